"""The interval of one number by profile likelihood."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from rimroll.gyro.motions.search import ROUNDS, Found, at_friction, least

Array = NDArray[np.float64]

MOST_STEPS = 30
"""Steps to either side of the minimum."""
MOST_HALVINGS = 8
"""How often a step that went too far is halved."""
FAR = 4.0
"""A rise that is larger than so many of those asked for is too far."""
LEAST_STEP = 1e-7
"""The smallest step, over the largest friction."""


def friction_interval(
    best: Found, rise: float, highest: float, rounds: int = ROUNDS
) -> tuple[float, float | None, Found]:
    """The frictions at which the sum of squares is at most ``rise`` larger than at its minimum.

    From the minimum one goes to either side in growing steps, fits all other numbers again at each,
    and finds the end by interpolation of the root of the rise. The lower end is 0 and the upper one
    None where the rise is not reached. Also returns the lowest minimum that was met. Each fit makes
    at most so many ``rounds``.
    """
    place = best.model.free.index("friction")
    error = math.sqrt(float(best.covariance[place, place]) * rise)
    if not LEAST_STEP * highest < error:  # where the rim does not slip, friction changes nothing
        flat = np.abs(best.jacobian[:, place]).max() == 0.0
        error = (0.1 if flat else LEAST_STEP) * highest
    least_squares = best
    ends: list[float | None] = []
    for sign in (-1.0, 1.0):
        end, lower = _end(best, place, sign, rise, error, highest, rounds)
        ends.append(end)
        if lower.squares < least_squares.squares:
            least_squares = lower
    return ends[0] or 0.0, ends[1], least_squares


def _end(
    best: Found, place: int, sign: float, rise: float, error: float, highest: float, rounds: int
) -> tuple[float | None, Found]:
    center = float(best.vector[place])
    limit = highest if sign > 0.0 else 0.0
    step = min(error, 0.1 * highest)
    vector = np.delete(best.vector, place)
    before, height, refined = center, 0.0, 0
    lowest = best
    for _ in range(MOST_STEPS):
        at = before + sign * step
        at = min(at, limit) if sign > 0.0 else max(at, limit)
        one = least(at_friction(best.model, at), vector, rounds)
        now = one.squares - best.squares
        if one.squares < lowest.squares - 1e-3:
            lowest = _freed(best, one, place, at, rounds)
        if now > FAR * rise and refined < MOST_HALVINGS:  # too far: back half of the way
            step, refined = 0.5 * abs(at - before), refined + 1
            continue
        if now >= rise:
            # The square root of the rise is nearly straight.
            low, high = math.sqrt(height), math.sqrt(now)
            part = (math.sqrt(rise) - low) / max(high - low, 1e-12)
            return before + part * (at - before), lowest
        if at == limit:
            return None, lowest
        before, height, vector = at, max(now, 0.0), one.vector
        step *= 1.0 if now > 0.1 * rise else 1.6
    return None, lowest


def _freed(best: Found, fixed: Found, place: int, friction: float, rounds: int) -> Found:
    """The minimum from a point of the profile, with the friction free."""
    return least(best.model, np.insert(fixed.vector, place, friction), rounds)
