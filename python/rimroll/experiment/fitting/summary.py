"""Directions of fall that stand in for published means and spreads."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from rimroll.errors import RimrollError
from rimroll.experiment.fitting.predicted import TURN
from rimroll.experiment.normal import quantiles
from rimroll.given import number, whole_number

Array = NDArray[np.float64]


def directions_from_summary(
    *, left: tuple[float, float, int], right: tuple[float, float, int]
) -> Array:
    """Directions (n,), rad, whose turns have exactly the given means and spreads.

    ``left`` and ``right``: mean turn, standard deviation (rad) and number of the falls to a side.
    The values are spread like a normal distribution; for normal errors, the likelihood depends on
    the data only through mean, spread and number.
    """
    sides = []
    for name, sign, given in (("left", 1.0, left), ("right", -1.0, right)):
        if not isinstance(given, tuple | list) or len(given) != 3:
            raise RimrollError(field=name, value=given, bound="a mean, a spread and a count")
        mean, spread, count = given
        n = whole_number(f"{name} count", count)
        mean = number(f"{name} mean", mean, "rad")
        spread = number(f"{name} spread", spread, "rad")
        if not (math.isfinite(mean) and 0.0 <= spread < math.inf):
            raise RimrollError(field=name, value=(mean, spread), bound="a mean and a spread >= 0")
        if n < 2:
            raise RimrollError(f"{name} needs at least 2 falls, got {n}")
        normal = quantiles((np.arange(n) + 0.5) / n)
        sides.append(sign * (mean + spread * normal / normal.std(ddof=1)))
    return np.asarray(np.mod(np.concatenate(sides), TURN))
