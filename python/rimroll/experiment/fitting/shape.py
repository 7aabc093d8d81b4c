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
"""Of the series; they fall off faster than e^(−k²)."""

NARROWEST = 1e12
"""The largest concentration of a hump: one all of whose directions are the same."""


def chance_of_uniform(numbers: Array) -> float:
    """The chance that even numbers (n,) in (0, 1) lie as far from an even spread as these, or more.

    By Cramér and von Mises' statistic; the chance is its limit for many numbers (Anderson and
    Darling, Ann. Math. Statist. 23, 1952), which for n of them is right to 0.15/n.
    """
    n = len(numbers)
    middles = (np.arange(n) + 0.5) / n
    squares = 1.0 / (12.0 * n) + float(np.sum((np.sort(numbers) - middles) ** 2))
    return 1.0 - _below(squares)


def _below(statistic: float) -> float:
    """The chance of a statistic below this one, in the limit of many numbers."""
    from scipy.special import gammaln, kve

    k = np.arange(TERMS)
    x = (4.0 * k + 1.0) ** 2 / (16.0 * statistic)
    weights = np.exp(gammaln(k + 0.5) - gammaln(k + 1.0)) * np.sqrt(4.0 * k + 1.0)
    total = float(np.sum(weights * np.exp(-2.0 * x) * kve(0.25, x)))
    chance: float = total / (math.pi**1.5 * math.sqrt(statistic))
    return min(chance, 1.0)


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
