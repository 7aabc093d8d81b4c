"""The bodies of the rows of a study."""

from __future__ import annotations

import inspect
import json
from collections.abc import Mapping
from dataclasses import dataclass, fields
from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from rimroll.body import Body
from rimroll.errors import RimrollError
from rimroll.names import choose, nearest
from rimroll.scenario import presets
from rimroll.scenario.tables import as_toml, made, read_body, readable
from rimroll.study.given import Block, Codes, Given, distinct, key_in, part, with_value
from rimroll.study.targets import unit_of
from rimroll.units import quantity

NUMBERS = tuple(field.name for field in fields(Body))

FACTORS = "factors"
"""The table of factors on the numbers of a body."""


@dataclass(frozen=True, eq=False)
class BodyRows:
    """The body of each of n rows."""

    numbers: Mapping[str, float | NDArray[np.float64]]
    """The five numbers: one for all rows, or (n,)."""
    codes: Codes
    """Equal for rows that have the same body (n,)."""

    def body(self, rows: Codes | slice = slice(None)) -> Body:
        """The bodies of some rows."""
        return Body(**{name: part(value, rows) for name, value in self.numbers.items()})

    def one(self, row: int) -> Body:
        """The body of a row."""
        return Body(**{name: float(part(value, row)) for name, value in self.numbers.items()})


def bodies_of(table: Mapping[str, Any], block: Block) -> BodyRows:
    """The bodies that a table and what varies of it give.

    A value of one of the five numbers replaces that of the body, unless its preset makes the body
    from it; then the body is made anew. Factors come last.

    Raises ``RimrollError`` as scenario files do.
    """
    given = block.of("body")
    anew = [one for one in given if _is_made_from(table, key_in(one))]
    rows, codes = distinct(block.count, [one.codes for one in anew])
    later = [one for one in given if one not in anew]
    found = [_made(table, anew, later, int(row)) for row in rows]
    numbers: dict[str, Any] = {
        name: getattr(found[0], name)
        if len(found) == 1
        else np.array([getattr(one, name) for one in found])[codes]
        for name in NUMBERS
    }
    for name, factor in _factors(table).items():
        numbers[name] = numbers[name] * factor
    for one in later:
        key = key_in(one)
        _, _, name = key.rpartition(".")
        numbers[name] = numbers[name] * one.array if key.startswith(FACTORS) else one.array
    _, codes = distinct(block.count, [codes, *(one.codes for one in later)])
    return BodyRows(numbers, codes)


def _is_made_from(table: Mapping[str, Any], key: str) -> bool:
    """Whether a body is made anew for each value of a key."""
    if key.startswith(FACTORS):
        return False
    if key not in NUMBERS:
        return True
    preset = table.get("preset")
    if not isinstance(preset, str):
        return False
    make = made("[body]", lambda: choose("preset", preset, presets()))
    return key in inspect.signature(make).parameters


def _made(table: Mapping[str, Any], anew: list[Given], later: list[Given], row: int) -> Body:
    """The body of a row, without its factors and before numbers are replaced."""
    whole = {key: value for key, value in table.items() if key != FACTORS}
    for one in anew:
        key, value = key_in(one), _with_unit(one, row)
        if key:
            whole = with_value(whole, key, value)
        else:
            whole = {"preset": value} if isinstance(value, str) else dict(value)
    if not whole.keys() & {"preset", "solids"}:
        for one in later:
            if not key_in(one).startswith(FACTORS):
                whole.setdefault(key_in(one), _with_unit(one, row))
    return read_once(json.dumps(whole, sort_keys=True))


def _with_unit(one: Given, row: int) -> Any:
    """A value as it may stand in a file, where large numbers need a unit."""
    value, unit = one.at(row), unit_of(one.of)
    return value if unit in (None, "1") else f"{value!r} {unit}"


@lru_cache(maxsize=4096)
def read_once(table: str) -> Body:
    """The body of a table in JSON."""
    return read_body(json.loads(table))


def _factors(table: Mapping[str, Any]) -> dict[str, float]:
    given = table.get(FACTORS, {})
    if not isinstance(given, Mapping):
        raise RimrollError(f"[body] factors must be a table, got {as_toml(given)}")
    for name in given:
        if name not in NUMBERS:
            raise RimrollError(
                f"[body.factors] has an unknown key {name!r}{nearest(name, NUMBERS)}"
            )
    return {
        name: made("[body.factors]", lambda n=name, v=value: quantity(readable(v), "1", n))  # type: ignore[misc]
        for name, value in given.items()
    }
