"""The reduced equation of rocking, against whole motions and the quadrature."""

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

import rimroll as rr
from given.motions import CAN, DISK
from given.strategies import bodies, few


def rocking(size):
    return rr.State(tilt=np.pi / 6, tilt_rate=-0.5, yaw_rate=size, spin_rate=size)


def turn_error(size, order):
    """Turn of the reduced equation less that of the quadrature, rad, and the smallest tilt."""
    exact = rr.exact_turn(CAN, rocking(size), rr.NoSlip())
    reduced = rr.reduced_motion(CAN, rocking(size), 1.0, order=order)
    return float(reduced.yaw(reduced.maxima[:1])[0]) - exact.turn, exact.min_tilt


def test_at_order_zero_the_reduced_equation_lacks_the_logarithm_of_the_near_collisions_spin():
    """The equation has one of the three terms of the error law, that of gravity.

    The others are 2 √(J/K) (m H R/K) φ_c ln φ_c.
    """
    near, far = turn_error(1e-4, 0), turn_error(1e-3, 0)
    slope = (near[0] / near[1] - far[0] / far[1]) / np.log(near[1] / far[1])
    K = CAN.transverse_inertia + CAN.mass * CAN.height**2
    J = K + CAN.mass * CAN.radius**2
    expected = -2.0 * np.sqrt(J / K) * CAN.mass * CAN.height * CAN.radius / K
    assert slope == pytest.approx(expected, rel=2e-3)


@pytest.mark.parametrize(("order", "factor"), [(1, 4.0), (2, 0.05), (4, 3e-3), (6, 2e-5)])
def test_at_higher_orders_the_error_is_proportional_to_the_smallest_tilt(order, factor):
    near, far = turn_error(1e-4, order), turn_error(1e-2, order)
    assert near[0] / near[1] == pytest.approx(far[0] / far[1], rel=0.06)
    assert abs(near[0]) < factor * near[1]


@pytest.mark.parametrize("body", [CAN, DISK], ids=["can", "disk"])
def test_with_the_whole_series_it_is_the_motion(body):
    start = rr.State(tilt=0.6, tilt_rate=-0.3, yaw=0.2, yaw_rate=0.8, spin_rate=-1.3)
    whole = rr.simulate(body, start, rr.NoSlip(), 0.6, rtol=1e-12)
    reduced = rr.reduced_motion(body, start, 0.6, order=60)
    t = np.linspace(0.0, 0.6, 40)
    at = whole.evaluate(t)
    np.testing.assert_allclose(reduced.tilt(t), at.tilt, rtol=1e-8)
    np.testing.assert_allclose(reduced.tilt_rate(t), at.tilt_rate, atol=1e-7)
    np.testing.assert_allclose(reduced.yaw(t), at.yaw, atol=1e-8)


@few
@given(body=bodies(), part=st.floats(0.2, 0.9), rate=st.floats(0.05, 0.5))
def test_the_constants_are_those_of_the_near_collision(body, part, rate):
    start = rr.State(tilt=min(1.4, part * rr.balance_tilt(body)), yaw_rate=rate)
    exact = rr.exact_turn(body, start, rr.NoSlip())
    assume(exact.outcome == "rocked" and exact.min_tilt < 0.02)
    reduced = rr.reduced_motion(body, start, 1e-3)
    duration = 50.0 * np.sqrt(body.radius / rr.STANDARD_GRAVITY)
    motion = rr.simulate(body, start, rr.NoSlip(), duration, rtol=1e-11)
    lowest = motion.crossings(lambda at: at.tilt_rate, rising=True)[0]
    crossing_rate = lowest.state.yaw_rate * np.sin(lowest.state.tilt) ** 2
    # l and l₀ differ by the order of the smallest tilt, times ratios of inertias below 1.
    size = abs(crossing_rate) * exact.min_tilt + exact.min_tilt**2 * abs(reduced.spin_constant)
    assert reduced.crossing_rate == pytest.approx(crossing_rate, abs=3.0 * size + 1e-9)


@pytest.mark.parametrize("tilt_rate", [-0.5, -4.0, -8.2])
def test_the_friction_of_a_rocking_is_that_of_a_motion_with_small_sideways_rates(tilt_rate):
    start = rr.State(tilt=np.pi / 6, tilt_rate=tilt_rate, yaw_rate=1e-9, spin_rate=1e-9)
    motion = rr.simulate(CAN, start, rr.NoSlip(), 0.5)
    lowest = motion.crossings(lambda at: at.tilt_rate, rising=True)[0]
    at = motion.samples(8)
    largest = at.friction_ratio[at.t <= lowest.t].max()
    found = rr.rocking_friction(CAN, start)
    # It is reached at the end of the tipping, between two of the solver's steps.
    assert found == pytest.approx(largest, rel=1e-5 if tilt_rate > -5.0 else 1e-3)
    arrives = abs(rr.composite(CAN, start, rr.NoSlip()).tipping_rate)
    assert (found > rr.needed_friction(CAN) * (1.0 + 1e-9)) == (arrives > rr.slip_rate(CAN))


def test_what_is_refused():
    for wrong in (0.0, -9.81, np.nan):
        with pytest.raises(rr.RimrollError, match="gravity"):
            rr.reduced_motion(CAN, rocking(0.1), gravity=wrong)
        with pytest.raises(rr.RimrollError, match="gravity"):
            rr.rocking_friction(CAN, rr.State(tilt=0.5), gravity=wrong)
    with pytest.raises(rr.RimrollError, match="order must be a whole number from 0 to 60"):
        rr.reduced_motion(CAN, rocking(0.1), order=61)
    with pytest.raises(rr.RimrollError, match=r"tilt must be at most 1\.5"):
        rr.reduced_motion(DISK, rr.State(tilt=1.55, yaw_rate=1.0))
    with pytest.raises(rr.RimrollError, match="comes down flat"):
        rr.reduced_motion(CAN, rr.State(tilt=0.5))
    with pytest.raises(rr.RimrollError, match="does not come down"):
        rr.rocking_friction(CAN, rr.State(tilt=0.5, tilt_rate=1.0))
    with pytest.raises(rr.RimrollError, match="lifts off"):
        rr.rocking_friction(CAN, rr.State(tilt=0.5, tilt_rate=-12.0))
