"""What can be kept of a column in place of its rows; all of it is merged exactly."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from rimroll.study.exact_sum import PIECES, added, deviation, mean, sums
from rimroll.study.plan import Coordinate, Variable

Counts = NDArray[np.int64]
Arrays = dict[str, NDArray[Any]]


@dataclass(frozen=True)
class Kept:
    """An array that is accumulated: a value for each group, or several."""

    dtype: str
    shape: tuple[int, ...] = ()
    start: float = 0
    """What nothing has been added to."""
    merged: Callable[[NDArray[Any], NDArray[Any]], NDArray[Any]] = np.add
    """Merges two arrays."""

    def empty(self, groups: int) -> NDArray[Any]:
        """What nothing has been added to."""
        return np.full((groups, *self.shape), self.start, self.dtype)


class Reduction(Protocol):
    """A statistic of a column for each group of rows."""

    @property
    def column(self) -> str:
        """The column that it is made from."""

    @property
    def kept(self) -> Mapping[str, Kept]:
        """The arrays that are accumulated, by name."""

    @property
    def coords(self) -> Mapping[str, Coordinate]:
        """The coordinates of the dimensions that it adds."""

    def variables(self, dims: tuple[str, ...], of: Variable) -> Mapping[str, Variable]:
        """Its results over the dimensions of the groups, for a column."""

    def reduced(self, values: NDArray[Any], place: Counts, groups: int) -> Arrays:
        """The arrays for some rows: their values (n,) and the group of each."""

    def finished(self, arrays: Mapping[str, NDArray[Any]]) -> Arrays:
        """The results, by name, from arrays to which all rows have been added."""


@dataclass(frozen=True)
class Count:
    """How many rows have each of some words, or for how many something is true."""

    column: str
    flags: tuple[str, ...]

    @property
    def name(self) -> str:
        """The name of the result."""
        return f"{self.column}_count"

    @property
    def kept(self) -> Mapping[str, Kept]:
        """The counts."""
        return {self.name: Kept("int64", (len(self.flags),) if self.flags else ())}

    @property
    def coords(self) -> Mapping[str, Coordinate]:
        """The words."""
        words = {self.column: Coordinate(np.array(self.flags), (self.column,))}
        return words if self.flags else {}

    def variables(self, dims: tuple[str, ...], of: Variable) -> Mapping[str, Variable]:
        """The counts."""
        more = (self.column,) if self.flags else ()
        return {self.name: Variable("int64", (*dims, *more), "", f"count of {self.column}")}

    def reduced(self, values: NDArray[Any], place: Counts, groups: int) -> Arrays:
        """The counts of some rows."""
        if not self.flags:
            return {self.name: np.bincount(place[values.astype(bool)], minlength=groups)}
        width = len(self.flags)
        combined = np.bincount(place * width + values, minlength=groups * width)
        return {self.name: combined.reshape(groups, width)}

    def finished(self, arrays: Mapping[str, NDArray[Any]]) -> Arrays:
        """The counts."""
        return {self.name: arrays[self.name]}


@dataclass(frozen=True)
class Moments:
    """The number of finite values, their mean and standard deviation."""

    column: str
    coords: Mapping[str, Coordinate]

    @property
    def kept(self) -> Mapping[str, Kept]:
        """The number, and exact sums of the values and of their squares."""
        pieces = Kept("int64", (PIECES,), merged=added)
        return {
            f"{self.column}_number": Kept("int64"),
            f"{self.column}_sum": pieces,
            f"{self.column}_squares": pieces,
        }

    def variables(self, dims: tuple[str, ...], of: Variable) -> Mapping[str, Variable]:
        """The number, the mean and the standard deviation."""
        name = of.long_name or self.column
        return {
            f"{self.column}_number": Variable("int64", dims, "", f"number of values: {name}"),
            f"{self.column}_mean": Variable("float64", dims, of.unit, f"mean: {name}"),
            f"{self.column}_sd": Variable("float64", dims, of.unit, f"standard deviation: {name}"),
        }

    def reduced(self, values: NDArray[Any], place: Counts, groups: int) -> Arrays:
        """The number and the sums of some rows."""
        numbers = values.astype(np.float64)
        return {
            f"{self.column}_number": np.bincount(place[np.isfinite(numbers)], minlength=groups),
            f"{self.column}_sum": sums(numbers, place, groups),
            f"{self.column}_squares": sums(numbers * numbers, place, groups),
        }

    def finished(self, arrays: Mapping[str, NDArray[Any]]) -> Arrays:
        """The number, the mean and the standard deviation; NaN where there are too few values."""
        number = arrays[f"{self.column}_number"]
        counts = number.tolist()
        sum_, squares = arrays[f"{self.column}_sum"], arrays[f"{self.column}_squares"]
        every = zip(sum_, squares, counts, strict=True)
        return {
            f"{self.column}_number": number,
            f"{self.column}_mean": np.array(
                [mean(one, n) for one, n in zip(sum_, counts, strict=True)]
            ),
            f"{self.column}_sd": np.array([deviation(*one) for one in every]),
        }


@dataclass(frozen=True)
class Extremes:
    """The smallest and the largest finite value; NaN where there is none."""

    column: str
    coords: Mapping[str, Coordinate]

    @property
    def kept(self) -> Mapping[str, Kept]:
        """Both extremes."""
        return {
            f"{self.column}_min": Kept("float64", (), np.inf, np.minimum),
            f"{self.column}_max": Kept("float64", (), -np.inf, np.maximum),
        }

    def variables(self, dims: tuple[str, ...], of: Variable) -> Mapping[str, Variable]:
        """Both extremes."""
        name = of.long_name or self.column
        return {
            f"{self.column}_min": Variable("float64", dims, of.unit, f"least: {name}"),
            f"{self.column}_max": Variable("float64", dims, of.unit, f"largest: {name}"),
        }

    def reduced(self, values: NDArray[Any], place: Counts, groups: int) -> Arrays:
        """The extremes of some rows."""
        finite = np.isfinite(values)
        found = {name: one.empty(groups) for name, one in self.kept.items()}
        low, high = found.values()
        np.minimum.at(low, place[finite], values[finite])
        np.maximum.at(high, place[finite], values[finite])
        return found

    def finished(self, arrays: Mapping[str, NDArray[Any]]) -> Arrays:
        """The extremes."""
        return {
            name: np.where(np.isfinite(arrays[name]), arrays[name], np.nan) for name in self.kept
        }


@dataclass(frozen=True)
class Histogram:
    """Numbers of values in bins of equal width, and of values below and above them."""

    column: str
    low: float
    high: float
    bins: int
    unit: str

    @property
    def edges(self) -> NDArray[np.float64]:
        """The edges of the bins (bins + 1,); a value on one belongs to the bin above."""
        return np.linspace(self.low, self.high, self.bins + 1)

    @property
    def kept(self) -> Mapping[str, Kept]:
        """The counts, with those below and above."""
        return {f"{self.column}_histogram": Kept("int64", (self.bins + 2,))}

    @property
    def coords(self) -> Mapping[str, Coordinate]:
        """The centres of the bins."""
        edges = self.edges
        centres = 0.5 * (edges[1:] + edges[:-1])
        return {f"{self.column}_bin": Coordinate(centres, (f"{self.column}_bin",), self.unit)}

    def variables(self, dims: tuple[str, ...], of: Variable) -> Mapping[str, Variable]:
        """The counts."""
        name = of.long_name or self.column
        ends = f"{self.low:g} to {self.high:g} {of.unit}".rstrip()
        return {
            f"{self.column}_histogram": Variable(
                "int64", (*dims, f"{self.column}_bin"), "", f"histogram: {name}", ends
            ),
            f"{self.column}_below": Variable("int64", dims, "", f"below the histogram: {name}"),
            f"{self.column}_above": Variable("int64", dims, "", f"above the histogram: {name}"),
        }

    def reduced(self, values: NDArray[Any], place: Counts, groups: int) -> Arrays:
        """The counts of some rows; what is not a number is not counted."""
        there = ~np.isnan(values)
        bins = np.searchsorted(self.edges, values[there], side="right")
        bins[values[there] == self.high] = self.bins  # the last bin has both its ends
        width = self.bins + 2
        counts = np.bincount(place[there] * width + bins, minlength=groups * width)
        return {f"{self.column}_histogram": counts.reshape(groups, width)}

    def finished(self, arrays: Mapping[str, NDArray[Any]]) -> Arrays:
        """The counts."""
        counts = arrays[f"{self.column}_histogram"]
        return {
            f"{self.column}_histogram": counts[:, 1:-1],
            f"{self.column}_below": counts[:, 0],
            f"{self.column}_above": counts[:, -1],
        }
