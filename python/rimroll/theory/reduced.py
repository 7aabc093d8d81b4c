"""A reduced equation of rocking: one second-order equation for the tilt, by Frobenius series."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from rimroll import _core
from rimroll.bodies.body import Body, one_body
from rimroll.errors import RimrollError, expect, hold
from rimroll.state import State, single, times
from rimroll.units import Number, Values, number, positive

Array = NDArray[np.float64]

TERMS = 60
"""Terms of the series that stand for the exact solution; they converge below a tilt of π."""

LARGEST_TILT = 1.5
"""Largest tilt, rad, at which these terms are exact to rounding."""


class ReducedMotion:
    """A motion without slip by the reduced equation. Make it with :func:`reduced_motion`."""

    order: int
    """The highest power of the tilt that is kept of l and s."""
    crossing_rate: float
    """l₀ = dψ/dt sin²φ, continued to zero tilt, rad/s: its sign is that of the turn."""
    spin_constant: float
    """s₀, the part of the axial spin at zero tilt beside κ l₀ ln φ, rad/s."""

    def __init__(
        self, body: Body, start: State[float], duration: float, order: int, gravity: float
    ) -> None:
        from scipy.integrate import solve_ivp

        self.order = order
        series = _Series(body, TERMS)
        rate = start.yaw_rate * math.sin(start.tilt) ** 2
        spin = start.spin_rate + start.yaw_rate * math.cos(start.tilt)
        constants = np.linalg.solve(series.at(start.tilt, TERMS), [rate, spin])
        self.crossing_rate, self.spin_constant = constants.tolist()
        m, R, H, A, C = series.numbers
        K = A + m * H**2
        J = K + m * R**2

        def rates(t: float, u: Array) -> list[float]:
            tilt, tilt_rate, _ = u
            sin, cos = math.sin(tilt), math.cos(tilt)
            l, s = series.at(tilt, order) @ constants
            w = l / sin
            moment = w * cos / sin * (K * w - m * H * R * s) + m * H * R * w**2
            moment -= (C + m * R**2) * w * s + m * gravity * (R * cos - H * sin)
            return [tilt_rate, moment / J, w / sin]

        def turns_down(t: float, u: Array) -> float:
            return float(u[1])

        turns_down.direction = -1.0  # type: ignore[attr-defined]
        first = (start.tilt, start.tilt_rate, start.yaw)
        found = solve_ivp(
            rates,
            (0.0, duration),
            first,
            method="DOP853",
            dense_output=True,
            events=turns_down,
            rtol=1e-12,
            atol=1e-14,
        )
        if not found.success:
            raise RimrollError(f"the reduced equation has no solution: {found.message}")
        self._solution = found.sol
        self._duration = duration
        self.maxima: Array = found.t_events[0]
        """Times of the tilt maxima, s."""

    def tilt(self, t: Values) -> Array:
        """φ at the times t (s), rad, shape (n,)."""
        return np.asarray(self._at(t)[0])

    def tilt_rate(self, t: Values) -> Array:
        """dφ/dt at the times t (s), rad/s, shape (n,)."""
        return np.asarray(self._at(t)[1])

    def yaw(self, t: Values) -> Array:
        """ψ at the times t (s), rad, shape (n,)."""
        return np.asarray(self._at(t)[2])

    def _at(self, t: Values) -> Array:
        moments = np.atleast_1d(times(t))
        bound = f"inside the motion, 0 to {self._duration:.6g} s"
        hold("t", moments, (moments >= 0.0) & (moments <= self._duration), bound, "s")
        return np.asarray(self._solution(moments))


def reduced_motion(
    body: Body,
    start: State,
    duration: Number = 2.0,
    *,
    order: int = 0,
    gravity: Number = _core.STANDARD_GRAVITY,
) -> ReducedMotion:
    """A motion without slip by a single second-order equation for the tilt.

    Parameters
    ----------
    body, start
        What rocks, and a start with a tilt of at most 1.5 rad.
    duration
        Length of the motion, s. The tilt must stay below π.
    order
        The highest power of the tilt that is kept: 0 for the reduced equation itself, J φ̈ = K l₀²
        cosφ/sin³φ + m H R l₀²/sin²φ − m g ρ, and up to 60, which is exact.
    gravity
        m/s².

    Raises
    ------
    RimrollError
        A number outside its bounds, or a motion that comes down flat.

    Notes
    -----
    Without slip l = dψ/dt sin²φ and the axial spin s follow from the tilt alone, by the linear
    equations dl/dφ = p s sinφ − β l and ds/dφ = κ l/sinφ + β s with p = C (C + mR²)/D, β = m H R
    C/D, κ = m R² A/D and D = C K + m R² A. They have a regular singular point at φ = 0, and a basis
    of Frobenius series: l = 1 − βφ + …, s = κ ln φ + …; and l = pφ²/2 + …, s = 1 + βφ + …. With
    these, the third equation of motion is one for the tilt alone. The constants l₀ and s₀ of the
    two follow from the start by the whole series; ``order`` terms are kept in the equation, and at
    order 0 no spin.
    """
    one_body(body)
    expect("start", start, State)
    release, length = single(start), positive("duration", duration, "s")
    g = positive("gravity", gravity, "m/s^2")
    if not 0 <= number("order", order) <= TERMS or int(order) != order:
        raise RimrollError(field="order", value=order, bound=f"a whole number from 0 to {TERMS}")
    if not release.tilt <= LARGEST_TILT:
        raise RimrollError(
            field="tilt", value=release.tilt, bound=f"at most {LARGEST_TILT} rad", unit="rad"
        )
    if release.yaw_rate == release.spin_rate == 0.0:
        raise RimrollError("the body comes down flat: yaw_rate or spin_rate must not be 0")
    return ReducedMotion(body, release, length, int(order), g)


class _Series:
    """l and s over the tilt, for the two solutions that begin with l = 1 and with s = 1."""

    def __init__(self, body: Body, count: int) -> None:
        m, R, H = body.mass, body.radius, body.height
        A, C = body.transverse_inertia, body.axial_inertia
        self.numbers = m, R, H, A, C
        D = C * (A + m * H**2) + m * R**2 * A
        p, beta, kappa = C * (C + m * R**2) / D, m * H * R * C / D, m * R**2 * A / D
        sine, cosecant = _sine(count), _cosecant(count)
        # Coefficients [solution, l or s, without or with ln φ, power of φ].
        of = np.zeros((2, 2, 2, count + 1))
        of[0, 0, 0, 0] = of[1, 1, 0, 0] = 1.0
        of[0, 1, 1, 0] = kappa
        for solution in of:
            (l, s), log = solution, np.array([[0.0, 1.0], [0.0, 0.0]])
            for k in range(count):
                # The coefficients of φ^k in dl/dφ and φ^(k+1) in φ ds/dφ: (k + 1) a + b for a
                # term (a + b ln φ) φ^(k+1), so that b comes first.
                l_rate = p * (s[:, k::-1] @ sine[: k + 1]) - beta * l[:, k]
                l[:, k + 1] = _integrated(l_rate, k + 1, log)
                s_rate = kappa * (l[:, k + 1 :: -1] @ cosecant[: k + 2]) + beta * s[:, k]
                s[:, k + 1] = _integrated(s_rate, k + 1, log)
        self.coefficients = of

    def at(self, tilt: float, order: int) -> Array:
        """[[l₁, l₂], [s₁, s₂]] at a tilt, up to a power of it; at order 0, s is left out."""
        powers = tilt ** np.arange(order + 1)
        kept = self.coefficients[..., : order + 1] @ powers
        both: Array = (kept[..., 0] + kept[..., 1] * math.log(tilt)).T
        if order == 0:
            both[1] = 0.0
        return both


def _integrated(rate: Array, power: int, log: Array) -> Array:
    """(a, b) with d/dφ [(a + b ln φ) φ^power] = (rate[0] + rate[1] ln φ) φ^(power − 1)."""
    with_log = rate[1] / power
    return np.array([(rate[0] - with_log) / power, with_log])


def _sine(count: int) -> Array:
    """Coefficients of sin φ by powers of φ."""
    found = np.zeros(count + 2)
    for k in range(1, count + 2, 2):
        found[k] = (-1.0) ** (k // 2) / math.factorial(k)
    return found


def _cosecant(count: int) -> Array:
    """Coefficients of φ/sin φ by powers of φ."""
    over_tilt = _sine(count + 1)[1:]
    found = np.zeros(count + 2)
    found[0] = 1.0
    for k in range(1, count + 2):
        found[k] = -(over_tilt[1 : k + 1] @ found[k - 1 :: -1][:k])
    return found


def rocking_friction(body: Body, start: State, gravity: Number = _core.STANDARD_GRAVITY) -> float:
    """The friction that rolling through a whole rocking needs, for vanishing sideways rates.

    It is the largest |T|/N of the tipping from the tilt and tilt rate of ``start`` to the table, or
    :func:`rimroll.needed_friction` of the near-collision if that is larger. The rocking up again is
    the mirror image. In the tipping, a pendulum about the contact point, T = −m (z φ̈ + ρ φ̇²) and N
    = m (g + ρ φ̈ − z φ̇²) with J φ̈ = −m g ρ.

    Raises ``RimrollError`` for a gravity that is not positive, a start that does not come down, or
    one whose rim lifts off.
    """
    from rimroll.theory.closed_forms import needed_friction

    one_body(body)
    expect("start", start, State)
    release, g = single(start), positive("gravity", gravity, "m/s^2")
    m, R, H = body.mass, body.radius, body.height
    J = body.transverse_inertia + m * (R**2 + H**2)
    tilt = np.linspace(release.tilt, 0.0, 2001)
    rho, z = R * np.cos(tilt) - H * np.sin(tilt), R * np.sin(tilt) + H * np.cos(tilt)
    square = release.tilt_rate**2 + 2.0 * m * g * (z[0] - z) / J
    if release.tilt_rate > 0.0 or (square[1:] <= 0.0).any():
        raise RimrollError("the body does not come down: it must fall, from below its balance tilt")
    acceleration = -m * g * rho / J
    friction = np.abs(z * acceleration + rho * square)
    normal = g + rho * acceleration - z * square
    if (normal <= 0.0).any():
        raise RimrollError("the rim lifts off the table while the body tips")
    return max(float((friction / normal).max()), float(needed_friction(body)))
