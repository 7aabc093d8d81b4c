"""The angle of turn in closed form, how motions approach it, and the friction that they need.

Symbols: K = A + mH², J = K + mR². SI units and radians. Every function raises ``RimrollError`` for
numbers outside the bounds that it states.

Functions that return one number take arrays, too: bodies, laws and numbers broadcast, and the
result is an array of that shape; each element equals the single result to the last bit. Data arrays
of xarray broadcast by the names of their dimensions, and then the result is a data array.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

from rimroll import _core
from rimroll.bodies.body import Body, one_body
from rimroll.errors import expect
from rimroll.laws import Law, contact_law, ideal, one_law
from rimroll.many.rows import elementwise
from rimroll.state import State, single
from rimroll.units import Number, Values, number, values


@dataclass(frozen=True)
class Arrival:
    """The state of a body at the end of its tipping phase, in the limit ε → 0.

    A near-collision under friction depends on the ratios slip/(H ω) and axial_spin/ω.
    """

    tipping_rate: float = 1.0
    """ω = −dφ/dt, rad/s."""
    slip: float = 0.0
    """Velocity of the rim's lowest point, from it toward the base's centre, m/s."""
    axial_spin: float = 0.0
    """s = dθ/dt + dψ/dt cos φ, rad/s, positive in the direction of the turn."""
    friction_ratio: float = math.nan
    """The largest |T|/N on the way down: the friction that tipping needs. NaN if unknown."""

    def __post_init__(self) -> None:
        units = {
            "tipping_rate": "rad/s",
            "slip": "m/s",
            "axial_spin": "rad/s",
            "friction_ratio": "1",
        }
        for name, unit in units.items():
            object.__setattr__(self, name, number(name, getattr(self, name), unit))

    def _numbers(self) -> tuple[float, float, float, float]:
        return self.tipping_rate, self.slip, self.axial_spin, self.friction_ratio


@dataclass(frozen=True)
class Passage:
    """The result of a near-collision, in the limit ε → 0."""

    turn: float
    """The limiting angle of turn, rad."""
    rising_rate: float
    """dφ/dt at the beginning of the rise, rad/s."""
    axial_spin: float
    """s at the beginning of the rise, rad/s, positive in the direction of the turn."""
    slip: tuple[float, float]
    """Slip at the beginning of the rise, m/s: toward the base's centre, and across."""
    energy_lost_fraction: float
    """The fraction of the kinetic energy on arrival that is lost to friction."""


def arrival(
    body: Body, start: State, law: Law, gravity: Number = _core.STANDARD_GRAVITY
) -> Arrival:
    """How a body released at ``start`` comes down, in the limit of ever smaller sideways rates.

    The yaw rate and spin rate of the start are ignored. Raises ``RimrollError`` if the base
    does not come down flat, because the body topples or its rim lifts off on the way.
    """
    one_body(body)
    expect("start", start, State)
    one_law(law)
    return Arrival(*_core.arrival(body, single(start), law, number("gravity", gravity, "m/s^2")))


def turn_limit(body: Body, law: Law, arrival: Arrival | None = None) -> Any:
    """Limiting angle of turn, rad, as the motion comes arbitrarily close to a face-down collision.

    No-slip: π √(J/K) = π √((A + mR² + mH²)/(A + mH²)). Frictionless: π √((A + mR²)/A).

    Source: the paper, Eqs. (15) and (19) of the preprint. Erratum: the last two
    lines of the former print the fraction upside down.

    Other laws: the near-collision is computed numerically, to 3e-8 rad. It depends on the arrival:
    by default the rim is at rest and the body has no spin (see :func:`arrival`). Under ``Stribeck``
    and ``Tabulated`` friction, which contain speeds, it also depends on the tipping rate. Under
    Coulomb friction it is the no-slip angle for μ ≥ ``needed_friction(body)`` and the frictionless
    angle at μ = 0. For a body like the can it decreases steadily in between; a low, wide body may
    turn slightly more under weak friction than without friction. Under friction a body continues
    to turn as it rises, so its whole turn from release to tilt maximum tends to another value.

    Raises ``RimrollError`` if the rim lifts off on the way or at Painlevé's paradox.
    """
    expect("body", body, Body)
    contact_law(law)
    expect("arrival", arrival, Arrival | None)
    numbers = (arrival or Arrival())._numbers()
    return elementwise(lambda body, law: _core.turn_limit(body, law, numbers), body, law)


def passage(body: Body, law: Law, arrival: Arrival | None = None) -> Passage:
    """The near-collision in the limit ε → 0: its turn, and the state of the body after it.

    ``arrival`` and errors are those of :func:`turn_limit`.
    """
    one_body(body)
    one_law(law)
    expect("arrival", arrival, Arrival | None)
    return Passage(*_core.passage(body, law, (arrival or Arrival())._numbers()))


def turn_limit_with_spin(body: Body, axial_spin: Values, tipping_rate: Values) -> Any:
    """Limiting angle without slip, rad, for a body that arrives with a spin about its axis.

    √(J/K) [π + 2 arctan(mHR s/(ω √(JK)))], with s = dθ/dt + dψ/dt cos φ (rad/s, positive in the
    direction of the turn) and ω > 0 the rate of tipping on arrival (rad/s), as long as the rim can
    push and pull. The paper's "independent of initial conditions" is the case s → 0. Close to the
    limit a spin against the turn keeps the rim pressed; with one along it the motion lifts off.
    """
    expect("body", body, Body)
    axial_spin = values("axial_spin", axial_spin, "rad/s")
    tipping_rate = values("tipping_rate", tipping_rate, "rad/s")
    return elementwise(_core.turn_limit_with_spin, body, axial_spin, tipping_rate)


def disk_turn_limit(gyration_ratio: Values) -> Any:
    """Limiting angle of a disk, rad: π √(2 + k²)/k for the radius of gyration kR, k > 0.

    Source: the paper, Eq. (23). It holds with and without friction. Uniform disk:
    k = 1/√2, π√5; ring: k = 1, π√3; it grows without bound as k → 0.
    """
    return elementwise(_core.disk_turn_limit, values("gyration_ratio", gyration_ratio))


def tall_turn_limit(body: Body, law: Law) -> Any:
    """Limiting angle of a tall body to first order in R²/H², rad: π + (π/2) mR²/K'.

    K' = A + mH² without slip, A without friction. Above the exact limit by less than
    (π/8)(mR²/K')². Source: the paper's "Tall thin containers", carried one order further.
    """
    expect("body", body, Body)
    name = ideal(law).name
    return elementwise(lambda body: _core.tall_turn_limit(body, name), body)


def point_mass_turn_limit(radius: Values, height: Values, law: Law) -> Any:
    """Limiting angle of a point mass at ``height`` over the base (A → 0), rad: π √(1 + R²/H²).

    Without friction it grows without bound: infinity.
    """
    name = ideal(law).name
    radius, height = values("radius", radius, "m"), values("height", height, "m")
    return elementwise(
        lambda radius, height: _core.point_mass_turn_limit(radius, height, name), radius, height
    )


def needed_friction(body: Body) -> Any:
    """Friction coefficient needed to roll through the near-collision: μ* = mHR/(A + mH²).

    |T|/N tends to this constant throughout the near-collision, however violent it is. The paper
    shows a finite ratio in its simulation figure and gives no formula.
    """
    expect("body", body, Body)
    return elementwise(_core.needed_friction, body)


def painleve_friction(body: Body) -> Any:
    """Smallest friction coefficient at which Painlevé's paradox can occur: 2 √(q (1 + q)).

    q = A/(m (R² + H²)). Below it the normal force is unique for every direction of slip.
    """
    expect("body", body, Body)
    return elementwise(_core.painleve_friction, body)


def error_law_coefficient(
    body: Body, law: Law, tipping_rate: Values, gravity: Values = _core.STANDARD_GRAVITY
) -> Any:
    """Coefficient b of the error law |Δψ| = limit + φ_c (b ln φ_c + a), dimensionless.

    Δψ is the turn from tilt maximum to tilt maximum and φ_c the smallest tilt (rad) between; a is a
    number of the whole motion. b = −2 √(J'/K') R N_p/(K' ω²), where ω > 0 is the rate of tipping on
    arrival (rad/s) and N_p the normal force then: no-slip J' = J, K' = K, N_p = m(gK/J − Hω²);
    frictionless J' = A + mR², K' = A, N_p = mA(g − Hω²)/(A + mR²). So motions approach the limit
    like ε ln ε, not like a power. Not in the paper.
    """
    expect("body", body, Body)
    name = ideal(law).name
    return elementwise(
        lambda body, *numbers: _core.error_law_coefficient(body, name, *numbers),
        body,
        values("tipping_rate", tipping_rate, "rad/s"),
        values("gravity", gravity, "m/s^2"),
    )


def balance_tilt(body: Body, *, liquid: bool = False) -> Any:
    """Tilt at which the centre of mass is over the rim, rad: arctan(R/H); π/2 for a disk.

    A filling counts as frozen, as it is in motions. With ``liquid`` its surface is level while the
    body is held still: a single body with a :attr:`rimroll.Body.filling` then balances at a smaller
    tilt. The surface may cut the floor of the round vessel, its lid, or both.

    >>> from rimroll import bodies
    >>> can = bodies.soda_can(fill=0.3)
    >>> print([round(math.degrees(balance_tilt(can, liquid=is_liquid)), 3) for is_liquid in (0, 1)])
    [46.667, 35.788]

    Raises ``RimrollError`` for ``liquid`` with a body that has no filling.
    """
    expect("body", body, Body)
    if not liquid:
        return elementwise(_core.balance_tilt, body)
    from rimroll.bodies.body import liquid_balance

    return liquid_balance(body)


def lift_off_rate(body: Body, gravity: Values = _core.STANDARD_GRAVITY) -> Any:
    """Tipping rate on arrival above which a rolling rim lifts off, rad/s: √(gK/(JH)).

    Infinite for a disk. The paper warns that a flick too fast lifts the can off.
    """
    expect("body", body, Body)
    return elementwise(_core.lift_off_rate, body, values("gravity", gravity, "m/s^2"))


def slip_rate(body: Body, gravity: Values = _core.STANDARD_GRAVITY) -> Any:
    """Tipping rate on arrival above which tipping needs more friction than μ*, rad/s.

    √(2mgHK/(J(K + mH²))): the ratio |T|/N at the end of the tipping phase passes μ* there.
    """
    expect("body", body, Body)
    return elementwise(_core.slip_rate, body, values("gravity", gravity, "m/s^2"))
