"""The probit regression of fragility curves: its likelihood with profiles, and the jackknife.

The jackknife says how much a curve varies with the records. A record decides the motions at all its
intensities, so the motions are not independent, but the records are. Each record is left out in
turn and the curve is fitted to the others. With z a number of the curve of all n records and zᵢ
that without record i, the interval is

    n z - (n - 1) z̄ ± t √((n - 1)/n Σ (zᵢ - z̄)²)

with t of Student's distribution with n - 1 degrees of freedom (Tukey 1958; Efron and Tibshirani, An
Introduction to the Bootstrap, 1993, chapter 11). Its centre corrects the bias of z, which matters
for the dispersion of few records. No random number is drawn. In simulations of 10 to 40 records at
10 and 30 intensities it contained the dispersion more often than percentiles or BCa of resampled
records and than the sandwich of covariances, all of which were too narrow.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Interval = tuple[float, float]

NEWTON_STEPS = 100
"""Largest number of Newton's steps; from the curve of all records some five are needed."""


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


def left_out(
    record: NDArray[np.intp], count: Array, x: Array, of: Array, begin: tuple[float, float]
) -> Array | None:
    """Intercept and slope (n, 2) of the probit regressions without one of n records each.

    ``record`` (m,) numbers the records of the data from 0; ``count`` of ``of`` trials failed at
    ``x``; ``begin`` are the intercept and slope of all data. None with fewer than two records, or
    if the data without some record determine no rising curve.
    """
    each, place = np.unique(x, return_inverse=True)
    records = int(record.max()) + 1
    fell, all_of = np.zeros((2, records, len(each)))
    np.add.at(fell, (record, place), count)
    np.add.at(all_of, (record, place), of)
    fell, all_of = fell.sum(axis=0) - fell, all_of.sum(axis=0) - all_of
    if records < 2 or not _overlap(fell, all_of):
        return None
    found = _fitted(fell, each, all_of, begin)
    return None if found is None or not (found[:, 1] > 0.0).all() else found


def _overlap(count: Array, of: Array) -> bool:
    """Whether in each row something fell below or where something stood: else β is 0."""
    fell, stood = count > 0.0, count < of
    lowest = np.where(fell.any(axis=1), fell.argmax(axis=1), fell.shape[1])
    highest = np.where(stood.any(axis=1), stood.shape[1] - 1 - stood[:, ::-1].argmax(axis=1), -1)
    return bool((lowest < highest).all())


def _fitted(count: Array, x: Array, of: Array, begin: tuple[float, float]) -> Array | None:
    """The largest likelihoods by Newton's method, which halves steps that do not rise."""
    from scipy.special import log_ndtr

    rest = of - count
    at = np.tile(np.array(begin), (len(count), 1))

    def evaluated(at: Array) -> tuple[Array, Array, Array, Array]:
        """Φ⁻¹, the logarithms of both probabilities, and that of the likelihood."""
        z = at[:, :1] + at[:, 1:] * x
        fell, stood = log_ndtr(z), log_ndtr(-z)
        return z, fell, stood, (count * fell + rest * stood).sum(axis=1)

    z, fell, stood, best = evaluated(at)
    for _ in range(NEWTON_STEPS):
        log_density = -0.5 * z * z - 0.5 * math.log(2.0 * math.pi)
        up, down = np.exp(log_density - fell), np.exp(log_density - stood)
        rate = count * up - rest * down
        bend = count * up * (up + z) + rest * down * (down - z)
        gradient = np.stack([rate.sum(axis=1), rate @ x], axis=1)
        whole, mixed, square = bend.sum(axis=1), bend @ x, bend @ (x * x)
        hessian = np.stack([whole, mixed, mixed, square], axis=1).reshape(-1, 2, 2)
        step = np.linalg.solve(hessian, gradient[:, :, np.newaxis])[:, :, 0]
        if (np.abs(step) <= 1e-10 * (1.0 + np.abs(at))).all():
            return at
        for _ in range(30):
            z, fell, stood, risen = evaluated(at + step)
            falls = risen < best - 1e-12 * np.abs(best)
            if not falls.any():
                break
            step[falls] *= 0.5
        at, best = at + step, risen
    return None


def jackknife_interval(all_of: Array, without: Array, level: float) -> tuple[Array, Array]:
    """The interval of numbers (...) of the curve, from those without one of n records (n, ...)."""
    from scipy.stats import t

    records, mean = len(without), without.mean(axis=0)
    scatter = ((without - mean) ** 2).sum(axis=0)
    error = np.sqrt((records - 1) / records * scatter)
    unbiased = records * all_of - (records - 1) * mean
    reach = float(t.ppf(0.5 + 0.5 * level, records - 1)) * error
    return unbiased - reach, unbiased + reach
