"""A body, a start and a law as the set-up of the lab's page.

The page reads numbers in units for people. Each is written with as few digits as give the same
number in SI units, so that the page computes the same motion; where no digits do, it differs in
the last bit.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import astuple
from typing import TYPE_CHECKING
from urllib.parse import urlencode

from rimroll import bodies
from rimroll.body import Body, one_body
from rimroll.browser.digits import Pairs, plain, shortest
from rimroll.browser.floor import floor_of
from rimroll.errors import RimrollError, expect
from rimroll.given import Number, number
from rimroll.laws import Coulomb, Frictionless, Law, NoSlip, RollingResistance, one_law
from rimroll.options import FlatLanding, ground_given, landing_given
from rimroll.state import State, single

if TYPE_CHECKING:
    from rimroll.ground.ground import Ground

RING_RADIUS = 0.05
"""Radius of the page's ring, m."""

DEGREE = math.pi / 180.0


def setup_of(
    body: Body | None,
    start: State | None,
    law: Law | None,
    duration: Number | None,
    gravity: Number | None,
    ground: Ground | None = None,
    flat: FlatLanding | None = None,
) -> str:
    """The set-up ``name=value&...`` of what is given; the page has its own values for the rest.

    Raises ``RimrollError`` for arrays, and for a law or a ground that the page does not have.
    """
    pairs: list[tuple[str, str]] = []
    given_ground = ground_given(ground)
    landing = landing_given(flat, given_ground is not None)
    if body is not None:
        pairs += _body(one_body(body))
    if start is not None:
        expect("start", start, State)
        begin = single(start)
        if begin.tilt == 0.0 and given_ground is None:
            raise RimrollError("start stands flat, which the lab shows on a ground that moves only")
        pairs += _start(begin)
    if law is not None:
        pairs += _law(one_law(law))
    for name, given, unit in (("gravity", gravity, "m/s^2"), ("duration", duration, "s")):
        if given is not None:
            pairs.append((name, plain(number(name, given, unit))))
    if given_ground is not None:
        pairs += floor_of(given_ground, landing, None if start is None else single(start))
    return urlencode(pairs)


def _body(body: Body) -> Pairs:
    for name, preset in bodies.PRESETS.items():
        if body == (bodies.ring(RING_RADIUS) if name == "ring" else preset()):
            yield "body", name
            return
    for name, filled in (("soda_can", bodies.soda_can), ("beer_bottle", bodies.beer_bottle)):
        percent = _fill(body, filled)
        if percent is not None:
            yield "body", name
            yield "fill", percent
            return
    mass = body.mass
    yield "body", "inertia"
    yield "mass", shortest(mass, 1000.0 * mass, lambda shown: shown / 1000.0)
    for name, length in (("radius", body.radius), ("height", body.height)):
        yield name, shortest(length, 100.0 * length, lambda shown: shown / 100.0)
    for name, inertia in (("transverse", body.transverse_inertia), ("axial", body.axial_inertia)):
        per_mass = 1e4 * inertia / mass
        yield name, shortest(inertia, per_mass, lambda shown: mass * shown / 1e4)


def _fill(body: Body, filled: Callable[[float], Body]) -> str | None:
    """How full a can or bottle is if it is this body, in percent."""
    empty, full = filled(0.0), filled(1.0)
    if body.radius != empty.radius or not empty.mass <= body.mass <= full.mass:
        return None
    percent = 100.0 * (body.mass - empty.mass) / (full.mass - empty.mass)
    shown = shortest(body, percent, lambda shown: filled(min(shown / 100.0, 1.0)))
    found = filled(float(shown) / 100.0)
    pairs = zip(astuple(found), astuple(body), strict=True)
    same = all(math.isclose(one, other, rel_tol=1e-12) for one, other in pairs)
    return shown if same else None


def _start(start: State[float]) -> Pairs:
    if start.tilt == 0.0:
        yield "yaw", _yaw(start)
        return
    sin, cos = math.sin(start.tilt), math.cos(start.tilt)
    # The page has the rates about the line along which the body leans and about the vertical.
    sideways = shortest(start.spin_rate, -start.spin_rate * sin, lambda shown: -shown / sin)
    by_sideways = float(sideways) * cos / sin
    twist = shortest(
        start.yaw_rate, start.yaw_rate - by_sideways, lambda shown: shown + by_sideways
    )
    yield "tilt", shortest(start.tilt, start.tilt / DEGREE, lambda shown: shown * DEGREE)
    yield "tilt_rate", plain(start.tilt_rate)
    yield "sideways", sideways
    yield "twist", twist
    yield "yaw", _yaw(start)


def _yaw(start: State[float]) -> str:
    degrees = math.remainder(start.yaw / DEGREE, 360.0)
    return shortest(start.yaw, degrees, lambda shown: shown * DEGREE)


def _law(law: Law) -> Pairs:
    if isinstance(law, Coulomb):
        if law.static not in (None, law.friction):
            raise _missing(law, "one coefficient for sticking and sliding")
        yield "friction", plain(law.friction)
        yield "restitution", plain(law.restitution)
    elif not isinstance(law, NoSlip | Frictionless):
        raise _missing(law, "NoSlip, Frictionless and Coulomb")
    yield "law", law.name
    for resistance in law.resistances:
        if not isinstance(resistance, RollingResistance) or resistance.viscous:
            raise _missing(law, "dry rolling resistance alone")
        yield "rolling", plain(resistance.dry)


def _missing(law: Law, known: str) -> RimrollError:
    return RimrollError(f"law cannot be shown in the lab, which has {known}, got {law!r}")
