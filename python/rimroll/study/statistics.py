"""Statistics in place of rows: counts, means, extremes, histograms and fragility by group.

A number is cut into six whole numbers of 32 bits, which count multiples of 2³², 1, 2⁻³², ... 2⁻¹²⁸.
Sums of these are whole numbers; what of one exceeds 32 bits is carried to the piece before it. One
more piece, of multiples of 2⁶⁴, takes what the others cannot hold, so that 2⁶³ numbers have a sum.
What of a number is below 2⁻¹²⁸ is dropped.

Chunks are reduced by themselves and merged in any order. Counts and sums are whole numbers, so the
result depends on no chunk and no order, to the last bit.
"""

from __future__ import annotations

import math
import warnings
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray
from pydantic import Field

from rimroll.errors import RimrollError, nearest
from rimroll.scenario.tables import Table, as_toml, checked, readable
from rimroll.study.columns import TRIAL, Blocks, Columns, Coordinate, Variable
from rimroll.units import quantity

PIECES = 7
"""The first one is for what is carried: numbers themselves have none of it."""

BITS = 32
TOP = 64
"""Numbers must be below 2 to this power."""

UNIT = TOP - (PIECES - 1) * BITS
"""The last piece counts multiples of 2 to this power."""


def sums(values: NDArray[np.float64], place: NDArray[np.int64], count: int) -> NDArray[np.int64]:
    """The sum of the finite values (n,) of each of ``count`` places, in pieces (count, 7).

    Raises ``RimrollError`` for a finite value of 2⁶⁴ or more.
    """
    found = np.zeros((count, PIECES), np.int64)
    finite = np.isfinite(values)
    values, place = values[finite], place[finite]
    rest = np.abs(values) * 2.0**-TOP
    if (rest >= 1.0).any():
        raise RimrollError(f"sums are of numbers below 2^{TOP}, got {np.abs(values).max():g}")
    signs = np.sign(values).astype(np.int64)
    for k in range(1, PIECES):
        rest = rest * 2.0**BITS
        whole = np.floor(rest)
        rest -= whole
        np.add.at(found[:, k], place, signs * whole.astype(np.int64))
    return found


def added(one: NDArray[np.int64], other: NDArray[np.int64]) -> NDArray[np.int64]:
    """The sums of two arrays of sums (n, 7), of fewer than 2³⁰ numbers or themselves added.

    All pieces but the first are between 0 and 2³², so that there is always room for more.
    """
    found = one + other
    for k in range(PIECES - 1, 0, -1):
        found[:, k - 1] += found[:, k] >> BITS  # rounded down, also below zero
        found[:, k] &= (1 << BITS) - 1
    return found


def whole(pieces: NDArray[np.int64]) -> int:
    """A sum (7,) as a multiple of 2⁻¹²⁸."""
    total = 0
    for piece in pieces.tolist():
        total = (total << BITS) + piece
    return total


def quotient(total: int, divisor: int) -> float:
    """A sum, as a multiple of 2⁻¹²⁸, over a whole number: the nearest float."""
    return total / (divisor << -UNIT)


def mean(pieces: NDArray[np.int64], number: int) -> float:
    """The mean of ``number`` values; NaN for none."""
    return quotient(whole(pieces), number) if number else math.nan


def deviation(pieces: NDArray[np.int64], squares: NDArray[np.int64], number: int) -> float:
    """The standard deviation of a sample, with divisor n − 1; NaN for fewer than two values."""
    if number < 2:
        return math.nan
    total, square = whole(pieces), whole(squares)
    spread = (number * square << -UNIT) - total * total  # n Σx² − (Σx)², in 2⁻²⁵⁶
    return math.sqrt(max(spread, 0) / (number * (number - 1) << -2 * UNIT))


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


GROUP = "group"
"""The array of a part that says to which groups its other arrays belong."""

NUMBER = "number"
"""The variable with the number of rows of each group."""

HEADER = 500
"""Bytes of an array in a part beside its numbers, about."""

FRAGILITY = {"median": "intensity at which half overturn", "dispersion": "dispersion"}


class _Histogram(Table):
    range: list[Any]
    bins: int


class _Statistics(Table):
    over: list[str] | None = None
    count: list[str] = Field(default_factory=list)
    mean: list[str] = Field(default_factory=list)
    extremes: list[str] = Field(default_factory=list)
    histogram: dict[str, Any] = Field(default_factory=dict)
    fragility: str | None = None


@dataclass(frozen=True, eq=False)
class Statistics:
    """The reductions of the rows of a study to groups: the places of the dimensions that stay."""

    dims: Mapping[str, int]
    """The dimensions of the rows."""
    groups: Mapping[str, int]
    """The dimensions that stay."""
    reductions: tuple[Reduction, ...]
    variables: Mapping[str, Variable]
    coords: Mapping[str, Coordinate]
    """All coordinates of the variables."""
    fragility: str | None = None
    """The dimension of the intensity of fragility curves."""

    @property
    def sizes(self) -> Mapping[str, int]:
        """The sizes of all dimensions of the variables."""
        more = {dim: len(one.values) for one in self.coords.values() for dim in one.dims}
        return {**more, **self.groups}

    def of(self, first: int, last: int, columns: Mapping[str, NDArray[Any]]) -> Columns:
        """The part of the rows from ``first`` to before ``last``.

        A part is a dictionary of arrays: ``group`` (g,), the numbers of the groups of these rows,
        and others whose first dimension has a value for each of these.
        """
        groups, place = np.unique(self._group(np.arange(first, last)), return_inverse=True)
        count = len(groups)
        part: Columns = {GROUP: groups, NUMBER: np.bincount(place, minlength=count)}
        for one in self.reductions:
            part |= one.reduced(columns[one.column], place, count)
        return part

    def empty(self) -> Columns:
        """What parts are added to."""
        count = math.prod(self.groups.values())
        found: Columns = {NUMBER: np.zeros(count, np.int64)}
        for one in self.reductions:
            found |= {name: kept.empty(count) for name, kept in one.kept.items()}
        return found

    def bytes_of_parts(self, blocks: Blocks) -> int:
        """The size of the parts of all chunks."""
        along = zip(self.dims, blocks.counts, strict=True)
        # A group has a part in each chunk that differs in the dimensions that are reduced.
        each = math.prod(self.groups.values())
        each *= math.prod(count for dim, count in along if dim not in self.groups)
        arrays = [kept for one in self.reductions for kept in one.kept.values()]
        of_group = sum(kept.empty(1).nbytes for kept in arrays) + 16  # group and number
        return each * of_group + blocks.number * (len(arrays) + 2) * HEADER

    def add(self, total: Columns, part: Mapping[str, NDArray[Any]]) -> None:
        """Add a part to the total, which is changed. Each part must be added once; in any order."""
        groups = part[GROUP]
        total[NUMBER][groups] += part[NUMBER]
        for one in self.reductions:
            for name, kept in one.kept.items():
                total[name][groups] = kept.merged(total[name][groups], part[name])

    def finished(self, total: Mapping[str, NDArray[Any]]) -> Columns:
        """The variables, each over its dimensions, from a total to which parts have been added."""
        flat: Columns = {NUMBER: total[NUMBER]}
        for one in self.reductions:
            flat |= one.finished(total)
        sizes = self.sizes
        found = {
            name: np.asarray(flat[name], one.dtype).reshape([sizes[dim] for dim in one.dims])
            for name, one in self.variables.items()
            if name in flat
        }
        return found if self.fragility is None else found | self._fragilities(found)

    def merged(self, parts: Iterable[Mapping[str, NDArray[Any]]]) -> Columns:
        """The variables from all parts."""
        total = self.empty()
        for part in parts:
            self.add(total, part)
        return self.finished(total)

    def _group(self, rows: NDArray[np.int64]) -> NDArray[np.int64]:
        """The number of the group of each row."""
        group = np.zeros(len(rows), np.int64)
        stride = math.prod(self.dims.values())
        for dim, size in self.dims.items():
            stride //= size
            if dim in self.groups:
                group = group * size + rows // stride % size
        return group

    def _fragilities(self, found: Columns) -> Columns:
        """Fragility curves along the intensity; NaN where no lognormal curve fits."""
        from rimroll.shaking.lognormal import UndecidedWarning, fragility

        assert self.fragility is not None
        axis = list(self.groups).index(self.fragility)
        counts = [
            np.moveaxis(found[name], axis, -1).reshape(-1, self.groups[self.fragility])
            for name in ("overturned_count", NUMBER, "undecided_count")
        ]
        strengths = np.asarray(self.coords[self.fragility].values, np.float64)
        curves = np.full((2, len(counts[0])), np.nan)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", UndecidedWarning)  # their count is a variable
            for k, (overturned, number, undecided) in enumerate(zip(*counts, strict=True)):
                some = number > 0
                try:
                    curve = fragility(
                        overturned[some],
                        strengths[some],
                        trials=number[some],
                        undecided=undecided[some],
                    )
                except RimrollError:
                    continue
                curves[:, k] = curve.median, curve.dispersion
        shape = [size for dim, size in self.groups.items() if dim != self.fragility]
        return {
            f"fragility_{name}": one.reshape(shape)
            for name, one in zip(FRAGILITY, curves, strict=True)
        }


def statistics_of(
    table: Mapping[str, Any],
    dims: Mapping[str, int],
    coords: Mapping[str, Coordinate],
    columns: Mapping[str, Variable],
) -> Statistics:
    """The statistics of a table.

    Raises ``RimrollError`` for unknown columns and dimensions, and for columns of another type than
    a statistic needs.
    """
    read = checked(_Statistics, dict(table), "[statistics]")
    try:
        over = _over(read.over, dims)
        reductions = _reductions(read, columns)
        groups = {dim: size for dim, size in dims.items() if dim not in over}
        if read.fragility is not None:
            _expect_fragility(read.fragility, groups, coords, columns)
            names = {one.column for one in reductions if isinstance(one, Count)}
            for name in ("overturned", "undecided"):
                if name not in names:
                    reductions.append(Count(name, ()))
        if not reductions:
            raise RimrollError("is empty: give count, mean, extremes, histogram or fragility")
    except RimrollError as error:
        raise error.inside("[statistics]") from None
    left = tuple(groups)
    variables = {NUMBER: Variable("int64", left, "", "number of rows")}
    all_coords = {
        name: one for name, one in coords.items() if all(dim in groups for dim in one.dims)
    }
    taken = {*left, *all_coords}
    for one in reductions:
        variables |= one.variables(left, columns[one.column])
        all_coords |= one.coords
    for name in [*variables, *(name for one in reductions for name in one.coords)]:
        if name in taken:
            raise RimrollError(f"[statistics] {name!r} is also the name of an axis: take another")
    if read.fragility is not None:
        rest = tuple(dim for dim in left if dim != read.fragility)
        unit = coords[read.fragility].unit
        for name, long_name in FRAGILITY.items():
            of = unit if name == "median" else ""
            variables[f"fragility_{name}"] = Variable("float64", rest, of, long_name)
    return Statistics(dims, groups, tuple(reductions), variables, all_coords, read.fragility)


def _over(over: list[str] | None, dims: Mapping[str, int]) -> list[str]:
    """The dimensions that are reduced: by default the trials."""
    found = [TRIAL] if over is None and TRIAL in dims else over or []
    for dim in found:
        if dim not in dims:
            raise RimrollError(f"over: unknown dimension {dim!r}{nearest(dim, dims)}")
    return found


def _reductions(read: _Statistics, columns: Mapping[str, Variable]) -> list[Reduction]:
    found: list[Reduction] = []
    for name in read.count:
        one = _column("count", name, columns)
        if not one.flags and one.dtype != "bool":
            raise RimrollError(f"count: {name} is a number: take a mean or a histogram")
        found.append(Count(name, one.flags))
    for name in read.mean:
        found.append(Moments(_number("mean", name, columns), {}))
    for name in read.extremes:
        found.append(Extremes(_number("extremes", name, columns), {}))
    for name, table in read.histogram.items():
        found.append(_histogram(_number("histogram", name, columns), table, columns[name].unit))
    return found


def _histogram(name: str, table: object, unit: str) -> Histogram:
    if not isinstance(table, dict):
        raise RimrollError(f"histogram.{name} must be a table, got {as_toml(table)}")
    read = checked(_Histogram, table, f"histogram.{name}")
    if len(read.range) != 2:
        raise RimrollError(f"histogram.{name} range must be two numbers, got {as_toml(read.range)}")
    low, high = (quantity(readable(end), unit or "1", "range") for end in read.range)
    if not low < high:
        raise RimrollError(f"histogram.{name} range must rise, got {as_toml(read.range)}")
    if not 1 <= read.bins <= 100_000:
        raise RimrollError(f"histogram.{name} bins must be between 1 and 100000, got {read.bins}")
    return Histogram(name, low, high, read.bins, unit)


def _column(what: str, name: str, columns: Mapping[str, Variable]) -> Variable:
    if name not in columns:
        raise RimrollError(f"{what}: unknown column {name!r}{nearest(name, columns)}")
    return columns[name]


def _number(what: str, name: str, columns: Mapping[str, Variable]) -> str:
    one = _column(what, name, columns)
    if one.flags or one.dtype == "bool":
        raise RimrollError(f"{what}: {name} is no number: count it")
    return name


def _expect_fragility(
    axis: str,
    groups: Mapping[str, int],
    coords: Mapping[str, Coordinate],
    columns: Mapping[str, Variable],
) -> None:
    if axis not in groups:
        raise RimrollError(f"fragility: unknown dimension {axis!r}{nearest(axis, groups)}")
    values = coords[axis].values
    if values.dtype.kind != "f" or not (values > 0.0).all():
        raise RimrollError(f"fragility: the values of {axis} must be intensities > 0")
    for name in ("overturned", "undecided"):
        _column("fragility", name, columns)
