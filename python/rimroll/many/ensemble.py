"""Many falls at once: the outcome of a release from each of many starts."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import asdict, replace
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from rimroll import _core
from rimroll.bodies.body import Body
from rimroll.errors import RimrollError, callback, expect, hold
from rimroll.files.recorded import FELL, OUTCOMES, parameters
from rimroll.laws import Law, contact_law
from rimroll.many.falls import Column, Falls, Interrupted
from rimroll.many.falls import rows as in_rows
from rimroll.many.rows import LOSSES, Rows, energy_lost, inputs, transposed, unless_stopped
from rimroll.options import Keywords, Options, takes_options
from rimroll.state import State
from rimroll.theory.exact import NUMBERS, OUTCOME_OF, turns_in_parts
from rimroll.units import Number, Values, number, optional, thread_count, values

if TYPE_CHECKING:
    from typing import Unpack

    import xarray as xr


Array = NDArray[np.float64]


OPTIONS = Options(duration=10.0, rtol=1e-8, max_steps=100_000)
"""The defaults of :func:`ensemble`."""

VARIABLES = {
    "turn": (
        "rad",
        "angle of turn",
        "change of yaw from the release, or the tilt maximum after it, to the end",
    ),
    "direction": (
        "rad",
        "direction",
        "direction of fall or of the largest tilt, counted anticlockwise from that of the first"
        " lean, 0 to 2 pi: a turn of -1 degree leads to 359 degrees",
    ),
    "min_tilt": ("rad", "smallest tilt", "how close the near-collision was"),
    "min_tilt_time": ("s", "time of the smallest tilt", None),
    "end_time": ("s", "time of the end", None),
    "end_tilt": ("rad", "tilt at the end", None),
    "end_axial_spin": (
        "rad/s",
        "axial spin at the end",
        "angular velocity about the symmetry axis at the end",
    ),
    **LOSSES,
    "impact_loss": ("J", "energy lost in landings", None),
    "slid": ("", "whether the rim slid", None),
    "flew": ("", "whether the rim left the table", None),
    "steps": ("", "steps of the solver", None),
}
"""The columns of falls: unit, a name that fits an axis, and a comment where it needs one."""


@takes_options(OPTIONS, "flat", "flat_gap")
def ensemble(
    body: Body,
    starts: State,
    law: Law,
    *,
    friction_scale: Values = 1.0,
    duration: Number | None = None,
    threads: int | None = None,
    progress: Callable[[int, int], object] | None = None,
    options: Options | None = None,
    **keywords: Unpack[Keywords],
) -> xr.Dataset:
    """Follow a body from each of many starts through its first turn, on all processors.

    Each fall ends when the body topples, or when its tilt has passed a minimum and then a maximum.
    The results are the same, to the last bit, for any number of threads and any order of the
    starts, and equal those of :func:`rimroll.simulate` within ``rtol``.

    Parameters
    ----------
    body, starts, law
        What rolls, how it is released, and how its rim meets the table. Arrays in their fields
        broadcast to n rows; data arrays of xarray, as from :func:`rimroll.axis`, broadcast by the
        names of their dimensions. Each row is what its body, start and law give by themselves, to
        the last bit.
    friction_scale
        A factor on the law's friction: a number, (n,) or a data array. To sweep the coefficient
        itself, give the law an array, ``Coulomb([0.1, 0.2])``.
    duration, gravity, rtol, topple_tilt, max_steps, options
        As for :func:`rimroll.simulate`.
    threads
        Number of threads; by default one for each processor.
    progress
        Called about ten times a second with the number of falls done and the number of all falls.

    Returns
    -------
    xarray.Dataset
        One row for each ``trial``, or one value for each place on the named dimensions. The columns
        are ``outcome`` (see :data:`rimroll.files.recorded.OUTCOMES`), the inputs ``start_...`` and
        ``friction_scale``, ``body_...`` and ``law_...`` where they differ from row to row, and the
        :data:`VARIABLES`.

        ``turn`` is the angle by which the contact point went round, with its sign, and
        ``direction`` where that led. A body that dips and falls over near where it leaned at first
        has a small turn. The turn begins at the release unless the tilt rises there; see
        :class:`rimroll.ExactTurn`. ``turn``, ``direction``, ``min_tilt`` and ``min_tilt_time`` are
        NaN for a fall without a tilt minimum, and for one that ``hovered`` or ``failed``, whose
        turn was not complete when the time or the steps ran out. The attributes hold everything
        else that the falls were computed from.

    Raises
    ------
    RimrollError
        A number outside its bounds; arrays that do not broadcast; arrays of more than one dimension
        without names for them. For an array the message names the element, as ``tilt[1]``.
    Interrupted
        On Ctrl-C; it carries the falls done so far, in rows.
    """
    falls = follow(
        body,
        starts,
        law,
        OPTIONS.changed(options, duration, keywords),
        friction_scale=friction_scale,
        threads=threads,
        progress=progress,
    )
    return falls.to_xarray()


def follow(
    body: Body,
    starts: State,
    law: Law,
    options: Options,
    *,
    friction_scale: Values = 1.0,
    threads: int | None = None,
    progress: Callable[[int, int], object] | None = None,
    words: bool = True,
) -> Falls:
    """What :func:`ensemble` computes, in plain columns, without importing xarray.

    Arguments, errors and columns are those of :func:`ensemble`. Without ``words``, outcomes are
    their places (int8) in the list of outcomes.
    """
    expect("body", body, Body)
    expect("starts", starts, State)
    contact_law(law)
    if options.flat not in (None, "stop") or options.flat_gap:
        raise RimrollError(
            "flat and flat_gap are for single motions and for tables that move: many falls end"
            " where the base comes down flat"
        )
    workers = thread_count(threads)
    callback("progress", progress)
    friction_scale = _friction_scale(friction_scale)
    numbers = law.varied
    rows = _flat(Rows.of(body, starts, {"friction_scale": friction_scale, **numbers}))
    varied = {name: rows.grid.flat(value) for name, value in numbers.items()}
    scales, count = rows.grid.flat(friction_scale), rows.grid.size

    def report(done: int) -> None:
        if progress is not None:
            progress(done, count)

    try:
        table, stopped = _core.ensemble(
            rows.bodies,
            rows.starts,
            law.fixed,
            varied,
            scales,
            *options.values,
            workers,
            report,
        )
    except RimrollError as refusal:
        raise rows.placed(refusal, law.name, options.gravity, options.topple_tilt) from None
    columns = _columns(rows, varied, scales, table, words)
    recorded = asdict(options) | {"flat": None, "flat_gap": None}
    attrs = parameters(law.name, recorded, law=law.numbers, body=asdict(body))
    falls = replace(in_rows(columns, attrs), body=body, law=law)
    if len(table) == count and rows.grid.dims is not None:
        falls = falls.laid_out(rows.grid)
    return unless_stopped(falls, stopped)


def _friction_scale(friction_scale: Values) -> Any:
    given = values("friction_scale", friction_scale)
    factors = np.asarray(given)
    hold("friction_scale", factors, np.isfinite(factors) & (factors >= 0.0), "finite and >= 0")
    return given


def _flat(rows: Rows) -> Rows:
    """The rows; ``RimrollError`` if they have several dimensions without names."""
    grid = rows.grid
    if grid.dims is None and len(grid.shape) > 1:
        raise RimrollError(
            f"bodies, starts, law and friction_scale must be flat arrays, got shape {grid.shape}:"
            " for a grid, name its dimensions, as with rimroll.axis"
        )
    return rows


def _columns(
    rows: Rows, varied: Mapping[str, Array], scales: Array, table: Array, words: bool
) -> dict[str, Column]:
    done = len(table)
    found = dict(zip(_core.FALL_COLUMNS, transposed(table), strict=True))
    gone_round = np.mod(found.pop("end_yaw") - rows.starts.yaw[:done], 2.0 * np.pi)
    found["direction"] = np.where(np.isnan(found["turn"]), np.nan, gone_round)
    found["energy_lost"] = energy_lost(found)
    for flag in ("slid", "flew"):
        found[flag] = found[flag] != 0.0
    found["steps"] = found["steps"].astype(np.int64)
    outcome = found["outcome"].astype(np.int8)
    return {
        "outcome": Column(np.array(_core.OUTCOMES)[outcome] if words else outcome),
        **described(found),
        **inputs(rows, varied, done),
        "friction_scale": Column(scales[:done], ""),
    }


def described(numbers: Mapping[str, NDArray[Any]]) -> dict[str, Column]:
    """The :data:`VARIABLES` among some columns of numbers, with unit and meaning."""
    return {
        name: Column(numbers[name], *meaning)
        for name, meaning in VARIABLES.items()
        if name in numbers
    }


def fell(falls: Falls | xr.Dataset) -> NDArray[np.bool_]:
    """Which of the falls have a direction."""
    outcome = np.asarray(falls["outcome"])
    return np.asarray(np.logical_or.reduce([outcome == name for name in FELL]))


def outcomes(falls: Falls | xr.Dataset) -> dict[str, int]:
    """How many falls had each of the outcomes that occur."""
    outcome = np.asarray(falls["outcome"])
    counts: dict[str, int] = {}
    for name in OUTCOMES:
        if sum(counts.values()) < outcome.size:  # comparing a million words is slow
            counts[name] = int(np.count_nonzero(outcome == name))
    return {name: count for name, count in counts.items() if count}


def exact_falls(
    body: Body,
    starts: State,
    law: Law,
    *,
    gravity: Number,
    topple_tilt: Number | None,
    threads: int | None,
    progress: Callable[[int, int], object] | None,
) -> Falls:
    """The first turn from each of the starts (n,), as rows of an ensemble.

    Raises ``Interrupted`` on Ctrl-C; it carries the falls done so far.
    """
    gravity = number("gravity", gravity, "m/s^2")
    topple_tilt = optional("topple_tilt", topple_tilt, "rad")
    (total,) = starts.shape
    rows = Rows.of(body, starts)
    codes, table = np.empty(total, np.uint8), np.empty((len(NUMBERS), total))
    done = 0

    def so_far() -> Falls:
        options = {"gravity": gravity, "topple_tilt": topple_tilt}
        columns = _exact_columns(codes[:done], table[:, :done])
        return in_rows(columns, parameters(law.name, options, law=law.numbers, body=asdict(body)))

    try:
        for outcomes, columns, _ in turns_in_parts(rows, law, gravity, topple_tilt, threads):
            last = done + len(outcomes)
            codes[done:last], table[:, done:last] = outcomes, columns
            done = last
            if progress is not None:
                progress(done, total)
    except KeyboardInterrupt:
        raise Interrupted(so_far()) from None
    return so_far()


def _exact_columns(codes: NDArray[np.uint8], table: Array) -> dict[str, Column]:
    numbers = dict(zip(NUMBERS, table, strict=True))
    with np.errstate(invalid="ignore"):  # a NaN stays one
        numbers["direction"] = np.mod(numbers["yaw_change"], 2.0 * np.pi)
    return {"outcome": Column(OUTCOME_OF[codes]), **described(numbers)}
