"""A strong filter of the sensor is recognised by the jumps of the rate, taken out, and said."""

import math
from dataclasses import replace

import numpy as np
import pytest
from scipy import signal

import rimroll as rr
from given.gyroscopes import RELEASE
from rimroll.sensors.gyro.peaks import Filter, filter_of

CAN = rr.bodies.can_2007()
START = rr.State(tilt=0.5, yaw_rate=0.2)
FRICTION = 0.15


def phone(cutoff, sampling_rate=200.0):
    return replace(rr.gyro.phone(sampling_rate), bandwidth=cutoff)


@pytest.fixture(scope="module")
def motion():
    return rr.simulate(CAN, START, rr.Coulomb(FRICTION), duration=0.9)


def cutoff_of(record):
    still = record.rates[:100]
    found = filter_of(record.t, record.rates - still.mean(axis=0), float(still.std()))
    return None if found is None else found.cutoff


def test_the_recursion_undoes_the_filter_of_scipy():
    """Two straight lines with a jump between two samples, through SciPy's Butterworth filter."""
    cutoff, rate, jump_at = 20.0, 200.0, 0.1507
    fine = np.arange(0.0, 0.3, 1e-5)
    lines = np.where(fine < jump_at, 1.0 + 20.0 * fine, -3.0 - 5.0 * fine)
    system = signal.butter(2, 2.0 * np.pi * cutoff, analog=True)
    _, shown, _ = signal.lsim(system, lines, fine)
    every = slice(0, None, round(1e5 / rate))
    rates = np.stack([shown[every]] * 3, axis=-1)
    t, undone = Filter(1.0 / (math.sqrt(2.0) * np.pi * cutoff)).undone(fine[every], rates)
    true = t - math.sqrt(2.0) / (2.0 * np.pi * cutoff)  # the mean delay of the filter remains
    before = (true > 0.06) & (true < jump_at - 2.0 / rate)
    after = true > jump_at + 2.0 / rate
    assert undone[before, 0] == pytest.approx(1.0 + 20.0 * true[before], abs=0.01)
    assert undone[after, 0] == pytest.approx(-3.0 - 5.0 * true[after], abs=0.01)
    assert np.abs(shown[every][2:][after] + 3.0 + 5.0 * true[after]).max() > 0.5


@pytest.mark.parametrize(("cutoff", "rate"), [(20.0, 100.0), (20.0, 200.0), (40.0, 400.0)])
def test_its_cut_off_frequency_is_found(motion, cutoff, rate):
    assert cutoff_of(phone(cutoff, rate).record(motion, seed=1)) == pytest.approx(cutoff, rel=0.1)


@pytest.mark.parametrize("rate", [100.0, 200.0, 400.0])
def test_a_usual_sensor_shows_none(motion, rate):
    record = rr.gyro.phone(rate).record(motion, seed=1)
    assert cutoff_of(record) is None
    found = rr.gyro.analyze(record, CAN)
    assert found.filter_cutoff is None
    assert not any("low-pass" in note for note in found.notes)


@pytest.mark.parametrize("yaw_rate", [0.8, 2.0])
def test_a_passage_that_is_not_near_upright_shows_none(yaw_rate):
    motion = rr.simulate(CAN, replace(START, yaw_rate=yaw_rate), rr.NoSlip(), duration=0.9)
    assert cutoff_of(rr.gyro.phone(200.0).record(motion, seed=1)) is None


def test_after_a_filter_at_20_hz_the_veer_and_the_friction_come_back(motion):
    for seed in range(4):
        found = rr.gyro.analyze(phone(20.0).record(motion, seed=seed), CAN, axis="z")
        one = found.collisions[0]
        turn = min(motion.turns, key=lambda turn: abs(turn.t + RELEASE - one.time))
        assert abs(one.veer - (abs(turn.angle) - math.pi)) < min(
            2.0 * one.veer_error, math.radians(5.0)
        )
        low, high = found.friction.interval
        assert low < FRICTION < (high or math.inf)
        assert found.filter_cutoff == pytest.approx(20.0, rel=0.1)
        assert found.to_dict()["filter_cutoff"] == found.filter_cutoff
        assert "low-pass filter of second order" in found.notes[0]


def test_a_filter_that_is_too_steep_is_refused(motion):
    record = rr.gyro.phone(200.0).record(motion, seed=1)
    system = signal.butter(6, 20.0, fs=200.0, output="sos")
    still = record.rates[:100].mean(axis=0)
    shown = signal.sosfilt(system, record.rates - still, axis=0) + still
    with pytest.raises(rr.RimrollError, match=r"too steep to be taken out.*widest band"):
        rr.gyro.analyze(replace(record, rates=shown), CAN)
