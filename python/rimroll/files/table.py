"""A table of text as spreadsheets and people write it: encoding, separators, decimals, quotes."""

from __future__ import annotations

import csv
import os
import re
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path
from typing import IO

from rimroll.errors import RimrollError
from rimroll.units import SECONDS

Source = str | os.PathLike[str] | IO[bytes]
"""A path, or a binary stream such as ``sys.stdin.buffer``."""

MOST_BYTES = 20_000_000

EMPTY = " ;,\t"
"""The characters of a line without content: spaces, and separators of empty cells."""

_ENCODINGS = {b"\xff\xfe": "utf-16", b"\xfe\xff": "utf-16", b"\xef\xbb\xbf": "utf-8-sig"}
"""Byte order marks, and what they announce; Excel's "Unicode text" is UTF-16."""

_NOT_TEXT = re.compile(r"[\x00-\x08\x0e-\x1f]")
_END_OF_FILE = "\x1a"
"""What DOS writes behind the last line."""
_SEPARATOR = re.compile(r"[\"']?sep=(.|\\t)[\"']?[;,\s]*", re.IGNORECASE)
"""The line with which Excel is told the separator."""
_EXCEL = {
    b"PK\x03\x04": "a zip or Excel file: unpack it, or",
    b"\xd0\xcf\x11\xe0": "an Excel file:",
}
_TITLE_BETWEEN_SPACES = re.compile(r"[^\s\[(]+(?:\s*[\[(][^\])]*[\])])?")
_UNITS = re.compile(
    rf"|{'|'.join(SECONDS)}|g|gal|mg|rad|deg|°|dps|counts|-"
    r"|(m|cm|mm|in|ft)(/s\S*)?|(rad|deg|°)/s\S*",
    re.IGNORECASE,
)
MOST_ABOVE = 100
"""Lines of a preamble above the titles."""
_DECIMAL_COMMA = re.compile(r"^([+\-−]?\d+),(\d+)(?!,)")
_PAIR = re.compile(r"[+\-−]?\d+,(\d+)\s*(?:°|deg\w*|rad\w*)?")

ENOUGH_FOR_DECIMALS, WIDE_APART = 8, 60
"""How many unnamed lines such as ``213,5`` hold decimals, and how far apart, in degrees, their
whole parts are. As columns they would be a first lean and a fall, all falls below 100 degrees. A
body falls some 140 degrees from its lean, to either side, so the leans would be close together."""


@dataclass(frozen=True)
class Row:
    """The cells of a line of a file; lines are counted from 1."""

    line: int
    cells: list[str]


class UnevenRow(RimrollError):
    """A row of another width than the first one."""

    line = 0
    """The line of the file, from 1."""


@dataclass(frozen=True)
class Table:
    """The rows of a file, all of one width, and what messages call the file."""

    name: str
    titles: list[str]
    """Names of the columns as they are written; none where the first line has a number."""
    rows: list[Row]
    """The rows below the names."""
    width: int
    blank: list[int]
    """The lines between the first and the last row that hold nothing."""
    titles_line: int = 1
    """The line of the names, or the first one."""

    @property
    def names(self) -> list[str]:
        """Names of the columns in small letters."""
        return [title.lower() for title in self.titles]


def read_table(source: Source, *, has_columns: bool = False) -> Table:
    """The table in a file; ``has_columns`` and errors as for :func:`table_of`."""
    name = source_name(source)
    return table_of(name, text_of(name, source), has_columns=has_columns)


def table_of(name: str, text: str, *, has_columns: bool = False) -> Table:
    """Comma, semicolon, tab or space separated values, of a file that messages call ``name``.

    Lines that begin with # and lines without content are passed over (``blank`` lists the latter),
    and so are columns at the end that are empty throughout, and Excel's line ``sep=;``. Decimals
    follow a point, or a comma where commas cannot separate columns; that they do is known where
    the file ``has_columns``. Such a file may have a preamble above its titles, which is passed
    over, too, and a line of units below them.

    Raises ``RimrollError`` for no lines, for rows of different widths, and for commas that may be
    decimal or separate columns.
    """
    every = [(i, line.strip()) for i, line in enumerate(text.splitlines(), 1)]
    lines = [(i, line) for i, line in every if line.strip(EMPTY) and not line.startswith("#")]
    if not lines:
        raise RimrollError(
            f"{name} holds nothing but comments" if text.strip() else f"{name} is empty"
        )
    separator = None
    if told := _SEPARATOR.fullmatch(lines[0][1]):
        separator = told[1].replace("\\t", "\t").strip(" ") or None
        lines = lines[1:] or lines
    try:
        if has_columns:
            lines = _below_preamble(lines, separator)
        cells = _cells(name, [line for _, line in lines], has_columns, separator)
    except csv.Error as error:
        raise RimrollError(f"{name} does not read as a table: {error}") from None
    rows = [Row(i, part) for (i, _), part in zip(lines, cells, strict=True)]
    width = len(rows[0].cells)
    for row in rows:
        if len(row.cells) != width:
            what = f"{len(row.cells)} columns where line {rows[0].line} has {width}"
            uneven = UnevenRow(f"{name}, line {row.line}: {what}")
            uneven.line = row.line
            raise uneven
    titles = _titles(rows[0].cells)
    below = rows[1:] if titles else rows
    inside = range(below[0].line, below[-1].line) if below else range(0)
    blank = [i for i, line in every if i in inside and not line.strip(EMPTY)]
    return Table(name, titles, below, width, blank, rows[0].line)


def source_name(source: Source) -> str:
    """What messages call a file or a stream."""
    if isinstance(source, str | os.PathLike):
        return str(Path(source))
    return "standard input" if getattr(source, "name", None) == "<stdin>" else "the stream"


def text_of(name: str, source: Source, if_large: str = "", if_binary: str = "") -> str:
    """The text of a file in UTF-8, UTF-16 with a byte order mark, or Windows' code page 1252.

    Raises ``RimrollError`` for a file that cannot be read, and for one that is too large or no
    text, with a hint for either.
    """
    try:
        if isinstance(source, str | os.PathLike):
            with Path(source).open("rb") as stream:
                read = stream.read(MOST_BYTES + 1)  # also of a pipe, whose size is unknown
        else:
            read = source.read(MOST_BYTES + 1)
    except (OSError, ValueError) as error:  # ValueError: of a path with a NUL in it
        why = getattr(error, "strerror", None) or error
        raise RimrollError(f"cannot read {name}: {why}") from None
    if len(read) > MOST_BYTES:
        raise RimrollError(f"{name} is larger than {MOST_BYTES // 1_000_000} MB{if_large}")
    if read[:4] in _EXCEL:
        raise RimrollError(f"{name} is {_EXCEL[read[:4]]} export it as CSV")
    marked = next((known for mark, known in _ENCODINGS.items() if read.startswith(mark)), None)
    for encoding in [marked] if marked else ["utf-8", "cp1252"]:
        try:
            text = read.decode(encoding)
        except UnicodeDecodeError:
            continue
        text = text.rstrip(f"{_END_OF_FILE}\x00 \r\n") + "\n" if _END_OF_FILE in text else text
        if not _NOT_TEXT.search(text):
            return text
    encodings = "UTF-8, UTF-16 or Windows' code page 1252"
    raise RimrollError(f"{name} is no text file in {encodings}{if_binary}")


def _below_preamble(lines: list[tuple[int, str]], separator: str | None) -> list[tuple[int, str]]:
    """The lines from the titles on, which are those just above the numbers; units in their titles.

    A line of another number of cells than the numbers have is no line of titles.
    """
    rows = [_cells_of(line, separator) for _, line in lines[: MOST_ABOVE + 2]]
    first = next((i for i, row in enumerate(rows) if _begin_numbers(row, rows[i + 1 : i + 2])), 0)
    if first == 0:
        return lines
    width, above = len(rows[first]), first - 1
    mark = separator or _mark_of(lines[first][1])
    titles = _titles_of(lines[above][1], mark, width)
    if titles is None:
        has_units = len(rows[above]) > 1 and re.search(r"[\[(]", lines[above][1])
        return lines[above:] if has_units else lines[first:]
    if above and _are_units(titles):
        names = _titles_of(lines[above - 1][1], mark, width)
        if names is not None:
            marked = [
                f"{name} ({bare})"
                if (bare := unit.strip("[]() ")) and name[-1:] not in "])"
                else name
                for name, unit in zip(names, titles, strict=True)
            ]
            return [(lines[above][0], (mark or "  ").join(marked)), *lines[first:]]
    return lines[above:]


def _begin_numbers(row: list[str], following: list[list[str]]) -> bool:
    """Whether the numbers begin here: most cells are numbers, as in the next line."""
    filled = [cell for cell in row if cell]
    numbers = sum(_are_numbers([cell]) for cell in filled)
    enough = numbers == len(filled) if len(filled) < 3 else 2 * numbers > len(filled)
    alike = all(len(other) == len(row) or _are_numbers(other) for other in following)
    return bool(filled) and enough and alike


def _cells_of(line: str, separator: str | None) -> list[str]:
    """The cells of a line that is looked at alone."""
    mark = separator or _mark_of(line)
    row = _spaced(line) if mark is None else _separated(line, mark)
    while len(row) > 1 and not row[-1]:
        row.pop()
    return row


def _mark_of(line: str) -> str | None:
    """What separates the cells of a line; None for spaces."""
    return next((mark for mark in ";\t," if mark in line), None)


def _titles_of(line: str, mark: str | None, width: int) -> list[str] | None:
    """The titles of so many columns in a line; None if it has another number of them."""
    row = line.split() if mark is None else _cells_of(line, mark)
    if len(row) == width or mark is not None or _mark_of(line) is not None:
        return row if len(row) == width else None
    for titles in (re.split(r"\s{2,}", line.strip()), _TITLE_BETWEEN_SPACES.findall(line)):
        if len(titles) == width:
            return titles
    return None


def _are_units(cells: list[str]) -> bool:
    """Whether all cells are units, as in the second line of titles."""
    bare = [cell.strip().strip("[]()").strip() for cell in cells]
    return any(bare) and all(_UNITS.fullmatch(cell) for cell in bare)


def _cells(
    name: str, lines: list[str], has_columns: bool, separator: str | None
) -> list[list[str]]:
    separator = separator or next((mark for mark in ";\t" if mark in lines[0]), None)
    if separator is not None:
        return _without_empty_end([_separated(line, separator) for line in lines])
    if any("," in line for line in lines):
        rows = [_separated(line, ",") for line in lines]
        if has_columns or not _commas_are_decimal(name, lines, rows):
            return _without_empty_end(rows)
    width = next((len(line.split()) for line in lines if _are_numbers(_spaced(line))), 1)
    rows = [_spaced(line) for line in lines]
    titles = _titles_of(lines[0], None, width) if has_columns else None
    return [
        titles
        if i == 0 and titles is not None
        else (row if len(row) == width or _are_numbers(row) else [_with_point(line.strip('"'))])
        for i, (line, row) in enumerate(zip(lines, rows, strict=True))
    ]


def _commas_are_decimal(name: str, lines: list[str], rows: list[list[str]]) -> bool:
    """Whether commas cannot separate columns; refuses those that may do either."""
    found = [_PAIR.fullmatch(line) for line in lines]
    parts = [pair[1] for pair in found if pair]
    short = all(len(part) < 3 for part in parts)
    # No whole number is written with a nought before it.
    certain = any(part.startswith("0") and part != "0" for part in parts)
    if len(parts) < len(lines):
        # A name or a whole number that stands alone shows that there is one column.
        alone = all(pair or len(row) == 1 for pair, row in zip(found, rows, strict=True))
        named = len(rows[0]) == 1 and bool(_titles(rows[0]))
        return bool(parts) and alone and (named or short or certain)
    if short and not certain and not _are_far_apart(rows):
        raise RimrollError(
            f"{name}: {lines[0]} may be one number or two; write decimals with a point, keep "
            f"columns apart with a semicolon, or name the columns in the first line"
        )
    return short or certain


def _are_far_apart(rows: list[list[str]]) -> bool:
    """Whether whole parts are too many and too far apart for first leans, and count nothing."""
    wholes = [int(row[0].replace("−", "-")) for row in rows]
    counts = all(later - earlier == 1 for earlier, later in pairwise(wholes))
    return (
        len(wholes) >= ENOUGH_FOR_DECIMALS
        and max(wholes) - min(wholes) >= WIDE_APART
        and not counts
    )


def _separated(line: str, separator: str) -> list[str]:
    """The cells of a line; a comma that is left inside a cell is decimal."""
    cells = next(csv.reader([line], delimiter=separator, skipinitialspace=True))
    return [_with_point(cell.strip()) for cell in cells]


def _spaced(line: str) -> list[str]:
    return [_with_point(cell.strip('"')) for cell in line.split()]


def _with_point(cell: str) -> str:
    return _DECIMAL_COMMA.sub(r"\1.\2", cell)


def _without_empty_end(rows: list[list[str]]) -> list[list[str]]:
    """Spreadsheets end every line with the separators of columns that are empty throughout."""
    widths = [max((i for i, cell in enumerate(row, 1) if cell), default=0) for row in rows]
    width = max(widths)
    return [row[:width] if len(row) > width else row for row in rows]


def _are_numbers(cells: list[str]) -> bool:
    try:
        [float(cell) for cell in cells]
    except ValueError:
        return False
    return True


def _titles(first: list[str]) -> list[str]:
    angles = any(re.match(r"[+\-−]?\.?\d", cell) or _are_numbers([cell]) for cell in first)
    return [] if angles else first
