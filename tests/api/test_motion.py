"""The arrays of a motion, its dense output, and its files."""

from dataclasses import asdict

import numpy as np
import pytest
import xarray as xr

import rimroll as rr
import rimroll.laws
import rimroll.motion
from given.ctrl_c import needs_signals, processor_time_after_ctrl_c
from given.motions import CAN, LAWS, PAPER_START, paper_motion, same_bits


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
    """As accurately as a floating-point time allows: in the near-collision the yaw rate is 1e5
    rad/s."""
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
    # One time gives one state, from which a motion can start.
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
        rr.RimrollError, match=r"t(\[1\])? must be inside the motion, 0 to 2 s \(finished\)"
    ):
        motion.evaluate(outside)
    with pytest.raises(rr.RimrollError, match="must be inside the motion"):
        motion(outside)


def test_the_time_of_many_that_is_outside_is_named(motion):
    with pytest.raises(rr.RimrollError, match=r"^t\[2\] must be inside .*, got 2.5 s$"):
        motion([0.5, 1.0, 2.5, 3.0])
    with pytest.raises(rr.RimrollError, match=r"^t must be inside .*, got 2.5 s$"):
        motion(2.5)


@pytest.mark.parametrize("law", [*LAWS, rr.Coulomb(0.2)], ids=lambda law: law.name)
def test_poses_are_the_first_rows_of_all_that_is_known_at_the_steps(law):
    core = paper_motion(law)._core
    poses, nodes = core.poses(), core.nodes()
    assert 0 < len(poses) < len(nodes)
    assert poses.tobytes() == nodes[: len(poses)].tobytes()


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


ENDLESS = """
import time
from given import ctrl_c
import rimroll as rr

start = rr.State(tilt=0.5, tilt_rate=-0.5, yaw_rate=0.005, spin_rate=0.005)
with ctrl_c.timed() as ready:

    def progress(t):
        ready()
        time.sleep(0.01)  # so that memory does not run out, however late the signal comes

    rr.simulate(
        rr.bodies.can_2007(), start, rr.NoSlip(), 1e7, max_steps=2_000_000, progress=progress
    )
"""


@needs_signals
def test_ctrl_c_stops_a_long_motion_at_once():
    assert processor_time_after_ctrl_c(ENDLESS) < 0.3
