"""The files of many falls: one format for each suffix."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from rimroll.cli.screen import plain
from rimroll.errors import RimrollError
from rimroll.output import ensure_folder, writing

if TYPE_CHECKING:
    import xarray as xr

DIRECTION = "of fall or of the largest tilt, anticlockwise from that of the first lean"

SMALL_INTEGERS = 2**31  # netCDF's; a larger seed is written down as text


def check(files: Sequence[Path]) -> None:
    """Raise ``RimrollError`` for a file of no known format, or that cannot be made there."""
    for file in files:
        if file.suffix.lower() not in _FORMATS:
            known = ", ".join(_FORMATS)
            raise RimrollError(f"cannot write {file}: its suffix must be one of {known}")
        ensure_folder(file.parent)


def write(file: Path, falls: xr.Dataset) -> None:
    """Write falls in the format of the file's suffix; the file appears when it is whole.

    Raises ``RimrollError`` when it cannot be written, for instance because the disk is full.
    """
    try:
        with writing(file) as part:
            _FORMATS[file.suffix.lower()](part, falls)
    except OSError as error:
        raise RimrollError(f"cannot write {file}: {error.strerror or error}") from error


def _columns(falls: xr.Dataset) -> Iterator[tuple[str, list[Any]]]:
    """The direction in degrees and the outcome, then all that there is in SI units."""
    yield "direction[deg]", np.degrees(falls["direction"].values).tolist()
    yield "outcome", falls["outcome"].values.tolist()
    for name, column in falls.data_vars.items():
        values = column.values
        if name != "outcome":
            unit = column.attrs.get("units")
            whole = values.astype(int) if values.dtype.kind == "b" else values
            yield f"{name}[{unit}]" if unit else str(name), whole.tolist()


def _csv(part: Path, falls: xr.Dataset) -> None:
    """One line of ``name[unit]``, comments with the parameters, and doubles in full."""
    names, columns = zip(*_columns(falls), strict=True)
    with part.open("w", encoding="utf-8", newline="\n") as file:
        file.write(",".join(names) + "\n")
        for name, value in {**falls.attrs, "direction": DIRECTION}.items():
            file.write(f"# {name} = {value}\n")
        file.writelines(",".join(map(str, row)) + "\n" for row in zip(*columns, strict=True))


def _netcdf(part: Path, falls: xr.Dataset) -> None:
    seed = falls.attrs.get("seed", 0)
    attributes = {"seed": str(seed)} if seed >= SMALL_INTEGERS else {}
    falls.assign_attrs(attributes).to_netcdf(part, engine="scipy")


def _json(part: Path, falls: xr.Dataset) -> None:
    variables = falls.data_vars.items()
    content = {
        "parameters": falls.attrs,
        "units": {name: column.attrs["units"] for name, column in variables if column.attrs},
        "comments": {"direction": DIRECTION},
        "falls": {name: column.values for name, column in variables},
    }
    text = json.dumps(plain(content), ensure_ascii=False, allow_nan=False)
    part.write_text(text + "\n", encoding="utf-8")


def _figure(part: Path, falls: xr.Dataset) -> None:
    # Matplotlib is slow to load.
    from rimroll.experiment.histogram import falls_figure
    from rimroll.style import save

    save(falls_figure(falls, name=falls.attrs["body"]), part)


_FORMATS: dict[str, Callable[[Path, xr.Dataset], None]] = {
    ".csv": _csv,
    ".nc": _netcdf,
    ".json": _json,
    ".png": _figure,
    ".svg": _figure,
    ".pdf": _figure,
}
