"""Motions fitted to what a sensor saw, as ``rimroll gyro`` and ``rimroll film`` print them."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping

from rich.table import Table

from rimroll.bodies.body import Body
from rimroll.cli.screen import prose, say, table
from rimroll.errors import RimrollError
from rimroll.laws import Coulomb, Law, RollingResistance
from rimroll.sensors.fits import Estimate
from rimroll.sensors.gyro.analysis import Analysis
from rimroll.sensors.gyro.motion_fit import fit_analysis
from rimroll.sensors.gyro.motion_result import MotionFit
from rimroll.theory.closed_forms import needed_friction

FIRST_RESISTANCE = 3e-4
"""The rolling resistance from which a search begins."""


def fitted(found: Analysis, resistance: bool, body_error: float) -> MotionFit:
    """The motion under dry friction, with a rolling resistance if asked for."""
    return fit_analysis(found, first_law(found.body, resistance), body_error=body_error)


def first_law(body: Body, resistance: bool) -> Law:
    """The dry friction, with a rolling resistance if asked for, from which a search begins."""
    needed = float(needed_friction(body))
    if needed == 0.0:
        raise RimrollError("a body without height turns alike at every friction: nothing to fit")
    law = Coulomb(0.5 * needed)
    return law + RollingResistance(dry=FIRST_RESISTANCE) if resistance else law


def show_fit(fit: MotionFit) -> None:
    """Print the fit: law, start, sensor, verdicts, notes."""
    say()
    many = "s" if sum(fit.followed) > 1 else ""
    prose(
        f"fit of the whole motion over {sum(fit.followed)} near-collision{many}:"
        f" {len(fit.t)} samples, residual {math.degrees(fit.residual):.2f} degrees/s"
    )
    say(numbers_table(fit.numbers, (*fit.fitted_of_law, *_of_first_release(fit))))
    for one in fit.verdicts[1:]:
        prose(f"{one.law!r}: {'excluded' if one.excluded else 'possible'}")
    for note in fit.notes:
        prose(f"Note: {note}")


def _of_first_release(fit: MotionFit) -> list[str]:
    names = ("tilt", "tilt_rate", "yaw_rate", "spin_rate", "delay")
    return [name if name in fit.numbers else f"{name}_1" for name in names]


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
