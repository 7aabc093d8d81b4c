"""The parameters of laws and resistances: numbers, or arrays of them for many laws at once."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import MISSING, fields
from typing import Any, NamedTuple

from rimroll import _core
from rimroll.errors import RimrollError
from rimroll.many.grid import Grid, is_array, key, same
from rimroll.units import Quantity, quantities_of, values
from rimroll.units import numbers as array


class Parameters:
    """A dataclass whose numbers, or arrays of numbers, are checked when it is made."""

    def _read(self) -> None:
        for name, parameter in quantities_of(type(self)).items():
            value = getattr(self, name)
            left_out = value is None and getattr(type(self), name, MISSING) is None
            if not left_out:
                read = listed if parameter.is_list else values
                object.__setattr__(self, name, read(name, value, self.unit_of(name, vars(self))))

    @classmethod
    def unit_of(cls, name: str, numbers: Mapping[str, Any]) -> str:
        """The SI unit of a number, which may depend on others."""
        return quantities_of(cls)[name].unit

    def __repr__(self) -> str:
        given = ", ".join(
            f"{item.name}={_brief(getattr(self, item.name))}"
            for item in fields(self)  # type: ignore[arg-type]
            if item.repr and not same(getattr(self, item.name), item.default)
        )
        return f"{type(self).__name__}({given})"

    def __eq__(self, other: object) -> bool:
        if type(other) is not type(self):
            return NotImplemented
        return all(
            same(getattr(self, item.name), getattr(other, item.name))
            for item in fields(self)  # type: ignore[arg-type]
        )

    def __hash__(self) -> int:
        numbers = (key(getattr(self, item.name)) for item in fields(self))  # type: ignore[arg-type]
        return hash((type(self), *numbers))


def listed(field: str, values: object, unit: str = "1") -> tuple[float, ...]:
    """The values of a field as a tuple of floats in an SI unit.

    Raises ``RimrollError`` naming the field unless they are a flat list of numbers.
    """
    flat = array(field, values, unit)
    if flat.ndim != 1:
        raise RimrollError(field=field, value=values, bound="a flat list of numbers")
    return tuple(flat.tolist())


def _brief(value: object) -> str:
    """The text of a number, or of a list of numbers, without the middle of a long one."""
    if not isinstance(value, tuple) or len(value) <= 8:
        return repr(value)
    return f"({value[0]!r}, {value[1]!r}, ..., {value[-1]!r}: {len(value)} numbers)"


def varied_numbers(numbers: Mapping[str, Any]) -> dict[str, Any]:
    """The numbers of a law that are arrays."""
    return {name: value for name, value in numbers.items() if is_array(value)}


def in_brief(value: float | tuple[float, ...]) -> str:
    """A number of a law as text, or the range of the numbers of a table."""
    if isinstance(value, tuple):
        return f"{min(value):g} to {max(value):g}"
    return f"{value:g}"


FRICTION = Quantity(help="Friction over normal force while the rim slides.")
STATIC = Quantity(
    option="static_friction",
    help="Largest friction over normal force while the rim sticks. [as --friction]",
)
RESTITUTION = Quantity(help="Restitution of landings, 0 to 1; not for no-slip. [0]")


class OneLaw(NamedTuple):
    """The name of a law and its numbers, as the core reads them."""

    name: str
    numbers: dict[str, float]


def only_fixed(name: str, numbers: Mapping[str, Any], varied: Mapping[str, Any]) -> OneLaw:
    """The law of that name without the numbers that are varied."""
    return OneLaw(name, {key: value for key, value in numbers.items() if key not in varied})


def check(fixed: OneLaw, varied: Mapping[str, Any]) -> None:
    """Raise ``RimrollError`` naming the first number that is out of bounds.

    ``varied`` are the numbers that are arrays.
    """
    if not varied:
        _core.check_contact_law(fixed)
        return
    grid = Grid.over(varied)
    columns = {name: grid.flat(value) for name, value in varied.items()}
    bad = _core.first_bad_contact_law(fixed, columns)
    if bad is not None:
        row, error = bad
        raise grid.placed(error, varied, row)
