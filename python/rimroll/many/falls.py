"""Many falls as plain columns, which can become an :class:`xarray.Dataset`.

Importing xarray takes longer than computing most falls, so it is imported only when needed.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from rimroll.errors import RimrollError
from rimroll.many.grid import Coordinate, Grid

if TYPE_CHECKING:
    import xarray as xr


@dataclass(frozen=True, eq=False)
class Column:
    """One number or word for each fall: values, their SI unit ("" for pure numbers) and meaning.

    ``long_name`` is short enough for the label of an axis, ``comment`` says exactly what it means.
    """

    values: NDArray[Any]
    units: str | None = None
    long_name: str | None = None
    comment: str | None = None

    @property
    def attrs(self) -> dict[str, str]:
        """Unit and meaning by the names that xarray and netCDF use."""
        named = {"units": self.units, "long_name": self.long_name, "comment": self.comment}
        return {name: text for name, text in named.items() if text is not None}

    @classmethod
    def with_attrs(cls, values: NDArray[Any], attrs: Mapping[str, Any]) -> Column:
        """Values with unit and meaning from the attributes of xarray."""
        return cls(values, *(attrs.get(name) for name in ("units", "long_name", "comment")))


@dataclass(frozen=True, eq=False)
class Falls:
    """Falls in rows, or laid out in a plane.

    ``axes`` are the coordinates by name, one flat column each: ``trial`` (n,) for rows; for a map
    ``spin_rate`` (s,) and ``yaw_rate`` (y,). ``columns`` have the shape of the axes, (n,) or
    (s, y): ``outcome`` and the numbers of each fall. ``attrs`` hold everything that all falls have
    in common. ``falls["turn"]`` is the array of one column or axis. ``labels`` are further
    coordinates, each along some of the axes. ``body`` and ``law`` are those of falls that were
    computed here, not read from a dataset.
    """

    columns: Mapping[str, Column]
    axes: Mapping[str, Column]
    attrs: dict[str, Any]
    labels: Mapping[str, Coordinate] = field(default_factory=dict)
    body: Any = None
    law: Any = None

    @classmethod
    def of(cls, falls: Falls | xr.Dataset) -> Falls:
        """The falls of a dataset of :func:`rimroll.ensemble`, else ``RimrollError``."""
        if isinstance(falls, Falls):
            return falls
        if not hasattr(falls, "data_vars") or "outcome" not in falls.data_vars:
            raise RimrollError("must be a dataset of rimroll.ensemble: it has no outcome", "falls")
        axes = {str(name): _column(falls[name]) for name in falls["outcome"].dims}
        columns = {
            str(name): _column(column)
            for name, column in falls.data_vars.items()
            if column.dims == falls["outcome"].dims
        }
        return cls(columns, axes, dict(falls.attrs))

    def __getitem__(self, name: str) -> NDArray[Any]:
        return (self.columns if name in self.columns else self.axes)[name].values

    def __contains__(self, name: object) -> bool:
        return name in self.columns or name in self.axes

    @property
    def size(self) -> int:
        """Number of falls."""
        return math.prod(len(axis.values) for axis in self.axes.values())

    def with_attrs(self, attrs: Mapping[str, Any]) -> Falls:
        """These falls with more attributes, which replace existing ones."""
        return replace(self, attrs=self.attrs | dict(attrs))

    def laid_out(self, grid: Grid) -> Falls:
        """Falls in rows, laid out on a grid of named dimensions.

        Raises ``RimrollError`` for a dimension with the name of a column.
        """
        assert grid.dims is not None
        axes: dict[str, Column] = {}
        for dim, size in zip(grid.dims, grid.shape, strict=True):
            if dim in self.columns:
                raise RimrollError(f"a dimension cannot be called {dim}, which is a result")
            _, values, attrs = grid.coords.get(dim, ((dim,), np.arange(size), {}))
            axes[dim] = Column.with_attrs(values, attrs)
        columns = {
            name: replace(one, values=one.values.reshape(grid.shape))
            for name, one in self.columns.items()
        }
        labels = {name: coord for name, coord in grid.coords.items() if name not in axes}
        return replace(self, columns=columns, axes=axes, labels=labels)

    def to_xarray(self) -> xr.Dataset:
        """The falls as a labelled dataset with units."""
        import xarray as xr

        across = tuple(self.axes)
        return xr.Dataset(
            {name: (across, one.values, one.attrs) for name, one in self.columns.items()},
            coords={name: (name, one.values, one.attrs) for name, one in self.axes.items()}
            | dict(self.labels),
            attrs=self.attrs,
        )


def rows(columns: Mapping[str, Column], attrs: Mapping[str, Any]) -> Falls:
    """Falls in rows, numbered as trials from 0 on."""
    trials = np.arange(len(next(iter(columns.values())).values))
    return Falls(columns, {"trial": Column(trials)}, dict(attrs))


def _column(array: xr.DataArray) -> Column:
    return Column.with_attrs(array.values, array.attrs)


class Interrupted(KeyboardInterrupt):
    """Ctrl-C during an ensemble; ``done`` is the dataset of the falls so far."""

    def __init__(self, falls: Falls | xr.Dataset) -> None:
        self.falls = Falls.of(falls)
        super().__init__(f"interrupted after {self.falls.size} falls")

    @property
    def done(self) -> xr.Dataset:
        """The completed falls, in the form that the interrupted function returns."""
        return self.falls.to_xarray()

    def __reduce__(self) -> tuple[type[Interrupted], tuple[Falls]]:
        return type(self), (self.falls,)
