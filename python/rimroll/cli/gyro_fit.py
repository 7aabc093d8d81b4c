"""What ``rimroll gyro --fit`` prints: the motion that was fitted to the record."""

from __future__ import annotations

import math

from rimroll.cli.screen import prose, say, table
from rimroll.errors import RimrollError
from rimroll.gyro.analysis import Analysis
from rimroll.gyro.motions.fit import fit_analysis
from rimroll.gyro.motions.result import Estimate, MotionFit
from rimroll.laws import Coulomb, RollingResistance
from rimroll.theory import needed_friction

FIRST_RESISTANCE = 3e-4
"""The rolling resistance from which a search begins."""


def fitted(found: Analysis, resistance: bool, body_error: float) -> MotionFit:
    """The motion under dry friction, with a rolling resistance if asked for."""
    needed = float(needed_friction(found.body))
    if needed == 0.0:
        raise RimrollError("a body without height turns alike at every friction: nothing to fit")
    law = Coulomb(0.5 * needed)
    if resistance:
        law = law + RollingResistance(dry=FIRST_RESISTANCE)
    return fit_analysis(found, law, body_error=body_error)


def show_fit(fit: MotionFit) -> None:
    """Print the fit: law, start, sensor, verdicts, notes."""
    say()
    many = "s" if sum(fit.followed) > 1 else ""
    prose(
        f"fit of the whole motion over {sum(fit.followed)} near-collision{many}:"
        f" {len(fit.t)} samples, residual {math.degrees(fit.residual):.2f} degrees/s"
    )
    rows = table("number", "value", "± 1 s.d.", "interval", "by")
    for name in (*fit.fitted_of_law, *_of_first_release(fit)):
        rows.add_row(name, *_in_words(name, fit.numbers[name]))
    say(rows)
    for one in fit.verdicts[1:]:
        prose(f"{one.law!r}: {'excluded' if one.excluded else 'possible'}")
    for note in fit.notes:
        prose(f"Note: {note}")


def _of_first_release(fit: MotionFit) -> list[str]:
    names = ("tilt", "tilt_rate", "yaw_rate", "spin_rate", "delay")
    return [name if name in fit.numbers else f"{name}_1" for name in names]


def _in_words(name: str, one: Estimate) -> tuple[str, str, str, str]:
    factor, unit = 1.0, "" if name.startswith(("friction", "rolling")) else " rad/s"
    if name.startswith("tilt") and not name.startswith("tilt_rate"):
        factor, unit = math.degrees(1.0), "°"
    if name.startswith("delay"):
        factor, unit = 1e3, " ms"
    low, high = one.interval
    places = _places(factor * one.error)

    def text(value: float) -> str:
        return f"{factor * value:z.{places}f}"

    end = "or more" if high is None else f"to {text(high)}"
    begin = "0" if low is None else text(low)
    return f"{text(one.value)}{unit}", text(one.error), f"{begin} {end}", one.method


MOST_PLACES = 9
"""Decimals of a number that is known exactly."""


def _places(error: float) -> int:
    """The decimals of a number whose error is shown with two digits."""
    if not error > 0.0:
        return MOST_PLACES
    return min(max(1 - math.floor(math.log10(error)), 0), MOST_PLACES)
