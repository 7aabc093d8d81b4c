"""Where in a record the body falls, collides and rises, and the filter of a sensor.

Within a few samples of a near-collision the rate is a straight line in time before it and another
one after it. A Butterworth filter of second order with the cut-off frequency f makes of the jump
from one to the other a step that approaches its end as exp(−t/τ), τ = 1/(√2 π f). Samples of it
satisfy a recursion over three of them, which undoes the filter.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from rimroll.bodies.body import Body

Array = NDArray[np.float64]

LEAST_RATE = 0.6
"""The smallest rate across the axis at a collision that is read, rad/s."""
OF_LARGEST = 0.15
"""And its part of the largest one."""
SLOPES = (0.4, 1.8)
"""The slopes beside a peak, over the smallest and the largest that a body falling freely has."""
MIN_SAMPLES = 5
"""Samples that each side of a collision must have."""
NEAR = 0.03
"""The time on each side of a collision in which the rate is taken as a straight line, s."""
LOSS = 0.04
"""The part of the rate by which it must fall in a collision before this is taken for a loss."""
HELD = 0.15
"""The largest rate of a body that a hand holds, rad/s, apart from the noise."""
LONGER = 1.5
"""A hand holds the body if it is this slow for this many times as long as a free body is near its
largest tilt."""
MOVING = 0.2
"""The rate at the end of a record, over its last peak, from which on the body still moves there."""
GUARD = 2
"""Samples beside a collision that the filter of a sensor may smear."""


@dataclass(frozen=True)
class Passage:
    """The samples of a fall, a near-collision and the rise after it, by their indices.

    ``start``: the release or the largest tilt before; ``before`` and ``after``: the last sample
    before the collision, and the first after it, that belong to smooth motion; ``end``: the largest
    tilt after; ``t``: the time of the collision, s; ``released``: whether no collision comes before
    it.
    """

    start: int
    before: int
    after: int
    end: int
    t: float
    released: bool


@dataclass(frozen=True)
class Falls:
    """The passages of a record, and how many other peaks its rate has.

    ``cut_off``: those after which the record ends before the largest tilt; ``quick``: those with
    too few samples; ``rough``: those that are not as steep as gravity makes them.
    """

    passages: list[Passage]
    cut_off: int = 0
    quick: int = 0
    rough: int = 0

    @property
    def unread(self) -> int:
        """How many peaks are of no passage."""
        return self.cut_off + self.quick + self.rough

    def why_unread(self, sampling_rate: float) -> str:
        """Why peaks were not read, in words."""
        reasons = [
            (self.quick, f"too quick for a sampling rate of {sampling_rate:.0f} Hz"),
            (self.rough, "not as steep as gravity makes the peak of a fall"),
            (self.cut_off, "cut off by the end of the record"),
        ]
        return ", ".join(f"{count} {reason}" for count, reason in reasons if count)


def accelerations(body: Body, gravity: float) -> tuple[float, float]:
    """How fast the rate of a nearly upright body grows as it falls, rad/s²: rolling, sliding."""
    m, R, H, A = body.mass, body.radius, body.height, body.transverse_inertia
    pull = m * gravity * R
    return pull / (A + m * (R**2 + H**2)), pull / (A + m * R**2)


def peaks_of(rate: Array, noise: float, dip: int = 1) -> tuple[list[int], list[int]]:
    """The peaks of a rate (n,), rad/s, and the smallest samples before, between and after them.

    Two peaks with a dip of less than ``dip`` samples between them count as one.
    """
    from scipy.ndimage import grey_closing

    filled = grey_closing(rate, dip) if dip > 1 else rate
    peaks = _peaks(filled, max(LEAST_RATE, OF_LARGEST * float(rate.max()), 20.0 * noise))
    return peaks, _lows(filled, peaks)


def falls_of(
    t: Array, rate: Array, noise: float, body: Body, gravity: float, valid: NDArray[np.bool_]
) -> Falls:
    """The falls in the rate across the axis, (n,), rad/s.

    At a near-collision this rate has a peak with straight sides, as steep as gravity makes them; a
    hand makes smooth ones. ``valid``: the samples that are not cut off at the sensor's range.
    """
    slow, fast = sorted(accelerations(body, gravity))
    near = max(int(NEAR / float(np.median(np.diff(t)))), MIN_SAMPLES)
    peaks, lows = peaks_of(rate, noise)
    passages: list[Passage] = []
    cut_off = quick = rough = 0
    for k, peak in enumerate(peaks):
        start, end = lows[k], lows[k + 1]
        before, after = _sides(valid, peak)
        is_whole = end < len(rate) - GUARD  # else the record ends before the largest tilt
        if not is_whole:
            cut_off += 1
            continue
        if before - start < MIN_SAMPLES or end - after < MIN_SAMPLES:
            quick += 1
            continue
        rise = _line(t, rate, max(start + 1, before - near), before)
        fall = _line(t, rate, after, min(end - 1, after + near))
        low, high = SLOPES[0] * slow, SLOPES[1] * fast
        if not (low < rise[0] < high and low < -fall[0] < high):
            ends_moving = k == len(peaks) - 1 and rate[-1] > MOVING * rate[peak]
            cut_off, rough = cut_off + ends_moving, rough + (not ends_moving)
            continue
        moment = _collision(t, rate, (before, peak, after), rise, fall)
        # A peak before it that was not read may be a near-collision, or a hand's.
        follows = bool(passages) and passages[-1].end == start
        held = k == 0 or (not follows and _is_held(t, rate, start, slow, noise))
        if held:
            start = _release(t, rate, start, before, high, noise)
            if before - start < MIN_SAMPLES:
                quick += 1
                continue
        passages.append(Passage(start, before, after, end, moment, held))
    return Falls(passages, cut_off, quick, rough)


def _peaks(rate: Array, least: float) -> list[int]:
    """The largest sample between two times at which the rate is below half of its neighbours'."""
    peaks: list[int] = []
    low, high, at = np.inf, 0.0, 0
    rising = True
    for i, value in enumerate(rate):
        if rising:
            if value > high:
                high, at = value, i
            elif value < 0.6 * high and high > least:
                peaks.append(at)
                rising, low = False, value
        elif value < low:
            low = value
        elif value > low + max(0.25 * high, 0.5 * least):
            rising, high, at = True, value, i
    return peaks


def _lows(rate: Array, peaks: list[int]) -> list[int]:
    """The smallest sample before the first peak, between peaks, and after the last."""
    lows = []
    for first, last in pairwise([0, *peaks, len(rate) - 1]):
        if first == 0:  # the last time at which it was as slow as ever before
            part = rate[: last + 1][::-1]
            lows.append(last - int(np.argmin(part)))
        else:
            lows.append(first + int(np.argmin(rate[first : last + 1])))
    return lows


def _sides(valid: NDArray[np.bool_], peak: int) -> tuple[int, int]:
    """The samples beside a peak beyond what a filter smears, and a range cuts off."""
    near = 3 * GUARD
    before, after = peak, peak
    while before > 0 and not valid[max(before - near, 0) : before + 1].all():
        before -= 1
    while after < len(valid) - 1 and not valid[after : after + near + 1].all():
        after += 1
    return max(before - GUARD, 0), min(after + GUARD, len(valid) - 1)


def _line(t: Array, rate: Array, first: int, last: int) -> tuple[float, float]:
    """Slope and value at t = 0 of the straight line through samples, both included."""
    part = slice(first, last + 1)
    slope, value = np.polyfit(t[part] - t[first], rate[part], 1)
    return float(slope), float(value - slope * t[first])


def _collision(
    t: Array,
    rate: Array,
    samples: tuple[int, int, int],
    rise: tuple[float, float],
    fall: tuple[float, float],
) -> float:
    """The time of a collision between two samples, from straight lines before and after it.

    The lines meet there, unless energy is lost. Then the rate jumps from one line to the other,
    and its integral, which a filter keeps, says when.
    """
    before, peak, after = samples
    half = 0.5 * (t[after] - t[before]) / max(after - before, 1)
    earliest, latest = t[peak] - half, t[peak] + half
    met = (fall[1] - rise[1]) / (rise[0] - fall[0])
    jump = rise[1] - fall[1] + (rise[0] - fall[0]) * t[peak]
    if jump < LOSS * rate[peak]:
        return float(np.clip(met, earliest - half, latest + half))
    part = slice(before, after + 1)
    total = float(np.trapezoid(rate[part], t[part]))
    trial = np.linspace(earliest, latest, 41)

    def area(line: tuple[float, float], start: Array, end: Array) -> Array:
        return np.asarray((end - start) * (line[1] + 0.5 * line[0] * (start + end)))

    found = area(rise, t[[before]], trial) + area(fall, trial, t[[after]])
    return float(trial[np.argmin(np.abs(found - total))])


def _is_held(t: Array, rate: Array, low: int, slow: float, noise: float) -> bool:
    """Whether the body rests at a low, longer than a largest tilt lasts."""
    first, last = low, low
    still = HELD + 6.0 * noise
    while first > 0 and rate[first - 1] < still:
        first -= 1
    while last < len(rate) - 1 and rate[last + 1] < still:
        last += 1
    return bool(t[last] - t[first] > LONGER * 2.0 * still / slow)


def _release(t: Array, rate: Array, low: int, before: int, steepest: float, noise: float) -> int:
    """Where a first fall begins: back from the collision to the hand's push, or to rest."""
    width = max(int(0.015 / float(np.median(np.diff(t)))), 2)
    i = before
    while i - width >= low:
        span = float(t[i] - t[i - width])
        slope, error = (rate[i] - rate[i - width]) / span, 4.5 * noise / span
        if slope > steepest + error or (slope < error and rate[i] < 6.0 * noise):
            break
        i -= 1
    return min(i + GUARD + 1, before)  # the samples there may hold a part of the push


STRONG = 0.9
"""The decay time τ, in steps of the record, from which on a filter is recognised and taken out: f
is a quarter of the sampling rate. Weaker filters hardly matter."""
LONGEST = 0.05
"""The longest decay time that is looked for, s: a cut-off frequency of 4.5 Hz."""
SPAN = 0.06
"""The time on each side of a peak whose samples are fitted, s."""
DIP = 0.03
"""A filter may make two peaks of one, with a dip where the rate jumps: its longest duration, s."""
MIN_AROUND = 9
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
    if last + 1 - first < MIN_AROUND:
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
