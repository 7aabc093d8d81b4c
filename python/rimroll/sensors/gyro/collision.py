"""A near-collision as it was read, and the uncertainty of what was read."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from rimroll.bodies.body import Body
from rimroll.sensors.gyro.passages import TIME_ERROR, Axis, Leg, Sensed

Array = NDArray[np.float64]

MISSED = 0.3
"""Error of the turn over the squared ratio of the miss distance to the tilt, rad: from simulated
records, in which it matters where this ratio is above 0.15."""
SIDE_ERRORS = 6.0
"""How many times its error the momentum must be to tell the side of the turn."""
USUAL = 0.7
"""The largest misfit of records of round bodies; beyond it, errors grow in proportion."""
CUT_OFF = 5.0
"""What errors are multiplied by where the sensor's range cuts off the near-collision."""
LEAST_TILT = math.radians(4.0)
"""The smallest tilt from which a fall is read."""
MOST_MISSED = 0.25
"""The largest such ratio at which a passage is read as a near-collision."""
UNSEEN = 0.05
"""The part of the energy that may be of a translation that is not known."""
FIRST = 5
"""Samples at the start of a leg whose mean is the spin there."""
GRAVITY = (0.7, 1.35)
"""The energy that a fall gains over that which its height sets free: at least, with all the
translation of a rim that rests, and at most, with none but that upward. Simulated falls have 0.77
to 1.30."""
BESIDE = math.radians(12.0)
"""Tilt up to which the direction of the rate is extrapolated to the collision, rad."""


@dataclass(frozen=True)
class Collision:
    """A near-collision: angles in rad, rates in rad/s, times in s; errors are standard deviations.

    Attributes
    ----------
    time
        When the body was nearest to upright, in the time of the record.
    turn
        The angle of turn, as :class:`rimroll.Turn` counts it: the change of yaw from the release or
        the largest tilt before the collision to the largest tilt after it; positive if
        anticlockwise about the sensor's axis that points along the body.
    veer
        The size of the turn less π, with the standard deviation :attr:`veer_error`.
    turn_alone
        The turn of the near-collision alone, from the directions of the rate across the axis just
        before and just after it. No error is stated for it.
    released
        Whether the body was released before it, and not rocking already.
    start, end
        Times of the release or largest tilt before, and of the largest tilt after.
    last_before, first_after
        Times of the last sample before the collision and of the first after it that are used.
    tilt_before, tilt_after
        Tilts at the start and the end.
    rate_before, rate_after
        Rate across the axis just before and just after.
    spin_before, spin_after
        Spin about the axis just before and just after: ``spin_after`` is what is left behind.
    energy_kept
        Energy at ``end`` over that at ``start``: of height, and of rotation about the centre; at a
        release also of translation, by a rim that rests while the hand lets go. None where the
        energy of translation is not known to 5 %: after a flick the rim may slide at the release,
        and the record may end on the way to toppling.
    energy_kept_error
        Standard deviation of ``energy_kept``: from the time of the near-collision, the axis, the
        bias and the sensitivity. Nine in ten of simulated records are within two of them. None
        where ``energy_kept`` is.
    miss
        How far from upright the axis would have passed on a straight path, rad.
    yaw_rate, spin_rate, tilt_rate
        Rates of the Euler angles at ``start``.
    side_is_sure
        Whether the measured momentum exceeds its error by so much that it tells the direction of
        the turn; never if a strong filter or the sensor's range hides the near-collision. Else the
        direction is that in which the size of the turn is nearest to what the two ideal laws allow,
        and it may have been a turn to the other side.
    own_errors, shared_errors
        Standard deviations of the size of the turn (rad), the momentum about the vertical and the
        spin at ``start`` (both rad/s): what belongs to this near-collision alone, (3,); and what
        one standard deviation of each error that all near-collisions of the record share changes
        in them, with signs, (8, 3): two directions of the axis, the bias along x, y and z, and the
        sensitivity along x, y and z.
    """

    time: float
    turn: float
    veer: float
    turn_alone: float
    released: bool
    start: float
    end: float
    last_before: float
    first_after: float
    tilt_before: float
    tilt_after: float
    rate_before: float
    rate_after: float
    spin_before: float
    spin_after: float
    energy_kept: float | None
    energy_kept_error: float | None
    miss: float
    yaw_rate: float
    spin_rate: float
    tilt_rate: float
    side_is_sure: bool
    own_errors: Array
    shared_errors: Array

    @property
    def veer_error(self) -> float:
        """Standard deviation of the veer, rad."""
        return self._error(0)

    @property
    def momentum_error(self) -> float:
        """Standard deviation of the momentum about the vertical at ``start``, rad/s."""
        return self._error(1)

    def _error(self, column: int) -> float:
        return math.hypot(self.own_errors[column], *self.shared_errors[:, column])


def is_near(one: Sensed, axis: Axis) -> bool:
    """Whether a passage is a near-collision, between tilts that are large enough to be read."""
    fall, rise = one.legs(axis.direction)
    least = min(float(fall.tilt[0]), float(rise.tilt[-1]))
    return least > LEAST_TILT and _miss(one, fall, rise) < MOST_MISSED * least


def is_driven(one: Sensed, axis: Axis, body: Body, gravity: float) -> bool:
    """Whether gravity alone may have moved the body before and after a near-collision.

    Each half of its fall and of its rise must turn height into rotation as a body on its rim does.
    """
    return all(
        least > GRAVITY[0] and most < GRAVITY[1]
        for leg in one.legs(axis.direction)
        for least, most in _gains(leg, body, gravity)
    )


def _gains(leg: Leg, body: Body, gravity: float) -> list[tuple[float, float]]:
    """What :data:`GRAVITY` bounds: in both halves of a leg, if the rim rests and if it slides."""
    R, H = body.radius, body.height
    raised = R * np.sin(leg.tilt) + H * (leg.cos - 1.0)
    turning = body.transverse_inertia * leg.rate**2 + body.axial_inertia * leg.spin**2
    upward = (R * leg.cos - H * np.sin(leg.tilt)) * leg.tilt_rate
    middle = int(np.argmin(np.abs(leg.tilt - 0.5 * (leg.tilt[0] + leg.tilt[-1]))))
    out = []
    for first, last in ((0, middle), (middle, -1)):
        freed = body.mass * gravity * (raised[first] - raised[last])
        gained = [
            0.5 * (energy[last] - energy[first]) / freed if freed else 0.0
            for energy in (
                turning + body.mass * (R**2 + H**2) * leg.rate**2,
                turning + body.mass * upward**2,
            )
        ]
        out.append((float(gained[0]), float(gained[1])))
    return out


def _miss(one: Sensed, fall: Leg, rise: Leg) -> float:
    """How far from upright the axis would have passed on a straight path, rad."""
    before = abs(float(fall.momentum[-1])) / _speed(fall, one.passage.t)
    after = abs(float(rise.momentum[0])) / _speed(rise, one.passage.t)
    return 0.5 * (before + after)


def collision_of(one: Sensed, axis: Axis, body: Body, gravity: float, expected: float) -> Collision:
    """What a passage says; ``expected``: the middle of the turns that theory allows, rad."""
    direction = axis.direction
    fall, rise = one.legs(direction)
    changed = _changed(one, axis)
    own, shared = _errors(one, direction, changed, fall, rise)
    kept = _energy_kept(fall, rise, one.passage.released, body, gravity)
    arriving = float(fall.momentum[-1])
    is_whole = one.taken_out is None and not one.cut_off
    is_sure = is_whole and abs(arriving) > SIDE_ERRORS * math.hypot(own[1], *shared[:, 1])
    turn = _nearest(one.turn(direction), expected, arriving if is_sure else 0.0)
    alone = _alone(one, fall, rise, turn)
    inward, outward = _speed(fall, one.passage.t), _speed(rise, one.passage.t)
    miss = _miss(one, fall, rise)
    ratio = miss / min(fall.tilt[0], rise.tilt[-1])
    own[0] = math.hypot(own[0], MISSED * ratio**2)
    own *= max(1.0, axis.misfit / USUAL) * (CUT_OFF if one.cut_off else 1.0)
    shared[:, 0] *= math.copysign(1.0, turn)
    tilt, momentum = float(fall.tilt[0]), float(fall.momentum[0])
    yaw_rate = momentum / math.sin(tilt) ** 2
    spin = float(fall.spin[:FIRST].mean())
    return Collision(
        time=one.passage.t,
        turn=turn,
        veer=abs(turn) - math.pi,
        turn_alone=alone,
        released=one.passage.released,
        start=float(fall.t[0]),
        end=float(rise.t[-1]),
        last_before=float(fall.t[-1]),
        first_after=float(rise.t[0]),
        tilt_before=tilt,
        tilt_after=float(rise.tilt[-1]),
        rate_before=inward,
        rate_after=outward,
        spin_before=_spin_at(fall, one.passage.t),
        spin_after=_spin_at(rise, one.passage.t),
        energy_kept=kept,
        energy_kept_error=None if kept is None else _energy_error(kept, changed, body, gravity),
        miss=miss,
        yaw_rate=yaw_rate,
        spin_rate=spin - yaw_rate * math.cos(tilt),
        tilt_rate=float(fall.tilt_rate[0]) if one.passage.released else 0.0,
        side_is_sure=is_sure,
        own_errors=own,
        shared_errors=shared,
    )


def _nearest(turn: float, expected: float, side: float = 0.0) -> float:
    """The turn plus or minus whole revolutions whose size is nearest to what is expected.

    ``side``: the sign that the turn must have; 0 if it is not known.
    """
    possible = turn + 2.0 * math.pi * np.arange(-3, 4)
    allowed = possible[possible * side >= 0.0]
    return float(min(allowed, key=lambda angle: abs(abs(angle) - expected)))


@dataclass(frozen=True)
class Changed:
    """A passage with one error of one standard deviation: in its rates, the axis or its time."""

    one: Sensed
    direction: Array
    later: float = 0.0

    @cached_property
    def legs(self) -> tuple[Leg, Leg]:
        """The fall and the rise."""
        return self.one.legs(self.direction, self.later)

    def turn(self) -> float:
        """The turn, rad."""
        return self.one.turn(self.direction, self.later)


def _changed(one: Sensed, axis: Axis) -> list[Changed]:
    """The passage with each of the eight errors that a record shares, and with its time's."""
    values, vectors = np.linalg.eigh(axis.covariance)
    turned = [
        axis.moved(*(math.sqrt(value) * vector))
        for value, vector in zip(values, vectors.T, strict=True)
    ]
    mistaken = zip(one.mistaken, axis.shared, strict=True)  # they move the axis, too
    return [
        *(Changed(one, other) for other in turned),
        *(Changed(other, axis.moved(*shift)) for other, shift in mistaken),
        Changed(one, axis.direction, TIME_ERROR * one.step),
    ]


def _errors(
    one: Sensed, direction: Array, changed: list[Changed], fall: Leg, rise: Leg
) -> tuple[Array, Array]:
    """Own errors (3,) and shared ones (8, 3), as in :class:`Collision`, of the signed turn.

    The errors of the collision's time, the axis, the bias and the sensitivity are carried through
    by differences; that of the noise follows from the least squares of each leg.
    """
    turn, momentum = one.turn(direction), float(fall.momentum[0])
    spin = float(fall.spin[:FIRST].mean())

    def change(other: Changed) -> tuple[float, float, float]:
        apart = math.remainder(other.turn() - turn, 2.0 * math.pi)
        leg, _ = other.legs
        return apart, float(leg.momentum[0]) - momentum, float(leg.spin[:FIRST].mean()) - spin

    *shared, of_time = map(change, changed)
    excess = [max(1.0, float(np.sqrt(np.mean(leg.residual**2)))) for leg in (fall, rise)]
    of_turn = [
        excess[0] * fall.offset_error / math.sin(fall.tilt[0]),
        excess[1] * rise.offset_error / math.sin(rise.tilt[-1]),
    ]
    # The spin jumps at a time that is known to a part of a step.
    jump = (rise.spin[0] - fall.spin[-1]) * one.step * TIME_ERROR / 2.0
    own = [
        math.hypot(of_time[0], *of_turn, jump),
        math.hypot(of_time[1], excess[0] * fall.momentum_error),
        one.noise / math.sqrt(len(fall.t[:FIRST])),
    ]
    return np.array(own), np.array(shared)


def _alone(one: Sensed, fall: Leg, rise: Leg, turn: float) -> float:
    """The turn of the near-collision alone, near the whole turn, from directions of the rate."""
    alone = _direction_at(one, rise) - _direction_at(one, fall) + math.pi
    return turn + math.remainder(alone - turn, 2.0 * math.pi)


def _direction_at(one: Sensed, leg: Leg) -> float:
    """Direction of the rate across the axis at the collision, by a straight line over the time."""
    near = (leg.tilt < BESIDE) | (np.argsort(np.argsort(np.abs(leg.t - one.passage.t))) < 5)
    t, angle, size = leg.t[near] - one.passage.t, leg.direction[near], leg.rate[near]
    fitted = np.polynomial.polynomial.polyfit(t, angle, 1, w=size)
    return float(fitted[0])


def _near(leg: Leg, time: float) -> NDArray[np.intp]:
    """The samples of a leg nearest to a time."""
    return np.argsort(np.abs(leg.t - time))[: max(5, len(leg.t) // 8)]


def _speed(leg: Leg, time: float) -> float:
    """The rate across the axis at the collision, extrapolated."""
    near = _near(leg, time)
    return float(np.polyfit(leg.t[near] - time, leg.rate[near], 1)[1])


def _spin_at(leg: Leg, time: float) -> float:
    near = _near(leg, time)
    return float(np.polyfit(leg.t[near] - time, leg.spin[near], 1)[1])


def _energy_kept(fall: Leg, rise: Leg, released: bool, body: Body, gravity: float) -> float | None:
    """Energy after over energy before, where the unseen translation hardly matters."""
    before, after = _energy(fall, 0, body, gravity), _energy(rise, -1, body, gravity)
    upward, level = _of_translation(fall, body) if released else (0.0, 0.0)
    arm = body.radius**2 + body.height**2
    unseen = 0.5 * body.mass * arm * float(rise.tilt_rate[-1]) ** 2
    if level > UNSEEN * before or unseen > UNSEEN * after:
        return None
    return after / (before + upward + level)


def _energy_error(kept: float, changed: list[Changed], body: Body, gravity: float) -> float | None:
    """Standard deviation of the energy kept; None where an error makes it unknown."""
    others = [
        _energy_kept(*other.legs, other.one.passage.released, body, gravity) for other in changed
    ]
    known = [other - kept for other in others if other is not None]
    return math.hypot(*known) if len(known) == len(others) else None


def _energy(leg: Leg, at: int, body: Body, gravity: float) -> float:
    """Energy over that of standing: of height, and of rotation about the centre of mass, J."""
    tilt = float(leg.tilt[at])
    raised = body.radius * math.sin(tilt) + body.height * (math.cos(tilt) - 1.0)
    turning = body.transverse_inertia * leg.rate[at] ** 2 + body.axial_inertia * leg.spin[at] ** 2
    return float(body.mass * gravity * raised + 0.5 * turning)


def _of_translation(leg: Leg, body: Body) -> tuple[float, float]:
    """The energy of the centre's motion upward and level at the start, if the rim rests, J."""
    tilt, falling = float(leg.tilt[0]), float(leg.tilt_rate[0])
    upward = body.radius * math.cos(tilt) - body.height * math.sin(tilt)
    onward = body.radius * math.sin(tilt) + body.height * math.cos(tilt)
    across = float(leg.momentum[0]) / math.sin(tilt)  # yaw rate × sin(tilt)
    sideways = body.height * across - body.radius * float(leg.spin[0])
    level = (onward * falling) ** 2 + sideways**2
    return 0.5 * body.mass * (upward * falling) ** 2, 0.5 * body.mass * level
