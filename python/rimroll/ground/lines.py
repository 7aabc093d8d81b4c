"""A ground as straight lines of the acceleration, and its largest values."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import NamedTuple

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


HORIZONTAL = ("vector", "rotd50", "geomean")
"""How two components become one number: see :meth:`rimroll.ground.ground.Ground.intensity`."""

DIRECTIONS = np.stack([np.cos(np.radians(range(180))), np.sin(np.radians(range(180)))], axis=-1)
"""The directions of RotD50 and RotD100 (180, 2), a degree apart (Boore 2010)."""


class Peak(NamedTuple):
    """The largest magnitude of each component, and of the horizontal vector."""

    x: float
    y: float
    z: float
    horizontal: float


def peak_of_part(core: _core.CoreGround) -> Peak | None:
    """The peak acceleration of a ground of one pulse or of a record; None for other grounds."""
    pulses, record = core.pulses(), core.samples()
    if record is not None:
        return None if pulses else peak_of(record[1])
    if len(pulses) != 1:
        return None
    [(kind, _, period, duration, center)] = pulses
    end = np.nextafter(duration, 0.0)
    if kind == "ricker" and center > end:
        return None
    # A sine is largest after a quarter of its period, if it lasts as long, a cosine at its start.
    largest = {"sine": 0.25 * period, "ricker": center}.get(kind, 0.0)
    return peak_of(core.acceleration(np.array([min(largest, end)])))


def bound_of_peak(core: _core.CoreGround) -> Peak:
    """What the peak acceleration does not exceed: the sum of the peaks of its parts."""
    record = core.samples()
    peaks = [] if record is None else [peak_of(record[1])]
    peaks += [peak_of(np.array([amplitude])) for _, amplitude, *_ in core.pulses()]
    return Peak(*map(sum, zip(*peaks, strict=True)))


def peak_of(values: NDArray[np.float64]) -> Peak:
    """The peak of vectors (n, 3)."""
    horizontal = np.hypot(values[:, 0], values[:, 1]).max()
    return Peak(*map(float, (*np.abs(values).max(axis=0), horizontal)))


def combined(largest: Callable[[Array], Array], how: str) -> float:
    """One number for the horizontal motion by one of :data:`HORIZONTAL`.

    ``largest`` gives the largest magnitudes along some directions, unit vectors (n, 2).
    """
    if how == "geomean":
        return math.sqrt(math.prod(largest(np.eye(2)).tolist()))
    every = np.concatenate([largest(one[np.newaxis]) for one in DIRECTIONS])
    return float(np.median(every) if how == "rotd50" else every.max())


def along(values: Array, directions: Array) -> Array:
    """The components of vectors (n, 2 or 3) along directions (k, 2), (k, n)."""
    components: Array = directions @ values[:, :2].T
    return components
