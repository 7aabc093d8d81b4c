"""Records from filtered noise."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from rimroll.errors import RimrollError, hold
from rimroll.given import Number, Values, numbers, positive, random_seed
from rimroll.ground.ground import Ground
from rimroll.ground.lines import MAX_POINTS
from rimroll.ground.records import sampled

Array = NDArray[np.float64]

SLOW = 0.1
"""Frequency of the high-pass filter over that of the soil."""
SLOW_DAMPING = 0.6
FADED = 0.05
"""The part of the strongest shaking that is left at the end."""


def synthetic(
    seed: int,
    amplitude: Values = 3.0,
    *,
    duration: Number = 20.0,
    step: Number = 0.01,
    soil_period: Number = 0.4,
    soil_damping: Number = 0.6,
) -> Ground:
    """A synthetic record, which resembles an earthquake and is none.

    Gaussian white noise, independent in each component, under an envelope that rises as t² in the
    first tenth of the duration, is constant for three tenths and then decays exponentially to 5 %
    (Jennings), passes the filter of Kanai and Tajimi, a layer of soil on rock, and the high-pass
    filter of Clough and Penzien, which removes drift. Each component is scaled to its peak.

    Raises ``RimrollError`` for numbers that are not positive (an amplitude may be 0), and for fewer
    than 100 samples or more than ten million.

    Parameters
    ----------
    seed
        A whole number; the same seed gives the same record, with the same version of NumPy.
    amplitude
        The peak, m/s²: a number, along x alone, or three (x, y, z).
    duration, step
        Length of the record and time between two samples, s.
    soil_period, soil_damping
        Natural period (s) and damping ratio of the soil; firm soil has 0.4 s and 0.6.

    Examples
    --------
    >>> import rimroll as rr
    >>> rr.ground.synthetic(1, amplitude=("0.3 g", "0.3 g", "0.2 g"))
    <Ground of 2001 samples at 0.01 s: 20 s, peaks 2.942, 2.942, 1.961 m/s²>
    """
    random = np.random.default_rng(random_seed(seed))
    peaks = numbers("amplitude", amplitude, "m/s^2")
    if peaks.shape not in ((), (3,)):
        raise RimrollError(f"amplitude must be one number or three (x, y, z), got {amplitude!r}")
    hold("amplitude", peaks, (peaks >= 0.0) & (peaks <= 1e9), "between 0 and 1e9", "m/s^2")
    end, interval = positive("duration", duration, "s"), positive("step", step, "s")
    count = round(end / interval) if end / interval < 1e9 else MAX_POINTS
    if not 100 <= count + 1 <= MAX_POINTS:
        raise RimrollError(
            f"duration/step must be between 100 and {MAX_POINTS}, got {end / interval:g}"
        )
    t = np.arange(count + 1) * interval
    noise = random.standard_normal((3, count + 1)) * _envelope(t / t[-1])
    soil = positive("soil_period", soil_period, "s"), positive("soil_damping", soil_damping)
    shaken = _filtered(noise, interval, *soil)
    wanted = peaks if peaks.ndim else np.array([float(peaks), 0.0, 0.0])
    scale = wanted / np.abs(shaken).max(axis=1)
    return sampled(interval, (shaken * scale[:, np.newaxis]).T)


def _envelope(part: Array) -> Array:
    """Jennings' envelope over the part of the duration that has passed."""
    decay = np.exp(math.log(FADED) * (part - 0.4) / 0.6)
    return np.where(part < 0.1, (part / 0.1) ** 2, np.where(part < 0.4, 1.0, decay))


def _filtered(noise: Array, step: float, period: float, damping: float) -> Array:
    """The response of soil to accelerations (3, n) of the rock, without what is slow."""
    count = noise.shape[1]
    padded = 2 * count  # a filter goes round, from the end to the beginning
    # Frequencies relative to that of the soil, and of the high-pass filter.
    r = np.fft.rfftfreq(padded, step) * period
    soil = (1.0 + 2j * damping * r) / (1.0 - r**2 + 2j * damping * r)
    q = r / SLOW
    high = -(q**2) / (1.0 - q**2 + 2j * SLOW_DAMPING * q)
    filtered = np.fft.irfft(np.fft.rfft(noise, padded, axis=1) * soil * high, padded, axis=1)
    return filtered[:, :count]
