"""Many falls at once: what became of a body let go from each of many starts."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import asdict, dataclass, fields
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from rimroll import _core, laws
from rimroll.body import Body
from rimroll.errors import RimrollError, callback, expect, hold
from rimroll.falls import Column, Falls, Interrupted
from rimroll.falls import rows as in_rows
from rimroll.given import Number, Values, number, numbers
from rimroll.laws import (
    AirDrag,
    Law,
    PivotingFriction,
    Resistance,
    RollingResistance,
    contact_law,
    listed,
)
from rimroll.motion import thread_count
from rimroll.options import Options
from rimroll.refusals import placed
from rimroll.state import State

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
    body, law
        What rolls, and how its rim meets the table.
    starts
        A State of arrays (n,).
    grip
        A factor of the law's friction, one for all or (n,).
    duration, gravity, rtol, topple_tilt, max_steps
        As for :func:`rimroll.simulate`.
    threads
        How many to use; as many as there are processors unless given.
    progress
        Called some ten times a second with the number of falls done, and of all.

    Returns
    -------
    xarray.Dataset
        One row a ``trial``: ``outcome`` (see :data:`OUTCOMES`), the ``start_...`` and ``grip`` it
        was computed from, and the :data:`VARIABLES`. ``turn`` is by how much the contact point went
        round, with its sign, and ``direction`` where that led: a body that dips and falls over near
        where it leaned has a small turn. ``turn``, ``direction``, ``min_tilt`` and
        ``near_time`` are NaN for a fall that did not come down, and for one that ``hovered`` or
        ``failed``, whose turn was not over when time or steps were up. The attributes hold
        everything else that it was computed from. ``outcome``, ``near_time`` and ``end_tilt`` are
        what :func:`rimroll.exact_turn` calls ``status``, ``min_time`` and ``max_tilt``.

    Raises
    ------
    RimrollError
        A number outside its bounds, or starts that are no flat arrays; of an array the message
        names the element, ``tilt[1]``.
    Interrupted
        On Ctrl-C; it carries the falls done so far.
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
    rows = _rows(starts)
    grips = _grips(grip, len(rows.tilt))
    count = len(rows.tilt)

    def said(done: int) -> None:
        if progress is not None:
            progress(done, count)

    try:
        table, stopped = _core.ensemble(body, rows, law, grips, *options.values, workers, said)
    except RimrollError as refusal:
        raise placed(refusal, body, starts, rows, options.gravity, options.topple_tilt) from None
    columns = _columns(rows, grips, table)
    falls = in_rows(columns, parameters(body, law, asdict(options)))
    if isinstance(stopped, KeyboardInterrupt):
        raise Interrupted(falls) from None
    if stopped is not None:
        raise stopped
    return falls


@dataclass(frozen=True)
class _Rows:
    """A start for each trial: arrays (n,)."""

    tilt: Array
    tilt_rate: Array
    yaw: Array
    yaw_rate: Array
    spin: Array
    spin_rate: Array


def _rows(starts: State) -> _Rows:
    if len(starts.shape) > 1:
        raise RimrollError(f"starts must be flat arrays, got shape {starts.shape}")
    shape = starts.shape or (1,)
    return _Rows(
        **{
            field.name: np.array(np.broadcast_to(getattr(starts, field.name), shape), np.float64)
            for field in fields(_Rows)
        }
    )


def _grips(grip: Values, count: int) -> Array:
    grips = numbers("grip", grip)
    if grips.shape not in ((), (count,)):
        raise RimrollError(f"grip must be a number or {count} of them, got shape {grips.shape}")
    hold("grip", grips, np.isfinite(grips) & (grips >= 0.0), "finite and >= 0")
    return np.array(np.broadcast_to(grips, (count,)))


def _columns(rows: _Rows, grips: Array, table: Array) -> dict[str, Column]:
    done = len(table)
    told = dict(zip(_core.FALL_COLUMNS, table.T, strict=True))
    told["time"] = told.pop("end_time")
    gone_round = np.mod(told.pop("end_yaw") - rows.yaw[:done], 2.0 * np.pi)
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
            f"start_{name}": Column(column[:done], _unit(name))
            for name, column in vars(rows).items()
        },
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


def _unit(name: str) -> str:
    return "rad/s" if name.endswith("_rate") else "rad"


def parameters(body: Body, law: Law, options: Mapping[str, object]) -> dict[str, object]:
    """The attributes of falls: everything that they were computed from but the starts."""
    return {
        "law": law.name,
        **{f"law_{name}": value for name, value in law.numbers.items()},
        **{f"body_{name}": value for name, value in asdict(body).items()},
        **{name: value for name, value in options.items() if value is not None},
        "rimroll_version": _core.__version__,
    }


def body_of(falls: Falls | xr.Dataset) -> Body:
    """The body whose falls they are; raises ``RimrollError`` for a dataset of something else."""
    return Body(**{field.name: _number(falls, f"body_{field.name}") for field in fields(Body)})


def law_of(falls: Falls | xr.Dataset) -> Law:
    """The law under which it fell; raises ``RimrollError`` for a dataset of something else."""
    kind = laws.kind(str(_told(falls, "law")))
    own = [name for name in laws.numbers_of(kind) if f"law_{name}" in falls.attrs]
    law = laws.by_name(kind.name, {name: _law_number(falls, name) for name in own})
    for resistance, names in _RESISTANCES.items():
        if f"law_{names[0]}" in falls.attrs:
            law += resistance(*(_number(falls, f"law_{name}") for name in names))
    return law


_RESISTANCES: dict[type[Resistance], tuple[str, ...]] = {
    RollingResistance: ("rolling_dry", "rolling_viscous"),
    PivotingFriction: ("pivoting_length",),
    AirDrag: ("air_coefficient", "air_exponent"),
}
"""The numbers of resistances, as a law tells them."""


def _told(falls: Falls | xr.Dataset, name: str) -> object:
    if name not in falls.attrs:
        raise RimrollError(f"falls must be a dataset of rimroll.ensemble: there is no {name} in it")
    return falls.attrs[name]


def _law_number(falls: Falls | xr.Dataset, name: str) -> float | tuple[float, ...]:
    if name in laws.TABLES:
        return listed(name, _told(falls, f"law_{name}"))
    return _number(falls, f"law_{name}")


def _number(falls: Falls | xr.Dataset, name: str) -> float:
    return number(name, _told(falls, name))
