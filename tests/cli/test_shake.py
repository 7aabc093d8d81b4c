"""``rimroll shake``: the ground from options and files, answers, files and errors."""

import csv
import json
import math
from pathlib import Path

import numpy as np
import pytest
import xarray as xr

import rimroll as rr
from given.motions import CAN, same_bits
from rimroll.cli.simulate import UNDECIDED
from rimroll.scenario import load

EXAMPLES = Path(__file__).parents[2] / "examples"
COLUMN = EXAMPLES / "column.toml"
RECORD = [EXAMPLES / f"synthetic_{name}.at2" for name in ("000", "090", "up")]
FILES = " ".join(map(str, RECORD))
PULSE = "shake --pulse sine --amplitude 0.9g --period 0.3s"


@pytest.fixture(scope="module")
def column():
    return load(COLUMN).body


def shaken(body, ground, law, flat=None, **options):
    duration = ground.duration + 10.0
    return rr.simulate(
        body, rr.State.standing(), law, duration, ground=ground, flat=flat, **options
    )


def test_a_record_in_json_is_the_api(stdout_of, column):
    command = f"shake {COLUMN} --record {FILES} --scale 1.2 --flat housner --json"
    answer = json.loads(stdout_of(command))
    ground = rr.ground.read(*RECORD).scaled(1.2)
    motion = shaken(column, ground, rr.Coulomb(0.6), "housner", gravity=9.81)
    assert answer["parameters"].items() >= motion.parameters().items()
    assert answer["status"] == motion.status
    result = answer["shaken"]
    for name in ("overturned", "overturning_time", "uplift_time", "max_tilt", "max_tilt_ratio"):
        assert result[name] == getattr(motion, name)
    assert result["stands"] is motion.stands is False
    assert result["residual_displacement"] is result["residual_yaw"] is None
    assert result["ground_peak"]["x"] == ground.peak.x
    assert answer["losses"]["friction"] == motion.friction_loss[-1]


@pytest.mark.parametrize(
    "files", [f"--record {FILES}", FILES, " ".join(f"--record {file}" for file in RECORD)]
)
def test_files_of_a_record_may_be_given_in_any_of_these_ways(stdout_of, files):
    answer = json.loads(stdout_of(f"shake {COLUMN} {files} --duration 3s --json", UNDECIDED))
    assert answer["shaken"]["ground_peak"]["x"] == rr.ground.read(*RECORD).peak.x
    bodiless = json.loads(stdout_of(f"shake {files} --duration 3s --json", UNDECIDED))
    assert bodiless["parameters"]["body_radius"] == CAN.radius
    assert bodiless["shaken"]["ground_peak"] == answer["shaken"]["ground_peak"]


def test_headings_take_the_place_of_second_lines(tmp_path, stdout_of, error_of):
    files = [tmp_path / f"{name}.at2" for name in "xyz"]
    for file, record in zip(files, RECORD, strict=True):
        lines = record.read_text("utf-8").splitlines()
        lines[1] = "no direction here"
        file.write_text("\n".join(lines), "utf-8")
    given = f"shake {COLUMN} --record {' '.join(map(str, files))} --duration 3s --json"
    assert "on the command line --headings 0,90,up" in error_of(given.removesuffix(" --json"))
    answer = json.loads(stdout_of(f"{given} --headings 0,90,up", UNDECIDED))
    peak = rr.ground.read(*RECORD).peak
    assert answer["shaken"]["ground_peak"] == peak._asdict()
    scenario = tmp_path / "c.toml"
    names = ", ".join(f'"{file.name}"' for file in files)
    scenario.write_text(
        f'[body]\npreset = "coin"\n[ground]\nrecord = [{names}]\nheadings = ["0", "90", "up"]\n'
    )
    assert load(scenario).ground.peak == peak


@pytest.mark.parametrize(
    ("options", "ground"),
    [
        ("sine --amplitude 0.9g --period 0.3s", rr.ground.sine("0.9 g", 0.3)),
        ("cosine --amplitude 9,1,0 --period 0.3 --cycles 2,3,1",
         rr.ground.cosine((9.0, 1.0, 0.0), 0.3, (2, 3, 1))),
        ("half-sine --amplitude 9m/s2 --pulse-duration 200ms", rr.ground.half_sine(9.0, 0.2)),
        ("rectangular --amplitude 900gal --pulse-duration 0.2s", rr.ground.rectangular(9.0, 0.2)),
        ("ricker --amplitude 9 --period 0.4 --center 1s", rr.ground.ricker(9.0, 0.4, 1.0)),
        ("sine --amplitude 9 --period 0.3 --scale 50% --rotate 90deg",
         rr.ground.sine(9.0, 0.3).scaled(0.5).rotated(math.pi / 2)),
    ],
)  # fmt: skip
def test_pulses_are_those_of_the_api(stdout_of, options, ground):
    motion = shaken(CAN, ground, rr.NoSlip())
    code = UNDECIDED if motion.overturned is None else 0
    answer = json.loads(stdout_of(f"shake --pulse {options} --json", code))
    assert answer["parameters"].items() >= motion.parameters().items()
    assert answer["shaken"]["max_tilt"] == motion.max_tilt


def test_a_lean_replaces_the_standing_start(stdout_of):
    text = f"{PULSE} --tilt 5deg --yaw 30deg --duration 1s --friction 0.3 --flat smooth:4 --json"
    given = json.loads(stdout_of(text))["parameters"]
    assert given["start_tilt"] == math.radians(5.0) and given["start_yaw"] == math.radians(30.0)
    assert given["flat"] == "smooth:4" and given["duration"] == 1.0
    assert json.loads(stdout_of(f"{PULSE} --yaw 30deg --json"))["parameters"]["start_tilt"] == 0.0


def test_it_tells_what_became_of_the_body(stdout_of):
    text = stdout_of(f"shake {COLUMN} --record {FILES} --scale 1.2")
    assert "The ground: 1001 samples at 0.02 s, 20 s" in text
    assert "standing flat; gravity 9.81 m/s²" in text
    assert "The body was lifted at 1.99528 s." in text and "It overturned at 12.8104 s." in text
    calm = stdout_of(f"shake {COLUMN} --scale 0.5")
    assert "The body was never lifted. It did not overturn" in calm
    assert "--flat" not in stdout_of(PULSE)


@pytest.mark.parametrize(
    ("command", "status", "words"),
    [
        (f"{PULSE} --flat stop", "face_down", "where the body came down flat. --flat housner"),
        (f"shake {RECORD[0]} --duration 2s", "finished", "the ground moves until 20 s --duration"),
        ("shake --pulse rectangular --amplitude 0,0,-1.5g --pulse-duration 1s --tilt 3deg",
         "lifted_off", "--friction"),
        ("shake --pulse sine --amplitude 1mm/s2 --period 10ms --tilt 30deg --tilt-rate 3rad/s"
         " --duration 30ms", "finished", "it can still pass its balance tilt --duration"),
    ],
)  # fmt: skip
def test_a_motion_that_stops_early_is_undecided(stdout_of, command, status, words):
    text = stdout_of(command, UNDECIDED)
    assert "It is undecided whether it overturns" in text and "did not overturn" not in text
    assert all(part in text for part in words.split(" --"))
    answer = json.loads(stdout_of(f"{command} --json", UNDECIDED))
    assert answer["status"] == status and answer["shaken"]["overturned"] is None
    assert answer["shaken"]["residual_yaw"] is answer["shaken"]["residual_displacement"] is None


def test_a_body_that_still_rocks_has_no_residual_place(stdout_of):
    """Two components and no losses: the wobble goes on for ever."""
    pulse = "shake --pulse sine --amplitude 0.85g,0.3g,0 --period 0.3s,0.2s,1s"
    text = stdout_of(pulse)
    assert "It did not overturn. At 10.3 s it still rocks, up to" in text
    assert "% of its energy; nothing in this law takes its energy" in text
    assert "undecided" in text and "displaced" not in text
    assert json.loads(stdout_of(f"{pulse} --json"))["shaken"]["residual_yaw"] is None


def test_the_default_of_a_flat_landing_is_that_of_fragility(stdout_of, tmp_path):
    file = tmp_path / "flat.toml"
    for given, flat in (("", "housner"), ('[simulation]\nflat = "stop"\n', "stop")):
        file.write_text(f'[body]\npreset = "coin"\n[ground]\npulse = "sine"\n'
                        f'amplitude = 1e-3\nperiod = 1\n{given}')  # fmt: skip
        for command in ("shake", "simulate", "fragility --scale 1,2"):
            name, _, more = command.partition(" ")
            answer = json.loads(stdout_of(f"{name} {file} --json {more}"))
            assert answer["parameters"]["flat"] == flat


def test_a_gap_is_that_of_the_api(stdout_of, column):
    text = stdout_of(f"shake {COLUMN} --flat-gap 0.1mm --scale 1.2 --json")
    ground = load(COLUMN).ground.scaled(1.2)
    law = rr.Coulomb(0.6)
    motion = shaken(column, ground, law, flat_gap=1e-4, gravity=9.81)
    answer = json.loads(text)
    assert answer["parameters"]["flat_gap"] == 1e-4
    assert answer["shaken"]["max_tilt"] == motion.max_tilt
    assert answer["losses"]["impact"] == motion.impact_loss[-1] > 0.0


def test_simulate_follows_a_file_with_a_ground_too(stdout_of):
    one, other = (
        json.loads(stdout_of(f"{name} {COLUMN} --json")) for name in ("shake", "simulate")
    )
    assert one == other and one["shaken"]["uplift_time"] > 0.0


def test_files_hold_the_motion_and_the_ground(tmp_path, stdout_of, column):
    paths = [tmp_path / f"c.{suffix}" for suffix in ("csv", "nc", "json")]
    outputs = " ".join(f"-o {path}" for path in paths)
    stdout_of(f"shake {COLUMN} --duration 8s --every 0.5s {outputs}", UNDECIDED)
    ground = load(COLUMN).ground
    with xr.open_dataset(paths[1]) as stored:
        motion = rr.Motion.from_xarray(stored)
        np.testing.assert_array_equal(stored["ground_x"], ground(stored["t"].values)[:, 0])
        feet = np.stack([stored["footprint_x"], stored["footprint_y"]], axis=-1)
        np.testing.assert_allclose(
            feet[-1] - feet[0], motion.footprint[-1] - motion.footprint[0], atol=1e-12
        )
    direct = rr.simulate(
        column, rr.State.standing(), rr.Coulomb(0.6), 8.0, ground=ground, flat="housner",
        gravity=9.81,
    )  # fmt: skip
    assert motion.ground == ground and same_bits(motion, direct)
    lines = paths[0].read_text().splitlines()
    rows = list(csv.DictReader(line for line in lines if not line.startswith("#")))
    t = np.array([float(row["t[s]"]) for row in rows])
    assert t == pytest.approx(0.5 * np.arange(17))
    assert [float(row["ground_y[m/s^2]"]) for row in rows] == ground(t)[:, 1].tolist()
    assert "# flat = housner" in lines
    samples = json.loads(paths[2].read_text())["samples"]
    assert samples["ground_z"] == ground(samples["t"])[:, 2].tolist()


@pytest.mark.slow
def test_pictures_and_films_are_written(tmp_path, stdout_of):
    stdout_of(f"shake {COLUMN} --duration 4s -o {tmp_path}/c.svg -o {tmp_path}/c.gif", UNDECIDED)
    assert (tmp_path / "c.svg").stat().st_size > 10_000
    assert (tmp_path / "c.gif").read_bytes()[:3] == b"GIF"


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ("shake", "nothing says how the ground moves: give --record, --pulse or a file"),
        ("shake --scale 2", "nothing says how the ground moves"),
        ("shake --period 1s", "--period needs --pulse"),
        ("shake --pulse sin", "did you mean 'sine'?"),
        ("shake --pulse sine --amplitude 3", "the pulse sine needs --period"),
        ("shake --pulse rectangular --amplitude 3 --pulse-duration -1s", "--pulse-duration must"),
        ("shake --pulse ricker --amplitude 3 --period 1 --cycles 2", "--cycles does not go with"),
        ("shake --pulse sine --amplitude 3,1 --period 1", "--amplitude must be one or three"),
        ("shake --pulse sine --amplitude 3kg --period 1", "--amplitude"),
        (f"{PULSE} --scale 0", "--scale must be between 1e-6 and 1e6, got 0"),
        (f"shake {COLUMN} --scale 0", "--scale must be between 1e-6 and 1e6, got 0"),
        (f"{PULSE} --headings 0", "--headings needs --record"),
        (f"shake {RECORD[0]} --headings 0,90", "headings must be one for each file, 1, got 2"),
        (f"{PULSE} --flat 2", "restitution must be between 0 and 1, got 2"),
        (f"{PULSE} --flat plastic", "must be one of stop, smooth"),
        (f"shake {COLUMN} --flat-gap 1m", "--flat-gap must be between 0 and 0.05, a tenth of the"),
        (f"{PULSE} --flat-gap 1kg", "--flat-gap must be a length"),
        (f"{PULSE} --yaw-rate 1", "--yaw-rate is for a body that leans: give a tilt"),
        ("shake --tilt-rate 1", "--tilt 0 a body stands, and --tilt-rate is a knock"),
        ("shake --record nosuch.at2", "nosuch.at2"),
        (f"shake {RECORD[0]} {RECORD[0]}", "are all horizontal|must be perpendicular"),
        (f"turn {COLUMN}", "[ground], flat and flat_gap are for rimroll simulate, shake"),
    ],
)
def test_errors_are_one_line_that_names_the_option(error_of, arguments, message):
    error = error_of(arguments)
    assert len(error.splitlines()) == 1
    assert any(part in error for part in message.split("|"))


@pytest.mark.parametrize(
    ("ground", "message"),
    [
        ("{}", "[ground] lacks 'record' or 'pulse'"),
        ('{ pulse = "sine", amplitude = 3 }', "[ground] the pulse sine needs period"),
        ('{ pulse = "sine", amplitude = [1, 2], period = 1 }', "amplitude must be one or three"),
        ('{ pulse = "sine", amplitude = 1, period = 1, color = 2 }', "unknown key 'color'"),
        ('{ record = "nosuch.csv" }', "nosuch.csv"),
        ('{ pulse = "sine", amplitude = 3, period = 1, scale = 0 }', "scale must be between 1e-6"),
    ],
)
def test_errors_in_a_files_ground_name_the_table(tmp_path, ground, message):
    path = tmp_path / "shaken.toml"
    path.write_text(f'ground = {ground}\n[body]\npreset = "coin"\n')
    with pytest.raises(rr.RimrollError) as raised:
        load(path)
    assert message in str(raised.value) and str(raised.value).startswith(str(path))


def test_a_files_ground_and_flat_are_those_of_the_api(tmp_path):
    path = tmp_path / "shaken.toml"
    path.write_text(
        '[body]\npreset = "coin"\n[simulation]\nflat = ["smooth", 3]\nflat_gap = "0.1 mm"\n'
        '[ground]\npulse = "cosine"\n'
        'amplitude = ["0.3 g", 1, 0]\nperiod = "500 ms"\ncycles = [1, 2, 1]\nscale = 2\n'
    )
    read = load(path)
    assert read.ground == rr.ground.cosine(("0.3 g", 1.0, 0.0), 0.5, (1, 2, 1)).scaled(2.0)
    assert read.options.flat == ("smooth", 3) and read.options.flat_gap == 1e-4
    assert read.options.duration == 1.0 + 10.0 and not read.has_duration
