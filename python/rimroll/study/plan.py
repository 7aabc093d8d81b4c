"""What a study amounts to: its rows, how they are computed, its size and its time."""

from __future__ import annotations

import json
import math
import os
import shutil
import sys
import time
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from rimroll.errors import RimrollError, nearest
from rimroll.scenario.tables import as_toml, made
from rimroll.state import START_NUMBERS
from rimroll.study.columns import Blocks, Columns, Coordinate, Progress, Variable
from rimroll.study.description import Description, described
from rimroll.study.kinds import Cases
from rimroll.study.setups import STATE, Block
from rimroll.study.versions import versions

if TYPE_CHECKING:
    import xarray as xr

    from rimroll.study.statistics import Statistics


@dataclass(frozen=True, eq=False)
class Plan:
    """The rows of a study, and how the columns of any of them are computed.

    Rows are numbered along the dimensions in C order: the last dimension varies fastest.
    """

    description: Description
    content: Mapping[str, Any]
    """What :meth:`rimroll.Study.to_dict` gives."""
    dims: Mapping[str, int]
    """The sizes of the dimensions of the rows, in order."""
    coords: Mapping[str, Coordinate]
    columns: Mapping[str, Variable]
    """The columns of the rows: float64, int64, int8 or bool, each over all :attr:`dims`."""
    chunk: int
    """Rows in a chunk, at most."""
    attrs: Mapping[str, Any]
    """Everything that determines the numbers, as JSON knows it."""
    statistics: Statistics | None = None
    """What is kept of the rows, if not their columns."""

    @property
    def rows(self) -> int:
        """The number of motions."""
        return math.prod(self.dims.values())

    @cached_property
    def blocks(self) -> Blocks:
        """How the rows are divided into chunks, each of which is a block of the dimensions."""
        return Blocks.of(tuple(self.dims.values()), self.chunk)

    @property
    def chunks(self) -> int:
        """The number of chunks."""
        return self.blocks.number

    def bounds(self, number: int) -> tuple[int, int]:
        """The first row of a chunk, and the row after its last."""
        return self.blocks.rows(number)

    def __iter__(self) -> Iterator[tuple[int, int]]:
        return map(self.bounds, range(self.chunks))

    @property
    def variables(self) -> Mapping[str, Variable]:
        """What the finished study holds: the columns, or their statistics."""
        return self.columns if self.statistics is None else self.statistics.variables

    @property
    def bytes(self) -> int:
        """The size without compression of all variables, and of the parts of statistics."""
        sizes = self.sizes
        variables = sum(
            np.dtype(one.dtype).itemsize * math.prod(sizes[dim] for dim in one.dims)
            for one in self.variables.values()
        )
        parts = 0 if self.statistics is None else self.statistics.bytes_of_parts(self.blocks)
        return variables + parts

    @cached_property
    def sizes(self) -> Mapping[str, int]:
        """The sizes of all dimensions of the variables."""
        return self.dims if self.statistics is None else self.statistics.sizes

    def compute(
        self, first: int, last: int, *, threads: int | None = None, progress: Progress | None = None
    ) -> Columns:
        """The columns of the rows from ``first`` to before ``last``, each (last − first,).

        They depend on nothing but the study and these two numbers, and each row on its own number
        only. Where the plan has ``statistics``, reduce them by ``plan.statistics.of(first, last,
        columns)``.

        Raises ``RimrollError`` for rows that there are not, and ``Interrupted`` on Ctrl-C.
        """
        if not 0 <= first < last <= self.rows:
            text = f"must be between 0 and {self.rows}, got {first} to before {last}"
            raise RimrollError(text, "rows", (first, last))
        return computed(self.description, first, last, threads, progress)


def dataset_of(plan: Plan, values: Mapping[str, NDArray[Any]]) -> xr.Dataset:
    """Columns of all rows, each (rows,), or finished statistics, as a labelled dataset."""
    import xarray as xr

    sizes = plan.sizes
    coords = plan.coords if plan.statistics is None else plan.statistics.coords
    return xr.Dataset(
        {
            name: (
                one.dims,
                np.reshape(values[name], [sizes[dim] for dim in one.dims]),
                one.attrs,
            )
            for name, one in plan.variables.items()
        },
        coords={name: (one.dims, one.values, one.attrs) for name, one in coords.items()},
        attrs=dict(plan.attrs),
    )


WITHOUT_EFFECT = ("store", "chunk", "most_rows", "title")
"""What of a study does not change its numbers."""

TRIED = 1000
"""The number of first rows that are tried when a study is planned."""


def plan_of(content: Mapping[str, Any]) -> Plan:
    """The plan of a study that ``Study.to_dict`` describes; see :func:`planned`."""
    return planned(described(content["study"], Path(content["folder"])), content)


def planned(description: Description, content: Mapping[str, Any]) -> Plan:
    """The plan of a study, with the records of this moment.

    Raises ``RimrollError`` for what the study may not say.
    """
    description = description.with_records()
    _try(description)
    columns = _kept(description)
    coords = _coordinates(description)
    statistics = None
    if description.statistics is not None:
        from rimroll.study.statistics import statistics_of

        statistics = statistics_of(description.statistics, description.dims, coords, columns)
    return Plan(
        description,
        content,
        description.dims,
        coords,
        columns,
        min(description.chunk, description.rows),
        _attributes(description, content["study"]),
        statistics,
    )


def computed(
    description: Description,
    first: int,
    last: int,
    threads: int | None,
    progress: Progress | None,
) -> Columns:
    """The columns that are kept of the rows from ``first`` to before ``last``."""
    try:
        return _computed(description, first, last, threads, progress)
    except RimrollError as error:
        raise _in_row(description, first, last, error) from None


def _computed(
    description: Description,
    first: int,
    last: int,
    threads: int | None,
    progress: Progress | None,
) -> Columns:
    block = description.block(first, last)
    cases = _cases(description, block)
    columns = _kept(description)
    found = {
        name: np.empty(block.count, one.dtype)
        for name, one in columns.items()
        if name in description.kind.results
    }
    done = 0

    def report(of_call: int, _: int) -> None:
        if progress is not None:
            progress(done + of_call, block.count)

    for call in cases.calls():
        results = description.kind.computed(call, threads, report)
        for name in found:
            if len(call.rows) == block.count:
                found[name] = results[name].astype(found[name].dtype, copy=False)
            else:
                found[name][call.rows] = results[name]
        done += len(call.rows)
    found |= _inputs(description, cases, columns)
    return {name: found[name] for name in columns}


def _inputs(description: Description, cases: Cases, columns: Mapping[str, Variable]) -> Columns:
    """What was drawn for the rows."""
    count = cases.block.count
    drawn = {one.of: one for one in cases.block.given}
    found: Columns = {
        one.name: drawn[one.of].array for one in description.randoms if one.name in columns
    }
    if _has_starts(description):
        for name in STATE:
            if f"start_{name}" in columns:
                found[f"start_{name}"] = np.broadcast_to(cases.starts.numbers[name], count).copy()
        if "friction_scale" in columns:
            assert cases.starts.friction_scale is not None
            found["friction_scale"] = cases.starts.friction_scale
    return found


def _try(description: Description) -> None:
    """Make what is computed for every value of each axis, for likely ends, and for first rows."""
    _make(description, description.first)
    for axis in description.axes:
        block = description.along(axis)
        made(f"[axes.{axis.name}]", lambda block=block: _make(description, block))  # type: ignore[misc]
    for random in description.randoms:
        chances = np.array([0.5, description.draws - 0.5]) / description.draws
        ends = ", ".join(f"{one:.4g}" for one in random.values(chances))
        where = f"[random.{random.name}] reaches about {ends} in {description.draws} draws:"
        block = description.drawn(random, chances)
        made(where, lambda block=block: _make(description, block))  # type: ignore[misc]
    last = min(description.rows, TRIED)
    try:
        _make(description, description.block(0, last))
    except RimrollError as error:
        raise _in_row(description, 0, last, error) from None


def _cases(description: Description, block: Block) -> Cases:
    return Cases.of(
        description.tables,
        block,
        description.kind.options,
        description.folder,
        description.records,
    )


def _make(description: Description, block: Block) -> None:
    """Make the bodies, starts, laws and grounds of some rows."""
    for _ in _cases(description, block).calls():
        pass


def _in_row(description: Description, first: int, last: int, error: RimrollError) -> RimrollError:
    """The error of some rows as that of the first row whose values are refused, if there is one."""
    refusal = _refusal(description, first, last)
    while refusal is not None and last - first > 1:
        middle = (first + last) // 2
        earlier = _refusal(description, first, middle)
        if earlier is not None:
            last = middle
        else:
            first = middle
        refusal = earlier or _refusal(description, first, last)
    if refusal is None:
        return error
    return refusal.at(()).inside(f"row {first}:")


def _refusal(description: Description, first: int, last: int) -> RimrollError | None:
    try:
        _make(description, description.block(first, last))
    except RimrollError as error:
        return error
    return None


def _has_starts(description: Description) -> bool:
    """Whether a hand gives each row a start, which is kept."""
    return description.tables["release"] is not None and description.kind.one_start


def _columns(description: Description) -> dict[str, Variable]:
    dims = tuple(description.dims)
    found = {
        name: Variable(one.dtype, dims, one.unit, one.long_name, one.comment, one.flags)
        for name, one in description.kind.results.items()
    }
    for random in description.randoms:
        unit = "" if random.unit == "1" else random.unit
        found[random.name] = Variable("float64", dims, unit, comment=f"drawn for {random.of}")
    if _has_starts(description):
        for name, number in START_NUMBERS.items():
            found[f"start_{name}"] = Variable("float64", dims, number.unit)
        found["friction_scale"] = Variable(
            "float64", dims, "", None, "a factor on the law's friction"
        )
    return found


def _kept(description: Description) -> dict[str, Variable]:
    """The columns that are kept; ``RimrollError`` for unknown ones."""
    known = _columns(description)
    keep = description.keep
    if keep == "all":
        return known
    if not isinstance(keep, list) or not keep or not all(isinstance(one, str) for one in keep):
        raise RimrollError(f'must be "all" or a list of columns, got {as_toml(keep)}', "keep")
    for name in keep:
        if name not in known:
            raise RimrollError(f"keep: unknown column {name!r}{nearest(name, known)}")
    return {name: one for name, one in known.items() if name in keep}


def _coordinates(description: Description) -> dict[str, Coordinate]:
    # A dimension that is only numbered, such as the trials, has none: it may be long.
    return {
        axis.name: Coordinate(axis.labels, (axis.along,), axis.unit, axis.long_name)
        for axis in description.axes
    }


def _attributes(description: Description, content: Mapping[str, Any]) -> dict[str, Any]:
    """Everything that determines the numbers."""
    return {
        "title": description.title or "",
        "kind": description.kind.name,
        **versions(),
        "seed": description.sampling.seed,
        "study": json.dumps(
            {name: one for name, one in content.items() if name not in WITHOUT_EFFECT},
            sort_keys=True,
        ),
        # The rows are numbered along the dimensions, and an even design has a dimension for each
        # random quantity: the order of both decides.
        "dimensions": ", ".join(description.dims),
        "random_quantities": ", ".join(one.name for one in description.randoms),
        "records": json.dumps(description.records),
    }


PLACES = 8
"""At how many places of a study rows are tried."""

LONG_ENOUGH = 0.4
"""A try that takes this long is representative, s."""

MAX_TRIED = 1 << 17
"""The largest number of rows that are tried at once."""


@dataclass(frozen=True)
class Probe:
    """What some rows, spread over a study, took."""

    rows: int
    seconds: float

    def of(self, rows: int) -> float:
        """How long this many rows take at the same rate, s."""
        return rows * self.seconds / self.rows


def probe(plan: Plan, threads: int | None = None) -> Probe:
    """Compute rows at some places of a study, more and more, until that takes 0.4 s."""
    count = 1
    while True:
        starts = sorted({k * plan.rows // PLACES for k in range(PLACES)})
        begin = time.perf_counter()
        tried = 0
        for first in starts:
            last = min(first + count, plan.rows)
            plan.compute(first, last, threads=threads)
            tried += last - first
        seconds = time.perf_counter() - begin
        if seconds > LONG_ENOUGH or tried >= min(plan.rows, MAX_TRIED):
            return Probe(tried, seconds)
        count *= 4


def free(place: Path) -> int:
    """The free bytes of the disk that has, or will have, a place."""
    folder = place.resolve()
    while not folder.exists():
        folder = folder.parent
    return shutil.disk_usage(folder).free


def expect_room(plan: Plan, store: Path) -> None:
    """Raise ``RimrollError`` if the variables, without compression, do not fit on the disk."""
    room = free(store)
    if plan.bytes > room:
        raise RimrollError(
            f"the study takes up to {in_bytes(plan.bytes)}, and the disk of {store} has"
            f" {in_bytes(room)}: keep fewer columns, or statistics, or say --larger-than-disk"
        )


def in_bytes(size: float) -> str:
    """A size as people read it: ``1.2 GB``."""
    for unit in ("B", "kB", "MB", "GB", "TB"):
        if size < 1000.0:
            return f"{size:.0f} B" if unit == "B" else f"{size:.3g} {unit}"
        size /= 1000.0
    return f"{size:.3g} PB"


def in_time(seconds: float) -> str:
    """A duration as people read it: ``2.5 h``."""
    for unit, length in (("days", 86400.0), ("h", 3600.0), ("min", 60.0)):
        if seconds >= length:
            return f"{seconds / length:.3g} {unit}"
    return f"{seconds:.2g} s"


def processors() -> int:
    """The processors that this process may use, which may be fewer than the machine has."""
    if sys.platform == "linux":
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1
