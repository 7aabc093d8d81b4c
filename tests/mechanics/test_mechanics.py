"""Motions obey Newton's laws, energy conservation, symmetry and scaling."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import rimroll as rr
from given.motions import CAN, PAPER_START, by_law, paper_motion
from given.strategies import bodies, few


def test_the_center_is_where_the_tilt_puts_it_over_the_contact(motion):
    rho = CAN.radius * np.cos(motion.tilt) - CAN.height * np.sin(motion.tilt)
    apart = motion.center[:, :2] - motion.contact_path
    np.testing.assert_allclose(np.hypot(*apart.T), np.abs(rho), rtol=0, atol=1e-15)
    # The contact point is at azimuth yaw + pi.
    toward = np.stack([np.cos(motion.yaw), np.sin(motion.yaw)], axis=-1)
    np.testing.assert_allclose(apart, rho[:, None] * toward, rtol=0, atol=1e-15)
    height = CAN.radius * np.sin(motion.tilt) + CAN.height * np.cos(motion.tilt)
    np.testing.assert_allclose(motion.center[:, 2], height, rtol=0, atol=1e-15)
    potential = CAN.mass * 9.8 * (motion.center[:, 2] - CAN.height)
    np.testing.assert_allclose(motion.potential_energy, potential, rtol=0, atol=1e-15)


def test_axial_spin_is_the_spin_rate_seen_from_outside(motion):
    seen = motion.spin_rate + motion.yaw_rate * np.cos(motion.tilt)
    # The two rates cancel: rounding of 8e4 rad/s is left.
    np.testing.assert_allclose(motion.axial_spin, seen, rtol=0, atol=3e-10)


# Central differences of fourth order: step in s, weights at -2h ... 2h.
STEP = 1e-3
FIRST = np.array([1.0, -8.0, 0.0, 8.0, -1.0]) / (12 * STEP)
SECOND = np.array([-1.0, 16.0, -30.0, 16.0, -1.0]) / (12 * STEP**2)


def times_away_from_collisions(motion):
    """Times where nothing happens within 2 STEP that differences could not resolve."""
    times = np.linspace(0.01, motion.t[-1] - 0.01, 400)
    times = times[motion.evaluate(times).tilt > 0.2]
    assert len(times) > 150
    return times


def difference(weights, motion, times, quantity):
    """A derivative with respect to time of a quantity of shape (n, k)."""
    around = times[:, None] + STEP * np.arange(-2, 3)
    values = getattr(motion.evaluate(around.ravel()), quantity)
    return np.einsum("j,ijk->ik", weights, values.reshape(len(times), 5, -1))


def test_the_table_s_force_and_gravity_accelerate_the_center(motion):
    """Tolerance: (STEP/0.07 s)^4 of the difference formula, relative to the weight."""
    times = times_away_from_collisions(motion)
    moments = motion.evaluate(times)
    weight = CAN.mass * 9.8
    force = np.column_stack([moments.friction_force, moments.normal_force - weight])
    acceleration = difference(SECOND, motion, times, "center")
    np.testing.assert_allclose(CAN.mass * acceleration, force, rtol=0, atol=1e-6 * weight)


def test_friction_on_a_rolling_rim_has_no_power():
    """The material point of the rim that touches the table is at rest."""
    motion = paper_motion(rr.NoSlip(), rtol=1e-13)
    times = times_away_from_collisions(motion)
    now = motion.evaluate(times)
    sin, cos = np.sin(now.yaw), np.cos(now.yaw)
    up = np.broadcast_to([0.0, 0.0, 1.0], (len(times), 3))
    e_x1 = np.column_stack([cos, sin, 0 * sin])
    e_y1 = np.column_stack([-sin, cos, 0 * sin])
    axis = np.cos(now.tilt)[:, None] * up - np.sin(now.tilt)[:, None] * e_x1
    turning = (
        now.yaw_rate[:, None] * up - now.tilt_rate[:, None] * e_y1 + now.spin_rate[:, None] * axis
    )
    arm = np.column_stack([now.contact_path, 0 * sin]) - now.center
    velocity = difference(FIRST, motion, times, "center") + np.cross(turning, arm)
    speed = np.linalg.norm(difference(FIRST, motion, times, "center"), axis=1).max()
    np.testing.assert_allclose(velocity, 0.0, atol=1e-7 * speed)
    power = np.einsum("ij,ij->i", now.friction_force, velocity[:, :2])
    np.testing.assert_allclose(power, 0.0, atol=1e-7 * CAN.mass * 9.8 * speed)


def test_a_rolling_rim_leaves_as_long_a_track_as_the_arc_it_rolled():
    motion = paper_motion(rr.NoSlip(), rtol=1e-13)
    times = times_away_from_collisions(motion)
    along = np.hypot(*difference(FIRST, motion, times, "contact_path").T)
    arc = CAN.radius * np.abs(motion.evaluate(times).spin_rate)
    np.testing.assert_allclose(along, arc, rtol=0, atol=1e-5 * arc.max())


def test_without_friction_the_center_moves_only_up_and_down():
    motion = paper_motion(rr.Frictionless())
    np.testing.assert_array_equal(motion.center[:, :2], 0.0)
    np.testing.assert_array_equal(motion.friction_force, 0.0)
    np.testing.assert_array_equal(motion.friction_ratio, 0.0)
    np.testing.assert_allclose(motion.axial_spin, motion.axial_spin[0], rtol=1e-12)


def test_friction_ratio_is_the_length_of_the_friction_over_the_normal_force(motion):
    ratio = np.hypot(*motion.friction_force.T) / motion.normal_force
    np.testing.assert_allclose(motion.friction_ratio, ratio, rtol=1e-13)


@by_law
def test_energy_stays_over_tens_of_rockings(law):
    """To the default rtol of 1e-10."""
    motion = paper_motion(law, duration=15.0)
    assert len(motion.turns) > 20
    total = motion.energy + CAN.mass * 9.8 * CAN.height
    np.testing.assert_allclose(total, total[0], rtol=1e-10)


@by_law
def test_the_mirror_image_of_a_start_moves_in_mirror_image(law):
    mirrored = replace(PAPER_START, yaw_rate=-0.005, spin_rate=-0.005)
    one, other = paper_motion(law), rr.simulate(CAN, mirrored, law, gravity=9.8)
    np.testing.assert_array_equal(one.t, other.t)
    np.testing.assert_array_equal(one.tilt, other.tilt)
    np.testing.assert_array_equal(one.yaw, -other.yaw)
    np.testing.assert_array_equal(one.center, other.center * [1, -1, 1])


@by_law
def test_a_start_turned_about_the_vertical_moves_the_same_way_turned(law):
    plain = paper_motion(law, rtol=1e-13)
    start = replace(PAPER_START, yaw=1.0, spin=2.0)
    turned = rr.simulate(CAN, start, law, gravity=9.8, rtol=1e-13)
    for turn, other in zip(plain.turns, turned.turns, strict=True):
        assert turn.angle == pytest.approx(other.angle, rel=1e-12, abs=0.0)
    times = np.linspace(0.0, 2.0, 50)
    plain, turned = plain.evaluate(times), turned.evaluate(times)
    # A lateness of 1e-13 s is seen where yaw runs.
    np.testing.assert_allclose(turned.yaw, plain.yaw + 1.0, rtol=0, atol=1e-9)
    np.testing.assert_allclose(turned.spin, plain.spin + 2.0, rtol=0, atol=1e-9)
    x, y = plain.center[:, 0], plain.center[:, 1]
    rotated = [np.cos(1) * x - np.sin(1) * y, np.sin(1) * x + np.cos(1) * y]
    np.testing.assert_allclose(turned.center[:, :2].T, rotated, rtol=0, atol=1e-12)


@by_law
@few
@given(body=bodies(), factor=st.sampled_from([0.25, 4.0, 16.0]))
def test_motions_scale_with_mass_and_length(law, body, factor):
    """Factors are powers of 4, whose roots are exact: the mass may not change a bit of the yaw."""
    start = rr.State(tilt=0.4 * rr.balance_tilt(body), yaw_rate=0.05, spin_rate=-0.02)
    time = 4 * np.sqrt(body.radius / 9.8)
    heavy = rr.Body(
        body.mass * factor,
        body.radius,
        body.height,
        body.transverse_inertia * factor,
        body.axial_inertia * factor,
    )
    plain = rr.simulate(body, start, law, time, gravity=9.8)
    massive = rr.simulate(heavy, start, law, time, gravity=9.8)
    np.testing.assert_array_equal(plain.yaw, massive.yaw)
    np.testing.assert_array_equal(plain.normal_force * factor, massive.normal_force)
    larger = rr.Body(
        body.mass,
        body.radius * factor,
        body.height * factor,
        body.transverse_inertia * factor**2,
        body.axial_inertia * factor**2,
    )
    slower = replace(
        start, yaw_rate=start.yaw_rate / np.sqrt(factor), spin_rate=-0.02 / np.sqrt(factor)
    )
    slow = rr.simulate(larger, slower, law, time * np.sqrt(factor), gravity=9.8)
    np.testing.assert_allclose(slow.yaw[-1], plain.yaw[-1], rtol=0, atol=1e-8)
    np.testing.assert_allclose(slow.center[-1] / factor, plain.center[-1], atol=1e-8 * body.radius)
