"""A coefficient of friction and those that the data do not exclude."""

from __future__ import annotations

import math
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from rimroll.experiment.fitting.likelihood import Likelihood, Point

Array = NDArray[np.float64]
Interval = tuple[float, float]


@dataclass(frozen=True, eq=False)
class Estimate:
    """A coefficient of friction, and the set of coefficients that the data do not exclude.

    ``intervals`` are (low, high), in order; there may be several, since two frictions may turn a
    body by the same angle. An interval that ends at 0 or at ``holding_friction`` is open there: at
    ``holding_friction`` the rim holds, and more friction changes almost nothing. ``deviance`` (f,)
    is twice the loss of log likelihood at ``frictions`` (f,), and ``limit`` its value at the ends
    of the intervals.
    """

    friction: float
    intervals: tuple[Interval, ...]
    holding_friction: float
    frictions: Array = field(repr=False)
    deviance: Array = field(repr=False)
    limit: float = field(repr=False)

    def __str__(self) -> str:
        return f"{self.friction:.3f} ({self.in_words})"

    @property
    def open_above(self) -> bool:
        """Whether the data set no upper bound: the rim may not have slipped at all."""
        return self.intervals[-1][1] >= self.holding_friction

    @property
    def in_words(self) -> str:
        """The intervals as ``0.11 to 0.16`` or ``above 0.31``."""
        return " or ".join(self.interval_in_words(*interval) for interval in self.intervals)

    def interval_in_words(self, low: float, high: float) -> str:
        """One of the intervals."""
        from_none, to_most = low <= 0.0, high >= self.holding_friction
        if from_none and to_most:
            return "any friction"
        if from_none:
            return f"below {high:.3f}"
        return f"above {low:.3f}" if to_most else f"{low:.3f} to {high:.3f}"


def estimate(
    likelihood: Likelihood, confidence: float, fixed: dict[str, float]
) -> tuple[Estimate, Point]:
    """The friction, with every other parameter profiled that is not fixed."""
    from scipy.optimize import brentq

    best = likelihood.best(**fixed)
    points = {best.friction: best}
    # Outward from the best: the top at the friction before is next to that at the next.
    frictions = likelihood.predicted.frictions
    up, down = frictions[frictions > best.friction], frictions[frictions <= best.friction]
    for way in (up, down[::-1]):
        near = best
        for friction in way.tolist():
            near = points[friction] = likelihood.best(near, **fixed, friction=friction)
    best = max(points.values(), key=lambda one: one.log_likelihood)
    for start in _tops([points[friction] for friction in sorted(points)]):
        point = likelihood.climb(start, fixed)
        points[point.friction] = point
        best = max(best, point, key=lambda one: one.log_likelihood)
    limit = likelihood.most(confidence)

    def beyond(friction: float) -> float:
        point = points.get(friction) or likelihood.best(best, **fixed, friction=friction)
        return likelihood.beyond(point, best, limit)

    grid = np.array(sorted(points))
    deviance = np.array([likelihood.worse(points[friction], best) for friction in grid.tolist()])
    over = deviance - limit
    ends = [] if over[0] > 0.0 else [float(grid[0])]
    for i in np.flatnonzero((over[1:] > 0.0) != (over[:-1] > 0.0)):
        ends.append(float(brentq(beyond, grid[i], grid[i + 1], xtol=1e-5)))
    ends += [] if over[-1] > 0.0 else [float(grid[-1])]
    intervals = tuple(zip(ends[::2], ends[1::2], strict=True))
    most = float(likelihood.predicted.frictions[-1])
    return Estimate(best.friction, intervals, most, grid, deviance, limit), best


def _tops(points: list[Point]) -> list[Point]:
    """Those that are above their neighbours: between them more data may see more than one hill."""
    heights = np.array([-math.inf, *(point.log_likelihood for point in points), -math.inf])
    above = (heights[1:-1] >= heights[:-2]) & (heights[1:-1] >= heights[2:])
    return [points[i] for i in np.flatnonzero(above)]
