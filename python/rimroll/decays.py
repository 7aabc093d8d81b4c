"""How a steady motion decays under weak resistance: slowly, through other steady motions."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from rimroll.body import Body
from rimroll.errors import RimrollError, expect
from rimroll.given import Number, number
from rimroll.laws import AirDrag, Law, NoSlip, PivotingFriction, RollingResistance, one_law
from rimroll.steady import SteadyMotion

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
