"""What all contact laws have in common."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import TYPE_CHECKING, Any, ClassVar, Self

from rimroll.errors import RimrollError, choose, expect, typed
from rimroll.files.recorded import expect_dataset, is_recorded, not_recorded, recorded
from rimroll.laws.parameters import (
    OneLaw,
    Parameters,
    check,
    listed,
    only_fixed,
    varied_numbers,
)
from rimroll.laws.resistances import RESISTANCES, Resistance
from rimroll.many.falls import Falls
from rimroll.many.grid import Grid
from rimroll.units import Quantity, quantities_of

if TYPE_CHECKING:
    import xarray as xr

    from rimroll.files.recorded import Record


@dataclass(frozen=True, repr=False, eq=False)
class Law(Parameters):
    """How the rim meets the table; add resistances with ``+``.

    The numbers of laws and resistances may be arrays, for many laws at once. They broadcast as in
    NumPy, data arrays of xarray by the names of their dimensions. :func:`rimroll.ensemble` and
    :func:`rimroll.turn_limit` take many laws; a single motion takes one.
    """

    name: ClassVar[str]
    """The name of the law in the core, on the command line and in scenario files."""
    color: ClassVar[str]
    """The colour of its results in figures; colours must be distinguishable with any vision."""
    marker: ClassVar[str]
    """The marker of its results in figures: one of matplotlib's."""
    can_stick: ClassVar[bool] = False
    """Whether the rim can stick; its markers are filled then."""

    resistances: tuple[Resistance, ...] = field(default=(), kw_only=True, repr=False)

    def __post_init__(self) -> None:
        _expect_known(type(self))
        self._read()
        given = self.resistances
        items = (given,) if isinstance(given, Resistance) else tuple(given)
        kinds = [type(item).__name__ for item in items]
        for item, kind in zip(items, kinds, strict=True):
            expect("what is added to a law", item, Resistance)
            if kinds.count(kind) > 1:
                raise RimrollError(f"a law takes one {kind}, got two")
        in_order = tuple(sorted(items, key=lambda item: type(item).__name__, reverse=True))
        object.__setattr__(self, "resistances", in_order)
        check(self.fixed, self.varied)

    @classmethod
    def from_xarray(cls, dataset: xr.Dataset) -> Law:
        """The law of a dataset of a motion, of falls or of a map, with its resistances.

        Raises ``RimrollError`` for a dataset of something else.
        """
        expect_dataset(dataset)
        return law_of(dataset)

    def __add__(self, other: Resistance) -> Self:
        expect("what is added to a law", other, Resistance)
        return replace(self, resistances=(*self.resistances, other))

    def __radd__(self, other: Resistance) -> Self:
        return self + other

    def __repr__(self) -> str:
        return " + ".join([super().__repr__(), *map(repr, self.resistances)])

    @cached_property
    def numbers(self) -> dict[str, float | tuple[float, ...]]:
        """The law's numbers and those of its resistances, by name, in SI units.

        Tables are tuples of numbers.
        """
        own = {
            name: value
            for name in quantities_of(type(self))
            if (value := getattr(self, name)) is not None
        }
        for resistance in self.resistances:
            own |= resistance.numbers
        return own

    @cached_property
    def varied(self) -> dict[str, Any]:
        """The numbers that are arrays, by name."""
        return varied_numbers(self.numbers)

    @cached_property
    def fixed(self) -> OneLaw:
        """The law without the numbers that are arrays, as the core reads it."""
        return only_fixed(self.name, self.numbers, self.varied)

    @cached_property
    def shape(self) -> tuple[int, ...]:
        """The shape that the numbers broadcast to; () for one law."""
        return Grid.over(self.varied).shape


def contact_law(law: object) -> Law:
    """The law, if it is a law of the core; else ``RimrollError``."""
    expect("law", law, Law)
    assert isinstance(law, Law)
    _expect_known(type(law))
    return law


def one_law(law: Any) -> Law:
    """The law itself, if it is a single law of the core; else ``RimrollError``."""
    contact_law(law)
    if law.shape:
        raise RimrollError(
            f"must be a single law, got numbers of shape {law.shape}: rimroll.ensemble takes many",
            "law",
        )
    assert isinstance(law, Law)
    return law


LAWS: dict[str, type[Law]] = {}
"""The laws by name, in the core's order; :mod:`rimroll.laws.friction` lists them."""


def _expect_known(kind: type[Law]) -> None:
    """Raise ``RimrollError`` for a user's class: the core knows laws by name only."""
    if kind not in LAWS.values():
        known = ", ".join(known.__name__ for known in LAWS.values())
        raise RimrollError(
            f"must be one of rimroll's own, {known}, got the class {kind.__name__}: laws are"
            " compiled; for a friction of your own over the slip speed use"
            " rimroll.Tabulated",
            "law",
        )


def kind(name: str) -> type[Law]:
    """The class of law of that name, typed like ``no-slip`` or ``no_slip``.

    Raises ``RimrollError`` with the nearest name if there is none.
    """
    return choose("law", name, {typed(known): law for known, law in LAWS.items()})


def by_name(name: str, numbers: Mapping[str, float | tuple[float, ...]] | None = None) -> Law:
    """The law of that name with these numbers; ``-`` may stand for ``_``.

    Raises ``RimrollError`` with the nearest name if there is none, or with the name of a number
    that is missing or does not belong to the law.
    """
    numbers = numbers or {}
    law = kind(name)
    takes = quantities_of(law)
    for given in numbers:
        if given not in takes:
            choices = ", ".join(takes) or "no numbers"
            raise RimrollError(f"{typed(law.name)} takes {choices}, got {given}")
    for number_name, parameter in takes.items():
        if parameter.required and number_name not in numbers:
            raise RimrollError(f"{typed(law.name)} needs {number_name}")
    return law(**numbers)  # type: ignore[arg-type]


def law_of(record: Record) -> Law:
    """The law of a motion or of falls, with arrays where its numbers differ from fall to fall.

    Raises ``RimrollError`` for a dataset of something else.
    """
    if isinstance(record, Falls) and record.law is not None:
        kept: Law = record.law
        return kept
    if "law" not in record.attrs:
        raise not_recorded("law", "law")
    law = kind(str(record.attrs["law"]))
    own = {
        name: _recorded_number(record, name, parameter)
        for name, parameter in quantities_of(law).items()
        if is_recorded(record, f"law_{name}")
    }
    found = by_name(law.name, own)
    for resistance in RESISTANCES:
        names = [f"law_{name}" for name in resistance.core_names()]
        if is_recorded(record, names[0]):
            found += resistance(*(recorded(record, name) for name in names))
    return found


def _recorded_number(record: Record, name: str, parameter: Quantity) -> Any:
    if parameter.is_list:
        return listed(name, record.attrs[f"law_{name}"])
    return recorded(record, f"law_{name}")
