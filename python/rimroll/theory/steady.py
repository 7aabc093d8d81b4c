"""Steady motions, whose tilt is constant, their stability and their nutation."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from rimroll import _core
from rimroll.bodies.body import Body, one_body
from rimroll.errors import RimrollError, expect
from rimroll.laws import Law, NoSlip, ideal, one_law
from rimroll.many.rows import elementwise
from rimroll.motion import Motion, simulate
from rimroll.state import State, single
from rimroll.units import Number, Values, number, optional, positive, values


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


QUANTITIES = ("tilt", "tilt_rate", "yaw_rate", "spin_rate")
"""What is disturbed and observed; yaw and spin themselves do not matter."""

BLOCKS = 12
"""Rows of blocks in the Hankel matrix; twice as many derivatives are taken."""

STEPS_PER_RADIAN = 2.0
"""Derivatives while the fastest rotation of the motion turns by one radian."""

NOISE = 1e-6
"""Singular values below this fraction of the largest are errors of the derivatives."""

DISTURBANCES = (1e-8, 1e-7, 1e-6, 1e-9)
"""Tilt rates, in units of √(g/R), that are added to the start, one after the other until the
derivatives are accurate. With them the solver's steps follow disturbances; on an exactly steady
motion it would take steps of any length."""

LARGEST_ORDER = 6
"""Tilt, its rate, two rates and the slip."""

STEADY = 1e-4
"""The largest change of the tilt of a steady motion, rad."""

LARGEST_GROWTH = 100.0
"""By which factor a disturbance may grow, so that it leaves others to be seen."""

HALVINGS = 5
"""How often the duration is halved where a disturbance grows beyond that."""


def growth_rates(
    body: Body,
    start: State,
    law: Law,
    *,
    duration: Number | None = None,
    gravity: Number = _core.STANDARD_GRAVITY,
) -> NDArray[np.complex128]:
    """The rates at which small disturbances of a steady motion grow, 1/s, under any law.

    Parameters
    ----------
    body, start, law
        A steady motion: tilt, yaw rate and spin rate stay constant from this start. It may be one
        of :func:`rimroll.steady_motions`, whose ``start`` it has, or that of an upright disk.
    duration
        How long disturbances are followed, s. By default, until the motion has turned by 12 radians
        (at its yaw or spin rate, or at √(g/R) if that is larger). It is shortened if disturbances
        grow too fast.
    gravity
        m/s².

    Returns
    -------
    array of complex
        The eigenvalues λ of disturbances exp(λt), the largest real part first: a positive real part
        is an instability, an imaginary part an oscillation. Zeros belong to neighbouring steady
        motions. Disturbances that vanish within the duration are not among them.

    Raises
    ------
    RimrollError
        A number outside its bounds, or a motion that is not steady or whose derivatives are not
        accurate enough.

    Notes
    -----
    The motion is simulated with its exact derivatives. M(t), those of the tilt, its rate and the
    other two rates by the same quantities of the start, is C exp(Lt) B with the generator L. Under
    laws that allow slip, L also contains the slip, which is neither given at the start nor
    observed. So L follows from M at equal steps by the eigensystem realization algorithm (J.-N.
    Juang and R. S. Pappa, J. Guidance 8, 1985): the Hankel matrix of M, reduced to its range, and
    the same one step later. Under dry friction a rim that sticks with a margin of friction also
    sticks in small disturbances, and the rates are those without slip.
    """
    one_body(body)
    expect("start", start, State)
    one_law(law)
    g, release = positive("gravity", gravity, "m/s^2"), single(start)
    falling_rate = math.sqrt(g / body.radius)
    fastest = max(falling_rate, abs(release.yaw_rate), abs(release.spin_rate))
    length = 2 * BLOCKS / (STEPS_PER_RADIAN * fastest)
    if duration is not None:
        length = positive("duration", duration, "s")
    for disturbance in DISTURBANCES:
        disturbed = replace(release, tilt_rate=release.tilt_rate + disturbance * falling_rate)
        flow, step = _followed(body, disturbed, law, length, g, fastest)
        multipliers = _multipliers(flow)
        if multipliers is not None:
            rates = np.log(multipliers.astype(complex)) / step
            return np.asarray(rates[np.argsort(-rates.real)])
    raise RimrollError(
        "the derivatives of the motion are not accurate enough for growth rates; choose another"
        " duration"
    )


def _followed(
    body: Body, start: State[float], law: Law, length: float, gravity: float, fastest: float
) -> tuple[NDArray[np.float64], float]:
    """M at equal steps and the step, s, for so short a time that no disturbance grows too large."""
    for _ in range(HALVINGS):
        motion = simulate(body, start, law, length, gravity=gravity, rtol=1e-12, jacobian=True)
        if motion.status == "finished" and np.ptp(motion.tilt) < STEADY:
            step = length / (2 * BLOCKS)
            flow = _flow(motion, step, fastest)
            if np.abs(flow).max() < LARGEST_GROWTH:
                return flow, step
        length *= 0.5
    raise RimrollError(
        f"the motion is not steady: within {2.0 * length:.3g} s its tilt goes from"
        f" {motion.tilt.min():.6g} to {motion.tilt.max():.6g} rad ({motion.status})"
    )


def _flow(motion: Motion, step: float, fastest: float) -> NDArray[np.float64]:
    """M at equal steps, shape (2 BLOCKS, 4, 4), with rates in units of the fastest one."""
    found = motion.jacobian(np.minimum(step * np.arange(1, 2 * BLOCKS + 1), motion.t[-1]))
    by_names = [[found[row, column] for column in QUANTITIES] for row in QUANTITIES]
    units = np.array([1.0, fastest, fastest, fastest])
    flow: NDArray[np.float64] = np.moveaxis(np.array(by_names), -1, 0) * units / units[:, None]
    if not np.isfinite(flow).all():
        raise RimrollError("the motion has no derivatives: its contact changes at the start")
    return flow


def _multipliers(flow: NDArray[np.float64]) -> NDArray[np.complex128] | None:
    """The eigenvalues of the flow over one step, of the smallest system with these derivatives.

    None if that system has more quantities than a rim on a table, as errors have.
    """
    now, later = (
        np.block([[flow[i + j + shift] for j in range(BLOCKS)] for i in range(BLOCKS)])
        for shift in (0, 1)
    )
    left, sizes, right = np.linalg.svd(now)
    kept = int((sizes > NOISE * sizes[0]).sum())
    if kept > LARGEST_ORDER:
        return None
    root = 1.0 / np.sqrt(sizes[:kept])
    reduced = (root[:, None] * left[:, :kept].T) @ later @ (right[:kept].T * root)
    multipliers: NDArray[np.complex128] = np.linalg.eigvals(reduced)
    return multipliers
