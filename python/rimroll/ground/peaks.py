"""The largest values of a motion of the ground."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from rimroll import _core

Array = NDArray[np.float64]

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
