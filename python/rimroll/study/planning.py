"""From the description of a study to its plan, and from rows to their columns."""

from __future__ import annotations

import json
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from rimroll.errors import RimrollError
from rimroll.names import nearest
from rimroll.scenario.tables import as_toml, made
from rimroll.study.cases import Cases
from rimroll.study.description import Description
from rimroll.study.given import Block
from rimroll.study.plan import Columns, Coordinate, Plan, Progress, Variable
from rimroll.study.starts import STATE
from rimroll.study.versions import versions
from rimroll.units import START_UNIT_OF

if TYPE_CHECKING:
    from rimroll.study.study import Study

WITHOUT_EFFECT = ("store", "chunk", "most_rows", "title")
"""What of a study does not change its numbers."""

TRIED = 1000
"""The number of first rows that are tried when a study is planned."""


def planned(study: Study) -> Plan:
    """The plan of a study; raises ``RimrollError`` for what it may not say."""
    description = study.description
    _try(description)
    columns = _kept(description)
    coords = _coordinates(description)
    statistics = None
    if description.statistics is not None:
        from rimroll.study.statistics import statistics_of

        statistics = statistics_of(description.statistics, description.dims, coords, columns)
    return Plan(
        study,
        description.dims,
        coords,
        columns,
        min(description.chunk, description.rows),
        _attributes(study),
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
    cases = Cases.of(description, block, description.kind.options)
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


def _make(description: Description, block: Block) -> None:
    """Make the bodies, starts, laws and grounds of some rows."""
    for _ in Cases.of(description, block, description.kind.options).calls():
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
        for name in STATE:
            found[f"start_{name}"] = Variable("float64", dims, START_UNIT_OF[name])
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


def _attributes(study: Study) -> dict[str, Any]:
    """Everything that determines the numbers."""
    description = study.description
    content = study.to_dict()["study"]
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
