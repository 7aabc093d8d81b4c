"""The likelihood of directions of fall, given friction, bias, unsteadiness and share of lefts.

The probability density of one direction d is

    w f_left(d − b; μ, κ) + (1 − w) f_right(d − b; μ, κ)

with the densities of :mod:`rimroll.experiment.predicted`; falls are independent. Other parameters
are profiled: set to the values that maximise the likelihood. Between the points at which they were
computed, logarithms of densities are cubic splines in the friction, the logarithm of the hand's
unsteadiness and the angle, so that the likelihood is smooth in all of its parameters and its
gradient is known.

A confidence set is where twice the loss of log likelihood, D, stays below n log(1 + F/(n − 2)),
with F the quantile of Fisher's distribution with 1 and n − 2 degrees of freedom. For normal humps
with unknown means and a common unknown spread this is Student's interval, exact for any n; for
large n it is Wilks' χ² interval.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from rimroll.experiment.predicted import ANGLES, STRAY, TURN, Predicted, which_node

Array = NDArray[np.float64]

MAX_BIAS = math.radians(60.0)
"""The largest bias that is tried, rad."""

MAX_LOGIT = 6.0
MIN_OF_A_SIDE = 3
"""Falls to the rarer side that are needed to distinguish a bias from friction."""

BINS = 2 * ANGLES
"""Bins of a quarter of a degree, smaller than any error of reading."""

_BIASES = np.radians(np.linspace(-54.0, 54.0, 37))


@dataclass(frozen=True)
class Point:
    """Parameters of the likelihood, and its logarithm."""

    friction: float
    bias: float
    unsteadiness: float
    left_share: float
    log_likelihood: float


class Likelihood:
    """The likelihood of n directions of fall (rad) under predicted densities."""

    def __init__(self, predicted: Predicted, directions: Array) -> None:
        self.predicted = predicted
        self.directions = np.mod(directions, TURN)
        self._angles, self._counts = _binned(self.directions)
        self._log_densities = LogDensities(predicted)
        knows_hands = len(predicted.unsteadiness) > 1
        self._bounds = {
            "friction": (float(predicted.frictions[0]), float(predicted.frictions[-1])),
            "bias": (-MAX_BIAS, MAX_BIAS),
            "log_unsteadiness": tuple(np.log(predicted.unsteadiness[[0, -1]]).tolist()),
            "logit": (-MAX_LOGIT, MAX_LOGIT),
        }
        self._fixed = {} if knows_hands else {"log_unsteadiness": 0.0}
        self._lattice = predicted.frictions[::2]
        self._some_hands = np.log(
            predicted.unsteadiness[:: max(len(predicted.unsteadiness) // 4, 1)]
        )
        self._known_curves: dict[float, Array] = {}

    @property
    def has_both_sides(self) -> bool:
        """Whether there are enough falls to the rarer side to distinguish a bias from friction."""
        lefts = int(np.sum(self.directions > math.pi))
        return min(lefts, len(self.directions) - lefts) >= MIN_OF_A_SIDE

    def best(self, near: Point | None = None, /, **fixed: float) -> Point:
        """The point of the largest likelihood, with some parameters held fixed.

        ``near`` is one more to climb from; what is found is no worse than what is up from there.
        """
        starts = [*self._starts(fixed), *([] if near is None else [near])]
        climbed = (self.climb(start, fixed) for start in starts)
        return max(climbed, key=lambda point: point.log_likelihood)

    def density(self, angles: Array, at: Point) -> Array:
        """Probability density of a direction, per radian, at angles (rad)."""
        curves = self._log_densities.curve(at.friction, math.log(at.unsteadiness))[0]
        left, right = np.exp(Places(angles - at.bias).values(curves))
        return np.asarray(at.left_share * left + (1.0 - at.left_share) * right)

    def strays(self, at: Point) -> NDArray[np.bool_]:
        """Which of the directions (n,) are more probably writing errors than falls."""
        return self.density(self.directions, at) < 2.0 * STRAY / TURN

    def worse(self, point: Point, best: Point) -> float:
        """D: twice the loss of log likelihood."""
        return 2.0 * max(best.log_likelihood - point.log_likelihood, 0.0)

    def beyond(self, point: Point, best: Point, limit: float) -> float:
        """How far a point lies outside the confidence set: below 0 inside, 0 where D is ``limit``.

        Measured in √D, which is nearly linear in a parameter, so that roots are found in few steps.
        """
        return math.sqrt(self.worse(point, best)) - math.sqrt(limit)

    def chance(self, deviance: float) -> float:
        """The chance of a D as large when the point is true."""
        from scipy.special import fdtrc

        spare = len(self.directions) - 2
        return float(fdtrc(1, spare, spare * math.expm1(deviance / len(self.directions))))

    def most(self, confidence: float) -> float:
        """The largest D inside the confidence set."""
        from scipy.special import fdtri

        n = len(self.directions)
        return n * math.log1p(float(fdtri(1, n - 2, confidence)) / (n - 2))

    def _starts(self, fixed: Mapping[str, float]) -> list[Point]:
        """Where to climb from: the best of a coarse lattice, at the best three frictions."""
        frictions = np.array([fixed["friction"]] if "friction" in fixed else self._lattice)
        biases = np.array([fixed["bias"]] if "bias" in fixed else _BIASES)
        hands = self._some_hands
        lefts = min(max(float(np.mean(self.directions > math.pi)), 0.05), 0.95)
        some = np.sort(self.directions)[:: max(len(self.directions) // 128, 1)]
        places = Places(some - biases[:, None])
        flat = []
        for friction in frictions.tolist():
            curves = self._curves(friction)
            left, right = np.exp(places.values(curves)).swapaxes(0, 1)
            flat.append(np.log(lefts * left + (1.0 - lefts) * right).sum(axis=-1))
        heights = np.array(flat)
        starts = []
        for i in np.argsort(heights.max(axis=(1, 2)))[::-1][:3]:
            hand, bias = np.unravel_index(np.argmax(heights[i]), heights[i].shape)
            unsteadiness = math.exp(hands[hand])
            starts.append(
                Point(float(frictions[i]), float(biases[bias]), unsteadiness, lefts, -math.inf)
            )
        return starts

    def _curves(self, friction: float) -> Array:
        """Curves (h, 2, c) at some of the hands; kept, as the same frictions come again."""
        if friction not in self._known_curves:
            curve, hands = self._log_densities.curve, self._some_hands.tolist()
            self._known_curves[friction] = np.array([curve(friction, hand)[0] for hand in hands])
        return self._known_curves[friction]

    def climb(self, start: Point, fixed: Mapping[str, float]) -> Point:
        """The top of the hill that a point is on, with some parameters held fixed."""
        from scipy.optimize import minimize

        share = min(max(start.left_share, 0.01), 0.99)
        values = {
            "friction": start.friction,
            "bias": start.bias,
            "log_unsteadiness": math.log(start.unsteadiness),
            "logit": math.log(share / (1.0 - share)),
            **self._fixed,
            **fixed,
        }
        free = [name for name in values if name not in fixed and name not in self._fixed]

        def loss(x: Array) -> tuple[float, Array]:
            moved = {**values, **dict(zip(free, x.tolist(), strict=True))}
            height, slopes = self.log_likelihood(**moved)
            return -height, -np.array([slopes[name] for name in free])

        if not free:
            return self._point(values, self.log_likelihood(**values)[0])
        found = minimize(
            loss,
            [values[name] for name in free],
            jac=True,
            method="SLSQP",  # several times as fast as L-BFGS-B here, and misses no top
            bounds=[self._bounds[name] for name in free],
            options={"ftol": 1e-9},
        )
        values |= dict(zip(free, found.x.tolist(), strict=True))
        return self._point(values, -float(found.fun))

    def _point(self, values: Mapping[str, float], log_likelihood: float) -> Point:
        return Point(
            values["friction"],
            values["bias"],
            math.exp(values["log_unsteadiness"]),
            1.0 / (1.0 + math.exp(-values["logit"])),
            log_likelihood,
        )

    def log_likelihood(
        self, friction: float, bias: float, log_unsteadiness: float, logit: float
    ) -> tuple[float, dict[str, float]]:
        """The logarithm of the likelihood, and its derivatives by the four parameters."""
        share = 1.0 / (1.0 + math.exp(-logit))
        places = Places(self._angles - bias)
        curves = self._log_densities.curve(friction, log_unsteadiness)
        logs, by_friction, by_hand = places.values(curves)
        parts = np.exp(logs) * [[share], [1.0 - share]]
        density = parts.sum(axis=0)
        # The weight of each side of each fall: how many falls, times the chance that it fell there.
        weights = parts * (self._counts / density)
        slopes = {
            "friction": float((weights * by_friction).sum()),
            "bias": -float((weights * places.slopes(curves[0])).sum()),
            "log_unsteadiness": float((weights * by_hand).sum()),
            "logit": float((1.0 - share) * weights[0].sum() - share * weights[1].sum()),
        }
        return float(self._counts @ np.log(density)), slopes


def _binned(directions: Array) -> tuple[Array, Array]:
    """Angles and numbers of falls there; if there are more falls than bins, those in one bin count
    as equal."""
    if len(directions) <= BINS:
        return directions, np.ones(len(directions))
    counts, edges = np.histogram(directions, BINS, (0.0, TURN))
    there = counts > 0
    return 0.5 * (edges[1:] + edges[:-1])[there], counts[there].astype(np.float64)


_PAD = 12
"""Angles repeated at both ends, so that splines know nothing of the seam."""


class LogDensities:
    """Cubic splines through the logarithms of the densities to the left and to the right."""

    def __init__(self, predicted: Predicted) -> None:
        left, right = (_coefficients(side) for side in (predicted.left, predicted.right))
        # One row of coefficients for each friction and hand: those of the left, then the right.
        self._rows = np.concatenate([left, right], axis=-1)
        self._frictions = predicted.frictions
        self._hands = np.log(predicted.unsteadiness)

    def curve(self, friction: float, log_unsteadiness: float) -> Array:
        """Coefficients (3, 2, c) along the angle, at a friction and an unsteadiness.

        The first index is 0 for the logarithms of the densities, 1 for their derivatives by the
        friction and 2 for those by the logarithm of the unsteadiness; the second is the side.
        """
        low, high = self._frictions[0], self._frictions[-1]
        part = (friction - low) / (high - low)
        frictions, hands, columns = self._rows.shape
        i, by_friction = _weights(float(which_node(part, frictions - 2)), frictions - 2)
        by_friction[1] *= 2.0 * (frictions - 3) / math.sqrt(1.0 + 8.0 * part) / (high - low)
        steps = len(self._hands) - 1
        per_hand = steps / (self._hands[-1] - self._hands[0]) if steps else 0.0
        j, by_hand = _weights((log_unsteadiness - self._hands[0]) * per_hand, hands - 2)
        by_hand[1] *= per_hand
        weights = by_friction[[0, 1, 0], :, None] * by_hand[[0, 0, 1], None, :]
        near = self._rows[i : i + 4, j : j + 4].reshape(16, columns)
        return np.asarray(weights.reshape(3, 16) @ near).reshape(3, 2, columns // 2)


class Places:
    """Angles (rad) at which to evaluate curves: what all curves share is computed once."""

    def __init__(self, angles: Array) -> None:
        place = np.mod(angles, TURN) * (ANGLES / TURN) + _PAD
        below = place.astype(np.intp)
        self._four = below + np.arange(-1, 3).reshape(4, *(1 for _ in below.shape))
        self._weights = _basis(place - below)
        self._weights[1] *= ANGLES / TURN

    def values(self, curves: Array) -> Array:
        """The values (..., *angles.shape) of curves (..., c)."""
        return self._sum(curves, 0)

    def slopes(self, curves: Array) -> Array:
        """The derivatives by the angle (..., *angles.shape), 1/rad, of curves (..., c)."""
        return self._sum(curves, 1)

    def _sum(self, curves: Array, derivative: int) -> Array:
        axis = curves.ndim - 1
        return np.asarray((curves[..., self._four] * self._weights[derivative]).sum(axis=axis))


def _weights(place: float, count: int) -> tuple[int, Array]:
    """The first of four padded coefficients of ``count``, and their weights (2, 4)."""
    below = min(max(math.floor(place), 0), count - 2)
    return below, _basis(np.float64(place - below))


def _basis(t: Array | np.float64) -> Array:
    """The cubic B-splines (4, ...) of four points and their derivatives, t past the second."""
    s = 1.0 - t
    return np.array(
        [
            [
                s * s * s / 6.0,
                2.0 / 3.0 - t * t * (1.0 - 0.5 * t),
                2.0 / 3.0 - s * s * (1.0 - 0.5 * s),
                t * t * t / 6.0,
            ],
            [-0.5 * s * s, t * (1.5 * t - 2.0), s * (2.0 - 1.5 * s), 0.5 * t * t],
        ]
    )


def _coefficients(density: Array) -> Array:
    """Coefficients of the cubic spline through the logarithm of a density (f, k, a).

    One more at either end of the first two axes, the mirror image of the one inside; there are at
    least two hands.
    """
    from scipy.ndimage import spline_filter

    log = np.log(density)
    hands = log if log.shape[1] > 1 else np.repeat(log, 2, axis=1)
    padded = np.concatenate([hands[..., -_PAD:], hands, hands[..., :_PAD]], axis=-1)
    coefficients = spline_filter(padded, mode="mirror")
    return np.asarray(np.pad(coefficients, ((1, 1), (1, 1), (0, 0)), mode="reflect"))


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
