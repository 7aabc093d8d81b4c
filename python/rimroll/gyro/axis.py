"""The direction of the body's symmetry axis in the sensor, found from the motion itself.

Newton's and Euler's laws leave nothing of the angular velocity about the vertical (see ``legs``) if
the axis is right. All falls together determine it, about as well as the spin and the paths allow.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from rimroll.gyro.attitude import across, unit
from rimroll.gyro.passages import Sensed

Array = NDArray[np.float64]

EXPECTED = np.radians(4.0)
"""How far a phone may be askew, rad, one standard deviation."""
MOST = np.radians(20.0)
"""How far the axis may be from where it is expected, rad."""
RINGS: tuple[tuple[int, float, float], ...] = (
    (1, 0.0, 0.0),
    (6, math.radians(9.0), 0.0),
    (6, math.radians(17.0), 0.5),
)
"""Directions at which a search may begin: how many lie on a ring about the guess, its
radius (rad), and the part of a step by which it is turned."""
TRIAL = np.radians(0.3)
"""The step of the derivatives, rad."""
ROUNDS = 8
"""Most steps of a search."""
CORRELATED = 2.0
"""What is left hangs together from sample to sample: so many samples tell as much as one."""
LEAST = 0.05
"""The least misfit."""


@dataclass(frozen=True)
class Axis:
    """A unit vector in the sensor, with errors toward two directions across it, rad.

    ``covariance`` (2, 2): of the scatter. ``shared`` (6, 2): how far it moves with one standard
    deviation of each error in :attr:`Sensed.mistaken`. ``misfit``: the root mean square of what is
    left, over the scatter that is expected at most.
    """

    direction: Array
    covariance: Array
    shared: Array
    misfit: float

    def moved(self, first: float, second: float) -> Array:
        """The direction, turned toward the two directions across it, rad."""
        return _moved(self.direction, np.array([first, second]))

    @property
    def error(self) -> float:
        """Standard deviation of its direction, rad, the larger of two."""
        whole = self.covariance + self.shared.T @ self.shared
        return float(np.sqrt(np.linalg.eigvalsh(whole)[-1]))


def fitted_axis(sensed: list[Sensed], guess: Array, start: Array | None = None) -> Axis:
    """The axis near a guess that suits all passages best (Gauss and Newton's method).

    What is left has several minima within 20 degrees, so the search begins at the best of many
    directions, or at ``start``.
    """
    direction = _start(sensed, guess) if start is None else start
    for _ in range(ROUNDS):
        left, slopes, covariance = _linear(sensed, direction)
        pull = np.stack(across(direction)) @ (direction - guess) / EXPECTED**2
        change = -covariance @ (slopes.T @ left + pull)
        size = float(np.linalg.norm(change))
        direction = _limited(_moved(direction, change * min(1.0, 0.1 / max(size, 1e-12))), guess)
        if size < 1e-4:
            break
    left, slopes, covariance = _linear(sensed, direction)
    scatter = _scatter(_left(sensed, direction))
    moved = [
        -covariance
        @ slopes.T
        @ (_left([one.mistaken[k] for one in sensed], direction) / scatter - left)
        for k in range(6)
    ]
    return Axis(direction, covariance, np.array(moved), scatter / np.sqrt(CORRELATED))


def _start(sensed: list[Sensed], guess: Array) -> Array:
    """The direction on the rings at which the least is left."""
    starts = [
        _moved(guess, radius * np.array([math.cos(angle), math.sin(angle)]))
        for count, radius, later in RINGS
        for angle in (math.tau * (k + later) / count for k in range(count))
    ]
    return min(starts, key=lambda one: float(np.mean(_left(sensed, one) ** 2)))


def _linear(sensed: list[Sensed], direction: Array) -> tuple[Array, Array, Array]:
    """What is left (n,) and its slopes (n, 2) over the scatter of both, and the covariance."""
    left = _left(sensed, direction)
    ahead = [_left(sensed, _moved(direction, step)) for step in TRIAL * np.eye(2)]
    slopes = np.stack([(one - left) / TRIAL for one in ahead], axis=-1)
    scatter = _scatter(left)
    left, slopes = left / scatter, slopes / scatter
    return left, slopes, np.linalg.inv(slopes.T @ slopes + np.eye(2) / EXPECTED**2)


def _left(sensed: list[Sensed], axis: Array) -> Array:
    """What is left of the momentum on all legs, over its noise."""
    return np.concatenate([leg.residual for one in sensed for leg in one.legs(axis)])


def _scatter(left: Array) -> float:
    """The scatter of what is left, as if samples were independent."""
    return float(np.sqrt(CORRELATED * max(float(np.mean(left**2)), LEAST**2)))


def _moved(direction: Array, shift: Array) -> Array:
    """A direction, turned toward the two directions across it, rad."""
    u, v = across(direction)
    return unit(direction + shift[0] * u + shift[1] * v)


def _limited(direction: Array, guess: Array) -> Array:
    """A direction at most 20 degrees beside a guess."""
    along = float(direction @ guess)
    beside = direction - along * guess
    length = float(np.linalg.norm(beside))
    if length <= np.tan(MOST) * along:
        return direction
    return unit(guess + np.tan(MOST) * beside / length)
