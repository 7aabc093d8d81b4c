"""Records of gyroscopes from files: phyphox, PocketLab, Vernier, and any table with names."""

from __future__ import annotations

import io
import os
import re
import zipfile
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from rimroll.errors import RimrollError, UnitError
from rimroll.files.table import MOST_BYTES, Source, Table, UnevenRow, source_name, table_of, text_of
from rimroll.files.titles import Title, columns_given, seconds_of, time_column, titles_of
from rimroll.sensors.gyro.record import SIMULATED, Record, with_even_notes
from rimroll.units import Number, factor_of, number

_GYRO = re.compile(
    r"gyr|angular (velocity|rate|speed)|angvel|rotation ?rate|drehrate|winkelgeschwindigkeit"
    r"|\bomega|^w ?[xyz]$|ω"
)
_OTHER = re.compile(r"\bacc|magnet|\bmag\b|orient|\bangle|grav|baro|press|temper|\babs|\bnorm")
_ACCELERATION = re.compile(r"\bacc(el|eleration|elerometer)?( ?[xyz])?\b|beschleunigung")
_AXIS_IN_WORD = re.compile(r"(?:gyro?|omega|g|w|rot|rate|angvel|ω)([xyz])|([xyz])(?:gyro?|rate)")

_RATES = {
    **dict.fromkeys(("rad/s", "rad/sec", "rads/s", "rad s^-1", "rad·s⁻¹", "radians/s"), "rad/s"),
    **dict.fromkeys(
        ("deg/s", "°/s", "º/s", "dps", "deg/sec", "degrees/s", "degree/s", "°/sec", "degrees/sec"),
        "deg/s",
    ),
    **dict.fromkeys(("rad_s", "rads_s", "rads", "rad_sec", "radians/sec"), "rad/s"),
    **dict.fromkeys(("deg_s", "degs", "degrees_s", "deg_sec", "degrees per second"), "deg/s"),
    "mdps": "mdeg/s",
}


@dataclass(frozen=True)
class Chosen:
    """Places of the columns, factors to s and rad/s, and how they were understood."""

    t: int
    axes: tuple[int, int, int]
    seconds: float
    is_stated: bool
    """Whether the unit of the times is stated."""
    factor: float
    in_words: str


def chosen_columns(
    table: Table,
    units: str | None,
    columns: Mapping[str, str | int] | None,
    time_unit: str | None,
) -> Chosen:
    """The columns, by what the user named or by their titles; errors as for ``read``."""
    given = columns_given(table, columns, ("t", "x", "y", "z"))
    if not table.titles and len(given) < len("txyz"):
        raise RimrollError(
            f"{table.name}: the first line must name the columns, with units, as in Time (s),"
            " Gyroscope x (rad/s), …; or give columns by their numbers, as in"
            ' columns={"t": 1, "x": 2, "y": 3, "z": 4} (on the command line'
            " --columns t=1,x=2,y=3,z=4)"
        )
    names = titles_of(table)
    missing = [axis for axis in "xyz" if axis not in given]
    found = _axes(table, names, [given[one] for one in given]) if missing else {}
    axes = tuple(given.get(axis, found.get(axis, -1)) for axis in "xyz")
    assert len(axes) == 3
    t = given["t"] if "t" in given else time_column(table, names[axes[0]].name)
    if len({t, *axes}) < len(axes) + 1:
        raise RimrollError(f"{table.name}: two of t, x, y and z are the same column")
    factor, unit = _factor(table, [names[i].unit for i in axes], units)
    seconds, is_stated = seconds_of(table.name, names[t], time_unit)
    written = [table.titles[i] if table.titles else f"column {i + 1}" for i in (t, *axes)]
    in_unit = f" in {time_unit}" if names[t].unit is None and time_unit is not None else ""
    spelled = f"times {written[0]}{in_unit}; rates {', '.join(written[1:])} in {unit}"
    return Chosen(t, axes, seconds, is_stated, factor, spelled)


def _axes(table: Table, titles: list[Title], given: list[int]) -> dict[str, int]:
    """The column of each axis."""
    names = {i: one for i, one in enumerate(titles) if i not in given and not one.is_time}
    rates = [i for i, one in names.items() if _is_rate(one.unit)]
    known = [i for i, one in names.items() if one.unit is None or i in rates]
    gyro = [i for i in known if _GYRO.search(names[i].name)]
    plain = [i for i in rates if not _OTHER.search(names[i].name) and i not in gyro]
    bare = [i for i, one in names.items() if one.name in ("x", "y", "z") and one.unit is None]
    for some in (gyro, plain, bare):
        axes = [(axis, i) for i in some if (axis := _axis(names[i].name)) is not None]
        places = {axis: [i for other, i in axes if other == axis] for axis in "xyz"}
        if all(len(one) == 1 for one in places.values()):
            return {axis: one[0] for axis, one in places.items()}
        if any(len(one) > 1 for one in places.values()):
            raise RimrollError(
                f"{table.name} has the rates of several runs or sensors; it has"
                f" {', '.join(table.titles)}: say which columns,"
                ' as in columns={"x": "…", "y": "…", "z": "…"} (on the command line --columns)'
            )
    if not rates and _holds_accelerations(names.values()):
        raise RimrollError(
            f"{table.name} holds accelerations; the turn needs the gyroscope (in phyphox:"
            " Gyroscope, rotation rate)"
        )
    raise RimrollError(
        f"{table.name} has no columns for the x, y and z of a gyroscope; it has"
        f" {', '.join(table.titles)}: name them,"
        ' as in columns={"x": "…", "y": "…", "z": "…"} (on the command line --columns)'
    )


def _holds_accelerations(titles: Iterable[Title]) -> bool:
    """Whether two or three axes of an accelerometer are among the columns."""
    found = [
        _axis(one.name)
        for one in titles
        if _ACCELERATION.search(one.name) or _is_acceleration(one.unit)
    ]
    return len(set(found) - {None}) >= 2


def _axis(name: str) -> str | None:
    """The axis in the words of a title, alone or in one of them: gyroscope x, gx, axis y."""
    words = name.split()
    found = [word for word in words if word in ("x", "y", "z")]
    if not found:
        parts = [_AXIS_IN_WORD.fullmatch(word) for word in words]
        found = [one[1] or one[2] for one in parts if one]
    return found[0] if len(set(found)) == 1 else None


def _is_rate(unit: str | None) -> bool:
    return unit is not None and unit.lower() in _RATES


def _is_acceleration(unit: str | None) -> bool:
    return unit is not None and unit.lower().replace("²", "2").replace("^", "") in ("m/s2", "g")


def _factor(table: Table, written: list[str | None], units: str | None) -> tuple[float, str]:
    """The factor to rad/s, and the unit."""
    if len({_known(table, unit) if unit else None for unit in written}) > 1:
        several = ", ".join(sorted(map(str, set(written))))
        raise UnitError(f"{table.name}: the rates have different units: {several}")
    unit = written[0]
    if unit is None and units is None:
        raise UnitError(
            f"{table.name}: the columns of rates name no unit: give it, as in"
            ' units="rad/s" or units="deg/s" (on the command line --units)'
        )
    given = None if units is None else factor_of(_spelled(units), "rad/s", "units", units)
    if unit is None:
        assert units is not None and given is not None
        return given, units
    factor = _known(table, unit)
    if given is not None and given != factor:
        raise UnitError(f'{table.name}: the rates are in {unit}, but units is "{units}"')
    return factor, unit


def _known(table: Table, unit: str) -> float:
    return factor_of(_spelled(unit), "rad/s", f"{table.name}: the unit of the rates", unit)


def _spelled(unit: str) -> str:
    return _RATES.get(unit.strip().lower(), unit)


Array = NDArray[np.float64]

_ZIP = b"PK\x03\x04"
_COLUMNS = 4
"""A time and three axes."""


def read(
    file: Source,
    *,
    units: str | None = None,
    columns: Mapping[str, str | int] | None = None,
    time_unit: str | None = None,
    between: tuple[Number, Number] | None = None,
) -> Record:
    """The record of a gyroscope from a file.

    A file is a CSV file with the titles of its columns, their units in brackets: as phyphox exports
    it, alone or in a zip file (``Time (s)``, ``Gyroscope x (rad/s)``, …); with columns for angular
    velocity as PocketLab and Vernier have them (``Angular Velocity X (deg/s)``,
    ``Data Set 1:Gyro x (°/s)``), SensorLog (``motionRotationRateX(rad/s)``) or Sensor Logger
    (``seconds_elapsed``, ``z``, ``y``, ``x``); or any other, whose columns you name. Commas,
    semicolons or tabs separate columns, decimals follow a point or a comma. At most 20 MB are read.
    Samples that come in packets, with one time for several, are spread evenly between the times.

    Raises ``RimrollError``, with file and line, for a file of something else, such as
    accelerations; for text among the numbers; for times that go back, and for packets that do not
    come evenly; for units that are missing or contradict each other; and for times that no
    gyroscope has, such as milliseconds without a unit.

    Parameters
    ----------
    file
        A path, or a binary stream.
    units
        The unit of the rates where the titles have none: ``"rad/s"`` or ``"deg/s"``.
    columns
        The titles, or numbers from 1, of the columns ``"t"``, ``"x"``, ``"y"`` and ``"z"``, where
        they are not found by their titles.
    time_unit
        The unit of the times where their title has none: ``"ms"``, ``"us"``, ``"ns"``. They are
        taken as seconds otherwise.
    between
        Two times, s: only the samples from the first to the second are read.

    Returns
    -------
    Record
        Its ``source`` says in a line how the file was understood, and its ``notes`` what is
        unusual: gaps, repeated times, uneven steps, rates that are cut off, a last line that is
        not complete.
    """
    name, text = _text(file)
    simulated = text.startswith(SIMULATED)
    table, cut = _table(name, text)
    chosen = chosen_columns(table, units, columns, time_unit)
    notes = ["The last line is not complete and was left out."] if cut else []
    t, rates = _numbers(table, chosen)
    lines = np.array([row.line for row in table.rows])
    if between is not None:
        start, end = (number("between", one, "s") for one in between)
        if not start < end:
            raise RimrollError(
                field="between",
                value=(start, end),
                bound="an earlier and a later time",
                unit="s",
            )
        inside = (t >= start) & (t <= end)
        t, rates, lines = t[inside], rates[inside], lines[inside]
    record, more = with_even_notes(name, t, rates, lines, chosen.is_stated)
    source = f"{chosen.in_words}; {len(record)} samples, {record.sampling_rate:.4g} Hz"
    return replace(record, source=source, notes=(*notes, *more), simulated=simulated)


def _text(file: Source) -> tuple[str, str]:
    """What messages call a file, and its text; of a zip file, that of the gyroscope's table."""
    name = source_name(file)
    if isinstance(file, str | os.PathLike):
        try:
            with Path(file).open("rb") as stream:
                head = stream.read(4)
        except (OSError, ValueError):
            head = b""  # text_of says why
    else:
        read = file.read(MOST_BYTES + 1)
        head, file = read[:4], io.BytesIO(read)
    if head != _ZIP:
        hint = ": a record of some minutes is enough; cut out the part with the falls"
        return name, text_of(name, file, if_large=hint)
    return _text_in_zip(name, file)


def _text_in_zip(name: str, file: Source) -> tuple[str, str]:
    try:
        with zipfile.ZipFile(file) as archive:
            entries = archive.infolist()
            if any(entry.filename.startswith("xl/") for entry in entries):
                raise RimrollError(f"{name} is an Excel file: export it as CSV")
            tables = [
                entry
                for entry in entries
                if entry.filename.lower().endswith((".csv", ".txt", ".tsv"))
                and "meta/" not in entry.filename
                and not entry.filename.startswith("__MACOSX")
            ]
            gyroscopes = [one for one in tables if "gyro" in one.filename.lower()]
            wanted = gyroscopes or tables
            if len(wanted) != 1:
                names = ", ".join(one.filename for one in tables) or "no CSV file"
                raise RimrollError(
                    f"{name} must hold one table of a gyroscope, it holds {names}: unpack it and"
                    " give the file"
                )
            if wanted[0].file_size > MOST_BYTES:
                raise RimrollError(
                    f"{name}: {wanted[0].filename} is larger than {MOST_BYTES // 1_000_000} MB"
                )
            inside = f"{name}: {wanted[0].filename}"
            return inside, text_of(inside, io.BytesIO(archive.read(wanted[0])))
    except (zipfile.BadZipFile, NotImplementedError, RuntimeError, OSError) as error:
        raise RimrollError(f"{name} does not read as a zip file: {error}") from None


def _table(name: str, text: str) -> tuple[Table, bool]:
    """The table, without a last line that was cut; whether there was one."""
    try:
        return table_of(name, text, has_columns=True), False
    except UnevenRow as error:
        whole = text.rstrip("\r\n")
        end = whole.rfind("\n")
        if error.line != whole.count("\n") + 1 or end < 0:
            raise
    return table_of(name, whole[:end], has_columns=True), True


def _numbers(table: Table, chosen: Chosen) -> tuple[Array, Array]:
    """Times (n,), s, and rates (n, 3), rad/s."""
    places = [chosen.t, *chosen.axes]
    values = np.empty((len(table.rows), _COLUMNS))
    for i, row in enumerate(table.rows):
        for j, place in enumerate(places):
            cell = row.cells[place]
            try:
                values[i, j] = float(cell)
            except ValueError:
                values[i, j] = np.nan
            if not np.isfinite(values[i, j]):
                what = f'"{cell}" is no number' if cell else "a number is missing"
                raise RimrollError(f"{table.name}, line {row.line}: {what}")
    return values[:, 0] * chosen.seconds, values[:, 1:] * chosen.factor
