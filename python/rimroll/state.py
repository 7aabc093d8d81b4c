"""Position and velocity of a body."""

from __future__ import annotations

import math
from dataclasses import dataclass, fields
from typing import TYPE_CHECKING, Any, Generic, cast, overload

import numpy as np
from numpy.typing import NDArray

from rimroll.errors import RimrollError, hold
from rimroll.files.recorded import expect_dataset, not_recorded
from rimroll.many.grid import Grid, is_labelled
from rimroll.units import (
    Quantity,
    Values,
    in_degrees_hint,
    number,
    numbers,
    positive,
    table_of,
    values,
)

Array = NDArray[np.float64]
Numbers = float | Array

START_NUMBERS = table_of(
    tilt=Quantity("rad", "Tilt at the start; 0 is upright, base flat.", hint="tilt"),
    tilt_rate=Quantity("rad/s", "Negative while falling toward upright. [0]"),
    yaw=Quantity("rad", "Where the tilt lifts the base: 0 is x, 90deg y. [0]"),
    yaw_rate=Quantity("rad/s", "How fast the contact point goes round. [0]"),
    spin=Quantity("rad"),
    spin_rate=Quantity("rad/s", "About the symmetry axis. [0]"),
)
"""The numbers of a start."""

KNOCKED_TILT = 1e-15
"""The tilt at which a body that stood begins to rock, rad, in the core, too."""

if TYPE_CHECKING:
    import xarray as xr

    # Its default lets one write State where it does not matter what the fields are.
    from typing_extensions import TypeVar

    FieldT = TypeVar("FieldT", bound=Numbers, covariant=True, default=Numbers)
    StateT = TypeVar("StateT", bound=Numbers)
else:
    from typing import TypeVar

    FieldT = TypeVar("FieldT", covariant=True)


@dataclass(frozen=True, kw_only=True, eq=False)
class State(Generic[FieldT]):
    """Position and motion in the paper's Euler angles (rad, rad/s).

    Every field is a number or an array, with or without a unit (see :mod:`rimroll.units`). Arrays
    must have the same shape; single numbers apply to all elements. Data arrays of xarray broadcast
    by the names of their dimensions. For type checkers, a state of single numbers is a
    ``State[float]``, whose fields are floats.

    Parameters
    ----------
    tilt
        φ, inside (0, π): 0 is upright, the base flat on the table.
    tilt_rate
        dφ/dt; negative while falling toward upright.
    yaw
        ψ: turns with the contact point, which is at azimuth ψ + π as seen from the base's centre.
    yaw_rate
        dψ/dt.
    spin
        θ: about the symmetry axis, relative to the frame that yaws and tilts. A body that just
        falls over turns yaw and spin oppositely.
    spin_rate
        dθ/dt.

    Raises
    ------
    RimrollError
        A value that is not a finite number, a unit of another kind, a tilt outside (0, π), arrays
        that differ in shape; for an array the message names the element, as ``tilt[1]``.
    """

    tilt: FieldT
    tilt_rate: FieldT = 0.0  # type: ignore[assignment]
    yaw: FieldT = 0.0  # type: ignore[assignment]
    yaw_rate: FieldT = 0.0  # type: ignore[assignment]
    spin: FieldT = 0.0  # type: ignore[assignment]
    spin_rate: FieldT = 0.0  # type: ignore[assignment]

    if TYPE_CHECKING:

        @overload
        def __init__(
            self: State[float],
            *,
            tilt: float | str,
            tilt_rate: float | str = 0.0,
            yaw: float | str = 0.0,
            yaw_rate: float | str = 0.0,
            spin: float | str = 0.0,
            spin_rate: float | str = 0.0,
        ) -> None: ...
        @overload
        def __init__(
            self: State[Numbers],
            *,
            tilt: Values,
            tilt_rate: Values = 0.0,
            yaw: Values = 0.0,
            yaw_rate: Values = 0.0,
            spin: Values = 0.0,
            spin_rate: Values = 0.0,
        ) -> None: ...
        def __init__(self, **fields: Values) -> None: ...

    def __post_init__(self) -> None:
        if self._is_plain():
            return
        has_unit = isinstance(self.tilt, str) or hasattr(self.tilt, "units")
        for field in fields(self):
            value = _finite(field.name, getattr(self, field.name))
            object.__setattr__(self, field.name, value)
        if any(map(is_labelled, vars(self).values())):
            _ = self.shape
        else:
            self._check_shapes()
        tilt = np.asarray(self.tilt)
        inside = (tilt > 0.0) & (tilt < np.pi)
        hint = None if has_unit else _hint
        hold("tilt", tilt, inside, "inside (0, pi)", "rad", hint)

    def _check_shapes(self) -> None:
        shapes = {f.name: np.shape(getattr(self, f.name)) for f in fields(self)}
        if len({shape for shape in shapes.values() if shape}) > 1:
            arrays = ", ".join(f"{name} {shape}" for name, shape in shapes.items() if shape)
            raise RimrollError(f"the arrays of a State must agree in shape, got {arrays}")

    def _is_plain(self) -> bool:
        """Whether all fields are valid floats, the usual case, which needs no conversion."""
        values = vars(self).values()
        plain = all(type(value) is float and math.isfinite(value) for value in values)
        return plain and 0.0 < self.tilt < math.pi  # type: ignore[return-value]

    @classmethod
    def standing(
        cls, *, yaw: float | str = 0.0, spin: float | str = 0.0, tilt_rate: float | str = 0.0
    ) -> State[float]:
        """A body that stands flat on the table, at rest: a start on a table that moves.

        With a tilt rate > 0 it has been knocked: it begins to rock about the point of its rim at
        the azimuth yaw + π, on any table. Its tilt is then 1e-15 rad, because there is no tilt
        rate at the tilt 0.
        """
        if number("tilt_rate", tilt_rate, "rad/s"):
            rate = positive("tilt_rate", tilt_rate, "rad/s")
            return State(tilt=KNOCKED_TILT, tilt_rate=rate, yaw=yaw, spin=spin)
        upright = State(tilt=1.0, yaw=yaw, spin=spin)
        return State.computed(**{**vars(upright), "tilt": 0.0})

    @property
    def is_knocked(self) -> bool:
        """Whether a body that stood has been knocked: see :meth:`standing`."""
        return self.shape == () and bool(self.tilt == KNOCKED_TILT)

    @staticmethod
    def computed(**numbers: StateT) -> State[StateT]:
        """A state of a motion, which may stand flat on the table, at the tilt 0."""
        state: State[StateT] = object.__new__(State)
        for name, value in numbers.items():
            object.__setattr__(state, name, value)
        return state

    @classmethod
    def from_xarray(cls, dataset: xr.Dataset) -> State:
        """The start of a dataset of a motion, or the starts of one of falls (n,).

        Raises ``RimrollError`` for a dataset of something else.
        """
        expect_dataset(dataset)
        return start_of(dataset)

    def _repr_html_(self) -> str | None:
        """The view in notebooks; None for many states."""
        if any(map(np.ndim, vars(self).values())):
            return None
        from rimroll.figures.notebook import table, view

        rows = []
        for field in fields(self):
            value = float(getattr(self, field.name))
            is_rate = field.name.endswith("rate")
            shown = f"{value:.6g} rad/s" if is_rate else f"{np.degrees(value):.6g}°"
            rows.append((field.name, shown))
        return view("State", table(rows))

    @property
    def shape(self) -> tuple[int, ...]:
        """The shape that the fields broadcast to; () when every field is a single number."""
        return Grid.over({f.name: getattr(self, f.name) for f in fields(self)}).shape


def start_of(dataset: xr.Dataset) -> State:
    """The start of a motion, or the starts of falls (n,).

    Raises ``RimrollError`` for a dataset without them, as a map of falls, whose plane has them.
    """
    given: dict[str, Array] = {}
    for field in fields(State):
        if (key := f"start_{field.name}") not in dataset and key not in dataset.attrs:
            raise not_recorded("start", key)
        value = dataset[key] if key in dataset else dataset.attrs[key]
        given[field.name] = numbers(key, value, START_NUMBERS[field.name].unit)
    if not given["tilt"].ndim and given["tilt"] == 0.0:
        return _standing(given)
    return State(**given)


def _standing(given: dict[str, Array]) -> State[float]:
    """A start that stands flat, from its numbers."""
    moving = [name for name, rate in given.items() if name.endswith("_rate") and rate != 0.0]
    if moving:
        raise RimrollError(f"{moving[0]} must be 0 where the tilt is 0, got {given[moving[0]]}")
    return State.standing(yaw=float(given["yaw"]), spin=float(given["spin"]))


def single(start: State) -> State[float]:
    """The start itself, when it is one; raises ``RimrollError`` for a State of arrays."""
    # Faster than asking NumPy.
    if not all(isinstance(value, float) for value in vars(start).values()):
        raise RimrollError(f"a motion has one start, got arrays of shape {start.shape}")
    return cast("State[float]", start)


def times(t: Values) -> NDArray[np.float64]:
    """Times (s) as an array () or (n,); raises ``RimrollError`` for anything else."""
    array = numbers("t", t, "s")
    if array.ndim > 1:
        raise RimrollError(f"must be a number or a flat array, got shape {array.shape}", "t")
    return array


def _hint(tilt: float) -> str:
    if tilt == 0.0:
        return (
            "; for a body that stands flat give State.standing(), on a table that moves or, as"
            " State.standing(tilt_rate=...), with a knock"
        )
    return in_degrees_hint(tilt) if tilt > math.pi else ""


def _finite(field: str, value: object) -> Any:
    if is_labelled(value) and value.ndim:
        given = values(field, value, START_NUMBERS[field].unit)
        hold(field, given.values, np.isfinite(given.values), "finite")
        return given
    array = numbers(field, value, START_NUMBERS[field].unit)
    hold(field, array, np.isfinite(array), "finite")
    return array if array.ndim else float(array)
