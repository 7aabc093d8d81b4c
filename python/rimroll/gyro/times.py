"""The times of a record: repeated, uneven, with gaps; and rates that are cut off."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from rimroll.errors import RimrollError
from rimroll.gyro.record import MIN_SAMPLES, Record

Array = NDArray[np.float64]

GAP = 4.0
"""A step that is longer than so many usual ones is a gap."""
UNEVEN = 0.25
"""Standard deviation of a step, over the usual one, from which on times are called uneven."""
DRIFT = 0.01
"""Change of the usual step between the first third and the last that is told."""
FLAT = 3
"""Equal largest samples in succession that show that a sensor cannot show more."""


def with_even_notes(
    name: str, t: Array, rates: Array, lines: list[int]
) -> tuple[Record, list[str]]:
    """The record without repeated samples, and what is unusual about its times and rates.

    Raises ``RimrollError`` for times that go back, for too few samples, and for a constant record.
    """
    steps = np.diff(t)
    if (steps < 0.0).any():
        place = int((steps < 0.0).argmax()) + 1
        raise RimrollError(
            f"{name}, line {lines[place]}: the time goes back, from {t[place - 1]:g} s to"
            f" {t[place]:g} s: keep one run"
        )
    notes = []
    again = np.concatenate(([False], steps == 0.0))
    if again.any():
        count = int(again.sum())
        notes.append(f"Samples that repeat the time of the one before were left out: {count}.")
        t, rates = t[~again], rates[~again]
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
