"""The direction of the body's symmetry axis in the sensor, found from the motion itself.

Newton's and Euler's laws leave nothing of the angular velocity about the vertical (see ``legs``) if
the axis is right. All falls together determine it, about as well as the spin and the paths allow.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from rimroll.gyro.attitude import across
from rimroll.gyro.passages import Sensed

Array = NDArray[np.float64]

EXPECTED = np.radians(3.0)
"""How far a phone that was put in with care may be askew, rad, one standard deviation."""
MOST = np.radians(20.0)
"""How far the axis may be from where it is expected, rad."""
TRIAL = np.radians(0.3)
"""The step of the derivatives, rad."""


@dataclass(frozen=True)
class Axis:
    """A unit vector in the sensor, with standard deviations toward two directions across, rad.

    ``misfit``: the root mean square of what is left, over the noise.
    """

    direction: Array
    covariance: Array
    misfit: float

    def moved(self, first: float, second: float) -> Array:
        """The direction, turned toward the two directions across it, rad."""
        u, v = across(self.direction)
        turned = self.direction + first * u + second * v
        return np.asarray(turned / np.linalg.norm(turned))

    @property
    def error(self) -> float:
        """Standard deviation of its direction, rad, the larger of two."""
        return float(np.sqrt(np.linalg.eigvalsh(self.covariance)[-1]))


def fitted_axis(sensed: list[Sensed], guess: Array) -> Axis:
    """The axis near a guess that suits all passages best (Gauss and Newton's method)."""
    u, v = across(guess)

    def at(shift: Array) -> Array:
        axis = guess + shift[0] * u + shift[1] * v
        return _left(sensed, axis / np.linalg.norm(axis))

    shift = np.zeros(2)
    misfit = 1.0
    for _ in range(5):
        left = at(shift)
        slopes = np.stack(
            [(at(shift + step) - left) / TRIAL for step in TRIAL * np.eye(2)], axis=-1
        )
        misfit = max(float(np.sqrt(np.mean(left**2))), 1.0)
        information = slopes.T @ slopes / misfit**2 + np.eye(2) / EXPECTED**2
        pull = slopes.T @ left / misfit**2 + shift / EXPECTED**2
        change = -np.linalg.solve(information, pull)
        size = float(np.linalg.norm(change))
        shift = shift + change * min(1.0, 0.1 / max(size, 1e-12))
        length = float(np.linalg.norm(shift))
        shift *= min(1.0, MOST / max(length, 1e-12))
        if size < 1e-4:
            break
    direction = guess + shift[0] * u + shift[1] * v
    left = at(shift)
    return Axis(
        direction / np.linalg.norm(direction),
        np.linalg.inv(information),
        float(np.sqrt(np.mean(left**2))),
    )


def _left(sensed: list[Sensed], axis: Array) -> Array:
    """What is left of the momentum on all legs, over its noise."""
    return np.concatenate([leg.residual for one in sensed for leg in one.legs(axis)])
