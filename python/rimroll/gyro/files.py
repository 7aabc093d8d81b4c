"""Records of gyroscopes from files: phyphox, PocketLab, Vernier, and any table with names."""

from __future__ import annotations

import io
import os
import zipfile
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from rimroll.errors import RimrollError
from rimroll.given import Number, number
from rimroll.gyro.phyphox import SIMULATED
from rimroll.gyro.record import Record
from rimroll.gyro.times import with_even_notes
from rimroll.gyro.titles import Chosen, chosen_columns
from rimroll.table import MOST_BYTES, Source, Table, UnevenRow, source_name, table_of, text_of

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
