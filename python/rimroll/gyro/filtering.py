"""A sensor's low-pass filter: recognised by the jump of the rate at a collision, and taken out.

Within a few samples of a near-collision the rate is a straight line in time before it and another
one after it. A Butterworth filter of second order with the cut-off frequency f makes of the jump
from one to the other a step that approaches its end as exp(−t/τ), τ = 1/(√2 π f). Samples of it
satisfy a recursion over three of them, which undoes the filter.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from rimroll.gyro.falls import peaks_of

Array = NDArray[np.float64]

STRONG = 0.9
"""The decay time τ, in steps of the record, from which on a filter is recognised and taken out: f
is a quarter of the sampling rate. Weaker filters hardly matter."""
LONGEST = 0.05
"""The longest decay time that is looked for, s: a cut-off frequency of 4.5 Hz."""
SPAN = 0.06
"""The time on each side of a peak whose samples are fitted, s."""
DIP = 0.03
"""A filter may make two peaks of one, with a dip where the rate jumps: its longest duration, s."""
MIN_SAMPLES = 9
"""Samples that the fit of a jump must have."""
ROUGHEST = 0.03
"""The largest residual over the jump with which a fit is believed."""
MAX_PEAKS = 4
"""The largest peaks that are fitted."""
TIMING = 1e-4
"""Standard deviation of the time at which a sample is taken, s."""
MISTAKEN = 0.05
"""Standard deviation of a decay time that was found, over itself."""


@dataclass(frozen=True)
class Filter:
    """A Butterworth filter of second order: its decay time, s."""

    decay: float

    @property
    def cutoff(self) -> float:
        """The cut-off frequency, Hz."""
        return 1.0 / (math.sqrt(2.0) * math.pi * self.decay)

    def weights(self, step: float) -> Array:
        """The weights (3,) of a sample and of the two before it that undo the filter."""
        angle = step / self.decay
        weights = np.array([1.0, -2.0 * math.exp(-angle) * math.cos(angle), math.exp(-2.0 * angle)])
        return np.asarray(weights / weights.sum())

    def noise(self, resolution: float, step: float) -> float:
        """Standard deviation that rounding to a resolution has after undoing."""
        gain = float(np.linalg.norm(self.weights(step)))
        return gain * resolution / math.sqrt(12.0)

    def left(self, step: float) -> float:
        """The part of a jump that remains just after the filter is undone.

        It decays with the filter: what samples lack that are not taken at their time, and what is
        due to the error of the decay time itself.
        """
        gain = float(np.linalg.norm(self.weights(step)))
        return gain * TIMING / self.decay + MISTAKEN

    def undone(self, t: Array, rates: Array) -> tuple[Array, Array]:
        """Times (n − 2,) and rates (n − 2, 3) before the filter, except for its mean delay."""
        step = float(np.median(np.diff(t)))
        weights = self.weights(step)
        later = -step * (weights[1] + 2.0 * weights[2])
        sharp = weights[0] * rates[2:] + weights[1] * rates[1:-1] + weights[2] * rates[:-2]
        return t[2:] + later, sharp


@dataclass(frozen=True)
class _Jump:
    """The decay time of a smeared jump, s, and the residual of its fit over the jump.

    ``is_whole``: whether the samples that were fitted reach the full span on both sides.
    """

    decay: float
    residual: float
    is_whole: bool


def filter_of(t: Array, rates: Array, noise: float, least: float = STRONG) -> Filter | None:
    """The strong filter that rates (n, 3) went through; None if their jumps show none.

    ``least``: the smallest decay time of a filter that is reported, in steps of the record.

    A passage that is not near upright turns slowly and looks filtered, too, so the sharpest of the
    largest jumps decides.
    """
    step = float(np.median(np.diff(t)))
    sizes = np.linalg.norm(rates, axis=1)
    peaks, lows = peaks_of(sizes, noise, math.ceil(DIP / step))
    largest = sorted(range(len(peaks)), key=lambda k: -float(sizes[peaks[k]]))[:MAX_PEAKS]
    jumps = [_jump_at(t, rates, peaks[k], (lows[k], lows[k + 1])) for k in largest]
    good = [one for one in jumps if one is not None and one.residual < ROUGHEST]
    whole = [one for one in good if one.is_whole]
    decay = min((one.decay for one in whole or good), default=0.0)
    return Filter(decay) if decay > least * step else None


def _jump_at(t: Array, rates: Array, peak: int, lows: tuple[int, int]) -> _Jump | None:
    """The jump at a peak between two lows, fitted; None if there are too few samples."""
    from scipy.optimize import least_squares

    step = float(np.median(np.diff(t)))
    inside = np.searchsorted(t, [t[peak] - SPAN, t[peak] + SPAN])
    first, last = max(lows[0] + 3, int(inside[0])), min(lows[1] - 1, int(inside[1]))
    if last + 1 - first < MIN_SAMPLES:
        return None
    time, shown = t[first : last + 1] - t[peak], rates[first : last + 1]

    def left(numbers: Array) -> Array:
        basis, _ = np.linalg.qr(_design(time, *numbers))
        return np.asarray((shown - basis @ (basis.T @ shown)).ravel())

    bounds = ([-SPAN, math.log(0.05 * step)], [3.0 * step, math.log(LONGEST)])
    starts = [(-k * step, math.log(k * step)) for k in (0.3, 1.0, 4.0) if k * step < LONGEST]
    fits = [least_squares(left, one, bounds=bounds, x_scale=(step, 1.0)) for one in starts]
    best = min(fits, key=lambda one: float(one.cost))
    lines = np.linalg.lstsq(_design(time, *best.x), shown, rcond=None)[0]
    freedom = max(shown.size - lines.size - len(best.x), 1)
    size = max(float(np.linalg.norm(lines[2])), 1e-12)
    residual = math.sqrt(2.0 * float(best.cost) / freedom) / size
    return _Jump(math.exp(best.x[1]), residual, (first, last) == (inside[0], inside[1]))


def _design(time: Array, begun: float, log_decay: float) -> Array:
    """A straight line, and a step and a ramp that begin at a time, filtered, (n, 4)."""
    decay = math.exp(log_decay)
    since = np.maximum(time - begun, 0.0) / decay
    fading = np.exp(-since)
    cos, sin = fading * np.cos(since), fading * np.sin(since)
    return np.stack(
        [np.ones_like(time), time, 1.0 - cos - sin, decay * (since - 1.0 + cos)], axis=-1
    )
