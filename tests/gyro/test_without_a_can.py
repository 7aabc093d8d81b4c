"""A record without a can in it is refused, whatever the axis."""

import math
import os
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import rimroll as rr
from given.without_a_can import KINDS, without_a_can
from rimroll.scenario import load

BODIES = (
    load(Path(__file__).parents[2] / "examples/can_with_phone.toml").body,
    rr.bodies.can_2007(),
    rr.Body(0.105, 0.0223, 0.01705, 3.503e-5, 2.405e-5),
)


def accepted(seed, axes=("auto", "x", "y", "z")):
    """The axes along which a record without a can is read."""
    found = []
    for axis in axes:
        try:
            rr.gyro.analyze(without_a_can(seed), BODIES[seed // len(KINDS) % 3], axis=axis)
        except rr.RimrollError:
            continue
        found.append(axis)
    return found


FEW = [0, 7, 14, 21]
"""Records of several kinds; each takes seconds, so the others are in `make soak`."""


@pytest.mark.slow
@pytest.mark.parametrize("seed", FEW)
def test_records_without_a_can_are_refused(seed):
    assert accepted(seed) == []


@pytest.mark.soak
@pytest.mark.parametrize("seed", sorted(set(range(30)) - set(FEW)))
def test_no_record_without_a_can_is_read(seed):
    assert accepted(seed) == []


@pytest.mark.soak
def test_new_records_without_a_can_are_refused():
    """One in a hundred may be read: chance makes motions of any kind."""
    first = int.from_bytes(os.urandom(4), "little")
    seeds = range(first, first + 60)
    wrong = [seed for seed in seeds if accepted(seed, ("auto",))]
    assert len(wrong) <= 2, wrong


def test_a_hand_that_turns_a_phone_about_one_axis_is_refused():
    """Its peaks are as steep as those of a fall, but tilt and rate do not go together."""
    t = np.arange(0.0, 6.0, 0.01)
    noise = 1e-3 * np.random.default_rng(0).standard_normal((len(t), 3))
    for width in (0.15, 0.2, 0.25):
        rates = noise + np.outer(4.0 * np.exp(-(((t - 3.0) / width) ** 2)), [1.0, 0.2, 0.1])
        for axis in "yz":
            with pytest.raises(rr.RimrollError):
                rr.gyro.analyze(rr.gyro.Record(t, rates), BODIES[0], axis=axis)


def test_an_axis_far_askew_is_found_on_a_body_that_rolls():
    """What is left of the momentum has other minima, in which a search from the middle ends."""
    body = BODIES[2]
    start = rr.State(tilt=0.7468, yaw_rate=0.181, spin_rate=-0.098)
    motion = rr.simulate(body, start, rr.NoSlip(), duration=1.0)
    sensor = replace(rr.gyro.phone(400.0), misalignment=math.radians(5.0))
    for seed in range(4):
        found = rr.gyro.analyze(sensor.record(motion, seed=seed), body, axis="z")
        for one, turn in zip(found.collisions, motion.turns, strict=False):
            assert one.veer + math.pi == pytest.approx(abs(turn.angle), abs=math.radians(1.5))
        assert not found.friction.excludes_rolling


def test_the_friction_follows_the_veer_without_steps():
    from rimroll.sensors.fits import chi_square
    from rimroll.sensors.gyro.friction import friction_from

    motion = rr.simulate(BODIES[1], rr.State(tilt=0.5, yaw_rate=0.1), rr.Coulomb(0.2), duration=0.8)
    found = rr.gyro.analyze(rr.gyro.phone(200.0).record(motion, seed=1), BODIES[1], axis="z")
    one, there = found.collisions[0], found.predictions[0]
    shifts = np.radians(np.linspace(0.0, 0.5, 26))
    read = [
        friction_from([replace(one, veer=one.veer + shift)], [there], chi_square(0.95))
        for shift in shifts
    ]
    for values in (
        [each.best for each in read],
        [each.interval[0] for each in read],
        [each.interval[1] for each in read],
    ):
        steps = -np.diff(values)
        assert (steps > 0.0).all()
        assert steps.max() < 2.0 * steps.min()
