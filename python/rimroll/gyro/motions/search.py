"""Least squares over the numbers of a model: from both sides of the turn, at every friction."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from rimroll.body import Body
from rimroll.gyro.friction import BEYOND
from rimroll.gyro.motions.law_numbers import with_numbers
from rimroll.gyro.motions.model import Model
from rimroll.theory import needed_friction

Array = NDArray[np.float64]

ROUNDS = 12
"""Most evaluations of a search."""
PRECISION = 1e-5
"""Relative change of the sum of squares at which a search ends."""
FARTHEST = 8.0
"""How far sensor, body and delay may be from what is expected, in standard deviations."""
OF_DISKS = 1.0
"""The largest friction that is tried for a body without height."""


def highest_friction(body: Body) -> float:
    """The largest friction that is tried: a little more than what rolling through needs."""
    return BEYOND * float(needed_friction(body)) or OF_DISKS


@dataclass(frozen=True)
class Found:
    """A minimum: the model, its numbers, the sum of squares (with priors), and the derivatives."""

    model: Model
    vector: Array
    squares: float
    jacobian: Array

    @property
    def covariance(self) -> Array:
        """The covariance of the numbers, if the scatter is right."""
        return np.asarray(np.linalg.pinv(self.jacobian.T @ self.jacobian, hermitian=True))


def least(model: Model, vector: Array, rounds: int = ROUNDS) -> Found:
    """The minimum near a vector, by SciPy's trust region."""
    from scipy.optimize import least_squares

    low, high = _bounds(model)
    inside = 1e-9 * np.minimum(high - low, 1.0)
    found = least_squares(
        model.residuals, np.clip(vector, low + inside, high - inside), model.jacobian,
        bounds=(low, high), x_scale="jac", ftol=PRECISION, xtol=1e-10, gtol=1e-10,
        max_nfev=rounds,
    )  # fmt: skip
    return Found(model, found.x, 2.0 * float(found.cost), found.jac)


def _bounds(model: Model) -> tuple[Array, Array]:
    """The lowest and the highest numbers that are tried."""
    low = np.full(len(model.names), -np.inf)
    high = np.full(len(model.names), np.inf)
    free = len(model.free)
    low[:free] = 0.0
    if "friction" in model.free:
        high[model.free.index("friction")] = highest_friction(model.body)
    prior = model.prior
    shared = slice(free, model.place(0).start)
    low[shared] = prior.shared - FARTHEST * prior.shared_error
    high[shared] = prior.shared + FARTHEST * prior.shared_error
    for k in range(len(model.windows)):
        place = model.place(k)
        low[place.start], high[place.start] = 0.01, 1.55
        high[place.stop - 1] = FARTHEST * prior.delay_error
        low[place.stop - 1] = -high[place.stop - 1]
    return low, high


def at_friction(model: Model, friction: float) -> Model:
    """The model with its friction fixed."""
    law = with_numbers(model.law, {"friction": friction})
    return replace(model, law=law, free=tuple(name for name in model.free if name != "friction"))
