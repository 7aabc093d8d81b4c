"""Tests of shape: Cramér and von Mises' statistic, and von Mises' distribution of directions.

``scipy.stats`` has both, but its import takes as long as the rest of a fit.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

TERMS = 20
"""How many terms of each series are summed: they fall off faster than e^(−k²)."""

LARGEST_STATISTIC = 6.0
"""A larger statistic has a chance below 1e-12, and its series would need more terms."""

BEYOND = 40.0
"""Where exp(−y²/4) is so small that the parabolic cylinder function need not be known."""

NARROWEST = 1e12
"""The largest concentration of a hump: one all of whose directions are the same."""


def chance_of_uniform(numbers: Array) -> float:
    """The chance that even numbers (n,) in (0, 1) lie as far from an even spread as these, or more.

    The test is that of Cramér and von Mises. The chance is the limit for many numbers and the first
    correction for n of them: S. Csörgő & J. J. Faraway, J. R. Statist. Soc. B 58 (1996), equations
    1.7, 1.8 and 1.10. What is left is of the order of 1/n².
    """
    n = len(numbers)
    middles = (np.arange(n) + 0.5) / n
    squares = 1.0 / (12.0 * n) + float(np.sum((np.sort(numbers) - middles) ** 2))
    return 1.0 - _below(squares, n)


def _below(statistic: float, n: int) -> float:
    """The chance that the statistic of n even numbers is below this one."""
    from scipy.special import gammaln, pbdv

    if statistic > LARGEST_STATISTIC:
        return 1.0

    def damped(order: float, y: Array) -> Array:
        """The parabolic cylinder function of an order times exp(−y²/4)."""
        return np.asarray(np.exp(-0.25 * y**2) * pbdv(order, np.minimum(y, BEYOND))[0])

    k = np.arange(float(TERMS))
    weights: Array = np.exp(gammaln(k + 0.5) - gammaln(k + 1.0)) / math.pi
    near, middle, far = (
        np.asarray((4.0 * k + part) / math.sqrt(4.0 * statistic), np.float64)
        for part in (1.0, 3.0, 5.0)
    )
    limit = 2.0 * statistic**-0.25 * float(weights @ damped(-0.5, near))
    halves = damped(0.5, middle) / 9.0 + (damped(0.5, near) + damped(0.5, far)) * 7.0 / 144.0
    threes = damped(1.5, near) / 72.0 + (2 * k + 3) * (2 * k + 1) / 12.0 * damped(1.5, far)
    terms = (2 * k + 1) * halves * statistic**-0.75 + threes * statistic**-1.25
    correction = limit / 12.0 - float(weights @ terms)
    return float(np.clip(limit + correction / n, 0.0, 1.0))


@dataclass(frozen=True)
class Hump:
    """A von Mises distribution: its middle, rad, and its concentration, 1/rad² of a narrow one."""

    middle: float
    concentration: float

    @classmethod
    def of(cls, directions: Array) -> Hump:
        """The hump that is most likely to have given directions (n,), rad."""
        from scipy.special import i0e, i1e

        mean = complex(np.mean(np.exp(1j * directions)))
        low, high = math.log(1e-12), math.log(NARROWEST)
        for _ in range(80):
            half = 0.5 * (low + high)
            narrow = math.exp(half)
            low, high = (half, high) if i1e(narrow) / i0e(narrow) < abs(mean) else (low, half)
        return cls(math.atan2(mean.imag, mean.real), math.exp(0.5 * (low + high)))

    def density(self, directions: Array) -> Array:
        """Probability density per radian at directions (rad)."""
        from scipy.special import i0e

        height = 2.0 * math.pi * i0e(self.concentration)
        # −2 sin² is cos − 1 without the loss of digits next to the middle.
        down = -2.0 * np.sin(0.5 * (directions - self.middle)) ** 2
        return np.asarray(np.exp(self.concentration * down) / height)
