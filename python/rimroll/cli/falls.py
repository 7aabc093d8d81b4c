"""The numbers of many falls as files, in rows or laid out in a plane."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from rimroll.cli.formats import Forms, write_json
from rimroll.cli.screen import Bar

if TYPE_CHECKING:
    import xarray as xr

DIRECTION = "of fall or of the largest tilt, anticlockwise from that of the first lean"

ROWS = 20_000  # written between two looks at the progress bar

SMALL_INTEGERS = 2**31  # netCDF's; a larger seed is written down as text


def _csv(part: Path, falls: xr.Dataset, bar: Bar) -> None:
    """One line of ``name[unit]``, comments with the parameters, and a row a fall in full."""
    columns = _columns(falls)
    with part.open("w", encoding="utf-8", newline="\n") as file:
        file.write(",".join(columns) + "\n")
        for name, value in {**falls.attrs, "direction": DIRECTION}.items():
            file.write(f"# {name} = {value}\n")
        for first in range(0, falls.outcome.size, ROWS):
            bar(first, falls.outcome.size, "")
            some = (_texts(column[first : first + ROWS]) for column in columns.values())
            file.writelines(f"{','.join(row)}\n" for row in zip(*some, strict=True))


def _columns(falls: xr.Dataset) -> dict[str, NDArray[Any]]:
    """The columns of a table of falls by ``name[unit]``, those for people first."""
    outcome = falls["outcome"]
    plane = [falls[name] for name in outcome.dims if name != "trial"]
    others = [falls[name] for name in falls.data_vars if name != "outcome"]
    return {
        "direction[deg]": np.degrees(falls["direction"].values).ravel(),
        "outcome": outcome.values.ravel(),
        **{_name(one): one.broadcast_like(outcome).values.ravel() for one in [*plane, *others]},
    }


def _name(column: xr.DataArray) -> str:
    unit = column.attrs.get("units")
    return f"{column.name}[{unit}]" if unit else str(column.name)


def _texts(column: NDArray[Any]) -> list[str]:
    """Numbers in full; flags as 0 and 1."""
    if column.dtype.kind == "U":
        return list(column.tolist())
    return [*map(repr, (column.astype(int) if column.dtype == bool else column).tolist())]


def _netcdf(part: Path, falls: xr.Dataset, bar: Bar) -> None:
    seed = falls.attrs.get("seed", 0)
    attributes = {"seed": str(seed)} if seed >= SMALL_INTEGERS else {}
    falls.assign_attrs(attributes).to_netcdf(part, engine="scipy")


def _json(part: Path, falls: xr.Dataset, bar: Bar) -> None:
    units = {name: column.attrs["units"] for name, column in falls.items() if column.attrs}
    content = {
        "parameters": falls.attrs,
        "units": units,
        "comments": {"direction": DIRECTION},
        "coordinates": {name: column.values for name, column in falls.coords.items()},
        "falls": {name: column.values for name, column in falls.items()},
    }
    write_json(part, content)


NUMBERS: Forms[Any] = {".csv": _csv, ".nc": _netcdf, ".json": _json}
"""By suffix."""
