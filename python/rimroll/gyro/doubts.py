"""Records that are none of a gyroscope in a rocking body: refused with what they look like."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from rimroll.body import Body
from rimroll.errors import RimrollError
from rimroll.gyro.axis import Axis
from rimroll.gyro.collision import Collision
from rimroll.gyro.filtering import Filter, filter_of
from rimroll.gyro.record import Record
from rimroll.gyro.rests import Rests

Array = NDArray[np.float64]

SLOWEST = 0.5
"""The largest rate of a record in which nothing falls, rad/s."""
STEEP, LEFT = 0.5, 0.8
"""The decay time that a filter leaves after it was taken out, over its own and over the step of the
record, from which on it is steeper than one of second order."""
MOST_LEFT = 2.0
"""The largest misfit of a record that is read: records of round bodies have at most 0.7."""
WIDEST = math.radians(45.0)
"""The largest error of a veer that says anything."""
GAINED = (0.1, 3.0)
"""The part of the energy, and how many of its errors, that a near-collision may seem to gain."""
FASTEST = 60.0
"""A rate in rad/s that no rocking body reaches, and that degrees/s easily do."""


def refuse_unlikely(record: Record, rates: Array, rests: Rests, body: Body, gravity: float) -> None:
    """Raise ``RimrollError`` for records in which no body can rock and fall."""
    sizes = np.linalg.norm(rates, axis=1)
    largest = float(sizes.max())
    still = np.median(np.linalg.norm(record.rates, axis=1))
    if abs(still - 9.8) < 1.0 and not rests.spans:
        raise RimrollError(
            f"{record.name}: the size of what it holds is mostly about 9.8, as that of an"
            " accelerometer at rest in m/s²: record the gyroscope (in phyphox: Gyroscope)"
        )
    if largest < SLOWEST:
        raise RimrollError(
            f"{record.name}: no rate is above {largest:.2g} rad/s, so nothing falls in it"
        )
    # A body that falls from its balance point reaches this rate, and a flick some of it more.
    fall = math.sqrt(
        2.0
        * gravity
        * (math.hypot(body.radius, body.height) - body.height)
        * body.mass
        / body.transverse_inertia
    )
    usual = float(np.percentile(sizes[sizes > 0.2 * largest], 50.0))
    if usual > max(6.0 * fall, FASTEST):
        raise RimrollError(
            f"{record.name}: rates of {usual:.0f} rad/s are far above those of a body that rocks"
            f" (some {fall:.0f} rad/s): they may be in degrees/s; give the unit, as in"
            ' units="deg/s" (on the command line --units deg/s)'
        )
    turned = np.trapezoid(rates, record.t, axis=0)
    longest = float(np.abs(turned).max())
    fraction = np.abs(rates).max(axis=0).max() / max(largest, 1e-9)
    if longest > math.tau and fraction > 0.98:
        column = int(np.abs(turned).argmax())
        other = float(np.sqrt((np.delete(rates, column, axis=1) ** 2).sum(axis=1)).max())
        if other < 0.3 * largest:
            raise RimrollError(
                f"{record.name}: the body turns {longest / math.tau:.1f} times about one axis and"
                " hardly about the others: it rolls on its side, or spins, and does not rock"
            )


def refuse_impossible(record: Record, axis: Axis, near: int, collisions: list[Collision]) -> None:
    """Raise ``RimrollError`` where what was read is no motion of such a body on its rim.

    ``near``: the near-collisions among which ``collisions`` follow gravity.
    """
    advice = "check the body, the axis and that the sensor is fixed in it; read one release alone"
    if near > 3 * len(collisions):
        raise RimrollError(
            f"{record.name}: in {near - len(collisions)} of {near} near-collisions tilt and rate do"
            f" not follow gravity as those of this body on its rim would: {advice}"
        )
    if collisions and axis.misfit > MOST_LEFT:
        raise RimrollError(
            f"{record.name}: {axis.misfit:.1f} times the sensor's noise is left of the momentum"
            f" about the vertical, more than {MOST_LEFT:g}: no body of revolution on its rim moves"
            f" like this; {advice}"
        )
    if collisions and min(one.veer_error for one in collisions) > WIDEST:
        raise RimrollError(
            f"{record.name}: the error of every veer is above {math.degrees(WIDEST):.0f} degrees,"
            f" wider than what laws of friction leave open: {advice}"
        )
    for one in collisions:
        if one.energy_kept is None or one.energy_kept_error is None:
            continue
        if one.energy_kept - 1.0 > max(GAINED[0], GAINED[1] * one.energy_kept_error):
            raise RimrollError(
                f"{record.name}: the near-collision at {one.time:.3f} s would leave"
                f" {100.0 * one.energy_kept:.0f} ± {100.0 * one.energy_kept_error:.0f} % of the"
                f" energy, and no body gains any: {advice}"
            )


def refuse_steep(record: Record, rates: Array, rests: Rests, taken_out: Filter) -> None:
    """Raise ``RimrollError`` where a filter that was taken out leaves a strong one."""
    left = filter_of(record.t, rates, rests.noise, LEFT)
    if left is not None and left.decay > STEEP * taken_out.decay:
        raise RimrollError(
            f"{record.name}: the sensor's filter smears a near-collision over"
            f" {4e3 * taken_out.decay:.0f} ms and is too steep to be taken out, so the turn cannot"
            " be read: record with the sensor's widest band"
        )
