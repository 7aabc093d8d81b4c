"""How a steady motion decays under weak resistance, and the exponents of its end."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from rimroll.bodies.body import Body
from rimroll.errors import RimrollError, expect, hold
from rimroll.laws import AirDrag, Law, NoSlip, PivotingFriction, RollingResistance, one_law
from rimroll.state import times
from rimroll.theory.steady import SteadyMotion
from rimroll.units import Number, Values, number, numbers

Array = NDArray[np.float64]

PER_DECADE = 100
"""Tilts at which a decay is tabulated, in each factor of ten."""

SMOOTH = 1e-3
"""Below this fraction of √(g/R) the core smooths the sign of a rate."""


@dataclass(frozen=True)
class Decay:
    """The slow decay of a steady motion that rolls without slip; arrays over falling tilts.

    It is the limit of weak resistance, in which the tilt falls much more slowly than it nutates.
    """

    tilt: Array
    """Tilts φ, rad, shape (n,)."""
    t: Array
    """Times after the beginning, s."""
    yaw_rate: Array
    """dψ/dt of the steady motion at each tilt, rad/s."""
    axial_spin: Array
    """s of the steady motion at each tilt, rad/s."""
    nutation_rate: Array
    """The angular frequency of small nutations at each tilt, rad/s."""
    time_left: Array
    """Time to the end, s; infinite if the tilt does not reach zero in a finite time."""

    @property
    def end(self) -> float:
        """When the tilt is zero, s after the beginning."""
        return float(self.t[0] + self.time_left[0])

    @property
    def exponent(self) -> Array:
        """Local exponent p of the tilt in (t_end − t)^p at each tilt: d ln φ/d ln(t_end − t)."""
        rate = np.gradient(np.log(self.tilt), self.t)
        return np.asarray(-rate * self.time_left)

    @property
    def turning_tilt(self) -> float:
        """The tilt at which the body turns back, rad; NaN if it does not.

        There the rate of nutation rises above the yaw rate: the yaw advances by exactly one
        revolution in a nutation. Before and after, the path, averaged over a nutation, bends to
        opposite sides.
        """
        excess = self.nutation_rate - np.abs(self.yaw_rate)
        rises = np.flatnonzero((excess[:-1] < 0.0) & (excess[1:] >= 0.0))
        if not len(rises):
            return math.nan
        at = int(rises[0])
        part = excess[at] / (excess[at] - excess[at + 1])
        return float(self.tilt[at] + part * (self.tilt[at + 1] - self.tilt[at]))


def decay(motion: SteadyMotion, law: Law, *, until: Number = 1e-4) -> Decay:
    """Follow a steady motion down through the steady motions that weak resistance leads it to.

    Parameters
    ----------
    motion
        A stable steady motion without slip, at a tilt below π/2.
    law
        ``NoSlip`` with the resistances that act, as in ``NoSlip() + RollingResistance(dry=1e-4)``:
        rolling resistance or air drag, or both.
    until
        The smallest tilt that is tabulated, rad. The time that is left below it follows from the
        power law there.

    Raises
    ------
    RimrollError
        Another law or one without resistance, or a motion that is unstable, becomes unstable, or
        does not sink.

    Notes
    -----
    A steady motion keeps φ̈(φ, w, s) = 0. Along the equations of motion w and s have the slopes w′
    and s′ over the tilt, and a resistance changes them by the rates w_r and s_r. So the condition
    stays true if φ̇ ω² = (∂φ̈/∂w) w_r + (∂φ̈/∂s) s_r, with the squared angular frequency of nutation
    ω². This is integrated together with dw/dφ = w′ + w_r/φ̇ and ds/dφ = s′ + s_r/φ̇, over ln φ. The
    curve (w, s) over φ does not depend on the size of a single resistance, and is the same for dry
    and viscous rolling resistance.
    """
    expect("motion", motion, SteadyMotion)
    one_law(law)
    smallest = number("until", until, "rad")
    if not (isinstance(law, NoSlip) and isinstance(motion.law, NoSlip) and law.resistances):
        raise RimrollError(
            "must be rimroll.NoSlip with a resistance added, and motion one without slip", "law"
        )
    if any(isinstance(resistance, PivotingFriction) for resistance in law.resistances):
        raise RimrollError(
            "must be without pivoting friction, which stops the turning about the vertical"
            " and then takes nothing",
            "law",
        )
    if not motion.tilt < 0.5 * math.pi:
        raise RimrollError(f"the tilt of motion must be below pi/2, got {motion.tilt:.6g} rad")
    if not 0.0 < smallest < motion.tilt:
        raise RimrollError(
            field="until", value=smallest, bound=f"inside (0, {motion.tilt:.6g} rad)", unit="rad"
        )
    return _integrated(_SlowMotion(motion.body, law, motion.gravity), motion, smallest)


def _integrated(slow: _SlowMotion, motion: SteadyMotion, smallest: float) -> Decay:
    from scipy.integrate import solve_ivp

    def over_log_tilt(log_tilt: float, state: Array) -> list[float]:
        tilt = math.exp(log_tilt)
        falls, w_rate, s_rate, _ = slow.rates(tilt, *state[:2])
        return [w_rate * tilt / falls, s_rate * tilt / falls, tilt / falls]

    span = math.log(motion.tilt), math.log(smallest)
    count = 2 + int(PER_DECADE * (span[0] - span[1]) / math.log(10.0))
    first = (motion.yaw_rate * math.sin(motion.tilt), motion.axial_spin, 0.0)
    at = np.linspace(*span, count)
    found = solve_ivp(
        over_log_tilt, span, first, method="DOP853", t_eval=at, rtol=1e-10, atol=1e-12
    )
    if not found.success:
        raise RimrollError(f"the decay cannot be followed below {math.exp(found.t[-1]):.3g} rad")
    w, s, t = found.y
    tilt = np.exp(at)
    falls, _, _, squares = np.array([slow.rates(*each) for each in zip(tilt, w, s, strict=True)]).T
    slope = math.log(falls[-2] / falls[-1]) / (at[-2] - at[-1])
    beyond = tilt[-1] / (-falls[-1] * (1.0 - slope)) if slope < 1.0 else math.inf
    return Decay(tilt, t, w / np.sin(tilt), s, np.sqrt(squares), t[-1] - t + beyond)


class _SlowMotion:
    """The rates of tilt, w and s along a decay; symbols as in the theory's pages."""

    def __init__(self, body: Body, law: Law, gravity: float) -> None:
        self.m, self.R, self.H = body.mass, body.radius, body.height
        self.A, self.C, self.g = body.transverse_inertia, body.axial_inertia, gravity
        self.K = self.A + self.m * self.H**2
        self.J = self.K + self.m * self.R**2
        self.D = self.C * self.K + self.m * self.R**2 * self.A
        self.rolling = self.C + self.m * self.R**2
        self.coupling = self.m * self.H * self.R
        self.resistances = law.resistances

    def rates(self, tilt: float, w: float, s: float) -> tuple[float, float, float, float]:
        """φ̇, ẇ, ṡ and ω², at a steady motion."""
        sin, cos = math.sin(tilt), math.cos(tilt)
        cot = cos / sin
        z = self.R * sin + self.H * cos
        by_tilt = -w / sin**2 * (self.K * w - self.coupling * s) + self.m * self.g * z
        by_w = (
            cot * (2.0 * self.K * w - self.coupling * s)
            + 2.0 * self.coupling * w
            - self.rolling * s
        )
        by_s = -w * cot * self.coupling - self.rolling * w
        w_slope = self.C * (self.rolling * s - self.coupling * w) / self.D - w * cot
        s_slope = (self.m * self.R**2 * self.A * w + self.coupling * self.C * s) / self.D
        square = -(by_tilt + by_w * w_slope + by_s * s_slope) / self.J
        about_x, about_z = self._moment(sin, cos, w, s)
        w_lost = (self.rolling * about_x + self.coupling * about_z) / self.D
        s_lost = (self.coupling * about_x + self.K * about_z) / self.D
        falls = (by_w * w_lost + by_s * s_lost) / (self.J * square)
        if square <= 0.0 or falls >= 0.0:
            becomes = "is not stable" if square <= 0.0 else "does not sink"
            raise RimrollError(f"the steady motion {becomes} at a tilt of {tilt:.6g} rad")
        return falls, w_slope * falls + w_lost, s_slope * falls + s_lost, square

    def _moment(self, sin: float, cos: float, w: float, s: float) -> tuple[float, float]:
        """The moments of the resistances about e_x2 and e_z2; the normal force is the weight."""
        about_x = about_z = 0.0
        weight = self.m * self.g
        for resistance in self.resistances:
            if isinstance(resistance, RollingResistance):
                running = s * sin - w * cos
                moment = resistance.dry * self.R * weight * self._sign(running)
                moment += resistance.viscous * self.R**2 * running / sin
                about_x += moment * cos / sin
                about_z -= moment
            elif isinstance(resistance, AirDrag):
                rate = abs(w) / sin
                about_x -= math.copysign(
                    resistance.coefficient * rate ** (resistance.exponent - 1.0) / sin, w
                )
        return about_x, about_z

    def _sign(self, rate: float) -> float:
        return rate / math.hypot(rate, SMOOTH * math.sqrt(self.g / self.R))


NEAREST, FARTHEST = 1e-9, 1e3
"""Where the end time is looked for after the last point, in lengths of the window."""

MIN_SAMPLES = 10
"""Fewest points to which a power law is fitted."""

PARAMETERS = 3
"""Amplitude, exponent and end time."""


@dataclass(frozen=True)
class EndExponent:
    """A power law a (t_end − t)^p, fitted to a window of a curve, with profile intervals.

    The intervals say how well the curve inside the window determines a power law. They know nothing
    of other terms outside it: compare several windows.
    """

    exponent: float
    """p."""
    exponent_interval: tuple[float, float]
    """The exponents that the window allows, with the end time and the amplitude free; without bound
    on the side where it allows an exponential."""
    end: float
    """t_end, s."""
    end_interval: tuple[float, float]
    """The end times that the window allows, s, with the exponent and the amplitude free; up to
    infinity if it allows an exponential."""
    amplitude: float
    """a, the value one second before the end."""
    confidence: float
    """The confidence level of the intervals."""
    window: tuple[float, float]
    """First and last time that was fitted, s."""
    count: int
    """Number of points in the window."""
    independent: float
    """How many independent residuals the points are worth."""
    residual: float
    """Root mean square of the residuals of the logarithm."""

    def __call__(self, t: Values) -> Array:
        """The fitted power law at the times t (s), rad or what was fitted; NaN after the end."""
        left = self.end - times(t)
        return np.asarray(self.amplitude * np.where(left < 0.0, np.nan, left) ** self.exponent)


def fit_exponent(
    t: Values,
    curve: Values,
    *,
    window: tuple[Number, Number] | None = None,
    confidence: float = 0.95,
) -> EndExponent:
    """Fit a power law of the time that is left, a (t_end − t)^p, to a window of a curve.

    Parameters
    ----------
    t
        Times, s, shape (n,), rising.
    curve
        What is fitted, > 0, shape (n,): the tilt of a disk that comes to rest, for example, or its
        yaw rate, whose exponent is negative.
    window
        First and last time to use, s; all by default. It must contain at least 10 points.
    confidence
        Level of the intervals, between 0 and 1.

    Raises
    ------
    RimrollError
        Arrays of different lengths, times that do not rise, values that are not positive, too few
        points, or a window that shows no end: one that an exponential would fit as well.

    Notes
    -----
    Least squares of ln curve = ln a + p ln(t_end − t). Amplitude and exponent enter linearly and
    are eliminated, so that one search over t_end remains. The interval of p holds all exponents
    whose best fit has a residual sum of squares below S (1 + q²/(k − 3)), with the smallest sum S
    and the quantile q of Student's t with k − 3 degrees of freedom; likewise the interval of t_end.
    So they include each other's uncertainty.

    The residuals of a computed or filmed curve follow each other smoothly. k is the number of
    independent ones: the number of points over the integrated autocorrelation time (the sum up to
    the first correlation that is not positive), or the number of runs of one sign if this is
    smaller, but at least 4. More points on the same curve do not narrow the intervals. Of
    residuals whose correlation lasts longer than a tenth of the window, k is an overestimate.
    """
    moments, positive = _curve(t, curve)
    first, last = (moments[0], moments[-1]) if window is None else _window(window)
    inside = (moments >= first) & (moments <= last)
    if inside.sum() < MIN_SAMPLES:
        raise RimrollError(
            f"must contain at least {MIN_SAMPLES} points, got {inside.sum()} between"
            f" {first:.6g} and {last:.6g} s",
            "window",
        )
    level = number("confidence", confidence)
    if not 0.0 < level < 1.0:
        raise RimrollError(field="confidence", value=level, bound="between 0 and 1")
    return _Fit(moments[inside], np.log(positive[inside])).intervals(level)


def _curve(t: Values, curve: Values) -> tuple[Array, Array]:
    moments, positive = np.asarray(times(t)), numbers("curve", curve)
    if moments.ndim != 1 or positive.shape != moments.shape:
        raise RimrollError(
            "t and curve must be arrays of the same length, got shapes"
            f" {moments.shape} and {positive.shape}"
        )
    hold("t", moments, np.diff(moments, prepend=-math.inf) > 0.0, "rising", "s")
    hold("curve", positive, (positive > 0.0) & np.isfinite(positive), "> 0 and finite")
    return moments, positive


def _window(window: tuple[Number, Number]) -> tuple[float, float]:
    if not isinstance(window, tuple | list) or len(window) != 2:
        raise RimrollError(field="window", value=window, bound="a first and a last time")
    return number("window", window[0], "s"), number("window", window[1], "s")


class _Fit:
    """Power laws through points of a window: x = ln(t_end − t), y = ln curve."""

    def __init__(self, t: Array, y: Array) -> None:
        self.t, self.y = t, y
        self.mean = float(y.mean())
        self.from_mean = y - self.mean
        length = float(t[-1] - t[0])
        # The end is looked for by the logarithm of its distance to the last point.
        self.bounds = (math.log(NEAREST * length), math.log(FARTHEST * length))
        self.grid = np.linspace(*self.bounds, 120)
        self.moments = np.array([self._moments(end) for end in self.grid]).T
        covariance, variance = self.moments
        self.best = self._lowest(-(covariance**2) / variance, self._at_end)
        if self.best > self.bounds[1] - 1.0 or not self.from_mean.any():
            raise RimrollError(
                "the window shows no end: a constant or an exponential fits as well as a power law"
            )

    def _log_left(self, log_end: float) -> Array:
        left: Array = np.log(math.exp(log_end) + (self.t[-1] - self.t))
        return left

    def _moments(self, log_end: float) -> tuple[float, float]:
        """The sums of products of x with y and with itself, about the means."""
        x = self._log_left(log_end)
        x -= x.mean()
        return float(x @ self.from_mean), float(x @ x)

    def _at_end(self, log_end: float) -> float:
        """The sum of squares of the best power law with an end."""
        covariance, variance = self._moments(log_end)
        return self._squares(log_end, covariance / variance)

    def _squares(self, log_end: float, exponent: float) -> float:
        return float(np.square(self._residuals(log_end, exponent)).sum())

    def _residuals(self, log_end: float, exponent: float) -> Array:
        """The sums of squares of the best power laws with given ends and exponents."""
        x = self._log_left(log_end)
        residuals: Array = self.from_mean - exponent * (x - x.mean())
        return residuals

    def _at_exponent(self, exponent: float) -> float:
        """The sum of squares of the best power law with an exponent."""
        covariance, variance = self.moments
        on_grid = exponent**2 * variance - 2.0 * exponent * covariance

        def squares(log_end: float) -> float:
            return self._squares(log_end, exponent)

        return squares(self._lowest(on_grid, squares))

    def _lowest(self, on_grid: Array, squares: Callable[[float], float]) -> float:
        """The end with the smallest sum of squares, near the lowest place of the grid."""
        from scipy.optimize import minimize_scalar

        place = int(np.argmin(on_grid))
        around = self.grid[max(place - 1, 0)], self.grid[min(place + 1, len(self.grid) - 1)]
        found = minimize_scalar(squares, bounds=around, method="bounded", options={"xatol": 1e-9})
        return float(found.x)

    def intervals(self, confidence: float) -> EndExponent:
        """The best power law, with its intervals."""
        from scipy.stats import t as student

        covariance, variance = self._moments(self.best)
        exponent = covariance / variance
        residuals = self._residuals(self.best, exponent)
        independent = _independent(residuals)
        freedom = independent - PARAMETERS
        least = float(np.square(residuals).sum())
        quantile = float(student.ppf(0.5 + 0.5 * confidence, freedom))
        allowed = least * (1.0 + quantile**2 / freedom)

        def excess(squares: Callable[[float], float]) -> Callable[[float], float]:
            return lambda at: squares(at) - allowed

        at_end, at_exponent = excess(self._at_end), excess(self._at_exponent)
        first, last = (_zero(at_end, self.best, step, *self.bounds) for step in (-0.01, 0.01))
        step = 1e-3 * abs(exponent) + 1e-6
        low, high = (_zero(at_exponent, exponent, way * step) for way in (-1.0, 1.0))
        end_of = float(self.t[-1])
        farthest = end_of + math.exp(last)
        if at_end(self.bounds[1]) <= 0.0:  # An exponential is allowed, too.
            farthest = math.inf
            low, high = (low, math.inf) if exponent > 0.0 else (-math.inf, high)
        return EndExponent(
            exponent=exponent,
            exponent_interval=(low, high),
            end=end_of + math.exp(self.best),
            end_interval=(end_of + math.exp(first), farthest),
            amplitude=math.exp(self.mean - exponent * float(self._log_left(self.best).mean())),
            confidence=confidence,
            window=(float(self.t[0]), end_of),
            count=len(self.t),
            independent=independent,
            residual=math.sqrt(least / len(self.t)),
        )


def _zero(
    function: Callable[[float], float],
    start: float,
    step: float,
    low: float = -math.inf,
    high: float = math.inf,
) -> float:
    """Where a function that is negative at the start first rises through zero, or the bound."""
    from scipy.optimize import brentq

    if function(start) > 0.0:  # rounding, where the fit is exact
        return start
    inner = start
    for _ in range(60):
        outer = min(max(inner + step, low), high)
        if function(outer) > 0.0:
            return float(brentq(function, inner, outer, xtol=1e-12, rtol=1e-10))
        if outer in (low, high):
            break
        inner, step = outer, 1.6 * step
    return outer


def _independent(residuals: Array) -> float:
    """How many independent numbers the residuals are worth; above the number of parameters."""
    count = len(residuals)
    spectrum = np.abs(np.fft.rfft(residuals, 2 * count)) ** 2
    covariances = np.fft.irfft(spectrum)[:count]
    if covariances[0] == 0.0:
        return float(PARAMETERS + 1)
    runs = 1 + int((np.diff(np.sign(residuals)) != 0.0).sum())
    correlations = covariances[1:] / covariances[0]
    ends = np.flatnonzero(correlations <= 0.0)
    positive = correlations[: ends[0]] if len(ends) else correlations
    independent = count / (1.0 + 2.0 * float(positive.sum()))
    return max(float(PARAMETERS + 1), min(float(runs), independent))
