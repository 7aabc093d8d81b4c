"""Both engines agree for extreme starts, and the census would notice if they did not."""

from __future__ import annotations

import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import rimroll as rr

BENCH = Path(__file__).parents[2] / "bench"


def test_a_small_census_leaves_nothing_unexplained():
    census = [sys.executable, str(BENCH / "census.py"), "--starts", "2000", "--seed", "42"]
    done = subprocess.run(census, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    assert "2000 starts by both engines, 20 motions" in done.stdout
    assert done.stdout.rstrip().endswith("0  not explained")


@pytest.fixture
def comparison(monkeypatch):
    monkeypatch.syspath_prepend(str(BENCH))
    from counting import comparison

    return comparison


@pytest.mark.parametrize("change", ["turn", "outcome"])
def test_the_census_notices_an_engine_that_errs(comparison, monkeypatch, change):
    from counting.draws import Setting

    def errs(setting, starts):
        right = by_quadrature(setting, starts)
        if change == "turn":
            return replace(right, turn=right.turn * (1.0 + 1e-7))
        return replace(right, outcome=np.full_like(right.outcome, "toppled"))

    by_quadrature = comparison.by_quadrature
    setting = Setting(rr.bodies.can_2007(), rr.NoSlip(), 9.8)
    starts = rr.State(tilt=np.array([0.3, 0.4]), tilt_rate=-0.5, yaw_rate=0.02, spin_rate=0.01)
    assert not list(comparison.differences(setting, starts))
    monkeypatch.setattr(comparison, "by_quadrature", errs)
    found = list(comparison.differences(setting, starts))
    assert [difference.why for difference in found] == ["", ""]
    assert "rr.exact_turn(Body(" in found[0].reproducer()


@pytest.fixture
def column_shaken(monkeypatch):
    monkeypatch.syspath_prepend(str(BENCH))
    from counting.shaken import Shaken

    column = rr.Body(1000.0, 0.5, 2.0, 1395.8, 125.0)
    start = rr.State(tilt=0.1, yaw=0.3, yaw_rate=0.2, spin_rate=-0.1)
    pulse = ("sine", np.array([1.0, 0.5, 0.5]), 1.2)
    record = (0.0, np.zeros((0, 3)))
    return Shaken(column, start, rr.NoSlip(), pulse, record, "stop", 0.0, 1.5, 9.81, 1e-10)


def broken(shaken):
    from counting.claims import findings

    found = list(findings(shaken, np.random.default_rng(4)))
    assert {"energy budget", "mirror", "derivative", "shake_many"} < {one.claim for one in found}
    return [one.claim for one in found if one.what and not one.why]


def test_a_shaken_column_keeps_all_that_the_census_claims(column_shaken):
    assert broken(column_shaken) == []


@pytest.mark.parametrize(
    ("claim", "method", "wrong"),
    [
        ("mirror", "mirror_image", lambda shaken: replace(shaken, mirrored=True)),
        ("heading", "turned_by", lambda shaken, angle: replace(shaken, turned=angle)),
        ("size", "enlarged", lambda shaken, size: replace(shaken, gravity=1.0001 * shaken.gravity)),
    ],
)
def test_the_census_notices_a_copy_that_is_none(column_shaken, monkeypatch, claim, method, wrong):
    monkeypatch.setattr(type(column_shaken), method, wrong)
    assert claim in broken(column_shaken)


def test_the_census_notices_a_wrong_derivative(column_shaken, monkeypatch):
    from counting import claims

    exact = claims._difference
    monkeypatch.setattr(claims, "_difference", lambda *of: 1.01 * exact(*of))
    assert "derivative" in broken(column_shaken)


def test_the_census_notices_energy_from_nowhere(column_shaken, monkeypatch):
    from counting.claims import misses

    motion = column_shaken.motion()
    assert all(miss <= 1.0 for _, miss in misses(motion, column_shaken))
    budget = motion.energy_budget * np.linspace(1.0, 1.000001, len(motion.t))
    monkeypatch.setattr(rr.Motion, "energy_budget", budget)
    assert dict(misses(motion, column_shaken))["energy budget"] > 1.0
