"""The view of a motion in notebooks."""

from __future__ import annotations

from html import escape
from typing import TYPE_CHECKING

from rimroll.figures.notebook import table
from rimroll.motion.parts import TURN_HEAD, turn_cells
from rimroll.motion.shaken import shaken_in_words

if TYPE_CHECKING:
    from rimroll.motion.motion import Motion

SHOWN = 6  # turns of a motion


def motion_in_html(motion: Motion) -> str:
    """The ending of a motion, its first turns as a table in degrees, and what it lost."""
    rows = [(str(number), *turn_cells(turn)) for number, turn in enumerate(motion.turns[:SHOWN], 1)]
    head = f"<p><b>Motion</b>, {escape(repr(motion.law))}: {escape(motion.message)}</p>"
    ground = f"<p>{escape(shaken_in_words(motion))}</p>" if motion.ground is not None else ""
    more = len(motion.turns) - len(rows)
    turns = table(rows, ("turn", *TURN_HEAD)) if rows else "<p>no turns</p>"
    rest = f"<p>and {more} more turns</p>" if more else ""
    return f"<div>{head}{ground}{turns}{rest}{_losses(motion)}</div>"


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
