"""Quantities of a finished or partial study that figures show: numbers, parts and means."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from rimroll.errors import RimrollError, nearest
from rimroll.study.statistics import NUMBER
from rimroll.study.store import DONE, is_truth

if TYPE_CHECKING:
    import xarray as xr


PREFERRED = ("overturned", "turn", "max_tilt_ratio", "fragility_median")
"""The quantities that are shown unless others are asked for."""

COUNT, MEAN, HISTOGRAM = "_count", "_mean", "_histogram"


def quantity_of(dataset: xr.Dataset, name: str) -> xr.DataArray:
    """A quantity of a study as floats; NaN in rows that are not done.

    ``turn`` is a column or its mean, ``overturned`` the truth of it as 0 and 1 or the part for
    which it is true, ``outcome=toppled`` the part with that word. Bodies of which it is undecided
    whether they overturn are left out of ``overturned``. Angles are in degrees.

    Raises ``RimrollError`` for an unknown name.
    """
    column, equals, word = name.partition("=")
    if equals:
        found = _part(dataset, column, word)
    elif column in dataset and (dataset[column].dtype.kind == "b" or is_truth(dataset[column])):
        truth = dataset[column].astype(float)
        if column == "overturned" and "undecided" in dataset:
            truth = truth.where(dataset["undecided"] <= 0)
        found = _named(truth, f"fraction: {_long(dataset, column)}")
    elif column in dataset and "flag_meanings" not in dataset[column].attrs:
        found = dataset[column].astype(float)
    elif f"{column}{MEAN}" in dataset:
        found = dataset[f"{column}{MEAN}"]
    elif f"{column}{COUNT}" in dataset and column not in dataset.dims:
        counts, number = dataset[f"{column}{COUNT}"], dataset[NUMBER]
        if column == "overturned" and f"undecided{COUNT}" in dataset:
            number = number - dataset[f"undecided{COUNT}"]
        found = _named(counts / _positive(number), f"fraction: {column.replace('_', ' ')}")
    else:
        raise RimrollError(f"unknown quantity {name!r}{nearest(name, names(dataset))}")
    done = is_done(dataset)
    if done is not None and set(done.dims) <= set(found.dims):
        found = _named(found.where(done), found.attrs.get("long_name"), found.attrs.get("units"))
    return in_degrees(found.drop_vars(DONE, errors="ignore").rename(name))


def is_done(dataset: xr.Dataset) -> xr.DataArray | None:
    """Which rows are done, if the study says so: whole numbers are negative elsewhere."""
    if DONE in dataset.coords:
        return dataset.coords[DONE]
    for name in (*(str(one) for one in dataset.data_vars), NUMBER):
        if name in dataset and dataset[name].dtype.kind == "i":
            return dataset[name] >= 0
    return None


def names(dataset: xr.Dataset) -> list[str]:
    """The quantities that can be shown, the preferred ones first."""
    found: list[str] = []
    for variable, one in dataset.data_vars.items():
        name = str(variable)
        words = [] if is_truth(one) else one.attrs.get("flag_meanings", "").split()
        if words:
            found += [f"{name}={word}" for word in words]
        elif name.endswith(COUNT) and name.removesuffix(COUNT) in dataset.dims:
            column = name.removesuffix(COUNT)
            found += [f"{column}={word}" for word in dataset[column].values.tolist()]
        elif not name.endswith(HISTOGRAM) and name != NUMBER:
            found.append(name.removesuffix(COUNT).removesuffix(MEAN))
    first = [name for name in PREFERRED if name in found]
    return list(dict.fromkeys([*first, *found]))


def at(array: xr.DataArray, places: Mapping[str, str]) -> xr.DataArray:
    """An array at some places of its dimensions: the nearest numbers, or the words themselves.

    Raises ``RimrollError`` for unknown dimensions and words.
    """
    for dim, text in places.items():
        if dim not in array.dims:
            raise RimrollError(f"unknown dimension {dim!r}{nearest(dim, map(str, array.dims))}")
        labels = label_of(array, dim)
        values = labels.values
        if values.dtype.kind in "iuf":
            try:
                wanted = float(text)
            except ValueError:
                raise RimrollError(f"{dim} must be a number, got {text!r}") from None
            place = int(np.abs(values - wanted).argmin())
        else:
            words = [str(one) for one in values]
            if text not in words:
                raise RimrollError(f"unknown {dim} {text!r}{nearest(text, words)}")
            place = words.index(text)
        array = array.isel({dim: place})
    return array


def label_of(array: xr.DataArray, dim: str) -> xr.DataArray:
    """What labels a dimension: its coordinate, the first along it, or the numbers of its places."""
    if dim in array.coords:
        return in_degrees(array.coords[dim])
    for coordinate in array.coords.values():
        if coordinate.dims == (dim,):
            return in_degrees(coordinate)
    return array[dim]


def is_number(label: xr.DataArray) -> bool:
    """Whether a label is a number and no word."""
    return bool(label.dtype.kind in "iuf")


def words_on_axis(array: xr.DataArray) -> str:
    """What an axis shows, with its unit."""
    long_name = array.attrs.get("long_name") or str(array.name).replace("_", " ")
    unit = array.attrs.get("units")
    return f"{long_name} ({unit})" if unit else str(long_name)


def mean(array: xr.DataArray, dims: Iterable[str]) -> xr.DataArray:
    """The mean over dimensions, without what is not a number."""
    return array.mean(list(dims), skipna=True, keep_attrs=True)


def in_degrees(array: xr.DataArray) -> xr.DataArray:
    """Angles and angular rates in degrees instead of radians."""
    unit = array.attrs.get("units")
    if unit not in ("rad", "rad/s"):
        return array
    return array.copy(data=np.degrees(array.values)).assign_attrs(
        units={"rad": "°", "rad/s": "°/s"}[unit]
    )


def _part(dataset: xr.Dataset, column: str, word: str) -> xr.DataArray:
    """The part that has a word."""
    label = f"fraction: {word.replace('_', ' ')}"
    if column in dataset.data_vars and "flag_meanings" in dataset[column].attrs:
        words = dataset[column].attrs["flag_meanings"].split()
        if word in words:
            return _named((dataset[column] == words.index(word)).astype(float), label)
    elif f"{column}{COUNT}" in dataset and column in dataset.dims:
        words = [str(one) for one in dataset[column].values]
        if word in words:
            counts = dataset[f"{column}{COUNT}"].isel({column: words.index(word)}, drop=True)
            return _named(counts / _positive(dataset[NUMBER]), label)
    name = f"{column}={word}"
    raise RimrollError(f"unknown quantity {name!r}{nearest(name, names(dataset))}")


def _positive(number: xr.DataArray) -> xr.DataArray:
    return number.where(number > 0)


def _named(array: xr.DataArray, long_name: Any, unit: str | None = None) -> xr.DataArray:
    attrs = {"long_name": long_name, "units": unit}
    array.attrs = {name: one for name, one in attrs.items() if one}
    return array


def _long(dataset: xr.Dataset, name: str) -> str:
    return str(dataset[name].attrs.get("long_name") or name).removeprefix("whether ")
