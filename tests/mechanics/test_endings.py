"""How motions end, and which starts and options are refused."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import rimroll as rr
from given.motions import CAN, DISK, PAPER_START, by_law
from given.strategies import bodies, examples


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


def test_a_disk_topples_only_at_a_given_tilt():
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
    why = "after 50 steps, the limit max_steps"
    assert motion.message == f"stopped at t = {motion.t[-1]:.6f} s {why}"
    # The part before can be used.
    assert motion.evaluate(motion.t[-1]).tilt[0] == pytest.approx(
        motion.tilt[-1], rel=1e-12, abs=0.0
    )


@pytest.mark.parametrize(
    ("options", "complaint"),
    [
        ({"duration": 0.0}, "duration must be > 0, got 0 s"),
        ({"duration": np.inf}, "duration must be a finite number, got inf"),
        ({"duration": "2 m"}, "duration must be a time such as"),
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


@examples(40)
@given(body=bodies(), part=st.floats(1e-3, 0.95), yaw=st.floats(-3.0, 3.0))
def test_a_knock_tilts_a_body_as_far_as_its_energy_goes(body, part, yaw):
    m, R, H, g = body.mass, body.radius, body.height, rr.STANDARD_GRAVITY
    inertia = body.transverse_inertia + m * (R**2 + H**2)
    rise = part * (np.hypot(R, H) - H)
    knocked = rr.State.standing(tilt_rate=np.sqrt(2.0 * m * g * rise / inertia), yaw=yaw)
    motion = rr.simulate(body, knocked, rr.NoSlip(), 20.0 * np.sqrt(R / g))
    if motion.status == "lifted_off":
        # A hard knock pulls a flat body off the table.
        assert motion.normal_force[-1] == pytest.approx(0.0, abs=1e-6 * m * g)
        return
    assert motion.status == "face_down" and motion.overturned is False
    top = motion.max_tilt
    assert R * np.sin(top) + H * np.cos(top) - H == pytest.approx(rise, rel=1e-8)
    np.testing.assert_array_equal(motion.yaw, yaw)


def test_a_knock_lifts():
    assert rr.State.standing(tilt_rate="3 rad/s").is_knocked
    with pytest.raises(rr.RimrollError, match="tilt_rate must be > 0 and finite, got -3"):
        rr.State.standing(tilt_rate=-3.0)
    with pytest.raises(rr.RimrollError, match=r"State.standing\(tilt_rate="):
        rr.State(tilt=0.0, tilt_rate=3.0)
