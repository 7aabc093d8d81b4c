"""The likelihood of a probit regression on one variable, its maximum and its profiles."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Interval = tuple[float, float]


@dataclass(frozen=True)
class Likelihood:
    """The logarithm of the likelihood of Φ(intercept + slope x), which is concave."""

    count: Array
    x: Array
    of: Array

    def __call__(self, intercept: float, slope: float) -> float:
        from scipy.special import log_ndtr

        z = intercept + slope * self.x
        rest = self.of - self.count
        return float(np.sum(self.count * log_ndtr(z) + rest * log_ndtr(-z)))

    def largest(self) -> tuple[float, float]:
        """The intercept and the slope with the largest likelihood."""
        from scipy.optimize import minimize

        spread = float(self.x.std())
        begin = np.array([0.0, 1.0])
        found = minimize(
            lambda a: -self(a[0], a[1] / spread),
            begin,
            jac=lambda a: -self._gradient(a[0], a[1] / spread) * [1.0, 1.0 / spread],
            method="BFGS",
            options={"gtol": 1e-9},
        )
        return float(found.x[0]), float(found.x[1]) / spread

    def _gradient(self, intercept: float, slope: float) -> Array:
        from scipy.special import log_ndtr

        z = intercept + slope * self.x
        log_density = -0.5 * z * z - 0.5 * math.log(2.0 * math.pi)
        rest = self.of - self.count
        each = self.count * np.exp(log_density - log_ndtr(z)) - rest * np.exp(
            log_density - log_ndtr(-z)
        )
        return np.array([each.sum(), (each * self.x).sum()])

    def at_median(self, theta: float) -> float:
        """The largest likelihood with this ln θ and a slope that is not negative."""
        from scipy.optimize import brentq

        def rate(slope: float) -> float:
            of_intercept, of_slope = self._gradient(-slope * theta, slope)
            return float(of_slope - theta * of_intercept)

        if rate(0.0) <= 0.0:
            return self(0.0, 0.0)
        steep = 1.0 / float(self.x.std())
        while rate(steep) > 0.0:
            steep *= 2.0
        slope = float(brentq(rate, 0.0, steep, xtol=1e-12))
        return self(-slope * theta, slope)

    def at_slope(self, slope: float) -> float:
        """The largest likelihood with this slope."""
        from scipy.optimize import brentq

        reach = 10.0 + abs(slope) * float(np.abs(self.x).max())
        intercept = brentq(lambda a: self._gradient(a, slope)[0], -reach, reach, xtol=1e-12)
        return self(float(intercept), slope)

    def interval(
        self,
        profile: Callable[[float], float],
        at: float,
        width: float,
        best: float,
        level: float,
    ) -> Interval:
        """The values around ``at`` that the test of the likelihood ratio does not reject."""
        from scipy.optimize import brentq
        from scipy.stats import chi2

        drop = 0.5 * float(chi2.ppf(level, 1))

        def excess(value: float) -> float:
            return best - profile(value) - drop

        ends = []
        for sign in (-1.0, 1.0):
            distance = 0.1 * width
            for _ in range(60):
                if excess(at + sign * distance) > 0.0:
                    ends.append(float(brentq(excess, at, at + sign * distance)))
                    break
                distance *= 2.0
                if distance > 1e3 * (width + abs(at)):
                    ends.append(sign * math.inf)
                    break
            else:
                ends.append(sign * math.inf)
        return ends[0], ends[1]
