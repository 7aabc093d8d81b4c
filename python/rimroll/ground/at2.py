"""AT2 files of the Pacific Earthquake Engineering Research Center: one component of a record.

A header, usually of four lines: a title; the earthquake, the station and the direction; the
quantity and its unit; the number of samples and the step, in any order and punctuation. Other
programs write more or fewer lines above the last of these, and blank ones. Then the samples,
several a line, as FORTRAN writes them.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from rimroll.errors import RimrollError
from rimroll.files.titles import expect_step
from rimroll.ground.columns import RECORD, Direction, axis_of, direction_of, factor_of_unit

Array = NDArray[np.float64]

MOST_HEADER = 40
"""Lines in which the header must end."""

# A number that touches the one before begins with a sign.
_NUMBER = r"(?:(?<![\d.])|(?=[+-]))[+-]?(?:\d+\.?\d*|\.\d+)(?:[EeDd][+-]?\d+|[+-]\d{3}(?![\d.]))?"
_NUMBERS = re.compile(_NUMBER)
_IN_HEADER = re.compile(r"(?<![\w.])[+-]?(?:\d+\.?\d*|\.\d+)(?:[EeDd][+-]?\d+)?")
_LABELS = re.compile(r"\b(?:NPTS|DT)\b", re.IGNORECASE)
_NPTS = re.compile(r"\bNPTS\b", re.IGNORECASE)
_POINTS = re.compile(
    r"\b(\d+)\s+(?:points|samples)\b.*?\b(?:spacing|intervals?|steps?)\s+of\s+([\d.]+)\s*s",
    re.IGNORECASE,
)
"""The number of samples and the step in words."""
_UNIT = re.compile(
    r"\bUNITS?\b\s*(?:OF|IN|ARE|IS)?\s*[:=]?\s*[(\[]?\s*([^\s()\[\],;]+)", re.IGNORECASE
)
_OTHER = re.compile(r"\b(VELOCITY|DISPLACEMENT)\b", re.IGNORECASE)
_TITLE = re.compile(r"\bPEER\b|PACIFIC ENGINEERING|UNITS OF", re.IGNORECASE)
_IN_BRACKETS = re.compile(r"\([^()]*\)\s*$")


@dataclass(frozen=True)
class Component:
    """One component of a record."""

    name: str
    """What messages call the file."""
    direction: Direction | None
    axis: str | None
    """x, y or z, where line 2 says L, T or V, or H1 and H2, and no direction."""
    step: float
    """s."""
    samples: Array
    """(n,), m/s²."""


def is_at2(text: str) -> bool:
    """Whether the first lines are those of an AT2 file, perhaps of one that was cut."""
    head = [line for line in text.splitlines()[:MOST_HEADER] if not line.lstrip().startswith("#")]
    return bool(
        any(_NPTS.search(line) or _POINTS.search(line) for line in head)
        or _TITLE.search("\n".join(head[:6]))
    )


def component_of(name: str, text: str, units: str | None = None) -> Component:
    """The component in a file.

    ``units`` is the unit where the header names none. Raises ``RimrollError``, with file and line,
    for what does not read as above, for another quantity, for text among the samples, for another
    number of samples than the header says, and for a step that no record has.
    """
    lines = text.splitlines()
    counted = _count_and_step(name, lines)
    header = [(i, line) for i, line in enumerate(lines[: counted.line], 1) if line.strip()]
    factor = _factor(name, header, units)
    samples = _samples(name, lines, counted)
    return Component(name, *_direction(_second(text)), counted.step, factor * samples)


def _second(text: str) -> str:
    """The second line that is not blank: of the earthquake, the station and the direction."""
    filled = [line for line in text.splitlines()[:MOST_HEADER] if line.strip()]
    return [*filled, "", ""][1]


class _Counted(NamedTuple):
    npts: int
    step: float
    line: int
    """Where the header says so, the last of its lines, from 1."""


def _count_and_step(name: str, lines: list[str]) -> _Counted:
    """NPTS and DT: the first two numbers beside their labels, in the order of these."""
    places = [i for i, line in enumerate(lines[:MOST_HEADER]) if _LABELS.search(line)]
    told = [i for i, line in enumerate(lines[:MOST_HEADER]) if _POINTS.search(line)]
    if not places and told:
        words = _POINTS.search(lines[told[0]])
        assert words is not None
        below = (i for i, line in enumerate(lines) if i > told[0] and _is_all_numbers(line))
        return _expected(name, told[0], float(words[1]), float(words[2]), next(below, told[0] + 1))
    text = " ".join(lines[i] for i in places)
    labels = [label.upper() for label in _LABELS.findall(text)]
    found = [float(number.upper().replace("D", "E")) for number in _IN_HEADER.findall(text)]
    where = f"{name}, line {places[-1] + 1}" if places else name
    if sorted(labels) != ["DT", "NPTS"] or len(found) < 2:
        got = (
            f'got "{text.strip()}"'
            if places
            else f"its first {min(len(lines), MOST_HEADER)} lines name neither"
        )
        raise RimrollError(
            f'{where}: it must name NPTS and DT, as in "NPTS= 4000, DT= .01 SEC", {got}'
        )
    values = dict(zip(labels, found, strict=False))
    return _expected(name, places[-1], values["NPTS"], values["DT"], places[-1] + 1)


def _expected(name: str, place: int, count: float, step: float, end: int) -> _Counted:
    where = f"{name}, line {place + 1}"
    if not (count.is_integer() and count >= 2.0):
        raise RimrollError(f"{where}: NPTS must be a whole number >= 2, got {count:g}")
    if not step > 0.0:
        raise RimrollError(f"{where}: DT must be > 0, got {step:g} s")
    expect_step(f"{where}: DT", RECORD, step, is_stated=True)
    return _Counted(int(count), step, end)


def _is_all_numbers(line: str) -> bool:
    return bool(line.strip()) and not _NUMBERS.sub(" ", line).strip(" \t,")


def _factor(name: str, header: list[tuple[int, str]], units: str | None) -> float:
    """The factor of the unit that the header names, in the first line with that word."""
    named = [(i, text, unit) for i, text in header if (unit := _UNIT.search(text))]
    third = header[min(2, len(header) - 1)]
    line, of_unit, written = named[0] if named else (*third, None)
    if other := _OTHER.search(of_unit):
        what = {"VELOCITY": "velocities", "DISPLACEMENT": "displacements"}[other[1].upper()]
        raise RimrollError(f"{name}, line {line}: it holds {what}; a ground needs accelerations")
    given = None if units is None else factor_of_unit(units, "units")
    if written is None:
        if given is None:
            raise RimrollError(
                f'{name}, line {line}: it names no unit, as in "IN UNITS OF G": give units="g"'
                " (on the command line --units g), or what the unit is"
            )
        return given
    factor = factor_of_unit(written[1].rstrip("."), f"{name}, line {line}: it")
    if given is not None and given != factor:
        raise RimrollError(f'{name}, line {line}: the unit is {written[1]}, but units is "{units}"')
    return factor


def _direction(line: str) -> tuple[Direction | None, str | None]:
    """What the end of line 2 says, before what is in brackets: a direction, or an axis."""
    fields = _IN_BRACKETS.sub("", line.strip()).strip(" ,").split(",")
    words = fields[-1].split()
    found = direction_of(fields[-1]) if len(fields) > 1 else None
    if found is None and words and not re.fullmatch(r"\d{1,2}|v", words[-1].lower()):
        found = direction_of(words[-1])
    axis = axis_of(fields[-1]) if found is None and len(fields) > 1 else None
    return found, axis


def station_of(text: str) -> str:
    """The earthquake and the station in line 2: all that is before the direction.

    >>> station_of("PEER\\nImperial Valley-02, 5/19/1940, El Centro Array #9, 180\\n")
    'Imperial Valley-02, 5/19/1940, El Centro Array #9'
    """
    line = _IN_BRACKETS.sub("", _second(text).strip()).strip(" ,")
    before, comma, last = line.rpartition(",")
    if comma and (direction_of(last) is not None or axis_of(last) is not None):
        line = before
    elif _direction(line)[0] is not None:
        line = line.rpartition(" ")[0]
    return " ".join(line.split()).rstrip(" ,")


def _samples(name: str, lines: list[str], counted: _Counted) -> Array:
    count, said = counted.npts, f"line {counted.line}"
    first = counted.line
    # A mark such as "*** Begin data ***" may follow the header.
    while first < len(lines) and re.fullmatch(r"[a-zA-Z\s*:=-]*", lines[first]):
        first += 1
    try:
        samples = np.array(" ".join(lines[first:]).split(), np.float64)
    except ValueError:
        samples = np.array([np.nan])
    # The usual file; NumPy reads no numbers that touch each other, and nan as a number.
    if len(samples) == count and np.isfinite(samples).all() and not any("_" in a for a in lines):
        return samples
    values: list[float] = []
    for i, line in enumerate(lines[first:], first + 1):
        more = _values(name, i, line)
        if len(values) >= count and line.strip():
            raise RimrollError(
                f"{name}, line {i}: the samples go on after the {count} that {said} says: the file"
                " holds more than one record, or NPTS is wrong"
            )
        values += more
        if any(values[count:]):  # noughts fill the last line in some files
            raise RimrollError(
                f"{name}, line {i}: NPTS in {said} is {count}, and {len(values)} samples have"
                f" passed: write NPTS= {len(values)} there if the last ones belong to the record"
            )
    if len(values) < count:
        raise RimrollError(
            f"{name}: {said} says {count} samples, and {len(values)} follow: the file was cut, or"
            " NPTS is wrong"
        )
    return np.array(values[:count])


def _values(name: str, number: int, line: str) -> list[float]:
    """The numbers of a line, as FORTRAN writes them: ``1.234-5.678``, ``.12D-3``, ``.5-101``."""
    rest = _NUMBERS.sub(" ", line)
    if rest.strip(" \t,"):
        wrong = next((word for word in line.split() if _NUMBERS.sub(" ", word).strip(" ,")), line)
        raise RimrollError(f'{name}, line {number}: "{wrong}" is no number')
    return [_value(word) for word in _NUMBERS.findall(line)]


def _value(word: str) -> float:
    try:
        return float(word)
    except ValueError:
        with_e = re.sub(r"[Dd]", "E", word)
        return float(re.sub(r"(?<=[\d.])([+-]\d{3})$", r"E\1", with_e))
