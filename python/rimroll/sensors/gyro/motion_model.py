"""The rates that a sensor shows of motions under a law, beside those of a record."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from rimroll.bodies.body import Body
from rimroll.errors import RimrollError
from rimroll.laws import Law
from rimroll.motion import Moments, Motion, simulate
from rimroll.motion.jacobian import PARAMETERS, QUANTITIES
from rimroll.sensors.fits import (
    BODY,
    MOST_STEPS,
    RTOL,
    START,
    UNREACHED,
    Minimum,
    highest_friction,
    inflation,
    with_numbers,
)
from rimroll.state import State

Array = NDArray[np.float64]

SENSOR = (
    "axis_first",
    "axis_second",
    "bias_x",
    "bias_y",
    "bias_z",
    "scale_x",
    "scale_y",
    "scale_z",
)
"""Turn of the sensor about two directions across the axis (rad), bias (rad/s), sensitivity."""

_ROW = {name: row for row, name in enumerate(QUANTITIES)}


def body_rates(moments: Moments) -> Array:
    """Angular velocity along the axes of the body, (n, 3), rad/s."""
    return np.asarray(moments.body_angular_velocity)


def derivatives(moments: Moments, of_state: Array) -> Array:
    """Derivatives of the body rates, (n, 3, k), from those of the state, (n, 6, k).

    With w = ψ̇ sin φ the rates are w cos θ − φ̇ sin θ, −w sin θ − φ̇ cos θ and θ̇ + ψ̇ cos φ.
    """
    tilt, yaw_rate = moments.tilt[:, np.newaxis], moments.yaw_rate[:, np.newaxis]
    spin, falling = moments.spin[:, np.newaxis], moments.tilt_rate[:, np.newaxis]
    sin, cos = np.sin(tilt), np.cos(tilt)

    def by(name: str) -> Array:
        return np.asarray(of_state[:, _ROW[name], :])

    w = yaw_rate * sin
    of_w = by("yaw_rate") * sin + yaw_rate * cos * by("tilt")
    of_falling, of_spin = by("tilt_rate"), by("spin")
    x, y = w * np.cos(spin) - falling * np.sin(spin), -w * np.sin(spin) - falling * np.cos(spin)
    return np.stack(
        [
            of_w * np.cos(spin) - of_falling * np.sin(spin) + y * of_spin,
            -of_w * np.sin(spin) - of_falling * np.cos(spin) - x * of_spin,
            by("spin_rate") + by("yaw_rate") * cos - yaw_rate * sin * by("tilt"),
        ],
        axis=1,
    )


@dataclass(frozen=True)
class Sensing:
    """A sensor in the body: ``frame`` (3, 3) has the body's axes, as they are expected, as columns.

    The turned frame is frame · (1 + [a]×) to first order, made orthogonal; then come sensitivity
    and bias along each axis of the sensor.
    """

    frame: Array

    def turned(self, sensor: Array) -> Array:
        """The body's axes in the sensor for the numbers of :data:`SENSOR`."""
        from scipy.spatial.transform import Rotation

        turn = Rotation.from_rotvec([sensor[0], sensor[1], 0.0]).as_matrix()
        return np.asarray(self.frame @ turn)

    def shown(self, rates: Array, sensor: Array) -> Array:
        """The rates that the sensor shows, (n, 3), of rates in the body."""
        return np.asarray((rates @ self.turned(sensor).T) * (1.0 + sensor[5:8]) + sensor[2:5])

    def unturned(self, shown: Array) -> Array:
        """Rates along the axes of the body as they are expected, of rates along the sensor's."""
        return np.asarray(shown @ self.frame)

    def carried(self, of_rates: Array, sensor: Array) -> Array:
        """Derivatives (n, 3, k) of what is shown from those of the rates in the body."""
        turned = (1.0 + sensor[5:8])[:, np.newaxis] * self.turned(sensor)
        return np.asarray(np.einsum("ij,njk->nik", turned, of_rates))

    def by_sensor(self, rates: Array, sensor: Array) -> Array:
        """Derivatives (n, 3, 8) of what is shown by the numbers of :data:`SENSOR`."""
        count = len(rates)
        out = np.zeros((count, 3, len(SENSOR)))
        step = 1e-6
        for column in range(2):
            moved = np.array(sensor)
            moved[column] += step
            ahead = self.shown(rates, moved)
            moved[column] -= 2.0 * step
            out[:, :, column] = (ahead - self.shown(rates, moved)) / (2.0 * step)
        plain = rates @ self.turned(sensor).T
        for i in range(3):
            out[:, i, 2 + i] = 1.0
            out[:, i, 5 + i] = plain[:, i]
        return out


RELEASE = (*START, "azimuth", "delay")
"""The numbers of a release: its start, the azimuth of the sensor's axes, and its delay, s."""
SHIFT = 2e-5
"""Time over which the motion is differenced by the delay, s."""
SMALL = 2e-4
"""Step by which a number of the law is differenced, of its size."""
OF_FRICTION, OF_RESISTANCE = 0.05, 1e-3
"""The sizes at which such numbers are taken as small."""
FARTHEST = 8.0
"""How far from what is expected a search may go, in standard deviations."""
END = 1e-9
"""A sample at most so long after the end of a motion belongs to it, s."""

SHARED = (*SENSOR, *(f"{name}_deviation" for name in BODY))
"""The numbers that all releases share, besides those of the law."""

_OF_START = [PARAMETERS.index(name) for name in START]
_OF_BODY = [PARAMETERS.index(name) for name in BODY]


@dataclass(frozen=True)
class Window:
    """The samples after one release that are fitted: ``rates`` (n, 3) less the bias at rest.

    ``release``: the time at which the motion begins, as far as it is known, s; ``scatter`` (n, 1):
    the standard deviation of a rate, rad/s.
    """

    release: float
    t: Array
    rates: Array
    scatter: Array


@dataclass(frozen=True)
class Prior:
    """Expected values and standard deviations of the shared numbers, and that of the delay."""

    shared: Array
    shared_error: Array
    delay_error: float


@dataclass(frozen=True)
class Model:
    """Motions of a body after releases, seen by one sensor.

    Its vector of numbers holds the ``free`` numbers of the law, those of the sensor and the body
    (:data:`SHARED`), and those of each release (:data:`RELEASE`).
    """

    body: Body
    law: Law
    free: tuple[str, ...]
    gravity: float
    sensing: Sensing
    windows: Sequence[Window]
    prior: Prior

    @property
    def names(self) -> list[str]:
        """The names of the numbers; those of release k end in ``_k`` if there are several."""
        several = len(self.windows) > 1
        ends = [f"_{k}" if several else "" for k in range(1, len(self.windows) + 1)]
        return [*self.free, *SHARED, *(f"{name}{end}" for end in ends for name in RELEASE)]

    @property
    def count(self) -> int:
        """How many rates are fitted."""
        return 3 * sum(len(window.t) for window in self.windows)

    def numbers_of_law(self, vector: Array) -> Array:
        """The free numbers of the law."""
        return np.asarray(vector[: len(self.free)])

    def numbers_of_law_given(self) -> Array:
        """The free numbers as the law has them."""
        numbers = self.law.numbers
        return np.array([float(numbers[name]) for name in self.free])  # type: ignore[arg-type]

    def numbers_of_sensor(self, vector: Array) -> Array:
        """The numbers of the sensor."""
        return vector[len(self.free) :][: len(SENSOR)]

    def shared(self, vector: Array) -> Array:
        """The numbers of the sensor and of the body."""
        return vector[len(self.free) :][: len(SHARED)]

    def body_at(self, vector: Array) -> Body:
        """The body with the deviations of a vector; ``RimrollError`` if there is none such."""
        deviations = self.shared(vector)[len(SENSOR) :]
        changed = {
            name: float(getattr(self.body, name) * (1.0 + deviation))
            for name, deviation in zip(BODY, deviations, strict=True)
            if deviation != 0.0
        }
        return replace(self.body, **changed)

    def place(self, window: int) -> slice:
        """Where the numbers of a release are."""
        first = len(self.free) + len(SHARED) + window * len(RELEASE)
        return slice(first, first + len(RELEASE))

    def law_at(self, vector: Array) -> Law:
        """The law with the numbers of a vector."""
        numbers = self.numbers_of_law(vector)
        return with_numbers(self.law, dict(zip(self.free, map(float, numbers), strict=True)))

    def motion(self, vector: Array, window: int, law: Law, jacobian: bool = False) -> Motion:
        """The motion after a release; ``RimrollError`` where the start is impossible."""
        numbers = vector[self.place(window)]
        start = State(**dict(zip(START, map(float, numbers), strict=False)), spin=float(numbers[4]))
        part = self.windows[window]
        duration = max(float(part.t[-1]) - part.release - min(numbers[5], 0.0) + 1e-3, 1e-2)
        return simulate(
            self.body_at(vector), start, law, duration, gravity=self.gravity, rtol=RTOL,
            max_steps=MOST_STEPS, jacobian=jacobian,
        )  # fmt: skip

    def _since(self, vector: Array, window: int) -> Array:
        """Times of the samples since the release, s; 0 before it."""
        part = self.windows[window]
        since = part.t - part.release - vector[self.place(window)][5]
        return np.asarray(np.maximum(since, 0.0))

    def shown(self, vector: Array, window: int, law: Law | None = None) -> Array:
        """The rates that the sensor would show, (n, 3), rad/s.

        After the end of the motion they are those of rest if the body has come to rest, and
        otherwise NaN.
        """
        motion = self.motion(vector, window, law or self.law_at(vector))
        rates = _rates(motion, self._since(vector, window))
        return self.sensing.shown(rates, self.numbers_of_sensor(vector))

    def residuals(self, vector: Array) -> Array:
        """What is left of the rates over their scatter, and of the priors over theirs."""
        law = self.law_at(vector)
        parts = []
        for k, part in enumerate(self.windows):
            try:
                left = (self.shown(vector, k, law) - part.rates) / part.scatter
            except RimrollError:
                left = np.full(part.rates.shape, UNREACHED)
            parts.append(np.nan_to_num(left, nan=UNREACHED).ravel())
        return np.concatenate([*parts, *self._of_prior(vector)])

    def _of_prior(self, vector: Array) -> list[Array]:
        shared = (self.shared(vector) - self.prior.shared) / self.prior.shared_error
        delays = [vector[self.place(k)][5:] for k in range(len(self.windows))]
        return [shared, np.concatenate(delays) / self.prior.delay_error]

    def jacobian(self, vector: Array) -> Array:
        """Derivatives of :meth:`residuals`: exact ones by the start, differences by the law."""
        law = self.law_at(vector)
        sensor = self.numbers_of_sensor(vector)
        first = len(self.free)
        rows = []
        for k, part in enumerate(self.windows):
            block = np.zeros((*part.rates.shape, len(vector)))
            try:
                place = self.place(k)
                by_release, by_body = self._by_motion(vector, k, law, sensor)
                block[:, :, place] = by_release
                block[:, :, first + len(SENSOR) : first + len(SHARED)] = by_body
                motion = self.motion(vector, k, law)
                rates = _rates(motion, self._since(vector, k))
                block[:, :, first : first + len(SENSOR)] = self.sensing.by_sensor(rates, sensor)
                for i in range(first):
                    block[:, :, i] = self._by_law(vector, k, i)
                block[np.isnan(rates).any(axis=1)] = 0.0
            except RimrollError:
                pass  # no derivative where there is no motion
            block = np.nan_to_num(block, posinf=0.0, neginf=0.0) / part.scatter[:, :, np.newaxis]
            rows.append(block.reshape(-1, len(vector)))
        prior = np.zeros((len(SHARED) + len(self.windows), len(vector)))
        for i, error in enumerate(self.prior.shared_error):
            prior[i, first + i] = 1.0 / error
        for k in range(len(self.windows)):
            prior[len(SHARED) + k, self.place(k).stop - 1] = 1.0 / self.prior.delay_error
        return np.concatenate([*rows, prior])

    def _by_motion(self, vector: Array, k: int, law: Law, sensor: Array) -> tuple[Array, Array]:
        """Derivatives (n, 3, 6) by the numbers of a release, and (n, 3, 4) by those of the body."""
        motion = self.motion(vector, k, law, jacobian=True)
        end = float(motion.t[-1])
        unclipped = self._since(vector, k)
        since = np.minimum(unclipped, end)
        moments = motion.evaluate(since)
        of_state = motion.jacobian(since).values
        sizes = np.array([getattr(self.body, name) for name in BODY])
        of_body = derivatives(moments, of_state[:, :, _OF_BODY] * sizes)
        later = body_rates(motion.evaluate(np.clip(since + SHIFT, 0.0, end)))
        sooner = body_rates(motion.evaluate(np.clip(since - SHIFT, 0.0, end)))
        rates = body_rates(moments)
        by_azimuth = np.stack([rates[:, 1], -rates[:, 0], np.zeros(len(rates))], axis=-1)
        extra = np.stack([by_azimuth, (sooner - later) / (2.0 * SHIFT)], axis=-1)
        of_start = derivatives(moments, of_state[:, :, _OF_START])
        of_release = np.concatenate([of_start, extra], axis=-1)
        ended = unclipped > end + END
        of_release[ended], of_body[ended] = 0.0, 0.0
        carried = self.sensing.carried
        return carried(of_release, sensor), carried(of_body, sensor)

    def _by_law(self, vector: Array, k: int, i: int) -> Array:
        least = OF_FRICTION if self.free[i] in ("friction", "static") else OF_RESISTANCE
        step = SMALL * max(abs(float(vector[i])), least)
        ahead, behind = vector.copy(), vector.copy()
        ahead[i] += step
        behind[i] = max(behind[i] - step, 0.0)
        apart = self.shown(ahead, k) - self.shown(behind, k)
        return np.asarray(apart / (ahead[i] - behind[i]))

    def bounds(self) -> tuple[Array, Array]:
        """The lowest and the highest numbers that are tried."""
        low = np.full(len(self.names), -np.inf)
        high = np.full(len(self.names), np.inf)
        free = len(self.free)
        low[:free] = 0.0
        if "friction" in self.free:
            high[self.free.index("friction")] = highest_friction(self.body)
        prior = self.prior
        shared = slice(free, self.place(0).start)
        low[shared] = prior.shared - FARTHEST * prior.shared_error
        high[shared] = prior.shared + FARTHEST * prior.shared_error
        for k in range(len(self.windows)):
            place = self.place(k)
            low[place.start], high[place.start] = 0.01, 1.55
            high[place.stop - 1] = FARTHEST * prior.delay_error
            low[place.stop - 1] = -high[place.stop - 1]
        return low, high


def _rates(motion: Motion, since: Array) -> Array:
    """Rates in the body, (n, 3), rad/s; after the end of the motion 0 at rest, and else NaN."""
    end = float(motion.t[-1])
    rates = body_rates(motion.evaluate(np.minimum(since, end)))
    later = 0.0 if motion.status == "at_rest" else np.nan
    return np.where((since > end + END)[:, np.newaxis], later, rates)


def part_left(one: Minimum[Model]) -> float:
    """Residual over rate: root mean squares; NaN if a motion ends before its samples do."""
    residuals, _ = residuals_of(one)
    rates = np.concatenate([window.rates for window in one.model.windows])
    return math.sqrt(float(np.mean(residuals**2) / np.mean(rates**2)))


def residuals_of(one: Minimum[Model]) -> tuple[Array, Array]:
    """What is left of the rates, rad/s (NaN after the end of a motion), and the scatter."""
    windows = one.model.windows
    shown = [one.model.shown(one.vector, k) for k in range(len(windows))]
    left = np.concatenate([w.rates - s for w, s in zip(windows, shown, strict=True)])
    return left, np.concatenate([window.scatter for window in windows])


def normal_residual(one: Minimum[Model]) -> float:
    """Root mean square of the residuals over their scatter."""
    residuals, scatter = residuals_of(one)
    return math.sqrt(float(np.mean((residuals / scatter) ** 2)))


def inflation_of(one: Minimum[Model]) -> float:
    """The factor by which variances are larger than the scatter alone says.

    The mean square of the normalised residuals, if it is above 1, times the number of samples that
    hang together: 1 + 2 Σ of their autocorrelations, up to the first that is not positive.
    """
    residuals, scatter = residuals_of(one)
    return inflation(residuals / scatter, len(one.vector))
