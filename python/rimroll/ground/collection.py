"""Several records from files."""

from __future__ import annotations

import os
import re
from collections.abc import Mapping, Sequence
from itertools import takewhile
from pathlib import Path

from rimroll.errors import RimrollError
from rimroll.given import Number
from rimroll.ground.at2 import is_at2, station_of
from rimroll.ground.columns import Layout
from rimroll.ground.files import record_of, texts_of
from rimroll.ground.ground import Ground
from rimroll.ground.names import axis_of, direction_of

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
