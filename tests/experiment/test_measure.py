"""Kitchen measurements determine a body and its uncertainty."""

import json
import math
import re

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.integrate import quad
from scipy.linalg import eigh
from scipy.special import ellipk

import rimroll as rr
from given.strategies import bodies, examples
from rimroll import units
from rimroll.cli import main
from rimroll.cli.measure import measure as command
from rimroll.experiment.readings import Readings, main_source, pretty
from rimroll.scenario import load

CAN = rr.bodies.can_2007()
G = 9.80665
FIELDS = ("mass", "radius", "height", "transverse_inertia", "axial_inertia")
KITCHEN = {
    "mass": "70 g",
    "diameter": "10.2 cm",
    "balance_point": "6.9 cm",
    "swings": 50,
    "swings_time": "38.3 s",
}
LINE = "--mass 70g --diameter 10.2cm --balance-point 6.9cm --swings 50 --swings-time 38.3s"

many = examples(60, derandomize=True)


# An independent account of the pendulum: the tensor of inertia about the pivot


def small_swings(body, p=None, h=0.0):
    """Periods of a body hung from a point at distance p from its axis and h above its base.

    Along; across about an edge that holds the axis; across about a point. From the whole tensor of
    inertia about the pivot and the stiffness m g L against turning about each horizontal axis.
    """
    arm = np.array([p or body.radius, 0.0, body.height - h])
    length = np.linalg.norm(arm)
    about_center = np.diag([body.transverse_inertia] * 2 + [body.axial_inertia])
    tensor = about_center + body.mass * (length**2 * np.eye(3) - np.outer(arm, arm))
    down = arm / length
    tangent = np.array([0.0, 1.0, 0.0])
    across = np.cross(tangent, down)
    frame = np.stack([tangent, across, down])
    inertia = frame @ tensor @ frame.T
    stiffness = body.mass * G * length * np.diag([1.0, 1.0, 0.0])
    along, edge = 2 * np.pi * np.sqrt(np.diag(inertia)[:2] / stiffness[0, 0])
    modes = eigh(stiffness[1:, 1:], inertia[1:, 1:], eigvals_only=True)  # twist, swing
    return float(along), float(edge), float(2 * np.pi / np.sqrt(modes[1]))


def numbers_of(body):
    return [getattr(body, name) for name in FIELDS]


def numbers(measurement):
    return numbers_of(measurement.body)


def body_readings(body, **more):
    along, edge, _ = small_swings(body)
    known = {"mass": body.mass, "radius": body.radius, "balance_point": body.height}
    return {**known, "swing_period": along, "across_period": edge, **more}


def test_the_papers_can_comes_back_with_its_5_13e_3_m2():
    along, across, _ = small_swings(CAN)
    measured = rr.measure(
        mass="70 g",
        diameter="10.2 cm",
        balance_point="6.9 cm",
        swings=50,
        swings_time=f"{50 * along!r} s",
        across_swings="50",
        across_time=50 * across,
    )
    assert numbers(measured) == pytest.approx(numbers_of(CAN), rel=1e-12, abs=0.0)
    per_mass = measured.transverse_inertia / measured.mass
    assert per_mass.nominal_value == pytest.approx(5.13e-3)  # the paper
    assert per_mass.std_dev == pytest.approx(7e-5, rel=0.1)
    assert measured.axial_inertia_measured


@many
@given(bodies())
def test_swings_along_and_across_give_any_body_back(body):
    measured = rr.measure(**body_readings(body))
    assert numbers(measured)[:3] == [body.mass, body.radius, body.height]
    arm = body.mass * (body.radius**2 + body.height**2)
    slack = 1e-13 * (1.0 + arm / body.transverse_inertia)
    assert measured.body.transverse_inertia == pytest.approx(body.transverse_inertia, rel=slack)
    lever = 1e-12 * (arm + body.transverse_inertia) * (1 + (body.height / body.radius) ** 2)
    assert measured.body.axial_inertia == pytest.approx(body.axial_inertia, abs=lever)


@many
@given(bodies(), st.floats(0.3, 3.0), st.floats(-1.0, 4.0))
def test_it_may_hang_from_elsewhere_on_an_edge_or_on_a_point(body, across, up):
    p, h = across * body.radius, max(0.0, up * body.radius)
    along, edge, point = small_swings(body, p, h)
    arm = body.mass * (p**2 + (body.height - h) ** 2)
    slack = 1e-11 * (arm + body.transverse_inertia) * (1 + ((body.height - h) / p) ** 2) ** 2
    for pivot, period in (("edge", edge), ("point", point)):
        readings = body_readings(
            body,
            swing_period=along,
            across_period=period,
            across_pivot=pivot,
            pivot_radius=p,
            pivot_height=h,
        )
        try:
            found = rr.measure(**readings).body
        except rr.RimrollError as refusal:  # a rounding error beyond C = 0 or C = 2A
            assert "(C = 0)" in str(refusal)
            assert min(body.axial_inertia, 2 * body.transverse_inertia - body.axial_inertia) < slack
            continue
        assert found.transverse_inertia == pytest.approx(body.transverse_inertia, abs=slack)
        assert found.axial_inertia == pytest.approx(body.axial_inertia, abs=slack)


def test_a_body_on_a_point_swings_across_faster_than_on_an_edge_so_that_it_matters():
    _, edge, point = small_swings(CAN)
    assert (edge, point) == pytest.approx((0.7309, 0.7074), abs=1e-4)
    with pytest.raises(rr.RimrollError, match=r"^across_period.*did it hang on a point"):
        rr.measure(**body_readings(CAN, across_period=point))
    found = rr.measure(**body_readings(CAN, across_period=point, across_pivot="point"))
    assert found.body.axial_inertia == pytest.approx(CAN.axial_inertia)


@pytest.mark.parametrize("degrees", [5.0, 20.0, 90.0])
def test_swings_of_some_amplitude_are_corrected(degrees):
    amplitude = np.radians(degrees)
    longer = 2.0 / np.pi * ellipk(np.sin(amplitude / 2) ** 2)
    readings = body_readings(CAN)
    for name in ("swing_period", "across_period"):
        readings[name] *= longer
    found = rr.measure(**readings, swing_amplitude=f"{degrees!r} deg").body
    assert numbers_of(found) == pytest.approx(numbers_of(CAN), rel=1e-10, abs=0.0)


def test_the_tilt_at_which_it_balances_stands_for_the_balance_point():
    readings = body_readings(CAN)
    del readings["balance_point"]
    found = rr.measure(**readings, balance_tilt=rr.balance_tilt(CAN))
    assert numbers(found) == pytest.approx(numbers_of(CAN), rel=1e-12, abs=0.0)


@pytest.mark.parametrize("part", [0.1, 0.5, 0.9, 0.99])
@pytest.mark.parametrize("name", ["can_2007", "soda_can", "beer_bottle"])
def test_rocking_as_it_is_simulated_gives_a_back(name, part):
    body = rr.bodies.by_name(name)
    tilt = part * rr.balance_tilt(body)
    start = rr.State(tilt=tilt, yaw_rate=1e-9, spin_rate=1e-9)
    motion = rr.simulate(body, start, rr.NoSlip(), duration=5.0)
    up_again = next(event.t for event in motion.events if event.kind == "tilt_max" and event.t > 0)
    readings = body_readings(body, rocking_tilt=tilt, rocking_time=up_again)
    del readings["swing_period"]
    found = rr.measure(**readings).body
    assert found.transverse_inertia == pytest.approx(body.transverse_inertia, rel=1e-6)


@many
@given(bodies(), st.floats(0.02, 1.0), st.floats(0.1, 3.0), st.floats(1.0, 2.0))
def test_rolling_down_a_slope_gives_c_back(body, angle, length, wider):
    side = wider * body.radius * max(1.0, math.sqrt(body.axial_inertia / body.mass) / body.radius)
    heft = 1.0 + body.axial_inertia / (body.mass * side**2)

    def slowness(root):  # dt/d√s by energy, (1 + C/mr²) v²/2 = g s sin α
        return 2.0 * root / math.sqrt(2.0 * G * root**2 * math.sin(angle) / heft)

    time = quad(slowness, 0.0, math.sqrt(length))[0]
    readings = body_readings(body, slope_length=length, slope_time=time, side_radius=side)
    del readings["across_period"]
    for steep in ({"slope_angle": angle}, {"slope_height": length * math.sin(angle)}):
        found = rr.measure(**readings, **steep).body
        assert found.axial_inertia == pytest.approx(body.axial_inertia, rel=1e-9, abs=0.0)


def test_c_of_a_hollow_vessel_is_guessed_where_it_is_not_measured():
    measured = rr.measure(**KITCHEN)
    assert not measured.axial_inertia_measured
    share = measured.axial_inertia / (measured.mass * measured.radius**2)
    assert share.nominal_value == pytest.approx(0.75)
    assert share.std_dev == pytest.approx(0.5 / math.sqrt(12.0))  # of an even chance on a range
    assert main_source(measured.axial_inertia) == "estimate"
    wider = rr.measure(**KITCHEN, side_radius="6 cm").body.axial_inertia
    assert wider == pytest.approx(0.75 * 0.07 * 0.06**2)


def test_no_limit_hangs_on_the_guess():
    measured = rr.measure(**KITCHEN)
    for number in (measured.turn_no_slip, measured.turn_frictionless, measured.needed_friction):
        assert "estimate" not in {part.tag for part in number.error_components()}


@many
@given(bodies())
def test_what_follows_is_what_the_core_says_of_the_body(body):
    measured = rr.measure(**body_readings(body))
    best = measured.body
    for number, expected in (
        (measured.turn_no_slip, rr.turn_limit(best, rr.NoSlip())),
        (measured.turn_frictionless, rr.turn_limit(best, rr.Frictionless())),
        (measured.needed_friction, rr.needed_friction(best)),
    ):
        assert number.nominal_value == pytest.approx(expected, rel=1e-12, abs=0.0)
        assert number.std_dev == 0.0  # numbers are exact


# Uncertainties

EACH = {
    "mass": ("70 ± 1 g", 0.07, 1e-3),
    "diameter": ("10.2(1) cm", 0.102, 1e-3),
    "balance_point": ("6.9 ± 0.1 cm", 0.069, 1e-3),
    "swings_time": ("38.3 ± 0.2 s", 38.3, 0.2),
    "slope_length": ("2 ± 0.01 m", 2.0, 0.01),
    "slope_height": ("20.0 ± 0.2 cm", 0.2, 2e-3),
    "slope_time": ("2.69 ± 0.02 s", 2.69, 0.02),
}


def test_uncertainties_are_those_of_a_thousand_tables():
    measured = rr.measure(swings=50, **{name: text for name, (text, _, _) in EACH.items()})
    random = np.random.default_rng(2007)
    tables = []
    for _ in range(2000):
        once = {name: random.normal(value, sd) for name, (_, value, sd) in EACH.items()}
        found = rr.measure(swings=50, **once)
        tables.append([*numbers(found), found.turn_no_slip.n, found.turn_frictionless.n])
    expected = [getattr(measured, name) for name in FIELDS]
    expected += [measured.turn_no_slip, measured.turn_frictionless]
    spread = np.std(tables, axis=0)
    # 2000 draws know a spread to 1.6 %, and what is not linear here adds some.
    assert [number.std_dev for number in expected] == pytest.approx(spread, rel=0.07)
    for number, mean in zip(expected, np.mean(tables, axis=0), strict=True):
        assert number.nominal_value == pytest.approx(mean, abs=0.15 * number.std_dev)
    # Correlations are kept: A/m does not depend on the mass.
    a, m = np.array(tables)[:, 3], np.array(tables)[:, 0]
    ratio = measured.transverse_inertia / measured.mass
    assert ratio.std_dev == pytest.approx(np.std(a / m), rel=0.07)


def test_rocking_too_carries_its_uncertainties():
    tilt, time = math.radians(25.0), 0.45
    known = {"mass": 0.07, "radius": 0.051, "balance_point": 0.069}

    def inertia(tilt, time):
        found = rr.measure(**known, rocking_tilt=tilt, rocking_time=time, side_radius=0.04)
        return found.transverse_inertia.n

    measured = rr.measure(
        **known, rocking_tilt="25 ± 1 deg", rocking_time="0.45 ± 0.01 s", side_radius=0.04
    )
    step = 1e-5
    slopes = (
        (inertia(tilt + step, time) - inertia(tilt - step, time)) / (2 * step),
        (inertia(tilt, time + step) - inertia(tilt, time - step)) / (2 * step),
    )
    expected = math.hypot(slopes[0] * math.radians(1.0), slopes[1] * 0.01)
    assert measured.transverse_inertia.std_dev == pytest.approx(expected, rel=1e-3)


@pytest.mark.parametrize(
    ("name", "text", "uncertainty"),
    [
        ("mass", "70 g", 5e-4),  # half a unit of the last digit
        ("mass", "70.0 g", 5e-5),
        ("mass", 0.07, 0.0),  # numbers are exact
        ("diameter", "10.2 cm", 5e-4),
        ("swings", "50", 0.0),
        ("swings_time", "38.30 s", 0.1),  # a hand's
        ("swings_time", "38.30 ± 0.02 s", 0.02),
        ("swings_time", "38 s", 0.5),
        ("swing_period", "0.766 s", 5e-4),
        ("rocking_time", "0.64 s", 1 / 30),  # a frame's
        ("gravity", "9.8", 0.0),
        ("gravity", "9.80(1)", 0.01),
    ],
)
def test_how_uncertain_a_reading_is_if_it_does_not_say(name, text, uncertainty):
    assert Readings({name: text})[name].std_dev == pytest.approx(uncertainty)


READINGS = [
    ("70 ± 1 g", "kg", 0.07, 1e-3),
    ("70±1g", "kg", 0.07, 1e-3),
    ("70 +- 1 g", "kg", 0.07, 1e-3),
    ("70 +/- 1g", "kg", 0.07, 1e-3),
    ("(70 ± 1) g", "kg", 0.07, 1e-3),
    ("70 g ± 1000 mg", "kg", 0.07, 1e-3),
    ("70 g ± 2%", "kg", 0.07, 1.4e-3),
    ("6.9(1) cm", "m", 0.069, 1e-3),
    ("38.30(12)s", "s", 38.3, 0.12),
    ("36.5 ± 0.5°", "rad", math.radians(36.5), math.radians(0.5)),
    ("6.9cm", "m", 0.069, 5e-4),
    ("69 mm", "m", 0.069, 5e-4),
    ("0.0690", "m", 0.069, 5e-5),
    ("1e3 ms", "s", 1.0, 0.5),
    (0.069, "m", 0.069, 0.0),
]


@pytest.mark.parametrize(("text", "unit", "value", "uncertainty"), READINGS)
def test_a_reading_says_how_uncertain_it_is(text, unit, value, uncertainty):
    assert units.reading(text, unit) == pytest.approx((value, uncertainty))


@pytest.mark.parametrize(
    "text", ["± 1 g", "70 ± g", "70 ± -1 g", "70 ± 1 s", "70 g ± 1 cm", "70 ± 1 ± 1 g", "x(1) g"]
)
def test_what_is_no_reading_is_refused_by_its_name(text):
    with pytest.raises(rr.RimrollError, match=r"^--mass must be a mass such as"):
        units.reading(text, "kg", "--mass")


@pytest.mark.parametrize(
    ("value", "unit", "text"),
    [
        (0.069, "m", "6.9 cm"),
        (9.80665, "m/s^2", "9.80665 m/s²"),
        ("6.9(1) cm", "m", "6.90 ± 0.10 cm"),
        ("70 ± 5 g", "kg", "70 ± 5 g"),
        ("36.50 ± 0.05 deg", "rad", "(36.50 ± 0.05)°"),
    ],
)
def test_numbers_are_shown_to_the_digits_that_their_uncertainty_leaves(value, unit, text):
    if isinstance(value, str):
        name = {"m": "radius", "kg": "mass", "rad": "balance_tilt"}[unit]
        value = Readings({name: value})[name]
    assert pretty(value, unit) == text


# Impossible readings


def without(*names, **more):
    return {**{name: text for name, text in KITCHEN.items() if name not in names}, **more}


REFUSED = [
    (
        {},
        r"also needs mass; radius or diameter; balance_point or balance_tilt; swings\+swings_time",
    ),
    (without("balance_point"), r"also needs balance_point or balance_tilt$"),
    (without("swings_time"), r"^swings also needs swings_time$"),
    (without("swings", "swings_time", rocking_tilt="20 deg"), r"also needs rocking_time$"),
    (without(balance_tilt="36 deg"), r"^balance_point and balance_tilt measure the same"),
    (without(radius="5.1 cm"), r"^radius and diameter measure the same: give one"),
    (without(swing_period="0.766 s"), r"^swings and swing_period measure the same"),
    (without(rocking_tilt="20 deg"), r"^swings and rocking_tilt measure the same"),
    (without(across_period=0.73, slope_time=1), r"^across_period and slope_time measure the same"),
    (without(slope_length="2 m", slope_time="2 s"), r"also needs slope_height or slope_angle$"),
    (
        without(length="6.0 cm"),
        r"^balance_point: the centre of mass would be 6.9 cm above the base, .* 6 cm.*length$",
    ),
    (
        without("balance_point", balance_tilt="15 deg", length="130 mm"),
        r"^balance_tilt: the centre of mass would be 19.0\d* cm above the base",
    ),
    (
        without(
            "swings", "swings_time", swing_period=0.9, pivot_height="14.0 cm", length="0.130 m"
        ),
        r"^pivot_height: the pivot would be 14 cm above the base, but must be at most 13 cm",
    ),
    (without(length="13 g"), r'^length must be a length.*"g" does not measure a length'),
    (without(mass="-70 g"), r"^mass must be > 0, got -70 g"),
    (without(diameter=0.0), r"^diameter must be > 0"),
    (without(balance_point="-1 mm"), r"^balance_point must be >= 0, got -0.1 cm"),
    (without(mass="70 cm"), r'^mass must be a mass.*"cm" does not measure a mass'),
    (without(mass="heavy"), r"^mass must be a mass.*does not begin with a number"),
    (without(mass=math.nan), r"^mass must be .* not a finite number"),
    (without(swings="3"), r"^swings must be a whole number, at least 5.*got 3; .* swing_period"),
    (without(swings=50.5), r"^swings must be a whole number"),
    (without(swings="50 swings"), r'^swings must be a pure number.*unknown unit "swings"'),
    (without("balance_point", balance_tilt=36), r"^balance_tilt must be at most 90 deg.*radians"),
    (without(gravity=0), r"^gravity must be > 0"),
    (without(swings_time="19 s"), r"^swings_time: a swing takes 0.38 s.*more than 0.5877 s.*back"),
    (without(across_period="0.6 s"), r"^across_period.*0.6 s.*0.7082 s \(C = 0\).*\(C = 2A\)"),
    (without(across_period="0.9 s"), r"^across_period.*0.9 s.*between"),
    (without(across_period="0.73 s", across_pivot="nail"), r"unknown across_pivot 'nail'"),
    (without(across_pivot="point"), r"^across_pivot needs across_swings"),
    (
        without(slope_length="1 m", slope_height="10 cm", slope_time="1 s"),
        r"^slope_time: 1 s down this slope, but even sliding without friction takes 1.428 s",
    ),
    (
        without(slope_length="1.00 m", slope_height="10.0 cm", slope_time="3.0 s"),
        r"^slope_time: 3 s down this slope.*at most 2.02 s",
    ),
    (
        without(slope_length="1 m", slope_height="2 m", slope_time="1 s"),
        r"^slope_height must be less than slope_length.*got 200 cm",
    ),
    (
        without("swings", "swings_time", rocking_tilt="40 deg", rocking_time="1 s"),
        r"^rocking_tilt must be less than .* balances, 36.4692°, got 40°",
    ),
    (
        without("swings", "swings_time", rocking_tilt="20 deg", rocking_time="0.1 s"),
        r"^rocking_time: 0.1 s .* more than 0.2709 s",
    ),
    (
        without(
            "swings", "swings_time", rocking_tilt=0.3, rocking_time=1.0, swing_amplitude="5 deg"
        ),
        r"^swing_amplitude needs swings",
    ),
    (
        without("swings", "swings_time", swing_period="0.6 s"),
        r"^C cannot be guessed for so flat a body.*look at swing_period again",
    ),
]


def test_how_tall_a_body_is_changes_nothing_and_may_be_as_uncertain_as_the_rest():
    plain = rr.measure(**KITCHEN)
    for length in ("13 cm", 0.0691, "6.8 cm"):  # the last two within their uncertainties
        tall = rr.measure(**KITCHEN, length=length)
        assert numbers(tall) == numbers(plain)
        assert set(tall.readings) - set(plain.readings) == {"length"}


@pytest.mark.parametrize(("readings", "complaint"), REFUSED)
def test_what_cannot_be_is_refused_by_the_name_of_the_measurement(readings, complaint):
    with pytest.raises(rr.RimrollError) as refusal:
        rr.measure(**readings)
    assert re.search(complaint, str(refusal.value)), refusal.value
    assert "\n" not in str(refusal.value)


# The command


@pytest.fixture
def stdout_of(capsys):
    def run(arguments):
        assert main(arguments.split()) == 0
        captured = capsys.readouterr()
        assert captured.err == ""
        return captured.out

    return run


def test_the_command_shows_values_and_where_their_uncertainty_comes_from(stdout_of):
    text = stdout_of(f"measure {LINE}")
    assert "diameter 10.20 ± 0.05 cm" in text  # its assumptions
    assert "swings time 38.30 ± 0.10 s" in text
    assert re.search(r"A/m +\(5.14 ± 0.07\)×10⁻³ m² +1.3 % +swings-time", text)
    assert re.search(r"axial inertia C +137 ± 26 kg mm² +19 % +estimate", text)
    assert re.search(r"no-slip +\(202.26 ± 0.28\)°", text)
    assert "C is not measured but guessed" in text
    assert max(map(len, text.splitlines())) < 80


def test_with_c_measured_there_is_no_guess(stdout_of):
    text = stdout_of(f"measure {LINE} --across-swings 50 --across-time 36.6s")
    assert "guessed" not in text and "across-time" in text


def test_json_has_each_number_with_its_uncertainty(stdout_of):
    answer = json.loads(stdout_of(f"measure {LINE} --json"))
    measured = rr.measure(**KITCHEN)
    for name in FIELDS:
        number = getattr(measured, name)
        assert answer["body"][name] == {"value": number.n, "uncertainty": number.s}
    assert answer["turn_limit"]["no_slip"]["uncertainty"] == measured.turn_no_slip.s
    assert answer["axial_inertia_measured"] is False
    assert answer["readings"]["swings"] == {"value": 50.0, "uncertainty": 0.0}


def test_the_file_is_a_scenario_that_other_commands_take(stdout_of, tmp_path):
    file = tmp_path / "my_can.toml"
    assert f"wrote {file}" in stdout_of(f"measure {LINE} -o {file}")
    body = rr.measure(**KITCHEN).body
    assert load(file).body == body
    comments = file.read_text()
    assert "swings_time = 38.30 ± 0.10 s" in comments and "(a guess)" in comments
    answer = json.loads(stdout_of(f"turn {file} --json"))
    assert answer["turn_limit"]["no_slip"] == rr.turn_limit(body, rr.NoSlip())
    assert "202." in stdout_of(f"simulate --scenario {file} --tilt 20deg --yaw-rate 0.005")


def test_a_file_is_whole_or_not_there(capsys, monkeypatch, tmp_path):
    file = tmp_path / "my_can.toml"
    file.write_text("older")
    assert main(["measure", *LINE.split(), "--mass", "-1g", "-o", str(file)]) == 2
    assert "--mass must be > 0" in capsys.readouterr().err

    def full(*_, **__):
        raise OSError(28, "No space left on device")

    monkeypatch.setattr("pathlib.Path.write_text", full)
    assert main(["measure", *LINE.split(), "-o", str(file)]) == 2
    assert f"cannot write {file}: No space left" in capsys.readouterr().err
    assert file.read_text() == "older"
    assert [path.name for path in tmp_path.iterdir()] == [file.name]


@pytest.mark.parametrize(
    ("arguments", "complaint"),
    [
        ("", "a measurement also needs --mass; --radius or --diameter;"),
        (f"{LINE} --balance-tilt 36deg", "--balance-point and --balance-tilt measure the same"),
        (f"{LINE} --swings 3", "--swings must be a whole number, at least 5"),
        (f"{LINE} --swings-time 19s", "--swings-time: a swing takes 0.38 s"),
        (f"{LINE} --length 5cm", "--balance-point: the centre of mass would be 6.9 cm above"),
        (f"{LINE} --mass 70cm", '"cm" does not measure a mass'),
        (f"{LINE} -o can.csv", "cannot write can.csv: its suffix must be .toml"),
        (f"{LINE} --colour red", "No such option: --colour"),
    ],
)
def test_bad_input_is_one_line_and_exit_code_2(capsys, arguments, complaint):
    assert main(["measure", *arguments.split()]) == 2
    error = capsys.readouterr().err
    assert complaint in error and error.count("\n") == 1


def test_the_examples_in_the_help_work(stdout_of, monkeypatch, tmp_path):
    monkeypatch.chdir(tmp_path)
    whole_lines = re.sub(r" \\\n\s+", " ", command.__doc__)
    examples = re.findall(r"\$ rimroll (.+)", whole_lines)
    assert len(examples) == 2
    for example in examples:
        assert "turn limit, no-slip" in stdout_of(example)
    assert "$ rimroll measure" in stdout_of("measure --help")


@examples(20, derandomize=True)
@given(bodies())
def test_any_measured_body_can_be_written_and_read(tmp_path_factory, body):
    file = tmp_path_factory.mktemp("measured") / "body.toml"
    given = body_readings(body)
    names = {name: f"{value!r}" for name, value in given.items()}
    arguments = [part for name, text in names.items() for part in (f"--{name}", text)]
    code = main(["measure", *(a.replace("_", "-") for a in arguments), "-o", str(file), "--json"])
    assert code == 0
    assert load(file).body.mass == body.mass


def test_what_no_table_holds_is_refused():
    with pytest.raises(rr.RimrollError, match="mass is no reading on a table: 1e-300 kg"):
        rr.measure(mass=1e-300, radius=0.05, balance_point=0.07, swing_period=0.77)
