"""Zeros of a function of a motion: sampled inside each step, then bracketed and refined.

Each step is searched separately, in the solver's time, in which the motion is as smooth in a
near-collision as elsewhere. A jump in a landing is not a passage through zero.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from rimroll.errors import RimrollError

Array = NDArray[np.float64]
Places = NDArray[np.int64]
Values = Callable[[Places, Array], Array]
"""The function's values inside steps, given the steps' numbers and fractions of them, 0 to 1."""

ROUNDS = 100
CLOSE = 4.0 * np.finfo(np.float64).eps
"""Width of a final bracket, as a fraction of a step."""


@dataclass(frozen=True)
class Crossings:
    """Zeros inside steps, in order, and whether the function rises there."""

    steps: Places
    fractions: Array
    rises: NDArray[np.bool_]


def crossings(values: Values, step_count: int, per_step: int) -> Crossings:
    """Where the function changes its sign inside a step, or becomes zero.

    It is looked at ``per_step`` times in each step.
    """
    looks = np.linspace(0.0, 1.0, per_step + 1)
    steps = np.repeat(np.arange(step_count), per_step + 1)
    fractions = np.tile(looks, step_count)
    found = values(steps, fractions).reshape(step_count, per_step + 1)
    before, after = found[:, :-1], found[:, 1:]
    changes = np.argwhere((np.sign(before) * np.sign(after)) < 0)
    low, high = looks[changes[:, 1]], looks[changes[:, 1] + 1]
    at = changes[:, 0]
    roots = _closed_in(values, at, low, high, before[tuple(changes.T)], after[tuple(changes.T)])
    zeros = np.argwhere(_comes_to_zero(found))
    all_steps = np.concatenate([at, zeros[:, 0]])
    # A zero at the start of a step has no earlier sample in the step, and needs no refinement.
    all_low = np.concatenate([low, looks[np.maximum(zeros[:, 1] - 1, 0)]])
    all_fractions = np.concatenate([roots, looks[zeros[:, 1]]])
    all_fractions = _first_zeros(values, all_steps, all_low, all_fractions)
    earlier = np.concatenate([before[tuple(changes.T)], _value_before(found, zeros)])
    order = np.lexsort((all_fractions, all_steps))
    return Crossings(all_steps[order], all_fractions[order], earlier[order] < 0.0)


def _comes_to_zero(found: Array) -> NDArray[np.bool_]:
    """Which samples are zero while the one before is not; the end of a step is the next's start."""
    flat = found.ravel()
    comes = np.zeros(flat.shape, np.bool_)
    comes[1:] = (flat[1:] == 0.0) & (flat[:-1] != 0.0)
    return comes.reshape(found.shape)


def _value_before(found: Array, places: Places) -> Array:
    values: Array = found.ravel()[places[:, 0] * found.shape[1] + places[:, 1] - 1]
    return values


def _first_zeros(values: Values, steps: Places, low: Array, high: Array) -> Array:
    """Where the function becomes exactly zero, between low, where it is not, and high.

    A clipped function is zero over a stretch, and the sample that meets the stretch lies anywhere
    in it. Brackets are halved until they are closed. Where the function is not exactly zero at
    high, high is returned.
    """
    low, high = low.copy(), high.copy()
    open_ = np.flatnonzero(values(steps, high) == 0.0) if len(steps) else np.arange(0)
    for _ in range(ROUNDS):
        open_ = open_[high[open_] - low[open_] > CLOSE]
        if not len(open_):
            break
        middle = 0.5 * (low[open_] + high[open_])
        zero = values(steps[open_], middle) == 0.0
        high[open_] = np.where(zero, middle, high[open_])
        low[open_] = np.where(zero, low[open_], middle)
    return high


def _closed_in(values: Values, steps: Places, a: Array, b: Array, fa: Array, fb: Array) -> Array:
    """Zeros between a and b, where the function has opposite signs, all at once.

    Method: T. R. Chandrupatla, Adv. Eng. Software 28 (1997): inverse quadratic interpolation where
    it is safe, else bisection.
    """
    a, b, fa, fb = a.copy(), b.copy(), fa.copy(), fb.copy()
    part = np.full(a.shape, 0.5)
    open_ = np.arange(len(a))
    for _ in range(ROUNDS):
        if not len(open_):
            break
        x = a[open_] + part[open_] * (b[open_] - a[open_])
        fx = values(steps[open_], x)
        # The newest end is a, the other side of the zero b, and the end before c.
        same = np.sign(fx) == np.sign(fa[open_])
        c, fc = np.where(same, a[open_], b[open_]), np.where(same, fa[open_], fb[open_])
        b[open_] = np.where(same, b[open_], a[open_])
        fb[open_] = np.where(same, fb[open_], fa[open_])
        a[open_], fa[open_] = x, fx
        part[open_] = _next_part(x, fx, b[open_], fb[open_], c, fc)
        open_ = open_[(np.abs(b[open_] - x) > CLOSE) & (fx != 0.0)]
    return np.where(np.abs(fa) <= np.abs(fb), a, b)


def _next_part(a: Array, fa: Array, b: Array, fb: Array, c: Array, fc: Array) -> Array:
    """The next point between a and b, as a fraction of the interval."""
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        xi, phi = (a - b) / (c - b), (fa - fb) / (fc - fb)
        safe = (phi**2 < xi) & ((1.0 - phi) ** 2 < 1.0 - xi)
        quadratic = fa / (fb - fa) * fc / (fb - fc) + (c - a) / (b - a) * fa / (fc - fa) * fb / (
            fc - fb
        )
        part = np.where(safe & np.isfinite(quadratic), quadratic, 0.5)
        least = np.minimum(0.5, 0.5 * CLOSE / np.abs(b - a))
    return np.clip(part, least, 1.0 - least)


def checked(values: object, count: int, t: Array) -> Array:
    """The values that a function returned for ``count`` moments, as finite numbers.

    Raises ``RimrollError`` for anything but ``count`` real numbers, and for NaN.
    """
    array = np.asarray(values)
    if array.shape != (count,) or array.dtype.kind not in "iuf":
        got = f"shape {array.shape}" if array.dtype.kind in "iuf" else f"{array.dtype} values"
        raise RimrollError(
            f"must give a number for each of the {count} moments, shape ({count},), got {got}",
            "function",
        )
    if np.isnan(array).any():
        first = t[np.isnan(array)][0]
        raise RimrollError(f"must give numbers, got nan at t = {first:.6g} s", "function")
    largest = np.finfo(np.float64).max
    return np.clip(array.astype(np.float64), -largest, largest)
