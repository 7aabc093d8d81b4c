"""The report's table of the paper's numbers, and its list of errata."""

import re
from pathlib import Path

import numpy as np
import pytest

import rimroll as rr
from rimroll.paper.claims import AGREES, CUT, DIFFERS, INPUT, MEASURED, Claim, all_claims
from rimroll.paper.errata import ERRATA

PROOFS = (Path(__file__).parents[1] / "proofs/test_newton_euler.py").read_text("utf-8")


@pytest.fixture(scope="module")
def claims():
    return [claim for group in all_claims().values() for claim in group]


def find(claims, text):
    (claim,) = (claim for claim in claims if text in claim.says)
    return claim


def test_a_verdict_follows_from_the_numbers_alone():
    def verdict(printed, ours):
        return Claim("", "", printed, "", ours, 0.5).verdict

    assert verdict(40, 40.4) == AGREES
    assert verdict(40, 40.97) == CUT
    assert verdict(40, 39.1) == DIFFERS
    assert verdict(40, 41.2) == DIFFERS
    assert verdict(40, None) == MEASURED


def test_the_printed_no_slip_formula_is_the_only_angle_of_the_can_that_differs(claims):
    differing = [c for c in claims if c.verdict == DIFFERS and c.unit == "°"]
    assert [c.where for c in differing] == ["Eq. (15)", "Disks", "Disks"]
    inverted = find(claims, "as printed")
    k = 5.13e-3 + 0.069**2
    assert inverted.printed == pytest.approx(180 * np.sqrt(k / (k + 0.051**2)), abs=1e-9)
    assert inverted.ours == pytest.approx(180 * np.sqrt((k + 0.051**2) / k), abs=1e-9)


def test_every_number_that_the_paper_compares_with_an_experiment_is_there(claims):
    printed = {(c.printed, c.unit) for c in claims}
    for value in (220, 202, 40, 22, 213.0, 217.9, 3.9, 4.5, 41, 48, 90):
        assert (value, "°") in printed
    assert {(2.23, "π"), (1.73, "π"), (42, "")} <= printed


def test_the_can_of_the_caption_taken_literally_topples_instead_of_rocking(claims):
    claim = find(claims, "with A and C in kg m²")
    assert claim.verdict == DIFFERS
    assert claim.ours == pytest.approx(1.5, abs=1e-9)
    assert "t = 2.129" in claim.remark
    assert "182.99° and 183.18°" in claim.remark


def test_numbers_that_rimroll_takes_from_the_paper_do_not_count_as_agreeing(claims):
    inputs = [claim for claim in claims if claim.verdict == INPUT]
    can = rr.bodies.can_2007()
    typed_in = {
        can.mass,
        100 * can.radius,
        100 * can.height,
        1e3 * can.transverse_inertia / can.mass,
        9.8,
    }
    assert {claim.ours for claim in inputs} == typed_in


def test_the_step_of_disks_depends_on_no_friction_but_the_turn_to_the_tilt_maximum_does(claims):
    assert find(claims, "form of the friction law").verdict == AGREES
    whole = find(claims, "uniform disk at μ = 0.8")
    assert whole.verdict == DIFFERS
    assert whole.ours == pytest.approx(399.07 - 402.49, abs=0.02)


def test_starts_do_not_matter_at_the_paper_s_two_limits(claims):
    assert find(claims, "does not depend on the initial conditions").verdict == AGREES


@pytest.mark.parametrize("erratum", ERRATA, ids=lambda e: e.test)
def test_every_erratum_is_proved_by_the_test_it_names(erratum):
    assert f"def {erratum.test}(" in PROOFS


def test_every_proved_erratum_is_listed_once():
    proved = re.findall(r"def (test_erratum_\w+)\(", PROOFS)
    assert sorted(e.test for e in ERRATA) == sorted(proved)
