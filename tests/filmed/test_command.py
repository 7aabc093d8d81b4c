"""``rimroll film``: from the file of a track to the friction."""

import json

import numpy as np
import pytest

import rimroll as rr
from given.films import filmed, leaning
from rimroll.cli import main

CAN = rr.bodies.can_2007()
FRICTION = 0.15


@pytest.fixture(scope="module")
def motion():
    return rr.simulate(CAN, rr.State(tilt=0.5, yaw_rate=0.1), rr.Coulomb(FRICTION), 0.9)


@pytest.fixture(scope="module")
def path(motion, tmp_path_factory):
    """A track of a marker on the lid, in cm."""
    t, places = filmed(motion, (0.0, 0.0, 0.12))
    file = tmp_path_factory.mktemp("film") / "dot.txt"
    np.savetxt(
        file,
        np.column_stack([t, 100.0 * places]),
        delimiter="\t",
        header="dot\nt\tx\ty",
        comments="",
    )
    return file


@pytest.fixture(scope="module")
def lean(motion, tmp_path_factory):
    t, angles = leaning(motion)
    file = tmp_path_factory.mktemp("film") / "lean.csv"
    titles = "t,tilt (deg),heading (deg)"
    np.savetxt(
        file, np.column_stack([t, np.degrees(angles)]), delimiter=",", header=titles, comments=""
    )
    return file


MARKER = ["--body", "can_2007", "--marker", "0 mm,12 cm", "--units", "x=cm,y=cm"]


@pytest.mark.slow
def test_the_path_of_a_marker_gives_the_friction(path, tmp_path, capsys):
    file, picture = tmp_path / "fit.json", tmp_path / "fit.svg"
    assert main(["film", str(path), *MARKER, "-o", str(file), "-o", str(picture)]) == 0
    out = capsys.readouterr().out
    assert "read path: t in s, x in cm, y in cm" in out
    assert "friction" in out and "profile" in out
    low, high = json.loads(file.read_text())["numbers"]["friction"]["interval"]
    assert low < FRICTION < high
    assert picture.read_text().startswith("<?xml")


@pytest.mark.slow
def test_a_lean_gives_the_friction_and_a_resistance(lean, capsys):
    assert main(["film", str(lean), "--body", "can_2007", "--resistance", "--json"]) == 0
    numbers = json.loads(capsys.readouterr().out)["numbers"]
    low, high = numbers["friction"]["interval"]
    assert low < FRICTION and (high is None or high > FRICTION)
    assert numbers["rolling_dry"]["interval"][0] >= 0.0


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["--body", "can_2007"], "a path needs --marker"),
        (["--body", "can_2007", "--marker", "3 cm"], "--marker must be two lengths"),
        (["--body", "can_2007", "--marker", "3 cm,high"], "--marker must be a length"),
        ([*MARKER, "--units", "cm"], "--units must be as in x=cm,y=cm, got 'cm'"),
        ([*MARKER, "--columns", "1,2,3"], "--columns must be as in t=1,x=2,y=3, got '1,2,3'"),
        ([*MARKER, "--error", "1 deg"], "--error must be a length"),
    ],
)
def test_what_is_wrong_is_said_in_a_line(path, arguments, message, capsys):
    assert main(["film", str(path), *arguments]) == 2
    assert message in capsys.readouterr().err


def test_a_marker_of_a_lean_is_refused(lean, capsys):
    assert main(["film", str(lean), "--body", "can_2007", "--marker", "0 mm,12 cm"]) == 2
    assert "--marker needs a path; the track shows the lean" in capsys.readouterr().err
