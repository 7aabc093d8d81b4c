"""Falls by both engines: quadrature, and steps to a tolerance."""

from __future__ import annotations

from dataclasses import dataclass, fields

import numpy as np
from numpy.typing import NDArray

import rimroll as rr
from counting.draws import Setting
from rimroll.many.ensemble import exact_falls

RTOL = 1e-10
"""The tolerance of the steps, unless two engines differ."""

TIGHTEST = 1e-13
"""The tolerance of the steps where they differ."""

FALLING_TIMES = 1000.0
"""A fall is followed for this many times the time scale of falling over, as in the quadrature."""

MAX_STEPS = 20_000

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Outcomes:
    """Arrays (n,): outcome by name, turn (rad), smallest tilt (rad) and time of the end (s)."""

    outcome: NDArray[np.str_]
    turn: Array
    min_tilt: Array
    end_time: Array


def by_quadrature(setting: Setting, starts: rr.State) -> Outcomes:
    """Outcomes of a body from one start or from starts (n,), by quadrature."""
    names, shape = [f.name for f in fields(rr.State)], starts.shape or (1,)
    starts = rr.State(**{name: np.broadcast_to(getattr(starts, name), shape) for name in names})
    falls = exact_falls(
        setting.body,
        starts,
        setting.law,
        gravity=setting.gravity,
        topple_tilt=None,
        threads=None,
        progress=None,
    )
    return Outcomes(falls["outcome"], falls["turn"], falls["min_tilt"], falls["end_time"])


def by_steps(setting: Setting, starts: rr.State, rtol: float = RTOL) -> Outcomes:
    """Outcomes by time stepping."""
    falls = rr.ensemble(
        setting.body,
        starts,
        setting.law,
        duration=FALLING_TIMES * setting.falling_time,
        gravity=setting.gravity,
        rtol=rtol,
        max_steps=MAX_STEPS,
    )
    return Outcomes(*(falls[field.name].values for field in fields(Outcomes)))


def one(starts: rr.State, row: int) -> rr.State:
    """A row of starts."""
    return rr.State(
        **{field.name: _at(getattr(starts, field.name), row) for field in fields(rr.State)}
    )


def _at(values: object, row: int) -> float:
    column = np.asarray(values, np.float64)
    return float(column[row] if column.ndim else column)
