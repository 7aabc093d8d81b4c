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

import math
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from rimroll.body import Body
from rimroll.gyro.attitude import across, product, unit
from rimroll.gyro.filtering import Filter

Array = NDArray[np.float64]

TIME_ERROR = 0.5
"""Standard deviation of the time of a collision, in steps of the record."""
SENSITIVITY = 0.001
"""Error of the momentum over the rate: the axes of a sensor are not equally sensitive."""
SMEARED, DECAY = 1.0, 2.0
"""What a sensor's filter leaves of a jump, over the rate, at the collision and by how much its
logarithm falls from sample to sample: as for a second-order filter (Butterworth), which loses
√2 π in it in a period of its cut-off frequency, at 0.45 of the sampling rate."""
NEAREST = 5
"""Samples at the edge of a leg from which its rate is extrapolated to the collision."""


@dataclass(frozen=True)
class Path:
    """The motion of the axis over some samples, in the frame of the body at one of them.

    ``axis`` n (n, 3), ``turning`` Ω without its part along n (n, 3) in rad/s, ``rate`` its size
    (n,), ``spin`` s (n,) in rad/s, ``t`` (n,) in s.
    """

    t: Array
    axis: Array
    turning: Array
    rate: Array
    spin: Array

    def part(self, first: int, last: int) -> Path:
        """From one sample to another, both included."""
        some = slice(first, last + 1)
        return Path(
            self.t[some], self.axis[some], self.turning[some], self.rate[some], self.spin[some]
        )


def path_of(t: Array, rates: Array, axis: Array, turned: Array) -> Path:
    """The path of a body's axis, given along the sensor's axes, by its attitudes (n, 3, 3)."""
    spin = rates @ axis
    across_axis = rates - spin[:, np.newaxis] * axis
    turning = (turned @ across_axis[:, :, np.newaxis])[:, :, 0]
    rate = np.sqrt(np.einsum("ni,ni->n", turning, turning))
    return Path(t, turned @ axis, turning, rate, spin)


@dataclass(frozen=True)
class Leg:
    """A fall or a rise whose vertical is known.

    ``path`` is its motion, ``vertical`` the upward direction in its frame, and ``up`` are two
    horizontal directions from which headings are counted. ``momentum`` l (n,), smoothed by the law
    above, is in rad/s; ``offset_error`` is the standard deviation of the vertical across the path,
    rad, and ``momentum_error`` that of the momentum, rad/s; ``residual``: what is left of l, over
    its noise.
    """

    path: Path
    vertical: Array
    up: tuple[Array, Array]
    momentum: Array
    offset_error: float
    momentum_error: float
    residual: Array

    @property
    def t(self) -> Array:
        """Times of the samples, s."""
        return self.path.t

    @property
    def spin(self) -> Array:
        """The spin about the axis, rad/s."""
        return self.path.spin

    @property
    def rate(self) -> Array:
        """The size of the angular velocity across the axis, rad/s."""
        return self.path.rate

    @cached_property
    def cos(self) -> Array:
        """The cosine of the tilt."""
        return np.asarray(np.clip(self.path.axis @ self.vertical, -1.0, 1.0))

    @cached_property
    def tilt(self) -> Array:
        """The tilt, rad."""
        return np.arccos(self.cos)

    @cached_property
    def heading(self) -> Array:
        """The yaw, but for a constant that is common to all legs in one frame, rad."""
        leaning = self.path.axis - self.cos[:, np.newaxis] * self.vertical
        return np.unwrap(np.arctan2(-leaning @ self.up[1], -leaning @ self.up[0]))

    @cached_property
    def tilt_rate(self) -> Array:
        """d(tilt)/dt = −v·(Ω × n)/sin(tilt), rad/s."""
        rate = -np.cross(self.path.turning, self.path.axis) @ self.vertical
        return np.asarray(rate / np.maximum(np.sqrt(1.0 - self.cos**2), 1e-3))

    @cached_property
    def direction(self) -> Array:
        """The heading of the angular velocity across the axis, rad."""
        turning = self.path.turning
        return np.unwrap(np.arctan2(turning @ self.up[1], turning @ self.up[0]))


def leg_of(
    path: Path,
    collision: float,
    body: Body,
    noise: float,
    step: float,
    up: tuple[Array, Array],
    taken_out: Filter | None = None,
) -> Leg:
    """The leg with samples on one side of a collision (time in s); noise of a rate in rad/s.

    ``step`` is the time from sample to sample, s; ``up`` are two horizontal directions from which
    headings are counted; ``taken_out`` is a filter that the record went through.
    """
    edge = 0 if path.t[0] > collision else len(path.t) - 1
    n, turning = path.axis[edge], path.turning[edge]
    # The axis moves along the path with Ω × n, on to the vertical or away from it.
    along = unit(product(turning, n))
    angle = _angle_between(path, edge, collision)
    vertical = math.cos(angle) * n + math.sin(angle) * along
    sideways = unit(turning - (turning @ vertical) * vertical)
    onward = product(vertical, sideways)
    # How far along the path the vertical is follows from the time of the collision, which is
    # known to a part of a step; on a curved path also from the momentum.
    along_error = TIME_ERROR * step * float(path.rate[edge])
    apart = np.abs(path.t - collision)
    smeared = SMEARED * np.exp(-DECAY / step * apart)
    if taken_out is not None:
        smeared += 2.0 * taken_out.left(step) * np.exp(-apart / taken_out.decay)
    scatter = np.sqrt(noise**2 + (SENSITIVITY * path.rate) ** 2 + (smeared * path.rate[edge]) ** 2)
    design = np.empty((len(path.t), 3))
    design[:, 0], design[:, 1], design[:, 2] = path.turning @ sideways, path.turning @ onward, -1.0
    weighted = design / scatter[:, np.newaxis]
    precision = weighted.T @ weighted
    precision[1, 1] += along_error**-2
    covariance = np.linalg.inv(precision)
    momentum = path.turning @ vertical
    shift = np.zeros(3)
    for _ in range(3):  # the terms of the spin depend little on the vertical
        work = _of_spin(path, unit(vertical + shift[0] * sideways + shift[1] * onward), body)
        constant = momentum + work
        shift = -covariance @ (weighted.T @ (constant / scatter))
    return Leg(
        path,
        unit(vertical + shift[0] * sideways + shift[1] * onward),
        up,
        shift[2] - work,
        math.sqrt(covariance[0, 0]),
        math.sqrt(covariance[2, 2]),
        (design @ shift + constant) / scatter,
    )


def _angle_between(path: Path, edge: int, collision: float) -> float:
    """The angle that the axis covers from the edge of a leg to the collision, rad, signed."""
    count = max(NEAREST, len(path.t) // 8)
    nearest = slice(0, count) if edge == 0 else slice(-count, None)
    rate, t = path.rate[nearest], path.t[nearest] - path.t[edge]
    middle, away = rate.mean(), t - t.mean()
    slope = (away @ rate) / (away @ away)
    value = middle - slope * t.mean()
    time = collision - path.t[edge]
    return float(time * (value + 0.5 * slope * time))


def _of_spin(path: Path, vertical: Array, body: Body) -> Array:
    """(C ∫ s d(cos tilt) + (H C / R) ∫ sin(tilt) ds) / A, rad/s, from the first sample on."""
    cos = np.minimum(np.maximum(path.axis @ vertical, -1.0), 1.0)
    sin = np.sqrt(1.0 - cos**2)
    s, ratio = path.spin, 0.5 * body.axial_inertia / body.transverse_inertia
    of_tilt = (s[1:] + s[:-1]) * (cos[1:] - cos[:-1])
    of_spin = (sin[1:] + sin[:-1]) * (s[1:] - s[:-1])
    total = np.zeros(len(s))
    np.cumsum(of_tilt + body.height / body.radius * of_spin, out=total[1:])
    return ratio * total


def horizontal(axis: Array) -> tuple[Array, Array]:
    """Two directions across the axis from which headings are counted."""
    return across(axis)
