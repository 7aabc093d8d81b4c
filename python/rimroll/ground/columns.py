"""Records in tables of text, with units in the names of their columns."""

from __future__ import annotations

import re
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from rimroll.errors import RimrollError, UnitError
from rimroll.ground.names import factor_of_unit
from rimroll.ground.records import along
from rimroll.table import Table, table_of
from rimroll.units import factor_of

Array = NDArray[np.float64]

UNEVEN = 0.2
"""How far, in steps, a time may be from its place: times are rounded where they are written."""

_TIME = re.compile(r"t|time|zeit")
_UNIT_AT_END = re.compile(r"(.*?)\s*[\[(]\s*([^\[\]()]*?)\s*[\])]")
_ACCELERATION = r"(?:a|acc|accel|acceleration)"
_AXIS_LAST = re.compile(rf"{_ACCELERATION}?[\s_.-]*([xyz])")
_AXIS_FIRST = re.compile(rf"([xyz])[\s_.-]*{_ACCELERATION}")


class Columns(NamedTuple):
    """The record in a table."""

    step: float
    """s."""
    samples: Array
    """(n, 3), m/s²."""


def columns_of(name: str, text: str, units: str | None, component: str | None) -> Columns:
    """The record in the columns of a text; arguments as for :func:`rimroll.ground.read`.

    Raises ``RimrollError``, with file and line, for what does not read as such a table.
    """
    table = table_of(name, text, has_columns=True)
    if not table.titles:
        raise RimrollError(
            f"{name}: the first line must name the columns, with units, as in"
            " t (s), ax (m/s2), ay (m/s2), az (m/s2)"
        )
    titles = [_split(title) for title in table.titles]
    times = [i for i, (title, _) in enumerate(titles) if _TIME.fullmatch(title)]
    if len(times) != 1:
        raise RimrollError(
            f"{name} needs one column of times, t (s); it has {', '.join(table.titles)}"
        )
    others = [i for i in range(table.width) if i != times[0]]
    values = _numbers(table)
    step = _step(table, values[:, times[0]] * _seconds(name, titles[times[0]]))
    accelerations = {i: values[:, i] * _factor(name, titles[i], units) for i in others}
    if len(others) == 1:
        (only,) = others
        alone = component or _axis(titles[only][0]) or "x"
        return Columns(step, along(alone, accelerations[only]))
    if component is not None:
        raise RimrollError(f"component is for a single one, and {name} has {len(others)}")
    samples = np.zeros((len(values), 3))
    axes = [_axis(titles[i][0]) for i in others]
    if None in axes or len(set(axes)) < len(axes) or not axes:
        raise RimrollError(
            f"{name} needs columns ax, ay and az, or one of any name; it has"
            f" {', '.join(table.titles)}"
        )
    for i, axis in zip(others, axes, strict=True):
        samples[:, "xyz".index(str(axis))] = accelerations[i]
    return Columns(step, samples)


def _split(title: str) -> tuple[str, str | None]:
    """The name of a column in small letters, and its unit."""
    parts = _UNIT_AT_END.fullmatch(title)
    return (parts[1].lower(), parts[2] or None) if parts else (title.lower(), None)


def _axis(name: str) -> str | None:
    found = _AXIS_LAST.fullmatch(name) or _AXIS_FIRST.fullmatch(name)
    return found[1] if found else None


def _seconds(name: str, title: tuple[str, str | None]) -> float:
    unit = title[1]
    if unit is None or unit.lower() in ("sec", "seconds"):
        return 1.0
    return factor_of(unit, "s", f"{name}, line 1: the unit of {title[0]}", unit)


def _factor(name: str, title: tuple[str, str | None], units: str | None) -> float:
    column, unit = title
    if unit is None:
        if units is None:
            raise UnitError(
                f"{name}, line 1: the column {column} has no unit: write {column} (m/s2), or give"
                ' units="m/s2"'
            )
        return factor_of_unit(units, "units")
    factor = factor_of_unit(unit, f"{name}, line 1: the unit of {column}")
    if units is not None and factor != factor_of_unit(units, "units"):
        raise UnitError(f'{name}, line 1: the unit of {column} is {unit}, but units is "{units}"')
    return factor


def _numbers(table: Table) -> Array:
    """The cells as numbers, (n, columns)."""
    if len(table.rows) < 2:
        raise RimrollError(f"{table.name} must have at least 2 samples, it has {len(table.rows)}")
    for row in table.rows:
        for cell in row.cells:
            try:
                is_fit = bool(np.isfinite(float(cell)))
            except ValueError:
                is_fit = False
            if not is_fit:
                raise RimrollError(f'{table.name}, line {row.line}: "{cell}" is no number')
    return np.array([row.cells for row in table.rows], np.float64)


def _step(table: Table, times: Array) -> float:
    """The step of even times, s."""
    steps = np.diff(times)
    usual = float(np.median(steps))
    mean = (times[-1] - times[0]) / len(steps)
    off = times - times[0] - mean * np.arange(len(times))
    uneven = np.abs(steps - usual) > UNEVEN * usual
    if not uneven.any():
        uneven = np.abs(off[1:]) > UNEVEN * usual
    if not (steps > 0.0).all():
        line = table.rows[int((steps <= 0.0).argmax()) + 1].line
        raise RimrollError(f"{table.name}, line {line}: the time is not after the one before")
    if uneven.any():
        place = int(uneven.argmax())
        raise RimrollError(
            f"{table.name}, line {table.rows[place + 1].line}: the time is {steps[place]:g} s after"
            f" the one before, where most steps are {usual:g} s; a record needs equal steps"
        )
    return float(f"{mean:.12g}")
