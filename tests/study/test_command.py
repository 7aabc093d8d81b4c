"""``rimroll study plan``: what it shows and what it refuses."""

import json
from collections import namedtuple

import pytest

from rimroll.cli import main
from rimroll.cli.study import COMMANDS

STUDY = """
title = "A can on three tables"
kind = "topple"
trials = 20
seed = 4
keep = ["turn", "outcome"]
body = { preset = "can_2007" }
law = { kind = "coulomb" }
release = "paper"
axes = { friction = { of = "law.friction", values = [0.1, 0.2, 0.4] } }

[random."body.height"]
distribution = "normal"
mean = "6.9 cm"
spread = "1 mm"
"""


@pytest.fixture
def file(tmp_path):
    path = tmp_path / "can.toml"
    path.write_text(STUDY, "utf-8")
    return path


def test_a_plan_says_what_varies_and_how_much_that_is(file, capsys):
    assert main(["study", "plan", str(file)]) == 0
    shown = capsys.readouterr().out
    assert "A can on three tables" in shown
    assert "rows      60 = 3 friction x 20 trial" in shown
    assert "columns   outcome, turn" in shown
    assert "mean 0.069, spread 0.001" in shown
    assert "at most 540 B in" in shown


def test_a_plan_in_json_has_everything_that_decides_the_numbers(file, capsys):
    assert main(["study", "plan", str(file), "--json"]) == 0
    answer = json.loads(capsys.readouterr().out)
    assert answer["dims"] == {"friction": 3, "trial": 20}
    assert answer["rows"] == 60
    assert answer["bytes"] == 60 * 9
    assert answer["store"] == str(file.with_suffix(".zarr"))
    assert json.loads(answer["attributes"]["study"])["law"] == {"kind": "coulomb"}


def test_a_study_that_does_not_fit_on_the_disk_is_refused_unless_told(file, capsys, monkeypatch):
    usage = namedtuple("usage", "free")
    monkeypatch.setattr("shutil.disk_usage", lambda _: usage(500))
    assert main(["study", "plan", str(file)]) == 2
    complaint = capsys.readouterr().err
    assert "takes up to 540 B" in complaint and "has 500 B" in complaint
    assert main(["study", "plan", str(file), "--larger-than-disk"]) == 0


@pytest.mark.parametrize("name", COMMANDS)
def test_each_command_of_studies_has_help_with_an_example(name, capsys):
    assert main(["study", name, "--help"]) == 0
    shown = capsys.readouterr().out
    assert COMMANDS[name] in shown
    assert f"$ rimroll study {name}" in shown


def test_errors_name_the_file(tmp_path, capsys):
    path = tmp_path / "bad.toml"
    path.write_text(STUDY.replace("law.friction", "law.frictoin"), "utf-8")
    assert main(["study", "plan", str(path)]) == 2
    complaint = capsys.readouterr().err
    assert complaint.startswith(f"rimroll: {path}: [axes.friction] unknown quantity 'law.frictoin'")
    assert "did you mean 'law.friction'?" in complaint
    assert main(["study", "plan", "can.csv"]) == 2
    assert "a study is a .toml file, got can.csv" in capsys.readouterr().err
