"""The view of a motion in notebooks."""

from __future__ import annotations

from collections.abc import Sequence
from html import escape
from typing import TYPE_CHECKING

import numpy as np

from rimroll.motion.shaken import shaken_in_words

if TYPE_CHECKING:
    from rimroll.motion.motion import Motion

SHOWN = 6  # turns of a motion


def motion_in_html(motion: Motion) -> str:
    """The ending of a motion, its first turns as a table in degrees, and what it lost."""
    rows = [
        (
            str(number),
            f"{np.degrees(turn.angle):.4f}°",
            f"{np.degrees(turn.min_tilt):.4g}°",
            f"{turn.t:.6g} s",
        )
        for number, turn in enumerate(motion.turns[:SHOWN], 1)
    ]
    head = f"<p><b>Motion</b>, {escape(repr(motion.law))}: {escape(motion.message)}</p>"
    ground = f"<p>{escape(shaken_in_words(motion))}</p>" if motion.ground is not None else ""
    more = len(motion.turns) - len(rows)
    rest = f"<p>and {more} more turns</p>" if more else ""
    return f"<div>{head}{ground}{_table(rows)}{rest}{_losses(motion)}</div>"


def _losses(motion: Motion) -> str:
    """The energy that was lost by the end, J, by cause."""
    lost = ", ".join(
        f"{loss[-1]:.4g} J to {name}"
        for name, loss in (
            ("friction", motion.friction_loss),
            ("resistances", motion.resistance_loss),
            ("impacts", motion.impact_loss),
        )
    )
    return f"<p>lost: {lost}</p>"


def _table(rows: Sequence[tuple[str, ...]]) -> str:
    if not rows:
        return "<p>no turns</p>"
    names = ("turn", "angle", "smallest tilt", "at t")
    head = "".join(f"<th>{name}</th>" for name in names)
    body = "".join(
        "<tr>" + "".join(f"<td>{escape(cell)}</td>" for cell in row) + "</tr>" for row in rows
    )
    return f"<table><thead><tr>{head}</tr></thead><tbody>{body}</tbody></table>"
