"""Records in tables of text, with units in the names of their columns."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from rimroll.errors import RimrollError, UnitError
from rimroll.given import Number, positive
from rimroll.ground.names import RECORD, axis_of_channel, factor_of_unit
from rimroll.ground.records import along
from rimroll.table import Table, table_of
from rimroll.titles import (
    Title,
    columns_given,
    expect_step,
    seconds_of,
    time_column,
    titles_of,
)

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
