"""Laws in the form of the core."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, NamedTuple

from rimroll import _core
from rimroll.grid import Grid


class OneLaw(NamedTuple):
    """The name of a law and its numbers, as the core reads them."""

    name: str
    numbers: dict[str, float]


def only_fixed(name: str, numbers: Mapping[str, Any], varied: Mapping[str, Any]) -> OneLaw:
    """The law of that name without the numbers that are varied."""
    return OneLaw(name, {key: value for key, value in numbers.items() if key not in varied})


def check(fixed: OneLaw, varied: Mapping[str, Any]) -> None:
    """Raise ``RimrollError`` naming the first number that is out of bounds.

    ``varied`` are the numbers that are arrays.
    """
    if not varied:
        _core.check_contact_law(fixed)
        return
    grid = Grid.over(varied)
    columns = {name: grid.flat(value) for name, value in varied.items()}
    bad = _core.first_bad_contact_law(fixed, columns)
    if bad is not None:
        row, error = bad
        raise grid.placed(error, varied, row)
