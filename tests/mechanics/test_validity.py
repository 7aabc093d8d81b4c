"""The numbers of ``motion.validity`` against those of the motion itself."""

import numpy as np
import pytest

import rimroll as rr

CAN = rr.bodies.can_2007()


@pytest.mark.parametrize("law", [rr.NoSlip(), rr.Frictionless(), rr.Coulomb(0.15)])
def test_the_numbers_are_those_of_the_motion(law):
    start = rr.State(tilt=0.4, tilt_rate=-0.5, yaw_rate=0.1)
    motion = rr.simulate(CAN, start, law, duration=1.0)
    assert len(motion.validity) == len(motion.turns) > 0
    for turn, validity in zip(motion.turns, motion.validity, strict=True):
        moments = motion.evaluate(np.linspace(turn.start, turn.end, 200_001))
        low = motion.evaluate(turn.t)
        assert validity.gap == pytest.approx(2.0 * CAN.radius * np.sin(turn.min_tilt), rel=1e-12)
        assert validity.contact_speed == pytest.approx(CAN.radius * abs(low.spin_rate[0]), rel=1e-9)
        turned = (moments.yaw - moments.yaw[0]) / turn.angle
        fast = moments.t[(turned > 0.1) & (turned < 0.9)]
        step = moments.t[1] - moments.t[0]
        assert validity.passage_time == pytest.approx(np.ptp(fast), abs=2.1 * step)
        # The largest force and energy can lie between two of the core's samples.
        weights = moments.normal_force.max() / (CAN.mass * motion.gravity)
        assert validity.force_ratio == pytest.approx(weights, rel=0.02)
        lost = moments.energy[0] - moments.energy[-1]
        assert validity.loss_ratio == pytest.approx(
            lost / moments.kinetic_energy.max(), rel=1e-3, abs=1e-7
        )
        assert validity.sound_time == pytest.approx(2.0 * CAN.radius / 5000.0)


def test_it_says_what_is_beyond_the_model():
    start = rr.State(tilt=0.5, yaw_rate=1e-4)
    (validity, *_) = rr.simulate(CAN, start, rr.NoSlip()).validity
    assert str(validity).count("beyond the model") == 4
    gentle = rr.simulate(CAN, rr.State(tilt=0.3, yaw_rate=0.5), rr.Coulomb(0.3)).validity[0]
    assert not gentle.is_uneven
    assert not gentle.is_faster_than_sound
    assert not gentle.is_flexible
    assert "within the model" in str(gentle)


def test_a_gap_below_the_flatness_of_faces_is_beyond_the_model():
    """A face 30 to 100 mm across is flat to 0.1 to 0.4 mm by ISO 2768-2, H to L."""
    for sideways in 0.01, 0.05, 0.1, 0.3:
        turn = rr.simulate(CAN, rr.State(tilt=0.5, yaw_rate=sideways), rr.NoSlip()).validity[0]
        assert turn.is_uneven == (turn.gap < 4e-4)


def test_a_motion_without_turns_has_none():
    assert rr.simulate(CAN, rr.State(tilt=1.2), rr.NoSlip()).validity == []
