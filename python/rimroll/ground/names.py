"""Units, directions and components as files of records write them."""

from __future__ import annotations

import math
import re

from rimroll.errors import RimrollError, UnitError
from rimroll.given import number
from rimroll.units import factor_of

UP, DOWN = "up", "down"

Direction = float | str
"""A heading, rad clockwise from north; :data:`UP` or :data:`DOWN`."""

_VERTICAL = {
    **dict.fromkeys(("up", "updn", "ud", "ver", "vert", "vertical", "v", "z"), UP),
    **dict.fromkeys(("dn", "dwn", "down"), DOWN),
}
_COMPASS = {"n": 0.0, "ns": 0.0, "e": 90.0, "ew": 90.0, "s": 180.0, "sn": 180.0}
_COMPASS |= {"w": 270.0, "we": 270.0}
_QUADRANT = re.compile(r"([ns])(\d{1,2})([ew])")
_DEGREES = re.compile(r"(\d{1,3}(?:\.\d*)?)(?:\s*(?:deg|°))?")
_SECONDS = re.compile(r"\b(?:seconds?|sec)\b")


def factor_of_unit(unit: str, field: str) -> float:
    """The factor from a unit of acceleration to m/s²: ``g``, ``gal``, ``cm/s2``, ``CM/SEC/SEC``.

    Raises ``RimrollError`` for what is no unit of acceleration.
    """
    if not isinstance(unit, str):
        raise UnitError(f'{field} must be a unit such as "g" or "m/s2", got {unit!r}')
    spelled = _SECONDS.sub("s", unit.strip().lower().replace("'s", ""))
    spelled = spelled.replace("**", "").replace("^", "").replace("²", "2").replace("s/s", "s2")
    try:
        return factor_of(spelled, "m/s^2", field, unit)
    except UnitError:
        example = 'a unit of acceleration such as "g", "gal" or "m/s2"'
        raise UnitError(f'{field} must be {example}, got "{unit}"') from None


def direction_of(text: str) -> Direction | None:
    """The direction that a text names, as in line 2 of an AT2 file; None if it names none.

    >>> direction_of("UP"), direction_of("N-S"), round(direction_of("S69E"), 4)
    ('up', 0.0, 1.9373)
    """
    word = text.strip().lower()
    bare = word.replace("-", "").replace(" ", "")
    if bare in _VERTICAL:
        return _VERTICAL[bare]
    if bare in _COMPASS:
        return math.radians(_COMPASS[bare])
    if quadrant := _QUADRANT.fullmatch(bare):
        pole, angle, side = quadrant[1], float(quadrant[2]), quadrant[3]
        from_north = angle if pole == "n" else 180.0 - angle
        return math.radians((from_north if side == "e" else -from_north) % 360.0)
    if degrees := _DEGREES.fullmatch(word):
        angle = float(degrees[1])
        return math.radians(angle % 360.0) if angle <= 360.0 else None
    return None


def given_direction(field: str, value: object) -> Direction:
    """A direction as users give it: a text as above, or an angle in rad or with a unit.

    Raises ``RimrollError`` for anything else.
    """
    named = direction_of(value) if isinstance(value, str) else None
    if named is not None:
        return named
    kinds = 'must be "up", "down" or a heading such as "230 deg" or "N40E"'
    if isinstance(value, str) and not re.match(r"\s*[-+.\d]", value):
        raise RimrollError(f'{field} {kinds}, got "{value}"')
    angle = number(field, value, "rad")
    if not abs(angle) <= math.tau:
        raise RimrollError(f'{field} {kinds}, got {angle:g} rad: for degrees write "{angle:g} deg"')
    return angle % math.tau
