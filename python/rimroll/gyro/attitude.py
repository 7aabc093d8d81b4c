"""Rotations, and the attitude of a body from the rates of its gyroscope."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


def crossing(vector: Array) -> Array:
    """The matrix that takes the cross product with a vector."""
    x, y, z = vector
    return np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])


def rotation(vector: Array) -> Array:
    """The rotation by a vector: about its direction, by its length, rad (Rodrigues)."""
    angle = float(np.sqrt(vector @ vector))
    matrix = crossing(vector)
    first = np.sinc(angle / np.pi)
    second = 0.5 * np.sinc(0.5 * angle / np.pi) ** 2
    turned: Array = np.eye(3) + first * matrix + second * matrix @ matrix
    return turned


def attitudes(t: Array, rates: Array) -> Array:
    """Rotations (n, 3, 3) from the body at each time to the body at the first.

    Between two samples the rates are taken as linear, with Magnus's correction of second order.
    """
    steps = np.diff(t)[:, np.newaxis]
    mean = 0.5 * steps * (rates[:-1] + rates[1:])
    increments = _rotations(mean + steps**2 / 12.0 * np.cross(rates[:-1], rates[1:]))
    turned = np.empty((len(t), 3, 3))
    turned[0] = np.eye(3)
    for i, increment in enumerate(increments):
        turned[i + 1] = turned[i] @ increment
    return turned


def _rotations(vectors: Array) -> Array:
    """The rotations (n, 3, 3) by vectors (n, 3), as :func:`rotation` makes them."""
    angles = np.linalg.norm(vectors, axis=1)[:, np.newaxis, np.newaxis]
    matrices = np.cross(vectors[:, np.newaxis, :], np.eye(3)).transpose(0, 2, 1)
    first = np.sinc(angles / np.pi)
    second = 0.5 * np.sinc(0.5 * angles / np.pi) ** 2
    turned: Array = np.eye(3) + first * matrices + second * matrices @ matrices
    return turned


def across(axis: Array) -> tuple[Array, Array]:
    """Two unit vectors that make a right-handed frame with a unit vector, which is the third."""
    helper = np.eye(3)[int(np.argmin(np.abs(axis)))]
    first = helper - (helper @ axis) * axis
    first /= np.linalg.norm(first)
    return first, np.cross(axis, first)
