"""Laws in the form of the core."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, NamedTuple

from rimroll import _core
from rimroll.grid import Grid
from rimroll.laws.parameters import fixed_numbers, varied_numbers


class OneLaw(NamedTuple):
    """The name of a law and its numbers, as the core reads them."""

    name: str
    numbers: dict[str, float]


def check(name: str, numbers: Mapping[str, Any]) -> None:
    """Raise ``RimrollError`` naming the first number that is out of bounds."""
    varied, fixed = varied_numbers(numbers), OneLaw(name, fixed_numbers(numbers))
    if not varied:
        _core.check_contact_law(fixed)
        return
    grid = Grid.over(varied)
    columns = {name: grid.flat(value) for name, value in varied.items()}
    bad = _core.first_bad_contact_law(fixed, columns)
    if bad is not None:
        row, error = bad
        raise grid.placed(error, numbers, row)
