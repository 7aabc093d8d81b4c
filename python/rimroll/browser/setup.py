"""A body, a start, a law and a ground as the set-up of the lab's page, checked before it opens.

The page reads numbers in units for people. Each is written with as few digits as give the same
number in SI units, so that the page computes the same motion; where no digits do, it differs in
the last bit.
"""

from __future__ import annotations

import json
import math
import re
from collections.abc import Callable, Iterator
from dataclasses import astuple
from pathlib import Path
from typing import Any, TypeVar
from urllib.parse import parse_qsl, urlencode

from rimroll import bodies
from rimroll.bodies.body import Body, one_body
from rimroll.errors import RimrollError, expect, nearest
from rimroll.ground.ground import Ground
from rimroll.ground.pulses import CALM
from rimroll.laws import Coulomb, Frictionless, Law, NoSlip, RollingResistance, one_law
from rimroll.options import FlatLanding, ground_given, landing_given
from rimroll.state import State, single
from rimroll.units import Number, number

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


_DECIMAL = re.compile(r"[+-]?(Infinity|([0-9]+\.?[0-9]*|\.[0-9]+)([eE][+-]?[0-9]+)?)")
_OTHER_BASE = re.compile(r"0([xX][0-9a-fA-F]+|[oO][0-7]+|[bB][01]+)")
"""The two make up what JavaScript's ``Number`` takes, which is less than Python's ``float``."""

_THOUSANDS = re.compile(r"[-+\N{MINUS SIGN}]?[1-9][0-9]{0,2}(,[0-9]{3})+")


def check(setup: str, page: Path) -> None:
    """Raise ``RimrollError`` for a set-up with a name or a value that the built page does not take.

    ``setup`` is ``name=value&...`` as in the page's address; what the page takes is in its
    ``setup.json``.
    """
    table = page / "setup.json"
    if not table.is_file():
        raise RimrollError("the page is older than this rimroll; in its source tree, run: make web")
    quantities = json.loads(table.read_text(encoding="utf-8"))
    for name, value in parse_qsl(setup, keep_blank_values=True):
        if name not in quantities:
            raise RimrollError(f"there is no quantity {name!r}{nearest(name, quantities)}")
        _check_value(name, value, quantities[name])


def _check_value(name: str, value: str, allowed: dict[str, Any]) -> None:
    if "choices" in allowed:
        if value not in allowed["choices"]:
            raise RimrollError(f"{name} cannot be {value!r}{nearest(value, allowed['choices'])}")
        return
    if "pattern" in allowed:
        if not re.fullmatch(allowed["pattern"], value):
            raise RimrollError(f"{name} is not one that the page has written")
        return
    low, high, unit = allowed["min"], allowed["max"], allowed["unit"]
    number = _number(value, unit)
    if number is None:
        raise RimrollError(field=name, value=value, bound="a number")
    if allowed["whole"] and not number.is_integer():
        raise RimrollError(field=name, value=value, bound="a whole number")
    inside = low < number < high if allowed["open"] else low <= number <= high
    if not inside:
        bounds = "between" if allowed["open"] else "from"
        joint = "and" if allowed["open"] else "to"
        in_unit = f" ({unit})" if unit else ""
        raise RimrollError(field=name, value=value, bound=f"{bounds} {low} {joint} {high}{in_unit}")


def _number(text: str, unit: str) -> float | None:
    """The number that the page reads, as ``read`` of web/src/setup/setup.ts; None if it refuses.

    One comma may be a decimal point, and the unit may be there or not. What may be thousands with
    commas between them, such as ``1,000``, is refused.
    """
    bare = text.strip().removesuffix(unit).strip() if unit else text.strip()
    if _THOUSANDS.fullmatch(bare):
        return None
    plain = bare.replace(",", ".", 1).replace("\N{MINUS SIGN}", "-")
    if _DECIMAL.fullmatch(plain):
        return float(plain)
    return _whole(plain) if _OTHER_BASE.fullmatch(plain) else None


def _whole(text: str) -> float:
    try:
        return float(int(text, 0))
    except OverflowError:
        return math.inf


T = TypeVar("T")
Pairs = Iterator[tuple[str, str]]


def shortest(value: T, shown: float, read: Callable[[float], T]) -> str:
    """The text with the fewest digits near ``shown`` that the page reads as the value."""
    for digits in range(1, 18):
        rounded = float(f"{shown:.{digits}g}")
        if read(rounded) == value:
            return plain(rounded)
    return plain(shown)


def plain(value: float) -> str:
    """All digits of a number."""
    return repr(value + 0.0).removesuffix(".0")  # 0.0 for -0.0


FLAT = ("stop", "smooth_left", "smooth_right", "housner")
"""What the lab has for a base that comes down flat."""


def floor_of(ground: Ground, flat: FlatLanding, start: State[float] | None) -> Pairs:
    """The set-up of the floor.

    Raises ``RimrollError`` for a ground that is not one pulse, and for a ``flat`` that the lab does
    not have.
    """
    if flat not in FLAT:
        raise RimrollError(
            f"flat cannot be shown in the lab, which has {', '.join(FLAT)}, got {flat!r}"
        )
    pulses = ground.core.pulses()
    if ground.core.samples() is not None or len(pulses) != 1:
        raise _missing_of_floor(ground)
    ((kind, (x, y, z), period, duration, center),) = pulses
    if kind == "ricker" and (center, duration) != (CALM * period, CALM * period + CALM * period):
        raise _missing_of_floor(ground)
    yield "floor", "pulse"
    yield "pulse", "rectangular" if kind == "constant" else kind
    yield "shake", plain(math.hypot(x, y))
    yield "direction", plain(math.degrees(math.atan2(y, x)))
    yield "vertical", plain(z)
    yield "period", plain(duration if kind == "constant" else period)
    if kind in ("sine", "cosine"):
        yield "cycles", shortest(duration, duration / period, lambda shown: shown * period)
    yield "flat", str(flat)
    if start is not None and start.tilt == 0.0:
        yield "start", "standing"


def _missing_of_floor(ground: Ground) -> RimrollError:
    return RimrollError(
        "ground cannot be shown in the lab, which has one pulse with the same times in x, y and z,"
        f" and no records, got {ground!r}: a film shows any ground (motion.film)"
    )
