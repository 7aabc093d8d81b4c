"""What a gyroscope recorded: angular velocities at times, its rests, and what was noticed."""

from __future__ import annotations

import math
import os
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view
from numpy.typing import NDArray

from rimroll.errors import RimrollError, hold
from rimroll.files.output import writing
from rimroll.files.titles import expect_step
from rimroll.units import Values, numbers

TITLES = (
    "Time (s)",
    "Gyroscope x (rad/s)",
    "Gyroscope y (rad/s)",
    "Gyroscope z (rad/s)",
    "Absolute (rad/s)",
)

SIMULATED = "# simulated by rimroll, not measured"
"""The first line of a file that holds a simulated record."""


def write(path: str | os.PathLike[str], record: Record) -> Path:
    """Write the record as such a file, with commas and decimal points."""
    with writing(path) as part:
        part.write_text(text_of_record(record), encoding="utf-8")
    return Path(path)


def text_of_record(record: Record) -> str:
    """The file as a text; times to a microsecond, rates to six digits."""
    absolute = np.linalg.norm(record.rates, axis=1)
    lines = [",".join(f'"{title}"' for title in TITLES)]
    for t, (x, y, z), size in zip(record.t, record.rates, absolute, strict=True):
        lines.append(f"{t:.6f},{x:.6g},{y:.6g},{z:.6g},{size:.6g}")
    return "\n".join([*([SIMULATED] if record.simulated else []), *lines, ""])


Array = NDArray[np.float64]

MIN_SAMPLES = 20
"""Samples that a record must have."""


@dataclass(frozen=True, eq=False, repr=False)
class Record:
    """The record of a gyroscope.

    Raises ``RimrollError`` for fewer than 20 samples, for shapes that do not fit, and for times
    that do not increase.

    Parameters
    ----------
    t
        Times of the samples, (n,), s, increasing; not necessarily even.
    rates
        Angular velocity along the sensor's axes x, y and z, (n, 3), rad/s.
    name
        What messages and figures call it.
    source
        How the file was understood, in one line.
    notes
        What is unusual about it, a sentence each: gaps, repeated times, saturation.
    simulated
        Whether it was computed instead of measured.
    """

    t: Array
    rates: Array
    name: str = "the record"
    source: str = ""
    notes: tuple[str, ...] = ()
    simulated: bool = False

    def __post_init__(self) -> None:
        t, rates = numbers("t", self.t, "s"), numbers("rates", self.rates, "rad/s")
        if t.ndim != 1 or rates.shape != (len(t), 3):
            raise RimrollError(
                f"must have the shape (n,) and rates (n, 3), got {t.shape} and {rates.shape}", "t"
            )
        if len(t) < MIN_SAMPLES:
            raise RimrollError(
                f"{self.name} must have at least {MIN_SAMPLES} samples, it has {len(t)}"
            )
        hold("t", t, np.isfinite(t), "finite", "s")
        hold("rates", rates, np.isfinite(rates), "finite", "rad/s")
        hold("t", t, np.diff(t, prepend=-np.inf) > 0.0, "greater than the time before", "s")
        object.__setattr__(self, "t", t)
        object.__setattr__(self, "rates", rates)

    def __len__(self) -> int:
        return len(self.t)

    def __repr__(self) -> str:
        kind = "simulated record" if self.simulated else "record"
        return (
            f"<Gyroscope {kind} of {len(self)} samples in {self.t[-1] - self.t[0]:.4g} s,"
            f" {self.sampling_rate:.4g} Hz>"
        )

    @property
    def step(self) -> float:
        """The usual time from sample to sample, s: the median."""
        return float(np.median(np.diff(self.t)))

    @property
    def sampling_rate(self) -> float:
        """Samples a second: the inverse of :attr:`step`."""
        return 1.0 / self.step

    def between(self, start: Values, end: Values) -> Record:
        """The samples from ``start`` to ``end``, s.

        Raises ``RimrollError`` if they are fewer than 20.
        """
        inside = (self.t >= float(numbers("start", start, "s"))) & (
            self.t <= float(numbers("end", end, "s"))
        )
        return Record(
            self.t[inside], self.rates[inside], self.name, self.source, self.notes, self.simulated
        )

    def save(self, path: str | os.PathLike[str]) -> Path:
        """Write it as the CSV file that phyphox exports, with commas and decimal points.

        A record that was simulated says so in a comment in the first line, which
        :func:`rimroll.gyro.read` understands.
        """

        return write(path, self)


GAP = 4.0
"""A step that is longer than so many usual ones is a gap."""
UNEVEN = 0.25
"""Standard deviation of a step, over the usual one, from which on times are called uneven."""
DRIFT = 0.01
"""Change of the usual step between the first third and the last that is told."""
FLAT = 3
"""Equal largest samples in succession that show that a sensor cannot show more."""


PACKETS = 0.1
"""The part of samples that repeat a time from which on they come in packets."""


def with_even_notes(
    name: str, t: Array, rates: Array, lines: NDArray[np.int_], is_stated: bool
) -> tuple[Record, list[str]]:
    """The record without repeated samples, and what is unusual about its times and rates.

    ``lines`` are those of the samples in their file, and ``is_stated`` says whether the unit of the
    times is. Raises ``RimrollError`` for times that go back, for packets that do not come evenly,
    for steps that no gyroscope has, and for too few samples.
    """
    steps = np.diff(t)
    if (steps < 0.0).any():
        place = int((steps < 0.0).argmax()) + 1
        raise RimrollError(
            f"{name}, line {lines[place]}: the time goes back, from {t[place - 1]:g} s to"
            f" {t[place]:g} s: keep one run, or read a part without it, as in between=(12, 20) (on"
            ' the command line --between "12 s,20 s")'
        )
    notes = []
    again = np.concatenate(([False], steps == 0.0))
    if again.mean() > PACKETS and np.diff(rates, axis=0)[again[1:]].any(axis=1).mean() > PACKETS:
        t, note = _spread(name, t, again)
        notes.append(note)
    elif again.any():
        count = int(again.sum())
        notes.append(f"Samples that repeat the time of the one before were left out: {count}.")
        t, rates = t[~again], rates[~again]
    if len(t) > 1:
        expect_step(name, "record of a gyroscope", float(np.median(np.diff(t))), is_stated)
    if len(t) < MIN_SAMPLES:
        raise RimrollError(f"{name} must have at least {MIN_SAMPLES} samples, it has {len(t)}")
    record = Record(t, rates, name)
    steps = np.diff(t)
    gaps = np.flatnonzero(steps > GAP * record.step)
    if len(gaps):
        longest = gaps[np.argmax(steps[gaps])]
        notes.append(
            f"Gaps in the times: {len(gaps)}, the longest {1e3 * steps[longest]:.0f} ms at"
            f" {t[longest]:.2f} s; falls across a gap are not read."
        )
    usual = steps[steps <= GAP * record.step]
    if float(np.std(usual)) > UNEVEN * record.step:
        notes.append("The times are uneven; they are used as they are.")
    third = len(steps) // 3
    first, last = (_usual(part, record.step) for part in (steps[:third], steps[-third:]))
    if abs(last / first - 1.0) > DRIFT:
        notes.append(f"The sampling rate drifts by {100.0 * (first / last - 1.0):+.1f} %.")
    if cut := cut_off(rates):
        largest = float(np.abs(rates).max())
        notes.append(
            f"Rates are cut off at the sensor's range, {largest:.3g} rad/s"
            f" ({math.degrees(largest):.0f} degrees/s); these samples are not used: {cut}."
        )
    return record, notes


def _spread(name: str, t: Array, again: NDArray[np.bool_]) -> tuple[Array, str]:
    """Times of samples that come in packets with the time of the last one; a note on it."""
    lasts = np.flatnonzero(np.append(~again[1:], True))
    sizes = np.diff(lasts, prepend=-1)
    apart = np.diff(t[lasts])
    steps = apart / sizes[1:]
    usual = float(np.median(steps)) if len(steps) else 0.0
    many = f"{sizes.min()}" if sizes.min() == sizes.max() else f"{sizes.min()} to {sizes.max()}"
    ordinary = steps[steps <= GAP * usual]
    # The first and the last packet may be cut, so that their size says nothing.
    if not len(ordinary) or float(np.std(ordinary[:-1])) > UNEVEN * usual:
        raise RimrollError(
            f"{name}: its samples come in packets of {many} that share a time, and the packets do"
            " not come evenly, so the times of the samples are not known: record on the sensor, or"
            " with the time of each sample"
        )
    # Backward from the time of a packet, so that no sample moves across a gap.
    step = np.minimum(np.concatenate(([usual], steps)), usual * (1.0 + UNEVEN))
    step[-1] = usual
    place = np.repeat(np.arange(len(sizes)), sizes)
    spread = t - (lasts[place] - np.arange(len(t))) * step[place]
    rate = f"{1.0 / usual:.4g} Hz" if usual < 0.5 else f"a sample in {usual:g} s"
    return spread, (
        f"Samples came in packets of {many} with one time; their times were spread evenly between"
        f" the packets: {rate}."
    )


def _usual(steps: Array, step: float) -> float:
    """The mean of the steps that are no gaps, s; the usual step where all are."""
    usual = steps[steps <= GAP * step]
    return float(usual.mean()) if len(usual) else step


def cut_off(rates: Array) -> int:
    """How many samples are at the end of the sensor's range; 0 if it is not reached."""
    count = 0
    for column in rates.T:
        at_end = np.abs(column) >= (1.0 - 1e-6) * np.abs(rates).max()
        edges = np.flatnonzero(np.diff(np.concatenate(([0], at_end.astype(int), [0]))))
        lengths = edges[1::2] - edges[::2]
        count += int(lengths[lengths >= FLAT].sum())
    return count


WINDOW = 0.3
"""The shortest rest, s."""
QUIET = 0.05
"""The largest standard deviation of a rate at rest, rad/s."""
LARGEST_BIAS = 0.6
"""The largest mean rate at rest, rad/s: data sheets of cheap sensors have up to 20 degrees/s."""
UNKNOWN_BIAS = 0.0175
"""Uncertainty of a bias where nothing rests, rad/s: the 1 degree/s that data sheets give."""


@dataclass(frozen=True)
class Rests:
    """Where nothing moves, and what the sensor shows there.

    ``spans`` are start and end of each rest, s. ``bias`` (k, 3) is the mean rate in each, rad/s,
    ``noise`` the standard deviation of a sample, rad/s, ``bias_error`` that of the bias.
    """

    spans: list[tuple[float, float]]
    bias: Array
    noise: float
    bias_error: float

    def bias_at(self, t: Array) -> Array:
        """The bias at times, (n, 3): on straight lines between rests, constant beyond them."""
        if not self.spans:
            return np.zeros((len(t), 3))
        centers = [0.5 * (start + end) for start, end in self.spans]
        return np.stack([np.interp(t, centers, self.bias[:, i]) for i in range(3)], axis=-1)

    @property
    def drift(self) -> float:
        """How far the bias moves between the first rest and the last, rad/s."""
        return float(np.linalg.norm(self.bias[-1] - self.bias[0])) if self.spans else 0.0


def rests_of(record: Record) -> Rests:
    """The rests of a record: the quietest parts of it, of at least 0.3 s."""
    width = max(round(WINDOW / record.step), 8)
    if width >= len(record):
        return Rests([], np.zeros((0, 3)), _roughness(record.rates), UNKNOWN_BIAS)
    step = smallest_step(record.rates)
    windows = sliding_window_view(record.rates, width, axis=0)
    means, spreads = windows.mean(axis=-1), windows.std(axis=-1, ddof=1).max(axis=1)
    possible = (spreads < QUIET) & (np.abs(means).max(axis=1) < LARGEST_BIAS)
    if not possible.any():
        return Rests([], np.zeros((0, 3)), _roughness(record.rates), UNKNOWN_BIAS)
    quietest = np.flatnonzero(possible)[np.argmin(spreads[possible])]
    limit = max(2.0 * float(spreads[quietest]), step)
    # A slow steady motion is as quiet as a rest, but its mean is not that of the quietest part.
    near = np.abs(means - means[quietest]).max(axis=1) < max(limit, 0.01)
    inside = np.zeros(len(record), bool)
    for i in np.flatnonzero(possible & near & (spreads <= limit)):
        inside[i : i + width] = True
    edges = np.flatnonzero(np.diff(np.concatenate(([0], inside.astype(int), [0]))))
    parts = [record.rates[a:b] for a, b in zip(edges[::2], edges[1::2], strict=True)]
    spans = [
        (float(record.t[a]), float(record.t[b - 1]))
        for a, b in zip(edges[::2], edges[1::2], strict=True)
    ]
    bias = np.array([part.mean(axis=0) for part in parts])
    count = sum(len(part) for part in parts)
    left = np.concatenate([part - part.mean(axis=0) for part in parts])
    # A digital output may be constant at rest; its noise is then that of rounding.
    middle = 1.4826 * float(np.median(np.abs(left)))
    noise = max(middle, step / math.sqrt(12.0))
    return Rests(spans, bias, noise, noise / math.sqrt(min(count, 50)))


def _roughness(rates: Array) -> float:
    """Noise of a sample from third differences, which smooth motions leave small."""
    third = np.diff(rates, 3, axis=0) / np.sqrt(20.0)
    return float(np.median(np.abs(third)) / 0.6745) + smallest_step(rates) / math.sqrt(12.0)


def smallest_step(rates: Array) -> float:
    """The smallest difference between two rates that occur along one axis: the resolution."""
    steps = [np.diff(np.unique(rates[:, i])) for i in range(3)]
    return float(min((step.min() for step in steps if len(step)), default=0.0))
