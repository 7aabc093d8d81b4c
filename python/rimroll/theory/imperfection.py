"""The theory that the paper rejects: a rim, or a table, with an imperfection."""

from __future__ import annotations

from dataclasses import dataclass

from rimroll import _core
from rimroll.bodies.body import Body, one_body
from rimroll.laws import Law, ideal
from rimroll.units import Number, number


@dataclass(frozen=True)
class Collision:
    """A plastic collision of one more point of the rim, while another rests on the table.

    Azimuths are counted round the rim from the point A on which the body came down, in the
    direction of the imperfection's angle, rad between 0 and 2π.
    """

    azimuth: float
    """Azimuth of the point that strikes."""
    scaled_tilt: float
    """The tilt at the collision, in units of (height of the imperfection)/R."""
    impulse: float
    """The table's upward impulse at the point that strikes, N s."""
    held_impulse: float
    """The table's upward impulse at the point that rested on the table, N s; 0 if it lifts off."""
    lean_azimuth: float | None
    """Azimuth toward which the lean moves after the collision; None for a body that stops."""
    lean_rate: float
    """Rate of the lean after the collision, rad/s."""
    vertical_velocity: float
    """Upward velocity of the centre of mass after the collision, m/s; negative if it sinks."""
    energy_kept_fraction: float
    """The fraction of the kinetic energy on arrival that is left."""


@dataclass(frozen=True)
class ImperfectRim:
    """The result of a fall on an imperfection of the rim; see :func:`imperfect_rim`."""

    turn: float | None
    """The angle between the leans before and after, rad; None for a body that stops."""
    rising_rate: float
    """dφ/dt at the beginning of the rise, rad/s."""
    energy_kept_fraction: float
    """The fraction of the kinetic energy on arrival that is left."""
    collisions: tuple[Collision, ...]
    """The collisions, one or two."""


def imperfect_rim(body: Body, angle: Number, law: Law, tipping_rate: Number = 1.0) -> ImperfectRim:
    """Let a body fall exactly face down on a rim with one imperfection.

    The body tips about the point A of its rim. The point B at ``angle`` (β) round the rim from A,
    or the table under it, stands out a little and strikes first. All collisions are plastic: what
    strikes comes to rest without rebound, and the table never pulls. The outcome is the limit of a
    small imperfection on a rim that is perfect elsewhere, where neither its height nor gravity
    matters. With K' = A + mH² without slip, A without friction, and J' = K' + mR²:

    * B strikes. When K' + mR² cos β ≥ 0, A lifts off, and the part mR² K' (1 − cos β)²/J'² of the
      energy is lost; else A and B both hold. Not to slip asks for :func:`rimroll.needed_friction`.
    * The body rotates about B until a point C of the rim strikes, at χ from B with
      cot(χ/2) = (K' − mR²)/J' tan(β/2).
    * For K' ≥ mR² (all but flat bodies) B lifts off and the rim rolls on from C, as in the
      near-collision. For K' < mR² the body rocks over the chord BC first, and the turn is β plus a
      number of the body, for β < π.

    At β = π the turn is π and the tipping rate falls by the factor (K' − mR²)/(K' + mR²), as for
    a rocking block; bodies with K' ≤ mR² stop.

    Source: the paper's "Candidate theories for symmetry breaking" names this theory and rejects it
    without computing it: the outcome depends on where the imperfection is. (The other theory named
    there is the whole base slapping the table at once, which no rigid-body law determines.)

    Parameters
    ----------
    body, law
        What falls, and how its rim meets the table.
    angle
        β, rad, inside (0, 2π). The turn is counted in the same direction.
    tipping_rate
        ω > 0, rad/s: |dφ/dt| on arrival. Rates and impulses are in proportion to it.

    Raises
    ------
    RimrollError
        An angle outside (0, 2π), a tipping rate outside 1e-60 to 1e60.

    Examples
    --------
    >>> import numpy as np, rimroll as rr
    >>> fall = rr.imperfect_rim(rr.bodies.can_2007(), np.radians(120.0), rr.NoSlip())
    >>> round(float(np.degrees(fall.turn)), 2), round(fall.energy_kept_fraction, 3)
    (195.53, 0.553)
    """
    one_body(body)
    turn, rising_rate, energy_kept_fraction, collisions = _core.imperfect_rim(
        body,
        number("angle", angle, "rad"),
        ideal(law).name,
        number("tipping_rate", tipping_rate, "rad/s"),
    )
    return ImperfectRim(
        turn, rising_rate, energy_kept_fraction, tuple(Collision(*c) for c in collisions)
    )
