"""What motions and falls were computed from, as their datasets record it."""

from __future__ import annotations

from dataclasses import fields
from typing import TYPE_CHECKING

from rimroll.errors import RimrollError, expect
from rimroll.given import Values, numbers
from rimroll.options import Options
from rimroll.state import State
from rimroll.units import START_UNIT_OF

if TYPE_CHECKING:
    import xarray as xr


def start_of(dataset: xr.Dataset) -> State:
    """The start of a motion, or the starts of falls (n,).

    Raises ``RimrollError`` for a dataset without them, as a map of falls, whose plane has them.
    """
    names = [field.name for field in fields(State)]
    given: dict[str, Values] = {}
    for name in names:
        if (key := f"start_{name}") in dataset:
            given[name] = numbers(key, dataset[key], START_UNIT_OF[name])
        elif key in dataset.attrs:
            given[name] = numbers(key, dataset.attrs[key], START_UNIT_OF[name])
        else:
            raise RimrollError(f"this dataset records no start: there is no {key} in it")
    return State(**given)


def options_of(dataset: xr.Dataset) -> Options:
    """The options of a motion or of falls.

    Raises ``RimrollError`` for a dataset without them.
    """
    told = {field.name: dataset.attrs.get(field.name) for field in fields(Options)}
    for name, value in told.items():
        if value is None and name != "topple_tilt":
            raise RimrollError(f"this dataset records no options: there is no {name} in it")
    return Options.read(**told)


def expect_dataset(value: object) -> None:
    """Raise ``RimrollError`` unless the value is an ``xarray.Dataset``."""
    import xarray as xr

    expect("dataset", value, xr.Dataset)
