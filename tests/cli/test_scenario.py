"""Scenario files give the same objects as the API, and errors in them give one line."""

from pathlib import Path

import numpy as np
import pytest

import rimroll as rr
from rimroll import scenario
from rimroll.options import Options
from rimroll.scenario import load

EXAMPLES = Path(__file__).parents[2] / "examples"


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
    assert numbers(can.body) == pytest.approx(numbers(rr.bodies.can_2007()), rel=1e-15, abs=0.0)
    assert (can.start.tilt, can.start.tilt_rate) == (np.pi / 6, -0.5)
    assert (can.start.yaw_rate, can.start.spin_rate) == (0.005, 0.005)
    assert can.law == rr.NoSlip()
    assert can.options == Options(duration=2.0, gravity=9.8, rtol=1e-10)


def test_the_example_of_the_cup_weighs_what_its_parts_weigh():
    cup = load(EXAMPLES / "my_cup.toml")
    tea = 1000.0 * np.pi * 0.031**2 * 0.04
    assert cup.body.mass == pytest.approx(0.007 + 0.0015 + 0.001 + tea, rel=1e-14, abs=0.0)
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
        "disk": "mass = 1\nradius = 0.1\nheight = 0.3",
        "ring": "mass = 1\nradius = 0.1",
        "wall": "mass = 1\nradius = 0.1\nlength = 0.2\nbase = 0.1",
        "box": "mass = 0.2\nwidth = 0.07\nthickness = 0.008\nlength = 0.15\nbase = 0.01",
        "filling": "density = 1000\nradius = 0.1\ndepth = 0.2",
        "solid": "mass = 1\nheight = 0.1\ntransverse_inertia = 0.2\naxial_inertia = 0.3",
    }
    tables = [f'[[body.solids]]\nkind = "{kind}"\n{rest}\n' for kind, rest in parts.items()]
    s = rr.solids
    expected = [
        s.cylinder(1, 0.1, 0.2),
        s.hollow_cylinder(1, 0.1, 0.2, 0.2),
        s.disk(1, 0.1, 0.3),
        s.ring(1, 0.1),
        s.wall(1, 0.1, 0.2, 0.1),
        s.box(0.2, 0.07, 0.008, 0.15, 0.01),
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


@pytest.mark.parametrize(
    ("text", "law"),
    [
        ('law = "no_slip"', rr.NoSlip()),
        ('law = "noslip"', rr.NoSlip()),
        ('law = "Frictionless"', rr.Frictionless()),
        ('[law]\nkind = "no-slip"', rr.NoSlip()),
        ('[law]\nkind = "coulomb"\nfriction = 0.2', rr.Coulomb(0.2)),
        (
            '[law]\nkind = "coulomb"\nfriction = "20%"\nstatic = 0.25\nrestitution = 0.5',
            rr.Coulomb(0.2, 0.25, 0.5),
        ),
        ('[law]\nkind = "viscous"\ncoefficient = "2 mN s/mm"', rr.Viscous(2.0)),
        (
            '[law]\nkind = "stribeck"\nfriction = 0.2\nstribeck_speed = "2 cm/s"',
            rr.Stribeck(0.2, stribeck_speed=0.02),
        ),
        ('[law]\nsurface = "ice"\nstatic = 0.1', rr.Coulomb(0.03, 0.1)),
        (
            '[law]\nkind = "no-slip"\n[law.rolling_resistance]\ndry = 1e-3\nviscous = "1 mN s/m"\n'
            '[law.pivoting_friction]\nlength = "1mm"\n[law.air_drag]\ncoefficient = 1e-9\n'
            "exponent = 2.5",
            rr.NoSlip()
            + rr.RollingResistance(1e-3, 1e-3)
            + rr.PivotingFriction(1e-3)
            + rr.AirDrag(1e-9, 2.5),
        ),
        (
            '[law]\nkind = "no-slip"\n[law.air_drag]\ncoefficient = "film"\n'
            "[simulation]\ngravity = 9.8",
            rr.NoSlip() + rr.AirDrag.film(0.01162500, gravity=9.8),
        ),
    ],
)
def test_laws_are_names_or_tables_with_units(written, text, law):
    body = '[body]\npreset = "coin"\n'
    given = f"{text}\n{body}" if text.startswith("law") else body + text
    assert load(written(given)).law == law


def test_the_example_on_wood_slips_in_the_near_collision_and_turns_by_more_than_rolling():
    wood = load(EXAMPLES / "wood.toml")
    assert wood.law == rr.Coulomb(0.3)
    motion = rr.simulate(wood.body, wood.start, wood.law, 0.8, gravity=9.8)
    assert [phase.kind for phase in motion.phases][:2] == ["rolling", "sliding"]
    assert motion.turns[0].angle > rr.turn_limit(wood.body, rr.NoSlip())


def test_the_example_of_eulers_disk_runs_through_to_rest():
    disk = load(EXAMPLES / "euler_disk.toml")
    motion = rr.simulate(disk.body, disk.start, disk.law, disk.options.duration)
    assert motion.status == "at_rest"
    assert 10.0 < motion.t[-1] < 40.0
    assert motion.resistance_loss[-1] > 0.9 * motion.energy[0]


COIN = '[body]\npreset = "coin"\n'
WALL = '[body]\nradius = 1\n[[body.solids]]\nkind = "wall"\nmass = 1\nradius = 1\n'

BAD = {
    "half-written header": ("[body\n", "is not valid TOML: .*line 1, column 6"),
    "half-written value": ('[body]\npreset = "co', r"is not valid TOML: .*(line 2|at end)"),
    "not a text": (b"\xff\xfe\x00", "not a text in UTF-8"),
    "empty": ("", r"is empty: write what rolls, such as \[body\] and preset ="),
    "only comments": ("# nothing yet\n", "is empty: write what rolls"),
    "no body": ('law = "no-slip"', r"has no table \[body\]: write what rolls"),
    "no body, misspelt": ('[bdy]\npreset = "coin"', "'bdy': did you mean 'body'"),
    "tilt is true": (COIN + "[start]\ntilt = true", "tilt must be an angle .*got true: neither"),
    "rate is a table": (
        COIN + "[start]\ntilt = 0.1\nyaw_rate = { deg = 3, ok = false }",
        r"yaw_rate must be .*got \{ deg = 3, ok = false \}",
    ),
    "rate is a list": (
        COIN + '[start]\ntilt = 0.1\nyaw_rate = ["3 deg/s", true]',
        r'yaw_rate must be .*got \["3 deg/s", true\]',
    ),
    "body is true": ("body = true", "body must be a table, got true"),
    "body is a text": ('body = "coin"', 'body must be a table, got "coin"'),
    "law is true": ("law = true\n" + COIN, "law must be a text or a table, got true"),
    "preset is false": ("[body]\npreset = false", "preset must be a text, got false"),
    "steps are a text": (
        COIN + '[simulation]\nmax_steps = "9"',
        'max_steps must be a whole number, got "9"',
    ),
    "coefficient is true": (
        COIN + '[law]\nkind = "no-slip"\n[law.air_drag]\ncoefficient = true',
        "coefficient must be .*got true",
    ),
    "empty body": ("[body]", r"\[body\] is empty"),
    "unknown table": (COIN + "[simulaton]", "'simulaton': did you mean 'simulation'"),
    "body is a number": ("body = 3", "body must be a table, got 3"),
    "unknown law": ('law = "sticky"\n' + COIN, "unknown law 'sticky': did you mean 'stribeck'"),
    "law is a number": ("law = 1\n" + COIN, "law must be a text or a table, got 1"),
    "law without its number": (
        'law = "coulomb"\n' + COIN,
        "law = \"coulomb\" lacks 'friction': write a table .law. with kind",
    ),
    "law of no kind": (COIN + "[law]\nfriction = 0.2", r"\[law\] lacks 'kind': one of no-slip, fr"),
    "law of a wrong kind": (COIN + "[law]\nkind = 1", r"\[law\] kind must be a text, got 1"),
    "law of an unknown kind": (
        COIN + '[law]\nkind = "colomb"',
        r"\[law\] unknown law 'colomb': did you mean 'coulomb'",
    ),
    "law with unknown key": (
        COIN + '[law]\nkind = "coulomb"\nfricton = 0.2',
        r"\[law\] of kind \"coulomb\" has an unknown key 'fricton': did you mean 'friction'",
    ),
    "no-slip with friction": (
        COIN + '[law]\nkind = "no-slip"\nfriction = 0.2',
        r"\[law\] of kind \"no-slip\" has an unknown key 'friction'",
    ),
    "friction missing": (
        COIN + '[law]\nkind = "coulomb"\nstatic = 0.2',
        r"\[law\] coulomb needs friction",
    ),
    "friction negative": (
        COIN + '[law]\nkind = "coulomb"\nfriction = -0.2',
        r"\[law\] friction must be between 0 and 1e6, got -0.2",
    ),
    "friction nan": (COIN + '[law]\nkind = "coulomb"\nfriction = nan', "not a finite number"),
    "friction is a list": (
        COIN + '[law]\nkind = "coulomb"\nfriction = [0.2]',
        r"\[law\] of kind \"coulomb\" friction must be a pure number .*neither",
    ),
    "static below friction": (
        COIN + '[law]\nkind = "coulomb"\nfriction = 0.3\nstatic = 0.2',
        r"\[law\] static must be between friction = 0.3",
    ),
    "restitution 2": (
        COIN + '[law]\nkind = "viscous"\ncoefficient = 1\nrestitution = 2',
        r"\[law\] restitution must be between 0 and 1",
    ),
    "coefficient in cm": (
        COIN + '[law]\nkind = "viscous"\ncoefficient = "1 cm"',
        "coefficient must be a viscous resistance",
    ),
    "unknown surface": (
        COIN + '[law]\nsurface = "woof"',
        r"\[law\] unknown surface 'woof': did you",
    ),
    "surface and kind": (
        COIN + '[law]\nsurface = "ice"\nkind = "coulomb"',
        r"\[law\] has both a kind and a surface: give one",
    ),
    "surface with friction": (
        COIN + '[law]\nsurface = "ice"\nfriction = 0.2',
        r"\[law\] of surface \"ice\" has an unknown key 'friction'",
    ),
    "resistance of nothing": (
        COIN + '[law]\nkind = "no-slip"\n[law.rolling_resistance]',
        r"\[law.rolling_resistance\] lacks 'dry' or 'viscous'",
    ),
    "resistance is a number": (
        COIN + '[law]\nkind = "no-slip"\nair_drag = 3',
        r"\[law\] air_drag must be a table, got 3",
    ),
    "resistance negative": (
        COIN + '[law]\nkind = "no-slip"\n[law.rolling_resistance]\ndry = -1',
        r"rolling_resistance dry must be >= 0",
    ),
    "resistance misspelt": (
        COIN + '[law]\nkind = "no-slip"\n[law.pivoting_friction]\nlenght = 1',
        r"\[law.pivoting_friction\] has an unknown key 'lenght': did you mean 'length'",
    ),
    "resistance unknown": (
        COIN + '[law]\nkind = "no-slip"\n[law.pivotin_friction]\nlength = 1',
        "did you mean 'pivoting_friction'",
    ),
    "air drag without number": (
        COIN + '[law]\nkind = "no-slip"\n[law.air_drag]\nexponent = 4',
        r"\[law.air_drag\] lacks 'coefficient'",
    ),
    "air drag of another exponent": (
        COIN + '[law]\nkind = "no-slip"\n[law.air_drag]\ncoefficient = "1 W"',
        r"\[law.air_drag\] coefficient must be a coefficient of air drag",
    ),
    "air drag out of bounds": (
        COIN + '[law]\nkind = "no-slip"\n[law.air_drag]\ncoefficient = 1\nexponent = 9',
        r"air_drag exponent must be between 1.5 and 8",
    ),
    "film with exponent": (
        COIN + '[law]\nkind = "no-slip"\n[law.air_drag]\ncoefficient = "film"\nexponent = 4',
        r"\[law.air_drag\] a film has its own exponent",
    ),
    "unknown preset": ('[body]\npreset = "soda_cam"', r"\[body\] .*did you mean 'soda_can'"),
    "preset is a number": ("[body]\npreset = 1", r"\[body\] preset must be a text"),
    "unknown argument": (COIN + "fill = 1", r"\[body\] .*unknown key 'fill'"),
    "misspelt argument": ('[body]\npreset = "soda_can"\nfil = 1', "did you mean 'fill'"),
    "argument out of bounds": (
        '[body]\npreset = "soda_can"\nfill = 1.5',
        r"\[body\] fill must be between 0 and 1, got 1.5",
    ),
    "argument in percent": (
        '[body]\npreset = "soda_can"\nfill = 50',
        r'\[body\] fill must be between 0 and 1, got 50: for percent write 0.5 or "50 %"',
    ),
    "size without its unit": (
        '[body]\npreset = "ring"\nradius = 33',
        r'radius: 33 is read as 33 m; with its unit write "33 mm"',
    ),
    "argument missing": ('[body]\npreset = "disk"', r"\[body\] .*lacks 'radius'"),
    "numbers missing": ('[body]\nmass = "70 g"', r"\[body\] lacks 'radius'"),
    "no radius": (
        "[body]\nmass = 1\nradius = 0\nheight = 1\ntransverse_inertia = 1\naxial_inertia = 1",
        r"\[body\] radius must be > 0, got 0 m",
    ),
    "C > 2A": (
        "[body]\nmass = 1\nradius = 1\nheight = 1\ntransverse_inertia = 0.1\naxial_inertia = 0.3",
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
