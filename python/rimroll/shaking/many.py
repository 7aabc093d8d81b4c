"""Many motions on a moving table: what becomes of each, without the motion itself."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import asdict, dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from rimroll import _core
from rimroll.bodies.body import Bodies, Body
from rimroll.errors import RimrollError, callback, expect, hold
from rimroll.files.recorded import parameters
from rimroll.ground.ground import MAX_FACTOR, Ground
from rimroll.laws import Law, OneLaw, contact_law
from rimroll.many.falls import Column, Falls
from rimroll.many.falls import rows as in_rows
from rimroll.many.grid import is_labelled
from rimroll.many.rows import LOSSES, Rows, Starts, energy_lost, inputs, unless_stopped
from rimroll.options import (
    ON_MOVING_TABLES,
    Keywords,
    Options,
    flat_in_core,
    landing_given,
    takes_options,
)
from rimroll.shaking.scales import rocking_frequency_of, tilt_of_balance
from rimroll.state import State
from rimroll.units import Values, thread_count, values

if TYPE_CHECKING:
    from typing import Unpack

    import xarray as xr

Array = NDArray[np.float64]

Grounds = Ground | Sequence[Ground] | Mapping[str, Ground]
"""One motion of the ground, a list of them, or several by name."""

FREE = 20.0
"""How long a motion goes on after that of the ground by default, in units of 1/p."""

UNLESS_IT_STANDS = "NaN unless the body stands at the end"
"""Where a body still rocks or slides, or has overturned, its residual place is not determined."""

VARIABLES = {
    "overturned": (
        "",
        "whether the body overturned",
        "whether it reached the topple tilt or, under a law without flight, lifted off beyond the"
        " balance tilt",
    ),
    "undecided": (
        "",
        "whether it is undecided if the body overturns",
        "the motion ended before that was determined: it failed, came down flat, lifted off below"
        " the balance tilt under a law without flight, or the ground still moved at the end, or the"
        " body could still reach its balance tilt",
    ),
    "stands": ("", "whether the body stands at the end", "and the ground no longer moves"),
    "overturning_time": ("s", "time of overturning", "NaN for a body that did not overturn"),
    "max_tilt": ("rad", "largest tilt", None),
    "max_tilt_ratio": ("", "largest tilt over balance tilt", "balance tilt: atan(R/H)"),
    "max_tilt_time": ("s", "time of the largest tilt", None),
    "uplift_time": ("s", "time of the first uplift", "NaN for a body that was never uplifted"),
    "end_time": ("s", "time of the end", None),
    "end_tilt": ("rad", "tilt at the end", None),
    "end_x": ("m", "displacement along x at the end", "of the centre of the footprint"),
    "end_y": ("m", "displacement along y at the end", "of the centre of the footprint"),
    "end_yaw": ("rad", "turn of the body at the end", "change of yaw + spin since the start"),
    "residual_x": ("m", "residual displacement along x", UNLESS_IT_STANDS),
    "residual_y": ("m", "residual displacement along y", UNLESS_IT_STANDS),
    "residual_displacement": ("m", "residual displacement", UNLESS_IT_STANDS),
    "residual_yaw": ("rad", "residual yaw", UNLESS_IT_STANDS),
    **LOSSES,
    "impact_loss": ("J", "energy lost in impacts", None),
    "ground_work": ("J", "work of the ground", "in the frame of the table"),
    "steps": ("", "steps of the solver", None),
}
"""The columns of shaken bodies: unit, a name that fits an axis, and a comment if it needs one."""


@dataclass(frozen=True)
class Shakings:
    """Rows in the form of the core."""

    bodies: Bodies
    starts: Starts
    contact_law: OneLaw
    varied: dict[str, Array]
    grounds: list[_core.CoreGround]
    ground: NDArray[np.int64]
    scale: Array
    duration: Array


SHAKING = Options(rtol=1e-8, flat=ON_MOVING_TABLES)
"""The defaults of functions that follow many motions on moving tables, besides the duration."""


@takes_options(SHAKING, "duration")
def shake_many(
    body: Body,
    starts: State,
    law: Law,
    grounds: Grounds,
    *,
    scale: Values = 1.0,
    duration: Values | None = None,
    threads: int | None = None,
    progress: Callable[[int, int], object] | None = None,
    options: Options | None = None,
    **keywords: Unpack[Keywords],
) -> xr.Dataset:
    """Follow bodies on moving tables to the end of each motion, on all processors.

    Only the end and the extremes of each motion are kept. The results are the same, to the last
    bit, for any number of threads and any order of the rows, and are those of
    :func:`rimroll.simulate` with the same options.

    Parameters
    ----------
    body, starts, law
        What rocks, how it starts (:meth:`rimroll.State.standing` for a body that stands flat), and
        how its rim meets the table. Arrays in their fields broadcast to n rows; data arrays of
        xarray, as from :func:`rimroll.axis`, broadcast by the names of their dimensions.
    grounds
        One motion of the ground for all rows, or a list with one for each row. If anything else has
        named dimensions, a list becomes the dimension ``ground``. A dictionary of grounds by name
        always does.
    scale
        A factor on the acceleration of the ground, 1e-6 to 1e6: a number, (n,) or a data array.
    duration
        Length of the motion, s: a number, (n,) or a data array. By default it is that of
        ``options`` or, without them, the duration of the ground and a further 20/p with the body's
        :func:`rimroll.rocking_frequency` p, in which nearly every body that overturns falls over.
    gravity, rtol, topple_tilt, max_steps, flat, flat_gap, options
        As for :func:`rimroll.simulate`.
    threads
        Number of threads; by default one for each processor.
    progress
        Called about ten times a second with the number of motions done and the number of all.

    Returns
    -------
    xarray.Dataset
        One row for each ``trial``, or one value for each place on the named dimensions. The columns
        are ``status`` (see :data:`rimroll.files.recorded.STATUSES`), the :data:`VARIABLES`, and the
        inputs ``ground`` (the index in the list), ``scale``, ``start_...``, and ``body_...`` and
        ``law_...`` where they differ from row to row. For a body that overturned, the end is the
        moment at which it did, before its side meets the table. The footprint is the circle on
        which the base would stand if the body turned upright about its contact point. ``end_x``,
        ``end_y`` and ``end_yaw`` say where it is at the end, ``residual_x`` and so on where it
        stands for good: they are NaN for a body that still rocks or slides.

    Raises
    ------
    RimrollError
        A number outside its bounds; arrays that do not broadcast; arrays of more than one dimension
        without names for them. For an array the message names the element, as ``tilt[1]``.
    Interrupted
        On Ctrl-C; it carries the motions done so far, in rows.
    """
    chosen = SHAKING.changed(options, None, keywords)
    if duration is None and options is not None:
        duration = options.duration
    shaken = follow_shaken(
        body,
        starts,
        law,
        grounds,
        scale=scale,
        duration=duration,
        options=chosen,
        threads=threads,
        progress=progress,
    )
    return shaken.to_xarray()


def follow_shaken(
    body: Body,
    starts: State,
    law: Law,
    grounds: Grounds,
    *,
    scale: Values,
    duration: Values | None,
    options: Options,
    threads: int | None,
    progress: Callable[[int, int], object] | None = None,
) -> Falls:
    """What :func:`shake_many` computes, in plain columns. The duration of the options is not used.

    Arguments, errors and columns are those of :func:`shake_many`.
    """
    expect("body", body, Body)
    expect("starts", starts, State)
    contact_law(law)
    workers = thread_count(threads)
    callback("progress", progress)
    flat = landing_given(options.flat, True)
    scales, durations = _positive("scale", scale), duration
    _expect_scales(scales)
    if durations is not None:
        durations = _positive("duration", durations, "s")
    numbers = law.varied
    others = {"scale": scales, "duration": durations, **numbers}
    each, index = _grounds(grounds, [body, starts], others)
    others = {name: value for name, value in others.items() if value is not None}
    rows = Rows.of(body, starts, {"grounds": index, **others})
    if rows.grid.dims is None and len(rows.grid.shape) > 1:
        raise RimrollError(
            "body, starts, law, grounds, scale and duration must be flat arrays, got shape"
            f" {rows.grid.shape}: for a grid, name its dimensions, as with rimroll.axis"
        )
    shakings = _shakings(rows, law, each, index, scales, durations, options.gravity)
    count = rows.grid.size

    def report(done: int) -> None:
        if progress is not None:
            progress(done, count)

    settings = (
        options.rtol,
        options.topple_tilt,
        options.max_steps,
        flat_in_core(flat, options.flat_gap),
    )
    try:
        table, stopped = _core.shake_many(shakings, options.gravity, *settings, workers, report)
    except RimrollError as refusal:
        raise _placed(refusal, rows, shakings, options) from None
    recorded = asdict(options) | {"flat": str(flat)}
    del recorded["duration"]
    attrs = parameters(law.name, recorded, law=law.numbers, body=asdict(body))
    shaken = in_rows(_columns(rows, shakings, table), attrs)
    if len(table) == count and rows.grid.dims is not None:
        kept = {name: one for name, one in shaken.columns.items() if name not in rows.grid.dims}
        shaken = Falls(kept, shaken.axes, shaken.attrs).laid_out(rows.grid)
    return unless_stopped(shaken, stopped)


def _positive(field: str, value: Values, unit: str = "1") -> Any:
    given = values(field, value, unit)
    array = np.asarray(given)
    hold(field, array, (array > 0.0) & np.isfinite(array), "> 0 and finite", unit)
    return given


def _expect_scales(scales: Any) -> None:
    array = np.asarray(scales)
    within = (array >= 1.0 / MAX_FACTOR) & (array <= MAX_FACTOR)
    hold("scale", array, within, "between 1e-6 and 1e6")


def _grounds(
    grounds: object, things: list[Any], others: Mapping[str, Any]
) -> tuple[list[Ground], Any]:
    """The grounds, and the index of that of each row as something that broadcasts."""
    if isinstance(grounds, Ground):
        return [grounds], 0.0
    if not isinstance(grounds, Sequence | Mapping) or isinstance(grounds, str):
        expect("grounds", grounds, Ground)
    assert isinstance(grounds, Sequence | Mapping)
    each = list(grounds.values() if isinstance(grounds, Mapping) else grounds)
    if not each:
        raise RimrollError("must be one or more, got none", "grounds")
    for place, ground in enumerate(each):
        expect(f"grounds[{place}]", ground, Ground)
    index = np.arange(len(each), dtype=np.float64)
    given = [*others.values(), *(value for thing in things for value in vars(thing).values())]
    if not isinstance(grounds, Mapping) and not any(map(is_labelled, given)):
        return each, index
    import xarray as xr

    names = list(grounds) if isinstance(grounds, Mapping) else np.arange(len(each))
    return each, xr.DataArray(index, dims="ground", coords={"ground": names})


def _shakings(
    rows: Rows,
    law: Law,
    grounds: list[Ground],
    index: Any,
    scales: Any,
    durations: Any,
    gravity: float,
) -> Shakings:
    of_row = rows.grid.flat(index).astype(np.int64)
    if durations is None:
        ends = np.array([ground.duration for ground in grounds])
        lengths = ends[of_row] + FREE / rocking_frequency_of(rows.bodies, gravity)
    else:
        lengths = rows.grid.flat(durations)
    return Shakings(
        rows.bodies,
        rows.starts,
        law.fixed,
        {name: rows.grid.flat(value) for name, value in law.varied.items()},
        [ground.core for ground in grounds],
        of_row,
        rows.grid.flat(scales),
        np.ascontiguousarray(lengths),
    )


def _placed(error: RimrollError, rows: Rows, shakings: Shakings, options: Options) -> RimrollError:
    """An error of the core, with the element of the array: ``tilt[3]``."""
    if error.field not in rows.given:
        return error
    row = _core.first_refused_shaking(shakings, options.gravity, options.topple_tilt)
    return error if row is None else rows.grid.placed(error, rows.given, row)


def _columns(rows: Rows, shakings: Shakings, table: Array) -> dict[str, Column]:
    done = len(table)
    found: dict[str, Any] = dict(zip(_core.SHAKEN_COLUMNS, table.T, strict=True))
    found["overturned"] = ~np.isnan(found["overturning_time"])
    balance = np.broadcast_to(tilt_of_balance(rows.bodies), rows.grid.size)[:done]
    found["max_tilt_ratio"] = found["max_tilt"] / balance
    found["undecided"], found["stands"] = found["undecided"] > 0.0, found["stands"] > 0.0
    for name in ("x", "y", "yaw"):
        found[f"residual_{name}"] = np.where(found["stands"], found[f"end_{name}"], np.nan)
    found["residual_displacement"] = np.hypot(found["residual_x"], found["residual_y"])
    found["energy_lost"] = energy_lost(found)
    found["steps"] = found["steps"].astype(np.int64)
    status = np.array(_core.STATUSES)[found["status"].astype(np.int64)]
    return {
        "status": Column(status),
        **{name: Column(found[name], *meaning) for name, meaning in VARIABLES.items()},
        "ground": Column(shakings.ground[:done], None, "index of the ground"),
        "scale": Column(shakings.scale[:done], "", "factor on the acceleration of the ground"),
        **inputs(rows, shakings.varied, done),
    }
