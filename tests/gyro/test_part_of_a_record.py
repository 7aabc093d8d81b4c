"""``rimroll gyro --between``: one of several releases in a record."""

import json

import numpy as np
import pytest

import rimroll as rr
from rimroll.cli import main

CAN = rr.bodies.can_2007()


@pytest.fixture(scope="module")
def twice(tmp_path_factory):
    """The file of a record with two releases, on tables with frictions 0.1 and 0.3."""
    sensor, records = rr.gyro.phone(200.0), []
    for friction in (0.1, 0.3):
        start = rr.State(tilt=0.5, yaw_rate=0.1)
        motion = rr.simulate(CAN, start, rr.Coulomb(friction), duration=0.8)
        records.append(sensor.record(motion, seed=4))
    first, second = records
    later = first.t[-1] + first.step + second.t
    t, rates = np.append(first.t, later), np.append(first.rates, second.rates, axis=0)
    file = tmp_path_factory.mktemp("record") / "twice.csv"
    rr.gyro.Record(t, rates, "twice", "simulated", simulated=True).save(file)
    return file, float(later[0])


def friction_in(capsys, *arguments):
    assert main(["gyro", *map(str, arguments), "--body", "can_2007", "--json"]) == 0
    return json.loads(capsys.readouterr().out)["collisions"][0]["friction"]


def test_each_release_is_read_apart(twice, capsys):
    file, second = twice
    assert friction_in(capsys, file, "--between", f"0 s,{second} s") == pytest.approx(0.1, abs=0.03)
    assert friction_in(capsys, file, "--between", f"{second},1 h") == pytest.approx(0.3, abs=0.05)


@pytest.mark.parametrize(
    ("times", "message"),
    [
        ("12 s", "--between must be two times"),
        ("12 s,2 s", "--between must be an earlier and a later time, got 12 s,2 s"),
        ("1 m,2 m", "--between must be a time"),
        ("0 s,1 ms", "must have at least 20 samples"),
    ],
)
def test_other_times_are_refused(twice, times, message, capsys):
    assert main(["gyro", str(twice[0]), "--body", "can_2007", "--between", times]) == 2
    assert message in capsys.readouterr().err
