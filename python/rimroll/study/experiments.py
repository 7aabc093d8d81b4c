"""The experiments of the rows of a study of fits."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Annotated, Any

import numpy as np
from numpy.typing import NDArray

from rimroll.errors import hold
from rimroll.scenario.tables import Table, checked, in_unit, made
from rimroll.study.given import Block, key_in

Array = NDArray[np.float64]

MAX_FALLS = 100_000
MIN_FALLS = 3


class _Experiment(Table):
    falls: Annotated[float, in_unit("1")] = 42.0
    reading_error: Annotated[float, in_unit("rad")] = math.radians(2.0)
    bias: Annotated[float, in_unit("rad")] = math.radians(2.0)


def experiments_of(table: Mapping[str, Any], block: Block) -> dict[str, Array]:
    """The number of falls, the error of reading and the standard deviation of the bias (rad).

    Raises ``RimrollError`` for fewer than 3 falls or more than 100 000, and for negative errors.
    """
    read = checked(_Experiment, dict(table), "[fit]").model_dump()
    found = {name: np.full(block.count, value) for name, value in read.items()}
    for one in block.of("fit"):
        found[key_in(one)] = one.array
    made("[fit]", lambda: _check(found))
    return found


def _check(found: Mapping[str, Array]) -> None:
    falls = found["falls"]
    whole = (falls >= MIN_FALLS) & (falls <= MAX_FALLS) & (falls == np.floor(falls))
    hold("falls", falls, whole, f"whole, between {MIN_FALLS} and {MAX_FALLS}")
    for name in ("reading_error", "bias"):
        hold(name, found[name], found[name] >= 0.0, ">= 0", "rad")
