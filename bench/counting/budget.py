"""Whether the energy of motions and their losses add up to the initial energy."""

from __future__ import annotations

import numpy as np

import rimroll as rr
from counting.draws import Setting
from counting.engines import MAX_STEPS, one

RTOL = 1e-10

ALLOWED = 1e3
"""Errors of the energy in units of rtol: some hundred rockings, landings and changes of contact."""

FALLING_TIMES = 20.0


def surface(rng: np.random.Generator) -> rr.Law:
    """One of the laws, with the friction and restitution of everyday tables."""
    friction, restitution = float(rng.uniform(0.02, 1.0)), float(rng.uniform(0.0, 0.9))
    laws = (rr.NoSlip(), rr.Frictionless(), rr.Coulomb(friction, restitution=restitution))
    return laws[int(rng.integers(len(laws)))]


def unbalanced(setting: Setting, law: rr.Law, starts: rr.State, row: int) -> str:
    """A description of an error in the energy of the motion from a row of starts; empty if there is
    none."""
    start, duration = one(starts, row), FALLING_TIMES * setting.falling_time
    motion = rr.simulate(
        setting.body,
        start,
        law,
        duration=duration,
        gravity=setting.gravity,
        rtol=RTOL,
        max_steps=MAX_STEPS,
    )
    budget = motion.energy_budget
    whole = max(np.max(np.abs(budget)), np.max(motion.kinetic_energy))
    off = float(np.max(np.abs(budget - budget[0])) / whole)
    if off <= ALLOWED * RTOL:
        return ""
    return (
        f"{off:.1e} of the energy is not accounted for: rr.simulate({setting.body!r}, {start!r},"
        f" {law!r}, duration={duration!r}, gravity={setting.gravity!r}, rtol={RTOL})"
    )
