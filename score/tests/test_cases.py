"""The cases are what rimroll computes, and the measures find no error in rimroll's own motions."""

import ast
import math
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from rimroll_score import film, search, tables, truth
from rimroll_score.badge import badge
from rimroll_score.cases import FILE, cases, falls
from rimroll_score.checks import variants
from rimroll_score.distribution import distribution
from rimroll_score.environments import PINS
from rimroll_score.euler import tilt_of, wrapped
from rimroll_score.measures import energies, lowest, measured, slipped
from rimroll_score.page import CHECKS, Bounds, cell, write
from rimroll_score.paths import path_of, seen_from_above, true_path
from rimroll_score.protocol import (
    friction_departures,
    inertia_departures,
    loss_departures,
    quaternion,
    rotation_matrix,
)
from rimroll_score.results import EngineResult, load, save
from rimroll_score.sweep import STEPS, Run, grade, run, task
from rimroll_score.worker import Worker

ROOT = Path(__file__).parents[2]
CASES = {case.name: case for case in cases()}
ITSELF = "rimroll_score.adapters.rimroll_itself:Rimroll"


@pytest.fixture(scope="module")
def rimroll_itself():
    with Worker(ITSELF, sys.executable) as worker:
        yield worker


def numbers(text):
    """The numbers of a file and the words between them."""
    words = text.replace("[", " ").replace("]", " ").replace(",", " ").split()
    read = []
    for word in words:
        try:
            read.append(float(word))
        except ValueError:
            read.append(word)
    return read


@pytest.mark.slow
def test_the_file_of_cases_is_what_rimroll_computes():
    stored, found = numbers(FILE.read_text("utf-8")), numbers("\n".join(truth.lines()))
    assert len(stored) == len(found)
    for old, new in zip(stored, found, strict=True):
        assert old == (pytest.approx(new, rel=1e-11, abs=1e-11) if isinstance(new, float) else new)


def test_the_limit_of_the_turn_is_approached_by_the_three_near_collisions():
    """pi sqrt(J/K) = 202.28719483 and 220.96915717 degrees (Srinivasan & Ruina 2007, corrected)."""
    for way, limit in (("rolling", 202.28719483), ("sliding", 220.96915717)):
        beyond = [
            CASES[f"{way}_{near}"].truth["turn"] - limit for near in ("far", "near", "nearer")
        ]
        assert beyond[0] > 3.0 * beyond[1] > 9.0 * beyond[2] > 0.0


def test_the_disk_closes_its_circle_once_round():
    case = CASES["circle"]
    assert case.truth["axis"] == pytest.approx(case.state.rotation[:, 2].tolist(), abs=1e-9)
    assert case.truth["position"][:2] == pytest.approx([0.0, 0.0], abs=1e-9)


def test_angular_momentum_turns_the_axis_in_free_flight_as_an_integration_says():
    case = CASES["flight"]
    body, steps = case.scene.body, 20_000
    axis, turning = case.state.rotation[:, 2], case.state.angular_velocity
    momentum = body.transverse_inertia * turning
    momentum += (body.axial_inertia - body.transverse_inertia) * (axis @ turning) * axis
    dt = case.duration / steps
    for _ in range(steps):  # midpoint rule on d(axis)/dt = L/A x axis
        middle = axis + 0.5 * dt * np.cross(momentum, axis) / body.transverse_inertia
        axis = axis + dt * np.cross(momentum, middle) / body.transverse_inertia
    assert axis.tolist() == pytest.approx(case.truth["axis"], abs=1e-6)


@pytest.mark.parametrize("name", [name for name in CASES if name not in ("straight", "flight")])
def test_rimroll_is_right_by_the_interface_of_every_engine(name, rimroll_itself):
    found = run(rimroll_itself, CASES[name], 1e-3, "best")
    assert found.status == "ok", found.message
    assert found.error < 0.02  # the highest tilt lies between two samples
    # Friction takes energy between two samples.
    assert found.energy < (1e-4 if name == "friction" else 1e-6)
    assert found.measured.right_side in (True, None)
    assert found.measured.penetration < 1e-8
    assert found.measured.slip is None or found.measured.slip < 1e-8


def test_what_rimroll_has_not_is_unsupported(rimroll_itself):
    for name, why in (("straight", "cannot stand on its side"), ("flight", "no free flight")):
        found = run(rimroll_itself, CASES[name], 1e-3, "best")
        assert found.status == "unsupported" and why in found.message


def test_changes_that_change_nothing_do_not_change_the_error(rimroll_itself):
    for name, varied in variants(CASES["rolling_near"], 2e-3):
        for case, dt in varied:
            found = run(rimroll_itself, case, dt, "best")
            assert found.error < 0.02 and found.energy < 1e-6, name


def test_the_falls_are_two_humps_and_rimroll_finds_them(rimroll_itself):
    known = falls()
    assert len(known.directions) == len(known.states) == 42
    sides = [direction > math.pi for direction in known.directions]
    assert 5 < sum(sides) < 37
    found = distribution(rimroll_itself, known, 5e-3, "best")
    assert found.right_sides == 42 and found.median_error < 0.5


def test_a_body_that_stays_where_it_is_lies_down_or_errs(rimroll_itself):
    case = CASES["rolling_near"]
    outcome = rimroll_itself.run(task(case.scene, case.state, case.duration, 1e-3, "best"))
    whole = outcome.samples
    flat = np.broadcast_to(np.eye(3), whole.rotation.shape).copy()
    flat[0] = whole.rotation[0]
    lying = type(whole)(whole.time, whole.position, flat, 0 * whole.velocity, 0 * whole.velocity)
    found = measured(case, lying)
    assert found.angle_error is None and found.note == "lay down flat"
    assert found.right_side is False


def test_measures_of_a_motion_that_is_shifted(rimroll_itself):
    case = CASES["wobble"]
    outcome = rimroll_itself.run(task(case.scene, case.state, case.duration, 1e-3, "best"))
    whole = outcome.samples
    sunk = type(whole)(
        whole.time, whole.position - np.array([0.0, 0.0, 1e-4]), whole.rotation,
        whole.velocity + np.array([0.02, 0.0, 0.0]), whole.angular_velocity,
    )  # fmt: skip
    body = case.scene.body
    assert -lowest(body, sunk).min() == pytest.approx(1e-4, rel=1e-6)
    assert slipped(body, sunk) == pytest.approx(0.02 * case.duration, rel=1e-6)
    change = energies(case.scene, sunk)[0] - energies(case.scene, whole)[0]
    by_hand = 0.5 * body.mass * 0.02**2 - body.mass * case.scene.gravity * 1e-4
    assert change == pytest.approx(by_hand, rel=1e-6)


def fallen(dt, error, energy):
    return Run("c", "s", dt, "ok", "", 1.0, Found(error, energy), ())


class Found:
    right_side = True

    def __init__(self, error, energy):
        self.angle_error, self.energy_error = error, energy


def test_the_grade_is_the_largest_step_from_which_on_all_are_within_the_bounds():
    runs = [
        fallen(1e-3, 0.1, 0.0), fallen(5e-4, 3.0, 0.0), fallen(2e-4, -0.9, 0.005),
        fallen(1e-4, 0.1, -0.009),
    ]  # fmt: skip
    assert grade(runs) == 2e-4  # the lucky hit at 1e-3 does not count
    assert grade(runs, max_energy=0.001) is None
    assert grade([*runs, Run("c", "s", 1e-5, "raised", "", None, None, ())]) is None
    assert cell(runs, Bounds()).text == "0.2 ms"
    assert cell([fallen(1e-4, 5.0, 0.0)], Bounds()).text == "none tried"


def test_quaternions_and_rotation_matrices_agree():
    for angles in ((0.3, -1.0, 2.0), (math.pi, 0.0, 0.0), (0.0, math.pi, 0.0), (3.1, 3.0, -3.0)):
        size = np.linalg.norm(angles)
        half = 0.5 * size
        q = np.array([math.cos(half), *(math.sin(half) * np.array(angles) / size)])
        assert rotation_matrix(quaternion(rotation_matrix(q))) == pytest.approx(
            rotation_matrix(q), abs=1e-12
        )


def test_an_inertia_that_the_engine_changed_is_a_departure():
    body = CASES["wobble"].scene.body
    asked = (body.transverse_inertia, body.transverse_inertia, body.axial_inertia)
    assert inertia_departures(body, body.mass, asked) == []
    changed = inertia_departures(body, body.mass, (asked[0], asked[1], 2.0 * asked[2]))
    assert changed == ["axial inertia is 0.00028 kg m², not 0.00014 kg m²"]


def test_friction_and_losses_that_were_not_asked_are_departures():
    assert friction_departures(0.2, np.float32(0.2)) == []
    assert friction_departures(math.inf, 1.0) == ["friction is 1, not infinite"]
    assert friction_departures(0.2, 0.04) == ["friction is 0.04, not 0.2"]
    assert loss_departures(linear_damping=0.0, angular_damping=0.04) == [
        "angular damping is 0.04, not 0"
    ]


def test_results_survive_a_file_and_make_a_page_and_a_badge(rimroll_itself, tmp_path):
    runs = [run(rimroll_itself, CASES["rolling_near"], dt, "best") for dt in (2e-3, 1e-3)]
    path = {"best": [[0.0, 0.0, 0.08, 0.5, 0.0], [0.01, 0.0, 0.08, 0.4, 3.1]]}
    machine = {"processor": "p", "cores": "1", "system": "s", "python": "3"}
    one = EngineResult("mine", "1.0", {"best": "as is"}, "rimroll score mine", machine, "r",
                       runs, paths=path)  # fmt: skip
    save(tmp_path, [one])
    kept = load(tmp_path)["mine"]
    for run_kept, true in zip(kept.runs, runs, strict=True):
        assert run_kept.cost == pytest.approx(true.cost, rel=1e-5)
        assert run_kept.error == pytest.approx(true.error, rel=1e-5)
        assert run_kept.energy == pytest.approx(true.energy, rel=1e-5)
        assert run_kept.measured.right_side is true.measured.right_side
        plain = {"cost": None, "measured": None}
        assert replace(run_kept, **plain) == replace(true, **plain)
    assert replace(kept, runs=[]) == replace(one, runs=[])
    first = (tmp_path / "results.json").read_bytes()
    save(tmp_path, [kept])
    assert (tmp_path / "results.json").read_bytes() == first
    text = write(tmp_path, [one], Bounds()).read_text("utf-8")
    assert "mine 1.0" in text and '<td class="good"' in text and "2 ms" in text
    assert "<script" not in text and "<link" not in text
    assert "right to 2 ms" in badge(one, Bounds())
    assert "right at no step tried" in badge(one, Bounds(0.0, 0.0))
    assert "rolling_near not scored" in badge(replace(one, runs=[]), Bounds())


def test_a_film_shows_the_true_can_and_one_for_each_setting(rimroll_itself, tmp_path):
    near = CASES["rolling_near"]
    outcome = rimroll_itself.run(task(near.scene, near.state, near.duration, 1e-3, "best"))
    found = path_of(outcome.samples)
    true = true_path(near)
    assert len(found) == len(true) == 161
    np.testing.assert_allclose(np.array(found)[:, :4], true[:, :4], atol=1e-4)
    assert np.abs(seen_from_above(np.array(found)) - seen_from_above(true)).max() < 2e-4
    one = EngineResult("mine", "1.0", {"best": ""}, "", {}, "", paths={"best": found[:4]})
    with Image.open(film.write(tmp_path, one)) as picture:
        assert (picture.size, picture.n_frames) == ((2 * film.SIZE, film.SIZE), 161)
        shown = np.asarray(picture.convert("RGB"), float)
    # At first both cans are alike; the words above them differ.
    left, right = shown[20:, : film.SIZE], shown[20:, film.SIZE :]
    assert np.abs(left - right).mean() < 1.0
    assert film.write(tmp_path, replace(one, paths={})) is None


def test_wrapped_angles_and_tilts():
    assert wrapped(1.5 * math.pi) == pytest.approx(-0.5 * math.pi)
    assert tilt_of(np.array([[0.0, 0.0, -1.0], [1.0, 0.0, 0.0]])) == pytest.approx(
        [math.pi, 0.5 * math.pi]
    )


def test_one_coin_is_above_and_one_below_the_rate_of_theory():
    """A thin uniform disk stands above Omega² = m g R/(A + m R²) = 4g/(5R)."""
    critical = math.sqrt(4.0 * 9.8 / (5.0 * 0.05))
    assert CASES["spin_fast"].truth["largest_yaw_rate"] == pytest.approx(2.0 * critical)
    assert CASES["spin_slow"].state.angular_velocity[2] == pytest.approx(0.5 * critical)


@pytest.fixture(scope="module")
def stored():
    return load(ROOT / "score/results")


def test_the_tables_of_the_documentation_are_those_of_the_stored_results(stored):
    page = (ROOT / "docs/physics-engines.md").read_text("utf-8")
    tried = search.load(ROOT / "score/results")
    assert tables.filled(page, list(stored.values()), tried) == page


def test_the_stored_results_are_whole_small_and_of_pinned_versions(stored):
    assert (ROOT / "score/results/results.json").stat().st_size < 300e3
    assert set(stored) == set(PINS)
    for name, one in stored.items():
        assert {run.case for run in one.runs} == set(CASES), name
        assert not {run.status for run in one.runs} - {"ok", "unsupported", "raised", "invalid"}
        assert {run.setting for run in one.runs} == set(one.settings) >= {"defaults", "best"}
        if PINS[name]:
            assert PINS[name][0].endswith(f"=={one.version}")
        whole = name != "newton"  # whose steps cost too much
        assert {run.dt for run in one.runs} == set(STEPS if whole else STEPS[:4])
        assert {falls.setting for falls in one.falls} == set(one.settings if whole else ())
        assert {check.name for check in one.checks} == set(CHECKS if whole else ())


def named_in(adapter, name):
    """A literal in the class of an adapter, which cannot be imported without its engine."""
    text = (ROOT / f"score/src/rimroll_score/adapters/{adapter}.py").read_text("utf-8")
    assigned = [node for node in ast.walk(ast.parse(text)) if isinstance(node, ast.AnnAssign)]
    (value,) = (node.value for node in assigned if ast.unparse(node.target) == name)
    return ast.literal_eval(value)


@pytest.mark.parametrize("engine", sorted(set(PINS) - {"newton", "rimroll"}))
def test_all_choices_were_tried_and_none_is_better_than_the_best(engine, stored):
    tried = [one for one in search.load(ROOT / "score/results") if one.engine == engine]
    plain, *others = tried
    best, choices = named_in(engine, "best"), named_in(engine, "choices")
    assert (plain.option, plain.value) == ("", best)
    assert {one.version for one in tried} == {stored[engine].version}
    assert {(one.option, one.value) for one in others} == {
        (name, value) for name, values in choices.items() for value in values
    } - set(best.items())
    for one in others:  # a run more that passes, or errors that are smaller by a tenth
        better = one.passed > plain.passed or one.misfit < plain.misfit - math.log10(1.1)
        assert not (better and one.passed >= plain.passed), one


def test_a_search_changes_one_option_at_a_time():
    with Worker(f"{Path(__file__).with_name('tuned.py')}:Tuned") as worker:
        plain, near, far, idle = search.search("tuned", worker)
    assert [one.option for one in (plain, near, far, idle)] == ["", "off", "off", "idle"]
    assert (near.value, far.value, idle.value) == (1e-4, 0.1, 2)
    assert plain.value == {"off": 0.0, "idle": 1}
    assert plain.runs == 2 * (len(search.PROBES) - 1)  # rimroll has no free flight
    assert plain.passed == near.passed == idle.passed == plain.runs
    assert plain.misfit == idle.misfit < near.misfit < far.misfit


def test_rimroll_as_stored_is_what_it_computes_now(stored, rimroll_itself):
    (kept,) = (run for run in stored["rimroll"].of("rolling_near", "best") if run.dt == 2e-3)
    found = run(rimroll_itself, CASES["rolling_near"], 2e-3, "best")
    assert found.error == pytest.approx(kept.error, rel=1e-5)


def test_a_page_without_a_place_for_tables_is_refused():
    with pytest.raises(tables.NoPlace, match="needs the lines <!-- results -->"):
        tables.put("no place", "results", "tables")
