"""The contact laws of the rows of a study."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import Any

from rimroll.laws import Law, parameters_of
from rimroll.scenario import RESISTANCES
from rimroll.scenario.tables import made, read_law
from rimroll.study.bodies import BodyRows
from rimroll.study.given import Block, Codes, Given, distinct, key_in, with_value
from rimroll.study.targets import unit_of


@dataclass(frozen=True, eq=False)
class LawRows:
    """The law of each of n rows: some laws whose numbers may differ from row to row."""

    laws: list[Law]
    codes: Codes
    """The law of each row (n,), as a place in :attr:`laws`."""
    numbers: list[Given]
    """The numbers that differ from row to row."""

    def law(self, code: int, rows: Codes) -> Law:
        """One of the laws for some of its rows."""
        law = self.laws[code]
        for one in self.numbers:
            law = made("[law]", lambda law=law, one=one: _with(law, key_in(one), one.array[rows]))  # type: ignore[misc]
        return law


def laws_of(table: Any, block: Block, bodies: BodyRows, gravity: float) -> LawRows:
    """The laws that a table, or the name of one, and what varies of it give.

    The body of the first row and ``gravity`` give the air drag of a film: the description refuses
    a film where either varies. Raises ``RimrollError`` as scenario files do.
    """
    given = block.of("law")
    anew = [one for one in given if unit_of(one.of) is None]
    numbers = [one for one in given if one not in anew]
    rows, codes = distinct(block.count, [one.codes for one in anew])
    body = tuple(bodies.one(0).__dict__.values())
    laws = []
    for row in rows:
        whole = table
        for one in anew:
            key, value = key_in(one), one.at(int(row))
            whole = with_value(_as_table(whole), key, value) if key else value
        for one in numbers:
            whole = with_value(_as_table(whole), key_in(one), one.at(int(row)))
        text = json.dumps(whole, sort_keys=True)
        laws.append(_read_once(text, body, gravity))
    return LawRows(laws, codes, numbers)


def _as_table(law: Any) -> dict[str, Any]:
    return {"kind": law} if isinstance(law, str) else dict(law)


@lru_cache(maxsize=4096)
def _read_once(table: str, body: tuple[float, ...], gravity: float) -> Law:
    from rimroll.body import Body

    return read_law(json.loads(table), Body(*body), gravity)


def _with(law: Law, key: str, values: Any) -> Law:
    """A law in which a number is an array."""
    table, dot, name = key.rpartition(".")
    if not dot:
        assert name in parameters_of(type(law))
        changes: Mapping[str, Any] = {name: values}
        return replace(law, **changes)
    kind = RESISTANCES[table]
    changed = tuple(
        replace(one, **{name: values}) if type(one) is kind else one for one in law.resistances
    )
    return replace(law, resistances=changed)
