"""Titles of columns: the quantity and the unit that they name, and columns that a user chose."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from rimroll.errors import RimrollError, UnitError
from rimroll.files.table import Table
from rimroll.units import SECONDS, factor_of

Array = NDArray[np.float64]

_RUN = re.compile(r"^[^\[(]*?:\s*")
"""What Vernier writes before a title: the run or data set."""
_IN_BRACKETS = re.compile(r"(.*?)\s*[\[(]\s*([^\[\]()]*?)\s*[\])]\s*")
_AXIS_IN_BRACKETS = re.compile(r"[\[(]\s*([xyzXYZ])\s*[\])]")
_HUMP = re.compile(r"(?<=[a-z0-9])(?=[A-Z])|(?<=[A-Z])(?=[A-Z][a-z])")
_BETWEEN_WORDS = re.compile(r"[\s_.,;:/\\()\[\]\-]+")
_COMPASS = re.compile(r"\b([NnEeUu])-([SsWwDd])(?=\d?\b)")

_WITHOUT_BRACKETS = [unit for unit in SECONDS if not unit.startswith("min")]
"""Units of time that a title may end with: min may be a minimum."""

_AT_END = re.compile(
    rf"(.*?)(?:[\s_,/]+|\s+in\s+)({'|'.join(_WITHOUT_BRACKETS)}"
    r"|m/s/s|m/s\^?[2²]|cm/s/s|cm/s\^?[2²]|mps2|g|gal|m/s|cm/s|mm/s|m|cm|mm"
    r"|rads?[/_]?s(?:ec)?|(?:deg|degrees|°)[/_]?s(?:ec)?|dps|mdps)",
    re.IGNORECASE,
)
"""A unit at the end of a title, without brackets."""

_TIME = re.compile(
    r"t|time|times|zeit|temps|tiempo|tempo|tid|tijd|timestamp|timestamps|elapsed|epoch?|uptime"
)
_LONG_SECONDS = [unit for unit in SECONDS if len(unit) > 4]
"""Units that are words of a title, as in seconds_elapsed."""

LIKELY = ("ms", "us", "ns")
"""Units in which times without one may be, the most usual first."""
SHORTEST, LONGEST, LONGEST_BARE = 4e-5, 1.0, 0.2
"""Between which a step may be, s; and the largest where nothing says that times are in seconds."""


class Title(NamedTuple):
    """What a title names: a quantity, in small words, and its unit."""

    name: str
    unit: str | None

    @property
    def seconds(self) -> float | None:
        """The factor to seconds, if the unit is one of time that is spelled as usual."""
        return SECONDS.get((self.unit or "").lower())

    @property
    def is_time(self) -> bool:
        """Whether it names a time."""
        if self.unit is not None and self.seconds is None and not self.unit[:1].isdigit():
            return False
        return self.seconds is not None or any(map(_TIME.fullmatch, self.name.split()))


def title_of(text: str) -> Title:
    """The quantity and the unit in a title.

    >>> title_of("motionRotationRateX(rad/s)")
    Title(name='motion rotation rate x', unit='rad/s')
    >>> title_of("time_ms").seconds, title_of("seconds_elapsed").seconds
    (0.001, 1.0)
    """
    title = _RUN.sub("", text.strip().strip("\"'").strip())
    title = _AXIS_IN_BRACKETS.sub(r" \1 ", title).strip()
    if parts := _IN_BRACKETS.fullmatch(title):
        return Title(_words(parts[1]), parts[2] or None)
    if parts := _AT_END.fullmatch(title):
        return Title(_words(parts[1]), parts[2])
    words = _words(title)
    unit = next((word for word in words.split() if word in _LONG_SECONDS), None)
    last = words.split()[-1] if words else ""
    if unit is None and len(last) > 1 and last in _WITHOUT_BRACKETS:
        unit = last
    return Title(words, unit)


def _words(text: str) -> str:
    joined = _COMPASS.sub(r"\1\2", text)
    return " ".join(_BETWEEN_WORDS.sub(" ", _HUMP.sub(" ", joined)).lower().split())


def titles_of(table: Table) -> list[Title]:
    """What each title names; empty ones for a table without titles."""
    return [title_of(one) for one in table.titles] or [Title("", None)] * table.width


def columns_given(
    table: Table, columns: Mapping[str, str | int] | None, names: Sequence[str]
) -> dict[str, int]:
    """The places of the columns that a user named by title, or by number from 1.

    Raises ``RimrollError`` for other names than ``names``, and for columns that are not there.
    """
    places: dict[str, int] = {}
    for what, title in (columns or {}).items():
        if what not in names:
            known = ", ".join(f'"{name}"' for name in names)
            raise RimrollError(field="columns", value=what, bound=f"for {known}")
        text = str(title).strip()
        found = [i for i, one in enumerate(table.titles) if one.strip().lower() == text.lower()]
        if not found and text.isdecimal() and 1 <= int(text) <= table.width:
            found = [int(text) - 1]
        if len(found) != 1:
            have = ", ".join(table.titles) or f"{table.width} columns without titles"
            several = "several columns" if found else "no column"
            raise RimrollError(f'{table.name} has {several} "{text}"; it has {have}')
        places[what] = found[0]
    if len(set(places.values())) < len(places):
        raise RimrollError(field="columns", value=dict(columns or {}), bound="different ones")
    return places


def time_column(table: Table, beside: str = "") -> int:
    """The place of the column of times: by its title, its unit, and the numbers in it.

    Of several, it is one with a unit of time, one whose title begins as that ``beside`` it, or any
    of those that count the same times. Raises ``RimrollError`` for none, and where they differ.
    """
    titles = titles_of(table)
    named = [i for i, one in enumerate(titles) if one.is_time]
    found = [i for i in named if _numbers(table, i) is not None] or named
    with_unit = [i for i, one in enumerate(titles) if one.seconds is not None]
    beside_it = [i for i, one in enumerate(titles) if one.name.split()[:1] == beside.split()[:1]]
    plain = [i for i, one in enumerate(titles) if one.name in ("t", "time")]
    for better in (with_unit, beside_it, plain):
        found = [i for i in found if i in better] or found
    if len(found) > 1 and _are_alike([_since_first(table, i, titles[i]) for i in found]):
        found = found[:1]
    if len(found) != 1:
        several = "several columns" if found else "no column"
        raise RimrollError(
            f"{table.name} has {several} of times, such as t (s); it has"
            f' {", ".join(table.titles)}: say which, as in columns={{"t": "…"}} (on the command'
            " line --columns t=…)"
        )
    return found[0]


def _numbers(table: Table, place: int) -> Array | None:
    """The numbers of a column; None where a cell is none."""
    try:
        return np.array([float(row.cells[place]) for row in table.rows])
    except (ValueError, IndexError):
        return None


def _since_first(table: Table, place: int, title: Title) -> Array | None:
    numbers = _numbers(table, place)
    return None if numbers is None else (numbers - numbers[0]) * (title.seconds or 1.0)


def _are_alike(times: list[Array | None]) -> bool:
    """Whether columns count the same times, to a quarter of a step."""
    known = [one for one in times if one is not None]
    if len(known) < len(times) or not len(known[0]):
        return False
    step = float(known[0][-1]) / max(len(known[0]) - 1, 1)
    return all(float(np.abs(one - known[0]).max()) <= 0.25 * step for one in known[1:])


def seconds_of(where: str, title: Title, time_unit: str | None) -> tuple[float, bool]:
    """The factor of a column of times to s, and whether a title or the user says it.

    Raises ``UnitError`` for what is no unit of time, and where the two differ.
    """
    given = None if time_unit is None else _unit_of_time(time_unit, "time_unit")
    if title.unit is None:
        return (1.0, False) if given is None else (given, True)
    written = _unit_of_time(title.unit, f"{where}: the unit of {title.name or 'the times'}")
    if given is not None and given != written:
        raise UnitError(f'{where}: the times are in {title.unit}, but time_unit is "{time_unit}"')
    return written, True


def _unit_of_time(unit: str, field: str) -> float:
    if not isinstance(unit, str):
        raise UnitError(field=field, value=unit, bound='a unit of time such as "ms"')
    known = SECONDS.get(unit.strip().lower())
    return known if known is not None else factor_of(unit, "s", field, unit)


def expect_step(
    where: str,
    kind: str,
    step: float,
    is_stated: bool,
    way_out: str = 'time_unit="{0}" (on the command line --time-unit {0})',
) -> None:
    """Raise ``RimrollError`` for a step (s) that no record of this kind has.

    ``is_stated`` says whether the file or the user states the unit of the times; ``way_out`` how
    to give it.
    """
    if SHORTEST <= step <= (LONGEST if is_stated else LONGEST_BARE):
        return
    likely = [unit for unit in LIKELY if 1e-4 <= step * SECONDS[unit] <= LONGEST_BARE]
    unit = likely[0] if likely else None
    if is_stated:
        raise RimrollError(
            f"{where}: a step of {step:g} s is none of a {kind}, which has {SHORTEST:g} to"
            f" {LONGEST:g} s" + (f": the times may be in {unit}" if unit else ": check the unit")
        )
    raise RimrollError(
        f"{where}: the times have no unit and are taken as seconds, but a {kind} has no step of"
        f" {step:g} s" + (f"; they look like {unit}" if unit else "") + ": write the unit into the"
        f" title, as in time ({unit or 's'}), or give {way_out.format(unit or 's')}"
    )
