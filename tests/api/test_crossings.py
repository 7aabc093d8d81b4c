"""User-defined events: zeros of a function of the motion."""

from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import rimroll as rr
from given.strategies import composed_bodies, examples

CAN = rr.bodies.can_2007()
START = rr.State(tilt=0.5, tilt_rate=-0.5, yaw_rate=0.05, spin_rate=0.02)
ROLLING = rr.simulate(CAN, START, rr.NoSlip(), 3.0)
SLIPPING = rr.simulate(CAN, rr.State(tilt=0.37, yaw_rate=3.3, spin_rate=2.9), rr.Coulomb(0.2), 1.0)
BOUNCING = rr.simulate(
    CAN,
    rr.State(tilt=0.4, tilt_rate=-14.0, yaw_rate=5.0, spin_rate=-3.0),
    rr.Coulomb(0.2, restitution=0.6),
    0.5,
)


def times(events):
    return np.array([event.t for event in events])


def of_kind(motion, kind):
    return [event for event in motion.events if event.kind == kind]


@pytest.mark.parametrize("motion", [ROLLING, SLIPPING, BOUNCING])
def test_zeros_of_the_tilt_rate_are_the_extremes_of_the_tilt(motion):
    flying = [event.t for event in motion.events if event.kind in ("land", "lift_off")]
    count = 0
    for rising, kind in ((True, "tilt_min"), (False, "tilt_max")):
        found = motion.crossings(lambda at: at.tilt_rate, rising=rising)
        its = of_kind(motion, kind)
        # A landing may reverse the tilt rate: this is an extreme, and a jump over zero.
        its = [event for event in its if event.t not in flying]
        count += len(its)
        assert len(found) == len(its)
        # The core's own search ends at a tilt rate of some 1e-12 rad/s.
        assert times(found) == pytest.approx(times(its), abs=1e-12)
        for one, other in zip(found, its, strict=True):
            assert one.kind == "crossing"
            assert one.state.tilt == pytest.approx(other.state.tilt, rel=1e-11, abs=0.0)
            assert abs(one.state.tilt_rate) <= abs(other.state.tilt_rate) + 1e-14
    assert count > 0


def test_the_slip_comes_to_zero_where_the_rim_sticks():
    found = SLIPPING.crossings(lambda at: np.hypot(*at.slip.T))
    sticks = of_kind(SLIPPING, "stick")
    assert times(found).tolist() == times(sticks).tolist() and len(sticks) > 1
    assert SLIPPING.crossings(lambda at: np.hypot(*at.slip.T), rising=True) == []


def test_a_tilt_is_met_on_the_way_down_and_up_to_the_last_digits():
    found = ROLLING.crossings(lambda at: at.tilt - 0.3)
    assert len(found) == 2 * len(of_kind(ROLLING, "tilt_min"))
    for event in found:
        assert event.state.tilt == pytest.approx(0.3, abs=1e-15)
        assert ROLLING(event.t).tilt == pytest.approx(0.3, abs=1e-12)
    down = ROLLING.crossings(lambda at: at.tilt - 0.3, rising=False)
    up = ROLLING.crossings(lambda at: at.tilt - 0.3, rising=True)
    assert [event.t for event in sorted(down + up, key=lambda event: event.t)] == [
        event.t for event in found
    ]
    assert all(event.state.tilt_rate < 0.0 for event in down)
    assert all(event.state.tilt_rate > 0.0 for event in up)


@pytest.mark.parametrize("per_step", [2, 7, 64])
@pytest.mark.parametrize("clip", [np.maximum, np.minimum])
def test_a_clipped_function_comes_to_zero_where_the_unclipped_one_does(clip, per_step):
    found = ROLLING.crossings(lambda at: clip(at.tilt - 0.3, 0.0), per_step=per_step)
    free = ROLLING.crossings(lambda at: at.tilt - 0.3, rising=clip is np.minimum)
    assert len(free) > 1
    assert times(found) == pytest.approx(times(free), abs=1e-14)


@pytest.mark.parametrize("per_step", [2, 7, 64])
def test_a_dead_band_is_met_where_it_begins(per_step):
    found = ROLLING.crossings(
        lambda at: np.where(abs(at.tilt - 0.3) < 0.01, 0.0, at.tilt - 0.3), per_step=per_step
    )
    edges = [
        *ROLLING.crossings(lambda at: at.tilt - 0.31, rising=False),
        *ROLLING.crossings(lambda at: at.tilt - 0.29, rising=True),
    ]
    assert times(found) == pytest.approx(np.sort(times(edges)), abs=1e-14)


@given(st.floats(0.001, 2.999))
@examples(50)
def test_a_time_is_met_at_that_time(moment):
    (event,) = ROLLING.crossings(lambda at: at.t - moment)
    assert event.t == pytest.approx(moment, abs=1e-15)


def test_a_frictionless_fall_in_a_plane_is_met_where_the_energy_says():
    """Without sideways motion the tilt rate at a tilt follows from the energy alone."""
    start = rr.State(tilt=0.5, tilt_rate=-0.5)
    motion = rr.simulate(CAN, start, rr.NoSlip(), gravity=9.8)
    (event,) = motion.crossings(lambda at: at.tilt - 0.2)
    inertia = CAN.transverse_inertia + CAN.mass * (CAN.radius**2 + CAN.height**2)
    fallen = [CAN.radius * np.sin(phi) + CAN.height * np.cos(phi) for phi in (0.5, 0.2)]
    square = 0.25 + 2.0 * CAN.mass * 9.8 * (fallen[0] - fallen[1]) / inertia
    assert event.state.tilt_rate == pytest.approx(-np.sqrt(square), rel=1e-12, abs=0.0)


def test_landings_make_no_zeros_and_hide_none():
    landings = of_kind(BOUNCING, "land")
    assert len(landings) >= 3
    for landing in landings:
        before, after = BOUNCING.tilt_rate[BOUNCING.t == landing.t][[0, -1]]
        assert before != after
        # The tilt rate jumps over the values between, and never has them.
        jump = BOUNCING.crossings(lambda at, over=0.5 * (before + after): at.tilt_rate - over)
        assert landing.t not in times(jump)
        (event,) = BOUNCING.crossings(lambda at, t=landing.t: at.t - (t + 1e-9))
        assert event.t == pytest.approx(landing.t + 1e-9, abs=1e-15)
        (event,) = BOUNCING.crossings(lambda at, t=landing.t: at.t - t)
        assert event.t == landing.t


def test_the_gap_comes_back_to_zero_in_each_landing():
    found = BOUNCING.crossings(lambda at: at.gap, rising=False)
    assert set(times(of_kind(BOUNCING, "land"))) <= set(times(found).tolist())


@given(composed_bodies(), st.floats(0.3, 0.6), st.floats(0.05, 0.5), st.floats(-0.5, 0.5))
@examples(30)
def test_between_any_two_tilts_the_way_is_met_in_turns(body, part, yaw, spin):
    rate = np.sqrt(9.8 / body.radius)
    start = rr.State(
        tilt=part * rr.balance_tilt(body), yaw_rate=yaw * rate, spin_rate=0.1 * spin * rate
    )
    motion = rr.simulate(body, start, rr.Coulomb(0.3), 10.0 / rate, gravity=9.8)
    level = 0.5 * (motion.tilt.min() + motion.tilt.max())
    found = motion.crossings(lambda at: at.tilt - level)
    signs = np.sign(motion.tilt - level)
    assert len(found) >= np.count_nonzero(np.diff(signs[signs != 0.0]))
    for event in found:
        assert event.state.tilt == pytest.approx(level, rel=1e-13, abs=0.0)
    rises = [event.state.tilt_rate > 0.0 for event in found]
    assert all(one != other for one, other in pairwise(rises))


def test_a_near_collision_is_resolved_however_brief():
    motion = rr.simulate(CAN, rr.State(tilt=0.5, tilt_rate=-0.5, yaw_rate=1e-9), rr.NoSlip(), 0.5)
    low = of_kind(motion, "tilt_min")[0]
    assert low.state.tilt < 1e-9
    down, up = motion.crossings(lambda at: at.tilt - 2.0 * low.state.tilt)
    for event in (down, up):
        assert event.state.tilt == pytest.approx(2.0 * low.state.tilt, rel=1e-12, abs=0.0)
    assert down.t <= low.t <= up.t


def test_twins_within_a_step_are_found_by_looking_oftener():
    (low, *_) = of_kind(ROLLING, "tilt_min")
    level = low.state.tilt * (1.0 + 1e-6)
    found = ROLLING.crossings(lambda at: at.tilt - level, per_step=2000)
    assert len(found) >= 2 and found[0].t < low.t < found[1].t


@pytest.mark.parametrize(
    ("arguments", "says"),
    [
        ({"function": 0.3}, "function must be something to call, got 0.3"),
        ({"function": lambda at: at.tilt[:-1]}, r"function must give a number for each of the"),
        ({"function": lambda at: 1.0}, r"function must give a number .* got shape \(\)"),
        ({"function": lambda at: at.slip}, r"function must give a number .*, 2\)"),
        ({"function": lambda at: at.tilt > 0.3}, "function must give a number .* got bool values"),
        ({"function": lambda at: np.where(at.t > 1, np.nan, 1)}, "got nan at t = 1"),
        ({"function": lambda at: at.tilt, "per_step": 0}, "per_step must be a whole number >= 1"),
        ({"function": lambda at: at.tilt, "per_step": 10**9}, "per_step must be at most"),
        ({"function": lambda at: at.tilt, "rising": "up"}, "rising must be None, True or False"),
    ],
)
def test_what_is_no_function_of_the_motion_is_refused_in_words(arguments, says):
    with pytest.raises(rr.RimrollError, match=says):
        ROLLING.crossings(**arguments)


def test_what_the_function_raises_comes_through():
    with pytest.raises(ZeroDivisionError):
        ROLLING.crossings(lambda at: 1 / 0)


def test_functions_that_are_infinite_or_never_zero_are_no_trouble():
    assert ROLLING.crossings(lambda at: np.full(len(at), np.inf)) == []
    assert ROLLING.crossings(lambda at: np.zeros(len(at))) == []
    pole = ROLLING.crossings(lambda at: np.where(at.t < 1.0, -np.inf, np.inf))
    assert [event.t for event in pole] == [pytest.approx(1.0, abs=1e-12)]
