"""How a can moves in ``rolling_near``: what the page draws and films."""

from __future__ import annotations

import math
from dataclasses import asdict

import numpy as np
from numpy.typing import NDArray

import rimroll as rr
from rimroll_score.cases import Case
from rimroll_score.euler import frame, tilt_of, yaw_of
from rimroll_score.samples import Samples

Path5 = NDArray[np.float64]
"""Rows of x, y, z of the centre of mass (m), tilt and yaw (rad)."""

NEAR = "rolling_near"
STEP = 1e-3
"""Step of the motion, s."""
EVERY = 5e-3
"""Time between two rows, s."""
DIGITS = 4


def path_of(samples: Samples) -> list[list[float]]:
    """The path of a motion that an engine computed, rounded."""
    every = max(1, round(EVERY / (samples.time[1] - samples.time[0])))
    axis = samples.axis[::every]
    rows = np.column_stack([samples.position[::every], tilt_of(axis), yaw_of(axis)])
    rounded: list[list[float]] = np.round(rows, DIGITS).tolist()
    return rounded


def seen_from_above(path: Path5) -> Path5:
    """The tip of the unit axis, (n, 2)."""
    out = -np.sin(path[:, 3:4])
    return np.asarray(out * np.column_stack([np.cos(path[:, 4]), np.sin(path[:, 4])]))


def true_path(case: Case) -> Path5:
    """The path of a rolling body's case as it truly is."""
    motion = true_motion(case)
    count = round(case.duration / EVERY)
    found = motion.evaluate(np.linspace(0.0, count * EVERY, count + 1)[: count + 1])
    begin = motion.center[0] * [1.0, 1.0, 0.0]  # the engine starts above the origin
    return np.column_stack([found.center - begin, found.tilt, found.yaw])


def start_of(case: Case) -> rr.State:
    """The start of a rolling body's case in rimroll's angles."""
    axis, turning = case.state.rotation[:, 2], case.state.angular_velocity
    tilt = math.atan2(math.hypot(axis[0], axis[1]), axis[2])
    axes = frame(tilt, math.atan2(-axis[1], -axis[0]))
    yaw_rate = float(turning @ axes[:, 0]) / math.sin(tilt)
    return rr.State(
        tilt=tilt, tilt_rate=-float(turning @ axes[:, 1]), yaw_rate=yaw_rate,
        spin_rate=float(turning @ axis) - yaw_rate * math.cos(tilt),
    )  # fmt: skip


def true_motion(case: Case) -> rr.Motion:
    """The motion of a rolling body's case, by rimroll."""
    return rr.simulate(
        rr.Body(**asdict(case.scene.body)), start_of(case), rr.NoSlip(),
        duration=case.duration, gravity=case.scene.gravity,
    )  # fmt: skip
