"""The attitude of a body from the rates of its gyroscope."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


def attitudes(t: Array, rates: Array) -> Array:
    """Rotations (n, 3, 3) from the body at each time to the body at the first.

    Between two samples the rates are taken as linear, with Magnus's correction of second order.
    """
    from scipy.spatial.transform import Rotation

    steps = np.diff(t)[:, np.newaxis]
    mean = 0.5 * steps * (rates[:-1] + rates[1:])
    turned_by = mean + steps**2 / 12.0 * np.cross(rates[:-1], rates[1:])
    increments = Rotation.from_rotvec(turned_by).as_matrix()
    turned = np.empty((len(t), 3, 3))
    turned[0] = np.eye(3)
    for i, increment in enumerate(increments):
        turned[i + 1] = turned[i] @ increment
    return turned


def across(axis: Array) -> tuple[Array, Array]:
    """Two unit vectors that make a right-handed frame with a unit vector, which is the third."""
    least = int(np.argmin(np.abs(axis)))
    first = -axis[least] * axis
    first[least] += 1.0
    first = unit(first)
    return first, product(axis, first)


def product(a: Array, b: Array) -> Array:
    """The vector product of two vectors: quicker than NumPy's, which is made for many."""
    (a0, a1, a2), (b0, b1, b2) = a.tolist(), b.tolist()
    return np.array([a1 * b2 - a2 * b1, a2 * b0 - a0 * b2, a0 * b1 - a1 * b0])


def unit(vector: Array) -> Array:
    """A vector (3,) over its length."""
    return np.asarray(vector / math.sqrt(vector @ vector))
