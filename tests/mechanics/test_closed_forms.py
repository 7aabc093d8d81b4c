"""Closed forms, against the formulas written out and against whole motions."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

import rimroll as rr
from given.motions import CAN, DISK, LAWS, PAPER_START, by_law
from given.strategies import bodies, disks, few


def inertias(body, law):
    """J' and K' of a law."""
    rim = body.mass * body.radius**2
    k = body.transverse_inertia
    if law == rr.NoSlip():
        k += body.mass * body.height**2
    return k + rim, k


@by_law
@few
@given(body=bodies())
def test_limiting_turn_is_pi_times_the_root_of_j_over_k(law, body):
    J, K = inertias(body, law)
    assert rr.turn_limit(body, law) == pytest.approx(np.pi * np.sqrt(J / K), rel=1e-14, abs=0.0)


@few
@given(disk=disks())
def test_turn_of_a_disk_is_the_same_with_and_without_friction(disk):
    """The paper's k belongs to a flat body, C = 2A; free numbers with H = 0 have A alone."""
    no_slip, frictionless = (rr.turn_limit(disk, law) for law in LAWS)
    assert no_slip == pytest.approx(frictionless, rel=1e-14, abs=0.0)
    k = np.sqrt(2 * disk.transverse_inertia / (disk.mass * disk.radius**2))
    assert rr.disk_turn_limit(k) == pytest.approx(no_slip, rel=1e-14, abs=0.0)


def test_turn_of_a_uniform_disk_is_pi_sqrt_5_and_of_a_ring_pi_sqrt_3():
    for law in LAWS:
        assert rr.turn_limit(DISK, law) == pytest.approx(np.pi * np.sqrt(5), rel=1e-15, abs=0.0)
        assert rr.turn_limit(rr.bodies.ring(), law) == pytest.approx(
            np.pi * np.sqrt(3), rel=1e-15, abs=0.0
        )
    assert rr.disk_turn_limit(1e-9) > 1e9


@few
@given(body=bodies(), spin=st.floats(-30.0, 30.0), rate=st.floats(0.1, 20.0))
def test_turn_with_spin_has_an_arctangent_more(body, spin, rate):
    J, K = inertias(body, rr.NoSlip())
    lead = body.mass * body.height * body.radius * spin / (rate * np.sqrt(J * K))
    expected = np.sqrt(J / K) * (np.pi + 2 * np.arctan(lead))
    assert rr.turn_limit_with_spin(body, spin, rate) == pytest.approx(expected, rel=1e-13, abs=0.0)
    assert rr.turn_limit_with_spin(body, 0.0, rate) == rr.turn_limit(body, rr.NoSlip())


def arrival(rate, spin):
    """A near-collision of the can, so close to the table that gravity has no part in it.

    Yaw is far faster than the spin. The motion ends at the tilt where it began (but a little: a
    start must be below the tilt at which the motion ends).
    """
    tilt, yaw_rate = 1e-8, 1e5
    start = rr.State(tilt=tilt, tilt_rate=-rate, yaw_rate=yaw_rate, spin_rate=spin - yaw_rate)
    return rr.simulate(CAN, start, rr.NoSlip(), 1.0, topple_tilt=1.0001 * tilt)


@pytest.mark.parametrize("spin", [-0.3, -1.0, -2.0])
def test_a_can_that_arrives_spinning_turns_by_the_turn_with_spin(spin):
    """From a small tilt to the same tilt 2 sqrt(J/K) phi_c/phi = 7e-4 rad of it are missing."""
    rate = 3.0
    motion = arrival(rate, spin)
    assert motion.status == "toppled"
    turn = motion.yaw[-1] - motion.yaw[0]
    assert turn == pytest.approx(rr.turn_limit_with_spin(CAN, spin, rate), abs=1e-3)


@pytest.mark.parametrize("spin", [0.3, 1.0, 2.0])
def test_a_can_that_arrives_spinning_with_its_turn_lifts_off_instead(spin):
    """The turn with spin holds as long as the rim can push and pull."""
    assert arrival(3.0, spin).status == "lifted_off"


@by_law
@few
@given(body=bodies())
def test_tall_limit_is_above_the_limit_by_the_next_order_at_most(law, body):
    J, K = inertias(body, law)
    tall, exact = rr.tall_turn_limit(body, law), rr.turn_limit(body, law)
    assert tall == pytest.approx(np.pi + np.pi / 2 * (J / K - 1), rel=1e-14, abs=0.0)
    assert -1e-14 * exact <= tall - exact <= np.pi / 8 * (J / K - 1) ** 2 + 1e-14 * exact


def test_point_mass_limit_is_approached_as_the_moments_vanish():
    point = rr.Body(1.0, 0.1, 0.2, 1e-12, 1e-12)
    limit = rr.point_mass_turn_limit(0.1, 0.2, rr.NoSlip())
    assert limit == pytest.approx(np.pi * np.sqrt(1.25), rel=1e-15, abs=0.0)
    assert rr.turn_limit(point, rr.NoSlip()) == pytest.approx(limit, rel=1e-10, abs=0.0)
    assert rr.point_mass_turn_limit(0.1, 0.2, rr.Frictionless()) == np.inf
    assert rr.turn_limit(point, rr.Frictionless()) > 1e5


@few
@given(body=bodies())
def test_needed_friction_is_mhr_over_k(body):
    _, K = inertias(body, rr.NoSlip())
    expected = body.mass * body.height * body.radius / K
    assert rr.needed_friction(body) == pytest.approx(expected, rel=1e-14, abs=0.0)


def test_a_rolling_can_needs_that_friction_all_through_a_close_near_collision():
    """0.35577798 for the can. Gravity's part is of the order of the tilt, 1e-7 rad."""
    start = replace(PAPER_START, yaw_rate=1e-6, spin_rate=1e-6)
    motion = rr.simulate(CAN, start, rr.NoSlip(), 0.4, gravity=9.8)
    fine = motion.samples(10)
    close = fine.tilt < 3 * motion.events[0].state.tilt
    assert close.sum() > 100
    assert rr.needed_friction(CAN) == pytest.approx(0.35577798, abs=5e-9)
    np.testing.assert_allclose(fine.friction_ratio[close], rr.needed_friction(CAN), rtol=1e-5)


@by_law
@few
@given(body=bodies(), rate=st.floats(0.5, 20.0), gravity=st.floats(1.0, 30.0))
def test_error_law_coefficient_is_its_formula(law, body, rate, gravity):
    J, K = inertias(body, law)
    if law == rr.NoSlip():
        pressing = body.mass * (gravity * K / J - body.height * rate**2)
    else:
        pressing = body.mass * K * (gravity - body.height * rate**2) / J
    expected = -2 * np.sqrt(J / K) * body.radius * pressing / (K * rate**2)
    # N_p is a difference.
    allowed = 1e-13 * 2 * np.sqrt(J / K) * body.radius * body.mass / K
    allowed *= (gravity + body.height * rate**2) / rate**2
    given = rr.error_law_coefficient(body, law, rate, gravity)
    assert given == pytest.approx(expected, abs=allowed, rel=1e-13)


def test_error_law_of_the_can_from_the_paper_s_start():
    """-2.6919 without slip, -2.7181 without friction, by independent integration."""
    for law, expected in zip(LAWS, (-2.6919, -2.7181), strict=True):
        rate = rr.composite(CAN, PAPER_START, law, 9.8).tipping_rate
        assert rr.error_law_coefficient(CAN, law, rate, 9.8) == pytest.approx(expected, abs=5e-5)


@by_law
@few
@given(body=bodies(), tilt=st.floats(0.05, 1.5))
def test_a_steady_wobble_keeps_its_tilt_with_the_center_at_rest_and_no_friction(law, body, tilt):
    A, C, R, H = body.transverse_inertia, body.axial_inertia, body.radius, body.height
    rho = np.cos(tilt) - H / R * np.sin(tilt)
    stiffness = np.cos(tilt) - C * H / (A * R) * np.sin(tilt)
    assume(min(abs(rho), abs(stiffness)) > 0.1)
    if rho * stiffness < 0.0:
        with pytest.raises(rr.RimrollError, match="one at which a steady wobble exists"):
            rr.steady_wobble_rate(body, tilt)
        return
    yaw_rate = rr.steady_wobble_rate(body, tilt)
    spin_rate = yaw_rate * (body.height * np.sin(tilt) / body.radius - np.cos(tilt))
    start = rr.State(tilt=tilt, yaw_rate=yaw_rate, spin_rate=spin_rate)
    motion = rr.simulate(body, start, law, 3 / yaw_rate, rtol=1e-12)
    assert motion.status == "finished" and motion.events == []
    np.testing.assert_allclose(motion.tilt, tilt, rtol=1e-9)
    moved = motion.center - motion.center[0]
    np.testing.assert_allclose(moved, 0.0, atol=1e-9 * body.radius)
    np.testing.assert_allclose(motion.friction_ratio, 0.0, atol=1e-9)
    weight = body.mass * rr.STANDARD_GRAVITY
    np.testing.assert_allclose(motion.normal_force, weight, rtol=1e-9)


def test_a_tube_spins_nearly_horizontal_on_one_rim():
    tube = rr.bodies.cylinder("1 cm", "8 cm")
    rate = rr.steady_wobble_rate(tube, "85 deg")
    assert rate == pytest.approx(50.47878, abs=5e-6)
    (motion,) = rr.steady_motions(tube, rr.NoSlip(), "85 deg", yaw_rate=rate)
    assert motion.is_stable and motion.friction < 1e-12
    kept = rr.simulate(tube, motion.start, rr.NoSlip(), 2.0)
    assert np.ptp(kept.tilt) < 1e-9


@few
@given(body=bodies())
def test_balance_tilt_has_the_center_over_the_rim(body):
    tilt = rr.balance_tilt(body)
    assert tilt == pytest.approx(np.arctan2(body.radius, body.height), rel=1e-15, abs=0.0)
    rho = body.radius * np.cos(tilt) - body.height * np.sin(tilt)
    assert abs(rho) < 1e-15 * np.hypot(body.radius, body.height) * 4


def test_a_can_let_go_short_of_its_balance_falls_back_and_past_it_topples():
    for part, status in (0.99, "finished"), (1.01, "toppled"):
        start = rr.State(tilt=part * rr.balance_tilt(CAN), yaw_rate=1e-3)
        assert rr.simulate(CAN, start, rr.NoSlip(), 1.5).status == status


@few
@given(body=bodies(), gravity=st.floats(1.0, 30.0))
def test_lift_off_and_slip_rates_are_their_formulas(body, gravity):
    J, K = inertias(body, rr.NoSlip())
    m, H = body.mass, body.height
    lift_off = np.sqrt(gravity * K / (J * H)) if H else np.inf
    slip = np.sqrt(2 * m * gravity * H * K / (J * (K + m * H**2)))
    assert rr.lift_off_rate(body, gravity) == pytest.approx(lift_off, rel=1e-13, abs=0.0)
    assert rr.slip_rate(body, gravity) == pytest.approx(slip, rel=1e-13, abs=0.0)


def test_a_can_lifts_off_on_arrival_above_the_lift_off_rate_only():
    """10.605 rad/s with the paper's gravity; at a tilt of 1e-3 the rate is off by a part in 1e3."""
    rate = rr.lift_off_rate(CAN, 9.8)
    assert rate == pytest.approx(10.605, abs=5e-4)
    for factor, status in (0.995, "toppled"), (1.005, "lifted_off"):
        start = rr.State(tilt=1e-3, tilt_rate=-factor * rate, yaw_rate=1e-3)
        motion = rr.simulate(CAN, start, rr.NoSlip(), 0.01, gravity=9.8, topple_tilt=2e-3)
        assert motion.status == status


def test_at_the_slip_rate_tipping_needs_as_much_friction_as_rolling():
    """8.549 rad/s with the paper's gravity."""
    rate = rr.slip_rate(CAN, 9.8)
    assert rate == pytest.approx(8.549, abs=5e-4)
    start = rr.State(tilt=1e-9, tilt_rate=-rate, yaw_rate=1e-12)
    motion = rr.simulate(CAN, start, rr.NoSlip(), 1e-10, gravity=9.8)
    assert motion.friction_ratio[0] == pytest.approx(rr.needed_friction(CAN), rel=1e-7)
