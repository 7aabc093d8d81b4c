"""``rimroll gyro``: its answer, its files, and its errors."""

import json
import runpy
from pathlib import Path

import numpy as np
import pytest

import rimroll as rr
from rimroll.cli import main

EXAMPLES = Path(__file__).parents[2] / "examples"
RECORD = EXAMPLES / "simulated_phone_in_a_can.csv"
TIN = EXAMPLES / "can_with_phone.toml"


def test_the_command_gives_veer_and_friction_as_json(capsys):
    assert main(["gyro", str(RECORD), "--body", str(TIN), "--json"]) == 0
    answer = json.loads(capsys.readouterr().out)
    (first,) = answer["collisions"]
    low, high = first["friction_interval"]
    assert low < 0.2 < high  # the friction of examples/phone_in_a_can.py
    assert first["veer_error"] < 2.0
    assert answer["simulated"] is True


def test_the_command_says_that_the_record_is_simulated_and_draws_it(capsys, tmp_path):
    figure = tmp_path / "star.svg"
    assert main(["gyro", str(RECORD), "--body", str(TIN), "-o", str(figure)]) == 0
    out = capsys.readouterr().out
    assert "This record was simulated, not measured." in out
    assert "rolling without slip: excluded" in out
    assert figure.read_text().startswith("<?xml")


def test_columns_and_units_may_be_given(capsys, tmp_path):
    record = rr.gyro.read(RECORD)
    table = np.column_stack([record.t, np.degrees(record.rates)])
    file = tmp_path / "bare.csv"
    np.savetxt(file, table, delimiter=",", header="a,b,c,d", comments="")
    options = ["--units", "deg/s", "--columns", "t=a,x=b,y=3,z=4", "--axis", "y"]
    assert main(["gyro", str(file), "--body", str(TIN), *options]) == 0
    assert "rates b, c, d in deg/s" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("options", "message"),
    [
        (["--axis", "up"], 'axis must be "auto", "x", "y" or "z"'),
        (["--units", "deg/s"], "the rates are in rad/s"),
        (["--columns", "b"], "--columns must be as in"),
        (["--body", "nothing.toml"], "nothing.toml"),
        (["--body-error", "2%"], "--body-error needs --fit or --resistance"),
    ],
)
def test_what_is_wrong_is_said_in_a_sentence(capsys, options, message):
    assert main(["gyro", str(RECORD), "--body", str(TIN), *options]) == 2
    error = capsys.readouterr().err
    assert message in error or message.replace("axis must", "--axis must") in error


def test_the_record_of_the_examples_is_that_of_its_script(capsys):
    made = runpy.run_path(str(EXAMPLES / "phone_in_a_can.py"))["record"]
    shipped = rr.gyro.read(RECORD)
    assert shipped.simulated
    assert shipped.t == pytest.approx(made.t, abs=1e-6)
    assert shipped.rates == pytest.approx(made.rates, abs=2e-3)  # a digital step is 1.2e-3
