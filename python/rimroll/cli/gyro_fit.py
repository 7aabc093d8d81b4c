"""What ``rimroll gyro --fit`` prints: the motion that was fitted to the record."""

from __future__ import annotations

import math

from rimroll.bodies.body import Body
from rimroll.cli.fitted_numbers import numbers_table
from rimroll.cli.screen import prose, say
from rimroll.errors import RimrollError
from rimroll.laws import Coulomb, Law, RollingResistance
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
