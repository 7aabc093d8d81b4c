"""From the paper's Euler angles to poses and velocities, and back to tilt and yaw."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from rimroll_score.protocol import Body, State

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Angles:
    """Tilt, yaw and spin (rad) and their rates (rad/s), as in ``rimroll.State``."""

    tilt: float
    tilt_rate: float = 0.0
    yaw: float = 0.0
    yaw_rate: float = 0.0
    spin: float = 0.0
    spin_rate: float = 0.0


def frame(tilt: float, yaw: float) -> Array:
    """Columns e_x2, e_y1, e_z2 of the frame that yaws and tilts with the body."""
    c, s, cy, sy = math.cos(tilt), math.sin(tilt), math.cos(yaw), math.sin(yaw)
    return np.array([[c * cy, -sy, -s * cy], [c * sy, cy, -s * sy], [s, 0.0, c]])


def state(body: Body, angles: Angles, slides: bool = False) -> State:
    """The state of a body on the table, whose rim rolls.

    If it ``slides``, its centre of mass moves vertically instead.
    """
    axes = frame(angles.tilt, angles.yaw)
    c, s = math.cos(angles.spin), math.sin(angles.spin)
    spun = axes @ np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])
    turning = (
        angles.yaw_rate * np.array([0.0, 0.0, 1.0])
        - angles.tilt_rate * axes[:, 1]
        + angles.spin_rate * axes[:, 2]
    )
    above = body.radius * axes[:, 0] + body.height * axes[:, 2]  # centre from the contact point
    velocity = np.cross(turning, above)
    if slides:
        velocity = np.array([0.0, 0.0, velocity[2]])
    return State(np.array([0.0, 0.0, above[2]]), spun, velocity, turning)


def tilt_of(axis: Array) -> Array:
    """Tilt of symmetry axes (..., 3), rad."""
    return np.asarray(np.arctan2(np.hypot(axis[..., 0], axis[..., 1]), axis[..., 2]))


def yaw_of(axis: Array) -> Array:
    """Yaw of symmetry axes (..., 3), which lean towards yaw + π; rad, in (−π, π]."""
    return np.asarray(np.arctan2(-axis[..., 1], -axis[..., 0]))


def wrapped(angle: float) -> float:
    """The angle in [−π, π)."""
    return (angle + math.pi) % (2.0 * math.pi) - math.pi
