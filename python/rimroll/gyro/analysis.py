"""A record of a gyroscope read: rests, axis, near-collisions, veers, friction."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from statistics import NormalDist
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from rimroll import _core
from rimroll.body import Body, one_body
from rimroll.errors import RimrollError, expect
from rimroll.given import Number, number, positive
from rimroll.gyro.axis import Axis, fitted_axis
from rimroll.gyro.collision import LEAST_TILT, Collision, collision_of, is_driven, is_near
from rimroll.gyro.doubts import refuse_impossible, refuse_steep, refuse_unlikely
from rimroll.gyro.falls import Falls, Passage, falls_of
from rimroll.gyro.filtering import Filter, filter_of
from rimroll.gyro.friction import Friction, Predicted, friction_from, predicted
from rimroll.gyro.passages import Sensed
from rimroll.gyro.record import Record
from rimroll.gyro.rests import Rests, rests_of, smallest_step
from rimroll.gyro.times import GAP, cut_off
from rimroll.theory import balance_tilt, needed_friction

if TYPE_CHECKING:
    from matplotlib.figure import Figure

Array = NDArray[np.float64]

AXES = ("x", "y", "z")
LOOSE = 0.8
"""What is left of the momentum, over its noise, from which on a sensor may be loose."""
OTHER_FILTER = 3.0
"""What errors are multiplied by if a filter was taken out, because the sensor's filter may be of
another kind."""
CLEARER = 2.0
"""How many times worse every other axis of the sensor must suit than the one that is taken."""


@dataclass(frozen=True, eq=False, repr=False)
class Analysis:
    """What a record says of the near-collisions in it: see :func:`analyze`.

    Attributes
    ----------
    record, body, gravity, confidence
        What it was read from. After a strong filter, the record is the one without it.
    rests
        Where the sensor was at rest, with its bias and noise.
    axis
        The body's symmetry axis in the sensor.
    collisions
        The near-collisions that could be read, in order of time.
    predictions
        The turn that each fall has at each friction; None for those that imply no friction.
    frictions
        The friction that each veer implies. While a hand holds the body, its rim rests on the
        table; later falls may begin with a rim that slides, so they imply no friction: None stands
        for them, unless the record has no release at all.
    friction
        The friction that these veers imply together; None, as are the others, for a body without
        height, whose turn is the same at every friction.
    limits
        The limiting angles of turn, rolling without slip and sliding without friction, rad.
    notes
        What to know about it, a sentence each.
    """

    record: Record
    body: Body
    gravity: float
    confidence: float
    rests: Rests
    axis: Axis
    collisions: list[Collision]
    predictions: list[Predicted | None]
    frictions: list[Friction | None]
    friction: Friction | None
    limits: tuple[float, float]
    notes: list[str]
    filter_cutoff: float | None
    """The cut-off frequency of a filter that was recognised and taken out, Hz."""

    def __repr__(self) -> str:
        veers = ", ".join(f"{math.degrees(one.veer):.1f}°" for one in self.collisions[:6])
        return f"<Gyroscope analysis: {len(self.collisions)} near-collisions, veers {veers}>"

    def rates(self) -> Array:
        """The rates less their bias, (n, 3), rad/s: two axes across the body, and along it."""
        from rimroll.gyro.attitude import across

        frame = np.stack([*across(self.axis.direction), self.axis.direction])
        turned: Array = (self.record.rates - self.rests.bias_at(self.record.t)) @ frame.T
        return turned

    def plot(self) -> Figure:
        """The record, the star of the rate across the axis, and the veers with their friction."""
        from rimroll.gyro.figure import analysis_figure

        return analysis_figure(self)

    def to_dict(self) -> dict[str, Any]:
        """Everything that was read, as plain numbers: angles in degrees, rates in rad/s."""
        from rimroll.gyro.summary import summary_of

        return summary_of(self)


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
    from rimroll.theory import turn_limit

    return float(turn_limit(body, NoSlip())), float(turn_limit(body, Frictionless()))


def chi_square(confidence: float) -> float:
    """The chi square of one degree of freedom that is exceeded with the rest of the probability."""
    return NormalDist().inv_cdf(0.5 + 0.5 * confidence) ** 2


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
