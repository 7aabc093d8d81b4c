"""Whole motions are those of the paper's printed equations, integrated independently.

How close two computed motions can be: the oracle steps with a relative tolerance of 1e-12, and its
Euler angles lose 1e-16 / (least tilt) to cancellation in each of the hundred steps of a
near-collision; what is lost makes the motion early or late from there on. So each quantity may
differ by `closeness` of its own size and by what it changes in `closeness` times sqrt(R/g), where
closeness = 1e-11 + 3e-14 (1 + near-collisions) / (least tilt): twice what the can and 300 random
motions needed. rimroll's own error at rtol = 1e-13 is far below that.
"""

from dataclasses import dataclass

import numpy as np
import pytest
from hypothesis import assume, given

import rimroll as rr
from given.strategies import drawn, examples, rockings
from oracles import paper_equations as paper

LAWS = [rr.NoSlip(), rr.Frictionless()]
PAPER_START = rr.State(tilt=np.pi / 6, tilt_rate=-0.5, yaw_rate=0.005, spin_rate=0.005)
ACCURATE = 1e-13
ANGLES_AND_RATES = "psi", "phi", "theta", "psi_dot", "phi_dot", "theta_dot"


@dataclass(frozen=True)
class Pair:
    """One motion computed twice, and how close the two must be."""

    ours: rr.Motion
    theirs: paper.PaperMotion
    closeness: float

    @property
    def body(self):
        return self.ours.body

    @property
    def law(self):
        return self.ours.law.name

    @property
    def gravity(self):
        return self.ours.gravity

    @property
    def time(self):
        return np.sqrt(self.body.radius / self.gravity)


def computed_twice(body, start, law, duration, gravity):
    """The printed equations let the table pull at the rim, so they are followed only as far as
    rimroll goes."""
    ours = rr.simulate(body, start, law, duration, gravity=gravity, rtol=ACCURATE)
    theirs = paper.integrate(body, start, law.name, ours.t[-1], gravity=gravity)
    closeness = 1e-11 + 3e-14 * (1 + len(theirs.minima)) / theirs.phi.min()
    return Pair(ours, theirs, closeness)


@pytest.fixture(scope="module", params=LAWS, ids=lambda law: law.name)
def can(request):
    """The paper's can from the start of the paper's figure, through three near-collisions."""
    return computed_twice(rr.bodies.can_2007(), PAPER_START, request.param, 2.0, 9.8)


def in_the_paper_s_symbols(moments):
    """rimroll's moments as states for the printed formulas."""
    return paper.States(
        moments["t"],
        moments["yaw"],
        moments["tilt"],
        moments["spin"],
        moments["yaw_rate"],
        moments["tilt_rate"],
        moments["spin_rate"],
    )


def assert_same_states(pair, ours, theirs):
    """Angles and rates agree, at the same times."""
    rates = theirs.psi_dot, theirs.phi_dot, theirs.theta_dot
    accelerations = paper.angular_accelerations(
        pair.body, pair.law, theirs.phi, *rates, pair.gravity, np
    )
    angles = theirs.psi, theirs.phi, theirs.theta
    # Yaw and spin are measured against a radian, the tilt against itself, however small it is.
    sizes = 1.0, theirs.phi, 1.0
    for name, angle, size, rate, acceleration in zip(
        ("yaw", "tilt", "spin"), angles, sizes, rates, accelerations, strict=True
    ):
        allowed = pair.closeness * (size + np.abs(rate) * pair.time)
        np.testing.assert_array_less(np.abs(ours[name] - angle), allowed, name)
        size = np.abs(rate) + 1 / pair.time
        allowed = pair.closeness * (size + np.abs(acceleration) * pair.time)
        np.testing.assert_array_less(np.abs(ours[f"{name}_rate"] - rate), allowed, f"{name} rate")


def assert_same_motion(pair):
    """At the oracle's steps, which are not ours: the dense output is as good as the steps."""
    assert_same_states(pair, pair.ours.evaluate(pair.theirs.t), pair.theirs)


def oracle_at(pair, times):
    """The oracle's states at given times, to the accuracy of its steps.

    Its dense output is two orders below the steps (1e-8 near a collision), so it is made to step
    from its last step before each time to that time.
    """
    known = pair.theirs
    rows = []
    for t in times:
        i = np.searchsorted(known.t, t, side="right") - 1
        last = rr.State(
            tilt=known.phi[i],
            tilt_rate=known.phi_dot[i],
            yaw=known.psi[i],
            yaw_rate=known.psi_dot[i],
            spin=known.theta[i],
            spin_rate=known.theta_dot[i],
        )
        rest = paper.integrate(pair.body, last, pair.law, t - known.t[i], gravity=pair.gravity)
        rows.append([t, *(getattr(rest, name)[-1] for name in ANGLES_AND_RATES)])
    return paper.States(*np.reshape(rows, (-1, 7)).T)


def extremes(pair):
    """rimroll's tilt minima and maxima, except at the ends of the motion.

    A release at rest, and a last instant at rest, are extremes by rounding only.
    """
    margin = 1e-3 * pair.time
    return [
        event
        for event in pair.ours.events
        if event.kind in ("tilt_min", "tilt_max") and margin < event.t < pair.ours.t[-1] - margin
    ]


def assert_same_extremes(pair):
    """The oracle's tilt has the same minima and maxima, and is at rest when ours is."""
    margin = 1e-3 * pair.time
    for kind, theirs in ("tilt_min", pair.theirs.minima), ("tilt_max", pair.theirs.maxima):
        times = theirs.t[(theirs.t > margin) & (theirs.t < pair.ours.t[-1] - margin)]
        assert len([event for event in extremes(pair) if event.kind == kind]) == len(times)
    times = [event.t for event in extremes(pair)]
    if times:
        assert_same_states(pair, events_as_columns(extremes(pair)), oracle_at(pair, times))


def events_as_columns(events):
    names = "tilt", "tilt_rate", "yaw", "yaw_rate", "spin", "spin_rate"
    return {name: np.array([getattr(e.state, name) for e in events]) for name in names}


def assert_same_turns(pair):
    """Each turn is what the oracle's yaw changes from one tilt maximum (or release) to the next."""
    turns = pair.ours.turns
    if not turns:
        return
    starts, lows, ends = (
        oracle_at(pair, [getattr(turn, name) for turn in turns]) for name in ("start", "t", "end")
    )
    for i, turn in enumerate(turns):
        # At both ends the yaw hardly changes, so a delay has no effect.
        assert turn.angle == pytest.approx(ends.psi[i] - starts.psi[i], abs=2 * pair.closeness)
        assert turn.min_tilt == pytest.approx(lows.phi[i], rel=2 * pair.closeness)
        assert turn.yaw_rate == pytest.approx(lows.psi_dot[i], rel=2 * pair.closeness)
        assert turn.max_tilt == pytest.approx(ends.phi[i], rel=2 * pair.closeness)


def assert_forces_are_those_of_the_states(pair):
    """The printed formulas, given our states, yield our forces; the states are compared elsewhere.

    Compared at equal times instead, forces would show how late a motion is: 1e-11 s changes the
    peak of the normal force by 1e-6 of itself. The printed sums of terms as large as m R psi_ddot
    cancel by 1e-16 / tilt times a factor of the body, up to some hundreds.
    """
    ours = pair.ours.evaluate(pair.theirs.t)
    theirs = paper.contact_force(pair.body, in_the_paper_s_symbols(ours), pair.law, pair.gravity)
    size = pair.body.mass * pair.gravity + np.abs(theirs.normal)
    allowed = 1e-12 + 1e-13 / ours.tilt
    np.testing.assert_array_less(np.abs(ours.normal_force - theirs.normal) / size, allowed)
    for k in 0, 1:
        error = np.abs(ours.friction_force[:, k] - theirs.friction_in_world[k])
        np.testing.assert_array_less(error / size, allowed)
    # Where the rim lifts off the ratio has no bound.
    pressed = theirs.normal > 1e-3 * pair.body.mass * pair.gravity
    ratio = np.hypot(*theirs.friction[:, pressed]) / theirs.normal[pressed]
    error = np.abs(ours.friction_ratio[pressed] - ratio)
    np.testing.assert_array_less(error, 1e3 * allowed[pressed] * (1 + ratio))


def assert_energy_is_that_of_the_states_and_stays(pair):
    """Kinetic and potential energy follow from appendix B, and their sum from the start.

    The printed 2T cancels like the printed forces.
    """
    ours = pair.ours.evaluate(pair.theirs.t)
    states = in_the_paper_s_symbols(ours)
    upright = pair.body.mass * pair.gravity * pair.body.height
    total = paper.energy(pair.body, states, pair.law, pair.gravity) - upright
    rates = states.psi_dot, states.phi_dot, states.theta_dot
    kinetic = paper.doubled_kinetic_energy(pair.body, pair.law, states.phi, *rates, np) / 2
    size = upright + total[0]
    allowed = size * (1e-12 + 3e-14 / ours.tilt)
    np.testing.assert_array_less(np.abs(ours.kinetic_energy - kinetic), allowed)
    np.testing.assert_array_less(np.abs(ours.potential_energy - (total - kinetic)), allowed)
    # rtol is 1e-13.
    np.testing.assert_allclose(pair.ours.energy, ours.energy[0], rtol=0, atol=1e-13 * size)


def test_the_can_of_the_paper_moves_as_the_printed_equations_say(can):
    assert can.ours.status == "finished"
    assert can.closeness < 2e-9
    assert_same_motion(can)


def test_the_can_of_the_paper_rests_where_the_printed_equations_let_it_rest(can):
    assert len(extremes(can)) >= 6
    assert_same_extremes(can)


def test_the_can_of_the_paper_turns_as_the_printed_equations_say(can):
    assert len(can.ours.turns) >= 3
    assert_same_turns(can)


def test_the_can_of_the_paper_is_pushed_as_appendix_a_prints(can):
    assert_forces_are_those_of_the_states(can)


def test_the_can_of_the_paper_has_the_energy_of_appendix_b(can):
    assert_energy_is_that_of_the_states_and_stays(can)


def test_nine_digits_of_the_turns_come_without_asking(can):
    """The default rtol of 1e-10 is meant for tens of rockings; this is the first three."""
    motion = rr.simulate(can.body, PAPER_START, can.ours.law, 2.0, gravity=can.gravity)
    for turn, accurate in zip(motion.turns, can.ours.turns, strict=True):
        assert turn.angle == pytest.approx(accurate.angle, abs=1e-10)
        assert turn.min_tilt == pytest.approx(accurate.min_tilt, rel=1e-10, abs=0.0)
        assert turn.end == pytest.approx(accurate.end, abs=1e-10)


@pytest.mark.parametrize("law", LAWS, ids=lambda law: law.name)
def test_any_body_from_any_start_moves_as_the_printed_equations_say(law):
    turns = []

    @examples(30, derandomize=True)
    @given(rockings())
    def holds(rocking):
        case = rocking.body, rocking.start, law, 1.5 * rocking.time
        # Closer to the table the printed equations lose all digits.
        assume(rr.simulate(*case, gravity=rocking.gravity).tilt.min() > 1e-6)
        pair = computed_twice(*case, rocking.gravity)
        assert pair.ours.status in ("finished", "lifted_off")
        assert_same_motion(pair)
        assert_same_extremes(pair)
        assert_same_turns(pair)
        assert_forces_are_those_of_the_states(pair)
        assert_energy_is_that_of_the_states_and_stays(pair)
        turns.extend(pair.ours.turns)

    holds()
    # Otherwise the starts would differ from the intended ones.
    assert len(turns) > drawn(20)
