"""Many falls at once: what became of a body let go from each of many starts."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import asdict, fields
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from rimroll import _core, laws
from rimroll.body import Body
from rimroll.errors import RimrollError, callback, expect, hold
from rimroll.falls import Column, Falls, Interrupted
from rimroll.falls import rows as in_rows
from rimroll.given import Number, Values, number, values
from rimroll.laws import (
    AirDrag,
    Law,
    PivotingFriction,
    Resistance,
    RollingResistance,
    contact_law,
    fixed_numbers,
    listed,
    only_fixed,
    varied_numbers,
)
from rimroll.motion import thread_count
from rimroll.options import Options
from rimroll.rows import Rows
from rimroll.state import State
from rimroll.units import START_UNIT_OF, UNIT_OF

if TYPE_CHECKING:
    import xarray as xr

Array = NDArray[np.float64]


OPTIONS = Options(duration=10.0, rtol=1e-8, max_steps=100_000)
"""How falls are followed unless the caller says otherwise: the defaults of :func:`ensemble`."""

OUTCOMES = {
    "toppled": "came down, be it only a little, rose again and fell over, on whatever side; also if"
    " a law that knows no flight ends with the rim's leaving the table past the balance tilt",
    "rocked": "came down and rose again to a largest tilt",
    "fell_back": "fell over as it leaned: its tilt only grew, or was smallest at the release",
    "hovered": "did none of these before time was up",
    "lifted_off": "would have left the table, under a law that knows no flight",
    "face_down": "came down flat",
    "at_rest": "came to rest",
    "painleve": "met Painlevé's paradox",
    "failed": "could not be computed",
}
"""What can become of a body, and what the words mean."""

FELL = ("toppled", "rocked")
"""Outcomes of which the direction is one of fall, or of the largest tilt."""

VARIABLES = {
    "turn": ("rad", "change of yaw from the release, or the tilt maximum after it, to the outcome"),
    "direction": (
        "rad",
        "of fall or of the largest tilt, from that of the first lean: a bearing, 0 to 2 pi, so that"
        " a turn of -1 degree leads to 359 degrees",
    ),
    "min_tilt": ("rad", "the smallest tilt: how near the near-collision was"),
    "near_time": ("s", "time of the smallest tilt"),
    "time": ("s", "time of the outcome"),
    "end_tilt": ("rad", "tilt at the outcome"),
    "end_axial_spin": ("rad/s", "spin about the symmetry axis at the outcome"),
    "energy_lost": ("J", "to friction, resistance and impacts, until the outcome"),
    "friction_loss": ("J", "of it, to friction"),
    "resistance_loss": ("J", "of it, to rolling resistance, pivoting friction and air"),
    "impact_loss": ("J", "of it, in landings"),
    "slid": ("", "whether the rim slid on the way"),
    "flew": ("", "whether it left the table on the way"),
    "steps": ("", "steps of the solver"),
}
"""What is told of each fall: units and meaning."""


def ensemble(
    body: Body,
    starts: State,
    law: Law,
    *,
    grip: Values = 1.0,
    duration: Number = 10.0,
    gravity: Number = _core.STANDARD_GRAVITY,
    rtol: float = 1e-8,
    topple_tilt: Number | None = None,
    max_steps: int = 100_000,
    threads: int | None = None,
    progress: Callable[[int, int], object] | None = None,
) -> xr.Dataset:
    """Follow a body from each of many starts through its first turn, on all processors.

    Each fall is followed until it topples, or until it has come down and risen again to its largest
    tilt. The results are the same, to the last bit, for any number of threads and any order of the
    starts, and within ``rtol`` those of :func:`rimroll.simulate`.

    Parameters
    ----------
    body, starts, law
        What rolls, how it is let go, and how its rim meets the table. Arrays in their fields stand
        for many: they broadcast to n rows, or, where they are data arrays of xarray, by the names
        of their dimensions, as with :func:`rimroll.axis`. Each row is what its body, start and law
        give by themselves, to the last bit.
    grip
        A factor of the law's friction, a number, (n,) or a data array. A sweep of the coefficient
        itself is a law of arrays, ``Coulomb([0.1, 0.2])``.
    duration, gravity, rtol, topple_tilt, max_steps
        As for :func:`rimroll.simulate`.
    threads
        How many to use; as many as there are processors unless given.
    progress
        Called some ten times a second with the number of falls done, and of all.

    Returns
    -------
    xarray.Dataset
        One row a ``trial``, or the dimensions that were named with their coordinates: ``outcome``
        (see :data:`OUTCOMES`), the ``start_...`` and ``grip`` it was computed from, ``body_...``
        and ``law_...`` where they differ from row to row, and the :data:`VARIABLES`. ``turn`` is by
        how much the contact point went round, with its sign, and ``direction`` where that led: a
        body that dips and falls over near where it leaned has a small turn. The turn counts from
        the release unless the tilt rises there, as told in :class:`rimroll.ExactTurn`. ``turn``,
        ``direction``, ``min_tilt`` and ``near_time`` are NaN for a fall that did not come down, and
        for one that ``hovered`` or ``failed``, whose turn was not over when time or steps were up.
        The attributes hold everything else that it was computed from. ``outcome``, ``near_time``
        and ``end_tilt`` are what :func:`rimroll.exact_turn` calls ``status``, ``min_time`` and
        ``max_tilt``.

    Raises
    ------
    RimrollError
        A number outside its bounds, arrays that do not broadcast, or that are not flat and have no
        names for their dimensions; of an array the message names the element, ``tilt[1]``.
    Interrupted
        On Ctrl-C; it carries the falls done so far, in rows.
    """
    options = Options.read(duration, gravity, rtol, topple_tilt, max_steps)
    falls = follow(body, starts, law, options, grip=grip, threads=threads, progress=progress)
    return falls.to_xarray()


def follow(
    body: Body,
    starts: State,
    law: Law,
    options: Options,
    *,
    grip: Values = 1.0,
    threads: int | None = None,
    progress: Callable[[int, int], object] | None = None,
) -> Falls:
    """What :func:`ensemble` computes, in plain columns: it imports no xarray.

    Arguments, errors and columns are those of :func:`ensemble`.
    """
    expect("body", body, Body)
    expect("starts", starts, State)
    contact_law(law)
    workers = thread_count(threads)
    callback("progress", progress)
    grip = _grip(grip)
    numbers = varied_numbers(law.numbers)
    rows = _flat(Rows.of(body, starts, {"grip": grip, **numbers}))
    varied = {name: rows.grid.flat(value) for name, value in numbers.items()}
    grips, count = rows.grid.flat(grip), rows.grid.size

    def said(done: int) -> None:
        if progress is not None:
            progress(done, count)

    try:
        table, stopped = _core.ensemble(
            rows.bodies, rows.starts, only_fixed(law), varied, grips, *options.values, workers, said
        )
    except RimrollError as refusal:
        raise rows.placed(refusal, options.gravity, options.topple_tilt) from None
    columns = _columns(rows, varied, grips, table)
    falls = in_rows(columns, parameters(body, law, asdict(options)))
    if len(table) == count and rows.grid.dims is not None:
        falls = falls.laid_out(rows.grid)
    if isinstance(stopped, KeyboardInterrupt):
        raise Interrupted(falls) from None
    if stopped is not None:
        raise stopped
    return falls


def _grip(grip: Values) -> Any:
    given = values("grip", grip)
    factors = np.asarray(given)
    hold("grip", factors, np.isfinite(factors) & (factors >= 0.0), "finite and >= 0")
    return given


def _flat(rows: Rows) -> Rows:
    """The rows if they have one dimension, or names for more."""
    grid = rows.grid
    if grid.dims is None and len(grid.shape) > 1:
        raise RimrollError(
            f"bodies, starts, law and grip must be flat arrays, got shape {grid.shape}: for a grid,"
            " name its dimensions, as with rimroll.axis"
        )
    return rows


def _columns(
    rows: Rows, varied: Mapping[str, Array], grips: Array, table: Array
) -> dict[str, Column]:
    done = len(table)
    told = dict(zip(_core.FALL_COLUMNS, table.T, strict=True))
    told["time"] = told.pop("end_time")
    gone_round = np.mod(told.pop("end_yaw") - rows.starts.yaw[:done], 2.0 * np.pi)
    told["direction"] = np.where(np.isnan(told["turn"]), np.nan, gone_round)
    losses = ("friction_loss", "resistance_loss", "impact_loss")
    told["energy_lost"] = sum((told[loss] for loss in losses), np.zeros(done))
    for flag in ("slid", "flew"):
        told[flag] = told[flag] != 0.0
    told["steps"] = told["steps"].astype(np.int64)
    outcome = np.array(_core.OUTCOMES)[told["outcome"].astype(np.int64)]
    return {
        "outcome": Column(outcome),
        **described(told),
        **{
            f"start_{name}": Column(column[:done], START_UNIT_OF[name])
            for name, column in rows.starts._asdict().items()
        },
        **{
            f"body_{name}": Column(column[:done], UNIT_OF[name])
            for name, column in rows.bodies._asdict().items()
            if np.ndim(rows.given[name])
        },
        **{f"law_{name}": Column(column[:done]) for name, column in varied.items()},
        "grip": Column(grips[:done], ""),
    }


def described(numbers: Mapping[str, NDArray[Any]]) -> dict[str, Column]:
    """Those of the :data:`VARIABLES` that there are, with unit and meaning."""
    return {
        name: Column(numbers[name], unit, meaning)
        for name, (unit, meaning) in VARIABLES.items()
        if name in numbers
    }


def fell(falls: Falls | xr.Dataset) -> NDArray[np.bool_]:
    """Which of the falls have a direction."""
    outcome = np.asarray(falls["outcome"])
    return np.asarray(np.logical_or.reduce([outcome == name for name in FELL]))


def outcomes(falls: Falls | xr.Dataset) -> dict[str, int]:
    """How many falls had each outcome, of those that occur."""
    outcome = np.asarray(falls["outcome"])
    counts: dict[str, int] = {}
    for name in OUTCOMES:
        if sum(counts.values()) < outcome.size:  # a million words are slow to compare
            counts[name] = int(np.count_nonzero(outcome == name))
    return {name: count for name, count in counts.items() if count}


def parameters(body: Body, law: Law, options: Mapping[str, object]) -> dict[str, object]:
    """The attributes of falls: everything that they were computed from but the starts."""
    return {
        "law": law.name,
        **{f"law_{name}": value for name, value in fixed_numbers(law.numbers).items()},
        **{f"body_{name}": value for name, value in asdict(body).items() if not np.ndim(value)},
        **{name: value for name, value in options.items() if value is not None},
        "rimroll_version": _core.__version__,
    }


def body_of(falls: Falls | xr.Dataset) -> Body:
    """The body whose falls they are, or a Body of arrays where it differs from fall to fall.

    Raises ``RimrollError`` for a dataset of something else.
    """
    return Body(**{field.name: _value(falls, f"body_{field.name}") for field in fields(Body)})


def law_of(falls: Falls | xr.Dataset) -> Law:
    """The law under which it fell, with arrays of those numbers that differ from fall to fall.

    Raises ``RimrollError`` for a dataset of something else.
    """
    if "law" not in falls.attrs:
        raise _unknown("law")
    kind = laws.kind(str(falls.attrs["law"]))
    own = [name for name in laws.numbers_of(kind) if _has(falls, f"law_{name}")]
    law = laws.by_name(kind.name, {name: _law_number(falls, name) for name in own})
    for resistance, names in _RESISTANCES.items():
        if _has(falls, f"law_{names[0]}"):
            law += resistance(*(_value(falls, f"law_{name}") for name in names))
    return law


_RESISTANCES: dict[type[Resistance], tuple[str, ...]] = {
    RollingResistance: ("rolling_dry", "rolling_viscous"),
    PivotingFriction: ("pivoting_length",),
    AirDrag: ("air_coefficient", "air_exponent"),
}
"""The numbers of resistances, as a law tells them."""


def _has(falls: Falls | xr.Dataset, name: str) -> bool:
    return name in falls.attrs or name in falls


def _value(falls: Falls | xr.Dataset, name: str) -> Any:
    if name in falls.attrs:
        return number(name, falls.attrs[name])
    if name not in falls:
        raise _unknown(name)
    if isinstance(falls, Falls) or falls[name].dims == ("trial",):
        return np.asarray(falls[name])
    return falls[name]


def _law_number(falls: Falls | xr.Dataset, name: str) -> Any:
    if name in laws.TABLES:
        return listed(name, falls.attrs[f"law_{name}"])
    return _value(falls, f"law_{name}")


def _unknown(name: str) -> RimrollError:
    return RimrollError(f"this dataset records no {name}: there is no {name} in it")
