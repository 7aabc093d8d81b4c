"""Directions round the circle, degrees, for pictures: most bodies fall about 180, disks about 0."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

Array = NDArray[np.float64]


def away(middle: float, degrees: ArrayLike) -> Array:
    """Differences of directions from another one, −180 to 180."""
    return np.asarray(np.mod(np.asarray(degrees, np.float64) - middle + 180.0, 360.0) - 180.0)


def around(middle: float, degrees: ArrayLike) -> Array:
    """Directions as angles within half a turn of another."""
    return middle + away(middle, degrees)


def middle_of(degrees: ArrayLike) -> float:
    """180 or 0, whichever is closer to the directions on average."""
    return min((180.0, 0.0), key=lambda middle: float(np.abs(away(middle, degrees)).mean()))
