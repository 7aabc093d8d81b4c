"""The turn of each near-collision by the legs around it, and the body's axis in the sensor.

From the rates alone one knows how the symmetry axis n moves relative to the body's attitude at one
sample, but not where the vertical v is there. Newton and Euler determine it. With l the angular
velocity about the vertical without that of the spin, l = v·Ω_across = yaw rate × sin² tilt, they
give, whatever the horizontal force of the table on the rim is,

    A dl/dt = C s sin(tilt) d(tilt)/dt − (H C / R) sin(tilt) ds/dt,

in which the spin s is measured, so that A l + C ∫ s d(cos tilt) + (H C / R) ∫ sin(tilt) ds is
constant. At a near-collision the axis passes the vertical closely, which gives v but for a small
displacement. l is linear in it: the displacement and the constant follow by least squares.

Newton's and Euler's laws leave nothing of the angular velocity about the vertical (see ``legs``) if
the axis is right. All falls together determine it, about as well as the spin and the paths allow.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from rimroll.bodies.body import Body
from rimroll.sensors.gyro.peaks import GUARD, Filter, Passage

Array = NDArray[np.float64]


def attitudes(t: Array, rates: Array) -> Array:
    """Rotations (n, 3, 3) from the body at each time to the body at the first.

    Between two samples the rates are taken as linear, with Magnus's correction of second order.
    """
    from scipy.spatial.transform import Rotation

    steps = np.diff(t)[:, np.newaxis]
    mean = 0.5 * steps * (rates[:-1] + rates[1:])
    turned_by = mean + steps**2 / 12.0 * np.cross(rates[:-1], rates[1:])
    increments = Rotation.from_rotvec(turned_by).as_matrix()
    turned = np.empty((len(t), 3, 3))
    turned[0] = np.eye(3)
    for i, increment in enumerate(increments):
        turned[i + 1] = turned[i] @ increment
    return turned


def across(axis: Array) -> tuple[Array, Array]:
    """Two unit vectors that make a right-handed frame with a unit vector, which is the third."""
    least = int(np.argmin(np.abs(axis)))
    first = -axis[least] * axis
    first[least] += 1.0
    first = unit(first)
    return first, product(axis, first)


def product(a: Array, b: Array) -> Array:
    """The vector product of two vectors: quicker than NumPy's, which is made for many."""
    (a0, a1, a2), (b0, b1, b2) = a.tolist(), b.tolist()
    return np.array([a1 * b2 - a2 * b1, a2 * b0 - a0 * b2, a0 * b1 - a1 * b0])


def unit(vector: Array) -> Array:
    """A vector (3,) over its length."""
    return np.asarray(vector / math.sqrt(vector @ vector))


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


SCALE_ERROR = 0.012
"""Standard deviation of the sensitivity: data sheets have ±1 % as typical, ±3 % as the limit."""
AT_MAXIMUM = 3
"""Samples at each end of a leg that say when the tilt was largest."""


@dataclass(frozen=True)
class Sensed:
    """The samples of a passage, less their bias, and what else its legs depend on.

    ``cut_off``: whether some are beyond the sensor's range.
    """

    passage: Passage
    t: Array
    rates: Array
    noise: float
    bias_error: float
    body: Body
    taken_out: Filter | None = None
    cut_off: bool = False

    @cached_property
    def mistaken(self) -> list[Sensed]:
        """Copies that are wrong by one standard deviation of an error that a whole record shares.

        These errors are the bias along x, y and z, and the sensitivity along x, y and z.
        """
        biased = [self.rates + self.bias_error * along for along in np.eye(3)]
        scaled = [self.rates * (1.0 + SCALE_ERROR * along) for along in np.eye(3)]
        return [replace(self, rates=rates) for rates in (*biased, *scaled)]

    @cached_property
    def attitudes(self) -> Array:
        """Rotations from the body at each sample to that at the last one before the collision."""
        turned = attitudes(self.t, self.rates)
        origin = turned[self.passage.before - self.passage.start]
        return np.asarray(origin.T @ turned)

    @cached_property
    def step(self) -> float:
        """The usual time from sample to sample, s."""
        return float(np.median(np.diff(self.t)))

    def legs(self, axis: Array, later: float = 0.0) -> tuple[Leg, Leg]:
        """The fall and the rise, for an axis in the sensor, the collision ``later`` by seconds."""
        passage, path = self.passage, path_of(self.t, self.rates, axis, self.attitudes)
        collision = passage.t + later
        given = (self.body, self.noise, self.step, horizontal(axis), self.taken_out)
        before = path.part(0, passage.before - passage.start)
        after = path.part(passage.after - passage.start, passage.end - passage.start)
        return (
            leg_of(before, collision, *given),
            leg_of(after, collision, *given),
        )

    def turn(self, axis: Array, later: float = 0.0) -> float:
        """The turn from the release or the largest tilt to the next, rad, less whole turns."""
        fall, rise = self.legs(axis, later)
        begin = self._at_release(fall) if self.passage.released else heading_at_maximum(fall, 0)
        return float(np.remainder(heading_at_maximum(rise, -1) - begin, 2.0 * np.pi))

    def _at_release(self, fall: Leg) -> float:
        """The heading at the release, some samples before those of the leg."""
        yaw_rate = fall.momentum[0] / np.sin(fall.tilt[0]) ** 2
        earlier = GUARD * (self.t[1] - self.t[0])
        return float(fall.heading[0] - yaw_rate * earlier)


def heading_at_maximum(leg: Leg, end: int) -> float:
    """The heading at the largest tilt, which is near the first or the last sample of a leg."""
    part = slice(0, AT_MAXIMUM) if end == 0 else slice(-AT_MAXIMUM, None)
    t, rate, heading = leg.t[part], leg.tilt_rate[part], leg.heading[part]
    slope, value = np.polyfit(t - t[end], rate, 1)
    # Half a sample at most: beyond it, the tilt has no maximum here.
    half = 0.5 * float(np.median(np.diff(leg.t)))
    ahead = float(np.clip(-value / slope, -half, half)) if slope < 0.0 else 0.0
    turning = np.polyfit(t - t[end], heading, 1)[0]
    return float(leg.heading[end] + turning * ahead)


EXPECTED = np.radians(4.0)
"""How far a phone may be askew, rad, one standard deviation."""
MOST = np.radians(20.0)
"""How far the axis may be from where it is expected, rad."""
RINGS: tuple[tuple[int, float, float], ...] = (
    (1, 0.0, 0.0),
    (6, math.radians(9.0), 0.0),
    (6, math.radians(17.0), 0.5),
)
"""Directions at which a search may begin: how many lie on a ring about the guess, its
radius (rad), and the part of a step by which it is turned."""
TRIAL = np.radians(0.3)
"""The step of the derivatives, rad."""
ROUNDS = 8
"""Most steps of a search."""
CORRELATED = 2.0
"""What is left hangs together from sample to sample: so many samples tell as much as one."""
LEAST = 0.05
"""The least misfit."""


@dataclass(frozen=True)
class Axis:
    """A unit vector in the sensor, with errors toward two directions across it, rad.

    ``covariance`` (2, 2): of the scatter. ``shared`` (6, 2): how far it moves with one standard
    deviation of each error in :attr:`Sensed.mistaken`. ``misfit``: the root mean square of what is
    left, over the scatter that is expected at most.
    """

    direction: Array
    covariance: Array
    shared: Array
    misfit: float

    def moved(self, first: float, second: float) -> Array:
        """The direction, turned toward the two directions across it, rad."""
        return _moved(self.direction, np.array([first, second]))

    @property
    def error(self) -> float:
        """Standard deviation of its direction, rad, the larger of two."""
        whole = self.covariance + self.shared.T @ self.shared
        return float(np.sqrt(np.linalg.eigvalsh(whole)[-1]))


def fitted_axis(sensed: list[Sensed], guess: Array, start: Array | None = None) -> Axis:
    """The axis near a guess that suits all passages best (Gauss and Newton's method).

    What is left has several minima within 20 degrees, so the search begins at the best of many
    directions, or at ``start``.
    """
    direction = _start(sensed, guess) if start is None else start
    for _ in range(ROUNDS):
        left, slopes, covariance = _linear(sensed, direction)
        pull = np.stack(across(direction)) @ (direction - guess) / EXPECTED**2
        change = -covariance @ (slopes.T @ left + pull)
        size = float(np.linalg.norm(change))
        direction = _limited(_moved(direction, change * min(1.0, 0.1 / max(size, 1e-12))), guess)
        if size < 1e-4:
            break
    left, slopes, covariance = _linear(sensed, direction)
    scatter = _scatter(_left(sensed, direction))
    moved = [
        -covariance
        @ slopes.T
        @ (_left([one.mistaken[k] for one in sensed], direction) / scatter - left)
        for k in range(6)
    ]
    return Axis(direction, covariance, np.array(moved), scatter / np.sqrt(CORRELATED))


def _start(sensed: list[Sensed], guess: Array) -> Array:
    """The direction on the rings at which the least is left."""
    starts = [
        _moved(guess, radius * np.array([math.cos(angle), math.sin(angle)]))
        for count, radius, later in RINGS
        for angle in (math.tau * (k + later) / count for k in range(count))
    ]
    return min(starts, key=lambda one: float(np.mean(_left(sensed, one) ** 2)))


def _linear(sensed: list[Sensed], direction: Array) -> tuple[Array, Array, Array]:
    """What is left (n,) and its slopes (n, 2) over the scatter of both, and the covariance."""
    left = _left(sensed, direction)
    ahead = [_left(sensed, _moved(direction, step)) for step in TRIAL * np.eye(2)]
    slopes = np.stack([(one - left) / TRIAL for one in ahead], axis=-1)
    scatter = _scatter(left)
    left, slopes = left / scatter, slopes / scatter
    return left, slopes, np.linalg.inv(slopes.T @ slopes + np.eye(2) / EXPECTED**2)


def _left(sensed: list[Sensed], axis: Array) -> Array:
    """What is left of the momentum on all legs, over its noise."""
    return np.concatenate([leg.residual for one in sensed for leg in one.legs(axis)])


def _scatter(left: Array) -> float:
    """The scatter of what is left, as if samples were independent."""
    return float(np.sqrt(CORRELATED * max(float(np.mean(left**2)), LEAST**2)))


def _moved(direction: Array, shift: Array) -> Array:
    """A direction, turned toward the two directions across it, rad."""
    u, v = across(direction)
    return unit(direction + shift[0] * u + shift[1] * v)


def _limited(direction: Array, guess: Array) -> Array:
    """A direction at most 20 degrees beside a guess."""
    along = float(direction @ guess)
    beside = direction - along * guess
    length = float(np.linalg.norm(beside))
    if length <= np.tan(MOST) * along:
        return direction
    return unit(guess + np.tan(MOST) * beside / length)
