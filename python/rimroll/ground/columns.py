"""Records in tables of text: names and units of columns, directions and components."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from rimroll.errors import RimrollError, UnitError
from rimroll.files.table import Table, table_of
from rimroll.files.titles import (
    Title,
    columns_given,
    expect_step,
    seconds_of,
    time_column,
    titles_of,
)
from rimroll.ground.pulses import along
from rimroll.units import Number, factor_of, number, positive

Array = NDArray[np.float64]

UNEVEN = 0.2
"""How far, in steps, a time may be from its place: times are rounded where they are written."""

_IN_WORD = re.compile(r"(?:a|acc|accel|acceleration)([xyz])|([xyz])(?:acc|accel|acceleration)")
_OTHER = re.compile(
    r"\b(vel(ocity)?|v[xyz]?|disp(l(acement)?)?|d[xyz]?|u[xyz]?|index|no|number|sample|absolute"
    r"|magnitude|norm|temp(erature)?|total|resultant)\b"
)
"""Columns that hold no component of the acceleration."""


@dataclass(frozen=True)
class Layout:
    """What a user says of the columns of a table; arguments as for :func:`rimroll.ground.read`."""

    units: str | None = None
    component: str | None = None
    columns: Mapping[str, str | int] | None = None
    step: Number | None = None
    time_unit: str | None = None

    def expect_none_of_tables(self, name: str) -> None:
        """Raise ``RimrollError`` for what does not go with the AT2 file of this name."""
        for field in ("columns", "step", "time_unit"):
            if getattr(self, field) is not None:
                raise RimrollError(
                    f"{field} is for tables: {name} is an AT2 file, whose header says its step"
                )


class Columns(NamedTuple):
    """The record in a table."""

    step: float
    """s."""
    samples: Array
    """(n, 3), m/s²."""
    is_compass: bool
    """Whether x points east and y north."""


def columns_of(name: str, text: str, layout: Layout) -> Columns:
    """The record in the columns of a text.

    Raises ``RimrollError``, with file and line, for what does not read as such a table.
    """
    table = table_of(name, text, has_columns=True)
    given = columns_given(table, layout.columns, ("t", "x", "y", "z"))
    titles = titles_of(table)
    t = _time(table, titles, layout, given)
    axes = {axis: given[axis] for axis in "xyz" if axis in given}
    is_compass = False
    if axes and layout.component is not None:
        raise RimrollError("component and columns both say the axis: give one")
    if not axes:
        axes, is_compass = _found(table, titles, t, layout)
    if len(table.rows) < 2:
        raise RimrollError(f"{name} must have at least 2 samples, it has {len(table.rows)}")
    samples = sum(
        along(axis, _numbers(table, i) * _factor(table, i, titles[i], layout.units))
        for axis, i in axes.items()
    )
    if layout.step is not None:
        step = positive("step", layout.step, "s")
        expect_step(f"{name}: step", RECORD, step, is_stated=True)
    else:
        assert t is not None
        seconds, is_stated = seconds_of(_line_1(table), titles[t], layout.time_unit)
        step = _step(table, _since_first(table, t) * seconds, is_stated)
    return Columns(step, np.asarray(samples), is_compass)


def _line_1(table: Table) -> str:
    return f"{table.name}, line {table.titles_line}"


def _time(table: Table, titles: list[Title], layout: Layout, given: dict[str, int]) -> int | None:
    """The column of times; None where the step is given."""
    if layout.step is not None:
        if "t" in given or any(one.is_time for one in titles):
            raise RimrollError(f"step is for files without times, and {table.name} has a column")
        if layout.time_unit is not None:
            raise RimrollError("time_unit is for files with times, not with step")
        return None
    if "t" in given:
        return given["t"]
    if not table.titles:
        raise RimrollError(
            f"{table.name}: the first line must name the columns, with units, as in"
            " t (s), ax (m/s2), ay (m/s2), az (m/s2); or give columns by their numbers, as in"
            ' columns={"t": 1, "x": 2} (on the command line --columns t=1,x=2), or the step of a'
            ' single one, as in step="0.01 s" (--step 0.01s)'
        )
    return time_column(table)


def _found(
    table: Table, titles: list[Title], t: int | None, layout: Layout
) -> tuple[dict[str, int], bool]:
    """The columns of accelerations by axis, and whether they are those of the compass."""
    others = [i for i, one in enumerate(titles) if i != t and not (t is not None and one.is_time)]
    found = [i for i in others if _may_be_acceleration(titles[i])] or others
    if len(found) == 1:
        axis, is_compass = _axis(titles[found[0]].name) or ("x", False)
        axis = layout.component or axis
        return {axis: found[0]}, is_compass and layout.component is None
    if layout.component is not None:
        raise RimrollError(f"component is for a single one, and {table.name} has {len(found)}")
    axes = [_axis(titles[i].name) for i in found]
    named = [axis[0] for axis in axes if axis is not None]
    if len(named) < len(found) or len(set(named)) < len(named) or not named:
        have = ", ".join(table.titles) or f"{table.width} columns without titles"
        raise RimrollError(
            f"{table.name} needs columns ax, ay and az, or one of accelerations; it has {have}: say"
            ' which, as in columns={"t": 1, "x": 2} (on the command line --columns t=1,x=2)'
        )
    compass = {axis[1] for axis in axes if axis is not None and axis[0] != "z"}
    if len(compass) > 1:
        raise RimrollError(f"{table.name} mixes x or y with E or N: {', '.join(table.titles)}")
    return dict(zip(named, found, strict=True)), True in compass


def _may_be_acceleration(title: Title) -> bool:
    """Whether a column may hold a component of the acceleration, by its unit or by its name."""
    if _OTHER.search(title.name):
        return False
    if title.unit is None:
        return True
    try:
        factor_of_unit(title.unit, "unit")
    except UnitError:
        return False
    return True


def _axis(name: str) -> tuple[str, bool] | None:
    """The axis that the words of a name say, and whether it is one of the compass."""
    words = name.split()
    found = {axis for word in words if (axis := axis_of_channel(word)) is not None}
    if not found:
        parts = [_IN_WORD.fullmatch(word) for word in words]
        found = {(part[1] or part[2], False) for part in parts if part}
    return found.pop() if len(found) == 1 else None


def _factor(table: Table, place: int, title: Title, units: str | None) -> float:
    column = table.titles[place] if table.titles else f"column {place + 1}"
    if title.unit is None:
        if units is None:
            raise UnitError(
                f"{_line_1(table)}: the column {column} has no unit: write {column} (m/s2), or give"
                ' units="m/s2" (on the command line --units m/s2)'
            )
        return factor_of_unit(units, "units")
    factor = factor_of_unit(title.unit, f"{_line_1(table)}: the unit of {column}")
    if units is not None and factor != factor_of_unit(units, "units"):
        raise UnitError(
            f'{_line_1(table)}: the unit of {column} is {title.unit}, but units is "{units}"'
        )
    return factor


def _numbers(table: Table, place: int) -> Array:
    """The cells of a column as numbers, (n,)."""
    values = np.empty(len(table.rows))
    for i, row in enumerate(table.rows):
        try:
            values[i] = float(row.cells[place])
        except ValueError:
            values[i] = np.nan
        if not np.isfinite(values[i]):
            raise RimrollError(f'{table.name}, line {row.line}: "{row.cells[place]}" is no number')
    return values


def _since_first(table: Table, place: int) -> Array:
    """The times of a column since the first one; exact for whole numbers of any length."""
    cells: Sequence[str] = [row.cells[place] for row in table.rows]
    if all(cell.isdecimal() for cell in cells):
        return np.array([int(cell) - int(cells[0]) for cell in cells], np.float64)
    times = _numbers(table, place)
    return np.asarray(times - times[0])


def _step(table: Table, times: Array, is_stated: bool) -> float:
    """The step of even times, s."""
    steps = np.diff(times)
    usual = float(np.median(steps))
    mean = times[-1] / len(steps)
    off = times - mean * np.arange(len(times))
    if not (steps > 0.0).all():
        line = table.rows[int((steps <= 0.0).argmax()) + 1].line
        raise RimrollError(f"{table.name}, line {line}: the time is not after the one before")
    uneven = np.abs(steps - usual) > UNEVEN * usual
    if not uneven.any():
        uneven = np.abs(off[1:]) > UNEVEN * usual
    expect_step(_line_1(table), RECORD, usual, is_stated)
    if uneven.any():
        place = int(uneven.argmax())
        raise RimrollError(
            f"{table.name}, line {table.rows[place + 1].line}: the time is {steps[place]:g} s after"
            f" the one before, where most steps are {usual:g} s; a record needs equal steps"
        )
    return float(f"{mean:.12g}")


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
