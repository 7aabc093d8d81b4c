"""Points of a function, as many as a curve through them needs to follow it."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np
from numpy.typing import NDArray

from rimroll.errors import RimrollError
from rimroll.given import number

Array = NDArray[np.float64]
Curve = Callable[[Array], Array]

MOST_POINTS = 10_000
"""Where more would be needed, the function is refused."""

CLOSEST = 1e-9
"""How close two points may be, relative to the range of speeds."""

MOST_FRICTION = 1e6


def sampled(
    mu: Callable[[float], float],
    speeds: Sequence[float],
    curve_through: Callable[[Sequence[float], Sequence[float]], Curve],
    tolerance: float,
) -> tuple[list[float], list[float]]:
    """Speeds and frictions of points through which a curve follows ``mu`` to ``tolerance``.

    They begin with ``speeds``. The middle is added of each interval in which the curve is farther
    from ``mu`` at a quarter, half or three quarters of it. Raises ``RimrollError`` where ``mu``
    gives no friction, is not continuous, or needs more than :data:`MOST_POINTS`.
    """
    known = {speed: _friction(mu, speed) for speed in speeds}
    while True:
        points = sorted(known)
        frictions = [known[speed] for speed in points]
        new = _off(mu, np.array(points), curve_through(points, frictions), tolerance)
        if not new:
            return points, frictions
        closest = np.min(np.diff(sorted({*known, *new})))
        span = points[-1] - points[0]
        if len(known) + len(new) > MOST_POINTS or closest < CLOSEST * span:
            raise RimrollError(
                f"mu cannot be followed to {tolerance:g} near {min(new):g} m/s with {len(known)}"
                " points: it must be continuous"
            )
        known |= new


def _friction(mu: Callable[[float], float], speed: float) -> float:
    value = number(f"mu({speed:g})", mu(speed))
    if not 0.0 <= value <= MOST_FRICTION:
        raise RimrollError(f"mu({speed:g}) must be between 0 and {MOST_FRICTION:g}, got {value:g}")
    return value


def _off(
    mu: Callable[[float], float], points: Array, curve: Curve, tolerance: float
) -> dict[float, float]:
    """The middles of the intervals in which the curve is not yet good enough, and mu there."""
    begin, widths = points[:-1], np.diff(points)
    looks = np.array([begin + part * widths for part in (0.25, 0.5, 0.75)])
    found = np.array([[_friction(mu, float(speed)) for speed in look] for look in looks])
    bad = np.abs(curve(looks) - found).max(axis=0) > tolerance
    return dict(zip(looks[1][bad].tolist(), found[1][bad].tolist(), strict=True))
