"""What was read off scales, rulers and stopwatches, and how far each reading can be trusted.

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
from rimroll.given import without_unit
from rimroll.units import has_uncertainty, quantity, reading

UNITS = {
    "mass": "kg",
    "radius": "m",
    "diameter": "m",
    "length": "m",
    "balance_point": "m",
    "balance_tilt": "rad",
    "swings": "1",
    "swings_time": "s",
    "swing_period": "s",
    "across_swings": "1",
    "across_time": "s",
    "across_period": "s",
    "swing_amplitude": "rad",
    "pivot_radius": "m",
    "pivot_height": "m",
    "rocking_tilt": "rad",
    "rocking_time": "s",
    "slope_length": "m",
    "slope_height": "m",
    "slope_angle": "rad",
    "slope_time": "s",
    "side_radius": "m",
    "gravity": "m/s^2",
}
"""What can be measured, and the SI unit of each."""

HAND = 0.1
"""The least uncertainty of a stopwatch in a hand, s, where none is given."""
FRAME = 1.0 / 30.0
"""The same of what is read off a film, a frame of it, s."""

ESTIMATE = "estimate"
"""The tag of what was not read but guessed."""

_LEAST = {"swings_time": HAND, "across_time": HAND, "slope_time": HAND, "rocking_time": FRAME}
_COUNTS = ("swings", "across_swings")
_FEWEST = 5  # swings that a hand can time
_MAY_BE_ZERO = ("balance_point", "pivot_height")

Way = tuple[str, ...]
"""Readings that together give one number of a body."""


class Readings(Mapping[str, UFloat]):
    """The readings that are given, by name.

    Parameters
    ----------
    given
        Numbers in SI units, taken to be exact; texts as :func:`rimroll.units.reading` takes them;
        quantities with units, or of ``uncertainties``; None is left out. A text that does not say
        its uncertainty has half a unit of its last digit, times also at least :data:`HAND` or
        :data:`FRAME`; counts and gravity are exact.
    typed
        How messages write the name of a reading.

    Raises
    ------
    RimrollError
        What is no such quantity, or not positive; counts that are not whole or below 5; angles
        beyond 90 degrees.
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
        unit, said = UNITS[name], self.typed(name)
        number, uncertainty = self._number(name, value)
        least = ">= 0" if name in _MAY_BE_ZERO else "> 0"
        if number < 0.0 or (number == 0.0 and name not in _MAY_BE_ZERO):
            raise RimrollError(f"{said} must be {least}, got {pretty(number, unit)}")
        if number > 1e9 or (number < 1e-9 and name not in _MAY_BE_ZERO):
            raise RimrollError(f"{said} is no reading on a table: {number:g} {unit}")
        if unit == "rad" and number > 0.5 * math.pi:
            raise RimrollError(
                f"{said} must be at most 90 deg, got {pretty(number, unit)}"
                + ("" if "deg" in str(value) or "°" in str(value) else ": read as radians")
            )
        if name in _COUNTS and (number != int(number) or number < _FEWEST):
            period = self.typed("across_period" if name == "across_swings" else "swing_period")
            raise RimrollError(
                f"{said} must be a whole number, at least {_FEWEST} (50 is better), got"
                f" {number:g}; a swing timed by itself, off a film, is {period}"
            )
        return Variable(number, uncertainty, tag=name)

    def _number(self, name: str, value: object) -> tuple[float, float]:
        """A reading and its standard uncertainty, in the SI unit."""
        unit, said = UNITS[name], self.typed(name)
        value = without_unit(said, value, unit)
        if isinstance(value, UFloat):
            return quantity(value.nominal_value, unit, said), quantity(value.std_dev, unit, said)
        number, uncertainty = reading(value, unit, said)
        if has_uncertainty(value):
            return number, uncertainty
        if name in _COUNTS or name == "gravity":
            return number, 0.0
        return number, max(uncertainty, _LEAST.get(name, 0.0)) if isinstance(value, str) else 0.0

    def way(self, ways: Sequence[Way]) -> Way | None:
        """Which of the ways to measure one number was taken; None if none was.

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
        """Of numbers that can be measured in some ways each, those that are not, in words."""
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
    """A quantity in the units of a kitchen, to the digits that its uncertainty leaves it.

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
    """The reading from which most of a number's uncertainty comes; empty if it has none."""
    parts = {part.tag: size for part, size in number.error_components().items() if size > 0.0}
    return max(parts, key=parts.__getitem__, default="")
