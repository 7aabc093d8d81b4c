"""A ground as straight lines of the acceleration."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from rimroll import _core
from rimroll.errors import RimrollError

Array = NDArray[np.float64]

PER_PERIOD = 1000
"""Lines in each period of a pulse: their error is below 1e-5 of the amplitude."""

MAX_POINTS = 10_000_000
"""The largest number of samples, or of points with which a ground is followed: some 1.5 GB."""


@dataclass(frozen=True)
class Lines:
    """The acceleration at times; straight lines between them, exact for a record."""

    t: Array
    """Times (n,), s, from 0 to the end of the ground, where the last value is that before the end.
    At a jump between them there are two times that differ by rounding."""
    acceleration: Array
    """(n, 3), m/s²."""
    velocity: Array
    """(n, 3), m/s, from rest at t = 0; exact for pulses, too."""
    displacement: Array
    """(n, 3), m, since t = 0; exact for pulses, too."""
    scale: float
    """The time over which the acceleration changes, s."""


MAX_QUICK = 30_000
"""The number of points up to which a ground is followed in a few milliseconds."""


def takes_long(core: _core.CoreGround) -> bool:
    """Whether :func:`lines_of` takes more than milliseconds, or refuses the ground."""
    cycles = (
        duration / min(period or duration, duration) for _, _, period, duration, _ in core.pulses()
    )
    record = core.samples()
    points = PER_PERIOD * sum(cycles) + (len(record[1]) if record is not None else 0)
    return points > MAX_QUICK


def lines_of(core: _core.CoreGround) -> Lines:
    """The lines of a ground.

    Raises ``RimrollError`` for pulses of so many cycles that there are too many lines.
    """
    pulses, record = core.pulses(), core.samples()
    points: list[Array] = [np.zeros(1)]
    scales, ends = [], {core.duration}
    for _, _, period, duration, _ in pulses:
        step = min(period or duration, duration) / PER_PERIOD
        scales.append(50.0 * step)
        ends.add(duration)
        if not duration / step <= MAX_POINTS:
            raise RimrollError(
                f"a pulse of {duration / period:g} periods needs too many points: this is computed"
                f" for at most {MAX_POINTS // PER_PERIOD} periods"
            )
        # With a quarter of the period among them, at which a pulse is largest.
        points.append(np.arange(0.0, duration, step))
    if record is not None:
        step, samples = record
        scales.append(step)
        points.append(np.arange(len(samples), dtype=np.float64) * step)
        ends.add(points[-1][-1])
    last = np.array(sorted(ends))
    t = np.unique(np.concatenate((*points, last, np.nextafter(last, 0.0))))
    t = t[t < core.duration]
    acceleration = core.acceleration(t)
    t[-1] = core.duration
    return Lines(t, acceleration, *core.kinematics(t), min(scales))
