"""Turns and friction come back from simulated records, as often as their errors say."""

import math
from dataclasses import replace

import numpy as np
import pytest

import rimroll as rr
from given.gyroscopes import RELEASE, rocked
from rimroll.sensors.gyro.friction import friction_from

CAN = rr.bodies.can_2007()
START = rr.State(tilt=0.5, tilt_rate=-0.3, yaw_rate=0.2, spin_rate=0.1)


def motion_under(law, start=START, duration=1.2):
    return rr.simulate(CAN, start, law, duration=duration)


def true_turn(motion, collision):
    return min(motion.turns, key=lambda turn: abs(turn.t + RELEASE - collision.time)).angle


@pytest.fixture(scope="module")
def slipping():
    """The paper's can under friction 0.15, in a record of 200 samples a second."""
    motion = motion_under(rr.Coulomb(0.15))
    return motion, rr.gyro.phone(200.0).record(motion, seed=3)


@pytest.mark.parametrize("law", [rr.NoSlip(), rr.Coulomb(0.2), rr.Frictionless()])
def test_without_noise_the_turns_are_those_of_the_motion(law):
    motion = motion_under(law)
    record = rr.gyro.Sensor(sampling_rate=1000.0, noise_density=1e-6).record(motion)
    found = rr.gyro.analyze(record, CAN)
    first = found.collisions[0]
    assert first.released
    assert first.turn == pytest.approx(true_turn(motion, first), abs=math.radians(0.1))
    assert first.time == pytest.approx(motion.turns[0].t + RELEASE, abs=1e-3)
    assert first.tilt_before == pytest.approx(START.tilt, abs=0.02)
    assert first.tilt_after == pytest.approx(motion.turns[0].max_tilt, abs=0.02)
    before, after = (motion.evaluate(motion.turns[0].t + lag) for lag in (-0.003, 0.003))
    assert first.spin_before == pytest.approx(float(before.axial_spin[0]), abs=0.1)
    assert first.spin_after == pytest.approx(float(after.axial_spin[0]), abs=0.1)
    for rate, there in ((first.rate_before, before), (first.rate_after, after)):
        across = np.hypot(*there.body_angular_velocity[0, :2])
        assert rate == pytest.approx(across, rel=0.03)  # gravity adds 1 %
    momentum = float(before.yaw_rate[0] * np.sin(before.tilt[0]) ** 2)
    assert first.miss == pytest.approx(abs(momentum) / first.rate_before, rel=0.4)


@pytest.mark.parametrize(
    ("law", "tilt_rate"),
    [(rr.NoSlip(), 0.0), (rr.NoSlip(), -0.5), (rr.NoSlip(), -1.0), (rr.Frictionless(), 0.0)],
)
def test_ideal_laws_keep_the_energy(law, tilt_rate):
    motion = motion_under(law, rr.State(tilt=0.4, tilt_rate=tilt_rate, yaw_rate=0.1), 0.8)
    record = rr.gyro.Sensor(sampling_rate=1000.0, noise_density=1e-6).record(motion)
    for one in rr.gyro.analyze(record, CAN).collisions:
        assert one.energy_kept == pytest.approx(1.0, abs=0.01)


def test_after_a_hard_flick_the_energy_is_not_stated():
    """The rim may have slid as the hand let go: the energy of translation is not known."""
    motion = motion_under(rr.NoSlip(), rr.State(tilt=0.4, tilt_rate=-2.0, yaw_rate=0.1), 0.8)
    record = rr.gyro.Sensor(sampling_rate=1000.0, noise_density=1e-6).record(motion)
    assert rr.gyro.analyze(record, CAN).collisions[0].energy_kept is None


@pytest.mark.parametrize("side", [-1.0, 1.0])
def test_the_momentum_tells_the_side_of_the_turn(side):
    motion = motion_under(rr.NoSlip(), rr.State(tilt=0.5, yaw_rate=0.5 * side))
    first = rr.gyro.analyze(rr.gyro.phone(400.0).record(motion, seed=4), CAN).collisions[0]
    assert first.side_is_sure
    assert abs(first.turn) == pytest.approx(abs(motion.turns[0].angle), abs=math.radians(2.0))
    straight = motion_under(rr.NoSlip(), rr.State(tilt=0.5, yaw_rate=0.0002 * side))
    found = rr.gyro.analyze(rr.gyro.phone(400.0).record(straight, seed=4), CAN)
    assert not found.collisions[0].side_is_sure
    assert any("that theory makes likelier" in note for note in found.notes)


def test_the_friction_of_a_disk_is_not_stated():
    disk = rr.Body(0.3, 0.05, 0.0, 0.3 * 0.05**2 / 4.0, 0.3 * 0.05**2 / 2.0)
    motion = rr.simulate(disk, rr.State(tilt=0.6, yaw_rate=0.1), rr.NoSlip(), duration=0.8)
    found = rr.gyro.analyze(rr.gyro.phone(400.0).record(motion), disk, axis="z")
    assert found.friction is None
    assert set(found.frictions) == {None}
    assert any("turns alike at every friction" in note for note in found.notes)
    assert found.plot().axes[2].get_title(loc="left") == "(c) the same at every friction"
    assert found.to_dict()["friction"] is None


def test_the_turn_alone_is_that_of_theory():
    """For a body that rolls, it is near the limit, even where the whole turn is not."""
    motion = motion_under(rr.NoSlip(), replace(START, yaw_rate=0.02, spin_rate=0.0))
    found = rr.gyro.analyze(rr.gyro.phone(400.0).record(motion, seed=1), CAN)
    limit = rr.turn_limit(CAN, rr.NoSlip())
    assert found.collisions[0].turn_alone == pytest.approx(limit, abs=math.radians(1.5))


@pytest.mark.parametrize("rate", [100.0, 200.0, 400.0])
def test_friction_comes_back(rate):
    motion = motion_under(rr.Coulomb(0.2))
    found = rr.gyro.analyze(rr.gyro.phone(rate).record(motion, seed=5), CAN)
    low, high = found.friction.interval
    assert low <= 0.2 <= high
    assert high - low < 0.08
    assert found.friction.excludes_rolling
    assert found.friction.excludes_sliding


def test_rolling_gives_an_interval_without_end_and_sliding_one_from_zero():
    record = rr.gyro.phone(200.0).record(motion_under(rr.NoSlip()), seed=2)
    rolling = rr.gyro.analyze(record, CAN).friction
    assert rolling.interval[1] is None
    assert not rolling.excludes_rolling
    assert rolling.excludes_sliding
    record = rr.gyro.phone(200.0).record(motion_under(rr.Coulomb(0.0)), seed=2)
    sliding = rr.gyro.analyze(record, CAN).friction
    assert sliding.interval[0] == 0.0
    assert sliding.excludes_rolling
    assert not sliding.excludes_sliding


@pytest.mark.parametrize("order", [(0, 1, 2), (0, 2, 1), (2, 0, 1)])
def test_the_axis_is_found_whichever_of_the_sensor_it_is(slipping, order):
    motion, record = slipping
    # A mirror leaves an angular velocity as it is along the normal and turns the rest around.
    side = np.linalg.det(np.eye(3)[list(order)])
    turned = replace(record, rates=side * record.rates[:, order])
    found = rr.gyro.analyze(turned, CAN)
    assert int(np.argmax(np.abs(found.axis.direction))) == order.index(2)
    turn = abs(true_turn(motion, found.collisions[0]))
    assert abs(found.collisions[0].turn) == pytest.approx(turn, abs=math.radians(1.5))


def test_a_phone_that_is_askew_is_straightened(slipping):
    motion, _ = slipping
    sensor = replace(rr.gyro.phone(200.0), misalignment=math.radians(5.0))
    for seed in range(3):
        found = rr.gyro.analyze(sensor.record(motion, seed=seed), CAN)
        first = found.collisions[0]
        error = abs(first.veer - (abs(true_turn(motion, first)) - math.pi))
        assert error < 3.0 * first.veer_error
        assert first.veer_error < math.radians(2.0)


def test_veers_that_share_their_errors_tell_no_more_than_one(slipping):
    """Two veers with independent errors make the interval narrower, two with shared ones do not."""
    _, record = slipping
    found = rr.gyro.analyze(record, CAN, axis="z")
    one, there = found.collisions[0], found.predictions[0]

    def width(own, shared, count):
        error = np.array([math.radians(1.0), 0.0, 0.0])
        part = np.zeros((8, 3))
        part[2] = shared * error
        veer = replace(one, own_errors=own * error, shared_errors=part)
        low, high = friction_from([veer] * count, [there] * count, 3.84).interval
        return high - low

    single = width(1.0, 0.0, 1)
    assert width(1e-3, 1.0, 1) == pytest.approx(single, rel=1e-2)
    assert width(1e-3, 1.0, 2) == pytest.approx(single, rel=1e-2)
    assert width(1.0, 0.0, 2) == pytest.approx(single / math.sqrt(2.0), rel=0.1)


def test_a_bias_as_cheap_sensors_have_it_is_found():
    """20 degrees/s is the limit in the product specification of the MPU-6050 (PS-MPU-6000A-00)."""
    biased = replace(rr.gyro.phone(200.0), bias=math.radians(20.0))
    record = biased.record(motion_under(rr.Coulomb(0.2)), seed=5)
    found = rr.gyro.analyze(record, CAN, axis="z")
    assert np.abs(found.rests.bias).max() > 0.2
    assert found.friction.interval[0] <= 0.2 <= found.friction.interval[1]


def test_a_sensor_of_250_degrees_a_second_is_read_beside_what_it_cuts_off():
    motion = motion_under(rr.NoSlip())
    record = rr.gyro.phone(400.0, range=math.radians(250.0)).record(motion, seed=1)
    assert np.abs(record.rates).max() == pytest.approx(math.radians(250.0))
    found = rr.gyro.analyze(record, CAN, axis="z")
    first = found.collisions[0]
    error = abs(first.veer - (abs(true_turn(motion, first)) - math.pi))
    assert error < 3.0 * first.veer_error


@pytest.mark.slow
def test_veers_and_frictions_of_random_bodies_are_within_their_errors():
    check_coverage(range(8), within_two=0.9, friction_inside=0.75)


@pytest.mark.soak
def test_errors_are_as_large_as_they_say():
    """68 % of veers should be within one standard deviation, 95 % of frictions in the interval."""
    check_coverage(range(1000, 1120), within_one=0.68, within_two=0.95, friction_inside=0.93)


def check_coverage(seeds, within_two, friction_inside, within_one=0.0):
    off, energies, inside, refused = [], [], [], 0
    for seed in seeds:
        case = rocked(seed)
        if not case.motion.turns:  # it topples as it rises, or lingers at its balance tilt
            continue
        try:
            found = rr.gyro.analyze(case.record, case.body, axis="z")
        except rr.RimrollError:  # too few samples a second for a body so small
            refused += 1
            continue
        for one in found.collisions:
            veer = abs(case.true_turn(one)) - math.pi
            off.append(abs(one.veer - veer) / one.veer_error)
            if one.energy_kept is not None:
                energy = abs(one.energy_kept - case.true_energy_kept(one))
                energies.append(energy / one.energy_kept_error)
        interval = found.friction.interval
        inside.append(
            interval is not None
            and interval[0] <= case.friction
            and (interval[1] is None or case.friction <= interval[1])
        )
    off = np.array(off)
    assert refused <= 0.1 * len(seeds)
    assert (off < 1.0).mean() >= within_one
    assert (off < 2.0).mean() >= within_two
    assert off.max() < 6.0
    assert (np.array(energies) < 2.0).mean() >= 0.85  # measured: 0.91
    assert np.mean(inside) >= friction_inside


def test_the_answer_is_plain_numbers(slipping):
    _, record = slipping
    answer = rr.gyro.analyze(record, CAN).to_dict()
    first = answer["collisions"][0]
    assert {"time", "veer", "veer_error", "friction", "friction_interval"} <= first.keys()
    assert first["veer"] == pytest.approx(first["turn"] - 180.0)
    assert answer["simulated"] is True
    assert answer["veer_limits"] == pytest.approx([22.287, 40.969], abs=1e-3)


def test_the_figure_shows_record_star_and_friction(slipping):
    _, record = slipping
    figure = rr.gyro.analyze(record, CAN).plot()
    titles = [ax.get_title(loc="left") for ax in figure.axes]
    assert titles[0].startswith("(a) simulated record")
    assert titles[1].startswith("(b) the star")
    assert titles[2].startswith("(c) friction 0.1")


# Records of something else


def still(record):
    return replace(record, rates=record.rates[0] + 0.0 * record.rates)


def test_a_record_without_a_fall_is_refused(slipping):
    _, record = slipping
    with pytest.raises(rr.RimrollError, match="nothing falls in it"):
        rr.gyro.analyze(still(record), CAN)
    carried = replace(record, rates=np.stack([np.sin(2.0 * record.t + k) for k in range(3)], -1))
    with pytest.raises(rr.RimrollError, match="no fall through a near-collision was found"):
        rr.gyro.analyze(carried, CAN)


def test_a_can_that_rolls_on_its_side_is_refused():
    t = np.arange(0.0, 6.0, 0.01)
    noise = 1e-3 * np.random.default_rng(0).standard_normal((len(t), 3))
    rolling = np.where(t > 1.0, 12.0 * np.exp(-0.3 * (t - 1.0)), 0.0)
    rates = noise + np.outer(rolling, [0.0, 0.0, 1.0])
    with pytest.raises(rr.RimrollError, match="rolls on its side, or spins"):
        rr.gyro.analyze(rr.gyro.Record(t, rates), CAN)


def test_an_accelerometer_is_refused():
    t = np.arange(0.0, 3.0, 0.01)
    draw = np.random.default_rng(0)
    rates = np.array([0.1, 0.2, 9.8]) + 0.3 * draw.standard_normal((len(t), 3))
    with pytest.raises(rr.RimrollError, match="accelerometer at rest"):
        rr.gyro.analyze(rr.gyro.Record(t, rates), CAN)


def test_degrees_taken_for_radians_are_refused(slipping):
    _, record = slipping
    with pytest.raises(rr.RimrollError, match="they may be in degrees/s"):
        rr.gyro.analyze(replace(record, rates=np.degrees(record.rates)), CAN)


def test_a_loose_phone_is_told_or_refused(slipping):
    """A phone that swings in the can by some degrees leaves what no axis explains."""
    _, record = slipping

    def loose(size):
        swinging = size * np.sin(40.0 * record.t) * (record.t > RELEASE)
        return replace(record, rates=record.rates + np.outer(swinging, [0.6, 0.0, 0.8]))

    notes = rr.gyro.analyze(loose(0.5), CAN, axis="z").notes
    assert any("the sensor may be loose" in note for note in notes)
    with pytest.raises(rr.RimrollError, match="do not follow gravity"):
        rr.gyro.analyze(loose(1.5), CAN, axis="z")


def test_a_record_that_is_cut_in_the_middle_of_a_fall_gives_the_falls_before(slipping):
    _, record = slipping
    whole = rr.gyro.analyze(record, CAN)
    cut = record.between(0.0, whole.collisions[0].end + 0.12)
    assert len(rr.gyro.analyze(cut, CAN).collisions) == 1
    with pytest.raises(rr.RimrollError, match="cut off by the end of the record"):
        rr.gyro.analyze(record.between(0.0, whole.collisions[0].time - 0.05), CAN)


def test_falls_across_a_gap_are_not_read(slipping):
    _, record = slipping
    first = rr.gyro.analyze(record, CAN).collisions[0]
    kept = np.abs(record.t - first.time - 0.06) > 0.03
    gappy = rr.gyro.Record(record.t[kept], record.rates[kept])
    whole = [one.time for one in rr.gyro.analyze(record, CAN, axis="z").collisions]
    times = [one.time for one in rr.gyro.analyze(gappy, CAN, axis="z").collisions]
    assert times == pytest.approx(whole[1:], abs=1e-3)


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"axis": "w"}, 'axis must be "auto"'),
        ({"confidence": 1.0}, "confidence must be"),
        ({"gravity": -1.0}, "gravity must be > 0"),
    ],
)
def test_impossible_arguments_are_refused(slipping, options, message):
    with pytest.raises(rr.RimrollError, match=message):
        rr.gyro.analyze(slipping[1], CAN, **options)


def test_a_fall_after_a_near_collision_that_was_not_read_is_no_release(slipping):
    """The rim may still slide then, so such a fall gives no friction of its own."""
    _, record = slipping
    whole = rr.gyro.analyze(record, CAN)
    first, second = whole.collisions[:2]
    shown = np.array(record.rates)
    beside = np.abs(record.t - first.time) < 0.06  # a knock hides the first near-collision
    shown[beside] *= 1.0 + 0.8 * np.sin(200.0 * record.t[beside])[:, np.newaxis]
    found = rr.gyro.analyze(replace(record, rates=shown), CAN, axis="z")
    later = min(found.collisions, key=lambda one: abs(one.time - second.time))
    assert later.time == pytest.approx(second.time, abs=0.005)
    assert not later.released


def test_a_fall_that_follows_one_that_was_read_is_no_release():
    """Even from near the balance point, where a body lingers as in a hand."""
    tilt = 0.85 * rr.balance_tilt(CAN)
    motion = motion_under(rr.NoSlip(), rr.State(tilt=tilt, yaw_rate=0.1), 1.4)
    found = rr.gyro.analyze(rr.gyro.phone(200.0).record(motion, seed=1), CAN)
    assert [one.released for one in found.collisions] == [True, False]
