"""Files that commands write: a form for each suffix, and whole files or none."""

from __future__ import annotations

import json
import shutil
import sys
from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import TYPE_CHECKING, Any, TypeVar

from rimroll.cli.screen import Bar, plain, working
from rimroll.errors import RimrollError
from rimroll.files.output import place_of, writing

if TYPE_CHECKING:
    from matplotlib.figure import Figure

T = TypeVar("T")
Forms = Mapping[str, Callable[[Path, T, Bar], None]]
"""The functions that write something to a path, by suffix."""


STDOUT = Path("-")
"""In place of a file: standard output, which gets .csv and nothing else."""


def form_of(file: Path) -> str:
    """The suffix that says in which form a file is written."""
    return ".csv" if file == STDOUT else file.suffix.lower()


def check(files: Sequence[Path], suffixes: Collection[str], json: bool = False) -> None:
    """Raise ``RimrollError``, before the work, for what could not be written after it.

    ``json`` says whether standard output is taken by an answer in JSON.
    """
    places: dict[Path, Path] = {}
    for file in files:
        if form_of(file) not in suffixes:
            known = ", ".join(suffixes)
            what = "standard output" if file == STDOUT else str(file)
            raise RimrollError(f"cannot write {what}: its suffix must be one of {known}")
        if file == STDOUT and json:
            raise RimrollError("--json and -o - both go to standard output: give one")
        place = file if file == STDOUT else place_of(file)
        if place in places:
            twice = f"{file} twice" if places[place] == file else f"{places[place]} and {file}"
            raise RimrollError(f"-o gives the same file again: {twice}")
        places[place] = file


def write(file: Path, thing: T, forms: Forms[T]) -> None:
    """Write a thing in the form of the file's suffix; the file appears when it is whole.

    Raises ``RimrollError`` when it cannot be written, for instance because the disk is full.
    """
    if file == STDOUT:
        _to_stdout(thing, forms[form_of(file)])
        return
    try:
        with working(f"writing {file.name}") as bar, writing(file) as part:
            forms[form_of(file)](part, thing, bar)
    except OSError as error:
        raise RimrollError(f"cannot write {file}: {error.strerror or error}") from error


def _to_stdout(thing: T, form: Callable[[Path, T, Bar], None]) -> None:
    with TemporaryDirectory(prefix="rimroll-") as folder, working("writing") as bar:
        part = Path(folder) / "standard_output"
        form(part, thing, bar)
        with part.open("rb") as file:
            sys.stdout.flush()
            shutil.copyfileobj(file, sys.stdout.buffer)
            sys.stdout.buffer.flush()


def write_csv(
    part: Path,
    names: Iterable[str],
    rows: Iterable[Iterable[str]],
    comments: Mapping[str, object],
) -> None:
    """Write a line of names, the rows, and then the comments, as lines that begin with #.

    Names come first and comments last, so that a spreadsheet sees one whole table, and
    ``pandas.read_csv(file, comment="#")`` and ``numpy.genfromtxt(file, delimiter=",", names=True)``
    read it.
    """
    with part.open("w", encoding="utf-8", newline="\n") as file:
        file.write(",".join(names) + "\n")
        file.writelines(",".join(row) + "\n" for row in rows)
        file.writelines(f"# {name} = {value}\n" for name, value in comments.items())


def pictures(draw: Callable[[T], Figure], dpi: int = 200) -> Forms[T]:
    """The forms of a picture."""

    def picture(part: Path, thing: T, bar: Bar) -> None:
        from rimroll.figures.style import save  # brings matplotlib, which is slow to load

        save(draw(thing), part, dpi)

    return dict.fromkeys((".png", ".svg", ".pdf"), picture)


def write_json(part: Path, content: Mapping[str, Any]) -> None:
    """Write JSON; what is not finite is null."""
    text = json.dumps(plain(content), ensure_ascii=False, allow_nan=False)
    part.write_text(text + "\n", encoding="utf-8")
