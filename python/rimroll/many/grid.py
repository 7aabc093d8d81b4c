"""Values broadcast against one another: a row for each combination, and results laid out again.

Arrays broadcast as in NumPy, by the order of their dimensions. Data arrays of xarray broadcast by
the names of their dimensions, and results then are data arrays over these. xarray is not imported
here unless a data array is asked for or given.
"""

from __future__ import annotations

import sys
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, TypeGuard

import numpy as np
from numpy.typing import NDArray

from rimroll.errors import RimrollError

if TYPE_CHECKING:
    import xarray as xr


Array = NDArray[np.float64]

Coordinate = tuple[tuple[str, ...], NDArray[Any], dict[str, Any]]
"""A coordinate of a labelled grid: its dimensions, values and attributes."""


def is_labelled(value: object) -> TypeGuard[xr.DataArray]:
    """Whether a value is a data array of xarray."""
    xarray = sys.modules.get("xarray")
    return xarray is not None and isinstance(value, xarray.DataArray)


def is_array(value: object) -> bool:
    """Whether a value stands for many: an array, or a data array."""
    return isinstance(value, np.ndarray) or is_labelled(value)


@dataclass(frozen=True)
class Grid:
    """The shape and dimensions that some values broadcast to."""

    shape: tuple[int, ...] = ()
    dims: tuple[str, ...] | None = None
    """The names of the dimensions, where values are labelled."""
    coords: Mapping[str, Coordinate] = field(default_factory=dict)

    @classmethod
    def over(cls, values: Mapping[str, Any]) -> Grid:
        """The grid of some values by name.

        Raises ``RimrollError`` for arrays that do not broadcast, for labels that differ, and for
        arrays with and without labels together.
        """
        if all(type(value) is float for value in values.values()):
            return cls()  # most are
        labelled = {name: value for name, value in values.items() if is_labelled(value)}
        plain = {
            name: np.shape(value)
            for name, value in values.items()
            if name not in labelled and np.ndim(value)
        }
        if not labelled:
            return cls(_broadcast(plain))
        if plain:
            name, shape = next(iter(plain.items()))
            raise RimrollError(
                f"{name} has shape {shape} and no named dimensions, but {next(iter(labelled))} has:"
                " name them all, as with rimroll.axis"
            )
        return cls._labelled(labelled)

    @classmethod
    def _labelled(cls, values: Mapping[str, xr.DataArray]) -> Grid:
        sizes: dict[str, int] = {}
        coords: dict[str, Coordinate] = {}
        differing = set()
        for name, value in values.items():
            for dim, size in zip(map(str, value.dims), value.shape, strict=True):
                if sizes.setdefault(dim, size) != size:
                    raise RimrollError(
                        f"{name} has {size} values along {dim}, others have {sizes[dim]}"
                    )
            for label, coord in _coordinates(value).items():
                known = coords.setdefault(label, coord)
                if known[0] == coord[0] and np.array_equal(known[1], coord[1]):
                    continue
                if label in sizes:
                    raise RimrollError(f"{name} has other coordinates along {label} than others")
                differing.add(label)
        # As in xarray's arithmetic, labels that are no index are dropped where they differ.
        kept = {label: coord for label, coord in coords.items() if label not in differing}
        return cls(tuple(sizes.values()), tuple(sizes), kept)

    @property
    def size(self) -> int:
        """How many rows there are."""
        return int(np.prod(self.shape, dtype=np.int64))

    def flat(self, value: Any) -> Array:
        """The value of each row, (n,)."""
        return np.ascontiguousarray(self._spread(value), np.float64).reshape(-1)

    def column(self, value: Any) -> Array:
        """The value of each row, (n,), or (1,) for a single number, which applies to all rows."""
        return self.flat(value) if np.ndim(value) else np.array([value], np.float64)

    def laid_out(self, rows: NDArray[Any]) -> Any:
        """Results of the rows, (n,), as a single number, an array or a data array."""
        if self.dims is not None:
            import xarray as xr

            return xr.DataArray(rows.reshape(self.shape), dims=self.dims, coords=dict(self.coords))
        return rows.reshape(self.shape) if self.shape else rows.item()

    def index(self, row: int) -> tuple[int, ...]:
        """The place of a row."""
        return tuple(map(int, np.unravel_index(row, self.shape))) if self.shape else ()

    def index_in(self, value: Any, row: int) -> tuple[int, ...]:
        """The index in a value, as it was given, of the element that applies to a row."""
        places = np.arange(int(np.size(value))).reshape(np.shape(value))
        place = self._spread(value.copy(data=places) if is_labelled(value) else places)
        flat = int(np.reshape(place, -1)[row])
        return tuple(map(int, np.unravel_index(flat, np.shape(value)))) if np.ndim(value) else ()

    def placed(self, error: RimrollError, given: Mapping[str, Any], row: int) -> RimrollError:
        """An error about a row, ``height must be``, with the element: ``height[3] must be``.

        ``given`` are the values by name, as they were given.
        """
        field = error.field or ""
        index = self.index_in(given[field], row) if field in given else ()
        if index or self.size == 1:
            return error.at(index)
        return error.inside(f"at {list(self.index(row))}:")

    def _spread(self, value: Any) -> NDArray[Any]:
        if is_labelled(value):
            assert self.dims is not None
            own = [dim for dim in self.dims if dim in value.dims]
            where = tuple(slice(None) if dim in own else None for dim in self.dims)
            value = value.transpose(*own).values[where]
        return np.broadcast_to(np.asarray(value), self.shape)


def _coordinates(value: xr.DataArray) -> dict[str, Coordinate]:
    return {
        str(label): (tuple(map(str, coord.dims)), coord.values, dict(coord.attrs))
        for label, coord in value.coords.items()
    }


def _broadcast(shapes: Mapping[str, tuple[int, ...]]) -> tuple[int, ...]:
    try:
        return np.broadcast_shapes(*shapes.values())
    except ValueError:
        arrays = ", ".join(f"{name} {shape}" for name, shape in shapes.items())
        raise RimrollError(f"arrays must broadcast to one shape, got {arrays}") from None


def same(a: Any, b: Any) -> bool:
    """Whether two values are equal: numbers, texts, or arrays in every element and label."""
    if is_labelled(a) or is_labelled(b):
        return is_labelled(a) and is_labelled(b) and bool(a.identical(b))
    if isinstance(a, np.ndarray) or isinstance(b, np.ndarray):
        return np.array_equal(a, b)
    return bool(a == b)


def key(value: Any) -> object:
    """A hashable stand-in for a value; equal for values that are the :func:`same`."""
    if isinstance(value, np.ndarray) or is_labelled(value):
        # -0.0 equals 0.0
        return np.shape(value), (np.asarray(value, np.float64) + 0.0).tobytes()
    return value


def axis(name: str, values: Any, units: str | None = None) -> xr.DataArray:
    """A named dimension of a sweep: a data array of ``values`` (n,), labelled by themselves.

    Use it as a field of ``State``, ``Body`` or a law. ``units``, such as ``"deg"``, is stored in
    the attributes, and the field converts from it. So do not convert the axis yourself:
    ``np.radians`` keeps the attribute, and the field then raises an error. A quantity of pint has
    its own unit.

    >>> import rimroll as rr
    >>> law = rr.Coulomb(rr.axis("friction", [0.1, 0.2, 0.3]))
    >>> rr.turn_limit(rr.bodies.can_2007(), law).dims
    ('friction',)

    Raises ``RimrollError`` for anything but a flat array of numbers or one quantity of them.
    """
    import xarray as xr

    if units is None and hasattr(values, "magnitude"):
        values, units = values.magnitude, str(values.units)
    array = np.asarray(values) if not _carry_units(values) else np.asarray(None)
    if array.dtype.kind not in "iuf":
        raise RimrollError(
            field="values",
            value=values,
            bound="numbers, or one quantity of them",
            hint=f'; for angles in degrees write rr.axis("{name}", [15, 20], units="deg")',
        )
    if array.ndim != 1:
        raise RimrollError(f"must be a flat array, got shape {array.shape}", "values")
    attrs = {} if units is None else {"units": units}
    labels = xr.DataArray(array, dims=name, attrs=attrs)
    return xr.DataArray(array, dims=name, coords={name: labels}, attrs=attrs)


def _carry_units(values: Any) -> bool:
    """Whether a unit would be lost in an array, of the values or of any among them."""
    items = values if isinstance(values, list | tuple) else [values]
    return any(hasattr(item, "magnitude") or hasattr(item, "unit") for item in items)
