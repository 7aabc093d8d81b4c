"""``rimroll study plan``: what a study varies, how much that is, and how long it takes."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from rimroll.cli.options import JsonOption
from rimroll.cli.screen import prose, say, show_json, table
from rimroll.cli.study.options import (
    LargerOption,
    StoreOption,
    StudyArgument,
    place,
    planned,
    requested,
)
from rimroll.study.axes import Axis
from rimroll.study.plan import TRIAL, Plan
from rimroll.study.size import Probe, expect_room, free, in_bytes, in_time, probe, processors


def plan(
    study: StudyArgument,
    store: StoreOption = None,
    larger: LargerOption = False,
    json: JsonOption = False,
) -> int:
    """What a study varies, how much that is, and how long it takes.

    Every value is tried, and some rows are computed to measure the time. A study that may not fit
    on the disk is refused.

    Example:

    $ rimroll study plan turn_of_presets.toml
    """
    what = requested(study)
    whole = planned(what, study)
    folder = place(what, store)
    if not larger:
        expect_room(whole, folder)
    measured = probe(whole)
    if json:
        show_json(_answer(whole, folder, measured))
    else:
        _show(whole, folder, measured)
    return 0


def _answer(plan: Plan, store: Path, probe: Probe) -> dict[str, Any]:
    return {
        "title": plan.study.title,
        "kind": plan.attrs["kind"],
        "dims": dict(plan.dims),
        "rows": plan.rows,
        "chunk": plan.chunk,
        "chunks": plan.chunks,
        "variables": list(plan.variables),
        "bytes": plan.bytes,
        "store": str(store),
        "free": free(store),
        "seconds": probe.of(plan.rows),
        "attributes": dict(plan.attrs),
    }


def _show(plan: Plan, store: Path, probe: Probe) -> None:
    if plan.study.title:
        prose(plan.study.title)
        say()
    rows = table("axis", "of", "values", "from", "to", "unit")
    for axis in plan.study.description.axes:
        dim = "" if axis.along == axis.name else f" along {axis.along}"
        rows.add_row(axis.name + dim, axis.of, str(axis.size), *_ends(axis), axis.unit)
    for one in plan.study.description.randoms:
        unit = "" if one.unit == "1" else one.unit
        numbers = ", ".join(f"{name} {value:g}" for name, value in one.numbers.items())
        rows.add_row(one.name, one.of, "random", one.distribution, numbers, unit)
    if TRIAL in plan.dims:
        trials, sampling = plan.dims[TRIAL], plan.study.description.sampling.method
        rows.add_row(TRIAL, "", str(trials), sampling, f"seed {plan.attrs['seed']}", "")
    if rows.row_count:
        say(rows)
        say()
    _show_sizes(plan, store, probe)


def _show_sizes(plan: Plan, store: Path, probe: Probe) -> None:
    sizes = " x ".join(f"{size} {dim}" for dim, size in plan.dims.items())
    say(f"kind      {plan.attrs['kind']}")
    say(f"rows      {plan.rows:,} = {sizes}")
    say(f"chunks    {plan.chunks:,} of {plan.chunk:,} rows, {in_time(probe.of(plan.chunk))} each")
    kept = "statistics" if plan.statistics is not None else "columns"
    prose(f"{kept:9} {', '.join(plan.variables)}", hanging=10)
    room = f"{in_bytes(free(store))} are free"
    say(f"size      at most {in_bytes(plan.bytes)} in {store}; {room}")
    threads = processors()
    took = in_time(probe.of(plan.rows))
    say(f"time      {took} on the {threads} processors of this machine")


def _ends(axis: Axis) -> tuple[str, str]:
    ends = [axis.labels[0], axis.labels[-1]]
    first, last = (f"{end:.4g}" if isinstance(end, np.floating) else str(end) for end in ends)
    return first, last
