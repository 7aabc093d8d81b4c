"""Directions of fall: from files, and stand-ins for published means and spreads."""

from __future__ import annotations

import math
import re
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from rimroll.errors import RimrollError, UnitError
from rimroll.experiment.predicted import TURN
from rimroll.experiment.release import normal_quantiles
from rimroll.files.table import Row, Source, Table, read_table
from rimroll.units import number, quantity, whole_number

Array = NDArray[np.float64]

FALLS = re.compile(r"direction|angle|fall|end|richtung|winkel")
"""Beginnings of the name of a column of directions of fall."""

DIRECTIONS = re.compile(r"direction|angle|richtung|winkel")
"""The names of these that suffice to choose one among many columns."""

LEANS = re.compile(r"lean|(direction of |angle of )?(the )?first|start direction")
"""Beginnings of the name of a column of directions of the first lean."""

_UNIT_AT_END = re.compile(r"\s*(\[[^\]]*\]|\([^)]*\))$")

ENOUGH = 8
"""The smallest number of falls of one outcome for a fit."""

MAX_LINES = 10
"""Lines without an angle that a message lists."""

MIN_LABELS = 4
"""Rows with small whole numbers in the first of two unnamed columns that look like labels."""


@dataclass(frozen=True)
class FallDirections:
    """Directions of fall, and the columns that they were read from."""

    directions: Array = field(repr=False)
    """Angles (n,), rad, 0 to 2π, counted anticlockwise from the direction of the first lean."""
    source: str
    """The columns, their units and the rows that were read, in words."""


def read_directions(
    file: Source,
    *,
    radians: bool = False,
    clockwise: bool = False,
    outcome: str | None = None,
    column: str | int | None = None,
    lean_column: str | int | None = None,
) -> Array:
    """Directions of fall from a file of comma, semicolon, tab or space separated values.

    One column: the direction of fall, counted from the direction of the first lean. Two: the
    direction of the first lean and that of the fall, by the same protractor. A file with more
    columns needs a line of names with ``direction`` among them, or ``column``; a column named
    ``lean`` is the first lean. From a file of ``rimroll topple``, the falls that count are read.
    Lines that begin with # and blank lines are skipped. Files of spreadsheets work unchanged:
    semicolons, decimal commas, quotes, UTF-8, UTF-16 or Windows' code page 1252.

    Parameters
    ----------
    file
        A path, or a binary stream such as ``sys.stdin.buffer``.
    radians
        Whether plain numbers are in radians. They are in degrees unless this or the column's name
        says otherwise, as ``direction[rad]`` does; a cell may carry its unit, as in ``213 deg``.
    clockwise
        Whether angles grow clockwise seen from above, as on a compass.
    outcome
        The outcome of the rows to read, if there is a column ``outcome``; by default ``toppled``
        if there are at least 8 of them, else ``rocked``.
    column, lean_column
        The columns of the direction of fall and of the first lean, by name, with or without the
        unit in brackets at its end, or by number from 1.
        With ``column`` alone, directions are already counted from the first lean.

    Returns
    -------
    numpy.ndarray
        Directions (n,), rad, 0 to 2π, counted anticlockwise.

    Raises
    ------
    RimrollError
        For a cell that is not an angle, with file, line and cell; for columns that may not be
        directions, such as numbers of falls or groups; for commas that may be decimal commas or
        not; and for angles that look like radians without saying so.
    """
    return read_falls(
        file,
        radians=radians,
        clockwise=clockwise,
        outcome=outcome,
        column=column,
        lean_column=lean_column,
    ).directions


def read_falls(
    file: Source,
    *,
    radians: bool,
    clockwise: bool,
    outcome: str | None,
    column: str | int | None,
    lean_column: str | int | None,
) -> FallDirections:
    """What :func:`read_directions` gives, with a sentence on what was read."""
    table = read_table(file, has_columns=lean_column is not None or column not in (None, 1, "1"))
    rows, kind = _counting(table, outcome)
    if not rows:
        raise RimrollError(f"{table.name} holds no angles")
    columns = (
        _columns(table)
        if column is None and lean_column is None
        else _named_columns(table, column, lean_column)
    )
    _refuse_gaps(table, rows, columns)
    units = [_unit_of(table.names, one) for one in columns]
    plain = "rad" if radians else "deg"
    angles = np.array(
        [
            [
                _angle(table.name, row, one, unit or plain)
                for one, unit in zip(columns, units, strict=True)
            ]
            for row in rows
        ]
    )
    if not radians and not any(units):
        _refuse_hidden_radians(table.name, angles)
    if len(columns) == 2 and column is None and lean_column is None:
        _refuse_labels(table, angles[:, 0])
    turned = angles[:, 0] if len(columns) == 1 else angles[:, 1] - angles[:, 0]
    directions = np.mod(-turned if clockwise else turned, TURN)
    words = {"deg": "degrees", "rad": "radians"}
    in_units = " and ".join(dict.fromkeys(words[unit or plain] for unit in units))
    read = _column_in_words(table, columns[-1])
    if len(columns) == 2:
        read += f" less {_column_in_words(table, columns[0])}, the first lean"
    way = "clockwise" if clockwise else "anticlockwise"
    rows_read = f"{len(rows)} rows" + (f" with the outcome {kind}" if kind else "")
    if table.blank:
        are = "are" if len(table.blank) > 1 else "is"
        rows_read += f"; {_lines_in_words(table.blank)} {are} blank"
    return FallDirections(directions, f"{read}; {in_units}, {way}; {rows_read}")


def _column_in_words(table: Table, column: int) -> str:
    if table.width == 1 and not table.names:
        return "the only column"
    name = f' "{table.titles[column]}"' if table.titles and table.titles[column] else ""
    return f"column {column + 1}{name}"


def _columns(table: Table) -> list[int]:
    """The column of the direction of fall, after that of the first lean where there is one."""
    names, width = table.names, table.width
    leans = [i for i, name in enumerate(names) if LEANS.match(name)]
    lean = leans if len(leans) == 1 else []
    exactly = [
        i
        for i, name in enumerate(names)
        if re.match(r"direction\W*(\[|\(|$)", name) and i not in lean
    ]
    if exactly:
        return [*lean, exactly[0]]
    if width == 1:
        return [0]
    for pattern in (DIRECTIONS, FALLS):
        named = [i for i, name in enumerate(names) if pattern.match(name) and i not in lean]
        if len(named) == 1 and (pattern is DIRECTIONS or lean):
            return [*lean, *named]
    if width == 2 and (not any(names) or all(FALLS.match(name) for name in names)):
        return [0, 1]
    there = (
        f"has {', '.join(title or '(no name)' for title in table.titles)}"
        if table.titles
        else f"has {width} columns without names"
    )
    raise RimrollError(
        f"{table.name} needs one column (direction of fall), two (direction of the first lean, of "
        f"the fall) or one named direction; it {there}. Say which to read by its name or number: "
        f"column (--column), and lean_column (--lean-column) for that of the first lean"
    )


def _named_columns(table: Table, column: str | int | None, lean: str | int | None) -> list[int]:
    if column is None:
        raise RimrollError(
            "must be given with lean_column: it holds the direction of fall", "column"
        )
    fall = _place(table, "column", column)
    if lean is None:
        return [fall]
    first = _place(table, "lean_column", lean)
    if first == fall:
        raise RimrollError(f"column and lean_column must differ, got {column!r} and {lean!r}")
    return [first, fall]


def _place(table: Table, field: str, column: str | int) -> int:
    word = str(column).strip().lower()
    if word in table.names:
        return table.names.index(word)
    without_units = [_UNIT_AT_END.sub("", name) for name in table.names]
    if without_units.count(word) == 1:
        return without_units.index(word)
    if word.isdecimal() and 1 <= int(word) <= table.width:
        return int(word) - 1
    there = f", or of {', '.join(table.titles)}" if table.titles else ""
    raise RimrollError(
        field=field, value=column, bound=f"a number from 1 to {table.width}{there} in {table.name}"
    )


def _unit_of(names: list[str], column: int) -> str | None:
    """What the column's name says."""
    words = set(re.findall(r"[a-z]+|°", names[column])) if names else set()
    if words & {"rad", "radian", "radians"}:
        return "rad"
    return "deg" if words & {"deg", "degree", "degrees", "°"} else None


def _counting(table: Table, outcome: str | None) -> tuple[list[Row], str | None]:
    """The rows to take, and their outcome where the file says what became of each fall."""
    if "outcome" not in table.names:
        return table.rows, None
    at = table.names.index("outcome")
    outcomes = [row.cells[at] for row in table.rows]
    word = outcome or ("toppled" if outcomes.count("toppled") >= ENOUGH else "rocked")
    return [row for row in table.rows if row.cells[at] == word], word


def _refuse_gaps(table: Table, rows: list[Row], columns: list[int]) -> None:
    for column in columns:
        lines = [row.line for row in rows if not row.cells[column]]
        if lines:
            raise RimrollError(
                f"{table.name}, {_lines_in_words(lines)}: an angle is missing in"
                f" {_column_in_words(table, column)}; to leave a line out, begin it with #"
            )


def _lines_in_words(lines: list[int]) -> str:
    more = f" and {len(lines) - MAX_LINES} more" if len(lines) > MAX_LINES else ""
    return f"line{'s' * (len(lines) > 1)} {', '.join(map(str, lines[:MAX_LINES]))}{more}"


def _angle(file: str, row: Row, column: int, unit: str) -> float:
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
    try:
        return quantity(cell, "rad", place)
    except UnitError as error:
        raise RimrollError(
            f'{place}: an angle must read as 213 or 213 deg, got "{cell}": {error.why}'
        ) from None


def _refuse_hidden_radians(file: str, angles: Array) -> None:
    largest = float(np.degrees(np.abs(angles)).max())
    if len(angles) > 3 and largest <= TURN:
        raise RimrollError(
            f"{file}: no angle is above {largest:.3g} degrees, so these look like radians; name "
            f"the column direction[rad] or say so (--radians), or direction[deg] if they are not"
        )


def _refuse_labels(table: Table, first: Array) -> None:
    """Refuse numbers of falls, 0 or 1 and on, and of groups, for directions of a first lean."""
    count = np.arange(len(first))
    both = (first, np.degrees(first))
    counts = any(np.allclose(one, count + start) for one in both for start in (0, 1))
    if len(first) > 3 and counts:
        raise RimrollError(
            f"{table.name}: its first column counts the falls and is no direction of a first lean; "
            f"name the other direction, or choose it with column (--column)"
        )
    whole = np.degrees(first)
    few = len(set(whole.round(9).tolist())) <= len(first) // 2
    small = bool(np.all((whole >= 0.0) & (whole < 10.0)) and np.allclose(whole, whole.round()))
    if not table.names and len(first) >= MIN_LABELS and few and small and np.any(first):
        raise RimrollError(
            f"{table.name}: its first column has only small whole numbers that repeat, which look "
            f"like groups and not like directions of a first lean; name the columns (lean, fall), "
            f"or choose with column and lean_column (--column, --lean-column)"
        )


def directions_from_summary(
    *, left: tuple[float, float, int], right: tuple[float, float, int]
) -> Array:
    """Directions (n,), rad, whose turns have exactly the given means and spreads.

    ``left`` and ``right``: mean turn, standard deviation (rad) and number of the falls to a side.
    The values are spread like a normal distribution; for normal errors, the likelihood depends on
    the data only through mean, spread and number.
    """
    sides = []
    for name, sign, given in (("left", 1.0, left), ("right", -1.0, right)):
        if not isinstance(given, tuple | list) or len(given) != 3:
            raise RimrollError(field=name, value=given, bound="a mean, a spread and a count")
        mean, spread, count = given
        n = whole_number(f"{name} count", count)
        mean = number(f"{name} mean", mean, "rad")
        spread = number(f"{name} spread", spread, "rad")
        if not (math.isfinite(mean) and 0.0 <= spread < math.inf):
            raise RimrollError(field=name, value=(mean, spread), bound="a mean and a spread >= 0")
        if n < 2:
            raise RimrollError(f"{name} needs at least 2 falls, got {n}")
        normal = normal_quantiles((np.arange(n) + 0.5) / n)
        sides.append(sign * (mean + spread * normal / normal.std(ddof=1)))
    return np.asarray(np.mod(np.concatenate(sides), TURN))
