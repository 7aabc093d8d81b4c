"""The simulated sensor: its noise, bias, steps, range and delay, and the file that it writes."""

import numpy as np
import pytest

import rimroll as rr

CAN = rr.bodies.can_2007()
DEGREE = np.pi / 180.0
START = rr.State(tilt=0.5, tilt_rate=-0.2, yaw_rate=0.1)


@pytest.fixture(scope="module")
def motion():
    return rr.simulate(CAN, START, rr.NoSlip(), duration=1.0)


def across(record):
    return np.hypot(record.rates[:, 0], record.rates[:, 1])


def test_a_perfect_sensor_shows_the_motion(motion):
    sensor = rr.gyro.Sensor(sampling_rate=1000.0)
    record = sensor.record(motion, rest=0.5, held=0.2)
    released = 0.5 + 0.6 + 0.2
    t = record.t[record.t > released + 0.01] - released
    collisions = [event.t for event in motion.events if event.kind == "tilt_min"]
    smooth = np.abs(np.subtract.outer(t, collisions)).min(axis=1) > 0.01
    seen = across(record)[record.t > released + 0.01]
    w = motion.evaluate(t).body_angular_velocity
    assert np.abs(seen - np.hypot(w[:, 0], w[:, 1]))[smooth].max() < 2e-3


def test_noise_is_its_density_times_the_root_of_the_bandwidth(motion):
    sensor = rr.gyro.Sensor(sampling_rate=400.0, noise_density=1e-4)
    record = sensor.record(motion, rest=20.0)
    still = record.rates[record.t < 20.0]
    assert still.std() == pytest.approx(1e-4 * np.sqrt(200.0), rel=0.03)


def test_bias_differs_from_record_to_record_and_a_seed_repeats_it(motion):
    sensor = rr.gyro.Sensor(bias=0.02)
    first, again, other = (sensor.record(motion, seed=seed) for seed in (1, 1, 2))
    assert (first.rates == again.rates).all()
    assert np.abs(first.rates[0] - other.rates[0]).max() > 1e-3


def test_the_output_has_steps_and_a_range(motion):
    sensor = rr.gyro.Sensor(resolution=0.01, range=3.0)
    rates = sensor.record(motion).rates
    assert np.abs(rates / 0.01 - np.round(rates / 0.01)).max() < 1e-9
    assert np.abs(rates).max() == 3.0


def test_the_integral_of_the_rate_is_kept_by_the_filter(motion):
    """Its mean delay is taken off; so the tilt at the release and the one reached are right."""
    sensor = rr.gyro.Sensor(sampling_rate=100.0, bandwidth=20.0)
    record = sensor.record(motion, rest=0.5, held=0.5)
    tipped = record.t < 1.3
    assert np.trapezoid(across(record)[tipped], record.t[tipped]) == pytest.approx(0.5, abs=1e-3)


def test_a_record_survives_its_file_and_says_that_it_is_simulated(motion, tmp_path):
    record = rr.gyro.phone(200.0).record(motion)
    read = rr.gyro.read(record.save(tmp_path / "rock.csv"))
    assert read.simulated
    assert read.t == pytest.approx(record.t, abs=1e-6)
    assert read.rates == pytest.approx(record.rates, rel=1e-5, abs=1e-9)
    assert (tmp_path / "rock.csv").read_text().startswith("# simulated")


@pytest.mark.parametrize(
    ("field", "value"),
    [
        ("sampling_rate", 0.0), ("sampling_rate", np.nan), ("sampling_rate", "fast"),
        ("noise_density", -1.0), ("range", -2.0), ("bandwidth", np.inf), ("jitter", "2 m"),
        ("bias", [0.1, 0.2]),
    ],
)  # fmt: skip
def test_impossible_sensors_are_refused(field, value):
    with pytest.raises(rr.RimrollError, match=field):
        rr.gyro.Sensor(**{field: value})


def test_numbers_of_a_sensor_may_have_units(motion):
    sensor = rr.gyro.Sensor(bias="1 deg/s", jitter="0.1 ms", misalignment="2 deg")
    assert sensor == rr.gyro.Sensor(bias=DEGREE, jitter=1e-4, misalignment=2.0 * DEGREE)
    plain = sensor.record(motion, rest=1.0, held=0.5)
    assert (sensor.record(motion, rest="1 s", held="500 ms").rates == plain.rates).all()


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"rest": np.nan}, "rest must be >= 0 and finite"),
        ({"rest": -1.0}, "rest must be >= 0"),
        ({"held": np.inf}, "held must be >= 0 and finite"),
        ({"rest": 1e9}, "a record may have 1000000 samples"),
    ],
)
def test_impossible_times_are_refused(motion, options, message):
    with pytest.raises(rr.RimrollError, match=message):
        rr.gyro.Sensor().record(motion, **options)
