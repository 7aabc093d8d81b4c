"""A record of a gyroscope read: rests, axis, near-collisions, veers, friction."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from rimroll import _core
from rimroll.bodies.body import Body, one_body
from rimroll.errors import RimrollError, expect
from rimroll.sensors.fits import chi_square
from rimroll.sensors.gyro.analysis import Analysis
from rimroll.sensors.gyro.collision import LEAST_TILT, Collision, collision_of, is_driven, is_near
from rimroll.sensors.gyro.friction import friction_from, predicted
from rimroll.sensors.gyro.passages import Axis, Sensed, fitted_axis
from rimroll.sensors.gyro.peaks import Falls, Filter, Passage, falls_of, filter_of
from rimroll.sensors.gyro.record import GAP, Record, Rests, cut_off, rests_of, smallest_step
from rimroll.theory.closed_forms import balance_tilt, needed_friction
from rimroll.units import Number, number, positive

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


AXES = ("x", "y", "z")
LOOSE = 0.8
"""What is left of the momentum, over its noise, from which on a sensor may be loose."""
OTHER_FILTER = 3.0
"""What errors are multiplied by if a filter was taken out, because the sensor's filter may be of
another kind."""
CLEARER = 2.0
"""How many times worse every other axis of the sensor must suit than the one that is taken."""


def analyze(
    record: Record,
    body: Body,
    *,
    axis: str = "auto",
    gravity: Number = _core.STANDARD_GRAVITY,
    confidence: Number = 0.95,
) -> Analysis:
    """Read the near-collisions of a body from the record of a gyroscope inside it.

    The veers follow from Newton's and Euler's laws for a body of revolution on its rim. Of the laws
    of contact they assume only how many whole turns there were, and, where the momentum about the
    vertical is within its error, to which side (:attr:`Collision.side_is_sure`). The frictions are
    those of dry friction (``Coulomb``).

    A record should hold one release: after a catch the stated errors do not hold.

    Parameters
    ----------
    record
        From :func:`rimroll.gyro.read` or :meth:`rimroll.gyro.Sensor.record`.
    body
        The body with the sensor inside.
    axis
        The axis of the sensor that points along the body, up or down: ``"x"``, ``"y"`` or
        ``"z"``; with ``"auto"`` it is found from the motion. The exact direction, up to 20 degrees
        beside it, is always found from the motion.
    gravity
        m/s².
    confidence
        The confidence level of the intervals of friction.

    Returns
    -------
    Analysis

    Raises
    ------
    RimrollError
        A record without a fall, or one that does not look like that of a gyroscope in such a body:
        the message says what it looks like.

    Examples
    --------
    >>> import rimroll as rr
    >>> can = rr.bodies.can_2007()
    >>> start = rr.State(tilt=0.5, yaw_rate=0.1)
    >>> motion = rr.simulate(can, start, rr.Coulomb(0.2), duration=0.8)
    >>> record = rr.gyro.phone().record(motion)
    >>> found = rr.gyro.analyze(record, can)
    >>> len(found.collisions), abs(found.friction.best - 0.2) < 0.05
    (2, True)
    """
    expect("record", record, Record)
    one_body(body)
    if axis not in ("auto", *AXES):
        raise RimrollError(field="axis", value=axis, bound='"auto", "x", "y" or "z"')
    pull = positive("gravity", gravity, "m/s^2")
    level = number("confidence", confidence)
    if not 0.5 <= level < 1.0:
        raise RimrollError(field="confidence", value=level, bound="at least 0.5 and below 1")
    rests = rests_of(record)
    rates = record.rates - rests.bias_at(record.t)
    refuse_unlikely(record, rates, rests, body, pull)
    valid = _within_range(record)
    taken_out = filter_of(record.t, rates, rests.noise)
    if taken_out is not None:
        rounding = taken_out.noise(smallest_step(record.rates), record.step)
        record, valid = _unfiltered(record, valid, taken_out)
        rests = rests_of(record)
        rests = replace(rests, noise=max(rests.noise, rounding))
        rates = record.rates - rests.bias_at(record.t)
        refuse_steep(record, rates, rests, taken_out)
    candidates = AXES if axis == "auto" else (axis,)
    tried = [
        _along(record, rates, valid, rests, taken_out, body, pull, AXES.index(name))
        for name in candidates
    ]
    found, falls, sensed = _best(record, tried, [*candidates])
    cutoff = None if taken_out is None else taken_out.cutoff
    limits = _limits(body)
    middle = 0.5 * (limits[0] + limits[1])
    near = [one for one in sensed if is_near(one, found)]
    driven = [one for one in near if is_driven(one, found, body, pull)]
    collisions = [collision_of(one, found, body, pull, middle) for one in driven]
    refuse_impossible(record, found, len(near), collisions)
    notes = _notes(record, rests, found, falls, len(sensed) - len(near), collisions, body)
    if len(near) > len(driven):
        notes.append(
            f"Not read: {_counted(len(near) - len(driven), 'near-collision')} whose tilt and rate"
            " do not follow gravity."
        )
    if taken_out is not None:
        collisions = [replace(one, own_errors=OTHER_FILTER * one.own_errors) for one in collisions]
        notes.insert(0, _of_filter(taken_out))
    if not collisions:
        raise RimrollError(
            f"{record.name}: the body falls, but never upright through a near-collision that can"
            " be read: " + " ".join(one for one in notes if one not in record.notes)
        )
    if needed_friction(body) == 0.0:
        notes.append("A body without height turns alike at every friction, so none follows.")
        none = [None] * len(collisions)
        return Analysis(
            record,
            body,
            pull,
            level,
            rests,
            found,
            collisions,
            [],
            [*none],
            None,
            limits,
            notes,
            cutoff,
        )
    threshold = chi_square(level)
    used = [i for i, one in enumerate(collisions) if one.released] or [*range(len(collisions))]
    told = {i: predicted(collisions[i], body, pull) for i in used}
    predictions = [told.get(i) for i in range(len(collisions))]
    frictions = [
        friction_from([one], [told[i]], threshold) if i in told else None
        for i, one in enumerate(collisions)
    ]
    together = friction_from([collisions[i] for i in used], [*told.values()], threshold)
    if not collisions[used[0]].released:
        notes.append(
            "No fall begins with a release, so the friction assumes that the rim rests where the"
            " tilt is largest."
        )
    return Analysis(
        record, body, pull, level, rests, found, collisions, predictions, frictions, together,
        limits, notes, cutoff,
    )  # fmt: skip


Mask = NDArray[np.bool_]


def _within_range(record: Record) -> Mask:
    """The samples that are not cut off at the sensor's range, (n,)."""
    if cut_off(record.rates) == 0:
        return np.ones(len(record), bool)
    sizes = np.abs(record.rates)
    return np.asarray((sizes < (1.0 - 1e-6) * sizes.max()).all(axis=1))


def _unfiltered(record: Record, valid: Mask, taken_out: Filter) -> tuple[Record, Mask]:
    """The record as it was before a filter, and its samples that follow from valid ones."""
    t, rates = taken_out.undone(record.t, record.rates)
    return replace(record, t=t, rates=rates), valid[2:] & valid[1:-1] & valid[:-2]


def _of_filter(taken_out: Filter) -> str:
    return (
        "The sensor smears near-collisions, as a low-pass filter of second order at"
        f" {taken_out.cutoff:.0f} Hz does. This filter was taken out; as filters of other kinds"
        f" smear otherwise, the errors were multiplied by {OTHER_FILTER:g}. Choose the sensor's"
        " widest band."
    )


@dataclass(frozen=True)
class _Tried:
    """An axis of the sensor as the body's, and what the record then says."""

    axis: Axis | None
    falls: Falls
    sensed: list[Sensed]


def _along(
    record: Record,
    rates: Array,
    valid: Mask,
    rests: Rests,
    taken_out: Filter | None,
    body: Body,
    gravity: float,
    column: int,
) -> _Tried:
    """The passages if the body's axis is near one of the sensor's, with the axis that fits best."""
    guess = np.eye(3)[column]
    axis, falls, sensed = None, Falls([]), []
    for _ in range(2):  # a better axis shows the peaks better
        across = rates - np.outer(rates @ guess, guess)
        size = np.linalg.norm(across, axis=1)
        falls = falls_of(record.t, size, rests.noise, body, gravity, valid)
        if not falls.passages:
            return _Tried(None, falls, [])
        sensed = [
            Sensed(
                one,
                record.t[one.start : one.end + 1],
                rates[one.start : one.end + 1],
                rests.noise,
                rests.bias_error,
                body,
                taken_out,
                not valid[one.before : one.after + 1].all(),
            )
            for one in falls.passages
            if not _has_gap(record, one)
        ]
        if not sensed:
            return _Tried(None, falls, [])
        axis = fitted_axis(sensed, np.eye(3)[column], None if axis is None else guess)
        guess = axis.direction
    return _Tried(axis, falls, sensed)


def _has_gap(record: Record, one: Passage) -> bool:
    """Whether samples are missing in a passage."""
    return bool((np.diff(record.t[one.start : one.end + 1]) > GAP * record.step).any())


def _best(
    record: Record, tried: list[_Tried], names: list[str]
) -> tuple[Axis, Falls, list[Sensed]]:
    """The axis that suits clearly best; ``RimrollError`` where none does."""
    possible = [
        (one.axis.misfit / len(one.sensed), name, one)
        for name, one in zip(names, tried, strict=True)
        if one.axis is not None
    ]
    if not possible:
        most = max((one.falls for one in tried), key=lambda falls: falls.unread)
        why = most.why_unread(record.sampling_rate)
        more = f"; peaks of the rate that were not read: {why}" if why else ""
        raise RimrollError(
            f"{record.name}: no fall through a near-collision was found{more}. Give the body that"
            " was recorded, and an axis if you know which one points along it"
        )
    possible.sort(key=lambda one: one[0])
    if len(possible) > 1 and possible[1][0] < CLEARER * possible[0][0]:
        raise RimrollError(
            f"{record.name}: the motion fits the axes {possible[0][1]} and {possible[1][1]} of the"
            ' sensor about as well: say which one points along the body, as in axis="z" (on the'
            " command line --axis z)"
        )
    best = possible[0][2]
    assert best.axis is not None
    return best.axis, best.falls, best.sensed


def _limits(body: Body) -> tuple[float, float]:
    from rimroll.laws import Frictionless, NoSlip
    from rimroll.theory.closed_forms import turn_limit

    return float(turn_limit(body, NoSlip())), float(turn_limit(body, Frictionless()))


def _notes(
    record: Record,
    rests: Rests,
    axis: Axis,
    falls: Falls,
    far: int,
    collisions: list[Collision],
    body: Body,
) -> list[str]:
    notes = list(record.notes)
    if not rests.spans:
        notes.append(
            "Nothing rests for 0.3 s, so the bias is unknown: it is taken as 0 ± 1 degree/s."
        )
    elif rests.drift > 5.0 * rests.bias_error and rests.drift > 0.005:
        notes.append(
            f"The bias drifts by {math.degrees(rests.drift):.2f} degrees/s between the rests; it is"
            " taken as linear in time."
        )
    if axis.misfit > LOOSE:
        notes.append(
            f"The motion leaves {axis.misfit:.1f} times the sensor's noise unexplained: the sensor"
            " may be loose, the body not the one given or not round."
        )
    if falls.unread:
        notes.append(
            f"Not read: {_counted(falls.unread, 'other peak')} of the rate:"
            f" {falls.why_unread(record.sampling_rate)}."
        )
    if far:
        notes.append(
            f"Not read: {_counted(far, 'passage')} with a tilt below"
            f" {math.degrees(LEAST_TILT):.0f} degrees before or after, or too far from upright for"
            " a near-collision."
        )
    if any(one.tilt_after > 0.97 * float(balance_tilt(body)) for one in collisions):
        notes.append("The body rose as far as its balance point, and may have toppled.")
    unsure = sum(not one.side_is_sure for one in collisions)
    if unsure:
        notes.append(
            f"The side of {_counted(unsure, 'turn')} is the one that theory makes likelier: the"
            " momentum about the vertical is within its error."
        )
    return notes


def _counted(count: int, what: str) -> str:
    return f"{count} {what}" if count == 1 else f"{count} {what}s"
