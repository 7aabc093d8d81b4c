"""The comparison with the peers: its tools work, and its page shows the stored run."""

import json
import shutil
import sys
from pathlib import Path

import numpy as np
import pytest

ROOT = Path(__file__).parents[2]
sys.path.insert(0, str(ROOT / "bench"))

from contest import tables  # noqa: E402
from contest.contestants import CONTESTANTS, PEERS_PY  # noqa: E402
from contest.results import Results, frontier  # noqa: E402
from contest.rounds import Point, repeat, sweep  # noqa: E402
from contest.starts import every, near_collisions, sixty_turns, two_seconds  # noqa: E402
from contest.worker import Complaint, Question, Worker  # noqa: E402

RESULTS = ROOT / "bench/results/results.json"


@pytest.fixture(scope="module")
def worker():
    with Worker([sys.executable, PEERS_PY / "worker.py", "rimroll_itself"]) as at_work:
        yield at_work


def ensemble():
    return next(one for one in CONTESTANTS if one.method == "rimroll_ensemble")


@pytest.mark.parametrize("law", ["no_slip", "frictionless"])
def test_a_contestant_is_timed_in_rounds_and_its_error_verified(worker, law):
    point = Point(ensemble(), "turn", law, 1e-9, every(sixty_turns(), 20))
    assert list(sweep([point], worker)) == [point]
    repeat([point], {"rimroll": worker}, rounds=2)
    assert 0.0 < point.median <= point.worst < 1e-8
    assert len(point.seconds) == 2 and all(seconds > 0.0 for seconds in point.seconds)


def test_a_contestant_that_cannot_says_so(worker):
    question = Question("turn", "no_such_method", "regular", "no_slip", 1e-9, sixty_turns().path)
    with pytest.raises(Complaint, match="no_such_method"):
        worker.ask(question)


def test_the_motion_of_two_seconds_ends_where_the_truth_says(worker):
    question = Question(
        "motion", "rimroll_simulate", "regular", "no_slip", 1e-12, two_seconds().path
    )
    found = worker.ask(question).found
    np.testing.assert_allclose(found, two_seconds().truth("motion", "no_slip"), atol=1e-10)


def test_ever_nearer_starts_approach_the_limit_of_the_turn():
    """pi sqrt(J/K) = 202.28719483 degrees for the can (Srinivasan & Ruina 2007, corrected)."""
    nearest = near_collisions()[1e-12]
    turns = np.degrees(nearest.truth("turn", "no_slip"))
    np.testing.assert_allclose(turns, 202.28719483, atol=1e-8)


def test_of_settings_that_others_beat_none_is_drawn():
    row = {"method": "m", "coordinates": "c", "law": "l", "tolerance": 1.0, "every": 1}
    costs = [(1e-3, 1.0), (1e-3, 2.0), (1e-6, 3.0), (1e-5, 4.0), (None, 0.5)]
    rows = [row | {"worst": w, "median": w, "eps": None, "rounds": [s]} for w, s in costs]
    machine = {"machine": {}, "rounds": 1, "turns": rows, "near": [], "motions": []}
    errors, seconds = frontier(Results.from_json(machine).turns)
    assert errors.tolist() == [1e-3, 1e-6] and seconds.tolist() == [1.0, 3.0]


def test_the_page_shows_the_run_that_is_kept(tmp_path):
    results = Results.from_json(json.loads(RESULTS.read_text("utf-8")))
    page = tmp_path / "performance.md"
    shutil.copy(ROOT / "docs/performance.md", page)
    tables.put_between(page, "results", tables.summary(results))
    assert page.read_text("utf-8") == (ROOT / "docs/performance.md").read_text("utf-8")
    assert (RESULTS.parent / "table.md").read_text("utf-8") == tables.page(results)
