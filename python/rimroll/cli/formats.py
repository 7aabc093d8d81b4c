"""Files that commands write: a form for each suffix, and whole files or none."""

from __future__ import annotations

import json
from collections.abc import Callable, Collection, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar

from rimroll.cli.screen import Bar, plain, working
from rimroll.errors import RimrollError
from rimroll.output import ensure_folder, writing

if TYPE_CHECKING:
    from matplotlib.figure import Figure

T = TypeVar("T")
Forms = Mapping[str, Callable[[Path, T, Bar], None]]
"""What writes a thing to a path, by suffix."""


def check(files: Sequence[Path], suffixes: Collection[str]) -> None:
    """Raise ``RimrollError``, before the work, for what could not be written after it."""
    for file in files:
        if file.suffix.lower() not in suffixes:
            known = ", ".join(suffixes)
            raise RimrollError(f"cannot write {file}: its suffix must be one of {known}")
        ensure_folder(file.parent)


def write(file: Path, thing: T, forms: Forms[T]) -> None:
    """Write a thing in the form of the file's suffix; the file appears when it is whole.

    Raises ``RimrollError`` when it cannot be written, for instance because the disk is full.
    """
    try:
        with working(f"writing {file.name}") as bar, writing(file) as part:
            forms[file.suffix.lower()](part, thing, bar)
    except OSError as error:
        raise RimrollError(f"cannot write {file}: {error.strerror or error}") from error


def pictures(draw: Callable[[T], Figure], dpi: int = 200) -> Forms[T]:
    """The forms of a picture."""

    def picture(part: Path, thing: T, bar: Bar) -> None:
        from rimroll.style import save  # brings matplotlib, which is slow to load

        save(draw(thing), part, dpi)

    return dict.fromkeys((".png", ".svg", ".pdf"), picture)


def write_json(part: Path, content: Mapping[str, Any]) -> None:
    """Write JSON; what is not finite is null."""
    text = json.dumps(plain(content), ensure_ascii=False, allow_nan=False)
    part.write_text(text + "\n", encoding="utf-8")
