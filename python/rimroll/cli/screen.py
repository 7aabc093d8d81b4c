"""Output of commands: tables and JSON on stdout, progress on stderr."""

from __future__ import annotations

import json
import math
import textwrap
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from typing import Any

import numpy as np
from rich import box
from rich.console import Console
from rich.table import Table

WIDTH = 79  # of prose

NO_BREAK = "\N{NO-BREAK SPACE}"
"""A space at which prose is not broken; it is printed as a plain space."""

Bar = Callable[[int, int, str], None]
"""Takes what is done, what is to do in all, and what comes next."""


def say(*what: object) -> None:
    """Print lines or tables on stdout, in words only: nothing in them is taken for markup.

    A table that a terminal is too narrow for becomes a list, so that nothing is cut off.
    """
    console = Console(highlight=False, markup=False, emoji=False, soft_wrap=True)
    for item in what or ("",):
        if not isinstance(item, Table):
            console.print(item)
            continue
        width = console.measure(item, options=console.options.update(max_width=10_000)).maximum
        if width <= console.width:
            console.print(item)
        elif console.is_terminal:
            console.print(_list(item))
        else:  # wider than any terminal; a width given to print() cannot widen it
            Console(width=width, highlight=False, markup=False).print(item)


def prose(text: str, hanging: int = 4) -> None:
    """Print a sentence on stdout in lines of at most 79 characters.

    The second line and all after it are indented by ``hanging`` spaces.
    """
    lines = textwrap.wrap(
        text,
        WIDTH,
        subsequent_indent=" " * hanging,
        break_long_words=False,
        break_on_hyphens=False,
    )
    say("\n".join(lines).replace(NO_BREAK, " "))


def unbroken(words: str) -> str:
    """Words that :func:`prose` keeps on one line, such as a number and its unit."""
    return words.replace(" ", NO_BREAK)


def _list(rows: Table) -> str:
    """The rows of a table one below the other, a line for each cell."""
    names = [str(column.header) for column in rows.columns]
    width = max(map(len, names))
    cells = zip(*(column.cells for column in rows.columns), strict=True)
    return "\n\n".join(
        "\n".join(f"{name:<{width}}  {cell}" for name, cell in zip(names, row, strict=True) if cell)
        for row in cells
    )


def table(*columns: str) -> Table:
    """A table whose first column is text and the others are numbers."""
    made = Table(box=box.SIMPLE, show_edge=False, pad_edge=False)
    for i, column in enumerate(columns):
        made.add_column(column, justify="right" if i else "left", no_wrap=True)
    return made


def show_json(content: Mapping[str, Any]) -> None:
    """Print JSON on stdout."""
    print(json.dumps(plain(content), indent=2, ensure_ascii=False, allow_nan=False))


def plain(value: Any) -> Any:
    """Numbers and arrays as JSON knows them; what is not finite is null."""
    if isinstance(value, Mapping):
        return {str(key): plain(item) for key, item in value.items()}
    if isinstance(value, list | tuple):
        return [plain(item) for item in value]
    if isinstance(value, np.ndarray | np.generic):
        array = np.asarray(value)
        if array.dtype.kind == "f" and not np.isfinite(array).all():
            finite = np.isfinite(array)
            array = array.astype(object)
            array[~finite] = None
        return array.tolist()
    if isinstance(value, float) and not math.isfinite(value):
        return None
    return value


def angle(radians: float) -> str:
    """An angle in degrees, to a thousandth; smaller ones to four digits."""
    degrees = math.degrees(radians)
    return f"{degrees:.3f}°" if abs(degrees) >= 1.0 or degrees == 0.0 else f"{degrees:.4g}°"


def _silent(done: int, total: int, what: str) -> None:
    """A bar without output."""


@contextmanager
def working(title: str) -> Iterator[Bar]:
    """A progress bar on stderr, if that is a terminal, until the block ends."""
    console = Console(stderr=True)
    if not console.is_terminal:
        yield _silent
        return
    from rich.progress import BarColumn, Progress, SpinnerColumn, TextColumn, TimeRemainingColumn

    columns = (
        SpinnerColumn(),
        TextColumn("{task.description}"),
        BarColumn(),
        TimeRemainingColumn(),
    )
    with Progress(*columns, console=console, transient=True) as bar:
        task = bar.add_task(title, total=None)
        bar.refresh()

        def advance(done: int, total: int, what: str = "") -> None:
            description = f"{title}: {what}" if what else title
            bar.update(task, completed=done, total=total, description=description)

        yield advance
