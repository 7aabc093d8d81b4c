"""Every error gives one clear message, no traceback, and no half-written file."""

import errno
import os
import pickle
import subprocess
import sys

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import rimroll as rr
from given.ctrl_c import interrupt_when, needs_signals, running
from rimroll import cli
from rimroll.cli import files
from rimroll.errors import UnitError

CAN = rr.bodies.can_2007()
NUMBERS = {
    "mass": 0.07,
    "radius": 0.051,
    "height": 0.069,
    "transverse_inertia": 3.591e-4,
    "axial_inertia": 1.4e-4,
}
NOT_FINITE = [np.nan, np.inf, -np.inf]

# The API


@pytest.mark.parametrize("field", NUMBERS)
@pytest.mark.parametrize("value", [*NOT_FINITE, "light", "7 s", None, True])
def test_a_body_is_made_of_finite_numbers(field, value):
    with pytest.raises(rr.RimrollError, match=f"^{field} must be"):
        rr.Body(**{**NUMBERS, field: value})


@pytest.mark.parametrize("field", ["mass", "radius", "transverse_inertia", "axial_inertia"])
@pytest.mark.parametrize("value", [0.0, -0.05])
def test_a_body_has_mass_radius_and_inertia(field, value):
    with pytest.raises(rr.RimrollError, match=f"^{field} must be > 0, got {value:g}"):
        rr.Body(**{**NUMBERS, field: value})


def test_a_centre_of_mass_is_not_under_the_table():
    with pytest.raises(rr.RimrollError, match=r"^height must be >= 0"):
        rr.Body(**{**NUMBERS, "height": -0.01})


def test_no_rigid_body_has_c_above_2a():
    with pytest.raises(rr.RimrollError, match=r"^axial_inertia must be at most 2 transverse"):
        rr.Body(**{**NUMBERS, "axial_inertia": 2.01 * NUMBERS["transverse_inertia"]})


@pytest.mark.parametrize("field", ["tilt", "tilt_rate", "yaw", "yaw_rate", "spin", "spin_rate"])
@pytest.mark.parametrize("value", [*NOT_FINITE, "half", None])
def test_a_state_is_made_of_finite_numbers(field, value):
    with pytest.raises(rr.RimrollError, match=f"^{field} must be"):
        rr.State(**{"tilt": 0.5, field: value})


@pytest.mark.parametrize("tilt", [0.0, -0.1, np.pi, 4.0])
def test_a_tilt_is_inside_0_and_pi(tilt):
    with pytest.raises(rr.RimrollError, match=r"^tilt must be inside \(0, pi\), got"):
        rr.State(tilt=tilt)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"tilt": [0.5, np.nan]}, "tilt[1] must be finite, got nan"),
        ({"tilt": [0.5, 0.4, -0.1]}, "tilt[2] must be inside (0, pi), got -0.1 rad"),
        ({"yaw_rate": [[0.1, 0.2], [np.inf, np.nan]]}, "yaw_rate[1, 0] must be finite, got inf"),
    ],
)
def test_an_element_of_an_array_that_is_at_fault_is_named(change, message):
    with pytest.raises(rr.RimrollError) as refusal:
        rr.State(**{"tilt": 0.5, **change})
    assert str(refusal.value) == message


def test_arrays_of_a_state_agree_in_shape():
    with pytest.raises(rr.RimrollError, match=r"agree in shape, got tilt \(2,\), yaw_rate \(3,\)"):
        rr.State(tilt=np.full(2, 0.5), yaw_rate=np.zeros(3))


@pytest.mark.parametrize(
    ("option", "value", "says"),
    [
        *(("duration", value, "duration must be") for value in (*NOT_FINITE, 0.0, -2.0, "2 m")),
        *(("gravity", value, "gravity must be") for value in (*NOT_FINITE, 0.0, -9.8)),
        *(("rtol", value, "rtol must be") for value in (*NOT_FINITE, 0.0, -1e-6, 1.0)),
        *(("topple_tilt", value, "topple_tilt must be") for value in (np.nan, 0.0, 3.0)),
        ("topple_tilt", 0.4, "tilt must be below topple_tilt"),
        ("max_steps", 0, "max_steps must be"),
        ("max_steps", 2**70, r"max_steps must be below 2\^53"),
    ],
)
def test_a_simulation_has_a_span_a_pull_and_a_tolerance(option, value, says):
    with pytest.raises(rr.RimrollError, match=f"^{says}"):
        rr.simulate(CAN, rr.State(tilt=0.5, yaw_rate=0.1), rr.NoSlip(), **{option: value})


@pytest.mark.parametrize(
    "call",
    [
        lambda progress: rr.topple(CAN, rr.NoSlip(), 3, progress=progress),
        lambda progress: rr.predict_falls(CAN, progress=progress),
        lambda progress: rr.fit(CAN, np.full(9, 3.8), progress=progress),
        lambda progress: rr.simulate(CAN, rr.State(tilt=0.5, yaw_rate=0.1), rr.NoSlip()).animate(
            "can.gif", progress=progress
        ),
    ],
    ids=["topple", "predict_falls", "fit", "animate"],
)
def test_progress_is_something_to_call(call):
    with pytest.raises(rr.RimrollError, match="progress must be None or something to call, got 3"):
        call(3)


def test_simulate_follows_one_start():
    starts = rr.State(tilt=np.array([0.4, 0.5]))
    with pytest.raises(rr.RimrollError, match=r"one start, got arrays of shape \(2,\)"):
        rr.simulate(CAN, starts, rr.NoSlip())


def test_errors_about_unknown_bodies_and_laws_list_the_known_ones():
    with pytest.raises(rr.RimrollError, match="unknown body 'soda': did you mean 'soda_can'"):
        rr.bodies.by_name("soda")
    with pytest.raises(rr.RimrollError, match="unknown law 'sticky': did you mean 'stribeck'"):
        rr.laws.by_name("sticky")


REFUSED = {
    "a body": (lambda: rr.Body(**{**NUMBERS, "mass": -0.07}), "mass", -0.07, "> 0", "kg", ()),
    "one of many": (
        lambda: rr.State(tilt=[0.5, -0.1], yaw_rate=0.1),
        *("tilt", -0.1, "inside (0, pi)", "rad", (1,)),
    ),
    "a body of a grid": (
        lambda: rr.Body(**{**NUMBERS, "height": rr.axis("h", [0.1, -1.0]), "radius": 0.02}),
        *("height", -1.0, ">= 0", "m", (1,)),
    ),
    "a law": (
        lambda: rr.Coulomb([0.1, 0.2, -0.3]),
        *("friction", -0.3, "between 0 and 1e6", "", (2,)),
    ),
    "an entry of a table": (
        lambda: rr.Tabulated([0.0, 1.0, 2.0], [0.1, -0.2, 0.3]),
        *("frictions", -0.2, "between 0 and 1e6", "", (1,)),
    ),
    "a length": (
        lambda: rr.Tabulated([0.0], [0.1]),
        *("speeds", 1, "at least 2 entries", "", ()),
    ),
    "an option": (
        lambda: rr.simulate(CAN, rr.State(tilt=0.5), rr.NoSlip(), rtol=1.0),
        *("rtol", 1.0, "between 1e-14 and 1e-3", "", ()),
    ),
    "a start of many": (
        lambda: rr.ensemble(CAN, rr.State(tilt=[0.1, 0.3]), rr.NoSlip(), topple_tilt=0.2),
        *("tilt", 0.3, "below topple_tilt = 0.2 rad", "rad", (1,)),
    ),
    "a closed form": (
        lambda: rr.lift_off_rate(CAN, [9.8, -9.8]),
        *("gravity", -9.8, "> 0", "m/s2", ()),
    ),
    "a count": (
        lambda: rr.topple(CAN, rr.NoSlip(), 2, threads=5000),
        *("threads", 5000, "at most 1024", "", ()),
    ),
    "a text": (
        lambda: rr.State(tilt="3 cm"),
        *("tilt", "3 cm", 'an angle such as "30 deg" (plain numbers are in rad)', "", ()),
    ),
}


@pytest.mark.parametrize("name", REFUSED)
def test_an_error_about_a_value_holds_its_parts(name):
    call, *parts = REFUSED[name]
    with pytest.raises(rr.RimrollError) as refusal:
        call()
    error = refusal.value
    assert [error.field, error.value, error.bound, error.unit, error.index] == parts
    assert f"{error.field}{list(error.index) or ''} must " in str(error)
    assert error.bound in str(error)


@given(
    name=st.sampled_from(sorted(REFUSED)),
    index=st.lists(st.integers(0, 9), max_size=2),
    word=st.sampled_from(["--word", "friction in the link"]),
    places=st.lists(st.sampled_from(["my_cup.toml:", "[law]", "row 7:"]), max_size=3),
)
def test_an_error_comes_out_of_another_process_as_it_was(name, index, word, places):
    with pytest.raises(rr.RimrollError) as refusal:
        REFUSED[name][0]()
    error = refusal.value
    renamed = error.at(index).called({error.field: word})
    for place in reversed(places):
        renamed = renamed.inside(place)
    begin = "".join(f"{place} " for place in (*places, error.where) if place)
    assert str(renamed).startswith(f"{begin}{word}{index or ''} must ")
    for one in (error, renamed):
        other = pickle.loads(pickle.dumps(one))
        assert type(other) is type(one)
        assert (str(other), vars(other)) == (str(one), vars(one))


def test_an_error_of_a_start_without_near_collision_is_pickled_with_its_ending():
    with pytest.raises(rr.errors.NoNearCollision) as refusal:
        rr.arrival(CAN, rr.State(tilt=1.2, tilt_rate=9.0), rr.NoSlip())
    error = pickle.loads(pickle.dumps(refusal.value)).inside("row 3:")
    assert str(error) == f"row 3: {refusal.value}"
    assert (error.status, error.in_degrees) == (refusal.value.status, refusal.value.in_degrees)


def test_an_error_about_a_unit_says_what_is_wrong_with_it():
    with pytest.raises(UnitError) as refusal:
        rr.State(tilt="3 cm")
    assert pickle.loads(pickle.dumps(refusal.value)).why == '"cm" does not measure an angle'


# The command line


@pytest.fixture
def complaint(capsys, monkeypatch, tmp_path):
    """Runs a command that must fail, in an empty folder; returns the one line that it prints."""
    monkeypatch.chdir(tmp_path)

    def run(arguments, code=2):
        before = sorted(tmp_path.rglob("*"))
        assert cli.main(arguments.split()) == code
        captured = capsys.readouterr()
        assert captured.out == ""
        assert sorted(tmp_path.rglob("*")) == before
        return one_line(captured.err)

    return run


def one_line(text):
    assert text.startswith("rimroll: ") and text.endswith("\n")
    assert text.count("\n") == 1
    assert "Traceback" not in text and "╭" not in text
    return text.removeprefix("rimroll: ").rstrip("\n")


def body(**changed):
    numbers = {name.replace("_", "-"): value for name, value in {**NUMBERS, **changed}.items()}
    return " ".join(f"--{name} {value}" for name, value in numbers.items())


@pytest.mark.parametrize(
    ("arguments", "says"),
    [
        ("turn " + body(mass="nan"), '--mass must be a mass such as "70 g"'),
        ("turn " + body(mass="inf"), "not a finite number"),
        ("turn " + body(mass="-70g"), "mass must be > 0, got -0.07 kg"),
        ("turn " + body(radius="0cm"), "radius must be > 0, got 0 m"),
        ("turn " + body(radius="5.1foo"), 'unknown unit "foo"'),
        ("turn " + body(radius="70g"), '"g" does not measure a length'),
        ("turn " + body(axial_inertia="0.9"), "--axial-inertia must be at most 2"),
        ("turn --mass 70g --radius 5cm", "also needs --height, --transverse-inertia"),
        ("turn soda", "unknown body 'soda': did you mean 'soda_can'? Known: can_2007"),
        ("turn xyz", "unknown body 'xyz': choose from can_2007"),
        ("turn can_2007 --fill 0.5", "--fill does not go with can_2007"),
        ("turn soda_can --fill 150%", "--fill must be between 0 and 1, got 1.5"),
        (
            "turn soda_can --fill 50",
            "--fill must be between 0 and 1, got 50: for percent write 0.5",
        ),
        ("turn " + body(mass="70"), '--mass: 70 is read as 70 kg; with its unit write "70 g" or'),
        ("turn " + body(radius="5.1"), '--radius: 5.1 is read as 5.1 m; with its unit write "5.1'),
        ("turn ring --radius 33", 'write "33 mm" or "33 cm" or "33 m"'),
        ("turn " + body(axial_inertia="140"), 'write "140 kg mm^2" or "140 kg m^2"'),
        ("measure --mass 70 --radius 5.1cm", "--mass: 70 is read as 70 kg"),
        ("measure --mass 70g --radius 5.1", "--radius: 5.1 is read as 5.1 m; with its unit write"),
        ("turn soda_can --radius 3cm", "--radius does not go with soda_can (its options: --fill)"),
        ("turn disk", "disk needs --radius"),
        ("turn --length 3cm", "--length is for a preset"),
        ("turn --law sticky", "unknown law 'sticky': did you mean 'stribeck'? Known: no-slip,"),
        ("turn --law colomb", "unknown law 'colomb': did you mean 'coulomb'?"),
        ("turn --law coulomb", "coulomb needs --friction"),
        ("turn --law viscous", "viscous needs --viscous-coefficient"),
        ("turn --static-friction 0.3", "coulomb needs --friction"),
        (
            "turn --law no-slip --friction 0.3",
            "--friction does not go with no-slip, which takes no",
        ),
        ("turn --law noslip --restitution 0.3", "--restitution does not go with no-slip"),
        ("turn --restitution 0.3", "--restitution does not go with no-slip"),
        (
            "turn --law viscous --friction 1",
            "--friction does not go with viscous, which takes --visc",
        ),
        ("turn --friction 0.3 --stribeck-speed nan", "--stribeck-speed must be a speed"),
        ("turn --friction -0.1", "friction must be between 0 and 1e6, got -0.1"),
        ("turn --friction nan", '--friction must be a pure number such as "0.5", got "nan"'),
        ("turn --friction inf", "not a finite number"),
        ("turn --friction wood", "begin with a number; for this table write --surface wood"),
        ("turn --friction no-slip", "begin with a number; for this law write --law no-slip"),
        ("turn --static-friction oak", "the tables that have a name are ice, teflon, wood, steel"),
        ("compare --on file", "--on file is the law of a scenario file: name one"),
        ("turn --friction rough", "it does not begin with a number"),
        ("turn --friction 0.1,0.2", "decimals follow a point"),
        ("turn --friction [0.1]", "it does not begin with a number"),
        ("turn --friction 30deg", '"deg" does not measure a pure number'),
        (
            "turn --friction 0.3 --static-friction 0.2",
            "--static-friction must be between --friction = 0.3 and 1e6, got 0.2",
        ),
        ("turn --friction 0.3 --restitution 2", "restitution must be between 0 and 1, got 2"),
        ("turn --viscous-coefficient -1", "--viscous-coefficient must be >= 0, got -1 N s/m"),
        ("turn --viscous-coefficient 3cm", '"cm" does not measure a viscous resistance'),
        ("turn --friction 0.3 --creep-speed 0", "--creep-speed must be > 0, got 0 m/s"),
        ("turn --friction 0.3 --creep-speed 1s", '"s" does not measure a speed'),
        ("turn --surface woof", "unknown surface 'woof': did you mean 'wood'? Known: ice,"),
        ("turn --surface wood --friction 0.3", "--surface and --friction: give one"),
        ("turn --surface wood --law no-slip", "--surface is dry friction and --law is no-slip"),
        ("turn --rolling-resistance -1", "--rolling-resistance must be >= 0, got -1"),
        ("turn --rolling-resistance 1m", '"m" does not measure a pure number'),
        ("turn --rolling-viscous 1m", '"m" does not measure a viscous resistance'),
        ("turn --pivoting-friction -1mm", "--pivoting-friction must be >= 0, got -0.001 m"),
        ("turn --pivoting-friction 1kg", '"kg" does not measure a length'),
        ("turn --air-drag -1", "--air-drag must be >= 0, got -1 W (s/rad)^exponent"),
        ("turn --air-drag 1m", '"m" does not measure a coefficient of air drag'),
        ("turn --air-drag 1e-9 --air-exponent 9", "--air-exponent must be between 1.5 and 8"),
        ("turn --air-exponent 4", "--air-exponent needs --air-drag"),
        ("turn --air-drag film --air-exponent 4", "leave out --air-exponent"),
        ("compare --on woof", "unknown surface 'woof': did you mean 'wood'?"),
        ("compare --on ice,,wood", "--on must be a list such as ice,wood,0.5, got a gap"),
        ("compare --on ice,ice", "--on has 'ice' twice"),
        ("compare --on -0.1", "friction must be between 0 and 1e6, got -0.1"),
        ("compare --on nan", "not a finite number"),
        ("compare --on 3cm", '"cm" does not measure a pure number'),
        ("compare --restitution 2", "restitution must be between 0 and 1, got 2"),
        ("compare --tilt 0", "which rimroll simulate and shake can start"),
        ("compare -o can.csv", "its suffix must be one of .png, .svg, .pdf"),
        ("compare -o none/can.svg", "cannot write none/can.svg: there is no folder none"),
        ("compare -o can.svg --on .1,.2,.3,.4,.5,.6,.7", "at most 6 tables, got 7"),
        ("turn --yaw-rate 1", "a start needs --tilt"),
        ("turn nothing.toml", "nothing.toml: there is no such file"),
        ("turn --scenario nothing.toml", "nothing.toml: there is no such file"),
        ("turn a.toml --scenario b.toml", "give one"),
        ("turn coin coin", "unexpected extra argument"),
        ("turn --lawl no-slip", "No such option: --lawl"),
        ("turn --tilt", "requires an argument"),
        ("tilt", "No such command 'tilt'"),
        ("simulate --tilt 30", "--tilt: 30 is read as radians"),
        ("simulate --tilt 30 --topple-tilt 80", "for degrees write"),
        ("simulate --tilt 0", "a body that stands, and stays: give --tilt-rate"),
        ("simulate --tilt 0 --tilt-rate=-3", "must be > 0 for a body that stands, got -3 rad/s"),
        ("simulate --tilt 0 --spin-rate 3", "--spin-rate is for a body that leans: give a tilt"),
        ("simulate --tilt 180deg", "--tilt must be between -180 and 180 deg, got 180deg"),
        ("simulate --tilt -200deg", "--tilt must be between -180 and 180 deg, got -200deg"),
        ("simulate --tilt nan", "not a finite number"),
        ("simulate --tilt 30deg --yaw-rate 3Hz", "does not measure an angular rate"),
        ("simulate --tilt 30deg --duration 0s", "duration must be > 0, got 0 s"),
        ("simulate --tilt 30deg --duration -2s", "duration must be > 0, got -2 s"),
        ("simulate --tilt 30deg --duration inf", "not a finite number"),
        ("simulate --tilt 30deg --gravity 0", "--gravity must be > 0"),
        ("simulate --gravity -1", "--gravity must be > 0 and finite"),
        ("turn --gravity -3", "--gravity must be > 0 and finite, got -3 m/s^2"),
        ("turn --tilt 20deg --gravity -3", "--gravity must be > 0 and finite, got -3 m/s^2"),
        ("topple -n 0", "--number must be a whole number >= 1, got 0"),
        ("topple --tilt-spread -1", "--tilt-spread must be finite and >= 0"),
        ("simulate --tilt 30deg --rtol 1", "rtol must be between 1e-14 and 1e-3, got 1"),
        ("simulate --tilt 30deg --rtol nan", "--rtol must be a pure number"),
        ("simulate --tilt 30deg --rtol small", "--rtol must be a pure number"),
        ("simulate --tilt 30deg --max-steps 0", "Invalid value for '--max-steps'"),
        ("simulate --tilt 30deg --max-steps 99999999999999999999", "'--max-steps'"),
        ("simulate --tilt 30deg --topple-tilt 20deg", "--tilt must be below --topple-tilt = 0.349"),
        ("simulate --tilt 30deg --points 1", "--points must be between 2 and"),
        ("simulate --tilt 30deg --points 99999999999", "--points must be between 2 and"),
        ("simulate --tilt 30deg --every 0s", "--every must be > 0"),
        ("simulate --tilt 30deg --every 1fs -o can.csv", "makes more than 10000000 points"),
        ("simulate --tilt 30deg --every 1m", "--every must be a time"),
        ("simulate --tilt 30deg --every 1ms --points 9", "give one"),
        ("simulate --tilt 30deg -o can.xyz", "its suffix must be one of .csv, .nc, .json, .png"),
        ("simulate --tilt 30deg -o can", "its suffix must be one of"),
        ("simulate -o none/can.csv", "cannot write none/can.csv: there is no folder none"),
        ("simulate --tilt 30deg -o /proc/can.csv", "cannot write /proc/can.csv"),
        ("simulate --points 5", "--points spaces the points of a file: give one with -o"),
        ("simulate --every 1ms -o can.png", "--every spaces the points of a file"),
        ("simulate -o can.csv -o can.csv", "-o gives the same file again: can.csv twice"),
        ("topple -o a.csv -o ./sub/../a.csv", "-o gives the same file again"),
        ("simulate -o - -o -", "-o gives the same file again: - twice"),
        ("compare -o -", "cannot write standard output: its suffix must be one of .png"),
        ("topple --number 1.5", "must be a whole number such as 42, got '1.5'"),
        ("topple --number many", "must be a whole number such as 42, got 'many'"),
        ("topple --number 1e999999999", "must be a whole number"),
        ("topple --number nan", "must be a whole number"),
        ("simulate --max-steps 0", "must be between 1 and"),
        ("map --threads 0", "threads must be a whole number >= 1"),
        ("reproduce --output /proc/none", "cannot make the folder /proc/none"),
    ],
)
def test_each_mistake_is_one_line_and_exit_code_2(complaint, arguments, says):
    assert says in complaint(arguments)


def test_a_half_written_scenario_is_named_with_line_and_column(complaint, tmp_path):
    (tmp_path / "half.toml").write_text('[body]\npreset = "coin"\n[start\n')
    line = complaint("simulate half.toml")
    assert line.startswith("half.toml: is not valid TOML: ")
    assert "line 3, column 7" in line


@pytest.mark.parametrize(
    ("command", "table", "says"),
    [
        ("turn", 'gravity = "-3 m/s^2"', "can.toml: gravity must be > 0 and finite, got -3"),
        ("turn --tilt 20deg", "gravity = -3", "can.toml: gravity must be > 0 and finite, got -3"),
        ("simulate", 'duration = "-1 s"', "can.toml: duration must be > 0, got -1 s"),
        ("simulate --duration -2s", 'duration = "-1 s"', "--duration must be > 0, got -2 s"),
        ("simulate --gravity -3", 'duration = "-1 s"', "--gravity must be > 0 and finite, got -3"),
        ("simulate", "rtol = 1", "can.toml: rtol must be between 1e-14 and 1e-3, got 1"),
        ("simulate --tilt 30deg", "topple_tilt = 0.2", "--tilt must be below topple_tilt = 0.2"),
        (
            "simulate --topple-tilt 0.2",
            "rtol = 1e-9\n[start]\ntilt = 0.5",
            "can.toml: tilt must be below --topple-tilt = 0.2",
        ),
    ],
)
def test_a_value_is_blamed_on_the_file_or_on_the_option_that_gives_it(
    complaint, tmp_path, command, table, says
):
    file = tmp_path / "can.toml"
    file.write_text(f'[body]\npreset = "can_2007"\n[simulation]\n{table}\n')
    for file in ("can.toml", "--scenario can.toml"):
        assert complaint(f"{command} {file}").startswith(says)


@pytest.mark.parametrize(
    ("command", "says"),
    [
        ("simulate -o way/can.csv", "cannot write way/can.csv: way is no folder"),
        ("reproduce -o way", "cannot make the folder way: a file is in the way"),
    ],
)
def test_a_file_in_the_way_of_a_folder(complaint, tmp_path, command, says):
    (tmp_path / "way").write_text("mine")
    assert complaint(command) == says
    assert (tmp_path / "way").read_text() == "mine"


def test_a_folder_in_the_way_of_a_file(complaint, tmp_path):
    (tmp_path / "can.csv").mkdir()
    assert "it is a folder" in complaint("simulate --tilt 30deg -o can.csv")


@pytest.mark.parametrize(
    ("failure", "code", "says"),
    [
        (OSError(errno.ENOSPC, "No space left on device"), 2, "can.csv: No space left on device"),
        (MemoryError(), 2, "out of memory"),
        (KeyboardInterrupt(), 130, "interrupted"),
    ],
)
def test_a_file_that_fails_half_way_leaves_the_old_one(
    complaint, monkeypatch, tmp_path, failure, code, says
):
    def half(part, record, bar):
        part.write_text("half")
        raise failure

    monkeypatch.setitem(files.FORMS, ".csv", half)
    (tmp_path / "can.csv").write_text("old")
    assert says in complaint("simulate --tilt 30deg -o can.csv", code)
    assert (tmp_path / "can.csv").read_text() == "old"


@pytest.mark.skipif(not os.path.exists("/dev/full"), reason="no full disk to write to")
def test_a_full_disk_under_stdout_is_one_line():
    with open("/dev/full", "w") as full:
        run = subprocess.run(
            [sys.executable, "-m", "rimroll.cli", "bodies"],
            stdout=full,
            stderr=subprocess.PIPE,
            text=True,
        )
    assert run.returncode == 2
    assert one_line(run.stderr) == "No space left on device"


def interrupted(command, sign):
    """Runs Python and interrupts it when the path ``sign`` exists; returns what it prints."""
    with running(*command, cwd=sign.parent) as process:
        out, err = interrupt_when(sign.exists, process)
    assert out == ""
    assert process.returncode == 130
    return one_line(err)


@needs_signals
def test_ctrl_c_in_a_long_motion_is_one_line_and_leaves_nothing(tmp_path):
    code = (
        "import sys\n"
        "from pathlib import Path\n"
        "from rimroll.cli import main, simulate\n"
        "follow = simulate._follow\n"
        "def ready_to_follow(what):\n"
        "    Path('ready').touch()\n"
        "    return follow(what)\n"
        "simulate._follow = ready_to_follow\n"
        "sys.exit(main(sys.argv[1:]))\n"
    )
    endless = "simulate --tilt 30deg --yaw-rate 0.005 --duration 1e6s --max-steps 2000000000"
    command = ["-c", code, *endless.split(), "-o", "can.csv"]
    assert interrupted(command, tmp_path / "ready") == "interrupted"
    assert os.listdir(tmp_path) == ["ready"]


@pytest.mark.slow
@needs_signals
def test_ctrl_c_in_a_report_is_one_line_and_leaves_no_page(tmp_path):
    folder = tmp_path / "paper"
    command = ["-m", "rimroll.cli", "reproduce", "-o", "paper"]
    assert interrupted(command, folder) == "interrupted"
    names = os.listdir(folder)
    assert "index.html" not in names
    assert not [name for name in names if name.startswith(".")]
