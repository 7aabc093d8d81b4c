"""How far a fitted motion is from the record, and what that makes of its errors."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from rimroll.gyro.motions.search import Found

Array = NDArray[np.float64]


def part_left(one: Found) -> float:
    """Residual over rate: root mean squares; NaN if a motion ends before its samples do."""
    residuals, _ = residuals_of(one)
    rates = np.concatenate([window.rates for window in one.model.windows])
    return math.sqrt(float(np.mean(residuals**2) / np.mean(rates**2)))


def residuals_of(one: Found) -> tuple[Array, Array]:
    """What is left of the rates, rad/s (NaN after the end of a motion), and the scatter."""
    windows = one.model.windows
    shown = [one.model.shown(one.vector, k) for k in range(len(windows))]
    left = np.concatenate([w.rates - s for w, s in zip(windows, shown, strict=True)])
    return left, np.concatenate([window.scatter for window in windows])


def normal_residual(one: Found) -> float:
    """Root mean square of the residuals over their scatter."""
    residuals, scatter = residuals_of(one)
    return math.sqrt(float(np.mean((residuals / scatter) ** 2)))


def inflation_of(one: Found) -> float:
    """The factor by which variances are larger than the scatter alone says.

    The mean square of the normalised residuals, if it is above 1, times the number of samples that
    hang together: 1 + 2 Σ of their autocorrelations, up to the first that is not positive.
    """
    residuals, scatter = residuals_of(one)
    return inflation(residuals / scatter, len(one.vector))


def inflation(normal: Array, numbers: int) -> float:
    """The factor of :func:`inflation_of`, from normalised residuals (n, k) of a fit."""
    square = float(np.mean(normal**2))
    together = 1.0
    for lag in range(1, max(len(normal) // 4, 1)):
        correlation = float(np.mean(normal[lag:] * normal[:-lag])) / max(square, 1e-300)
        if correlation <= 2.0 / math.sqrt(normal.size):
            break
        together += 2.0 * correlation
    freedom = max(normal.size - numbers, 1)
    return max(1.0, square * normal.size / freedom) * together
