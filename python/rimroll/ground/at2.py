"""AT2 files of the Pacific Earthquake Engineering Research Center: one component of a record.

Four lines of header: a title; the earthquake, the station and the direction; the quantity and its
unit; the number of samples and the step, in any order and punctuation. Then the samples, several a
line, as FORTRAN writes them.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from rimroll.errors import RimrollError
from rimroll.ground.names import Direction, direction_of, factor_of_unit

Array = NDArray[np.float64]

HEADER = 4
"""Lines of the header."""

# A number that touches the one before begins with a sign.
_NUMBER = r"(?:(?<![\d.])|(?=[+-]))[+-]?(?:\d+\.?\d*|\.\d+)(?:[EeDd][+-]?\d+|[+-]\d{3}(?![\d.]))?"
_NUMBERS = re.compile(_NUMBER)
_IN_HEADER = re.compile(r"(?<![\w.])[+-]?(?:\d+\.?\d*|\.\d+)(?:[EeDd][+-]?\d+)?")
_LABELS = re.compile(r"\b(?:NPTS|DT)\b", re.IGNORECASE)
_NPTS = re.compile(r"\bNPTS\b", re.IGNORECASE)
_UNIT = re.compile(r"UNITS?\s+(?:OF|IN|:|=)?\s*\(?([^\s(),;]+)", re.IGNORECASE)
_OTHER = re.compile(r"\b(VELOCITY|DISPLACEMENT)\b", re.IGNORECASE)
_TITLE = re.compile(r"\bPEER\b|PACIFIC ENGINEERING|UNITS OF", re.IGNORECASE)
_IN_BRACKETS = re.compile(r"\([^()]*\)\s*$")


@dataclass(frozen=True)
class Component:
    """One component of a record."""

    name: str
    """What messages call the file."""
    direction: Direction | None
    step: float
    """s."""
    samples: Array
    """(n,), m/s²."""


def is_at2(text: str) -> bool:
    """Whether the first lines are those of an AT2 file, perhaps of one that was cut."""
    head = "\n".join(text.splitlines()[:HEADER])
    return bool(_NPTS.search(head) or _TITLE.search(head))


def component_of(name: str, text: str, units: str | None = None) -> Component:
    """The component in a file.

    ``units`` is the unit where line 3 names none. Raises ``RimrollError``, with file and line, for
    what does not read as above, for another quantity, for text among the samples, and for another
    number of samples than the header says.
    """
    lines = text.splitlines()
    if len(lines) < HEADER:
        raise RimrollError(f"{name}: an AT2 file has a header of 4 lines, this has {len(lines)}")
    counted = _count_and_step(name, lines[HEADER - 1])
    factor = _factor(name, lines[2], units)
    samples = _samples(name, lines[HEADER:], counted.npts)
    return Component(name, _direction(lines[1]), counted.step, factor * samples)


class _Counted(NamedTuple):
    npts: int
    step: float


def _count_and_step(name: str, line: str) -> _Counted:
    """NPTS and DT: the first two numbers, in the order of the labels."""
    labels = [label.upper() for label in _LABELS.findall(line)]
    found = [float(number.upper().replace("D", "E")) for number in _IN_HEADER.findall(line)]
    if sorted(labels) != ["DT", "NPTS"] or len(found) < 2:
        raise RimrollError(
            f'{name}, line 4: it must name NPTS and DT, as in "NPTS= 4000, DT= .01 SEC", got'
            f' "{line.strip()}"'
        )
    values = dict(zip(labels, found, strict=False))
    count, step = values["NPTS"], values["DT"]
    if not (count.is_integer() and count >= 2.0):
        raise RimrollError(f"{name}, line 4: NPTS must be a whole number >= 2, got {count:g}")
    if not step > 0.0:
        raise RimrollError(f"{name}, line 4: DT must be > 0, got {step:g} s")
    return _Counted(int(count), step)


def _factor(name: str, line: str, units: str | None) -> float:
    if other := _OTHER.search(line):
        what = {"VELOCITY": "velocities", "DISPLACEMENT": "displacements"}[other[1].upper()]
        raise RimrollError(f"{name}, line 3: it holds {what}; a ground needs accelerations")
    written = _UNIT.search(line)
    if written is None and units is None:
        raise RimrollError(
            f'{name}, line 3: it names no unit, as in "IN UNITS OF G": give units="g", or what the'
            " unit is"
        )
    given = None if units is None else factor_of_unit(units, "units")
    if written is None:
        assert given is not None
        return given
    factor = factor_of_unit(written[1].rstrip("."), f"{name}, line 3: it")
    if given is not None and given != factor:
        raise RimrollError(f'{name}, line 3: the unit is {written[1]}, but units is "{units}"')
    return factor


def _direction(line: str) -> Direction | None:
    """What the end of line 2 says, before what is in brackets."""
    fields = _IN_BRACKETS.sub("", line.strip()).strip(" ,").split(",")
    words = fields[-1].split()
    found = direction_of(fields[-1]) if len(fields) > 1 else None
    if found is None and words and not re.fullmatch(r"\d{1,2}|v", words[-1].lower()):
        found = direction_of(words[-1])
    return found


def station_of(text: str) -> str:
    """The earthquake and the station in line 2: all that is before the direction.

    >>> station_of("PEER\\nImperial Valley-02, 5/19/1940, El Centro Array #9, 180\\n")
    'Imperial Valley-02, 5/19/1940, El Centro Array #9'
    """
    line = _IN_BRACKETS.sub("", [*text.splitlines(), "", ""][1].strip()).strip(" ,")
    before, comma, last = line.rpartition(",")
    if comma and direction_of(last) is not None:
        line = before
    elif _direction(line) is not None:
        line = line.rpartition(" ")[0]
    return " ".join(line.split()).rstrip(" ,")


def _samples(name: str, lines: list[str], count: int) -> Array:
    try:
        samples = np.array(" ".join(lines).split(), np.float64)
    except ValueError:
        samples = np.array([np.nan])
    # The usual file; NumPy reads no numbers that touch each other, and nan as a number.
    if len(samples) == count and np.isfinite(samples).all() and not any("_" in a for a in lines):
        return samples
    values: list[float] = []
    for i, line in enumerate(lines, HEADER + 1):
        if len(values) >= count and line.strip():
            raise RimrollError(
                f"{name}, line {i}: the samples go on after the {count} that line 4 says"
            )
        values += _values(name, i, line)
    if len(values) < count:
        raise RimrollError(
            f"{name}: line 4 says {count} samples, and {len(values)} follow: the file was cut, or"
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
