"""Records from files: one, or several from a folder."""

from __future__ import annotations

import math
import os
import re
from collections.abc import Mapping, Sequence
from dataclasses import replace
from itertools import takewhile
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from rimroll.errors import RimrollError
from rimroll.files.table import Source, source_name, text_of
from rimroll.ground.at2 import Component, component_of, is_at2, station_of
from rimroll.ground.columns import (
    DOWN,
    UP,
    Direction,
    Layout,
    axis_of,
    columns_of,
    direction_of,
    expect_strength,
    given_direction,
)
from rimroll.ground.ground import Ground
from rimroll.ground.pulses import along, sampled
from rimroll.ground.streams import EAST
from rimroll.units import Number

Array = NDArray[np.float64]

RIGHT_ANGLE = math.pi / 2.0
ASKEW = math.radians(1.0)
"""How far two horizontal components may be from perpendicular, rad."""


def read(
    *files: Source,
    headings: Sequence[Number] | None = None,
    units: str | None = None,
    component: str | None = None,
    pad: bool = False,
    columns: Mapping[str, str | int] | None = None,
    step: Number | None = None,
    time_unit: str | None = None,
) -> Ground:
    """A record from files, whose format is known by their content.

    **AT2** (PEER, OpenSees): a file for each component, one to three. The direction is read from
    the end of line 2: a heading in degrees clockwise from north, or UP, VER, DWN and the like. x
    points in the direction of the first horizontal file, y at a right angle to its left, seen from
    above, and z upward. So if the second horizontal file points to the right of the first, its sign
    is changed, and so is that of a vertical file that points down. :attr:`Ground.heading` is that
    of x. The horizontal directions must be perpendicular within 1 degree. Where line 2 names the
    axes of the instrument, L, T and V, or H1 and H2, these are x, y and z, and the heading is not
    known. The
    unit g is 9.80665 m/s².

    **CSV**: one file, with a line of names of columns and their units: ``t (s)``, and ``ax``,
    ``ay``, ``az``, or one column of any name, in ``(m/s2)``, ``[g]``, ``(cm/s2)``, ``(gal)`` or
    another unit of acceleration. E, N, Z or EW, NS, UD are x, y and z, too. Velocities and
    displacements beside them are passed over, and so are lines above the names. Commas, semicolons,
    tabs or spaces separate columns. Times must have equal steps; the first is taken as t = 0. At
    most 20 MB are read from a file.

    For other formats see :func:`from_obspy`.

    Raises ``RimrollError``, with file and line, for files that are cut, hold text among their
    numbers or another number of samples than they say, for other quantities and unknown units; for
    steps and accelerations that no record has, such as times in milliseconds without a unit; and
    for components that differ in step or length, or whose directions do not go together.

    Parameters
    ----------
    files
        Paths, or binary streams.
    headings
        The directions of AT2 files in place of those in line 2, one for each: texts as there,
        ``"230"``, ``"N40E"``, ``"up"``, or angles clockwise from north, rad or with a unit.
    units
        The unit of the acceleration where the file names none.
    component
        ``"x"``, ``"y"`` or ``"z"``: the axis of a single component. By default it is z for a
        vertical one and x for any other.
    pad
        Whether AT2 files that are shorter than the longest get zeros at their end. This is right
        where all components begin at the same time, which the files do not say.
    columns
        The names, or numbers from 1, of the columns ``"t"``, ``"x"``, ``"y"`` and ``"z"`` of a
        table, where they are not found by their names. Those that are not given are not read.
    step
        The time between two samples of a table without times, s.
    time_unit
        The unit of the times of a table where their name has none: ``"ms"``, ``"us"``, ``"ns"``.
        They are taken as seconds otherwise.
    """
    if component not in (None, "x", "y", "z"):
        raise RimrollError(field="component", value=component, bound='"x", "y" or "z"')
    layout = Layout(units, component, columns, step, time_unit)
    return record_of(texts_of(files), layout, headings, pad)


def texts_of(files: Sequence[Source]) -> list[tuple[str, str]]:
    """The name and the text of each file.

    Raises ``RimrollError`` for one that is empty, no text, or in a format that is not read.
    """
    if not files:
        raise RimrollError("must be one or more, got none", "files")
    hint = f"; for miniSEED, SAC and other binary files, {OBSPY}"
    texts = [(name := source_name(file), text_of(name, file, if_binary=hint)) for file in files]
    for name, text in texts:
        if not text.strip():
            raise RimrollError(f"{name} is empty")
        refuse_other_format(name, text)
    return texts


def record_of(
    texts: Sequence[tuple[str, str]],
    layout: Layout,
    headings: Sequence[Number] | None = None,
    pad: bool = False,
) -> Ground:
    """The record in files with these names and texts; arguments and errors as for :func:`read`."""
    if all(is_at2(text) for _, text in texts):
        layout.expect_none_of_tables(texts[0][0])
        components = [component_of(*one, layout.units) for one in texts]
        return _of_components(_of_one_length(components, pad), headings, layout.component)
    if len(texts) > 1:
        table = next(name for name, text in texts if not is_at2(text))
        raise RimrollError(
            f"{table} is no AT2 file; a CSV file holds all components and is read alone"
        )
    if headings is not None:
        raise RimrollError("headings are for AT2 files: a CSV file names its components x, y and z")
    name = texts[0][0]
    found = columns_of(*texts[0], layout)
    expect_strength(name, float(np.abs(found.samples).max()))
    return Ground(sampled(found.step, found.samples).core, EAST if found.is_compass else None)


def _of_one_length(components: list[Component], pad: bool) -> list[Component]:
    """Components with the same step and number of samples; if ``pad``, with zeros at their end."""
    first, longest = components[0], max(components, key=lambda one: len(one.samples))
    for other in components[1:]:
        if other.step != first.step:
            raise RimrollError(
                f"{other.name} has a step of {other.step:g} s, but {first.name} of {first.step:g} s"
            )
    missing = [len(longest.samples) - len(one.samples) for one in components]
    if any(missing) and not pad:
        shorter = " and ".join(
            f"{one.name} is shorter than {longest.name} by {count} of {len(longest.samples)}"
            f" samples ({count * one.step:g} s)"
            for one, count in zip(components, missing, strict=True)
            if count
        )
        raise RimrollError(
            f"{shorter}: if all begin at the same time, pad=True (on the command line --pad) adds"
            " zeros at the end"
        )
    return [
        replace(one, samples=np.pad(one.samples, (0, count)))
        for one, count in zip(components, missing, strict=True)
    ]


def _of_components(
    components: list[Component], headings: Sequence[Number] | None, axis: str | None
) -> Ground:
    first = components[0]
    for one in components:
        expect_strength(one.name, float(np.abs(one.samples).max()))
    directions = _directions(components, headings)
    if len(components) == 1:
        return _alone(first, directions[0], axis)
    if axis is not None:
        raise RimrollError(f"component is for a single one, and there are {len(components)} files")
    if None in directions and (placed := _on_axes(components, directions)) is not None:
        return sampled(first.step, placed)
    samples = np.zeros((len(first.samples), 3))
    horizontal: list[tuple[Component, float]] = []
    vertical: list[Component] = []
    for one, direction in zip(components, directions, strict=True):
        if direction is None:
            raise RimrollError(
                f"{one.name}: line 2 does not end with a direction: give headings, as in"
                ' headings=("0 deg", "90 deg", "up") (on the command line --headings 0,90,up)'
            )
        if isinstance(direction, str):
            vertical.append(one)
            samples[:, 2] = one.samples if direction == UP else -one.samples
        else:
            horizontal.append((one, direction))
    if len(vertical) > 1 or len(horizontal) > 2:
        which = vertical if len(vertical) > 1 else [one for one, _ in horizontal]
        names = " and ".join(one.name for one in which)
        kind = "vertical" if len(vertical) > 1 else "horizontal"
        raise RimrollError(
            f"{names} are all {kind}: a record has two horizontal components and one vertical"
        )
    samples[:, 0] = horizontal[0][0].samples
    if len(horizontal) == 2:
        samples[:, 1] = _sign_of_second(*horizontal) * horizontal[1][0].samples
    return Ground(sampled(first.step, samples).core, horizontal[0][1])


def _on_axes(components: list[Component], directions: list[Direction | None]) -> Array | None:
    """The samples where line 2 names axes of the instrument, such as L, T and V; None where not."""
    axes = [
        one.axis if direction is None else ("z" if isinstance(direction, str) else None)
        for one, direction in zip(components, directions, strict=True)
    ]
    if None in axes or len(set(axes)) < len(axes):
        return None
    samples = np.zeros((len(components[0].samples), 3))
    for one, direction, axis in zip(components, directions, axes, strict=True):
        samples[:, "xyz".index(str(axis))] = one.samples * (-1.0 if direction == DOWN else 1.0)
    return samples


def _directions(
    components: list[Component], headings: Sequence[Number] | None
) -> list[Direction | None]:
    if headings is None:
        return [one.direction for one in components]
    given = [headings] if isinstance(headings, str) else list(headings)
    if len(given) != len(components):
        raise RimrollError(
            field="headings", value=len(given), bound=f"one for each file, {len(components)}"
        )
    return [given_direction(f"headings[{i}]", value) for i, value in enumerate(given)]


def _alone(one: Component, direction: Direction | None, axis: str | None) -> Ground:
    """A single component; a heading is that of x, and known of a component along x or y."""
    vertical = isinstance(direction, str)
    along_axis = axis or ("z" if vertical else "x")
    sign = -1.0 if direction == DOWN and along_axis == "z" else 1.0
    ground = sampled(one.step, along(along_axis, sign * one.samples))
    if direction is None or isinstance(direction, str) or along_axis == "z":
        return ground
    heading = direction if along_axis == "x" else direction + RIGHT_ANGLE
    return Ground(ground.core, heading % math.tau)


def _sign_of_second(first: tuple[Component, float], second: tuple[Component, float]) -> float:
    """1 if the second horizontal component points to the left of the first, -1 if to the right."""
    to_right = math.remainder(second[1] - first[1], math.tau)
    if abs(abs(to_right) - RIGHT_ANGLE) > ASKEW:
        angles = [f"{math.degrees(one[1]):g}" for one in (first, second)]
        raise RimrollError(
            f"{first[0].name} points to {angles[0]} degrees and {second[0].name} to {angles[1]}:"
            " horizontal components must be perpendicular; if line 2 says something else, give"
            " headings"
        )
    return -1.0 if to_right > 0.0 else 1.0


OBSPY = 'read it with ObsPy: rr.ground.from_obspy(obspy.read(FILE), "m/s2")'
TABLE = (
    "write its accelerations as a CSV file with the columns t (s), ax (m/s2), ay (m/s2), az (m/s2)"
)
NUMBERS = (
    "keep its numbers, one a line, and give their step and unit, as in --step 0.01s --units cm/s2"
)

_FORMATS = (
    (r"\AOrigin Time\b[\s\S]*^Sampling Freq", "K-NET or KiK-net", OBSPY),
    (r"^EVENT_NAME:[\s\S]*^(EVENT_ID|SAMPLING_INTERVAL_S|STATION_CODE|STREAM|UNITS):", "ESM (DYNA)",
     NUMBERS),
    (r"\A[\s\S]{0,400}\(Format v[\s\d.]+ with", "COSMOS", NUMBERS),
    (r"\A\s*\d?\s*(UN)?CORRECTED ACCELEROGRAM[^\n]*\n\*", "SMC (USGS)", NUMBERS),
    (r"\A[\s\S]{0,400}\b(UN)?CORRECTED ACCELEROGRAM", "CSMIP and USGS (V1, V2)", NUMBERS),
    (r"STRONG[ -](GROUND[ -])?MOTION RECORDS? OF T|^(PLACE|EARTHQUAKE DATE|STATION ID)\s*:[\s\S]*"
     r"^(SAMPLING INTERVAL|NUMBER OF DATA|RAW[_ ]PGA)", "AFAD", NUMBERS),
)  # fmt: skip

HEAD = 5000
"""Characters in which a format is looked for."""


def refuse_other_format(name: str, text: str) -> None:
    """Raise ``RimrollError`` for a file in a format of records that is known and not read."""
    for pattern, called, way_out in _FORMATS:
        if re.search(pattern, text[:HEAD], re.IGNORECASE | re.MULTILINE):
            raise RimrollError(
                f"{name} is in the format of {called}, which rimroll does not read: {way_out}, or"
                f" {TABLE}"
            )


PathLike = str | os.PathLike[str]

Named = tuple[str, str]
"""The name and the text of a file."""

LOOSE_ENDS = " _-.,#"
"""What the name of a record does not end with."""


def read_all(
    *files: PathLike | Sequence[PathLike],
    units: str | None = None,
    pad: bool = False,
    columns: Mapping[str, str | int] | None = None,
    step: Number | None = None,
    time_unit: str | None = None,
) -> dict[str, Ground]:
    """Several records from files, by name: a folder of AT2 files becomes its records.

    AT2 files of the same earthquake and station are the components of one record: those with the
    same line 2, up to the direction at its end. Each CSV file is a record. Names are what the names
    of the files begin with. :func:`rimroll.shake_many` takes the result as it is.

    Raises ``RimrollError`` as :func:`read`, for a file that is given twice, and for files whose
    second lines differ in a last word that may name a component and is no direction.

    Parameters
    ----------
    files
        Paths. A list of paths holds the files of one record, whatever their second lines say.
    units, pad, columns, step, time_unit
        As for :func:`read`.
    """
    single, lists = [], []
    for file in files:
        if isinstance(file, str | os.PathLike):
            single.append(Path(file))
        else:
            lists.append([Path(one) for one in file])
    _expect_once([*single, *(path for group in lists for path in group)])
    groups = [*_by_station(texts_of(single) if single else []), *map(texts_of, lists)]
    if not groups:
        raise RimrollError("must be one or more, got none", "files")
    _expect_components_together(groups[: len(groups) - len(lists)])
    layout = Layout(units, None, columns, step, time_unit)
    grounds = [record_of(texts, layout, pad=pad) for texts in groups]
    return dict(zip(_names(groups), grounds, strict=True))


def _expect_once(paths: list[Path]) -> None:
    for place, path in enumerate(paths):
        if path in paths[:place]:
            raise RimrollError(f"{path} is given twice")


def _by_station(texts: list[Named]) -> list[list[Named]]:
    """The files of each record, in the order in which they are given."""
    groups: dict[str, list[Named]] = {}
    for name, text in texts:
        station = station_of(text).casefold() if is_at2(text) else ""
        groups.setdefault(station or f"file {name}", []).append((name, text))
    return list(groups.values())


_CODE = re.compile(r"[A-Za-z]{1,4}\d?|\d{4}")
"""A word that may name a component: no heading, and no number of a station such as #6."""


def _expect_components_together(groups: list[list[Named]]) -> None:
    """Refuse files of one station whose second lines end with codes that are no directions."""
    ends: dict[str, tuple[str, str]] = {}
    for group in groups:
        name, text = group[0]
        before, comma, last = station_of(text).rpartition(",") if is_at2(text) else ("", "", "")
        code = last.strip()
        if not comma or not _CODE.fullmatch(code):
            continue
        if before in ends:
            other, its = ends[before]
            raise RimrollError(
                f"{other} and {name}: line 2 ends with {its} and {code}, no directions: for one"
                " record give headings, as in read(A, B, headings=(0, 90 deg)) (rimroll shake"
                " --headings 0,90); read two records apart"
            )
        ends[before] = name, code


def _names(groups: list[list[Named]]) -> list[str]:
    """A name for each record: how the names of its files begin, or else that of the first."""
    stems = [[Path(name).stem for name, _ in group] for group in groups]
    short = [_beginning(some) for some in stems]
    names = short if all(short) and len(set(short)) == len(short) else [some[0] for some in stems]
    if len(set(names)) < len(names):  # files of one name in several folders
        names = [group[0][0] for group in groups]
    return names


def _beginning(words: list[str]) -> str:
    """What all words begin with; if they can be taken for it, before their directions."""
    if len(words) == 1:
        return words[0]
    same = takewhile(lambda letters: len(set(letters)) == 1, zip(*words, strict=False))
    start = "".join(letters[0] for letters in same)
    for length in range(len(start), 0, -1):
        rest = [word[length:].strip(LOOSE_ENDS) for word in words]
        if all(map(_is_direction, rest)):
            return start[:length].rstrip(LOOSE_ENDS)
    return start.rstrip(LOOSE_ENDS)


def _is_direction(word: str) -> bool:
    """Whether a word is the direction in the name of a file: three digits, or UP and the like."""
    if word.isdigit():
        return len(word) == 3
    return direction_of(word) is not None or axis_of(word) is not None
