"""Logarithms of the predicted densities between the points at which they were computed.

They are cubic splines in the friction, the logarithm of the hand's unsteadiness and the angle, so
that the likelihood is smooth in all of its parameters and its gradient is known.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from rimroll.experiment.fitting.predicted import ANGLES, TURN, Predicted, which_node

Array = NDArray[np.float64]

_PAD = 12
"""Angles repeated at both ends, so that splines know nothing of the seam."""


class LogDensities:
    """Cubic splines through the logarithms of the densities to the left and to the right."""

    def __init__(self, predicted: Predicted) -> None:
        left, right = (_coefficients(side) for side in (predicted.left, predicted.right))
        # One row of coefficients for each friction and hand: those of the left, then the right.
        self._rows = np.concatenate([left, right], axis=-1)
        self._frictions = predicted.frictions
        self._hands = np.log(predicted.unsteadiness)

    def curve(self, friction: float, log_unsteadiness: float) -> Array:
        """Coefficients (3, 2, c) along the angle, at a friction and an unsteadiness.

        The first index is 0 for the logarithms of the densities, 1 for their derivatives by the
        friction and 2 for those by the logarithm of the unsteadiness; the second is the side.
        """
        low, high = self._frictions[0], self._frictions[-1]
        part = (friction - low) / (high - low)
        frictions, hands, columns = self._rows.shape
        i, by_friction = _weights(float(which_node(part, frictions - 2)), frictions - 2)
        by_friction[1] *= 2.0 * (frictions - 3) / math.sqrt(1.0 + 8.0 * part) / (high - low)
        steps = len(self._hands) - 1
        per_hand = steps / (self._hands[-1] - self._hands[0]) if steps else 0.0
        j, by_hand = _weights((log_unsteadiness - self._hands[0]) * per_hand, hands - 2)
        by_hand[1] *= per_hand
        weights = by_friction[[0, 1, 0], :, None] * by_hand[[0, 0, 1], None, :]
        near = self._rows[i : i + 4, j : j + 4].reshape(16, columns)
        return np.asarray(weights.reshape(3, 16) @ near).reshape(3, 2, columns // 2)


class Places:
    """Angles (rad) at which to evaluate curves: what all curves share is computed once."""

    def __init__(self, angles: Array) -> None:
        place = np.mod(angles, TURN) * (ANGLES / TURN) + _PAD
        below = place.astype(np.intp)
        self._four = below + np.arange(-1, 3).reshape(4, *(1 for _ in below.shape))
        self._weights = _basis(place - below)
        self._weights[1] *= ANGLES / TURN

    def values(self, curves: Array) -> Array:
        """The values (..., *angles.shape) of curves (..., c)."""
        return self._sum(curves, 0)

    def slopes(self, curves: Array) -> Array:
        """The derivatives by the angle (..., *angles.shape), 1/rad, of curves (..., c)."""
        return self._sum(curves, 1)

    def _sum(self, curves: Array, derivative: int) -> Array:
        axis = curves.ndim - 1
        return np.asarray((curves[..., self._four] * self._weights[derivative]).sum(axis=axis))


def _weights(place: float, count: int) -> tuple[int, Array]:
    """The first of four padded coefficients of ``count``, and their weights (2, 4)."""
    below = min(max(math.floor(place), 0), count - 2)
    return below, _basis(np.float64(place - below))


def _basis(t: Array | np.float64) -> Array:
    """The cubic B-splines (4, ...) of four points and their derivatives, t past the second."""
    s = 1.0 - t
    return np.array(
        [
            [
                s * s * s / 6.0,
                2.0 / 3.0 - t * t * (1.0 - 0.5 * t),
                2.0 / 3.0 - s * s * (1.0 - 0.5 * s),
                t * t * t / 6.0,
            ],
            [-0.5 * s * s, t * (1.5 * t - 2.0), s * (2.0 - 1.5 * s), 0.5 * t * t],
        ]
    )


def _coefficients(density: Array) -> Array:
    """Coefficients of the cubic spline through the logarithm of a density (f, k, a).

    One more at either end of the first two axes, the mirror image of the one inside; there are at
    least two hands.
    """
    from scipy.ndimage import spline_filter

    log = np.log(density)
    hands = log if log.shape[1] > 1 else np.repeat(log, 2, axis=1)
    padded = np.concatenate([hands[..., -_PAD:], hands, hands[..., :_PAD]], axis=-1)
    coefficients = spline_filter(padded, mode="mirror")
    return np.asarray(np.pad(coefficients, ((1, 1), (1, 1), (0, 0)), mode="reflect"))
