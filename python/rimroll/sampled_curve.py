"""Points of a function, dense enough for a curve through them to approximate it."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np
from numpy.typing import NDArray

from rimroll._core import MAX_FRICTION
from rimroll.errors import RimrollError
from rimroll.given import number

Array = NDArray[np.float64]
Curve = Callable[[Array], Array]

MAX_POINTS = 10_000
"""The largest number of points; a function that needs more raises an error."""

CLOSEST = 1e-9
"""How close two points may be, relative to the range of speeds."""

GOLDEN = 0.5 * (np.sqrt(5.0) - 1.0)
PLACES = np.sort(np.arange(1, 65) * GOLDEN % 1.0)
"""Divisions of each interval between given speeds at which the curve is always compared.

Multiples of the golden ratio are spread almost evenly, and have no common measure with a periodic
function, whose every quarter of an interval may look alike. Neighbours are 1/46 apart at most.
"""


def sampled(
    mu: Callable[[float], float],
    speeds: Sequence[float],
    curve_through: Callable[[Sequence[float], Sequence[float]], Curve],
    tolerance: float,
) -> tuple[list[float], list[float]]:
    """Speeds and frictions of points, such that the curve is within ``tolerance`` of ``mu``.

    They begin with ``speeds``. The middle is added of each interval in which the curve is farther
    from ``mu`` at a quarter, half or three quarters of it, or at one of 64 places between each two
    of ``speeds``. Raises ``RimrollError`` where ``mu`` gives no friction, is not continuous, or
    needs more than :data:`MAX_POINTS`.
    """
    known = {speed: _friction(mu, speed) for speed in speeds}
    begin = np.array(speeds)
    places = (begin[:-1, None] + np.diff(begin)[:, None] * PLACES).ravel()
    at_places = _frictions(mu, places)
    while True:
        points = np.array(sorted(known))
        frictions = [known[speed] for speed in points.tolist()]
        curve = curve_through(points.tolist(), frictions)
        middles = points[:-1] + 0.5 * np.diff(points)
        bad = _off_at_quarters(mu, points, curve, tolerance)
        missed = places[np.abs(curve(places) - at_places) > tolerance]
        bad[np.searchsorted(points, missed, side="right") - 1] = True
        new = dict(zip(middles[bad].tolist(), _frictions(mu, middles[bad]).tolist(), strict=True))
        if not new:
            return points.tolist(), frictions
        closest = np.min(np.diff(sorted({*known, *new})))
        span = points[-1] - points[0]
        if len(known) + len(new) > MAX_POINTS or closest < CLOSEST * span:
            raise RimrollError(
                f"mu cannot be followed to {tolerance:g} near {min(new):g} m/s with {len(known)}"
                " points: it must be continuous"
            )
        known |= new


def _friction(mu: Callable[[float], float], speed: float) -> float:
    value = number(f"mu({speed:g})", mu(speed))
    if not 0.0 <= value <= MAX_FRICTION:
        raise RimrollError(f"mu({speed:g}) must be between 0 and {MAX_FRICTION:g}, got {value:g}")
    return value


def _frictions(mu: Callable[[float], float], speeds: Array) -> Array:
    found = np.array([_friction(mu, speed) for speed in speeds.ravel().tolist()], np.float64)
    return found.reshape(speeds.shape)


def _off_at_quarters(
    mu: Callable[[float], float], points: Array, curve: Curve, tolerance: float
) -> NDArray[np.bool_]:
    """The intervals in which the curve is too far from mu at one of their quarters."""
    looks = points[:-1] + np.array([[0.25], [0.5], [0.75]]) * np.diff(points)
    bad: NDArray[np.bool_] = np.abs(curve(looks) - _frictions(mu, looks)).max(axis=0) > tolerance
    return bad
