"""Resistance: vanishing, stopping the contact point, and with an infinite slope."""

from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.integrate import solve_ivp

import rimroll as rr
from given.strategies import examples, rockings, sizes
from oracles import paper_equations as paper

CAN = rr.bodies.can_2007()
NAMES = ("yaw", "tilt", "spin", "yaw_rate", "tilt_rate", "spin_rate")
IDEAL_LAWS = [rr.NoSlip(), rr.Frictionless()]
KINDS = ["dry", "viscous", "pivoting", "air", "air below 2"]


def resistance(kind, strength, body=CAN, gravity=9.8):
    """A resistance of a kind, its coefficient in units made of the body's numbers and gravity."""
    rate = np.sqrt(gravity / body.radius)
    weight = body.mass * gravity
    exponent = 1.6 if kind == "air below 2" else 4.0
    return {
        "dry": lambda: rr.RollingResistance(dry=strength),
        "viscous": lambda: rr.RollingResistance(viscous=strength * body.mass * rate),
        "pivoting": lambda: rr.PivotingFriction(strength * body.radius),
        "air": lambda: rr.AirDrag(strength * weight * body.radius * rate ** (1 - 4.0), 4.0),
        "air below 2": lambda: rr.AirDrag(
            strength * weight * body.radius * rate ** (1 - exponent), exponent
        ),
    }[kind]()


# As it vanishes


@given(rockings(least_sideways=1e-13), st.sampled_from(IDEAL_LAWS), st.sampled_from(KINDS))
@examples(60)
def test_a_resistance_next_to_nothing_changes_nothing(rocking, law, kind):
    none = rr.simulate(rocking.body, rocking.start, law, rocking.time, gravity=rocking.gravity)
    law = law + resistance(kind, 1e-300, rocking.body, rocking.gravity)
    some = rr.simulate(rocking.body, rocking.start, law, rocking.time, gravity=rocking.gravity)
    assert some.status == none.status
    assert [event.kind for event in some.events] == [event.kind for event in none.events]
    for with_it, without in zip(some.turns, none.turns, strict=True):
        assert with_it.angle == pytest.approx(without.angle, abs=1e-6)
        assert with_it.min_tilt == pytest.approx(without.min_tilt, rel=1e-6)


NEAR = rr.State(tilt=0.5236, tilt_rate=-0.5, yaw_rate=1e-8, spin_rate=1e-8)
"""It passes the table at a tilt of 1e-10 rad or so."""


def turn_in_a_motion(law):
    return rr.simulate(CAN, NEAR, law, 0.7).turns[0].angle


def turn_in_an_ensemble(law):
    starts = rr.State(**{name: np.full(3, value) for name, value in vars(NEAR).items()})
    falls = rr.ensemble(CAN, starts, law)
    assert set(falls.outcome.values) == {"rocked"}
    return float(falls.turn[1])


@pytest.mark.parametrize("turn", [turn_in_a_motion, turn_in_an_ensemble])
@pytest.mark.parametrize("law", IDEAL_LAWS, ids=lambda law: law.name)
@pytest.mark.parametrize("kind", KINDS)
def test_the_turn_goes_to_that_without_resistance_as_it_vanishes(turn, law, kind):
    strengths = 10.0 ** np.arange(-13.0, -31.0, -3.0)
    # Power goes like the yaw rate to the exponent, and that is 1e10 times sqrt(g/R).
    strengths *= 1e-20 if kind == "air" else 1.0
    without = turn(law)
    errors = [abs(turn(law + resistance(kind, s)) - without) for s in strengths]
    noise = 1e-7
    assert errors[-1] < noise
    assert all(small < max(0.1 * large, noise) for large, small in pairwise(errors))


@pytest.mark.parametrize("kind", ["dry", "viscous", "air", "air below 2"])
def test_a_motion_rises_again_or_is_stopped_as_the_resistance_is_weak_or_strong(kind):
    statuses = []
    for strength in 10.0 ** np.arange(-60.0, -1.9, 0.5):
        motion = rr.simulate(CAN, NEAR, rr.NoSlip() + resistance(kind, strength), 0.35)
        statuses.append(motion.status)
        budget = motion.energy_budget
        assert abs(budget - budget[0]).max() < 1e-8 * budget[0]
        if motion.status == "face_down":
            assert "resistance has stopped the contact point" in motion.message
            assert motion.tilt[-1] <= 1.001e-9
    # In between, dry resistance makes this body lift off.
    order = ["finished", "lifted_off", "face_down"]
    assert statuses == sorted(statuses, key=order.index)
    assert statuses[0] == "finished" and statuses[-1] == "face_down"


@pytest.mark.parametrize("kind", KINDS)
def test_below_the_least_tilt_the_message_is_that_without_resistance(kind):
    start = rr.State(tilt=0.5236, tilt_rate=-0.5, yaw_rate=1e-16)
    without = rr.simulate(CAN, start, rr.NoSlip())
    weak = rr.simulate(CAN, start, rr.NoSlip() + resistance(kind, 1e-300))
    assert without.status == weak.status == "face_down"
    assert "the tilt falls below 1e-16 rad" in weak.message
    assert weak.message == without.message


# Drag that is not smooth where the yaw rate is zero


@given(
    rockings(least_sideways=1e-6),
    st.sampled_from(IDEAL_LAWS),
    st.floats(1.5, 2.0, exclude_max=True),
    sizes(1e-8, 0.1),
)
@examples(100)
def test_drag_below_an_exponent_of_2_costs_no_more_than_usual(rocking, law, exponent, strength):
    body, g = rocking.body, rocking.gravity
    unit = body.mass * g * body.radius * np.sqrt(g / body.radius) ** (1 - exponent)
    law = law + rr.AirDrag(strength * unit, exponent)
    motion = rr.simulate(body, rocking.start, law, 3.0 * rocking.time, gravity=g)
    assert motion.status != "failed"
    assert motion.stats.steps < 5000 and motion.stats.rejected < 1000
    assert (np.diff(motion.t) >= 0.0).all()
    budget = motion.energy_budget
    assert abs(budget - budget[0]).max() < 1e-9 * abs(budget[0])
    assert (np.diff(motion.resistance_loss) >= -1e-15 * budget[0]).all()


SPUN = rr.State(tilt=0.4, spin_rate=5.0)
"""Its yaw rate begins at zero; spin drives it back and forth, and drag holds it close to zero."""


@pytest.mark.parametrize("exponent", [1.5, 1.6, 1.7, 1.8, 1.9, 1.99])
@pytest.mark.parametrize("law", IDEAL_LAWS, ids=lambda law: law.name)
def test_a_yaw_rate_held_close_to_zero_is_followed_to_the_end(law, exponent):
    motion = rr.simulate(CAN, SPUN, law + rr.AirDrag(1e-5, exponent), 5.0)
    assert motion.status in ("finished", "face_down")
    assert motion.stats.steps < 5000
    budget = motion.energy_budget
    assert abs(budget - budget[0]).max() < 1e-10 * budget[0]


def dragged(start, law, drag, t):
    """Yaw, tilt, spin and their rates at t (s) by the printed equations with the drag's moment."""

    def rates(_, y):
        *_angles, yaw_rate, tilt_rate, spin_rate = y
        tilt = y[1]
        numbers = (CAN, tilt, yaw_rate, tilt_rate, spin_rate, 9.8)
        Q, (first, second, third) = paper.LAWS[law](*numbers)
        size = drag.coefficient * abs(yaw_rate) ** (drag.exponent - 1.0)
        # The first row is of moments about the axis e_x2; a turn by the yaw turns sin φ about it.
        first -= np.copysign(size, yaw_rate) / np.sin(tilt)
        determinant = Q[0][0] * Q[2][2] - Q[0][2] * Q[2][0]
        yaw_acceleration = (first * Q[2][2] - Q[0][2] * third) / determinant
        spin_acceleration = (Q[0][0] * third - first * Q[2][0]) / determinant
        return (
            *(yaw_rate, tilt_rate, spin_rate),
            *(yaw_acceleration, second / Q[1][1], spin_acceleration),
        )

    angles = [start.yaw, start.tilt, start.spin]
    begin = [*angles, start.yaw_rate, start.tilt_rate, start.spin_rate]
    return solve_ivp(rates, (0.0, t), begin, method="DOP853", rtol=1e-12, atol=1e-14).y[:, -1]


THROUGH_ZERO = [
    ("no_slip", 1.5, 1e-4, SPUN, 0.36),
    (
        "frictionless",
        1.5,
        1e-4,
        rr.State(tilt=0.4, tilt_rate=0.2, yaw_rate=-0.3, spin_rate=2.0),
        0.21,
    ),
    (
        "frictionless",
        1.5,
        1e-4,
        rr.State(tilt=0.3, tilt_rate=0.2, yaw_rate=-0.3, spin_rate=4.0),
        0.16,
    ),
]
"""The yaw rate changes its sign twice or more."""
HELD_AT_ZERO = [
    ("no_slip", 1.8, 1e-5, SPUN, 1.196),
    ("frictionless", 1.8, 1e-5, SPUN, 0.59),
]
"""It decreases with the tilt to nearly zero."""


@pytest.mark.parametrize(
    ("law", "exponent", "coefficient", "start", "t"), THROUGH_ZERO + HELD_AT_ZERO
)
def test_drag_below_2_converges_to_the_printed_equations(law, exponent, coefficient, start, t):
    drag = rr.AirDrag(coefficient, exponent)
    exact = dragged(start, law, drag, t)
    ours = rr.laws.by_name(law) + drag
    motion = rr.simulate(CAN, start, ours, t, gravity=9.8)
    changes = np.count_nonzero(np.diff(np.sign(motion.yaw_rate[1:])))
    assert changes >= 2 if (law, exponent, coefficient, start, t) in THROUGH_ZERO else changes == 0
    sizes = np.abs([motion[name] for name in NAMES]).max(axis=1)
    for rtol in (1e-5, 1e-7, 1e-9, 1e-11):
        end = rr.simulate(CAN, start, ours, t, gravity=9.8, rtol=rtol)(t)
        errors = np.abs([getattr(end, name) for name in NAMES] - exact) / sizes
        assert errors.max() < 30.0 * rtol


@pytest.mark.parametrize("law", IDEAL_LAWS, ids=lambda law: law.name)
@pytest.mark.parametrize("exponent", [1.5, 1.9])
def test_without_yaw_there_is_no_drag(law, exponent):
    start = rr.State(tilt=0.4, tilt_rate=-0.3)
    without = rr.simulate(CAN, start, law)
    motion = rr.simulate(CAN, start, law + rr.AirDrag(0.1, exponent))
    assert motion.status == without.status == "face_down"
    # It ends at a tilt of 1e-9 rad, since no contact point could run there.
    assert motion.t[-1] == pytest.approx(without.t[-1], abs=1e-8)
    assert (motion.yaw_rate == 0.0).all() and (motion.resistance_loss == 0.0).all()
    assert motion.stats.steps < 500
