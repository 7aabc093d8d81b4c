"""Columns that tables of many falls and of many shaken bodies have in common."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from rimroll.falls import Column, Falls, Interrupted
from rimroll.rows import Rows
from rimroll.units import START_UNIT_OF, UNIT_OF

Array = NDArray[np.float64]

Meaning = tuple[str, str, str | None]
"""The unit of a column, a name that fits an axis, and a comment if it needs one."""

LOSSES: dict[str, Meaning] = {
    "energy_lost": ("J", "energy lost", "energy lost to friction, resistances and impacts"),
    "friction_loss": ("J", "energy lost to friction", None),
    "resistance_loss": (
        "J",
        "energy lost to resistances",
        "energy lost to rolling resistance, pivoting friction and air",
    ),
}
"""The losses of energy, except for that in impacts."""


BLOCK = 1024
"""Rows that are transposed at a time: they fit in the cache of a core."""


def transposed(table: Array) -> Array:
    """A table (n, k) as columns (k, n), each of which lies in one piece."""
    found = np.empty(table.shape[::-1])
    for first in range(0, len(table), BLOCK):
        rows = slice(first, first + BLOCK)
        found[:, rows] = table[rows].T
    return found


def energy_lost(found: Mapping[str, Array]) -> Array:
    """The sum of all losses, J."""
    return found["friction_loss"] + found["resistance_loss"] + found["impact_loss"]


def inputs(rows: Rows, varied: Mapping[str, Array], done: int) -> dict[str, Column]:
    """The starts, and what differs from row to row of body and law, of the first rows."""
    return {
        **{
            f"start_{name}": Column(column[:done], START_UNIT_OF[name])
            for name, column in rows.starts._asdict().items()
        },
        **{
            f"body_{name}": Column(np.broadcast_to(column, rows.grid.size)[:done], UNIT_OF[name])
            for name, column in rows.bodies._asdict().items()
            if np.ndim(rows.given[name])
        },
        **{f"law_{name}": Column(column[:done]) for name, column in varied.items()},
    }


def unless_stopped(falls: Falls, stopped: Any) -> Falls:
    """The falls; raises ``Interrupted`` with them on Ctrl-C, and any other exception itself."""
    if isinstance(stopped, KeyboardInterrupt):
        raise Interrupted(falls) from None
    if stopped is not None:
        raise stopped
    return falls
