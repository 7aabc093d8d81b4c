"""Commands have a default start for every body, and suggest others where a start shows nothing."""

import io
import json
import math
import re
from functools import partial
from pathlib import Path

import pytest
from rich.console import Console

import rimroll as rr
from rimroll import bodies
from rimroll.cli import main, screen


@pytest.fixture
def stdout_of(capsys):
    """Runs a command that must succeed, and returns its stdout."""

    def run(arguments):
        assert main(arguments.split()) == 0
        return capsys.readouterr().out

    return run


@pytest.mark.parametrize("name", sorted(bodies.PRESETS))
def test_compare_and_simulate_need_no_start_for_any_body(stdout_of, name):
    compared = json.loads(stdout_of(f"compare {name} --json"))["outcomes"]
    followed = json.loads(stdout_of(f"simulate {name} --json"))
    balance = rr.balance_tilt(bodies.by_name(name))
    for one in compared:
        assert one["parameters"]["start_tilt"] == pytest.approx(0.5 * balance)
        assert one["turn"] is not None and one["turn_limit"] is not None
        assert one["status"] == "finished"
    assert followed["parameters"]["start_tilt"] == pytest.approx(0.5 * balance)
    assert followed["status"] == "finished" and len(followed["turns"]) > 1


def test_a_tilt_alone_is_compared_with_a_push_and_simulated_as_it_is(stdout_of):
    start = json.loads(stdout_of("compare --tilt 20deg --json"))["outcomes"][0]["parameters"]
    assert start["start_tilt"] == math.radians(20.0) and start["start_yaw_rate"] != 0.0
    start = json.loads(stdout_of("compare --spin-rate 0.1 --json"))["outcomes"][0]["parameters"]
    assert (start["start_yaw_rate"], start["start_spin_rate"]) == (0.0, 0.1)
    assert json.loads(stdout_of("simulate --tilt 20deg --json"))["status"] == "face_down"


@pytest.mark.parametrize("body", ["soda_can", "beer_bottle", "battery", "can_2007", "coin"])
@pytest.mark.parametrize("tilt", [5, 20, 40, 70, 85])
def test_no_loss_is_above_what_there_is_to_lose(stdout_of, body, tilt):
    for one in json.loads(stdout_of(f"compare {body} --tilt {tilt}deg --json"))["outcomes"]:
        assert -1e-9 < one["energy_lost_fraction"] <= 1.0 + 1e-9
        assert one["energy_available"] >= one["energy_at_start"]


@pytest.mark.parametrize("command", ["simulate", "turn"])
def test_a_start_past_the_balance_tilt_is_reported_in_degrees(stdout_of, command):
    text = " ".join(
        stdout_of(f"{command} beer_bottle --tilt 20deg --yaw-rate 1 --law no-slip").split()
    )
    assert "toppled: the tilt reached 90.000°" in text and " rad at" not in text
    assert "the start at 20° is past the balance tilt of this body, 17.05°" in text
    assert "try --tilt 8.5deg" in text
    assert "past the balance tilt" not in stdout_of(
        f"{command} beer_bottle --tilt 8.5deg --yaw-rate 1"
    )


def test_the_filling_of_a_body_is_said_to_be_frozen(stdout_of):
    text = stdout_of("turn soda_can --fill 30%")
    assert "its filling counts as frozen" in text
    assert re.search("balance tilt, filling frozen +46.667°", text)
    assert re.search("balance tilt, filling liquid +35.788°", text)
    answer = json.loads(stdout_of("turn soda_can --fill 30% --json"))
    assert math.degrees(answer["liquid_balance_tilt"]) == pytest.approx(35.78816, abs=1e-5)
    assert "frozen" in stdout_of("simulate soda_can --fill 30% --tilt 50deg")
    assert "frozen" not in stdout_of("turn soda_can") + stdout_of("simulate soda_can --tilt 50deg")


FALLS = str(Path(__file__).parents[2] / "examples" / "falls_of_the_paper.csv")
PAST = "the start at 40° is past the balance tilt of this body, 24.95°"


@pytest.mark.parametrize("command", ["topple soda_can --seed 1", "map soda_can --starts 4"])
def test_many_falls_from_past_the_balance_tilt_are_reported(stdout_of, command):
    text = " ".join(stdout_of(f"{command} --tilt 40deg --tilt-rate -1").split())
    assert f"{PAST}, and -1 rad/s is too slow to bring it back, so it falls over" in text
    assert "try --tilt 12deg" in text
    assert "balance tilt" not in stdout_of(f"{command} --tilt 12deg --tilt-rate -1")
    # A flick that brings the body back past its balance tilt is a valid start.
    assert "balance tilt" not in stdout_of(f"{command} --tilt 40deg --tilt-rate -4")


@pytest.mark.parametrize(
    ("command", "name", "words"),
    [
        ("map soda_can --tilt 40deg --starts 4", "fell_back", "fell back"),
        ("topple soda_can --tilt 40deg --tilt-rate -0.1 -n 8 --seed 1", "fell_back", "2 fell back"),
        ("compare coin --tilt 60deg --on no-slip", "lifted_off", "lifted off"),
        ("simulate coin --tilt 60deg --yaw-rate 1deg/s", "lift_off", "1 lift off"),
        ("simulate --tilt 20deg", "face_down", "1 face down"),
    ],
)
def test_an_ending_has_one_name_in_json_and_one_wording_on_the_screen(
    stdout_of, command, name, words
):
    text = stdout_of(command)
    assert words in text
    assert name not in text and name.replace("_", "-") not in text
    assert f'"{name}"' in stdout_of(f"{command} --json")


@pytest.mark.slow
def test_a_fit_of_flicks_from_past_the_balance_tilt_is_reported(stdout_of):
    fit = f"fit {FALLS} --body soda_can --tilt-rate-error 0"
    assert PAST in " ".join(stdout_of(f"{fit} --tilt 40deg --tilt-rate -1").split())
    assert "balance tilt" not in stdout_of(f"{fit} --tilt 12deg")


@pytest.mark.parametrize("command", ["simulate", "turn"])
def test_a_flick_back_over_the_balance_tilt_is_not_reported_to_fall_over(stdout_of, command):
    fast = "--tilt 40deg --tilt-rate -4.27 --yaw-rate 0.1 --law no-slip"
    assert "toppled" in stdout_of(f"{command} soda_can {fast}")
    assert "balance tilt of" not in stdout_of(f"{command} soda_can {fast}")


@pytest.mark.parametrize(
    "command",
    [
        "turn --friction 0.2 --tilt 30deg --yaw-rate 0.005",
        "simulate beer_bottle --tilt 20deg --friction 0.2",
        "simulate --tilt 30deg",
        "compare coin --tilt 60deg --on ice,no-slip,rubber",
        "topple --seed 1 --surface wood",
        "map --starts 4 --friction 0.2",
        "measure --mass 70g --diameter 10.2cm --balance-point 6.9cm --swings 50 --swings-time 38s",
        "bodies",
    ],
)
def test_what_a_command_says_fits_into_eighty_columns(stdout_of, command):
    assert max(map(len, stdout_of(command).splitlines())) <= 80


@pytest.mark.parametrize("command", ["simulate", "turn"])
def test_where_the_rim_lifts_off_another_friction_is_proposed_and_helps(stdout_of, command):
    text = " ".join(stdout_of(f"{command} coin --tilt 60deg --yaw-rate 1deg/s").split())
    assert "try --law coulomb --friction 0.3" in text
    text = stdout_of(f"{command} coin --tilt 60deg --yaw-rate 1deg/s --friction 0.3")
    assert "followed for the whole 2 s" in text and "try --" not in text


@pytest.mark.parametrize(
    ("law", "start"),
    [
        ("no-slip", "coin --tilt 60deg --yaw-rate 1deg/s"),
        ("frictionless", "soda_can --tilt 20deg --tilt-rate -10 --yaw-rate 50"),
    ],
)
@pytest.mark.parametrize("command", ["simulate {} --law", "turn {} --law", "compare {} --on"])
def test_the_friction_that_a_command_proposes_is_one_that_it_takes(stdout_of, command, law, start):
    command = f"{command.format(start)} {law}"
    proposed = re.search(
        r"try (--law coulomb |)(--\S+ [\d.]+)", " ".join(stdout_of(command).split())
    )
    assert proposed
    # Where an option is given twice the last one counts.
    assert "leaves the table" not in stdout_of(f"{command} {proposed[1]}{proposed[2]}")


def test_a_wide_table_is_not_cut_where_it_is_not_shown_on_a_terminal(monkeypatch, capsys):
    monkeypatch.setenv("COLUMNS", "80")
    rows = screen.table("law", "limiting angle of turn", "beyond 180°")
    rows.add_row("tabulated, speeds 0 to 0.5 m/s, frictions 0.14 to 0.28", "202.287°", "22.287°")
    screen.say(rows)
    head, _, row = capsys.readouterr().out.splitlines()
    assert head.startswith("law  ") and head.endswith("limiting angle of turn   beyond 180°")
    assert row.startswith("tabulated, speeds 0 to 0.5 m/s, frictions 0.14 to 0.28 ")
    assert row.endswith("202.287°       22.287°")


@pytest.mark.parametrize("width", [40, 60, 80, 120])
def test_nothing_of_a_table_is_cut_off_on_a_narrow_terminal(monkeypatch, width):
    shown = io.StringIO()
    console = partial(Console, file=shown, width=width, force_terminal=True, color_system=None)
    monkeypatch.setattr(screen, "Console", console)
    rows = screen.table("law", "limiting angle of turn", "beyond 180°")
    rows.add_row("no-slip", "202.287°", "22.287°")
    rows.add_row("frictionless", "220.969°", "")
    screen.say(rows)
    assert "…" not in shown.getvalue()
    for word in ("limiting angle of turn", "frictionless", "202.287°", "22.287°"):
        assert word in shown.getvalue()
    assert max(map(len, shown.getvalue().splitlines())) <= width
