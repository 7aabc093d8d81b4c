"""Left or right: maps of falls over a plane of starts, and the line of the jump."""

import contextlib
import json
import re

import numpy as np
import pytest
import xarray as xr
from hypothesis import assume, given
from hypothesis import strategies as st
from scipy.integrate import solve_ivp

import rimroll as rr
from given.strategies import bodies, examples
from rimroll.cli import main
from rimroll.many.map_figure import directions, map_figure, middle_of_map, span
from rimroll.paper import setting
from rimroll.paper.figures import sensitivity

CAN, GRAVITY = setting.CAN, setting.GRAVITY
FLICK = sensitivity.FLICK
LAWS = [rr.NoSlip(), rr.Coulomb(0.15), rr.Coulomb(0.4), rr.Viscous(0.1), rr.Frictionless()]
IDEAL = [rr.NoSlip(), rr.Frictionless()]
RATES = np.array([-0.8, -0.3, 0.3, 0.8])


def comes_down(body, tilt, law):
    """Whether the rim of the released body stays on the table until the body is flat."""
    try:
        rr.arrival(body, rr.State(tilt=tilt), law, 9.8)
    except rr.RimrollError:
        return False
    return True


def fall(yaw_rate, spin_rate, law, rtol=1e-10):
    starts = rr.State(
        tilt=FLICK.tilt,
        tilt_rate=FLICK.tilt_rate,
        yaw_rate=np.atleast_1d(yaw_rate),
        spin_rate=np.atleast_1d(spin_rate),
    )
    return rr.ensemble(CAN, starts, law, gravity=GRAVITY, rtol=rtol)


@pytest.mark.parametrize("law", LAWS, ids=repr)
def test_mirrored_starts_fall_in_mirrored_directions(law):
    falls = rr.turn_map(CAN, FLICK, law, RATES, RATES, gravity=GRAVITY)
    mirrored = falls.isel(spin_rate=slice(None, None, -1), yaw_rate=slice(None, None, -1))
    # Not to the last bit, since the direction of slip is stored as an angle.
    assert falls.turn.values == pytest.approx(-mirrored.turn.values, abs=1e-9)
    directions = falls.direction.values + mirrored.direction.values
    assert directions == pytest.approx(2.0 * np.pi, abs=1e-9)
    assert falls.min_tilt.values == pytest.approx(mirrored.min_tilt.values, rel=1e-9, abs=0.0)
    assert np.array_equal(falls.outcome.values, mirrored.outcome.values)


def test_a_map_is_the_ensemble_of_its_starts_and_says_what_it_was_computed_from():
    seen = []
    falls = rr.turn_map(
        CAN,
        FLICK,
        rr.Coulomb(0.15),
        [-0.5, 0.1, 0.5],
        [-0.2, 0.3],
        gravity=GRAVITY,
        progress=lambda done, total: seen.append((done, total)),
    )
    assert dict(falls.sizes) == {"spin_rate": 2, "yaw_rate": 3}
    one = fall(0.1, 0.3, rr.Coulomb(0.15), rtol=1e-6)
    assert falls.turn.sel(yaw_rate=0.1, spin_rate=0.3) == one.turn[0]
    assert falls.turn.units == "rad"
    assert seen[-1] == (6, 6)
    assert falls.attrs["start_tilt_rate"] == -5.0
    assert falls.attrs["law_friction"] == 0.15
    assert falls.attrs["gravity"] == GRAVITY


STARTS = {
    "toppling": (CAN, FLICK),
    "rocking": (CAN, rr.State(tilt=0.5, tilt_rate=-0.5)),
    "rising": (CAN, rr.State(tilt=0.3, tilt_rate=0.5)),
    "falling_back": (CAN, rr.State(tilt=0.62, tilt_rate=0.5)),
    "leaving_the_table": (rr.bodies.battery(), rr.State(tilt=0.15, tilt_rate=-4.0)),
}


@pytest.mark.parametrize("law", IDEAL, ids=lambda law: law.name)
@pytest.mark.parametrize("name", STARTS)
def test_a_map_without_stepping_is_the_ensemble_of_its_starts(name, law):
    body, start = STARTS[name]
    rates = np.array([-7.0, -1.0, -0.2, 0.1, 3.0])
    falls = rr.turn_map(body, start, law, rates, rates, gravity=GRAVITY)
    starts = rr.State(
        tilt=start.tilt,
        tilt_rate=start.tilt_rate,
        yaw_rate=np.tile(rates, len(rates)),
        spin_rate=np.repeat(rates, len(rates)),
    )
    stepped = rr.ensemble(body, starts, law, gravity=GRAVITY, rtol=1e-11)
    assert np.array_equal(falls.outcome.values.ravel(), stepped.outcome.values)
    for variable in falls.data_vars:
        if variable != "outcome":
            values = falls[variable].values.ravel()
            defined = ~np.isnan(values)
            steps = stepped[variable].values[defined]
            # Near the balance point errors of steps grow e-fold several times.
            within = 2e-7 if name == "falling_back" else 1e-7
            assert values[defined] == pytest.approx(steps, rel=1e-8, abs=within)
            if variable in ("turn", "direction", "min_tilt", "min_tilt_time"):
                assert np.array_equal(defined, ~np.isnan(stepped[variable].values))


def test_a_map_has_the_exact_turns_of_its_starts():
    rates = np.linspace(-7.0, 7.0, 6)
    falls = rr.turn_map(CAN, FLICK, rr.NoSlip(), rates, rates)
    starts = rr.State(
        tilt=FLICK.tilt,
        tilt_rate=FLICK.tilt_rate,
        yaw_rate=rates[None, :] + 0.0 * rates[:, None],
        spin_rate=rates[:, None] + 0.0 * rates[None, :],
    )
    turns = rr.exact_turn(CAN, starts, rr.NoSlip())
    for name in ("turn", "min_tilt", "min_tilt_time", "end_time", "end_tilt"):
        assert np.array_equal(falls[name].values, getattr(turns, name), equal_nan=True)
    assert np.array_equal(falls.outcome.values, turns.outcome)


@pytest.mark.parametrize("law", [rr.NoSlip(), rr.Coulomb(0.2)], ids=lambda law: law.name)
@pytest.mark.parametrize(
    ("option", "message"),
    [
        ({"duration": -1.0}, "duration must be > 0, got -1 s"),
        ({"duration": "long"}, 'duration must be a time such as "2 s"'),
        ({"rtol": 0.5}, "rtol must be between"),
        ({"max_steps": 0}, "max_steps must be a whole number >= 1, got 0"),
        ({"topple_tilt": 0.1}, "tilt must be below topple_tilt = 0.1 rad"),
        ({"progress": 3}, "progress must be None or something to call, got 3"),
    ],
)
def test_a_map_refuses_a_bad_option_whether_it_is_stepped_or_not(law, option, message):
    with pytest.raises(rr.RimrollError, match=rf"^(at \[0\]: )?{message}"):
        rr.turn_map(CAN, FLICK, law, [0.1, 0.2], [0.1], **option)


@examples(20)
@given(bodies(), st.floats(0.1, 0.9), st.sampled_from(IDEAL))
def test_the_watershed_of_linear_theory_is_where_falls_change_sides(body, share, law):
    tilt = share * min(rr.balance_tilt(body), 1.2)
    assume(comes_down(body, tilt, law))
    slope = rr.watershed_slope(body, tilt, law)
    rates = np.sqrt(9.8 / body.radius) * np.array([1e-3, 1e-2])
    spin = rates / max(1.0, slope)
    beside = 1e-6 * rates  # far enough from the line that the base does not come down flat
    for side in (-1.0, 1.0):
        # A spin along the turn lifts the rim off; against it, it stays on the table.
        spins = -side * spin
        starts = rr.State(tilt=tilt, yaw_rate=slope * spins + side * beside, spin_rate=spins)
        falls = rr.ensemble(body, starts, law, gravity=9.8, duration=30.0)
        assert np.all(np.sign(falls.turn.values) == side)


def rolled_up_from_flat(body, tilt):
    """(l, s) at a tilt of the motion without slip with l = 0, s = 1 at φ = 0: ``noslip_eqs``."""
    m, r, h = body.mass, body.radius, body.height
    a, c = body.transverse_inertia, body.axial_inertia
    both = c * (a + m * h * h) + a * m * r * r

    def rates(phi, state):
        l, s = state
        per_sine = l / np.sin(phi) if phi > 0.0 else 0.0  # l ~ φ²
        return [
            c * ((c + m * r * r) * s * np.sin(phi) - m * h * r * l) / both,
            m * r * (h * c * s + a * r * per_sine) / both,
        ]

    # l begins as φ², so its error is compared with φ².
    atol = [1e-14 * tilt * tilt, 1e-14]
    done = solve_ivp(rates, (0.0, tilt), [0.0, 1.0], method="DOP853", rtol=1e-12, atol=atol)
    return done.y[:, -1]


@examples(25)
@given(bodies(), st.floats(0.01, 1.5))
def test_the_watershed_of_rolling_is_the_motion_that_rises_from_lying_flat(body, tilt):
    l, s = rolled_up_from_flat(body, tilt)
    yaw_rate = l / np.sin(tilt) ** 2
    slope = yaw_rate / (s - yaw_rate * np.cos(tilt))
    # Ten times the tolerance of the integration.
    assert rr.watershed_slope(body, tilt, rr.NoSlip()) == pytest.approx(slope, rel=1e-11, abs=0.0)


@examples(25)
@given(bodies(), st.floats(0.05, 1.4))
def test_the_watershed_without_friction_keeps_the_angular_momentum_of_a_flat_spin(body, tilt):
    spin_rate = 1.0
    yaw_rate = rr.watershed_slope(body, tilt, rr.Frictionless()) * spin_rate
    l, s = yaw_rate * np.sin(tilt) ** 2, spin_rate + yaw_rate * np.cos(tilt)
    vertical = body.transverse_inertia * l + body.axial_inertia * s * np.cos(tilt)
    assert vertical == pytest.approx(body.axial_inertia * s, rel=1e-9, abs=0.0)


@pytest.mark.parametrize("law", IDEAL, ids=repr)
def test_the_watershed_found_by_trial_is_that_of_linear_theory(law):
    spins = np.array([-3.0, -0.1, 0.0, 1e-6, 1.0])
    found = rr.watershed(CAN, FLICK, law, spins, gravity=GRAVITY)
    slope = rr.watershed_slope(CAN, FLICK.tilt, law)
    assert found == pytest.approx(slope * spins, rel=1e-9, abs=1e-13)
    harder = rr.State(tilt=FLICK.tilt, tilt_rate=-0.5)
    assert rr.watershed(CAN, harder, law, spins) == pytest.approx(found, rel=1e-9, abs=1e-13)


def test_under_friction_that_holds_the_rim_the_watershed_is_that_of_rolling():
    spins = np.array([0.01, 1.0])
    for friction, holds in ((0.3, True), (0.15, False), (0.05, False)):
        found = rr.watershed(CAN, FLICK, rr.Coulomb(friction), spins, gravity=GRAVITY)
        rolling, sliding = (rr.watershed_slope(CAN, FLICK.tilt, law) * spins for law in IDEAL)
        if holds:
            assert found == pytest.approx(rolling, rel=1e-9, abs=0.0)
        else:
            assert np.all((1.01 * rolling < found) & (found < sliding))


@pytest.mark.parametrize("law", IDEAL, ids=repr)
def test_the_jump_is_twice_what_the_limiting_turn_exceeds_half_a_turn_by(law):
    excess = 2.0 * (rr.turn_limit(CAN, law) - np.pi)
    for epsilon, within in ((1e-3, 2e-3), (1e-6, 4e-6), (1e-9, 1e-8)):
        right, left = fall([-epsilon, epsilon], [0.0, 0.0], law).direction.values
        assert left - right == pytest.approx(excess, abs=within)


def test_the_jump_without_friction_is_the_same_all_along_the_watershed():
    law = rr.Frictionless()
    excess = 2.0 * (rr.turn_limit(CAN, law) - np.pi)
    slope = rr.watershed_slope(CAN, FLICK.tilt, law)
    for spin in (0.01, 1.0, 3.0):
        yaw = slope * spin + np.array([-1e-8, 1e-8])
        right, left = fall(yaw, [spin, spin], law).direction.values
        assert left - right == pytest.approx(excess, abs=1e-6)


def test_the_smallest_tilt_is_proportional_to_the_distance_from_the_watershed():
    for law in IDEAL:
        yaw = rr.watershed_slope(CAN, FLICK.tilt, law) * 0.1 + np.array([-1e-6, -1e-7, -1e-8])
        least = fall(yaw, np.full(3, 0.1), law).min_tilt.values
        assert least[:2] / least[1:] == pytest.approx(10.0, rel=1e-4)


def test_a_map_without_falls_or_with_falls_all_round_is_drawn():
    falls = rr.turn_map(CAN, FLICK, rr.NoSlip(), [-1.0, 1.0], [-1.0, 1.0])
    assert span(falls) == 50.0
    assert map_figure(falls).axes[0].get_title(loc="left") == "no slip, from 20° at −5 rad/s"
    flat = rr.turn_map(CAN, FLICK, rr.NoSlip(), [0.0], [0.0])
    assert flat.outcome.values == "face_down" and span(flat) == 180.0
    map_figure(flat)


def test_the_command_writes_the_map_that_the_api_computes(tmp_path, capsys):
    files = [tmp_path / f"map{suffix}" for suffix in (".nc", ".csv", ".png", ".json")]
    flick = ["--tilt", "20deg", "--tilt-rate", "-5rad/s", "--gravity", "9.8"]
    plane = ["--yaw-rates", "-30..30deg/s", "--spin-rates", "-1..1", "--starts", "4"]
    output = [part for file in files for part in ("-o", str(file))]
    assert main(["map", *flick, *plane, *output, "--json"]) == 0
    answer = json.loads(capsys.readouterr().out)
    yaw, spin = np.radians(np.linspace(-30.0, 30.0, 4)), np.linspace(-1.0, 1.0, 4)
    falls = rr.turn_map(CAN, FLICK, rr.NoSlip(), yaw, spin, gravity=GRAVITY, duration=2.0)
    with xr.open_dataset(files[0], engine="scipy") as stored:
        assert stored.turn.values == pytest.approx(falls.turn.values, rel=1e-12, abs=0.0)
        assert stored.attrs["gravity"] == GRAVITY
    lines = [line for line in files[1].read_text().splitlines() if not line.startswith("#")]
    head, *rows = (line.split(",") for line in lines)
    turns = np.array([float(row[head.index("turn[rad]")]) for row in rows])
    assert turns == pytest.approx(falls.turn.values.ravel(), rel=1e-12, abs=0.0)
    assert head[:4] == ["direction[deg]", "outcome", "spin_rate[rad/s]", "yaw_rate[rad/s]"]
    numbers = json.loads(files[3].read_text("utf-8"))
    assert numbers["coordinates"]["yaw_rate"] == pytest.approx(yaw, rel=1e-15, abs=0.0)
    assert np.shape(numbers["falls"]["turn"]) == (4, 4)
    assert files[2].read_bytes().startswith(b"\x89PNG")
    assert answer["left"]["falls"] == answer["right"]["falls"] == 8
    assert answer["watershed_slope"] == rr.watershed_slope(CAN, FLICK.tilt, rr.NoSlip())
    assert answer["jump"] == pytest.approx(2.0 * (rr.turn_limit(CAN, rr.NoSlip()) - np.pi))


def test_the_command_flicks_any_body_over_and_says_where_left_and_right_part(capsys):
    assert main(["map", "soda_can", "--starts", "6"]) == 0
    shown = capsys.readouterr().out
    assert re.search(r"to the left +18 ", shown) and re.search(r"to the right +18 ", shown)
    assert "left and right part where" in shown


def test_the_examples_in_the_help_of_the_command_work(tmp_path, capsys, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert main(["map", "--help"]) == 0
    lines = capsys.readouterr().out.splitlines()
    examples = [line.split("$ rimroll ")[1].split() for line in lines if "$ rimroll" in line]
    assert len(examples) == 3
    for example in examples:
        assert main([*example, "--starts", "4"]) == 0
    assert {file.name for file in tmp_path.iterdir()} == {"left_or_right.svg", "near.nc"}


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ("--yaw-rates 3", "--yaw-rates must be a range such as -1..1"),
        ("--spin-rates 3..1", "--spin-rates must rise, got '3..1'"),
        ("--spin-rates -1..1m", "does not measure an angular rate"),
        ("--starts 1", "--starts must be between 2 and 3000, got 1"),
        ("--duration -1s", "duration must be > 0, got -1 s"),
        ("--rtol 0.5", "rtol must be between 1e-14 and 1e-3, got 0.5"),
        ("-o map.txt", "cannot write map.txt: its suffix must be one of .csv"),
    ],
)
def test_the_command_refuses_what_is_no_map_in_a_line(capsys, arguments, message):
    assert main(["map", *arguments.split()]) == 2
    output = capsys.readouterr().err
    assert message in output and output.count("\n") == 1


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (
            lambda: rr.turn_map(CAN, FLICK, rr.NoSlip(), [0.1, 0.0], [0.0]),
            r"yaw_rates must rise from one to the next, got yaw_rates\[1\] = 0.0 after 0.1 rad/s",
        ),
        (lambda: rr.turn_map(CAN, FLICK, rr.NoSlip(), [0.0], [0.1, 0.1]), "spin_rates must rise"),
        (lambda: rr.turn_map(CAN, FLICK, rr.NoSlip(), [[0.1]], [0.0]), "yaw_rates must be a flat"),
        (lambda: rr.turn_map(CAN, FLICK, rr.NoSlip(), [], [0.0]), "yaw_rates must be a flat"),
        (lambda: rr.turn_map(CAN, FLICK, rr.NoSlip(), ["a"], [0.0]), "must be an angular rate"),
        (lambda: rr.turn_map(CAN, FLICK, rr.NoSlip(), [np.inf], [0.0]), "yaw_rates.0. must be fin"),
        (lambda: rr.turn_map(CAN, 0.3, rr.NoSlip(), [0.1], [0.0]), "start must be a rimroll.State"),
        (
            lambda: rr.turn_map(CAN, rr.State(tilt=[0.1, 0.2]), rr.NoSlip(), [0.1], [0.0]),
            "a motion has one start",
        ),
        (lambda: rr.watershed_slope(CAN, 0.3, rr.Coulomb(0.1)), "NoSlip or Frictionless"),
        (lambda: rr.watershed_slope(CAN, 2.0, rr.NoSlip()), r"tilt must be inside \(0, pi/2\)"),
        (lambda: rr.watershed(CAN, rr.State(tilt=1.2), rr.NoSlip(), [0.1]), "no watershed"),
        (lambda: rr.watershed(CAN, FLICK, rr.NoSlip(), "x"), "spin_rates must be an angular rate"),
    ],
)
def test_what_cannot_be_mapped_is_refused_in_a_line(call, message):
    with pytest.raises(rr.RimrollError, match=message):
        call()


def test_the_watershed_of_a_flat_body_has_digits_down_to_the_smallest_tilt():
    """C = 2A: C/(A (1 + cos φ) − C cos φ) = 1/sin²(φ/2)."""
    flat = rr.Body(1.0, 1.0, 0.0, 0.5, 1.0)
    for tilt in (1e-9, 1e-3, 1.0):
        slope = rr.watershed_slope(flat, tilt, rr.Frictionless())
        assert slope == pytest.approx(1.0 / np.sin(0.5 * tilt) ** 2, rel=1e-14, abs=0.0)


@pytest.mark.parametrize("law", [rr.NoSlip(), rr.Coulomb(0.3)], ids=lambda law: law.name)
def test_ctrl_c_leaves_the_rows_of_the_map_that_are_done(law, tmp_path, monkeypatch, capsys):
    """Rows of 100 falls, stopped halfway through a thousand: earlier rows are complete."""

    def stop(done: int, *_: object) -> None:
        if done >= 4000:
            raise KeyboardInterrupt

    few, rates = np.linspace(-1.0, 1.0, 100), np.linspace(-1.0, 1.0, 1000)
    with pytest.raises(rr.Interrupted) as interrupted:
        rr.turn_map(CAN, FLICK, law, few, rates, threads=1, progress=stop)
    rows = interrupted.value.done.sizes["spin_rate"]
    assert 0 < rows < 1000
    whole = rr.turn_map(CAN, FLICK, law, few, rates[:rows])
    assert interrupted.value.done.equals(whole)

    monkeypatch.setattr("rimroll.cli.map.working", lambda _: contextlib.nullcontext(stop))
    monkeypatch.chdir(tmp_path)
    assert main(["map", "--starts", "1000", "-o", "some.nc"]) == 130
    assert re.search(r"interrupted after \d+ of 1000 spin rates", capsys.readouterr().out)

    def one_row(*_: object, **__: object) -> None:
        raise rr.Interrupted(rr.turn_map(CAN, FLICK, rr.NoSlip(), rates[:3], rates[:1]))

    monkeypatch.setattr("rimroll.cli.map.map_falls", one_row)
    assert main(["map", "--starts", "400", "-o", "none.nc"]) == 130
    assert [file.name for file in tmp_path.iterdir()] == ["some.nc"]


def test_a_disk_s_map_is_coloured_about_where_it_falls():
    start = rr.State(tilt=0.7, tilt_rate=-2.0)
    falls = rr.turn_map(rr.bodies.coin(), start, rr.NoSlip(), [-1.0, 1.0], [-1.0, 1.0])
    assert middle_of_map(falls) == 0.0 and span(falls, 0.0) < 90.0
    left = falls.direction.values > np.pi
    assert np.array_equal(directions(falls, 0.0) < 0.0, left)
