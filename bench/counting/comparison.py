"""Where the two engines differ, and why."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

import rimroll as rr
from counting.draws import Setting
from counting.engines import (
    MAX_STEPS,
    RTOL,
    TIGHTEST,
    Array,
    Outcomes,
    by_quadrature,
    by_steps,
    one,
)

FLAT = 1e-16
"""Below this tilt (rad) a base counts as flat: the engines end the motion at a step or a root."""

ULPS = 64
"""Starts that differ by at most this many units of their last digits count as equal, since both
engines round."""

NEIGHBOURS = 96
"""How many neighbouring starts are computed."""

ALLOWED = 30.0
"""Errors of turns by steps in units of rtol (1 + |turn| + its change with the start)."""


@dataclass(frozen=True)
class Difference:
    """A start from which the engines differ. `why` is empty if it is not explained."""

    setting: Setting
    start: rr.State
    what: str
    why: str

    def reproducer(self) -> str:
        """Python that computes both, as one expression each."""
        setting = self.setting
        common = f"{setting.body!r}, {self.start!r}, {setting.law!r}"
        gravity = f"gravity={setting.gravity!r}"
        return (
            f"rr.exact_turn({common}, {gravity}); "
            f"rr.simulate({common}, duration={1000 * setting.falling_time!r}, {gravity},"
            f" rtol={TIGHTEST})"
        )


def differences(setting: Setting, starts: rr.State) -> Iterator[Difference]:
    """All differences from starts (n,)."""
    exact, stepped = by_quadrature(setting, starts), by_steps(setting, starts)
    for row in np.flatnonzero(~_agree(exact, stepped, RTOL, 0.0)):
        yield difference(setting, one(starts, int(row)))


def difference(setting: Setting, start: rr.State) -> Difference:
    """How the engines differ for one start with a tight tolerance, and what explains it."""
    exact, stepped = by_quadrature(setting, start), by_steps(setting, start, TIGHTEST)
    what = (
        f"{exact.outcome[0]} with a turn of {exact.turn[0]:.17g} rad by quadrature,"
        f" {stepped.outcome[0]} with one of {stepped.turn[0]:.17g} rad by steps"
    )
    return Difference(setting, start, what, explanation(setting, start, exact, stepped))


def explanation(setting: Setting, start: rr.State, exact: Outcomes, stepped: Outcomes) -> str:
    """Why two outcomes of a start (1,) differ; empty if unknown."""
    if _agree(exact, stepped, TIGHTEST, 0.0).all():
        return "equal by tighter steps"
    if stepped.outcome[0] == "failed":
        return f"more than {MAX_STEPS} steps"
    if np.nanmin([exact.min_tilt[0], stepped.min_tilt[0], 1.0]) < 2.0 * FLAT:
        return "the smallest tilt is about that at which a base counts as flat"
    if stepped.outcome[0] == "hovered" and exact.end_time[0] > stepped.end_time[0]:
        return "the turn takes longer than a fall is followed"
    beside = neighbours(start)
    engines = by_quadrature(setting, beside), by_steps(setting, beside, TIGHTEST)
    if exact.outcome[0] != stepped.outcome[0]:
        both = {exact.outcome[0], stepped.outcome[0]}
        on_edge = any(both <= set(engine.outcome) for engine in engines)
        return f"the outcome changes within {ULPS} units of the last digits" if on_edge else ""
    spread = max(_spread(engine) for engine in engines)
    if _agree(exact, stepped, TIGHTEST, spread).all():
        return f"the turn changes as much within {ULPS} units of the last digits"
    return ""


def neighbours(start: rr.State) -> rr.State:
    """Starts (NEIGHBOURS,) within some units of the last digits of one."""
    rng = np.random.default_rng(2007)
    reach = 2.0 ** rng.uniform(0.0, np.log2(ULPS), NEIGHBOURS)

    def beside(value: float) -> Array:
        units = np.round(reach * rng.uniform(-1.0, 1.0, NEIGHBOURS))
        return np.asarray(value + units * np.spacing(np.abs(value)))

    names = ("tilt", "tilt_rate", "yaw_rate", "spin_rate")
    return rr.State(**{name: beside(float(getattr(start, name))) for name in names})


def _spread(outcomes: Outcomes) -> float:
    turns = outcomes.turn[np.isfinite(outcomes.turn)]
    return float(np.ptp(turns)) if turns.size else 0.0


def _agree(exact: Outcomes, stepped: Outcomes, rtol: float, spread: float) -> NDArray[np.bool_]:
    """Which outcomes (n,) are equal, with turns equal within the tolerance of the steps and the
    start."""
    neither = np.isnan(exact.turn) & np.isnan(stepped.turn)
    allowed = ALLOWED * (rtol * (1.0 + np.abs(exact.turn)) + spread)
    close = np.abs(exact.turn - stepped.turn) <= allowed
    return np.asarray((exact.outcome == stepped.outcome) & (neither | close))
