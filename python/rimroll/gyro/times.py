"""The times of a record: repeated, uneven, with gaps; and rates that are cut off."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from rimroll.errors import RimrollError
from rimroll.gyro.record import MIN_SAMPLES, Record
from rimroll.titles import expect_step

Array = NDArray[np.float64]

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
