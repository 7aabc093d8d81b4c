"""The numbers of many falls as files, in rows or laid out in a plane."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from rimroll.cli.formats import Forms, write_json
from rimroll.cli.screen import Bar

if TYPE_CHECKING:
    import xarray as xr

DIRECTION = "of fall or of the largest tilt, anticlockwise from that of the first lean"

ROWS = 20_000  # written between two looks at the progress bar

SMALL_INTEGERS = 2**31  # netCDF's; a larger seed is written down as text


def _csv(part: Path, falls: xr.Dataset, bar: Bar) -> None:
    """One line of ``name[unit]``, comments with the parameters, and a row a fall in full."""
    frame = falls.to_dataframe().reset_index(drop=set(falls.sizes) == {"trial"})
    flags = frame.select_dtypes("bool").columns
    frame = frame.astype(dict.fromkeys(flags, int))
    frame.insert(0, "direction in degrees", np.degrees(frame["direction"]))
    frame.insert(1, "outcome", frame.pop("outcome"))
    frame.columns = list(_names(falls, frame.columns))
    with part.open("w", encoding="utf-8", newline="\n") as file:
        file.write(",".join(frame.columns) + "\n")
        for name, value in {**falls.attrs, "direction": DIRECTION}.items():
            file.write(f"# {name} = {value}\n")
        for first in range(0, len(frame), ROWS):
            bar(first, len(frame), "")
            rows = frame[first : first + ROWS]
            rows.to_csv(file, header=False, index=False, na_rep="nan", lineterminator="\n")


def _names(falls: xr.Dataset, columns: Any) -> Iterator[str]:
    for column in columns:
        if column == "direction in degrees":
            yield "direction[deg]"
        else:
            unit = falls[column].attrs.get("units")
            yield f"{column}[{unit}]" if unit else column


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
