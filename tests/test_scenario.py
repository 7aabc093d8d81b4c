"""Scenario files say what the API says, and what is wrong with one is said in one line."""

from pathlib import Path

import numpy as np
import pytest

import rimroll as rr
from rimroll import scenario
from rimroll.scenario import Options, load

EXAMPLES = Path(__file__).parent.parent / "examples"


@pytest.fixture
def written(tmp_path):
    """Writes a scenario file and returns its path."""

    def write(text):
        path = tmp_path / "scenario.toml"
        path.write_bytes(text if isinstance(text, bytes) else text.encode())
        return path

    return write


def numbers(body):
    return [body.mass, body.radius, body.height, body.transverse_inertia, body.axial_inertia]


def test_the_example_of_the_can_is_the_papers_can_and_start():
    can = load(EXAMPLES / "can_2007.toml")
    assert numbers(can.body) == pytest.approx(numbers(rr.bodies.can_2007()), rel=1e-15)
    assert (can.start.tilt, can.start.tilt_rate) == (np.pi / 6, -0.5)
    assert (can.start.yaw_rate, can.start.spin_rate) == (0.005, 0.005)
    assert can.law == rr.NoSlip()
    assert can.options == Options(duration=2.0, gravity=9.8, rtol=1e-10)


def test_the_example_of_the_cup_weighs_what_its_parts_weigh():
    cup = load(EXAMPLES / "my_cup.toml")
    tea = 1000.0 * np.pi * 0.031**2 * 0.04
    assert cup.body.mass == pytest.approx(0.007 + 0.0015 + 0.001 + tea, rel=1e-14)
    assert cup.body.radius == 0.028
    assert cup.options == Options(duration=0.8)


def test_all_examples_can_be_read():
    for path in EXAMPLES.glob("*.toml"):
        assert load(path).body.mass > 0.0


def test_a_body_alone_is_enough(written):
    read = load(written('[body]\npreset = "coin"'))
    assert read == scenario.Scenario(rr.bodies.coin(), None, rr.NoSlip(), Options())


@pytest.mark.parametrize(
    ("text", "body"),
    [
        ('preset = "soda-can"\nfill = "25%"', rr.bodies.soda_can(0.25)),
        ('preset = "ring"', rr.bodies.ring()),
        ('preset = "disk"\nradius = "4 cm"', rr.bodies.disk(0.04)),
        ('preset = "cylinder"\nradius = 0.03\nlength = "10cm"', rr.bodies.cylinder(0.03, 0.1)),
    ],
)
def test_presets_take_their_arguments(written, text, body):
    assert load(written(f"[body]\n{text}")).body == body


def test_every_kind_of_solid_is_that_of_the_module(written):
    parts = {
        "cylinder": "mass = 1\nradius = 0.1\nlength = 0.2",
        "hollow_cylinder": "mass = 1\ninner_radius = 0.1\nouter_radius = 0.2\nlength = 0.2",
        "disc": "mass = 1\nradius = 0.1\nheight = 0.3",
        "ring": "mass = 1\nradius = 0.1",
        "wall": "mass = 1\nradius = 0.1\nlength = 0.2\nbase = 0.1",
        "filling": "density = 1000\nradius = 0.1\ndepth = 0.2",
        "solid": "mass = 1\nheight = 0.1\ntransverse_inertia = 0.2\naxial_inertia = 0.3",
    }
    tables = [f'[[body.solids]]\nkind = "{kind}"\n{rest}\n' for kind, rest in parts.items()]
    s = rr.solids
    expected = [
        s.cylinder(1, 0.1, 0.2),
        s.hollow_cylinder(1, 0.1, 0.2, 0.2),
        s.disc(1, 0.1, 0.3),
        s.ring(1, 0.1),
        s.wall(1, 0.1, 0.2, 0.1),
        s.filling(1000, 0.1, 0.2),
        s.Solid(1, 0.1, 0.2, 0.3),
    ]
    read = load(written("[body]\nradius = 0.1\n" + "".join(tables)))
    assert read.body == rr.Body.from_solids(0.1, expected)


def test_a_law_and_all_options_are_read(written):
    text = """law = "frictionless"
    [body]
    preset = "can_2007"
    [start]
    tilt = "0.5 rad"
    yaw = "90 deg"
    spin = 1
    [simulation]
    duration = "500 ms"
    gravity = "1.62 m/s^2"
    rtol = 1e-8
    topple_tilt = "80 deg"
    max_steps = 1000
    """
    read = load(written(text))
    assert read.law == rr.Frictionless()
    assert (read.start.tilt, read.start.yaw, read.start.spin) == (0.5, np.pi / 2, 1.0)
    expected = Options(
        duration=0.5, gravity=1.62, rtol=1e-8, topple_tilt=np.radians(80), max_steps=1000
    )
    assert read.options == expected


COIN = '[body]\npreset = "coin"\n'
WALL = '[body]\nradius = 1\n[[body.solids]]\nkind = "wall"\nmass = 1\nradius = 1\n'

BAD = {
    "half-written header": ("[body\n", "is not valid TOML: .*line 1, column 6"),
    "half-written value": ('[body]\npreset = "co', r"is not valid TOML: .*(line 2|at end)"),
    "not a text": (b"\xff\xfe\x00", "not a text in UTF-8"),
    "empty": ("", "lacks 'body'"),
    "no body": ('law = "no-slip"', "lacks 'body'"),
    "empty body": ("[body]", r"\[body\] is empty"),
    "unknown table": (COIN + "[simulaton]", "'simulaton': did you mean 'simulation'"),
    "body is a number": ("body = 3", "body must be a table, got 3"),
    "unknown law": ('law = "sticky"\n' + COIN, "unknown law 'sticky': choose from no_slip"),
    "law is a number": ("law = 1\n" + COIN, "law must be a text, got 1"),
    "unknown preset": ('[body]\npreset = "soda_cam"', r"\[body\] .*did you mean 'soda_can'"),
    "preset is a number": ("[body]\npreset = 1", r"\[body\] preset must be a text"),
    "unknown argument": (COIN + "fill = 1", r"\[body\] .*unknown key 'fill'"),
    "misspelt argument": ('[body]\npreset = "soda_can"\nfil = 1', "did you mean 'fill'"),
    "argument out of bounds": (
        '[body]\npreset = "soda_can"\nfill = 1.5',
        r"\[body\] fill must be between 0 and 1, got 1.5",
    ),
    "argument missing": ('[body]\npreset = "disk"', r"\[body\] .*lacks 'radius'"),
    "numbers missing": ('[body]\nmass = "70 g"', r"\[body\] lacks 'radius'"),
    "no radius": (
        "[body]\nmass = 1\nradius = 0\nheight = 1\ntransverse_inertia = 1\naxial_inertia = 1",
        r"\[body\] radius must be > 0, got 0 m",
    ),
    "C > 2A": (
        "[body]\nmass = 1\nradius = 1\nheight = 1\ntransverse_inertia = 1\naxial_inertia = 3",
        r"\[body\] axial_inertia must be at most",
    ),
    "solids and mass": (WALL.replace("[[", "mass = 1\n[[", 1), "unknown key 'mass'"),
    "no solids": ("[body]\nradius = 1\nsolids = []", "at least one solid"),
    "solids are no tables": ("[body]\nradius = 1\nsolids = [3]", "solids.0 must be a table"),
    "solid without kind": (WALL.replace('kind = "wall"', ""), r"solids\]\] 1 needs a kind"),
    "solid of unknown kind": (WALL.replace('"wall"', '"wal"'), "did you mean 'wall'"),
    "solid incomplete": (WALL, r"\[\[body.solids\]\] 1 .*lacks 'length'"),
    "solid of no mass": (
        WALL.replace("mass = 1", "mass = 0\nlength = 1"),
        r"\[\[body.solids\]\] 1 mass must be > 0",
    ),
    "start without tilt": (COIN + "[start]\nyaw_rate = 1", r"\[start\] lacks 'tilt'"),
    "misspelt tilt": (COIN + "[start]\ntlit = 1", r"\[start\] .*'tlit': did you mean 'tilt'"),
    "tilt is a length": (COIN + '[start]\ntilt = "3 cm"', r"\[start\] tilt must be an angle"),
    "tilt is true": (COIN + "[start]\ntilt = true", r"\[start\] tilt must be an angle"),
    "tilt is nan": (COIN + "[start]\ntilt = nan", r"\[start\] tilt .*not a finite number"),
    "tilt too far": (
        COIN + "[start]\ntilt = 4",
        r"\[start\] tilt: 4 is read as radians, .* write 4deg",
    ),
    "steps of a text": (
        COIN + '[simulation]\nmax_steps = "9"',
        r"\[simulation\] max_steps must be a whole number",
    ),
    "no steps": (COIN + "[simulation]\nmax_steps = 0", r"\[simulation\] max_steps"),
    "duration is an angle": (
        COIN + '[simulation]\nduration = "2 deg"',
        r'\[simulation\] duration must be a time such as "2 s"',
    ),
}


@pytest.mark.parametrize(("text", "says"), BAD.values(), ids=BAD)
def test_a_wrong_file_is_refused_in_one_line_that_names_it_and_the_field(written, text, says):
    path = written(text)
    with pytest.raises(rr.RimrollError, match=says) as refusal:
        load(path)
    assert str(refusal.value).startswith(f"{path}: ")
    assert "\n" not in str(refusal.value)


def test_a_file_that_is_not_there_and_a_folder_are_refused(tmp_path):
    with pytest.raises(rr.RimrollError, match="no such file"):
        load(tmp_path / "nothing.toml")
    with pytest.raises(rr.RimrollError, match="cannot be read: Is a directory"):
        load(tmp_path)
