"""Figures of the report."""

from __future__ import annotations

from dataclasses import dataclass, field

from matplotlib.figure import Figure


@dataclass(frozen=True)
class Table:
    """A table under a figure, as texts."""

    caption: str
    head: list[str]
    rows: list[list[str]]


@dataclass(frozen=True)
class Drawing:
    """A drawn figure and what it shows.

    ``caption`` is HTML (inline markup only). ``numbers`` are the figure's results by name for
    ``numbers.json``, in SI units and radians or in the unit in the name.
    """

    slug: str
    title: str
    figure: Figure
    caption: str
    numbers: dict[str, object] = field(default_factory=dict)
    table: Table | None = None
