"""The largest values of a motion of the ground."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

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
