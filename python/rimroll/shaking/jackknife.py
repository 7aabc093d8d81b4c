"""The jackknife over records: how much a fragility curve varies with the records.

A record decides the motions at all its intensities, so the motions are not independent, but the
records are. Each record is left out in turn and the curve is fitted to the others. With z a number
of the curve of all n records and zᵢ that without record i, the interval is

    n z - (n - 1) z̄ ± t √((n - 1)/n Σ (zᵢ - z̄)²)

with t of Student's distribution with n - 1 degrees of freedom (Tukey 1958; Efron and Tibshirani, An
Introduction to the Bootstrap, 1993, chapter 11). Its centre corrects the bias of z, which matters
for the dispersion of few records. No random number is drawn. In simulations of 10 to 40 records at
10 and 30 intensities it contained the dispersion more often than percentiles or BCa of resampled
records and than the sandwich of covariances, all of which were too narrow.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

NEWTON_STEPS = 100
"""Largest number of Newton's steps; from the curve of all records some five are needed."""


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


def interval(all_of: Array, without: Array, level: float) -> tuple[Array, Array]:
    """The interval of numbers (...) of the curve, from those without one of n records (n, ...)."""
    from scipy.stats import t

    records, mean = len(without), without.mean(axis=0)
    scatter = ((without - mean) ** 2).sum(axis=0)
    error = np.sqrt((records - 1) / records * scatter)
    unbiased = records * all_of - (records - 1) * mean
    reach = float(t.ppf(0.5 + 0.5 * level, records - 1)) * error
    return unbiased - reach, unbiased + reach
