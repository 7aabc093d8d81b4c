"""The numbers of a fitted motion as a table: value, standard deviation, interval, method."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping

from rich.table import Table

from rimroll.cli.screen import table
from rimroll.sensors.fits import Estimate

MAX_PLACES = 9
"""Decimals of a number that is known exactly."""

_SHOWN: dict[str, tuple[float, str]] = {
    "friction": (1.0, ""),
    "rolling": (1.0, ""),
    "scale": (1.0, ""),
    "tilt": (math.degrees(1.0), "°"),
    "camera": (math.degrees(1.0), "°"),
    "delay": (1e3, " ms"),
    "release": (1.0, " s"),
}
"""The factor and the unit of numbers that are not shown in rad/s, by the beginning of the name."""


def numbers_table(numbers: Mapping[str, Estimate], names: Iterable[str]) -> Table:
    """A row for each of the named numbers."""
    rows = table("number", "value", "± 1 s.d.", "interval", "by")
    for name in names:
        rows.add_row(name, *_in_words(name, numbers[name]))
    return rows


def _in_words(name: str, one: Estimate) -> tuple[str, str, str, str]:
    factor, unit = 1.0, " rad/s"
    if "_rate" not in name:
        factor, unit = next(how for begin, how in _SHOWN.items() if name.startswith(begin))
    low, high = one.interval
    places = _places(factor * one.error)

    def text(value: float) -> str:
        return f"{factor * value:z.{places}f}"

    end = "or more" if high is None else f"to {text(high)}"
    begin = "0" if low is None else text(low)
    return f"{text(one.value)}{unit}", text(one.error), f"{begin} {end}", one.method


def _places(error: float) -> int:
    """The decimals of a number whose error is shown with two digits."""
    if not error > 0.0:
        return MAX_PLACES
    return min(max(1 - math.floor(math.log10(error)), 0), MAX_PLACES)
