"""Steady motions, whose tilt is constant, their stability, and the nutation of stable ones."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

from rimroll import _core
from rimroll.body import Body, one_body
from rimroll.errors import RimrollError, expect
from rimroll.given import Number, Values, number, optional, values
from rimroll.laws import Law, NoSlip, ideal
from rimroll.rows import elementwise
from rimroll.state import State


@dataclass(frozen=True)
class SteadyMotion:
    """A motion at a constant tilt, with a constant yaw rate and axial spin; SI units and radians.

    A small disturbance of a stable motion makes the tilt oscillate (nutation). One of an unstable
    motion grows. At the boundary between the two, linear theory does not decide.
    """

    body: Body
    law: Law
    tilt: float
    yaw_rate: float
    axial_spin: float
    """Spin about the symmetry axis, s = dθ/dt + dψ/dt cos φ."""
    gravity: float
    nutation_squared: float
    """The squared angular frequency of nutation, rad²/s²; negative for an unstable motion."""

    @property
    def start(self) -> State:
        """A state of this motion, from which :func:`rimroll.simulate` continues it."""
        return State(tilt=self.tilt, yaw_rate=self.yaw_rate, spin_rate=self.spin_rate)

    @property
    def spin_rate(self) -> float:
        """dθ/dt, rad/s."""
        return self.axial_spin - self.yaw_rate * math.cos(self.tilt)

    @property
    def is_stable(self) -> bool:
        """Whether small disturbances stay small."""
        return self.nutation_squared > 0.0

    @property
    def nutation_rate(self) -> float:
        """Angular frequency of small oscillations of the tilt, rad/s; NaN if unstable."""
        return math.sqrt(self.nutation_squared) if self.is_stable else math.nan

    @property
    def growth_rate(self) -> float:
        """The rate k at which a disturbance grows, like exp(kt), 1/s; 0 if stable."""
        return math.sqrt(max(0.0, -self.nutation_squared))

    @property
    def path_radius(self) -> float:
        """Radius of the circle on which the contact point runs, m; infinite for a straight line.

        Without friction, that where the centre of mass is at rest.
        """
        speed = self._center_speed - self._rho * self.yaw_rate
        return abs(speed / self.yaw_rate) if self.yaw_rate else math.inf

    @property
    def friction(self) -> float:
        """The coefficient of friction that the motion needs, |T|/N; N is the weight."""
        return abs(self.yaw_rate * self._center_speed) / self.gravity

    @property
    def _rho(self) -> float:
        """Horizontal distance from the contact point to the centre of mass."""
        return self.body.radius * math.cos(self.tilt) - self.body.height * math.sin(self.tilt)

    @property
    def _center_speed(self) -> float:
        """Velocity of the centre of mass along the rim's tangent, m/s."""
        if not isinstance(self.law, NoSlip):
            return 0.0
        across = self.yaw_rate * math.sin(self.tilt)
        return self.body.radius * self.axial_spin - self.body.height * across


def steady_motions(
    body: Body,
    law: Law,
    tilt: Number,
    *,
    yaw_rate: Number | None = None,
    axial_spin: Number | None = None,
    gravity: Number = _core.STANDARD_GRAVITY,
) -> tuple[SteadyMotion, ...]:
    """The steady motions of a body at a tilt: none, one or two.

    Parameters
    ----------
    body, law
        What moves, and how its rim meets the table: ``NoSlip`` or ``Frictionless``.
    tilt
        The constant tilt, rad, inside (0, π).
    yaw_rate, axial_spin
        One or both of the rates, rad/s. With the yaw rate alone, the axial spin follows. With the
        axial spin alone there are up to two yaw rates, the slower one first. With both there is one
        motion if they keep the tilt, and none otherwise. A body that rolls straight at its balance
        tilt has a yaw rate of 0 and any axial spin: give both.
    gravity
        m/s².

    Raises
    ------
    RimrollError
        A number outside its bounds, neither of the rates, or another law.

    Notes
    -----
    φ̈ = 0 is quadratic in the yaw rate and linear in the axial spin. The angular frequency of
    nutation follows from the derivatives of the equations of motion by dual numbers. Under both
    laws it includes the change of yaw rate and axial spin with the tilt.
    """
    one_body(body)
    name = ideal(law).name
    rate, spin = (
        optional("yaw_rate", yaw_rate, "rad/s"),
        optional("axial_spin", axial_spin, "rad/s"),
    )
    if rate is None and spin is None:
        raise RimrollError("give yaw_rate, axial_spin or both (rad/s)")
    angle, g = number("tilt", tilt, "rad"), number("gravity", gravity, "m/s^2")
    found = _core.steady_motions(body, name, angle, rate, spin, g)
    return tuple(SteadyMotion(body, law, angle, w, s, g, square) for w, s, square in found)


def steady_wobble_rate(body: Body, tilt: Values, gravity: Values = _core.STANDARD_GRAVITY) -> Any:
    """Yaw rate of the steady wobble at a tilt with the centre of mass at rest, rad/s.

    ψ̇² = m g R (R cosφ − H sinφ)/[sinφ (A R cosφ − C H sinφ)]; no friction acts. The spin rate is
    ψ̇ (H sinφ/R − cosφ).

    The quotient must be positive. Both factors in parentheses are positive below the smaller of the
    tilts where one of them vanishes, of which one is the balance tilt. Both are negative beyond the
    larger, where a tube spins nearly horizontal on one rim.

    Raises ``RimrollError`` for a tilt outside (0, π) or between these two.
    """
    expect("body", body, Body)
    tilt, gravity = values("tilt", tilt, "rad"), values("gravity", gravity, "m/s^2")
    return elementwise(_core.steady_wobble_rate, body, tilt, gravity)


def nutation_ratio(body: Body, law: Law) -> Any:
    """Angular frequency of nutation over yaw rate in a steady wobble, as the tilt goes to zero.

    The wobble is that with the centre of mass at rest. No slip: √((3A + mH²)/(A + mR² + mH²)), for
    a uniform disk √(3/5). Frictionless: √(3A/(A + mR²)).
    """
    expect("body", body, Body)
    name = ideal(law).name
    return elementwise(lambda body: _core.nutation_ratio(body, name), body)


def critical_rolling_spin(disk: Body, gravity: Values = _core.STANDARD_GRAVITY) -> Any:
    """Axial spin above which an upright disk that rolls straight is stable, rad/s.

    s² = A m g R/(C (C + mR²)): g/(3R) for a uniform disk, g/(4R) for a hoop. Raises
    ``RimrollError`` for a body with a height.
    """
    expect("disk", disk, Body)
    return elementwise(_core.critical_rolling_spin, disk, values("gravity", gravity, "m/s^2"))


def critical_spinning_rate(disk: Body, gravity: Values = _core.STANDARD_GRAVITY) -> Any:
    """Yaw rate above which a disk that spins about its vertical diameter is stable, rad/s.

    Without slip: Ω² = m g R/(A + mR²), 4g/(5R) for a uniform disk. Raises ``RimrollError`` for a
    body with a height.
    """
    expect("disk", disk, Body)
    return elementwise(_core.critical_spinning_rate, disk, values("gravity", gravity, "m/s^2"))


def spinning_rate(body: Body, tilt: Values, gravity: Values = _core.STANDARD_GRAVITY) -> Any:
    """Yaw rate at which a body spins about the vertical on a smooth table at a tilt, rad/s.

    The body rotates as a whole about the vertical through its centre of mass (dθ/dt = 0): Ω² = m g
    (R cosφ − H sinφ)/[(A − C) sinφ cosφ]. For A > C the tilt is below the balance tilt, for A < C
    beyond it; a uniform cylinder has A = C where its length is √3/2 of its diameter. Raises
    ``RimrollError`` where no such motion exists.
    """
    expect("body", body, Body)
    tilt, gravity = values("tilt", tilt, "rad"), values("gravity", gravity, "m/s^2")
    return elementwise(_core.spinning_rate, body, tilt, gravity)
