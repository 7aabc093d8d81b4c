"""The command line answers as the API does, on the screen, in JSON and in files."""

import inspect
import json
import os
import re
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
import xarray as xr

import rimroll as rr
from rimroll.cli import main
from rimroll.cli.commands import COMMANDS
from rimroll.motion import UNITS

CAN = str(Path(__file__).parents[2] / "examples" / "can_2007.toml")
PAPER = "--tilt 30deg --tilt-rate -0.5rad/s --yaw-rate 0.005 --spin-rate 0.005 --gravity 9.8"
START = rr.State(tilt=np.pi / 6, tilt_rate=-0.5, yaw_rate=0.005, spin_rate=0.005)


@pytest.fixture
def stdout_of(capsys):
    """Runs a command that must succeed, and returns its stdout."""

    def run(arguments):
        assert main(arguments.split()) == 0
        captured = capsys.readouterr()
        assert captured.err == ""
        return captured.out

    return run


@pytest.fixture(scope="module")
def motion():
    return rr.simulate(rr.bodies.can_2007(), START, rr.NoSlip(), gravity=9.8)


def test_the_version_is_the_packages(stdout_of):
    assert stdout_of("--version") == f"rimroll {rr.__version__}\n"


def test_without_a_command_there_is_help(stdout_of):
    assert "Usage: rimroll" in stdout_of("")


@pytest.mark.parametrize("command", ["turn", "simulate", "map", "compare", "reproduce", "bodies"])
def test_each_command_has_help_with_an_example(stdout_of, command):
    text = stdout_of(f"{command} --help")
    assert f"$ rimroll {command}" in text
    assert "Example" in text


@pytest.mark.parametrize(
    ("command", "function"),
    [("simulate", rr.simulate), ("turn", rr.simulate), ("topple", rr.topple), ("map", rr.turn_map)],
)
def test_the_defaults_in_the_help_are_those_of_python(stdout_of, command, function):
    text = " ".join(stdout_of(f"{command} --help").split())
    usual = inspect.signature(function).parameters
    for option, unit in (("duration", " s"), ("rtol", ""), ("max_steps", "")):
        found = re.search(rf"--{option.replace('_', '-')} [A-Z]+ [^\[]*\[([^\]]+)\]", text)
        assert found
        assert float(found[1].removesuffix(unit)) == usual[option].default


def test_a_map_and_falls_are_followed_with_the_options_of_python(stdout_of):
    """A scenario file, which is for one motion, gives neither duration nor accuracy."""
    for command in ("map --friction 0.2 --starts 2", "topple -n 2 --seed 1"):
        for file in ("", CAN):
            parameters = json.loads(stdout_of(f"{command} {file} --json"))["parameters"]
            assert (parameters["duration"], parameters["rtol"], parameters["max_steps"]) == (
                10.0,
                1e-6,
                100_000,
            )
        parameters = json.loads(stdout_of(f"{command} --duration 3s --max-steps 900 --json"))[
            "parameters"
        ]
        assert (parameters["duration"], parameters["rtol"], parameters["max_steps"]) == (
            3.0,
            1e-6,
            900,
        )


@pytest.mark.parametrize("command", ["", *COMMANDS])
def test_help_fits_into_eighty_columns_with_nothing_cut_off(stdout_of, command, monkeypatch):
    monkeypatch.setenv("COLUMNS", "80")
    text = stdout_of(f"{command} --help")
    assert max(map(len, text.splitlines())) <= 80
    assert all(COMMANDS[name] in text for name in COMMANDS if not command or command == name)


def test_the_list_of_bodies_says_how_those_of_any_size_are_made(stdout_of):
    text = stdout_of("bodies")
    for made in ("disk --radius LENGTH", "cylinder --radius LENGTH --length LENGTH"):
        assert f"in any size: {made}" in text
    assert "soda_can [--fill PART]" in text


@pytest.mark.parametrize("command", COMMANDS)
def test_the_help_names_no_folder_that_only_the_repository_has(stdout_of, command):
    assert "examples/" not in stdout_of(f"{command} --help")


@pytest.mark.parametrize(
    ("earlier", "now"),
    [
        ("map --points 3 --friction 0.2 --json", "map --starts 3 --friction 0.2 --json"),
        ("map --points=3 --json", "map --starts=3 --json"),
        (f"turn --scenario {CAN} --json", f"turn {CAN} --json"),
    ],
)
def test_earlier_spellings_of_options_work_and_are_not_shown(stdout_of, earlier, now):
    assert stdout_of(earlier) == stdout_of(now)
    command, option = earlier.split()[:2]
    assert option.partition("=")[0] not in stdout_of(f"{command} --help")


@pytest.mark.slow
def test_the_examples_in_the_help_work(stdout_of, monkeypatch, tmp_path):
    monkeypatch.chdir(tmp_path)
    for file in Path(CAN).parent.iterdir():
        Path(file.name).symlink_to(file)
    for command in ("turn", "simulate", "compare", "shake", "bodies"):
        lines = stdout_of(f"{command} --help").splitlines()
        examples = [line.split("$ rimroll ")[1] for line in lines if "$ rimroll" in line]
        assert examples
        for example in examples:
            assert stdout_of(example)


# turn


def test_turn_shows_the_papers_limiting_angles(stdout_of):
    text = stdout_of("turn")
    assert "202.287°" in text and "22.287°" in text  # without slip
    assert "220.969°" in text and "40.969°" in text  # without friction
    assert "0.3558" in text  # the friction needed


def test_turn_in_json_is_the_api(stdout_of):
    can = rr.bodies.can_2007()
    answer = json.loads(stdout_of("turn can-2007 --json"))
    assert answer["turn_limit"] == {
        "no_slip": rr.turn_limit(can, rr.NoSlip()),
        "frictionless": rr.turn_limit(can, rr.Frictionless()),
    }
    assert answer["needed_friction"] == rr.needed_friction(can)
    assert answer["balance_tilt"] == rr.balance_tilt(can)
    assert answer["lift_off_rate"] == rr.lift_off_rate(can)
    assert answer["body"]["mass"] == can.mass
    assert answer["motions"] == {}


def test_turn_of_one_law_is_that_law_only(stdout_of):
    assert list(json.loads(stdout_of("turn --law no-slip --json"))["turn_limit"]) == ["no_slip"]


def test_the_law_in_place_has_the_limit_without_slip(stdout_of, tmp_path):
    limit = rr.turn_limit(rr.bodies.can_2007(), rr.NoSlip())
    answer = json.loads(stdout_of("turn --law in-place --json"))
    assert answer["turn_limit"] == {"in_place": limit}
    file = tmp_path / "column.toml"
    file.write_text(
        '[body]\npreset = "can_2007"\n[start]\ntilt = "30 deg"\nyaw_rate = 0.01\n'
        '[law]\nkind = "in_place"\n'
    )
    turns = json.loads(stdout_of(f"simulate {file} --json"))["turns"]
    assert abs(turns[0]["angle"]) == pytest.approx(limit, abs=0.1)


def test_a_disk_never_lifts_off_which_json_says_as_null(stdout_of):
    answer = json.loads(stdout_of("turn disk --radius 4cm --json"))
    assert answer["lift_off_rate"] is None
    assert answer["turn_limit"]["no_slip"] == pytest.approx(np.pi * np.sqrt(5))  # the paper
    assert "never lifts off" in stdout_of("turn disk --radius 4cm")


def test_turn_with_a_start_sets_the_real_turns_beside_the_limit(stdout_of, motion):
    answer = json.loads(stdout_of(f"turn {PAPER} --json"))["motions"]["no_slip"]
    assert [turn["angle"] for turn in answer["turns"]] == [turn.angle for turn in motion.turns]
    assert answer["turns"][1]["min_tilt"] == motion.turns[1].min_tilt
    limit = rr.turn_limit(rr.bodies.can_2007(), rr.NoSlip())
    assert answer["turns"][1]["beyond_limit"] == motion.turns[1].angle - limit
    assert "202.675°" in stdout_of(f"turn {PAPER}")


@pytest.mark.parametrize(
    ("arguments", "body"),
    [
        ("", rr.bodies.can_2007()),
        ("coin", rr.bodies.coin()),
        ("soda-can --fill 50%", rr.bodies.soda_can(0.5)),
        ("cylinder --radius 3cm --length 10cm", rr.bodies.cylinder(0.03, 0.1)),
        ("ring", rr.bodies.ring()),
        ("ring --radius 10cm", rr.bodies.ring(0.1)),
        (
            "--mass 70g --radius 5.1cm --height 6.9cm --transverse-inertia 3.591e-4"
            " --axial-inertia 140kg*mm^2",
            rr.Body(0.07, 0.051, 0.069, 3.591e-4, 1.4e-4),
        ),
        (f"{CAN} --mass 80g", rr.Body(0.08, 0.051, 0.069, 3.591e-4, 1.4e-4)),
        (f"--scenario {CAN}", rr.Body(0.07, 0.051, 0.069, 3.591e-4, 1.4e-4)),
        (f"coin --scenario {CAN}", rr.bodies.coin()),
    ],
)
def test_a_body_is_a_preset_or_a_file_or_five_numbers(stdout_of, arguments, body):
    answer = json.loads(stdout_of(f"turn {arguments} --json"))
    assert answer["turn_limit"]["no_slip"] == rr.turn_limit(body, rr.NoSlip())
    assert answer["body"]["mass"] == body.mass


FRICTION = "--friction 0.2 --tilt 30deg --tilt-rate -0.5rad/s --yaw-rate 1e-5"
FLICK = rr.State(tilt=np.pi / 6, tilt_rate=-0.5, yaw_rate=1e-5)
CAN_2007 = rr.bodies.can_2007()


def test_turn_with_friction_sets_its_limit_beside_the_ideal_ones(stdout_of):
    answer = json.loads(stdout_of("turn --friction 0.2 --json"))
    assert answer["turn_limit"] == {
        "no_slip": rr.turn_limit(CAN_2007, rr.NoSlip()),
        "frictionless": rr.turn_limit(CAN_2007, rr.Frictionless()),
        "coulomb": rr.turn_limit(CAN_2007, rr.Coulomb(0.2)),
    }
    assert answer["arrivals"] == {} and answer["motions"] == {}
    text = stdout_of("turn --friction 0.2")
    assert "coulomb, friction 0.2" in text and "no-slip" in text
    assert "What depends on the arrival" in text


def test_turn_with_friction_and_a_start_has_the_limit_of_its_arrival(stdout_of):
    arrival = rr.arrival(CAN_2007, FLICK, rr.Coulomb(0.2))
    answer = json.loads(stdout_of(f"turn {FRICTION} --json"))
    assert answer["arrivals"]["coulomb"] == {
        "turn_limit": rr.turn_limit(CAN_2007, rr.Coulomb(0.2), arrival),
        "tipping_rate": arrival.tipping_rate,
        "slip": arrival.slip,
        "axial_spin": arrival.axial_spin,
        "friction_ratio": arrival.friction_ratio,
    }
    assert list(answer["motions"]) == ["coulomb"]
    assert "beyond_limit" not in answer["motions"]["coulomb"]["turns"][0]
    text = stdout_of(f"turn {FRICTION}")
    assert "210.784°" in text  # from this start
    assert "209.800°" in text  # arriving without slip
    assert "slipping outward at 3.05 cm/s" in " ".join(text.split())


def test_turn_with_friction_says_of_what_its_limit_is_as_compare_does(stdout_of):
    alone = "limit: the turn of the near-collision alone as the sideways push goes to 0"
    other = "slip before and after it changes the turn, too"
    for command in ("turn --friction 0.2", f"turn {FRICTION}", "compare --on 0.2"):
        text = " ".join(stdout_of(command).split())
        assert alone in text and other in text
    assert "alone" not in stdout_of("turn")  # the ideal limits are those of every start


def test_turn_from_a_start_that_topples_still_has_the_ideal_limits(stdout_of):
    text = stdout_of("turn --friction 0.2 --tilt 50deg")
    assert "202.287°" in text and "209.800°" in text
    assert "this start has no near-collision" in text


@pytest.mark.parametrize(
    ("arguments", "law"),
    [
        ("", rr.NoSlip()),
        ("--law noslip", rr.NoSlip()),
        ("--law no_slip", rr.NoSlip()),
        ("--law No-Slip", rr.NoSlip()),
        ("--friction 0.2", rr.Coulomb(0.2)),
        ("--friction 20%", rr.Coulomb(0.2)),
        (
            "--friction 0.2 --static-friction 0.25 --restitution 0.5",
            rr.Coulomb(0.2, 0.25, 0.5),
        ),
        ("--law coulomb --friction 0.2", rr.Coulomb(0.2)),
        ("--surface ice", rr.Coulomb(0.03)),
        ("--surface Wood --static-friction 0.5", rr.Coulomb(0.3, 0.5)),
        ("--law coulomb --surface rubber", rr.Coulomb(0.8)),
        ("--viscous-coefficient 2mN*s/mm", rr.Viscous(2.0)),
        ("--law viscous --viscous-coefficient 3", rr.Viscous(3.0)),
        ("--law stribeck --friction 0.2", rr.Stribeck(0.2)),
        (
            "--friction 0.2 --stribeck-speed 2cm/s --creep-speed 0.5mm/s",
            rr.Stribeck(0.2, stribeck_speed=0.02, creep_speed=5e-4),
        ),
        (
            "--rolling-resistance 1e-5 --rolling-viscous 1e-9 --pivoting-friction 0.1mm",
            rr.NoSlip() + rr.RollingResistance(1e-5, 1e-9) + rr.PivotingFriction(1e-4),
        ),
        ("--air-drag 1e-15", rr.NoSlip() + rr.AirDrag(1e-15)),
        ("--air-drag 1e-15 --air-exponent 2.5", rr.NoSlip() + rr.AirDrag(1e-15, 2.5)),
        ("--air-drag film", rr.NoSlip() + rr.AirDrag.film(0.051)),
    ],
)
def test_options_are_the_laws_of_the_api(stdout_of, arguments, law):
    start = "--tilt 30deg --yaw-rate 0.005 --duration 50ms"
    parameters = json.loads(stdout_of(f"simulate {start} {arguments} --json"))["parameters"]
    assert parameters["law"] == law.name
    given = {name: value for name, value in parameters.items() if name.startswith("law_")}
    assert given == {f"law_{name}": value for name, value in law.numbers.items()}


@pytest.fixture
def sticky(tmp_path):
    """A scenario with a law of its own."""
    path = tmp_path / "sticky.toml"
    path.write_text(
        '[body]\npreset = "can_2007"\n[start]\ntilt = "30 deg"\nyaw_rate = 0.005\n[law]\n'
        'kind = "coulomb"\nfriction = 0.2\nstatic = 0.3\n[law.rolling_resistance]\ndry = 1e-6\n'
        '[simulation]\nduration = "50 ms"'
    )
    return path


@pytest.mark.parametrize(
    ("arguments", "law"),
    [
        ("", rr.Coulomb(0.2, 0.3) + rr.RollingResistance(1e-6)),
        ("--friction 0.1", rr.Coulomb(0.1, 0.3) + rr.RollingResistance(1e-6)),
        ("--restitution 1", rr.Coulomb(0.2, 0.3, 1.0) + rr.RollingResistance(1e-6)),
        ("--law no-slip", rr.NoSlip() + rr.RollingResistance(1e-6)),
        ("--surface ice", rr.Coulomb(0.03) + rr.RollingResistance(1e-6)),
        ("--rolling-viscous 1e-9", rr.Coulomb(0.2, 0.3) + rr.RollingResistance(1e-6, 1e-9)),
        ("--rolling-resistance 0", rr.Coulomb(0.2, 0.3) + rr.RollingResistance(0.0)),
    ],
)
def test_options_replace_the_numbers_of_a_files_law(stdout_of, sticky, arguments, law):
    parameters = json.loads(stdout_of(f"simulate {sticky} {arguments} --json"))["parameters"]
    assert parameters["law"] == law.name
    given = {name: value for name, value in parameters.items() if name.startswith("law_")}
    assert given == {f"law_{name}": value for name, value in law.numbers.items()}


def test_turn_of_a_file_with_friction_shows_its_limit(stdout_of, sticky):
    assert "coulomb, friction 0.2, static 0.3" in stdout_of(f"turn {sticky}")


# simulate


def test_simulate_tells_how_it_ended_its_turns_and_its_events(stdout_of):
    text = stdout_of(f"simulate {PAPER}")
    assert "202.675°" in text
    assert "followed for the whole 2 s" in text
    assert "3 tilt min, 3 tilt max" in text


def test_simulate_in_json_is_the_api(stdout_of, motion):
    answer = json.loads(stdout_of(f"simulate {PAPER} --json"))
    assert answer["status"] == motion.status
    assert [turn["angle"] for turn in answer["turns"]] == [turn.angle for turn in motion.turns]
    assert [event["t"] for event in answer["events"]] == [event.t for event in motion.events]
    assert answer["parameters"].items() >= motion.parameters().items()
    assert answer["parameters"]["duration"] == 2.0


def test_options_replace_what_a_scenario_file_says(stdout_of):
    answer = json.loads(
        stdout_of(f"simulate {CAN} --duration 1s --tilt 20deg --law frictionless --json")
    )
    parameters = answer["parameters"]
    assert parameters["duration"] == 1.0
    assert parameters["start_tilt"] == np.radians(20)
    assert parameters["law"] == "frictionless"
    assert parameters["start_tilt_rate"] == -0.5  # the file's
    assert parameters["gravity"] == 9.8


def test_a_motion_that_topples_or_meets_the_table_flat_says_so(stdout_of):
    assert "toppled" in stdout_of("simulate --tilt 40deg --yaw-rate 1")
    # The paper's experiment: the can is flicked over.
    text = stdout_of("turn --tilt 20deg --tilt-rate -5rad/s --yaw-rate 0.01 --law no-slip")
    assert "toppled" in text and "202.421°" in text and "up to the end of the motion" in text
    assert "face down" in stdout_of("simulate --tilt 30deg")
    assert json.loads(stdout_of("simulate --tilt 30deg --json"))["status"] == "face_down"


def test_a_body_that_stands_can_be_knocked(stdout_of):
    text = stdout_of("simulate --tilt 0 --tilt-rate 3")
    assert "standing, knocked to a tilt rate of 3 rad/s" in text
    assert "It did not overturn. At 0.169429 s its base came down flat" in text
    answer = json.loads(stdout_of("simulate --tilt 0 --tilt-rate 3 --json"))
    shaken = json.loads(
        stdout_of("shake --tilt-rate 3 --pulse sine --amplitude 0 --period 1s --json")
    )
    assert answer["status"] == "face_down"
    assert answer["events"][0]["kind"] == "tilt_max"
    tops = [one["events"][0]["state"]["tilt"] for one in (answer, shaken)]
    assert tops[0] == pytest.approx(tops[1], rel=1e-8) and tops[0] > 0.1


def test_a_solver_that_gives_up_is_exit_code_1(capsys):
    assert main(f"simulate {PAPER} --max-steps 5".split()) == 1
    assert "after 5 steps, the limit max_steps" in capsys.readouterr().out


def test_csv_keeps_every_bit_and_every_parameter(stdout_of, motion, tmp_path):
    path = tmp_path / "can.csv"
    stdout_of(f"simulate {PAPER} -o {path}")
    lines = path.read_text().splitlines()
    comments = [line for line in lines if line.startswith("#")]
    assert "# body_mass = 0.07" in comments
    assert "# duration = 2.0" in comments
    assert f"# rimroll_version = {rr.__version__}" in comments
    header, *rows = [line for line in lines if line not in comments]
    assert header.split(",")[:3] == ["t[s]", "tilt[rad]", "tilt_rate[rad/s]"]
    table = np.array([row.split(",") for row in rows], dtype=float)
    for column, name in zip(table.T, UNITS, strict=True):
        assert np.array_equal(column, motion[name]), name
    # As documented.
    read = np.genfromtxt(path, delimiter=",", names=True, deletechars="")
    assert np.array_equal(read["tilt[rad]"], motion.tilt)
    # A spreadsheet sees one table: the comments come last.
    assert lines[0] == header and lines[-len(comments) :] == comments


def test_netcdf_opens_again_as_the_same_dataset(stdout_of, motion, tmp_path):
    path = tmp_path / "can.nc"
    stdout_of(f"simulate {PAPER} -o {path}")
    with xr.open_dataset(path) as read:
        assert read.drop_vars(["phase_kind", "phase_start", "phase_end"]).equals(motion.to_xarray())
        assert read["tilt"].attrs["units"] == "rad"
        assert read.attrs["start_tilt_rate"] == -0.5
        assert read.attrs["duration"] == 2.0


def test_json_files_also_have_the_samples(stdout_of, motion, tmp_path):
    path = tmp_path / "can.json"
    stdout_of(f"simulate {PAPER} -o {path}")
    read = json.loads(path.read_text())
    assert read["samples"]["yaw"] == motion.yaw.tolist()
    assert read["units"]["yaw"] == "rad"
    assert read["parameters"]["body"] == "can_2007"


def test_simulate_with_friction_tells_phases_and_losses(stdout_of):
    motion = rr.simulate(CAN_2007, FLICK, rr.Coulomb(0.3))
    rolling = [phase for phase in motion.phases if phase.kind == "rolling"]
    sliding = [phase for phase in motion.phases if phase.kind == "sliding"]
    text = stdout_of(f"simulate {FRICTION} --friction 0.3")
    assert f"phases: {len(rolling)} rolling" in text and f"{len(sliding)} sliding" in text
    assert f"lost {1e3 * motion.friction_loss[-1]:.4g} mJ to friction" in text
    assert f"{len(rolling) - 1} stick" in text
    rolled = stdout_of(f"simulate {PAPER}")
    assert "phases" not in rolled and "lost" not in rolled


def test_files_have_the_phases_the_losses_and_repeated_times(stdout_of, tmp_path):
    motion = rr.simulate(CAN_2007, FLICK, rr.Coulomb(0.3))
    files = [tmp_path / f"can.{suffix}" for suffix in ("csv", "nc", "json")]
    stdout_of(f"simulate {FRICTION} --friction 0.3 " + " ".join(f"-o {file}" for file in files))
    changes = len(motion.phases) - 1
    assert changes > 0

    header, *rest = files[0].read_text().splitlines()
    assert "slip_x[m/s]" in header and "friction_loss[J]" in header
    assert any(
        line.startswith("# t = ") and "once as before, once as after" in line for line in rest
    )
    t = [line.split(",")[0] for line in rest if not line.startswith("#")]
    assert 0 < len(t) - len(set(t)) <= changes

    with xr.open_dataset(files[1]) as read:
        assert [str(kind) for kind in read["phase_kind"].values] == [p.kind for p in motion.phases]
        assert read["phase_start"].values.tolist() == [p.start for p in motion.phases]
        assert read["phase_end"].values.tolist() == [p.end for p in motion.phases]
        assert "once as before, once as after" in read["t"].attrs["comment"]
        assert np.array_equal(read["slip_x"], motion["slip_x"])

    read = json.loads(files[2].read_text())
    assert [phase["kind"] for phase in read["phases"]] == [phase.kind for phase in motion.phases]
    assert read["losses"]["friction"] == motion.friction_loss[-1]
    assert read["samples"]["friction_loss"] == motion.friction_loss.tolist()
    assert "once as before, once as after" in read["comments"]["t"]


@pytest.mark.parametrize(
    ("spacing", "t"),
    [
        ("--points 5", np.linspace(0.0, 2.0, 5)),
        ("--every 500ms", np.linspace(0.0, 2.0, 5)),
        ("--every 0.6", 0.6 * np.arange(4)),
        ("--every 3s", [0.0]),
    ],
)
def test_points_can_be_evenly_spaced_in_every_table(stdout_of, motion, tmp_path, spacing, t):
    files = [tmp_path / f"can.{suffix}" for suffix in ("csv", "nc", "json")]
    stdout_of(f"simulate {PAPER} {spacing} " + " ".join(f"-o {file}" for file in files))
    expected = motion(np.asarray(t)).yaw
    assert np.array_equal(np.loadtxt(files[0], delimiter=",", skiprows=1, ndmin=2)[:, 3], expected)
    with xr.open_dataset(files[1]) as read:
        assert np.array_equal(read["yaw"], expected)
    assert json.loads(files[2].read_text())["samples"]["yaw"] == expected.tolist()


@pytest.mark.parametrize(("name", "begins"), [("can.svg", b"<?xml"), ("can.gif", b"GIF89a")])
def test_figures_and_films_are_written_by_their_suffix(stdout_of, tmp_path, name, begins):
    stdout_of(f"simulate {PAPER} --duration 20ms -o {tmp_path / name}")
    assert (tmp_path / name).read_bytes().startswith(begins)
    assert [path.name for path in tmp_path.iterdir()] == [name]


# compare


def test_compare_shows_the_papers_flick_on_ice_wood_and_rubber(stdout_of):
    lines = stdout_of(f"compare {PAPER.removesuffix(' --gravity 9.8')}").splitlines()
    ice, wood, rubber = (
        next(line for line in lines if line.startswith(name)) for name in ("ice", "wood", "rubber")
    )
    assert "0.03" in ice and "tipping" in ice
    assert "collision" in wood
    assert "202.287°" in rubber and "nowhere" in rubber
    assert any("rolling needs friction 0.2516 while tipping, 0.3558" in line for line in lines)


def test_compare_in_json_is_the_api(stdout_of):
    answer = json.loads(
        stdout_of(f"compare {FRICTION[15:]} --on ice,0.2,no-slip,frictionless --json")
    )
    laws = [rr.Coulomb(0.03), rr.Coulomb(0.2), rr.NoSlip(), rr.Frictionless()]
    assert [one["table"] for one in answer["outcomes"]] == ["ice", "0.2", "no-slip", "frictionless"]
    for one, law in zip(answer["outcomes"], laws, strict=True):
        motion = rr.simulate(CAN_2007, FLICK, law)
        arrival = rr.arrival(CAN_2007, FLICK, law)
        assert one["turn"]["angle"] == motion.turns[0].angle
        assert one["turn_limit"] == rr.turn_limit(CAN_2007, law, arrival)
        assert one["arrival"]["slip"] == arrival.slip
        lost = motion.evaluate(motion.turns[0].end).friction_loss[0] / motion.energy[0]
        # It prints the change of the energy, which is within the tolerance of 1e-10.
        assert one["energy_lost_fraction"] == pytest.approx(lost, abs=1e-11)
    assert [one["slips_while_tipping"] for one in answer["outcomes"]] == [True, True, False, True]
    assert [one["slips"] for one in answer["outcomes"]] == [True, True, False, True]


def test_compare_takes_a_files_body_and_start_and_resistances_but_not_its_friction(
    stdout_of, sticky
):
    answer = json.loads(stdout_of(f"compare {sticky} --on 0.5 --json"))["outcomes"][0]["parameters"]
    assert answer["start_tilt_rate"] == 0.0 and answer["duration"] == 0.05
    assert (answer["law_friction"], answer["law_rolling_dry"]) == (0.5, 1e-6)
    assert "law_static" not in answer


def test_compare_takes_a_files_law_as_one_more_table(stdout_of, sticky):
    of_file = rr.Coulomb(0.2, 0.3) + rr.RollingResistance(1e-6)
    for options, names in (("", "ice wood rubber file"), ("--on file,0.5", "file 0.5")):
        outcomes = json.loads(stdout_of(f"compare {sticky} {options} --json"))["outcomes"]
        assert [one["table"] for one in outcomes] == names.split()
        (parameters,) = [one["parameters"] for one in outcomes if one["table"] == "file"]
        given = {name[4:]: value for name, value in parameters.items() if name.startswith("law_")}
        assert given == of_file.numbers
    last = json.loads(stdout_of(f"compare {sticky} --restitution 1 --json"))["outcomes"][-1]
    assert last["table"] == "file" and last["parameters"]["law_restitution"] == 1.0


def test_compare_of_a_file_on_wood_has_wood_once(stdout_of, tmp_path):
    path = tmp_path / "wood.toml"
    path.write_text('[body]\npreset = "can_2007"\n[law]\nsurface = "wood"\n')
    outcomes = json.loads(stdout_of(f"compare {path} --json"))["outcomes"]
    assert [one["table"] for one in outcomes] == ["ice", "wood", "rubber"]


def test_compare_tells_where_a_table_of_friction_begins_to_slip(stdout_of, tmp_path):
    """The can needs 0.2516 while it tips and 0.3558 in the near-collision."""
    path = tmp_path / "table.toml"
    slips = []
    for static in (0.25, 0.3, 0.4):
        path.write_text(
            '[body]\npreset = "can_2007"\n[start]\ntilt = "30 deg"\ntilt_rate = -0.5\n'
            'yaw_rate = 0.005\nspin_rate = 0.005\n[law]\nkind = "tabulated"\n'
            f"speeds = [0, 1]\nfrictions = [0.2, 0.1]\nstatic = {static}\n"
        )
        (row,) = [
            line for line in stdout_of(f"compare {path} --on file").splitlines() if "%" in line
        ]
        assert row.startswith("file   0.1 to 0.2 ")
        slips.append(row.split()[6])
    assert slips == ["tipping", "collision", "nowhere"]


def test_compare_of_a_flick_that_topples_says_so_once_and_in_degrees(stdout_of):
    text = stdout_of("compare --tilt 50deg")
    assert text.count("toppled") == 3
    assert text.count("past the balance tilt of this body, 36.47°") == 1
    assert " rad " not in text and "try --tilt 18deg" in text


@pytest.mark.parametrize("suffix", ["svg", "png", "pdf"])
@pytest.mark.slow
def test_compare_draws_itself(stdout_of, tmp_path, suffix):
    path = tmp_path / f"compare.{suffix}"
    assert f"wrote {path}" in stdout_of(f"compare --on 0.1,rubber -o {path}")
    assert path.read_bytes()[:4] in (b"<?xm", b"\x89PNG", b"%PDF")


# bodies and reproduce


def test_bodies_lists_every_preset_with_its_numbers_and_origin(stdout_of):
    text = stdout_of("bodies")
    for name in rr.bodies.PRESETS:
        assert name in text
    assert "Quantitative comparisons" in text
    listed = json.loads(stdout_of("bodies --json"))["bodies"]
    assert listed["coin"]["mass"] == 0.0075
    assert listed["cylinder"]["arguments"] == ["radius", "length", "mass", "density"]


@pytest.fixture
def short_report(monkeypatch):
    """Replaces the long report by a page with one word."""

    def reproduce(folder, progress=None):
        progress(0, 1, "the page")
        folder.mkdir(parents=True, exist_ok=True)
        page = folder / "index.html"
        page.write_text("whole")
        return page

    monkeypatch.setattr("rimroll.paper.report.reproduce", reproduce)


def test_reproduce_says_last_where_the_report_is(stdout_of, short_report, monkeypatch, tmp_path):
    monkeypatch.chdir(tmp_path)
    text = stdout_of("reproduce")
    page = tmp_path / "out" / "paper" / "index.html"
    assert text.splitlines()[-1] == f"The report is at {page}"
    assert page.read_text() == "whole"
    assert json.loads(stdout_of("reproduce -o elsewhere --json")) == {
        "report": str(tmp_path / "elsewhere" / "index.html")
    }


# how it starts and ends


FALLS = Path(__file__).parents[2] / "examples/falls_of_the_paper.csv"
QUICK = {
    "turn --tilt 30deg --yaw-rate 1deg/s": "matplotlib jinja2 scipy",
    "topple can_2007 -o falls.csv -o falls.json": "matplotlib jinja2 scipy",
    f"fit {FALLS}": "matplotlib jinja2",
    "topple --friction 0.2 --json": "matplotlib jinja2 scipy",
    "topple -o falls.svg": "",
    "map --starts 4 --friction 0.2 -o map.csv": "matplotlib jinja2 scipy",
    "map --starts 4 -o map.svg": "jinja2",
}
"""Commands, and packages that they do not need, besides xarray and pandas."""


@pytest.mark.parametrize("command", QUICK)
@pytest.mark.slow
def test_a_command_loads_nothing_slow_that_it_has_no_use_for(command, tmp_path):
    unused = ["xarray", "pandas", "pint", *QUICK[command].split()]
    script = (
        f"import sys; from rimroll.cli import main; assert main({command.split()}) == 0;"
        f" print([name for name in {unused} if name in sys.modules])"
    )
    run = subprocess.run(
        [sys.executable, "-c", script], capture_output=True, text=True, cwd=tmp_path
    )
    assert run.stdout.splitlines()[-1:] == ["[]"], run.stderr


def test_the_package_runs_as_a_module_and_where_there_are_no_degree_signs():
    run = subprocess.run(
        [sys.executable, "-m", "rimroll.cli", "turn"],
        env={**os.environ, "PYTHONIOENCODING": "ascii"},
        capture_output=True,
        text=True,
    )
    assert (run.returncode, run.stderr) == (0, "")
    assert "202.287?" in run.stdout
