"""A simulated gyroscope: what a sensor in the body would record of a computed motion."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from rimroll.errors import RimrollError, expect
from rimroll.sensors.gyro.record import Record
from rimroll.units import Number, number, positive, random_seed

if TYPE_CHECKING:
    from rimroll.motion import Motion


Array = NDArray[np.float64]

DEGREE = np.pi / 180.0
OVERSAMPLING = 16
"""Instants at which the filter is evaluated for each sample."""


MOST_SAMPLES = 1_000_000
"""Samples of a simulated record: 83 minutes at 200 a second."""
_UNIT_OF = {
    "bias": "rad/s",
    "resolution": "rad/s",
    "range": "rad/s",
    "jitter": "s",
    "misalignment": "rad",
}


@dataclass(frozen=True, kw_only=True)
class Sensor:
    """A gyroscope with the errors of real ones.

    Plain numbers are in SI units and radians: rad/s, Hz, s; a text has a unit, as ``"0.1 ms"``. A
    rate in Hz and a density have no unit of their own here: give plain numbers.

    Parameters
    ----------
    sampling_rate
        Samples a second, Hz.
    noise_density
        White noise, rad/s/√Hz. A sample has the standard deviation
        ``noise_density × sqrt(bandwidth)``.
    bias
        Standard deviation of the zero-rate level along each axis, rad/s; each record draws one.
    resolution
        The step of the digital output, rad/s; 0 for none.
    range
        The largest rate along an axis, rad/s; larger ones are cut off.
    bandwidth
        Cut-off frequency of the low-pass filter, Hz, of second order (Butterworth); half the
        sampling rate unless given.
    jitter
        Standard deviation of the time at which a sample is taken about the time that is recorded,
        s.
    scale_error
        Standard deviation of the error of the sensitivity along each axis, a ratio.
    misalignment
        Standard deviation of the angles, about both axes across, between the sensor's z axis and
        the body's, rad.
    """

    sampling_rate: float = 200.0
    noise_density: float = 0.0
    bias: float = 0.0
    resolution: float = 0.0
    range: float = np.inf
    bandwidth: float | None = None
    jitter: float = 0.0
    scale_error: float = 0.0
    misalignment: float = 0.0

    def __post_init__(self) -> None:
        for field, given in list(vars(self).items()):
            if given is None and field == "bandwidth":
                continue
            unit = _UNIT_OF.get(field, "1")
            if field in ("sampling_rate", "bandwidth"):
                value = positive(field, given, unit)
            else:
                value = number(field, given, unit)
                least = value > 0.0 if field == "range" else 0.0 <= value < np.inf
                if not least:
                    what = "> 0" if field == "range" else ">= 0 and finite"
                    raise RimrollError(field=field, value=value, bound=f"{what}")
            object.__setattr__(self, field, value)
        if not self.sampling_rate < 1e5:
            raise RimrollError(
                field="sampling_rate", value=self.sampling_rate, bound="below 100000 Hz"
            )

    def record(
        self,
        motion: Motion,
        *,
        rest: Number = 1.0,
        held: Number = 0.5,
        seed: int = 0,
        name: str = "a simulated record",
    ) -> Record:
        """What the sensor would record of a motion: a simulation, not a measurement.

        The body stands for ``rest`` seconds, is tipped by a smooth motion of the hand that takes
        0.6 s, is held at the tilt of the start for ``held`` seconds, and is released: then the
        motion runs to its end, and so does the record. The same seed draws the same errors. The
        mean delay of the filter is taken off the times.

        Raises ``RimrollError`` for times that are negative or not finite, and for a record of more
        than a million samples.
        """
        from scipy.spatial.transform import Rotation

        from rimroll.motion import Motion

        expect("motion", motion, Motion)
        generator = np.random.default_rng(random_seed(seed))
        standing, holding = _duration("rest", rest), _duration("held", held)
        before = standing + TIPPING + holding
        samples = (before + float(motion.t[-1])) * self.sampling_rate
        if samples > MOST_SAMPLES:
            raise RimrollError(
                f"a record may have {MOST_SAMPLES} samples, this one would have {samples:.3g}"
            )
        count = int(samples)
        t = np.arange(count) / self.sampling_rate
        taken = t + self.jitter * generator.standard_normal(count)
        seen = self._filtered(lambda at: _hand_and_motion(motion, at, standing, holding), taken)
        askew = np.array([*(self.misalignment * generator.standard_normal(2)), 0.0])
        about = np.array([0.0, 0.0, 2.0 * np.pi * generator.random()])
        turned = (Rotation.from_rotvec(askew) * Rotation.from_rotvec(about)).as_matrix()
        shown = seen @ turned.T * (1.0 + self.scale_error * generator.standard_normal(3))
        shown += self.bias * generator.standard_normal(3)
        shown += self.noise * generator.standard_normal(shown.shape)
        if self.resolution > 0.0:
            shown = self.resolution * np.round(shown / self.resolution)
        shown = np.clip(shown, -self.range, self.range)
        return Record(t, shown, name, "simulated", simulated=True)

    @property
    def cutoff(self) -> float:
        """The cut-off frequency of the filter, Hz."""
        return 0.5 * self.sampling_rate if self.bandwidth is None else self.bandwidth

    @property
    def noise(self) -> float:
        """Standard deviation of the noise of a sample, rad/s."""
        return float(self.noise_density * np.sqrt(self.cutoff))

    def _filtered(self, rates: object, taken: Array) -> Array:
        """The rates through the low-pass filter, less its mean delay, at the times given."""
        frequency = 2.0 * np.pi * self.cutoff
        # Impulse response of the Butterworth filter of second order; its mean delay is √2/ω.
        lags = (np.arange(int(OVERSAMPLING * 8)) + 0.5) / (OVERSAMPLING * self.cutoff)
        slow = frequency / np.sqrt(2.0)
        weights = np.exp(-slow * lags) * np.sin(slow * lags)
        weights /= weights.sum()
        delay = float(weights @ lags)
        total = np.zeros((len(taken), 3))
        for lag, weight in zip(lags, weights, strict=True):
            total += weight * rates(taken - lag + delay)  # type: ignore[operator]
        return total


def _duration(field: str, value: Number) -> float:
    """A time in s, ``RimrollError`` unless it is at least 0 and finite."""
    read = number(field, value, "s")
    if not 0.0 <= read < np.inf:
        raise RimrollError(field=field, value=read, bound=">= 0 and finite", unit="s")
    return read


TIPPING = 0.6
"""How long the hand takes to tip the body, s."""


def _hand_and_motion(motion: Motion, t: Array, rest: float, held: float) -> Array:
    """Angular velocity in the body: at rest, tipped by the hand, held, and then the motion's."""
    rates = np.zeros((len(t), 3))
    part = (t - rest) / TIPPING
    tipped = (part > 0.0) & (part < 1.0)
    # A tilt that rises like x − sin(2πx)/2π begins and ends without velocity and acceleration.
    speed = motion.start.tilt / TIPPING * (1.0 - np.cos(2.0 * np.pi * part[tipped]))
    across = -1j * speed * np.exp(-1j * motion.start.spin)
    rates[tipped, 0], rates[tipped, 1] = across.real, across.imag
    since = t - rest - TIPPING - held
    moving = (since >= 0.0) & (since <= motion.t[-1])
    if moving.any():
        rates[moving] = motion.evaluate(since[moving]).body_angular_velocity
    return rates


def phone(sampling_rate: float = 200.0, *, range: float = 2000.0 * DEGREE) -> Sensor:
    """A sensor as in telephones.

    Noise density and zero-rate level are those of the data sheet of the STMicroelectronics LSM6DSO
    (DS12140, table "Mechanical characteristics"): 3.8 mdps/√Hz and ±1 dps, both typical; so is the
    sensitivity, 70 mdps a digit in a range of 2000 dps and in proportion below. The other numbers
    are assumptions: samples taken 0.1 ms from their time, sensitivities 1 % wrong, and a phone
    put into the can 1° askew.
    """
    return Sensor(
        sampling_rate=sampling_rate,
        noise_density=3.8e-3 * DEGREE,
        bias=1.0 * DEGREE,
        resolution=70e-3 * DEGREE * range / (2000.0 * DEGREE),
        range=range,
        jitter=1e-4,
        scale_error=0.01,
        misalignment=1.0 * DEGREE,
    )
