"""The largest values of a motion of the ground."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray


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
