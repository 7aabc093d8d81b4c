"""Least squares over the numbers of a model: from both sides of the turn, at every friction."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from rimroll.gyro.motions.law_numbers import with_numbers
from rimroll.gyro.motions.model import Model

Array = NDArray[np.float64]

ROUNDS = 12
"""Most evaluations of a search."""
PRECISION = 1e-5
"""Relative change of the sum of squares at which a search ends."""


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

    low, high = model.bounds()
    inside = 1e-9 * np.minimum(high - low, 1.0)
    found = least_squares(
        model.residuals, np.clip(vector, low + inside, high - inside), model.jacobian,
        bounds=(low, high), x_scale="jac", ftol=PRECISION, xtol=1e-10, gtol=1e-10,
        max_nfev=rounds,
    )  # fmt: skip
    return Found(model, found.x, 2.0 * float(found.cost), found.jac)


def at_friction(model: Model, friction: float) -> Model:
    """The model with its friction fixed."""
    law = with_numbers(model.law, {"friction": friction})
    return replace(model, law=law, free=tuple(name for name in model.free if name != "friction"))
