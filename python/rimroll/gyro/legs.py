"""A fall or a rise, read without any law of contact: where the vertical is, and the headings.

From the rates alone one knows how the symmetry axis n moves relative to the body's attitude at one
sample, but not where the vertical v is there. Newton and Euler determine it. With l the angular
velocity about the vertical without that of the spin, l = v·Ω_across = yaw rate × sin² tilt, they
give, whatever the horizontal force of the table on the rim is,

    A dl/dt = C s sin(tilt) d(tilt)/dt − (H C / R) sin(tilt) ds/dt,

in which the spin s is measured, so that A l + C ∫ s d(cos tilt) + (H C / R) ∫ sin(tilt) ds is
constant. At a near-collision the axis passes the vertical closely, which gives v but for a small
displacement. l is linear in it: the displacement and the constant follow by least squares.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from rimroll.body import Body
from rimroll.gyro.attitude import across

Array = NDArray[np.float64]

TIME_ERROR = 0.5
"""Standard deviation of the time of a collision, in steps of the record."""
SENSITIVITY = 0.001
"""Error of the momentum over the rate: the axes of a sensor are not equally sensitive."""
NEAREST = 5
"""Samples at the edge of a leg from which its rate is extrapolated to the collision."""


@dataclass(frozen=True)
class Path:
    """The motion of the axis over some samples, in the frame of the body at one of them.

    ``axis`` n (n, 3), ``turning`` Ω without its part along n (n, 3) in rad/s, ``spin`` s (n,) in
    rad/s, ``t`` (n,) in s.
    """

    t: Array
    axis: Array
    turning: Array
    spin: Array

    def part(self, first: int, last: int) -> Path:
        """From one sample to another, both included."""
        some = slice(first, last + 1)
        return Path(self.t[some], self.axis[some], self.turning[some], self.spin[some])


def path_of(t: Array, rates: Array, axis: Array, turned: Array) -> Path:
    """The path of a body's axis, given along the sensor's axes, by its attitudes (n, 3, 3)."""
    spin = rates @ axis
    turning = np.einsum("nij,nj->ni", turned, rates - np.outer(spin, axis))
    return Path(t, turned @ axis, turning, spin)


@dataclass(frozen=True)
class Leg:
    """A fall or a rise whose vertical is known.

    ``tilt``, ``heading`` (the yaw, but for a constant that is common to all legs in one frame),
    both (n,) in rad; ``rate`` and ``direction``: size and heading of the angular velocity across
    the axis, rad/s and rad; ``momentum`` l (n,), smoothed by the law above, rad/s;
    ``offset_error``: the standard deviation of the vertical across the path, rad; ``residual``:
    what is left of l, over its noise.
    """

    t: Array
    tilt: Array
    heading: Array
    tilt_rate: Array
    momentum: Array
    spin: Array
    rate: Array
    direction: Array
    offset_error: float
    momentum_error: float
    residual: Array


def leg_of(path: Path, collision: float, body: Body, noise: float, up: tuple[Array, Array]) -> Leg:
    """The leg with samples on one side of a collision (time in s); noise of a rate in rad/s.

    ``up`` are two horizontal directions from which headings are counted.
    """
    edge = 0 if path.t[0] > collision else len(path.t) - 1
    n, turning = path.axis[edge], path.turning[edge]
    # The axis moves along the path with Ω × n, on to the vertical or away from it.
    along = np.cross(turning, n) / np.linalg.norm(turning)
    angle = _angle_between(path, edge, collision)
    vertical = np.cos(angle) * n + np.sin(angle) * along
    sideways = turning - (turning @ vertical) * vertical
    sideways /= np.linalg.norm(sideways)
    onward = np.cross(vertical, sideways)
    # How far along the path the vertical is follows from the time of the collision, which is
    # known to a part of a step; on a curved path also from the momentum.
    along_error = TIME_ERROR * float(np.median(np.diff(path.t)) * np.linalg.norm(turning))
    scatter = np.hypot(noise, SENSITIVITY * np.linalg.norm(path.turning, axis=1))
    shift = np.zeros(3)
    for _ in range(3):  # the terms of the spin depend little on the vertical
        moved = vertical + shift[0] * sideways + shift[1] * onward
        work = _of_spin(path, moved / np.linalg.norm(moved), body)
        design = np.stack(
            [path.turning @ sideways, path.turning @ onward, -np.ones(len(path.t))], axis=-1
        )
        constant = path.turning @ vertical + work
        weighted = design / scatter[:, np.newaxis]
        precision = weighted.T @ weighted + np.diag([0.0, along_error**-2, 0.0])
        covariance = np.linalg.inv(precision)
        shift = -covariance @ weighted.T @ (constant / scatter)
    vertical = vertical + shift[0] * sideways + shift[1] * onward
    vertical /= np.linalg.norm(vertical)
    residual = (design @ shift + constant) / scatter
    cos = np.clip(path.axis @ vertical, -1.0, 1.0)
    leaning = path.axis - cos[:, np.newaxis] * vertical
    heading = np.unwrap(np.arctan2(-leaning @ up[1], -leaning @ up[0]))
    return Leg(
        path.t,
        np.arccos(cos),
        heading,
        _tilt_rate(path, vertical, cos),
        shift[2] - work,
        path.spin,
        np.linalg.norm(path.turning, axis=1),
        np.unwrap(np.arctan2(path.turning @ up[1], path.turning @ up[0])),
        float(np.sqrt(covariance[0, 0])),
        float(np.sqrt(covariance[2, 2])),
        residual,
    )


def _angle_between(path: Path, edge: int, collision: float) -> float:
    """The angle that the axis covers from the edge of a leg to the collision, rad, signed."""
    nearest = np.argsort(np.abs(path.t - path.t[edge]))[: max(NEAREST, len(path.t) // 8)]
    rate = np.linalg.norm(path.turning[nearest], axis=1)
    slope, value = np.polyfit(path.t[nearest] - path.t[edge], rate, 1)
    time = collision - path.t[edge]
    return float(time * (value + 0.5 * slope * time))


def _of_spin(path: Path, vertical: Array, body: Body) -> Array:
    """(C ∫ s d(cos tilt) + (H C / R) ∫ sin(tilt) ds) / A, rad/s, from the first sample on."""
    cos = np.clip(path.axis @ vertical, -1.0, 1.0)
    sin = np.sqrt(1.0 - cos**2)
    s = path.spin
    first = np.cumsum(0.5 * (s[1:] + s[:-1]) * np.diff(cos))
    second = np.cumsum(0.5 * (sin[1:] + sin[:-1]) * np.diff(s))
    total = first + body.height / body.radius * second
    return body.axial_inertia / body.transverse_inertia * np.concatenate(([0.0], total))


def _tilt_rate(path: Path, vertical: Array, cos: Array) -> Array:
    """d(tilt)/dt = −v·(Ω × n)/sin(tilt)."""
    rate = -np.cross(path.turning, path.axis) @ vertical
    return rate / np.maximum(np.sqrt(1.0 - cos**2), 1e-3)


def horizontal(axis: Array) -> tuple[Array, Array]:
    """Two directions across the axis from which headings are counted."""
    return across(axis)
