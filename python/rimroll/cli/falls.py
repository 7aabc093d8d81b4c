"""The numbers of many falls, or of many shaken bodies, as files: in rows or laid out in a plane."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from rimroll.cli.formats import Forms, write_csv, write_json
from rimroll.cli.screen import Bar
from rimroll.many.falls import Column, Falls

DIRECTION = "of fall or of the largest tilt, anticlockwise from that of the first lean"

ROWS = 20_000  # written between two looks at the progress bar

SMALL_INTEGERS = 2**31  # netCDF's; a larger seed is written down as text


def _csv(part: Path, falls: Falls, bar: Bar) -> None:
    """A row for each fall, numbers in full."""
    columns = _columns(falls)
    write_csv(part, columns, _rows(falls, columns, bar), {**falls.attrs, **_comments(falls)})


def _comments(falls: Falls) -> dict[str, str]:
    return {"direction": DIRECTION} if "direction" in falls.columns else {}


def _rows(falls: Falls, columns: dict[str, NDArray[Any]], bar: Bar) -> Iterator[tuple[str, ...]]:
    for first in range(0, falls.size, ROWS):
        bar(first, falls.size, "")
        some = (_texts(column[first : first + ROWS]) for column in columns.values())
        yield from zip(*some, strict=True)


def _columns(falls: Falls) -> dict[str, NDArray[Any]]:
    """The columns of a table of falls by ``name[unit]``, those for people first."""
    others = [(name, column) for name, column in falls.columns.items() if name != "outcome"]
    first: dict[str, NDArray[Any]] = {}
    if "direction" in falls.columns:  # not of shaken bodies
        first["direction[deg]"] = np.degrees(falls["direction"]).ravel()
        first["outcome"] = falls["outcome"].ravel()
    return {
        **first,
        **_plane(falls),
        **{_name(name, column): column.values.ravel() for name, column in others},
    }


def _plane(falls: Falls) -> dict[str, NDArray[Any]]:
    """Where in its plane each fall of a map is; nothing for falls in rows."""
    if len(falls.axes) == 1:
        return {}
    across = np.meshgrid(*(axis.values for axis in falls.axes.values()), indexing="ij")
    return {
        _name(name, axis): values.ravel()
        for (name, axis), values in zip(falls.axes.items(), across, strict=True)
    }


def _name(name: str, column: Column) -> str:
    return f"{name}[{column.units}]" if column.units else name


def _texts(column: NDArray[Any]) -> list[str]:
    """Numbers in full; flags as 0 and 1; a text with a comma in quotes."""
    if column.dtype.kind == "U":
        return [f'"{text}"' if "," in text else text for text in column.tolist()]
    return [*map(repr, (column.astype(int) if column.dtype == bool else column).tolist())]


def _netcdf(part: Path, falls: Falls, bar: Bar) -> None:
    seed = falls.attrs.get("seed", 0)
    attributes = {"seed": str(seed)} if seed >= SMALL_INTEGERS else {}
    falls.with_attrs(attributes).to_xarray().to_netcdf(part, engine="scipy")


def _json(part: Path, falls: Falls, bar: Bar) -> None:
    columns = falls.columns.items()
    content = {
        "parameters": falls.attrs,
        "units": {name: column.units for name, column in columns if column.units is not None},
        "comments": _comments(falls),
        "coordinates": {name: axis.values for name, axis in falls.axes.items()},
        "falls": {name: column.values for name, column in columns},
    }
    write_json(part, content)


NUMBERS: Forms[Falls] = {".csv": _csv, ".nc": _netcdf, ".json": _json}
"""By suffix."""
