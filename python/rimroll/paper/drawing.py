"""What a figure of the report is."""

from __future__ import annotations

from dataclasses import dataclass, field

from matplotlib.figure import Figure


@dataclass(frozen=True)
class Table:
    """A table under a figure: texts only, a row a line."""

    caption: str
    head: list[str]
    rows: list[list[str]]


@dataclass(frozen=True)
class Drawing:
    """A drawn figure and what it shows.

    ``caption`` is HTML (inline markup only); ``numbers`` are the figure's results by name, in SI
    units and radians or as the name says, for ``numbers.json``.
    """

    slug: str
    title: str
    figure: Figure
    caption: str
    numbers: dict[str, object] = field(default_factory=dict)
    table: Table | None = None
