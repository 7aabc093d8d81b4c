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
