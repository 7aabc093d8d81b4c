"""Bodies, starts and laws as rows that the core reads, and columns of tables of many."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, fields
from itertools import repeat
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from rimroll import _core
from rimroll.bodies.body import Bodies, Body
from rimroll.bodies.solids import SIZES
from rimroll.errors import RimrollError
from rimroll.laws import Law, OneLaw
from rimroll.many.falls import Column, Falls, Interrupted
from rimroll.many.grid import Grid
from rimroll.state import START_NUMBERS, State

Array = NDArray[np.float64]


class Starts(NamedTuple):
    """Starts in the form of the core: arrays (n,)."""

    tilt: Array
    tilt_rate: Array
    yaw: Array
    yaw_rate: Array
    spin: Array
    spin_rate: Array

    def part(self, rows: slice) -> Starts:
        """Some of the rows."""
        return Starts(*(column[rows] for column in self))


class OneBody(NamedTuple):
    """The numbers of a body, already checked."""

    mass: float
    radius: float
    height: float
    transverse_inertia: float
    axial_inertia: float


@dataclass(frozen=True)
class Rows:
    """A body, a start and other varied values for each row that they broadcast to."""

    grid: Grid
    given: Mapping[str, Any]
    """The fields of the body and the start by name, as they were given."""
    bodies: Bodies
    starts: Starts

    @classmethod
    def of(cls, body: Body, starts: State, others: Mapping[str, Any] | None = None) -> Rows:
        """The rows to which bodies, starts and other values broadcast."""
        given = {**_fields(body), **_fields(starts)}
        grid = Grid.over({**given, **(others or {})})
        return cls(
            grid,
            given,
            Bodies.of(body, grid),
            Starts(*(grid.flat(getattr(starts, name)) for name in Starts._fields)),
        )

    def placed(
        self, error: RimrollError, law: str, gravity: float, topple_tilt: float | None
    ) -> RimrollError:
        """An error of the core under a law, with the element of the array: ``tilt[3]``."""
        if error.field not in self.given:
            return error
        row = _core.first_refused(self.bodies, self.starts, law, gravity, topple_tilt)
        return error if row is None else self.grid.placed(error, self.given, row)


def elementwise(function: Callable[..., float], *things: Any) -> Any:
    """A function of single bodies, laws and numbers, for each row that these broadcast to.

    A single number where nothing is an array; else an array, or a data array if names are given to
    dimensions. A refusal names the row that it is about.
    """
    grid = Grid.over(_values(things))
    if grid.shape == () and grid.dims is None:
        return function(*things)
    results = np.empty(grid.size)
    for row, arguments in enumerate(zip(*(_each(thing, grid) for thing in things), strict=False)):
        try:
            results[row] = function(*arguments)
        except RimrollError as error:
            raise error.inside(f"at {list(grid.index(row))}:") from None
    return grid.laid_out(results)


def _values(things: tuple[Any, ...]) -> dict[str, Any]:
    values: dict[str, Any] = {}
    for place, thing in enumerate(things):
        if isinstance(thing, Law):
            values |= {f"law {name}": value for name, value in thing.varied.items()}
        elif isinstance(thing, Body):
            values |= _fields(thing)
        else:
            values[f"argument {place}"] = thing
    return values


def _each(thing: Any, grid: Grid) -> Iterator[Any]:
    if isinstance(thing, Body):
        columns = [grid.flat(getattr(thing, name)).tolist() for name in OneBody._fields]
        return map(OneBody, *columns) if thing.shape else repeat(thing)
    if isinstance(thing, Law):
        return _each_law(thing, grid) if thing.shape else repeat(thing)
    return iter(grid.flat(thing).tolist())


def _each_law(law: Law, grid: Grid) -> Iterator[OneLaw]:
    fixed = law.fixed.numbers
    columns = {name: grid.flat(value).tolist() for name, value in law.varied.items()}
    for row in zip(*columns.values(), strict=True):
        yield OneLaw(law.name, fixed | dict(zip(columns, row, strict=True)))


def _fields(thing: Body | State) -> dict[str, Any]:
    return {field.name: getattr(thing, field.name) for field in fields(thing)}


Meaning = tuple[str, str, str | None]
"""The unit of a column, a name that fits an axis, and a comment if it needs one."""

LOSSES: dict[str, Meaning] = {
    "energy_lost": ("J", "energy lost", "energy lost to friction, resistances and impacts"),
    "friction_loss": ("J", "energy lost to friction", None),
    "resistance_loss": (
        "J",
        "energy lost to resistances",
        "energy lost to rolling resistance, pivoting friction and air",
    ),
}
"""The losses of energy, except for that in impacts."""


BLOCK = 1024
"""Rows that are transposed at a time: they fit in the cache of a core."""


def transposed(table: Array) -> Array:
    """A table (n, k) as columns (k, n), each of which lies in one piece."""
    found = np.empty(table.shape[::-1])
    for first in range(0, len(table), BLOCK):
        rows = slice(first, first + BLOCK)
        found[:, rows] = table[rows].T
    return found


def energy_lost(found: Mapping[str, Array]) -> Array:
    """The sum of all losses, J."""
    return found["friction_loss"] + found["resistance_loss"] + found["impact_loss"]


def inputs(rows: Rows, varied: Mapping[str, Array], done: int) -> dict[str, Column]:
    """The starts, and what differs from row to row of body and law, of the first rows."""
    return {
        **{
            f"start_{name}": Column(column[:done], START_NUMBERS[name].unit)
            for name, column in rows.starts._asdict().items()
        },
        **{
            f"body_{name}": Column(np.broadcast_to(column, rows.grid.size)[:done], SIZES[name].unit)
            for name, column in rows.bodies._asdict().items()
            if np.ndim(rows.given[name])
        },
        **{f"law_{name}": Column(column[:done]) for name, column in varied.items()},
    }


def unless_stopped(falls: Falls, stopped: Any) -> Falls:
    """The falls; raises ``Interrupted`` with them on Ctrl-C, and any other exception itself."""
    if isinstance(stopped, KeyboardInterrupt):
        raise Interrupted(falls) from None
    if stopped is not None:
        raise stopped
    return falls
