"""The line of a map of falls at which their side changes: from theory, or by bisection."""

from __future__ import annotations

from dataclasses import fields, replace
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from rimroll.body import body_of
from rimroll.falls import Falls
from rimroll.laws import IDEAL, law_of
from rimroll.left_or_right import goes_left, halved, watershed_slope
from rimroll.many_falls import OPTIONS, fell
from rimroll.options import Options
from rimroll.state import State

if TYPE_CHECKING:
    import xarray as xr

Array = NDArray[np.float64]

ROWS = 60
"""Largest number of rows in which bisection seeks the line; between them it is nearly straight."""

HALVINGS = 8
"""Bisections between two starts of a map: to less than a picture shows."""


def side_line(falls: Falls | xr.Dataset, lowest: float, highest: float) -> tuple[Array, Array]:
    """Yaw and spin rates along the line between falls to the right and to the left, rad/s.

    Under the ideal laws it is straight, from one spin rate to the other. Under friction it has a
    point for each row of the map (for some rows of a large map) in which the side changes once,
    from right to left. Without such rows, or without falls, the arrays are empty.
    """
    falls = Falls.of(falls)
    law, tilt = law_of(falls), falls.attrs["start_tilt"]
    if not fell(falls).any():
        return np.empty(0), np.empty(0)
    if law not in IDEAL:
        return _by_bisection(falls)
    spin = np.array([lowest, highest] if tilt < 0.5 * np.pi else [])
    slope = watershed_slope(body_of(falls), tilt, law) if spin.size else 0.0
    return slope * spin, spin


def _by_bisection(falls: Falls) -> tuple[Array, Array]:
    attrs = falls.attrs
    rows = np.unique(np.linspace(0, len(falls["spin_rate"]) - 1, ROWS).astype(int))
    between = {k: ends for k in rows if (ends := _change(falls, k)) is not None}
    low, high = np.array([*between.values()]).reshape(-1, 2).T
    spin = falls["spin_rate"][[*between]] if between else np.empty(0)
    start = {name: attrs[f"start_{name}"] for name in ("tilt", "tilt_rate", "yaw", "spin")}
    options = replace(
        OPTIONS,
        **{field.name: attrs[field.name] for field in fields(Options) if field.name in attrs},
    )
    body, law = body_of(falls), law_of(falls)

    def to_the_left(yaw_rate: Array) -> NDArray[np.bool_]:
        starts = State(**start, yaw_rate=yaw_rate, spin_rate=spin)
        return goes_left(body, starts, law, options)

    return halved(to_the_left, low, high, HALVINGS), spin


def _change(falls: Falls, row: int) -> tuple[float, float] | None:
    """The yaw rates between which the side changes in a row of a map, if it does so once."""
    turn = falls["turn"][row]
    known = np.flatnonzero(~np.isnan(turn))
    left = turn[known] > 0.0
    changes = np.flatnonzero(left[1:] & ~left[:-1])
    if len(changes) != 1:
        return None
    low, high = falls["yaw_rate"][known[[changes[0], changes[0] + 1]]]
    return float(low), float(high)
