"""Views in notebooks: titles, tables and sentences as HTML."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from html import escape

CELL = 'style="text-align: left; padding-right: 1em"'


def view(title: str, *parts: str) -> str:
    """A view with a title in bold; the parts are HTML."""
    return f"<div><p><b>{escape(title)}</b></p>{''.join(parts)}</div>"


def table(rows: Iterable[Sequence[str]], head: Sequence[str] = ()) -> str:
    """A table of texts."""
    titles = "".join(f"<th {CELL}>{escape(name)}</th>" for name in head)
    top = f"<thead><tr>{titles}</tr></thead>" if head else ""
    body = "".join(
        "<tr>" + "".join(f"<td {CELL}>{escape(cell)}</td>" for cell in row) + "</tr>"
        for row in rows
    )
    return f"<table>{top}<tbody>{body}</tbody></table>"


def sentences(texts: Iterable[str]) -> str:
    """A list of sentences."""
    items = "".join(f"<li>{escape(text)}</li>" for text in texts)
    return f"<ul>{items}</ul>" if items else ""


def degrees(angle: float, decimals: int = 2) -> str:
    """An angle (rad) in degrees."""
    return f"{math.degrees(angle):.{decimals}f}°"
