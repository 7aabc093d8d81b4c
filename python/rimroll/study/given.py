"""The values that vary, for a block of rows, and the rows that have the same."""

from __future__ import annotations

import copy
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

Codes = NDArray[np.int64]


@dataclass(frozen=True, eq=False)
class Given:
    """The value of one varying quantity in each of n rows."""

    of: str
    """The key of the tables, such as ``law.friction``."""
    values: Sequence[Any] | NDArray[np.float64]
    codes: Codes
    """The index of each row's value in ``values`` (n,)."""

    def at(self, row: int) -> Any:
        """The value of a row."""
        value = self.values[int(self.codes[row])]
        return float(value) if isinstance(value, np.floating) else value

    @property
    def array(self) -> NDArray[np.float64]:
        """The numbers of all rows (n,)."""
        return np.asarray(self.values, np.float64)[self.codes]


@dataclass(frozen=True, eq=False)
class Block:
    """Some rows of a study."""

    count: int
    given: tuple[Given, ...]
    first: int = 0
    """The number of the first row."""
    seed: int = 0
    release: NDArray[np.float64] | None = None
    """The random numbers (n, 5) of the hand that releases the body."""

    def of(self, section: str) -> list[Given]:
        """What varies of a section of the tables, whole sections first."""
        found = [one for one in self.given if one.of.partition(".")[0] == section]
        return sorted(found, key=lambda one: one.of.count("."))


def distinct(count: int, codes: Iterable[Codes]) -> tuple[Codes, Codes]:
    """A row for each combination of codes that occurs, and the index of each row's combination."""
    combined = np.zeros(count, np.int64)
    varying = [each for each in codes if (each != each[0]).any()]
    if not varying:  # as in most chunks of large studies
        return np.zeros(1, np.int64), combined
    for each in varying:
        size = int(each.max(initial=0)) + 1
        _, combined = np.unique(combined * size + each, return_inverse=True)
    _, rows, place = np.unique(combined, return_index=True, return_inverse=True)
    return rows.astype(np.int64), place.astype(np.int64)


def with_value(table: dict[str, Any], key: str, value: Any) -> dict[str, Any]:
    """A copy of a table in which a key, ``rolling_resistance.dry``, has a value."""
    made = copy.deepcopy(table)
    *path, last = key.split(".")
    inner = made
    for name in path:
        inner = inner.setdefault(name, {})
    inner[last] = value
    return made


def key_in(one: Given) -> str:
    """The key of a quantity inside its section: "" for the whole section."""
    return one.of.partition(".")[2]


def part(value: float | NDArray[np.float64], rows: Any) -> Any:
    """The numbers of some rows, out of (n,); or the one number of all rows."""
    return value[rows] if isinstance(value, np.ndarray) else value
