"""What a Python user sees: bodies, starts, motions and all that is read off them."""

import doctest
import hashlib
import pickle
import signal
import subprocess
import sys
import time
from dataclasses import FrozenInstanceError, asdict, replace

import numpy as np
import pytest
import xarray as xr
from hypothesis import given, settings
from hypothesis import strategies as st

import rimroll as rr
import rimroll.body
import rimroll.laws
import rimroll.motion
from strategies import bodies, disks, upright_solids

LAWS = [rr.NoSlip(), rr.Frictionless()]
by_law = pytest.mark.parametrize("law", LAWS, ids=lambda law: law.name)
few = settings(max_examples=60, derandomize=True, deadline=None)

CAN = rr.bodies.can_2007()
DISK = rr.bodies.disk(0.05)
PAPER_START = rr.State(tilt=np.pi / 6, tilt_rate=-0.5, yaw_rate=0.005, spin_rate=0.005)


def paper_motion(law, **options):
    return rr.simulate(CAN, PAPER_START, law, **{"gravity": 9.8, **options})


@pytest.fixture(scope="module", params=LAWS, ids=lambda law: law.name)
def motion(request):
    """Three near-collisions of the paper's can, with the digits that finite differences need."""
    return paper_motion(request.param, rtol=1e-13)


def bits(moments):
    """A fingerprint of every column, to the last bit."""
    columns = [moments[name].tobytes() for name in rimroll.motion.UNITS]
    return hashlib.sha256(b"".join(columns)).hexdigest()


def same_bits(one, other):
    return bits(one) == bits(other)


# Arrays and dense output


def test_arrays_have_a_row_for_every_accepted_step(motion):
    steps = (len(motion),)
    assert steps == (motion.stats.steps + 1,)
    for name in rimroll.motion.UNITS:
        assert motion[name].shape == steps and motion[name].dtype == np.float64
        assert np.isfinite(motion[name]).all()
    for name in ("tilt", "tilt_rate", "yaw", "yaw_rate", "spin", "spin_rate", "axial_spin"):
        np.testing.assert_array_equal(getattr(motion, name), motion[name])
    assert motion.center.shape == (*steps, 3)
    assert motion.contact_path.shape == motion.friction_force.shape == (*steps, 2)
    assert motion.energy.shape == motion.normal_force.shape == motion.friction_ratio.shape == steps


def test_a_motion_begins_with_its_start_and_ends_when_it_should(motion):
    for name, value in asdict(PAPER_START).items():
        # Through sine and cosine and back.
        assert motion[name][0] == pytest.approx(value, rel=0, abs=2e-16)
    np.testing.assert_array_equal(motion.center[0, :2], 0.0)
    assert motion.t[0] == 0.0 and motion.t[-1] == 2.0
    assert (np.diff(motion.t) > 0.0).all()


@pytest.mark.parametrize("digits", range(3, 13))
def test_duration_is_kept_to_the_bit(digits):
    duration = round(np.pi / 10, digits)
    assert paper_motion(rr.NoSlip(), duration=duration).t[-1] == duration


def test_dense_output_goes_through_the_accepted_steps(motion):
    """As well as a time can say where: in the near-collision yaw runs 1e5 rad/s."""
    dense = motion.evaluate(motion.t)
    np.testing.assert_array_equal(dense.t, motion.t)
    rounding = 4 * np.finfo(float).eps * motion.t
    for name, rate in ("yaw", "yaw_rate"), ("tilt", "tilt_rate"), ("spin", "spin_rate"):
        error = np.abs(dense[name] - motion[name])
        np.testing.assert_array_less(error, 1e-14 + np.abs(motion[rate]) * rounding)
    np.testing.assert_allclose(dense.center, motion.center, rtol=0, atol=1e-15)
    np.testing.assert_allclose(dense.energy, motion.energy, rtol=1e-13)


def test_dense_output_is_as_accurate_as_the_steps():
    """At the steps of a motion computed with other tolerance, which lie between."""
    for law in LAWS:
        fine, coarse = paper_motion(law, rtol=1e-13), paper_motion(law, rtol=1e-8)
        dense = coarse.evaluate(fine.t)
        lateness = 1e-7 * np.sqrt(CAN.radius / 9.8)
        for name, rate in ("yaw", "yaw_rate"), ("tilt", "tilt_rate"), ("spin", "spin_rate"):
            error = np.abs(dense[name] - fine[name])
            np.testing.assert_array_less(error, 1e-7 + np.abs(fine[rate]) * lateness)


def test_a_motion_called_with_times_gives_states(motion):
    times = np.linspace(0.0, 2.0, 7)
    states = motion(times)
    assert isinstance(states, rr.State) and states.shape == (7,)
    moments = motion.evaluate(times)
    for name in asdict(PAPER_START):
        np.testing.assert_array_equal(getattr(states, name), moments[name])
    # One time gives one state, that a motion can start from.
    once = motion(0.3)
    assert once.shape == ()
    assert once.tilt == motion([0.3]).tilt[0]
    onward = rr.simulate(CAN, once, motion.law, 0.5, gravity=motion.gravity)
    assert onward(0.5).tilt == pytest.approx(motion(0.8).tilt, abs=1e-9)
    assert motion.evaluate([]).center.shape == (0, 3)
    # In any order.
    np.testing.assert_array_equal(motion(times[::-1]).yaw, states.yaw[::-1])


@pytest.mark.parametrize("outside", [-1e-9, 2.0000001, np.nan, np.inf, [0.5, 2.5]])
def test_times_outside_the_motion_are_refused(motion, outside):
    with pytest.raises(
        rr.RimrollError, match=r"t must be inside the motion, 0 to 2 s \(finished\)"
    ):
        motion.evaluate(outside)
    with pytest.raises(rr.RimrollError, match="t must be inside"):
        motion(outside)


def test_samples_lie_evenly_in_each_step(motion):
    samples = motion.samples(5)
    assert len(samples) == 5 * motion.stats.steps + 1
    np.testing.assert_array_equal(samples.yaw[::5], motion.yaw)
    assert (np.diff(samples.t) >= 0.0).all()
    assert len(motion.samples()) == 4 * motion.stats.steps + 1
    assert same_bits(motion.samples(1), motion)
    with pytest.raises(rr.RimrollError, match="per_step must be a whole number >= 1, got 0"):
        motion.samples(0)
    with pytest.raises(rr.RimrollError, match="per_step must be at most"):
        motion.samples(10**9)


# Events and turns


def test_events_come_in_order_with_tilt_minima_and_maxima_in_turns(motion):
    times = [event.t for event in motion.events]
    assert times == sorted(times)
    kinds = [event.kind for event in motion.events]
    assert kinds == ["tilt_min", "tilt_max"] * (len(kinds) // 2) + ["tilt_min"] * (len(kinds) % 2)
    assert len(kinds) >= 6


def test_at_an_extreme_the_tilt_is_at_rest_and_nowhere_beyond(motion):
    fine = motion.samples(8)
    lows, highs = (
        [event.state.tilt for event in motion.events if event.kind == kind]
        for kind in ("tilt_min", "tilt_max")
    )
    assert min(lows) <= fine.tilt.min() * (1 + 1e-12)
    assert max(highs) >= fine.tilt.max() * (1 - 1e-12)
    for event in motion.events:
        # The body's angular velocity is some rad/s all the time.
        assert abs(event.state.tilt_rate) < 1e-11


def test_a_turn_is_measured_from_rest_to_rest(motion):
    lows = [event for event in motion.events if event.kind == "tilt_min"]
    highs = [event for event in motion.events if event.kind == "tilt_max"]
    yaw, start = PAPER_START.yaw, 0.0
    assert len(motion.turns) == len(highs)
    for turn, low, high in zip(motion.turns, lows, highs, strict=False):
        assert (turn.start, turn.t, turn.end) == (start, low.t, high.t)
        assert turn.angle == high.state.yaw - yaw
        assert (turn.min_tilt, turn.yaw_rate) == (low.state.tilt, low.state.yaw_rate)
        assert turn.max_tilt == high.state.tilt
        yaw, start = high.state.yaw, high.t


def test_a_release_upward_starts_its_first_turn_at_the_top():
    start = replace(PAPER_START, tilt_rate=0.5)
    motion = rr.simulate(CAN, start, rr.NoSlip(), 1.0, gravity=9.8)
    assert [event.kind for event in motion.events][:3] == ["tilt_max", "tilt_min", "tilt_max"]
    assert motion.turns[0].start == motion.events[0].t > 0.0


def test_a_release_at_rest_is_no_event():
    start = replace(PAPER_START, tilt_rate=0.0)
    motion = rr.simulate(CAN, start, rr.NoSlip(), 1.0, gravity=9.8)
    assert motion.events[0].kind == "tilt_min" and motion.turns[0].start == 0.0


def test_a_disk_passes_its_edge_and_turns_on_its_other_face():
    start = rr.State(tilt=1.2, tilt_rate=10.0, yaw_rate=0.3, spin_rate=0.1)
    motion = rr.simulate(DISK, start, rr.Frictionless(), 0.4)
    first, over, second = motion.events
    assert [first.kind, over.kind, second.kind] == ["on_edge", "tilt_max", "on_edge"]
    assert first.state.tilt == pytest.approx(np.pi / 2, abs=1e-15)
    (turn,) = motion.turns
    assert turn.min_tilt == pytest.approx(np.pi - over.state.tilt, abs=1e-15)
    assert (turn.start, turn.t, turn.end) == (first.t, over.t, second.t)
    assert turn.max_tilt == pytest.approx(np.pi / 2, abs=1e-15)


# How motions end


def test_a_motion_is_finished_when_time_is_up(motion):
    assert (motion.status, motion.message) == ("finished", "followed for the whole 2 s")


@by_law
def test_a_can_pushed_over_its_balance_topples_onto_its_side(law):
    motion = rr.simulate(CAN, replace(PAPER_START, tilt_rate=5.0), law)
    assert motion.status == "toppled" and motion.message.startswith(
        "toppled: the tilt reached 1.57"
    )
    assert motion.tilt[-1] == pytest.approx(np.pi / 2, abs=1e-14)
    assert motion.events[-1].kind == "topple" and motion.events[-1].t == motion.t[-1]
    assert motion.topple_tilt is None


@by_law
@pytest.mark.parametrize("tilt", [0.6, 1.0, 1.8])
def test_the_tilt_that_counts_as_toppled_can_be_set(law, tilt):
    motion = rr.simulate(CAN, replace(PAPER_START, tilt_rate=5.0), law, topple_tilt=tilt)
    assert motion.status == "toppled" and motion.topple_tilt == tilt
    assert motion.tilt[-1] == pytest.approx(tilt, abs=1e-14)
    assert (motion.tilt[:-1] < tilt).all()


def test_a_disk_topples_only_when_told_so():
    start = rr.State(tilt=1.2, tilt_rate=10.0, yaw_rate=0.3, spin_rate=0.1)
    assert rr.simulate(DISK, start, rr.NoSlip(), 0.2).tilt.max() > np.pi / 2
    assert rr.simulate(DISK, start, rr.NoSlip(), 0.2, topple_tilt=1.5).status == "toppled"


def test_a_can_flicked_too_fast_lifts_off_before_it_lands():
    start = rr.State(tilt=0.3, tilt_rate=-10.0, yaw_rate=0.005, spin_rate=0.005)
    motion = rr.simulate(CAN, start, rr.NoSlip())
    assert motion.status == "lifted_off" and "lifted off at t = 0.02" in motion.message
    assert motion.events[-1].kind == "lift_off"
    weight = CAN.mass * rr.STANDARD_GRAVITY
    assert abs(motion.normal_force[-1]) < 1e-12 * weight < motion.normal_force[:-1].min()


def test_a_can_released_too_fast_to_stay_on_the_table_has_lifted_off_at_once():
    motion = rr.simulate(CAN, replace(PAPER_START, tilt_rate=-30.0), rr.NoSlip())
    assert (motion.status, len(motion), motion.t[-1]) == ("lifted_off", 1, 0.0)
    assert motion.turns == [] and motion.normal_force[0] < 0.0
    assert len(motion.evaluate(0.0)) == len(motion.samples()) == 1


@by_law
def test_without_any_sideways_motion_the_can_falls_face_down(law):
    motion = rr.simulate(CAN, replace(PAPER_START, yaw_rate=0.0, spin_rate=0.0), law)
    assert motion.status == "face_down" and motion.events[-1].kind == "face_down"
    assert "the whole rim meets the table at once" in motion.message
    assert "without any sideways motion" in motion.message
    beside = replace(PAPER_START, yaw_rate=1e-12 * PAPER_START.tilt_rate, spin_rate=0.0)
    assert rr.simulate(CAN, beside, law).status == "finished"
    assert motion.turns == [] and motion.tilt[-1] <= 1.01e-16
    np.testing.assert_array_equal(motion.yaw, 0.0)


@by_law
def test_what_the_face_down_message_promises_is_true(law):
    motion = rr.simulate(CAN, replace(PAPER_START, yaw_rate=1e-12, spin_rate=0.0), law)
    assert motion.status == "finished" and len(motion.turns) >= 2


def test_a_motion_out_of_steps_has_failed_and_says_where():
    motion = rr.simulate(CAN, PAPER_START, rr.NoSlip(), max_steps=50)
    assert motion.status == "failed" and motion.stats.steps == 50 and len(motion) == 51
    assert motion.message == f"stopped at t = {motion.t[-1]:.6f} s after max_steps = 50 steps"
    # What there is can be used.
    assert motion.evaluate(motion.t[-1]).tilt[0] == pytest.approx(motion.tilt[-1], rel=1e-12)


@pytest.mark.parametrize(
    ("options", "complaint"),
    [
        ({"duration": 0.0}, "duration must be > 0, got 0 s"),
        ({"duration": np.inf}, "duration must be a finite number, got inf"),
        ({"duration": "2"}, "duration must be a single number, got '2'"),
        ({"gravity": -9.8}, "gravity must be > 0, got -9.8 m/s2"),
        ({"rtol": 1e-15}, "rtol must be between 1e-14 and 1e-3"),
        ({"rtol": 0.1}, "rtol must be between 1e-14 and 1e-3, got 0.1"),
        ({"max_steps": 0}, "max_steps must be a whole number >= 1, got 0"),
        ({"topple_tilt": 0.1}, "tilt must be below topple_tilt = 0.1 rad"),
        ({"topple_tilt": 3.0}, "where the centre of mass is over the table, got 3 rad"),
        ({"topple_tilt": [1.0, 2.0]}, "topple_tilt must be a single number"),
    ],
)
def test_options_outside_their_bounds_are_refused_with_a_sentence(options, complaint):
    with pytest.raises(rr.RimrollError) as refusal:
        rr.simulate(CAN, PAPER_START, rr.NoSlip(), **options)
    assert complaint in str(refusal.value)


@pytest.mark.parametrize("tilt", [[0.1, 0.2], [0.1]])
def test_simulate_follows_one_start_and_refuses_arrays(tilt):
    start = replace(PAPER_START, tilt=np.array(tilt))
    with pytest.raises(rr.RimrollError, match="one start, got arrays of shape"):
        rr.simulate(CAN, start, rr.NoSlip())


# Geometry and mechanics


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
    """To the rtol of 1e-10 that is the default."""
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
        assert turn.angle == pytest.approx(other.angle, rel=1e-12)
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


# What a motion is written down with


def test_a_dataset_has_units_and_all_that_was_computed(motion):
    dataset = motion.to_xarray()
    assert set(dataset.variables) == set(rimroll.motion.UNITS)
    for name, variable in dataset.variables.items():
        assert variable.dims == ("t",)
        assert variable.attrs["units"] == rimroll.motion.UNITS[name]
        np.testing.assert_array_equal(variable, motion[name])
    assert dataset.attrs["status"] == "finished"
    assert dataset.attrs["message"] == motion.message
    assert motion.parameters().items() <= dataset.attrs.items()


def test_a_motion_read_from_netcdf_can_be_computed_again_to_the_bit(motion, tmp_path):
    path = tmp_path / "motion.nc"
    motion.to_xarray().to_netcdf(path, engine="scipy")
    with xr.open_dataset(path, engine="scipy") as read:
        xr.testing.assert_identical(read.load(), motion.to_xarray())
        given = {name: read.attrs[name] for name in motion.parameters()}
        duration = float(read.t[-1])

    def part(prefix):
        return {k.removeprefix(prefix): v for k, v in given.items() if k.startswith(prefix)}

    again = rr.simulate(
        rr.Body(**part("body_")),
        rr.State(**part("start_")),
        rimroll.laws.by_name(given["law"]),
        duration,
        gravity=given["gravity"],
        rtol=given["rtol"],
    )
    assert given["rimroll_version"] == rr.__version__
    assert same_bits(again, motion)


def test_parameters_are_plain_numbers_and_texts():
    motion = paper_motion(rr.NoSlip(), topple_tilt=1, gravity=np.float64(9.8))
    given = motion.parameters()
    assert {type(value) for value in given.values()} == {str, float, int}
    assert given["law"] == "no_slip" and given["topple_tilt"] == 1.0 and given["gravity"] == 9.8
    assert given["body_radius"] == CAN.radius and given["start_tilt"] == PAPER_START.tilt
    assert "topple_tilt" not in paper_motion(rr.NoSlip()).parameters()


def test_a_motion_introduces_itself():
    text = repr(paper_motion(rr.NoSlip()))
    assert text == (
        "<Motion no_slip, finished at t = 2 s; turns: [202.6546 deg, 202.6751 deg, 202.6751 deg]>"
    )


def test_gravity_is_standard_unless_given():
    default = rr.simulate(CAN, PAPER_START, rr.NoSlip())
    assert default.gravity == rr.STANDARD_GRAVITY == 9.80665
    assert same_bits(default, rr.simulate(CAN, PAPER_START, rr.NoSlip(), gravity=9.80665))


# The same bits


@by_law
def test_a_motion_computed_twice_has_the_same_bits(law):
    assert same_bits(paper_motion(law), paper_motion(law))


SAME_MOTION = """
import hashlib, sys
import numpy as np, rimroll as rr
from rimroll import laws, motion
start = rr.State(tilt=np.pi / 6, tilt_rate=-0.5, yaw_rate=0.005, spin_rate=0.005)
again = rr.simulate(rr.bodies.can_2007(), start, laws.by_name(sys.argv[1]), gravity=9.8)
print(hashlib.sha256(b"".join(again[name].tobytes() for name in motion.UNITS)).hexdigest())
"""


@by_law
def test_another_process_computes_the_same_bits(law):
    run = subprocess.run(
        [sys.executable, "-c", SAME_MOTION, law.name], capture_output=True, text=True
    )
    assert run.stdout.strip() == bits(paper_motion(law)), run.stderr


ENDLESS = """
import rimroll as rr
start = rr.State(tilt=0.5, tilt_rate=-0.5, yaw_rate=0.005, spin_rate=0.005)
print("rolling", flush=True)
try:
    motion = rr.simulate(rr.bodies.can_2007(), start, rr.NoSlip(), 1e7, max_steps=2_000_000)
    print(motion)
except KeyboardInterrupt:
    print("interrupted")
"""


@pytest.mark.skipif(sys.platform == "win32", reason="no SIGINT for another process there")
def test_control_c_stops_a_long_motion_within_a_second():
    command = [sys.executable, "-c", ENDLESS]
    with subprocess.Popen(
        command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
    ) as run:
        try:
            assert run.stdout.readline() == "rolling\n"
            time.sleep(0.3)
            run.send_signal(signal.SIGINT)
            asked = time.monotonic()
            out, err = run.communicate(timeout=20)
            assert time.monotonic() - asked < 1.0
        finally:
            run.kill()
    assert (out, err) == ("interrupted\n", "")


# Bodies


def test_a_body_is_a_value():
    other = rr.Body(*asdict(CAN).values())
    assert other == CAN and hash(other) == hash(CAN) and {CAN: 1}[other] == 1
    assert replace(CAN, height=0.07) != CAN
    assert pickle.loads(pickle.dumps(CAN)) == CAN
    assert eval(repr(CAN), {"Body": rr.Body}) == CAN
    with pytest.raises(FrozenInstanceError):
        CAN.mass = 1.0


@pytest.mark.parametrize(
    ("changed", "complaint"),
    [
        ({"mass": 0.0}, "mass must be > 0, got 0 kg"),
        ({"radius": -1.0}, "radius must be > 0, got -1 m"),
        ({"height": -0.1}, "height must be >= 0, got -0.1 m"),
        ({"transverse_inertia": 0.0}, "transverse_inertia must be > 0, got 0 kg m2"),
        ({"axial_inertia": np.nan}, "axial_inertia must be a finite number, got NaN"),
        ({"axial_inertia": 1.0}, "no rigid body has more), got 1 kg m2"),
        ({"mass": "heavy"}, "mass must be a single number, got 'heavy'"),
        ({"mass": [1.0, 2.0]}, "mass must be a single number, got [1.0, 2.0]"),
    ],
)
def test_what_is_no_body_is_refused_with_a_sentence(changed, complaint):
    with pytest.raises(rr.RimrollError) as refusal:
        replace(CAN, **changed)
    assert complaint in str(refusal.value)


def test_a_body_takes_numbers_of_any_kind():
    body = rr.Body(1, np.float32(0.5), 0, np.float64(0.2), np.array(0.25))
    assert [type(value) for value in asdict(body).values()] == [float] * 5


def summed(parts, rim):
    """The body of rings of matter: each part fills radii a..b and heights p..q with a density.

    Parts are (density, a, b, p, q) in kg/m3 and m; 300 x 300 rings each, so 1e-5 from exact.
    """
    rings = []
    for density, a, b, p, q in parts:
        n = 300
        r = a + (b - a) * (np.arange(n) + 0.5) / n
        z = p + (q - p) * (np.arange(n) + 0.5) / n
        r, z = np.meshgrid(r, z)
        rings.append((density * 2 * np.pi * r * (b - a) * (q - p) / n**2, r, z))
    dm, r, z = (np.concatenate([part[i].ravel() for part in rings]) for i in range(3))
    mass = dm.sum()
    height = (dm * z).sum() / mass
    axial = (dm * r**2).sum()
    return rr.Body(mass, rim, height, axial / 2 + (dm * (z - height) ** 2).sum(), axial)


def assert_same_body(body, other, rtol):
    np.testing.assert_allclose(list(asdict(body).values()), list(asdict(other).values()), rtol)


def solid_part(mass, radius, length):
    return (mass / (np.pi * radius**2 * length), 0.0, radius, 0.0, length)


def test_the_can_of_the_paper_has_the_paper_s_numbers():
    """Section "Quantitative comparisons"; C is estimated."""
    assert (CAN.mass, CAN.radius, CAN.height) == (0.070, 0.051, 0.069)
    assert CAN.transverse_inertia / CAN.mass == pytest.approx(5.13e-3, rel=1e-15)
    assert CAN.axial_inertia / CAN.mass == pytest.approx(2.0e-3, rel=1e-15)


@pytest.mark.parametrize("fill", [0.0, 0.4, 1.0])
def test_a_soda_can_weighs_and_turns_as_its_nominal_sizes_say(fill):
    """The preset takes the sheets as infinitely thin: 0.3 mm of 33 mm, squared."""
    aluminium, mm = 2700.0, 1e-3
    parts = [
        (aluminium, 32.95 * mm, 33.05 * mm, 0.0, 115 * mm),
        (aluminium, 0.0, 33 * mm, 4.85 * mm, 5.15 * mm),
        (aluminium, 0.0, 26 * mm, 114.875 * mm, 115.125 * mm),
    ]
    if fill:
        parts.append((1000.0, 0.0, 33 * mm, 5 * mm, (5 + 97 * fill) * mm))
    assert_same_body(rr.bodies.soda_can(fill), summed(parts, 24 * mm), 1e-4)


@pytest.mark.parametrize("fill", [0.0, 0.4, 1.0])
def test_a_beer_bottle_weighs_and_turns_as_its_nominal_sizes_say(fill):
    """The preset takes the glass as infinitely thin: in the neck 2.8 mm of 13.6 mm, squared/4."""
    glass, mm = 2500.0, 1e-3
    parts = [
        (glass, 28.3 * mm, 30.5 * mm, 0.0, 130 * mm),
        (glass, 12.2 * mm, 15.0 * mm, 130 * mm, 230 * mm),
        (glass, 0.0, 28.3 * mm, 0.0, 6 * mm),
    ]
    if fill:
        parts.append((1000.0, 0.0, 28.3 * mm, 6 * mm, (6 + 124 * fill) * mm))
    assert_same_body(rr.bodies.beer_bottle(fill), summed(parts, 26 * mm), 2e-3)


@pytest.mark.parametrize(
    ("body", "part"),
    [
        # European Central Bank; IEC 60086-2; the toy; water.
        (rr.bodies.coin(), solid_part(7.5e-3, 11.625e-3, 2.33e-3)),
        (rr.bodies.battery(), solid_part(23e-3, 7.25e-3, 50.5e-3)),
        (rr.bodies.euler_disk(), (7850.0, 0.0, 37.5e-3, 0.0, 12.7e-3)),
        (rr.bodies.cylinder(0.05, 0.2), (1000.0, 0.0, 0.05, 0.0, 0.2)),
    ],
    ids=["coin", "battery", "euler_disk", "cylinder"],
)
def test_solid_cylinders_weigh_and_turn_as_their_sizes_say(body, part):
    assert_same_body(body, summed([part], part[2]), 2e-5)
    assert body.height == pytest.approx(part[4] / 2)


def test_a_toy_euler_disk_weighs_440_g():
    assert rr.bodies.euler_disk().mass == pytest.approx(0.440, abs=1e-3)


def test_ideal_disk_and_ring_are_flat_with_the_textbook_moments():
    """k^2 = 1/2 and k = 1; C = 2A for whatever is flat."""
    for body, k_squared in (rr.bodies.disk(0.3), 0.5), (rr.bodies.ring(0.3), 1.0):
        assert (body.mass, body.radius, body.height) == (1.0, 0.3, 0.0)
        assert body.axial_inertia == pytest.approx(k_squared * 0.3**2, rel=1e-15)
        assert body.axial_inertia == pytest.approx(2 * body.transverse_inertia, rel=1e-15)


def test_presets_are_found_by_name():
    for name, preset in rr.bodies.PRESETS.items():
        assert rr.bodies.by_name(name) == rr.bodies.by_name(name.replace("_", "-")) == preset()
    with pytest.raises(rr.RimrollError, match="unknown body 'keg'"):
        rr.bodies.by_name("keg")
    with pytest.raises(rr.RimrollError, match=r"fill must be between 0 and 1, got 1\.5"):
        rr.bodies.soda_can(1.5)


@few
@given(solid=upright_solids(0.1))
def test_composing_one_solid_keeps_its_numbers(solid):
    body = rr.Body.from_solids(0.1, [solid])
    assert (body.mass, body.height) == (solid.mass, pytest.approx(solid.height, rel=1e-15))
    assert body.transverse_inertia == pytest.approx(solid.transverse_inertia, rel=1e-14)
    assert body.axial_inertia == pytest.approx(solid.axial_inertia, rel=1e-14)


@few
@given(solids=st.lists(upright_solids(0.1), min_size=2, max_size=5))
def test_composing_follows_the_parallel_axis_theorem(solids):
    body = rr.Body.from_solids(0.1, solids)
    mass = sum(s.mass for s in solids)
    height = sum(s.mass * s.height for s in solids) / mass
    transverse = sum(s.transverse_inertia + s.mass * (s.height - height) ** 2 for s in solids)
    axial = sum(s.axial_inertia for s in solids)
    assert_same_body(body, rr.Body(mass, 0.1, height, transverse, axial), 1e-12)


@pytest.mark.parametrize(
    ("solid", "part"),
    [
        (rr.solids.cylinder(1.0, 0.1, 0.3, 0.2), (1 / (np.pi * 0.003), 0.0, 0.1, 0.2, 0.5)),
        (
            rr.solids.hollow_cylinder(1.0, 0.06, 0.1, 0.3),
            (1 / (np.pi * 0.3 * 0.0064), 0.06, 0.1, 0.0, 0.3),
        ),
        (rr.solids.filling(800.0, 0.1, 0.3, 0.2), (800.0, 0.0, 0.1, 0.2, 0.5)),
        # Thin things as things of 1e-6 m.
        (rr.solids.disc(1.0, 0.1, 0.2), (1 / (np.pi * 1e-8), 0.0, 0.1, 0.2, 0.200001)),
        (rr.solids.wall(1.0, 0.1, 0.3, 0.2), (1 / (np.pi * 0.06e-6), 0.1, 0.100001, 0.2, 0.5)),
        (
            rr.solids.ring(1.0, 0.1, 0.2),
            (1 / (np.pi * 0.2e-12), 0.1, 0.100001, 0.2, 0.200001),
        ),
    ],
    ids=["cylinder", "hollow_cylinder", "filling", "disc", "wall", "ring"],
)
def test_solids_have_the_moments_of_the_rings_they_are_made_of(solid, part):
    assert_same_body(rr.Body.from_solids(0.1, [solid]), summed([part], 0.1), 5e-5)


@pytest.mark.parametrize(
    ("make", "complaint"),
    [
        (lambda: rr.solids.disc(-1.0, 0.1), "mass must be > 0, got -1 kg"),
        (lambda: rr.solids.ring(1.0, 0.0), "radius must be > 0, got 0 m"),
        (lambda: rr.solids.wall(1.0, 0.1, -0.1), "length must be >= 0, got -0.1 m"),
        (lambda: rr.solids.hollow_cylinder(1, 2, 1, 1), "at most outer_radius = 1 m, got 2 m"),
        (lambda: rr.solids.filling(0.0, 1, 1), "density must be > 0, got 0 kg/m3"),
        (lambda: rr.Body.from_solids(0.1, []), "solids must name at least one solid, got none"),
        (
            lambda: rr.Body.from_solids(0.1, [rr.solids.disc(1.0, 0.1, -0.2)]),
            "height must be >= 0, got -0.2 m",
        ),
    ],
)
def test_what_is_no_solid_is_refused_with_a_sentence(make, complaint):
    with pytest.raises(rr.RimrollError) as refusal:
        make()
    assert complaint in str(refusal.value)


# States


def test_fields_of_a_state_may_be_arrays_of_one_shape():
    state = rr.State(tilt=np.full((2, 3), 0.5), yaw_rate=[[1, 2, 3], [4, 5, 6]], spin=1)
    assert state.shape == (2, 3)
    assert state.yaw_rate.dtype == np.float64 and state.spin == 1.0
    assert rr.State(tilt=0.5).shape == () and isinstance(rr.State(tilt=1).tilt, float)
    assert rr.State(tilt=np.array(0.5)).shape == ()


@pytest.mark.parametrize(
    ("fields", "complaint"),
    [
        ({"tilt": 0.0}, "tilt must be inside (0, pi), got 0.0 rad"),
        ({"tilt": [0.5, 3.2]}, "tilt must be inside (0, pi), got 3.2 rad"),
        ({"tilt": 0.5, "yaw": np.nan}, "yaw must be finite, got nan"),
        ({"tilt": 0.5, "spin_rate": [0.0, -np.inf]}, "spin_rate must be finite, got -inf"),
        ({"tilt": "steep"}, "tilt must be a number or an array of numbers, got 'steep'"),
        ({"tilt": [0.1, 0.2], "yaw": [1, 2, 3]}, "must agree in shape, got tilt (2,), yaw (3,)"),
    ],
)
def test_what_is_no_state_is_refused_with_a_sentence(fields, complaint):
    with pytest.raises(rr.RimrollError) as refusal:
        rr.State(**fields)
    assert complaint in str(refusal.value)


def test_a_state_takes_names_only_and_stays_as_it_is():
    with pytest.raises(TypeError):
        rr.State(0.5)
    with pytest.raises(FrozenInstanceError):
        PAPER_START.tilt = 1.0


# Laws


def test_laws_are_values_that_are_found_by_name():
    assert rr.NoSlip() == rr.NoSlip() != rr.Frictionless()
    assert rimroll.laws.by_name("no-slip") == rr.NoSlip()
    with pytest.raises(rr.RimrollError, match="unknown law 'glue': choose from no-slip"):
        rimroll.laws.by_name("glue")


# Closed forms


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
    assert rr.turn_limit(body, law) == pytest.approx(np.pi * np.sqrt(J / K), rel=1e-14)


@few
@given(disk=disks())
def test_turn_of_a_disk_is_the_same_with_and_without_friction(disk):
    """The paper's k belongs to a flat body, C = 2A; free numbers with H = 0 have A alone."""
    no_slip, frictionless = (rr.turn_limit(disk, law) for law in LAWS)
    assert no_slip == pytest.approx(frictionless, rel=1e-14)
    k = np.sqrt(2 * disk.transverse_inertia / (disk.mass * disk.radius**2))
    assert rr.disk_turn_limit(k) == pytest.approx(no_slip, rel=1e-14)


def test_turn_of_a_uniform_disk_is_pi_sqrt_5_and_of_a_ring_pi_sqrt_3():
    for law in LAWS:
        assert rr.turn_limit(DISK, law) == pytest.approx(np.pi * np.sqrt(5), rel=1e-15)
        assert rr.turn_limit(rr.bodies.ring(), law) == pytest.approx(np.pi * np.sqrt(3), rel=1e-15)
    assert rr.disk_turn_limit(1e-9) > 1e9


@few
@given(body=bodies(), spin=st.floats(-30.0, 30.0), rate=st.floats(0.1, 20.0))
def test_turn_with_spin_has_an_arctangent_more(body, spin, rate):
    J, K = inertias(body, rr.NoSlip())
    lead = body.mass * body.height * body.radius * spin / (rate * np.sqrt(J * K))
    expected = np.sqrt(J / K) * (np.pi + 2 * np.arctan(lead))
    assert rr.turn_limit_with_spin(body, spin, rate) == pytest.approx(expected, rel=1e-13)
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
    assert tall == pytest.approx(np.pi + np.pi / 2 * (J / K - 1), rel=1e-14)
    assert -1e-14 * exact <= tall - exact <= np.pi / 8 * (J / K - 1) ** 2 + 1e-14 * exact


def test_point_mass_limit_is_approached_as_the_moments_vanish():
    point = rr.Body(1.0, 0.1, 0.2, 1e-12, 1e-12)
    limit = rr.point_mass_turn_limit(0.1, 0.2, rr.NoSlip())
    assert limit == pytest.approx(np.pi * np.sqrt(1.25), rel=1e-15)
    assert rr.turn_limit(point, rr.NoSlip()) == pytest.approx(limit, rel=1e-10)
    assert rr.point_mass_turn_limit(0.1, 0.2, rr.Frictionless()) == np.inf
    assert rr.turn_limit(point, rr.Frictionless()) > 1e5


@few
@given(body=bodies())
def test_needed_friction_is_mhr_over_k(body):
    _, K = inertias(body, rr.NoSlip())
    expected = body.mass * body.height * body.radius / K
    assert rr.needed_friction(body) == pytest.approx(expected, rel=1e-14)


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
        rate = rr.pasted(CAN, PAPER_START, law, 9.8).tipping_rate
        assert rr.error_law_coefficient(CAN, law, rate, 9.8) == pytest.approx(expected, abs=5e-5)


@by_law
@few
@given(body=bodies(), part=st.floats(0.1, 0.9))
def test_a_steady_wobble_keeps_its_tilt_with_the_center_at_rest_and_no_friction(law, body, part):
    tilt = part * rr.balance_tilt(body)
    # A body of large C and H has none.
    A, C = body.transverse_inertia, body.axial_inertia
    if A * body.radius * np.cos(tilt) - C * body.height * np.sin(tilt) <= 0.1 * A * body.radius:
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


def test_there_is_no_steady_wobble_beyond_the_balance_tilt():
    with pytest.raises(rr.RimrollError, match=r"tilt must be inside \(0, balance_tilt = 0.6365"):
        rr.steady_wobble_rate(CAN, 0.7)


@few
@given(body=bodies())
def test_balance_tilt_has_the_center_over_the_rim(body):
    tilt = rr.balance_tilt(body)
    assert tilt == pytest.approx(np.arctan2(body.radius, body.height), rel=1e-15)
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
    assert rr.lift_off_rate(body, gravity) == pytest.approx(lift_off, rel=1e-13)
    assert rr.slip_rate(body, gravity) == pytest.approx(slip, rel=1e-13)


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


# Documentation


@pytest.mark.parametrize("module", [rr, rimroll.body], ids=lambda module: module.__name__)
def test_examples_in_the_docstrings_are_true(module):
    results = doctest.testmod(module)
    assert results.attempted > 0 and results.failed == 0


def test_everything_public_is_documented():
    for name in rr.__all__:
        if not name.startswith("__") and name not in ("STANDARD_GRAVITY", "Law"):
            assert getattr(rr, name).__doc__, name
