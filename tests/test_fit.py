"""The friction of a table from directions of fall: densities, likelihood, intervals, verdicts."""

import importlib.util
import math
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import rimroll as rr
from rimroll.fitting.likelihood import Likelihood, Point
from rimroll.fitting.predicted import ANGLES, STRAY, UNSTEADY
from rimroll.laws import Law

CAN, GRAVITY, RELEASE = rr.bodies.can_2007(), 9.8, "paper"
TURN = 2.0 * math.pi
READING = math.radians(2.0)
GRID = np.linspace(0.0, TURN, ANGLES, endpoint=False)
TOO_RARE = 1e-3
"""A chance at which a test of random data is allowed to fail; its seeds are fixed."""


@pytest.fixture(scope="session")
def predicted():
    """Of the paper's can and flicks."""
    return rr.predict_falls(CAN, RELEASE, gravity=GRAVITY, frictions=17, falls=512)


@pytest.fixture(scope="session")
def of_the_paper():
    """Stand-ins with the means and spreads that the paper gives; the split is a guess."""
    return summary(21)


@pytest.fixture(scope="session")
def fit_of_the_paper(predicted, of_the_paper):
    return rr.fit(CAN, of_the_paper, predicted=predicted)


@pytest.fixture(scope="session")
def coverage():
    """The bench that counts how often intervals hold the truth."""
    file = Path(__file__).parents[1] / "bench" / "coverage.py"
    spec = importlib.util.spec_from_file_location("bench_of_coverage", file)
    module = importlib.util.module_from_spec(spec)
    sys.modules[spec.name] = module
    spec.loader.exec_module(module)
    return module


def summary(lefts, of=42):
    """Srinivasan & Ruina (2007): 42 falls, 213.0 ± 3.9° to the left, 217.9 ± 4.5° to the right."""
    return rr.directions_of_summary(
        left=(math.radians(213.0), math.radians(3.9), lefts),
        right=(math.radians(217.9), math.radians(4.5), of - lefts),
    )


def fallen(law: Law, n, seed, *, release=RELEASE, body=CAN, word="toppled"):
    """True directions of n falls that count, and the way each turned."""
    falls = rr.topple(body, law, n + n // 4 + 8, release, seed, gravity=GRAVITY)
    counts = falls["outcome"].values == word
    assert counts.sum() >= n
    return falls["direction"].values[counts][:n], falls["turn"].values[counts][:n]


def measured(law, n, seed, bias=0.0):
    """Directions as read by a protractor that is off by a bias."""
    error = READING * np.random.default_rng(seed).standard_normal(n)
    return fallen(law, n, seed)[0] + bias + error


def humps_apart(one, other):
    """Half the integral of the absolute difference of densities over GRID: 0 same, 1 disjoint."""
    return 0.5 * np.abs(one - other).sum(axis=-1) * TURN / ANGLES


def mirrored(density):
    """The density of 2π − d on GRID."""
    return np.roll(density[..., ::-1], 1, axis=-1)


# How falls scatter


def test_densities_are_above_0_and_integrate_to_1(predicted):
    for side in (predicted.left, predicted.right):
        assert side.shape == (17, len(UNSTEADY), ANGLES)
        assert side.min() > 0.0
        # Ripples of the Fourier transform below 0 are cut off.
        assert side.sum(axis=-1) * TURN / ANGLES == pytest.approx(1.0, abs=1e-9)


def test_densities_of_a_release_that_favours_no_side_are_mirror_images(predicted):
    assert np.array_equal(predicted.right, mirrored(predicted.left))
    middles = GRID[predicted.left.argmax(axis=-1)]
    assert np.all((middles > math.pi) & (middles < math.radians(225.0)))


def test_frictions_reach_from_none_to_where_the_can_rolls(predicted):
    assert predicted.frictions[0] == 0.0
    assert predicted.frictions[-1] > 1.25 * rr.needed_friction(CAN)
    assert predicted.counted == "toppled"


@pytest.mark.parametrize("node", [0, 5, 16])
def test_densities_are_those_of_other_falls_by_a_kernel_estimate(predicted, node):
    directions, _ = fallen(rr.Coulomb(predicted.frictions[node]), 400, seed=11)
    apart = np.mod(GRID[:, None] - directions + math.pi, TURN) - math.pi
    kernels = np.exp(-0.5 * (apart / READING) ** 2) / (READING * math.sqrt(TURN))
    estimate = kernels.mean(axis=1)
    found = Likelihood(predicted, directions).density(GRID, at(predicted.frictions[node]))
    hump = found - STRAY / TURN
    # Both are means over falls: weighted, 512 are worth no more than 400.
    error = math.sqrt(2.0) * kernels.std(axis=1) / math.sqrt(len(directions))
    assert np.all(np.abs(hump - estimate) < 4.0 * error + 0.02)
    assert humps_apart(hump, estimate) < 0.08


def at(friction, *, bias=0.0, unsteadiness=1.0, left_share=0.5):
    return Point(friction, bias, unsteadiness, left_share, math.nan)


@pytest.mark.parametrize("unsteadiness", [0.5, 2.0])
def test_weighted_falls_have_the_mean_and_spread_of_another_hand(predicted, unsteadiness):
    friction = predicted.frictions[6]
    release = rr.Release.named(RELEASE, CAN, GRAVITY).unsteady(unsteadiness)
    directions, turns = fallen(rr.Coulomb(friction), 400, 5, release=release)
    gone = np.where(turns > 0.0, directions, TURN - directions)
    likelihood = Likelihood(predicted, directions)
    density = likelihood.density(GRID, at(friction, unsteadiness=unsteadiness, left_share=1.0))
    hump = (density - STRAY / TURN) / (1.0 - STRAY) * TURN / ANGLES
    mean = (hump * GRID).sum()
    spread = math.sqrt((hump * (GRID - mean) ** 2).sum() - READING**2)
    # Standard errors of falls and prediction, which is worth half as many.
    error = gone.std() * math.sqrt(3.0 / len(gone))
    assert mean == pytest.approx(gone.mean(), abs=4.0 * error)
    # The falls have tails: of four times as large an error as normal ones.
    assert spread == pytest.approx(gone.std(), rel=4.0 * math.sqrt(4.0 * 0.5 * 3.0 / len(gone)))


def test_a_hand_that_twists_one_way_splits_the_falls_and_breaks_the_mirror():
    hand = replace(rr.Release.named(RELEASE, CAN, GRAVITY), twist=(0.4, 0.5))
    predicted = rr.predict_falls(CAN, hand, gravity=GRAVITY, frictions=8, falls=256)
    directions, _ = fallen(rr.Coulomb(0.2), 300, 3, release=hand)
    share = np.mean(directions > math.pi)
    assert share > 0.6
    assert np.all(humps_apart(predicted.right, mirrored(predicted.left)) > 0.02)
    for side in (predicted.left, predicted.right):
        assert side.sum(axis=-1) * TURN / ANGLES == pytest.approx(1.0, abs=1e-9)
    best = Likelihood(predicted, directions).best(friction=0.2)
    assert best.left_share == pytest.approx(share, abs=0.01)
    # Both sides lean the way the hand twists, and no bias is needed for that.
    assert best.bias == pytest.approx(0.0, abs=math.radians(1.5))


def test_a_coin_that_turns_more_than_all_the_way_round_gets_its_sides_right():
    coin = rr.bodies.coin()
    predicted = rr.predict_falls(coin, "let go", frictions=8, falls=128)
    assert predicted.counted == "rocked"
    falls = rr.topple(coin, rr.Coulomb(predicted.frictions[3]), 60, "let go", seed=1)
    directions, turns = falls["direction"].values, falls["turn"].values
    assert np.all(np.abs(turns[falls["outcome"] == "rocked"]) > TURN)
    for side, anticlockwise in ((predicted.left[3], False), (predicted.right[3], True)):
        peak = GRID[side[6].argmax()]
        assert (peak > math.pi) != anticlockwise
        there = directions[(falls["outcome"] == "rocked") & ((turns > 0.0) == anticlockwise)]
        assert peak == pytest.approx(np.median(there), abs=math.radians(1.5))


def test_directions_count_from_the_first_lean_whatever_is_done_before_the_largest_tilt():
    """A body thrown up first turns a little before it leans most, where `turn` begins."""
    up = rr.Release((0.3, 0.0), (1.0, 0.0), (0.4, 0.0), (0.0, 0.2))
    law = rr.Coulomb(1.0)
    falls = rr.topple(CAN, law, 200, up, seed=2, gravity=GRAVITY)
    gone_before = np.mod(falls["direction"].values - falls["turn"].values + math.pi, TURN) - math.pi
    assert np.degrees(np.nanmean(gone_before)) > 5.0
    predicted = rr.predict_falls(CAN, up, gravity=GRAVITY, frictions=8, falls=256)
    directions = falls["direction"].values[falls["outcome"].values == predicted.counted]
    density = Likelihood(predicted, directions).density(
        GRID, at(predicted.frictions[-1], left_share=np.mean(directions > math.pi))
    )
    resultant = (density * np.exp(1j * GRID)).sum() * TURN / ANGLES / (1.0 - STRAY)
    of_falls = np.exp(1j * directions).mean()
    assert abs(resultant - of_falls) < 0.05


@pytest.mark.parametrize("degrees", [0.5, 2.0, 10.0])
def test_the_spread_of_a_density_is_that_of_reading_where_nothing_else_scatters(degrees):
    steady = rr.Release((0.35, 0.0), (-5.0, 0.0), (0.02, 0.0))
    error = math.radians(degrees)
    predicted = rr.predict_falls(
        CAN, steady, gravity=GRAVITY, reading_error=error, frictions=8, falls=128
    )
    assert predicted.unsteady.tolist() == [1.0]
