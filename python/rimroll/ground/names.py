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
_UNSAID = {
    **dict.fromkeys(("l", "ln", "lon", "long", "longitudinal", "h1", "x"), "x"),
    **dict.fromkeys(("t", "tr", "tran", "trans", "transverse", "h2", "y"), "y"),
}
_CHANNEL = re.compile(r"[a-z][nlhg]([enz])")
"""A code of band, instrument and orientation, as in HNE."""

RECORD = "record of an earthquake"
STRONGEST = 1e3
"""The largest acceleration of a record, m/s²: 100 times gravity."""

_QUADRANT = re.compile(r"([ns])(\d{1,2})([ew])")
_DEGREES = re.compile(r"(\d{1,3}(?:\.\d*)?)(?:\s*(?:deg|°))?")
_SECONDS = re.compile(r"\b(?:seconds?|sec)\b")


def factor_of_unit(unit: str, field: str) -> float:
    """The factor from a unit of acceleration to m/s²: ``g``, ``gal``, ``cm/s2``, ``CM/SEC/SEC``.

    Raises ``RimrollError`` for what is no unit of acceleration.
    """
    if not isinstance(unit, str):
        raise UnitError(field=field, value=unit, bound='a unit such as "g" or "m/s2"')
    spelled = _SECONDS.sub("s", unit.strip().lower().replace("'s", ""))
    spelled = spelled.replace("**", "").replace("^", "").replace("²", "2").replace("s/s", "s2")
    try:
        return factor_of(spelled, "m/s^2", field, unit)
    except UnitError:
        example = 'a unit of acceleration such as "g", "gal" or "m/s2"'
        raise UnitError(f'must be {example}, got "{unit}"', field, unit, example) from None


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


def axis_of(text: str) -> str | None:
    """The axis of a component whose direction is not known: x for L and H1, y for T and H2."""
    return _UNSAID.get(text.strip().lower())


def axis_of_channel(name: str) -> tuple[str, bool] | None:
    """The axis of a channel, or of a column's name, and whether it is one of the compass.

    E is x, N is y, Z is z; or X, Y, Z. K-NET and KiK-net write EW, NS and UD, the latter with 1
    (in the borehole) or 2 (at the surface) behind them; codes of channels end with the letter.

    >>> axis_of_channel("HNE"), axis_of_channel("NS2"), axis_of_channel("HN1")
    (('x', True), ('y', True), None)
    """
    word = name.strip().lower().replace("-", "")
    axes = {"e": "x", "ew": "x", "east": "x", "n": "y", "ns": "y", "north": "y"}
    vertical = ("z", "ud", "updn", "up", "vertical")
    bare = word[:-1] if re.fullmatch(r"(ew|ns|ud)[12]", word) else word
    code = _CHANNEL.fullmatch(word)
    letter = code[1] if code else bare
    if letter in axes:
        return axes[letter], True
    if letter in vertical:
        return "z", False
    return (letter, False) if letter in ("x", "y") else None


def expect_strength(where: str, peak: float) -> None:
    """Raise ``RimrollError`` for a peak (m/s²) that no record has: counts, or another unit."""
    if not peak <= STRONGEST:
        raise RimrollError(
            f"{where}: its largest acceleration, {peak:.3g} m/s², is above {STRONGEST:g} m/s²,"
            " which no record reaches: check the unit, and whether the samples are counts"
        )


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
