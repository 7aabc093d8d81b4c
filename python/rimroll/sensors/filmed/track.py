"""What a film shows of a body, from files: Tracker's export, and any table with titles."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from rimroll.errors import RimrollError
from rimroll.files.table import Source, Table, source_name, table_of, text_of
from rimroll.files.titles import columns_given, expect_step
from rimroll.units import factor_of

Array = NDArray[np.float64]

MIN_SAMPLES = 12
"""Samples that a track must have."""
KINDS = ("path", "lean", "tilt")


@dataclass(frozen=True, eq=False, repr=False)
class Track:
    """The path of a marker seen from above, or the lean of a body, at times.

    Raises ``RimrollError`` for fewer than 12 samples, for times that do not increase, and for
    numbers that are not finite.

    Attributes
    ----------
    t
        Times, s, (n,), increasing.
    values
        (n, 2) for ``"path"``, x and y in m; (n, 2) for ``"lean"``, tilt and direction of lean in
        rad; (n, 1) for ``"tilt"``, the tilt in rad.
    kind
        ``"path"``, ``"lean"`` or ``"tilt"``.
    name, source, notes
        What messages call it, how the file was understood, and what is unusual.
    """

    t: Array
    values: Array
    kind: str = "path"
    name: str = "a track"
    source: str = ""
    notes: tuple[str, ...] = ()

    def __post_init__(self) -> None:
        if self.kind not in KINDS:
            raise RimrollError(field="kind", value=self.kind, bound='"path", "lean" or "tilt"')
        t, values = np.asarray(self.t, float), np.asarray(self.values, float)
        width = 1 if self.kind == "tilt" else 2
        if t.ndim != 1 or values.shape != (len(t), width):
            raise RimrollError(
                f"{self.name}: times must be (n,) and values (n, {width}),"
                f" got {t.shape} and {values.shape}"
            )
        if len(t) < MIN_SAMPLES:
            raise RimrollError(
                f"{self.name} must have at least {MIN_SAMPLES} samples, it has {len(t)}"
            )
        if not (np.isfinite(t).all() and np.isfinite(values).all()):
            raise RimrollError(f"{self.name} has numbers that are not finite")
        if not (np.diff(t) > 0.0).all():
            raise RimrollError(f"{self.name}: the times must increase: keep one run")
        object.__setattr__(self, "t", t)
        object.__setattr__(self, "values", values)

    def __repr__(self) -> str:
        return f"<Track: {self.kind}, {len(self.t)} samples over {self.t[-1] - self.t[0]:.2f} s>"

    def plane(self) -> NDArray[np.complex128]:
        """The track in a plane: x + i y in m, or the tilt, in rad, along the direction of lean."""
        if self.kind == "path":
            return np.asarray(self.values[:, 0] + 1j * self.values[:, 1])
        if self.kind == "lean":
            return np.asarray(self.values[:, 0] * np.exp(1j * self.values[:, 1]))
        return np.asarray(self.values[:, 0] + 0j)


_TITLE = re.compile(r"(.*?)\s*(?:[\[(]\s*([^\[\]()]*?)\s*[\])])?")
_MEANING = {
    **dict.fromkeys(("t", "time"), "t"),
    "x": "x",
    "y": "y",
    **dict.fromkeys(("tilt", "phi", "φ", "lean"), "tilt"),
    **dict.fromkeys(("heading", "direction", "azimuth", "psi", "ψ"), "heading"),
}
_UNIT = {"t": "s", "x": "m", "y": "m", "tilt": "rad", "heading": "rad"}
_ALIASES = {"°": "deg", "degrees": "deg", "sec": "s", "seconds": "s"}
_KINDS = {"path": ("x", "y"), "lean": ("tilt", "heading"), "tilt": ("tilt",)}


def read(
    file: Source,
    *,
    mass: str | None = None,
    units: Mapping[str, str] | None = None,
    columns: Mapping[str, str | int] | None = None,
) -> Track:
    """A filmed track from a file.

    Tracker (Open Source Physics) exports a line with the name of the mass and a line of titles,
    ``t x y``, separated by tabs, commas or semicolons; several masses follow a line ``#multi:``.
    Any other table with such titles is read, too. Columns are ``t``, and ``x`` and ``y``, or
    ``tilt`` with or without ``heading`` (the direction of lean). Units in brackets hold;
    otherwise ``units``. Without either, times are in s and lengths in m. Angles must have a unit.

    Raises ``RimrollError``, with file and line, for a file that is no such table, text among
    numbers, missing units of angles, and several masses of which none is named.

    Parameters
    ----------
    file
        A path, or a binary stream.
    mass
        The name of the mass, where the file holds several.
    units
        The units of columns without one, as in ``{"x": "cm", "y": "cm"}``.
    columns
        The titles, or numbers from 1, of ``"t"``, ``"x"``, ``"y"``, ``"tilt"``, ``"heading"``,
        where they are not found by their titles.

    Returns
    -------
    Track
        Its ``source`` says how the file was understood. Lines in which the mass was not marked
        are left out, which a note says.
    """
    name = source_name(file)
    text, above, masses = _below_names(text_of(name, file))
    table = table_of(name, text, has_columns=True)
    if not table.titles:
        raise RimrollError(f"{name}: a line must name the columns, as in t, x, y")
    places = _places(table, _span(name, table, masses, mass), columns or {})
    kind = next((k for k, own in _KINDS.items() if all(one in places for one in own)), None)
    if kind is None or "t" not in places:
        raise RimrollError(
            f"{name} must have columns t, x and y, or t and tilt; it has"
            f' {", ".join(table.titles)}: name them, as in columns={{"x": "…"}}'
        )
    wanted = ("t", *_KINDS[kind])
    factors = {one: _factor(table, places[one], one, units or {}) for one in wanted}
    values, missing = _numbers(table, [places[one] for one in wanted], above)
    values *= np.array([factors[one][0] for one in wanted])
    if len(values) >= MIN_SAMPLES:
        is_stated = factors["t"][2]
        step = float(np.median(np.diff(values[:, 0])))
        way_out = 'units={{"t": "{0}"}} (on the command line --units t={0})'
        if step > 0.0:
            expect_step(name, "film", step, is_stated, way_out)
    if kind == "lean":
        values[:, 2] = np.unwrap(values[:, 2])
    notes = (f"Lines without a marked position were left out: {missing}.",) if missing else ()
    said = ", ".join(f"{table.titles[places[one]]} in {factors[one][1]}" for one in wanted)
    source = f"{kind}: {said}; {len(values)} samples"
    return Track(values[:, 0], values[:, 1:], kind, name, source, notes)


def _below_names(text: str) -> tuple[str, int, list[str]]:
    """The text from its titles on, the number of lines above, and the masses in their columns."""
    lines = text.splitlines()
    above, masses = 0, []
    for i, line in enumerate(lines[:20]):
        cells = [cell.strip() for cell in re.split(r"[\t,;]", line)]
        if len(cells) >= 2 and any(_meaning(cell) is not None for cell in cells):
            above = i
            before = lines[i - 1] if i else ""
            named = [cell.strip() for cell in re.split(r"[\t,;]", before)]
            masses = named if i > 1 and lines[i - 2].startswith("#multi") else []
            break
    return "\n".join(_filled(lines[above:])), above, masses


def _filled(lines: list[str]) -> list[str]:
    """The lines with "nan" in cells that are empty, as at frames in which nothing was marked."""
    mark = next((one for one in "\t;," if lines and one in lines[0]), None)
    if mark is None:
        return lines
    width = len(lines[0].rstrip(f"{mark} ").split(mark))
    out = lines[:1]
    for line in lines[1:]:
        cells = line.split(mark)
        cells += [""] * (width - len(cells))
        empty = [not cell.strip() for cell in cells[:width]]
        if not any(empty) or all(empty):
            out.append(line)
            continue
        out.append(mark.join(cell if cell.strip() else "nan" for cell in cells[:width]))
    return out


def _meaning(title: str) -> str | None:
    parts = _TITLE.fullmatch(title.strip().strip('"'))
    return _MEANING.get(parts[1].lower()) if parts else None


def _span(name: str, table: Table, masses: list[str], mass: str | None) -> range:
    """The columns of the mass that is asked for."""
    starts = [i for i, one in enumerate(masses) if one]
    names = [masses[i] for i in starts]
    if not names or (mass is None and len(names) == 1):
        return range(table.width)
    if mass is None:
        raise RimrollError(
            f'{name} holds several masses, {", ".join(names)}: say which, as in mass="{names[0]}"'
        )
    if mass not in names:
        raise RimrollError(f'{name} has no mass "{mass}"; it has {", ".join(names)}')
    k = names.index(mass)
    end = starts[k + 1] if k + 1 < len(starts) else table.width
    return range(starts[k], min(end, table.width))


def _places(table: Table, span: range, columns: Mapping[str, str | int]) -> dict[str, int]:
    """The column of each quantity."""
    places: dict[str, int] = {}
    for i in range(table.width):
        what = _meaning(table.titles[i])
        if what is None or what in columns or (what != "t" and i not in span):
            continue
        if what in places:
            raise RimrollError(
                f"{table.name} has two columns for {what}:"
                f" {', '.join(table.titles)}: name the mass or the columns"
            )
        places[what] = i
    return places | columns_given(table, columns, tuple(_UNIT))


def _factor(
    table: Table, place: int, what: str, units: Mapping[str, str]
) -> tuple[float, str, bool]:
    """The factor of a column, its unit, and whether that is stated."""
    parts = _TITLE.fullmatch(table.titles[place].strip())
    unit = (parts[2] if parts else None) or units.get(what)
    if unit is None:
        if _UNIT[what] == "rad":
            raise RimrollError(
                f"{table.name}: the column {table.titles[place]} names no unit: give it, as in"
                f' units={{"{what}": "deg"}}'
            )
        return 1.0, _UNIT[what], False
    spelled = _ALIASES.get(unit, unit)
    if spelled == "deg" and _UNIT[what] == "rad":
        return math.radians(1.0), unit, True
    return factor_of(spelled, _UNIT[what], f"{table.name}: the unit of {what}", unit), unit, True


def _numbers(table: Table, places: list[int], above: int) -> tuple[Array, int]:
    """The numbers (n, k) of the rows that have all of them, and how many rows do not."""
    rows = []
    for row in table.rows:
        cells = [row.cells[place] for place in places]
        try:
            numbers = [float(cell) for cell in cells]
        except ValueError:
            line = row.line + above
            raise RimrollError(
                f"{table.name}, line {line}: {', '.join(cells)} are not all numbers"
            ) from None
        if np.isfinite(numbers).all():
            rows.append(numbers)
    return np.array(rows).reshape(-1, len(places)), len(table.rows) - len(rows)
