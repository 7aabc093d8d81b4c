"""The paper's own can, start and gravity, and the two motions that it shows."""

from __future__ import annotations

from functools import cache

import numpy as np

from rimroll import bodies
from rimroll.laws import Frictionless, Law, NoSlip
from rimroll.motion import Motion, simulate
from rimroll.state import State

CAN = bodies.can_2007()

GRAVITY = 9.8
"""The paper's gravity, m/s² (caption of the simulation figure)."""

MEASURED = ((213.0, 3.9), (217.9, 4.5))
"""Turns of the can in the paper's experiment, leftward and rightward: mean, s.d., degrees."""

LAWS: tuple[Law, ...] = (NoSlip(), Frictionless())

LAW_NAMES = {"no_slip": "no slip", "frictionless": "frictionless"}


def start(sideways: float = 0.005) -> State:
    """The paper's start (caption of the simulation figure), ψ̇ = θ̇ = ``sideways`` rad/s."""
    return State(tilt=np.pi / 6, tilt_rate=-0.5, yaw_rate=sideways, spin_rate=sideways)


@cache
def motion(law: Law, sideways: float = 0.005, duration: float = 2.0) -> Motion:
    """The can's motion from the paper's start; computed once."""
    return simulate(CAN, start(sideways), law, duration, gravity=GRAVITY, rtol=1e-12)
