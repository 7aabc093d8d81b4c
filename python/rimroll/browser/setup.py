"""A body, a start and a law as the set-up of the lab's page.

The page reads numbers in units for people. Each is written with as few digits as give the same
number in SI units, so that the page computes the same motion; where no digits do, it differs in
the last bit.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import astuple
from typing import TypeVar
from urllib.parse import urlencode

from rimroll import bodies
from rimroll.body import Body, one_body
from rimroll.errors import RimrollError, expect
from rimroll.given import Number, number
from rimroll.laws import Coulomb, Frictionless, Law, NoSlip, RollingResistance, one_law
from rimroll.state import State, single

T = TypeVar("T")
Pairs = Iterator[tuple[str, str]]

RING_RADIUS = 0.05
"""Radius of the page's ring, m."""

DEGREE = math.pi / 180.0


def setup_of(
    body: Body | None,
    start: State | None,
    law: Law | None,
    duration: Number | None,
    gravity: Number | None,
) -> str:
    """The set-up ``name=value&...`` of what is given; the page has its own values for the rest.

    Raises ``RimrollError`` for arrays, and for a law that the page does not have.
    """
    pairs: list[tuple[str, str]] = []
    if body is not None:
        pairs += _body(one_body(body))
    if start is not None:
        expect("start", start, State)
        pairs += _start(single(start))
    if law is not None:
        pairs += _law(one_law(law))
    for name, given, unit in (("gravity", gravity, "m/s^2"), ("duration", duration, "s")):
        if given is not None:
            pairs.append((name, _plain(number(name, given, unit))))
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
    yield "mass", _shortest(mass, 1000.0 * mass, lambda shown: shown / 1000.0)
    for name, length in (("radius", body.radius), ("height", body.height)):
        yield name, _shortest(length, 100.0 * length, lambda shown: shown / 100.0)
    for name, inertia in (("transverse", body.transverse_inertia), ("axial", body.axial_inertia)):
        per_mass = 1e4 * inertia / mass
        yield name, _shortest(inertia, per_mass, lambda shown: mass * shown / 1e4)


def _fill(body: Body, filled: Callable[[float], Body]) -> str | None:
    """How full a can or bottle is if it is this body, in percent."""
    empty, full = filled(0.0), filled(1.0)
    if body.radius != empty.radius or not empty.mass <= body.mass <= full.mass:
        return None
    percent = 100.0 * (body.mass - empty.mass) / (full.mass - empty.mass)
    shown = _shortest(body, percent, lambda shown: filled(min(shown / 100.0, 1.0)))
    found = filled(float(shown) / 100.0)
    pairs = zip(astuple(found), astuple(body), strict=True)
    same = all(math.isclose(one, other, rel_tol=1e-12) for one, other in pairs)
    return shown if same else None


def _start(start: State[float]) -> Pairs:
    sin, cos = math.sin(start.tilt), math.cos(start.tilt)
    # The page has the rates about the line along which the body leans and about the vertical.
    sideways = _shortest(start.spin_rate, -start.spin_rate * sin, lambda shown: -shown / sin)
    by_sideways = float(sideways) * cos / sin
    twist = _shortest(
        start.yaw_rate, start.yaw_rate - by_sideways, lambda shown: shown + by_sideways
    )
    yaw = math.remainder(start.yaw / DEGREE, 360.0)
    yield "tilt", _shortest(start.tilt, start.tilt / DEGREE, lambda shown: shown * DEGREE)
    yield "tilt_rate", _plain(start.tilt_rate)
    yield "sideways", sideways
    yield "twist", twist
    yield "yaw", _shortest(start.yaw, yaw, lambda shown: shown * DEGREE)


def _law(law: Law) -> Pairs:
    if isinstance(law, Coulomb):
        if law.static not in (None, law.friction):
            raise _missing(law, "one coefficient for sticking and sliding")
        yield "friction", _plain(law.friction)
        yield "restitution", _plain(law.restitution)
    elif not isinstance(law, NoSlip | Frictionless):
        raise _missing(law, "NoSlip, Frictionless and Coulomb")
    yield "law", law.name
    for resistance in law.resistances:
        if not isinstance(resistance, RollingResistance) or resistance.viscous:
            raise _missing(law, "dry rolling resistance alone")
        yield "rolling", _plain(resistance.dry)


def _missing(law: Law, known: str) -> RimrollError:
    return RimrollError(f"law cannot be shown in the lab, which has {known}, got {law!r}")


def _shortest(value: T, shown: float, read: Callable[[float], T]) -> str:
    """The text with the fewest digits near ``shown`` that the page reads as the value."""
    for digits in range(1, 18):
        rounded = float(f"{shown:.{digits}g}")
        if read(rounded) == value:
            return _plain(rounded)
    return _plain(shown)


def _plain(value: float) -> str:
    return repr(value + 0.0).removesuffix(".0")  # 0.0 for -0.0
