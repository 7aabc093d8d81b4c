"""Friction by a table over the slip speed, from tables and from functions."""

import json
import pickle

import numpy as np
import pytest
import xarray as xr
from hypothesis import given
from hypothesis import strategies as st
from scipy.interpolate import PchipInterpolator

import rimroll as rr
from given.strategies import composed_bodies, examples
from rimroll import cli
from rimroll.laws import law_of

CAN = rr.bodies.can_2007()
START = rr.State(tilt=0.5, tilt_rate=-0.5, yaw_rate=0.6, spin_rate=-0.3)
FALLING = rr.Tabulated(
    speeds=[0.0, 0.02, 0.05, 0.1, 0.3], frictions=[0.3, 0.25, 0.18, 0.16, 0.15], static=0.33
)


@st.composite
def tables(draw):
    """Speeds from 0 or a little more, and frictions that fall and rise."""
    thousandths = st.integers(0, 800).map(lambda thousandths: thousandths / 1000.0)
    steps = draw(st.lists(st.floats(1e-3, 0.5), min_size=1, max_size=8))
    speeds = draw(st.sampled_from([0.0, 0.01])) + np.cumsum([0.0, *steps])
    frictions = draw(st.lists(thousandths, min_size=len(speeds), max_size=len(speeds)))
    excess = draw(st.sampled_from([0.0, 0.05]))
    return rr.Tabulated(speeds, frictions, static=frictions[0] + excess)


# The curve


@given(tables())
def test_the_curve_is_scipys_monotone_one_and_constant_outside(law):
    its = PchipInterpolator(law.speeds, law.frictions)
    inside = np.linspace(law.speeds[0], law.speeds[-1], 101)
    assert law.friction_at(inside) == pytest.approx(its(inside), abs=1e-13)
    assert law.friction_at(law.speeds) == pytest.approx(np.array(law.frictions), abs=1e-15)
    assert law.friction_at(0.0) == law.frictions[0]
    assert law.friction_at(10.0 + law.speeds[-1]) == law.frictions[-1]


def test_the_curve_takes_numbers_and_arrays():
    assert isinstance(FALLING.friction_at(0.05), float)
    assert FALLING.friction_at([[0.0, 0.05]]).tolist() == [[0.3, 0.18]]
    with pytest.raises(rr.RimrollError, match=r"^speeds\[1\] must be >= 0, got -1"):
        FALLING.friction_at([0.0, -1.0])


@given(st.floats(0.01, 0.5), st.floats(0.0, 0.5), st.floats(0.005, 1.0), st.floats(1e-8, 1e-3))
@examples(30)
def test_a_function_is_followed_to_its_tolerance_everywhere(least, more, width, tolerance):
    def mu(speed):
        return least + more * np.exp(-((speed / width) ** 2))

    law = rr.Tabulated.from_function(mu, [0.0, 3.0 * width], tolerance=tolerance)
    speeds = np.linspace(0.0, 3.0 * width, 5003)
    # What is between the places that are looked at may be off by a little more.
    assert np.max(np.abs(law.friction_at(speeds) - mu(speeds))) <= 1.5 * tolerance


@pytest.mark.parametrize(
    ("mu", "begin"),
    [
        (lambda u: 0.2 + 0.1 * np.exp(-(((u - 0.1) / 0.02) ** 2)), [0.0, 1.0]),
        (lambda u: 0.2 + 0.1 * np.exp(-(((u - 0.61) / 0.02) ** 2)), [0.0, 1.0]),
        (lambda u: 0.3 + 0.1 * np.sin(8.0 * np.pi * u) ** 2, [0.0, 0.5, 1.0]),
    ],
)
def test_narrow_and_periodic_features_between_the_given_speeds_are_followed(mu, begin):
    law = rr.Tabulated.from_function(mu, begin, tolerance=1e-5)
    speeds = np.linspace(0.0, 1.0, 20011)
    assert np.max(np.abs(law.friction_at(speeds) - mu(speeds))) <= 1.5e-5


def test_a_straight_line_needs_no_more_points_than_are_given():
    law = rr.Tabulated.from_function(lambda u: 0.2 + 0.1 * u, [0.0, 1.0])
    assert law.speeds == (0.0, 1.0)


@pytest.mark.parametrize(
    ("make", "says"),
    [
        (lambda: rr.Tabulated([0.0], [0.1]), "speeds must have at least 2 entries, got 1"),
        (lambda: rr.Tabulated([], []), "speeds must be a flat list|speeds must have at least 2"),
        (lambda: rr.Tabulated([0, 1], [0.1]), "frictions must have as many entries as speeds, 2"),
        (
            lambda: rr.Tabulated([0.0, 1.0, 0.5], [0.1, 0.1, 0.1]),
            r"speeds\[2\] must be at least 1e-12 m/s above speeds\[1\] = 1, got 0.5 m/s",
        ),
        (lambda: rr.Tabulated([0.0, 0.0], [0.1, 0.1]), r"speeds\[1\] must be at least"),
        (lambda: rr.Tabulated([-1.0, 1.0], [0.1, 0.1]), r"speeds\[0\] must be between 0 and"),
        (lambda: rr.Tabulated([0.0, np.nan], [0.1, 0.1]), r"speeds\[1\] must be between 0 and"),
        (lambda: rr.Tabulated([0, np.inf], [0.1, 0.1]), r"speeds\[1\] must be between 0 and"),
        (lambda: rr.Tabulated([0, 1], [0.1, -0.1]), r"frictions\[1\] must be between 0 and 1e6"),
        (lambda: rr.Tabulated([0, 1], [np.nan, 0.1]), r"frictions\[0\] must be between 0 and"),
        (lambda: rr.Tabulated([0, 1], [[0.1], [0.1]]), "frictions must be a flat list of numbers"),
        (lambda: rr.Tabulated([0, 1], ["a", 0.1]), r"frictions\[0\] must be a pure number"),
        (lambda: rr.Tabulated(0.1, [0.1, 0.1]), "speeds must be a flat list of numbers"),
        (
            lambda: rr.Tabulated([0, 1], [0.3, 0.1], static=0.2),
            r"static must be between frictions\[0\] = 0.3 and 1e6, got 0.2",
        ),
        (lambda: rr.Tabulated([0, 1], [0.3, 0.1], restitution=2.0), "restitution must be between"),
        (lambda: rr.Tabulated.from_function(0.3, [0, 1]), "mu must be a function"),
        (lambda: rr.Tabulated.from_function(lambda u: None, [0, 1]), r"mu\(0\) must be a single"),
        (lambda: rr.Tabulated.from_function(lambda u: 1 - u, [0, 2]), r"mu\(2\) must be between"),
        (lambda: rr.Tabulated.from_function(lambda u: np.nan, [0, 2]), r"mu\(0\) must be between"),
        (lambda: rr.Tabulated.from_function(abs, [1, 0]), r"speeds\[1\] must be at least"),
        (lambda: rr.Tabulated.from_function(abs, [0, 1], tolerance=0), "tolerance must be > 0"),
        (
            lambda: rr.Tabulated.from_function(lambda u: 0.1 if u < 0.3 else 0.2, [0, 1]),
            "mu cannot be followed to 1e-06 near 0.3 m/s with .* points: it must be continuous",
        ),
    ],
)
def test_what_is_no_curve_is_refused_in_words(make, says):
    with pytest.raises(rr.RimrollError, match=f"^({says})"):
        make()


# The motion


@given(
    composed_bodies(),
    st.floats(0.0, 0.6),
    st.floats(0.0, 0.2),
    st.sampled_from([0.0, 0.5]),
    st.floats(0.2, 0.6),
    st.floats(-3.0, 1.0),
    st.floats(0.1, 1.0),
    st.floats(-1.0, 1.0),
)
@examples(30)
def test_a_constant_curve_is_coulombs_law(
    body, friction, excess, restitution, part, tilting, yaw, spin
):
    rate = np.sqrt(9.8 / body.radius)
    start = rr.State(
        tilt=part * rr.balance_tilt(body),
        tilt_rate=tilting * rate,
        yaw_rate=yaw * rate,
        spin_rate=spin * rate,
    )
    static = friction + excess
    table = rr.Tabulated([0.0, 0.1, 0.7], [friction] * 3, static, restitution)
    ours, coulombs = (
        rr.simulate(body, start, law, 3.0 / rate, gravity=9.8)
        for law in (table, rr.Coulomb(friction, static, restitution))
    )
    assert (ours.status, ours.message) == (coulombs.status, coulombs.message)
    assert ours.phases == coulombs.phases
    kinds, coulombs_kinds = ([event.kind for event in one.events] for one in (ours, coulombs))
    assert kinds == coulombs_kinds
    assert np.array_equal(ours._table, coulombs._table)


@given(composed_bodies(), tables(), st.floats(0.2, 0.6), st.floats(0.1, 1.0), st.floats(-1.0, 1.0))
@examples(30)
def test_friction_is_that_of_the_curve_and_the_energy_is_accounted_for(body, law, part, yaw, spin):
    rate = np.sqrt(9.8 / body.radius)
    start = rr.State(
        tilt=part * rr.balance_tilt(body), yaw_rate=yaw * rate, spin_rate=spin * 0.3 * rate
    )
    motion = rr.simulate(body, start, law, 3.0 / rate, gravity=9.8)
    budget = motion.energy_budget
    assert np.max(np.abs(budget - budget[0])) < 1e-8 * budget[0]
    assert np.all(np.diff(motion.friction_loss) >= -1e-12 * budget[0])
    for phase in motion.phases:
        inside = (motion.t > phase.start) & (motion.t < phase.end)
        force = np.hypot(*motion.friction_force[inside].T)
        normal = motion.normal_force[inside]
        size = body.mass * 9.8 + normal
        if phase.kind == "sliding":
            mu = law.friction_at(np.hypot(*motion.slip[inside].T))
            assert np.all(np.abs(force - mu * normal) < 1e-9 * size)
        elif phase.kind == "rolling":
            assert np.all(force <= law.static * normal + 1e-8 * size)


def test_the_error_falls_with_the_tolerance_over_the_points_of_a_table():
    """The slope of the curve is continuous there, its curvature is not: steps are tried again."""
    start = rr.State(tilt=0.5, tilt_rate=-0.5, yaw_rate=2.0, spin_rate=20.0)
    law = rr.Tabulated([0.0, 0.2, 0.5, 0.8, 1.2], [0.1, 0.3, 0.15, 0.35, 0.2])
    ends = {
        rtol: rr.simulate(CAN, start, law, 0.1, rtol=rtol)(0.1)
        for rtol in (1e-6, 1e-8, 1e-10, 1e-13)
    }
    for rtol in (1e-6, 1e-8, 1e-10):
        for field in ("tilt", "yaw", "spin"):
            off = getattr(ends[rtol], field) - getattr(ends[1e-13], field)
            assert abs(off) < 100.0 * rtol, (rtol, field)


def test_painleves_paradox_is_met_where_the_curve_is_high_enough():
    start = rr.State(tilt=0.57, tilt_rate=-10.0, yaw_rate=-2.9, spin_rate=-25.0)
    enough = rr.painleve_friction(CAN)
    law = rr.Tabulated([0.0, 0.3, 1.0], [1.5 * enough, 0.3, 0.1])
    motion = rr.simulate(CAN, start, law, 1.0)
    assert motion.status == "painleve"
    slip = float(np.hypot(*motion.slip[-1]))
    assert slip > 0.0 and law.friction_at(slip) > enough
    # As much friction, but only at speeds that the slip never has.
    lower = rr.Tabulated([0.0, 0.3, 30.0, 40.0], [0.3, 0.3, 0.3, 1.5 * enough])
    assert rr.simulate(CAN, start, lower, 1.0).status != "painleve"


# Functions that take laws


def test_a_table_goes_with_resistances_friction_scale_and_ensembles():
    law = FALLING + rr.RollingResistance(dry=1e-3)
    starts = rr.State(tilt=np.full(5, 0.5), tilt_rate=-0.5, yaw_rate=np.linspace(0.1, 0.6, 5))
    friction_scale = np.linspace(0.5, 1.5, 5)
    falls = rr.ensemble(CAN, starts, law, friction_scale=friction_scale, rtol=1e-10)
    for i in range(5):
        scaled = rr.Tabulated(
            law.speeds, np.array(law.frictions) * friction_scale[i], law.static * friction_scale[i]
        ) + rr.RollingResistance(dry=1e-3)
        start = rr.State(tilt=0.5, tilt_rate=-0.5, yaw_rate=float(starts.yaw_rate[i]))
        turn = rr.simulate(CAN, start, scaled, 10.0, rtol=1e-10).turns[0]
        assert falls["turn"].values[i] == pytest.approx(turn.angle, abs=1e-7)


def test_attributes_give_the_law_back(tmp_path):
    law = rr.Tabulated(FALLING.speeds, FALLING.frictions, 0.33, 0.1) + rr.AirDrag(1e-6, 2.5)
    starts = rr.State(tilt=np.array([0.5, 0.4]), tilt_rate=-0.5, yaw_rate=0.1)
    falls = rr.ensemble(CAN, starts, law)
    assert law_of(falls) == law
    falls.to_netcdf(tmp_path / "falls.nc", engine="scipy")
    with xr.open_dataset(tmp_path / "falls.nc", engine="scipy") as read:
        assert law_of(read) == law
    motion = rr.simulate(CAN, START, law, 0.2)
    motion.to_xarray().to_netcdf(tmp_path / "motion.nc", engine="scipy")
    with xr.open_dataset(tmp_path / "motion.nc", engine="scipy") as read:
        assert tuple(read.attrs["law_speeds"]) == law.speeds


def test_a_table_is_pickled_hashed_compared_and_shown():
    again = pickle.loads(pickle.dumps(FALLING))
    assert again == FALLING and hash(again) == hash(FALLING)
    assert eval(repr(FALLING), vars(rr)) == FALLING
    motion = rr.simulate(CAN, START, FALLING, 0.2)
    assert np.array_equal(pickle.loads(pickle.dumps(motion)).tilt, motion.tilt)
    long = rr.Tabulated(np.linspace(0.0, 1.0, 100), np.full(100, 0.2))
    assert len(repr(long)) < 150


def test_a_table_that_holds_the_rim_turns_as_without_slip():
    held = rr.Tabulated([0.0, 1.0], [0.4, 0.1])
    assert rr.turn_limit(CAN, held) == rr.turn_limit(CAN, rr.NoSlip())


def test_the_limiting_turn_on_a_constant_curve_is_coulombs():
    arrival = rr.Arrival(tipping_rate=2.0, slip=0.01)
    for friction in (0.1, 0.3):
        constant = rr.Tabulated([0.0, 1.0], [friction] * 2)
        assert rr.turn_limit(CAN, constant, arrival) == rr.turn_limit(
            CAN, rr.Coulomb(friction), arrival
        )


SCENARIO = """
start = { tilt = "30 deg", tilt_rate = -0.5, yaw_rate = 0.6 }
[body]
preset = "can_2007"
[law]
kind = "tabulated"
speeds = ["0 m/s", "2 cm/s", 0.05, 0.1, 0.3]
frictions = [0.3, 0.25, 0.18, 0.16, 0.15]
static = 0.33
[simulation]
duration = 0.3
"""


def test_scenario_files_have_tables(tmp_path, capsys):
    file = tmp_path / "can.toml"
    file.write_text(SCENARIO)
    assert cli.main(["simulate", str(file), "--json"]) == 0
    parameters = json.loads(capsys.readouterr().out)["parameters"]
    assert parameters["law"] == "tabulated"
    assert tuple(parameters["law_speeds"]) == FALLING.speeds
    assert tuple(parameters["law_frictions"]) == FALLING.frictions
    for suffix in ("csv", "nc", "json", "png"):
        assert cli.main(["simulate", str(file), "-o", str(tmp_path / f"out.{suffix}")]) == 0
    assert cli.main(["topple", str(file), "-o", str(tmp_path / "falls.csv")]) == 0
    capsys.readouterr()
    file.write_text(SCENARIO.replace("0.05, 0.1", "0.05, 0.01"))
    assert cli.main(["simulate", str(file)]) == 2
    assert "speeds[3] must be at least 1e-12 m/s above" in capsys.readouterr().err
    assert cli.main(["simulate", "can_2007", "--law", "tabulated"]) == 2
    assert "tabulated needs speeds from a scenario file" in capsys.readouterr().err


# User-defined laws


class MyLaw(rr.Law):
    name = "mine"

    def __post_init__(self):
        """Without the package's checks."""


@pytest.mark.parametrize(
    "use",
    [
        lambda law: rr.simulate(CAN, START, law),
        lambda law: rr.ensemble(CAN, START, law),
        lambda law: rr.topple(CAN, law=law),
        lambda law: rr.turn_limit(CAN, law),
        lambda law: rr.passage(CAN, law),
        lambda law: rr.arrival(CAN, START, law),
        lambda law: rr.exact_turn(CAN, START, law),
        lambda law: rr.tall_turn_limit(CAN, law),
    ],
)
def test_a_users_class_of_law_is_refused_everywhere_with_a_reason(use):
    with pytest.raises(rr.RimrollError, match=r"got the class MyLaw: .* use rimroll\.Tabulated"):
        use(MyLaw())


def test_a_users_class_of_law_is_refused_when_it_is_made():
    class Fading(rr.Coulomb):
        """Looks like Coulomb's law and would be computed as that."""

    for make in (rr.Law, lambda: Fading(0.3), lambda: type("L", (rr.Law,), {})()):
        with pytest.raises(rr.RimrollError, match=r"^law must be one of rimroll's own, NoSlip, "):
            make()
