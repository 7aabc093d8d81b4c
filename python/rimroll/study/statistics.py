"""Statistics in place of rows: counts, means, extremes, histograms and fragility by group.

Chunks are reduced by themselves and merged in any order. Counts and sums are whole numbers, so the
result depends on no chunk and no order, to the last bit.
"""

from __future__ import annotations

import math
import warnings
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray
from pydantic import Field

from rimroll.errors import RimrollError
from rimroll.names import nearest
from rimroll.scenario.tables import Table, as_toml, checked, readable
from rimroll.study.blocks import Blocks
from rimroll.study.plan import TRIAL, Columns, Coordinate, Variable
from rimroll.study.reductions import Count, Extremes, Histogram, Moments, Reduction
from rimroll.units import quantity

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
