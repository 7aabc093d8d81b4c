"""Readings of scales, rulers and stopwatches, with their uncertainties.

A reading is a quantity with its standard uncertainty (one standard deviation), in SI units and
radians. Readings are independent of each other; each is tagged with its name, so that whatever is
computed from them knows where its uncertainty comes from.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from itertools import combinations

from uncertainties import UFloat
from uncertainties.core import Variable

from rimroll.errors import RimrollError
from rimroll.options import Options
from rimroll.units import (
    Quantity,
    has_uncertainty,
    quantities_of,
    quantity,
    reading,
    size_of_body,
    table_of,
    without_unit,
)

READINGS = {
    "Size": table_of(
        mass=Quantity("kg", "On the scales."),
        radius=Quantity("m", "Of the rim that touches the table."),
        diameter=Quantity("m", "Or this: twice the radius."),
        length=Quantity("m", "How tall it is, base to top: a check on the others."),
        gravity=quantities_of(Options)["gravity"],
    ),
    "Balance (one of them)": table_of(
        balance_point=Quantity(
            "m", "Lying across an edge it balances; how far from its base is the edge?"
        ),
        balance_tilt=Quantity(
            "rad", "The tilt at which it stands poised on its rim, without a liquid in it."
        ),
    ),
    "Hung from the rim of its base, swinging along (for A)": table_of(
        swings=Quantity("1", "Swings there and back, in the plane of pivot and symmetry axis."),
        swings_time=Quantity("s", "How long they took."),
        swing_period=Quantity("s", "Or one swing by itself."),
        swing_amplitude=Quantity("rad", "If it is not small: how far to either side."),
        pivot_height=Quantity(
            "m", "If hung elsewhere: pivot above the base, as a mug on its lip. [0]"
        ),
        pivot_radius=Quantity("m", "And from the symmetry axis. [that of the rim]"),
    ),
    "Instead of swinging along: rocking (for A)": table_of(
        rocking_tilt=Quantity("rad", "Let go at rest from this tilt of the base;"),
        rocking_time=Quantity("s", "how long until it is at its highest on the other side."),
    ),
    "Swinging across (for C)": table_of(
        across_swings=Quantity("1", "Swings perpendicular to those along."),
        across_time=Quantity("s", "How long they took."),
        across_period=Quantity("s", "Or one swing by itself."),
    ),
    "Instead of swinging across: rolling down a slope on its side (for C)": table_of(
        slope_length=Quantity("m", "The way it rolls from rest."),
        slope_height=Quantity("m", "How far the slope falls on that way."),
        slope_angle=Quantity("rad", "Or its angle."),
        slope_time=Quantity("s", "How long it took."),
        side_radius=Quantity("m", "Radius of its widest part. [that of the rim]"),
    ),
}
"""The readings by what is done, which has a panel in the help of ``rimroll measure``."""

UNITS = {name: one.unit for numbers in READINGS.values() for name, one in numbers.items()}
"""The SI unit of each reading."""

HAND = 0.1
"""The smallest uncertainty of a hand-held stopwatch, s, if none is given."""
FRAME = 1.0 / 30.0
"""The smallest uncertainty of a time read from a film, one frame, s, if none is given."""

ESTIMATE = "estimate"
"""The tag of an estimated number."""

_LEAST = {"swings_time": HAND, "across_time": HAND, "slope_time": HAND, "rocking_time": FRAME}
_COUNTS = ("swings", "across_swings")
_MIN_SWINGS = 5  # swings that a hand can time
_MAY_BE_ZERO = ("balance_point", "pivot_height")
_OF_BODY = (
    *("mass", "radius", "diameter", "length", "balance_point"),
    *("pivot_height", "pivot_radius", "side_radius"),
)

Way = tuple[str, ...]
"""Readings that together determine one number of a body."""


class Readings(Mapping[str, UFloat]):
    """The given readings, by name.

    Parameters
    ----------
    given
        Exact numbers in SI units; texts as for :func:`rimroll.units.reading`; quantities with
        units, or numbers of ``uncertainties``. None is left out. The uncertainty of a text is half
        a unit of its last digit unless stated, and for times at least :data:`HAND` or
        :data:`FRAME`. Counts and gravity are exact.
    typed
        How messages write the name of a reading.

    Raises
    ------
    RimrollError
        A value that is not such a quantity or not positive; a count that is not a whole number of
        at least 5; an angle above 90 degrees.
    """

    def __init__(self, given: Mapping[str, object], typed: Callable[[str], str] = str) -> None:
        self.typed = typed
        self._read = {
            name: self._one(name, value) for name, value in given.items() if value is not None
        }

    def __getitem__(self, name: str) -> UFloat:
        return self._read[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._read)

    def __len__(self) -> int:
        return len(self._read)

    def _one(self, name: str, value: object) -> UFloat:
        unit, label = UNITS[name], self.typed(name)
        number, uncertainty = self._number(name, value)
        if name in _OF_BODY and isinstance(value, str) and not has_uncertainty(value):
            size_of_body(value, unit, label)
        bound = ">= 0" if name in _MAY_BE_ZERO else "> 0"
        if number < 0.0 or (number == 0.0 and name not in _MAY_BE_ZERO):
            text = f"must be {bound}, got {pretty(number, unit)}"
            raise RimrollError(text, label, number, bound, unit)
        if number > 1e9 or (number < 1e-9 and name not in _MAY_BE_ZERO):
            raise RimrollError(f"{label} is no reading on a table: {number:g} {unit}")
        if unit == "rad" and number > 0.5 * math.pi:
            raise RimrollError(
                f"{label} must be at most 90 deg, got {pretty(number, unit)}"
                + ("" if "deg" in str(value) or "°" in str(value) else ": read as radians")
            )
        if name in _COUNTS and (number != int(number) or number < _MIN_SWINGS):
            period = self.typed("across_period" if name == "across_swings" else "swing_period")
            raise RimrollError(
                field=label,
                value=number,
                bound=f"a whole number, at least {_MIN_SWINGS} (50 is better)",
                hint=f"; a swing timed by itself, off a film, is {period}",
            )
        return Variable(number, uncertainty, tag=name)

    def _number(self, name: str, value: object) -> tuple[float, float]:
        """A reading and its standard uncertainty, in the SI unit."""
        unit, label = UNITS[name], self.typed(name)
        value = without_unit(label, value, unit)
        if isinstance(value, UFloat):
            return quantity(value.nominal_value, unit, label), quantity(value.std_dev, unit, label)
        number, uncertainty = reading(value, unit, label)
        if has_uncertainty(value):
            return number, uncertainty
        if name in _COUNTS or name == "gravity":
            return number, 0.0
        return number, max(uncertainty, _LEAST.get(name, 0.0)) if isinstance(value, str) else 0.0

    def way(self, ways: Sequence[Way]) -> Way | None:
        """The way in which a number was measured; None if it was not.

        Raises ``RimrollError`` for one that lacks a reading, and for two at once.
        """
        used = [name for name in dict.fromkeys(sum(ways, ())) if name in self]
        fits = [way for way in ways if set(used) <= set(way)]
        for first, second in combinations(used, 2):
            if not any(first in way and second in way for way in ways):
                raise RimrollError(
                    f"{self.typed(first)} and {self.typed(second)} measure the same: give one"
                )
        if not used:
            return None
        if whole := next((way for way in fits if len(way) == len(used)), None):
            return whole
        rest = [[self.typed(name) for name in way if name not in used] for way in fits]
        missing = " or ".join(map(" and ".join, rest))
        raise RimrollError(f"{self.typed(used[0])} also needs {missing}")

    def lacking(self, needs: Sequence[Sequence[Way]]) -> list[str]:
        """The numbers that were not measured in any of their ways, in words."""
        return [
            " or ".join("+".join(map(self.typed, way)) for way in ways)
            for ways in needs
            if not self.way(ways)
        ]


_SHOWN = {
    "kg": ("g", 1e3),
    "m": ("cm", 1e2),
    "s": ("s", 1.0),
    "rad": ("°", 180.0 / math.pi),
    "m/s^2": ("m/s²", 1.0),
    "1": ("", 1.0),
    "kg m^2": ("kg mm²", 1e6),
    "m^2": ("×10⁻³ m²", 1e3),
}


def pretty(value: UFloat | float, unit: str) -> str:
    """A quantity in kitchen units, rounded to the digits that its uncertainty allows.

    >>> pretty(0.069, "m")
    '6.9 cm'
    >>> from uncertainties import ufloat
    >>> pretty(ufloat(0.069, 0.0005), "m")
    '6.90 ± 0.05 cm'
    """
    shown, factor = _SHOWN[unit]
    power = shown[:1] in ("°", "×")
    space = "" if power or not shown else " "
    if isinstance(value, UFloat):
        scaled = value * factor
        if scaled.std_dev > 0.0:
            number = f"{scaled:.2ufP}" if _leading(scaled.std_dev) < 3 else f"{scaled:.1ufP}"
            number = number.replace("±", " ± ")
            return f"({number}){shown}" if power else f"{number}{space}{shown}"
        value = value.nominal_value
    return f"{value * factor:.6g}{space}{shown}"


def _leading(number: float) -> int:
    """The first digit of a number."""
    return int(f"{number:e}"[0])


def main_source(number: UFloat) -> str:
    """The reading that contributes most to a number's uncertainty; empty if there is none."""
    parts = {part.tag: size for part, size in number.error_components().items() if size > 0.0}
    return max(parts, key=parts.__getitem__, default="")
