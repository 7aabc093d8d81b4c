"""Directions of fall from a file, or from the means and spreads of a publication."""

from __future__ import annotations

import csv
import math
import os
import re
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from rimroll.errors import RimrollError, UnitError, number
from rimroll.experiment.fitting.predicted import TURN
from rimroll.motion import whole_number
from rimroll.units import quantity

Array = NDArray[np.float64]

DIRECTIONS = ("direction", "angle", "richtung", "winkel")
"""Beginnings of the name of the column of directions."""

_DECIMAL_COMMA = re.compile(r"^([+-]?\d+),(\d+)")

ENOUGH = 8
"""Falls of a kind that are worth a fit."""

MOST_BYTES = 20_000_000


@dataclass(frozen=True)
class _Row:
    """The cells of a line of a file."""

    line: int
    text: str
    cells: list[str]


def read_angles(
    path: str | os.PathLike[str],
    *,
    radians: bool = False,
    clockwise: bool = False,
    counted: str | None = None,
) -> Array:
    """Directions of fall from a file of comma, semicolon, tab or space separated values.

    One column: the direction of fall, counted from the direction of the first lean. Two: the
    direction of the first lean and that of the fall, by the same protractor. More need a line of
    names with ``direction`` among them; of a file written by ``rimroll topple`` the falls that
    count are taken. Lines that begin with # are passed over. Decimals follow a point.

    Parameters
    ----------
    path
        The file.
    radians
        Whether plain numbers are in radians. They are in degrees unless this or the column's name
        says otherwise, as ``direction[rad]`` does; a cell may carry its unit, as in ``213 deg``.
    clockwise
        Whether angles grow clockwise seen from above, as on a compass.
    counted
        Of a file with a column ``outcome``, which rows to take; ``toppled`` if there are 8 of them,
        else ``rocked``, unless given.

    Returns
    -------
    numpy.ndarray
        Directions (n,), rad, 0 to 2π, counted anticlockwise.

    Raises
    ------
    RimrollError
        With file, line and cell, for what is no angle; for columns that cannot be told from a
        count or from decimal commas, and for angles that look like radians but are not said to be.
    """
    file = Path(path)
    rows = _rows(file)
    names = _names(rows)
    body = _counting(names, rows[1:] if names else rows, counted)
    if not body:
        raise RimrollError(f"{file} holds no angles")
    columns = _columns(file, names, len(body[0].cells))
    if not names and len(columns) == 2:
        _refuse_decimal_commas(file, body)
    units = [_unit_of(names, column) for column in columns]
    plain = "rad" if radians else "deg"
    table = np.array(
        [
            [
                _angle(file, row, column, unit or plain)
                for column, unit in zip(columns, units, strict=True)
            ]
            for row in body
        ]
    )
    if not radians and not any(units):
        _refuse_hidden_radians(file, table)
    if len(columns) == 2:
        _refuse_count(file, table[:, 0])
    direction = table[:, 0] if len(columns) == 1 else table[:, 1] - table[:, 0]
    return np.asarray(np.mod(-direction if clockwise else direction, TURN))


def directions_of_summary(
    *, left: tuple[float, float, int], right: tuple[float, float, int]
) -> Array:
    """Directions (n,), rad, whose turns have exactly the given means and spreads.

    ``left`` and ``right``: mean turn and standard deviation (rad) of the falls to a side, and how
    many. The values are spread as those of a normal distribution; under normal errors a mean, a
    spread and a number are all that a likelihood asks of data.
    """
    from scipy.special import ndtri

    sides = []
    for name, sign, given in (("left", 1.0, left), ("right", -1.0, right)):
        if not isinstance(given, tuple | list) or len(given) != 3:
            raise RimrollError(f"{name} must be a mean, a spread and a count, got {given!r}")
        mean, spread, count = given
        n = whole_number(f"{name} count", count)
        mean, spread = number(f"{name} mean", mean), number(f"{name} spread", spread)
        if not (math.isfinite(mean) and 0.0 <= spread < math.inf):
            raise RimrollError(f"{name} must be a mean and a spread >= 0, got {mean}, {spread}")
        if n < 2:
            raise RimrollError(f"{name} needs at least 2 falls, got {n}")
        normal = ndtri((np.arange(n) + 0.5) / n)
        sides.append(sign * (mean + spread * normal / normal.std(ddof=1)))
    return np.asarray(np.mod(np.concatenate(sides), TURN))


def _rows(file: Path) -> list[_Row]:
    text = _text(file)
    lines = [
        (i, line.strip())
        for i, line in enumerate(text.splitlines(), 1)
        if line.strip() and not line.lstrip().startswith("#")
    ]
    if not lines:
        raise RimrollError(f"{file} holds no angles" if text.strip() else f"{file} is empty")
    separator = next((mark for mark in ";\t," if mark in lines[0][1]), None)
    try:
        cells = [
            _spaced(line, lines) if separator is None else _separated(line, separator)
            for _, line in lines
        ]
    except csv.Error as error:
        raise RimrollError(f"{file} does not read as a table: {error}") from None
    rows = [_Row(i, line, part) for (i, line), part in zip(lines, cells, strict=True)]
    for row in rows:
        if len(row.cells) != len(rows[0].cells):
            raise RimrollError(
                f"{file}, line {row.line}: {len(row.cells)} columns where line {rows[0].line} has "
                f"{len(rows[0].cells)}"
            )
    return rows


def _text(file: Path) -> str:
    try:
        with file.open("rb") as stream:
            read = stream.read(MOST_BYTES + 1)  # of a pipe, too, which tells no size
    except (OSError, ValueError) as error:  # ValueError: of a path with a NUL in it
        why = getattr(error, "strerror", None) or error
        raise RimrollError(f"cannot read {file}: {why}") from None
    if len(read) > MOST_BYTES:
        raise RimrollError(f"{file} is larger than {MOST_BYTES // 1_000_000} MB")
    try:
        text = read.decode("utf-8-sig")
    except UnicodeDecodeError:
        text = "\0"
    if "\0" in text:
        raise RimrollError(f"{file} is no text file in UTF-8")
    return text


def _separated(line: str, separator: str) -> list[str]:
    cells = [cell.strip() for cell in next(csv.reader([line], delimiter=separator))]
    # Where commas do not separate they can only be decimal.
    return cells if separator == "," else [_DECIMAL_COMMA.sub(r"\1.\2", cell) for cell in cells]


def _spaced(line: str, lines: list[tuple[int, str]]) -> list[str]:
    """Spaces keep columns apart, unless they stand before a unit or inside a name."""
    width = next((len(one.split()) for _, one in lines if _numbers(one.split())), 1)
    cells = line.split()
    return cells if _numbers(cells) or len(cells) == width else [line.strip('"')]


def _numbers(cells: list[str]) -> bool:
    try:
        [float(cell) for cell in cells]
    except ValueError:
        return False
    return True


def _names(rows: list[_Row]) -> list[str]:
    """The names of the columns; none where there is a number in the first line."""
    first = rows[0].cells
    angles = any(re.match(r"[+\-−]?\.?\d", cell) or _numbers([cell]) for cell in first)
    return [] if angles else [cell.lower() for cell in first]


def _columns(file: Path, names: list[str], width: int) -> list[int]:
    """Of the direction, or of the first lean and the fall."""
    exactly = [i for i, name in enumerate(names) if re.match(r"direction\W*(\[|\(|$)", name)]
    if exactly:
        return exactly[:1]
    if width == 1:
        return [0]
    named = [i for i, name in enumerate(names) if name.startswith(DIRECTIONS)]
    if len(named) == 1:
        return named
    if width == 2:
        return [0, 1]
    there = f"has {', '.join(names)}" if names else f"has {width} columns without names"
    raise RimrollError(
        f"{file} needs one column (direction of fall), two (direction of the first lean, of the "
        f"fall) or one named direction; it {there}"
    )


def _unit_of(names: list[str], column: int) -> str | None:
    """What the column's name says."""
    words = set(re.findall(r"[a-z]+|°", names[column])) if names else set()
    if words & {"rad", "radian", "radians"}:
        return "rad"
    return "deg" if words & {"deg", "degree", "degrees", "°"} else None


def _counting(names: list[str], rows: list[_Row], counted: str | None) -> list[_Row]:
    if "outcome" not in names:
        return rows
    at = names.index("outcome")
    outcomes = [row.cells[at] for row in rows]
    word = counted or ("toppled" if outcomes.count("toppled") >= ENOUGH else "rocked")
    return [row for row in rows if row.cells[at] == word]


def _angle(file: Path, row: _Row, column: int, unit: str) -> float:
    cell = row.cells[column]
    place = f"{file}, line {row.line}"
    try:
        angle = math.radians(float(cell)) if unit == "deg" else float(cell)
    except ValueError:
        angle, unit = _with_unit(cell, place), "as it stands"
    if not abs(angle) <= 2.0 * TURN:
        raise RimrollError(
            f"{place}: an angle must be a number between -720 and 720 degrees, got {cell} ({unit})"
        )
    return angle


def _with_unit(cell: str, place: str) -> float:
    if not cell:
        raise RimrollError(f"{place}: an angle is missing")
    try:
        return quantity(cell, "rad", place)
    except UnitError as error:
        why = str(error).rpartition(": ")[2]
        raise RimrollError(
            f'{place}: an angle must read as 213 or 213 deg, got "{cell}": {why}'
        ) from None


def _refuse_decimal_commas(file: Path, rows: list[_Row]) -> None:
    """Whole numbers that follow a comma at once are columns only if no fractions could be so."""
    found = [re.fullmatch(r"[+\-−]?\d+,(\d+)", row.text) for row in rows]
    fractions = [one[1] for one in found if one]
    if len(fractions) < len(rows):
        return
    if any(part.startswith("0") and part != "0" for part in fractions) or all(
        len(part) < 3 for part in fractions
    ):
        raise RimrollError(
            f"{file}: {rows[0].text} may be one number or two; write decimals with a point, or "
            f"keep columns apart with a semicolon"
        )


def _refuse_hidden_radians(file: Path, table: Array) -> None:
    largest = float(np.degrees(np.abs(table)).max())
    if len(table) > 3 and largest <= TURN:
        raise RimrollError(
            f"{file}: no angle is above {largest:.3g} degrees, so these look like radians; name "
            f"the column direction[rad] or say so (--radians), or direction[deg] if they are not"
        )


def _refuse_count(file: Path, first: Array) -> None:
    """Numbers of the falls, 0 or 1 and on, are no directions of a first lean."""
    count = np.arange(len(first))
    told = [unit * (count + start) for unit in (1.0, math.radians(1.0)) for start in (0, 1)]
    if len(first) > 3 and any(np.allclose(first, one) for one in told):
        raise RimrollError(
            f"{file}: its first column counts the falls and tells no lean; name the other direction"
        )
