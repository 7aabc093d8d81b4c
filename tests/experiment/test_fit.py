"""The friction of a table from directions of fall: densities, likelihood, intervals, verdicts."""

import io
import json
import math
import pickle
import sys
from dataclasses import replace

import numpy as np
import pytest
from scipy.ndimage import map_coordinates
from scipy.stats import binom, chi2
from scipy.stats import t as student

import rimroll as rr
from rimroll.cli import main
from rimroll.experiment.likelihood import Estimate, Likelihood, Point
from rimroll.experiment.predicted import (
    ANGLES,
    MIN_FRICTIONS,
    STRAY,
    UNSTEADY,
    which_node,
)
from rimroll.laws import Law

CAN, GRAVITY, RELEASE = rr.bodies.can_2007(), 9.8, "paper"
TURN = 2.0 * math.pi
READING = math.radians(2.0)
GRID = np.linspace(0.0, TURN, ANGLES, endpoint=False)
TOO_RARE = 1e-3
"""A chance at which a test of random data is allowed to fail; its seeds are fixed."""


@pytest.fixture(scope="session")
def predicted():
    """Predictions for the paper's can and flicks, with a quarter of the default number of falls."""
    return rr.predict_falls(CAN, RELEASE, gravity=GRAVITY, falls=256)


@pytest.fixture(scope="session")
def of_the_paper():
    """Substitute falls with the means and spreads of the paper; the split is a guess."""
    return summary(21)


@pytest.fixture(scope="session")
def fit_of_the_paper(predicted, of_the_paper):
    return rr.fit(CAN, of_the_paper, predicted=predicted)


def summary(lefts, of=42):
    """Srinivasan & Ruina (2007): 42 falls, 213.0 ± 3.9° to the left, 217.9 ± 4.5° to the right."""
    return rr.directions_from_summary(
        left=(math.radians(213.0), math.radians(3.9), lefts),
        right=(math.radians(217.9), math.radians(4.5), of - lefts),
    )


def fallen(law: Law, n, seed, *, release=RELEASE, body=CAN, word="toppled"):
    """True directions of n falls that count, and the sense in which each turned."""
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
        assert side.shape == (33, len(UNSTEADY), ANGLES)
        assert side.min() > 0.0
        # Ripples of the Fourier transform below 0 are cut off.
        assert side.sum(axis=-1) * TURN / ANGLES == pytest.approx(1.0, abs=1e-9)


def test_densities_of_a_release_that_favours_no_side_are_mirror_images(predicted):
    assert np.array_equal(predicted.right, mirrored(predicted.left))
    # The hand is about as unsteady as the release.
    middles = GRID[predicted.left[:, 7].argmax(axis=-1)]
    assert np.all((middles > math.pi) & (middles < math.radians(225.0)))


def test_frictions_reach_from_none_to_where_the_can_rolls_and_begin_close_together(predicted):
    steps = np.diff(predicted.frictions)
    assert np.all(np.diff(steps) > 0.0)
    assert steps[0] < 0.01
    found = which_node(predicted.frictions / predicted.frictions[-1], 33)
    assert found == pytest.approx(np.arange(33), abs=1e-12)
    assert predicted.frictions[0] == 0.0
    assert predicted.frictions[-1] > 1.25 * rr.needed_friction(CAN)
    assert predicted.outcome == "toppled"


@pytest.mark.parametrize("node", [0, 10, 32])
def test_densities_are_those_of_other_falls_by_a_kernel_estimate(predicted, node):
    directions, _ = fallen(rr.Coulomb(predicted.frictions[node]), 400, seed=11)
    apart = np.mod(GRID[:, None] - directions + math.pi, TURN) - math.pi
    kernels = np.exp(-0.5 * (apart / READING) ** 2) / (READING * math.sqrt(TURN))
    estimate = kernels.mean(axis=1)
    found = Likelihood(predicted, directions).density(GRID, at(predicted.frictions[node]))
    hump = found - STRAY / TURN
    # Both are means over falls; 256 weighted falls are as accurate as 128.
    error = math.sqrt(1.0 + 400 / 128) * kernels.std(axis=1) / math.sqrt(len(directions))
    assert np.all(np.abs(hump - estimate) < 4.0 * error + 0.02)
    assert humps_apart(hump, estimate) < 0.08


def at(friction, *, bias=0.0, unsteadiness=1.0, left_share=0.5):
    return Point(friction, bias, unsteadiness, left_share, math.nan)


@pytest.mark.parametrize("unsteadiness", [0.5, 2.0])
def test_weighted_falls_have_the_mean_and_spread_of_another_hand(predicted, unsteadiness):
    friction = predicted.frictions[12]
    release = rr.Release.named(RELEASE, CAN, GRAVITY).with_unsteadiness(unsteadiness)
    directions, turns = fallen(rr.Coulomb(friction), 400, 5, release=release)
    gone = np.where(turns > 0.0, directions, TURN - directions)
    likelihood = Likelihood(predicted, directions)
    density = likelihood.density(GRID, at(friction, unsteadiness=unsteadiness, left_share=1.0))
    hump = (density - STRAY / TURN) / (1.0 - STRAY) * TURN / ANGLES
    mean = (hump * GRID).sum()
    spread = math.sqrt((hump * (GRID - mean) ** 2).sum() - READING**2)
    # Standard errors of the falls and of the prediction, which is worth half of its 256.
    error = gone.std() * math.sqrt(1.0 / len(gone) + 1.0 / 128)
    assert mean == pytest.approx(gone.mean(), abs=4.0 * error)
    # The error of a spread is 1/sqrt(2) of this for a normal distribution; falls have longer tails.
    assert spread == pytest.approx(gone.std(), abs=4.0 * error)


def test_a_hand_that_twists_one_way_splits_the_falls_and_breaks_the_mirror():
    hand = replace(rr.Release.named(RELEASE, CAN, GRAVITY), twist=(0.8, 0.5))
    predicted = rr.predict_falls(CAN, hand, gravity=GRAVITY, frictions=MIN_FRICTIONS, falls=256)
    directions, _ = fallen(rr.Coulomb(0.2), 300, 3, release=hand)
    share = np.mean(directions > math.pi)
    assert share > 0.6  # of 300: 3 sigma and more
    assert np.all(humps_apart(predicted.right, mirrored(predicted.left)) > 0.02)
    for side in (predicted.left, predicted.right):
        assert side.sum(axis=-1) * TURN / ANGLES == pytest.approx(1.0, abs=1e-9)
    best = Likelihood(predicted, directions).best(friction=0.2)
    assert best.left_share == pytest.approx(share, abs=0.01)
    # The twist shifts both sides alike, and no bias is needed for that.
    assert best.bias == pytest.approx(0.0, abs=math.radians(1.5))


def test_a_coin_that_turns_more_than_all_the_way_round_gets_its_sides_right():
    coin = rr.bodies.coin()
    predicted = rr.predict_falls(coin, "let_go", frictions=MIN_FRICTIONS, falls=128)
    assert predicted.outcome == "rocked"
    falls = rr.topple(coin, rr.Coulomb(predicted.frictions[3]), 60, "let_go", seed=1)
    directions, turns = falls["direction"].values, falls["turn"].values
    assert np.all(np.abs(turns[falls["outcome"] == "rocked"]) > TURN)
    for side, anticlockwise in ((predicted.left[3], False), (predicted.right[3], True)):
        peak = GRID[side[6].argmax()]
        assert (peak > math.pi) != anticlockwise
        there = directions[(falls["outcome"] == "rocked") & ((turns > 0.0) == anticlockwise)]
        assert peak == pytest.approx(np.median(there), abs=math.radians(1.5))


def test_directions_count_from_the_first_lean_whatever_is_done_before_the_largest_tilt():
    """A body thrown up first turns on its way to the largest tilt, from which `turn` counts."""
    up = rr.Release((0.3, 0.0), (2.0, 0.0), (0.4, 0.02), (0.0, 0.02))
    predicted = rr.predict_falls(CAN, up, gravity=GRAVITY, frictions=MIN_FRICTIONS, falls=128)
    assert predicted.outcome == "rocked"
    friction = predicted.frictions[-1]
    directions, turns = fallen(rr.Coulomb(friction), 100, 2, release=up, word="rocked")
    assert np.degrees(directions - turns) == pytest.approx(5.6, abs=1.5)
    hump = Likelihood(predicted, directions).density(GRID, at(friction, left_share=1.0))
    assert GRID[hump.argmax()] == pytest.approx(np.median(directions), abs=math.radians(1.0))


def test_a_hand_that_throws_to_one_side_only_leaves_the_other_to_strays():
    one_way = rr.Release((0.35, 0.03), (-5.0, 0.2), (0.5, 0.02), (0.0, 0.02))
    predicted = rr.predict_falls(CAN, one_way, gravity=GRAVITY, frictions=MIN_FRICTIONS, falls=128)
    assert np.all(predicted.right == 1.0 / TURN)
    directions, _ = fallen(rr.Coulomb(0.2), 40, 1, release=one_way)
    assert np.all(directions > math.pi)
    found = rr.fit(CAN, directions, predicted=predicted).friction.friction
    assert found == pytest.approx(0.2, abs=0.05)


@pytest.mark.parametrize("degrees", [0.5, 2.0, 10.0])
def test_where_nothing_else_scatters_falls_are_spread_by_reading_alone(degrees):
    steady = rr.Release((0.35, 0.0), (-5.0, 0.0), (0.02, 0.0))
    error = math.radians(degrees)
    predicted = rr.predict_falls(
        CAN, steady, gravity=GRAVITY, reading_error=error, frictions=MIN_FRICTIONS, falls=128
    )
    assert predicted.unsteadiness.tolist() == [1.0]
    hump = (predicted.left[:, 0] - STRAY / TURN) / (1.0 - STRAY) * TURN / ANGLES
    # Points half a degree apart hold a spread of half a degree but for ripples of a part in 100.
    assert hump.sum(axis=-1) == pytest.approx(1.0, abs=0.01)
    middle = GRID[hump.argmax(axis=-1)][:, None]
    near = np.where(np.abs(GRID - middle) < 4.0 * error, hump, 0.0)
    near /= near.sum(axis=-1, keepdims=True)
    mean = (near * GRID).sum(axis=-1, keepdims=True)
    spread = np.sqrt((near * (GRID - mean) ** 2).sum(axis=-1))
    # The rounding to points is allowed for on average over where between them a fall is.
    assert spread == pytest.approx(error, rel=0.1 if degrees < 1.0 else 0.01)
    # Without any freedom but the friction of one side, too, there is an answer.
    directions, _ = fallen(rr.Coulomb(0.2), 10, 1, release=steady)
    assert rr.fit(CAN, directions, predicted=predicted).left is not None


# Likelihood


def test_the_likelihood_is_the_product_of_the_densities_where_they_were_computed(predicted):
    i, k, share = 7, 4, 0.3
    places = np.array([290, 298, 421, 430, 436, 700])
    likelihood = Likelihood(predicted, GRID[places])
    point = at(predicted.frictions[i], unsteadiness=UNSTEADY[k], left_share=share)
    mixture = share * predicted.left[i, k, places] + (1.0 - share) * predicted.right[i, k, places]
    assert likelihood.density(GRID[places], point) == pytest.approx(mixture, rel=1e-9, abs=0.0)
    best = likelihood.best(
        friction=point.friction,
        bias=0.0,
        log_unsteadiness=math.log(UNSTEADY[k]),
        logit=math.log(share / (1.0 - share)),
    )
    assert best.log_likelihood == pytest.approx(np.log(mixture).sum(), rel=1e-9, abs=0.0)


@pytest.mark.parametrize("fraction", [0.0, 0.31, 0.5, 1.0])
def test_between_points_densities_are_the_splines_of_scipy(predicted, fraction):
    friction = fraction * predicted.frictions[-1]
    hand = math.exp((1.0 - fraction) * math.log(UNSTEADY[0]) + fraction * math.log(UNSTEADY[-1]))
    angles = np.random.default_rng(4).uniform(-TURN, TURN, 50)
    logs = np.log(np.concatenate([predicted.left] * 3, axis=-1))
    place = (
        which_node(fraction, len(predicted.frictions)),
        fraction * (len(UNSTEADY) - 1),
        np.mod(angles, TURN) / TURN * ANGLES + ANGLES,
    )
    expected = np.exp(map_coordinates(logs, np.broadcast_arrays(*place), mode="mirror"))
    point = at(friction, unsteadiness=hand, left_share=1.0)
    assert Likelihood(predicted, angles).density(angles, point) == pytest.approx(expected, rel=1e-6)


@pytest.mark.parametrize("friction", [0.02, 0.2, 0.4])
@pytest.mark.parametrize("logit", [-2.0, 0.3])
def test_the_gradient_is_that_of_differences(predicted, of_the_paper, friction, logit):
    likelihood = Likelihood(predicted, of_the_paper)
    point = {"friction": friction, "bias": 0.05, "log_unsteadiness": 0.37, "logit": logit}
    _, slopes = likelihood.log_likelihood(**point)
    for name, value in point.items():
        up, down = (
            likelihood.log_likelihood(**{**point, name: value + step})[0] for step in (1e-6, -1e-6)
        )
        assert slopes[name] == pytest.approx((up - down) / 2e-6, rel=1e-4, abs=1e-4)


def test_a_bias_turns_the_densities(predicted):
    likelihood = Likelihood(predicted, GRID)
    for bias in (math.radians(-7.5), math.radians(3.0)):
        turned = likelihood.density(GRID + bias, at(0.1, bias=bias))
        assert turned == pytest.approx(likelihood.density(GRID, at(0.1)), rel=1e-9, abs=0.0)


def test_between_frictions_densities_are_as_good_as_computed_there(predicted):
    finer = rr.predict_falls(CAN, RELEASE, gravity=GRAVITY, frictions=65, falls=256)
    assert finer.frictions[::2] == pytest.approx(predicted.frictions, abs=1e-15)
    coarse = Likelihood(predicted, GRID)
    for k in (0, 6, 12):
        between = [
            coarse.density(GRID, at(friction, unsteadiness=UNSTEADY[k], left_share=1.0))
            for friction in finer.frictions[1::2]
        ]
        misplaced = humps_apart(np.array(between), finer.left[1::2, k])
        # Far less than the 0.2 or so by which the histogram of 42 falls is off.
        assert misplaced.max() < 0.035


@pytest.mark.parametrize("n", [3, 8, 42, 1000])
@pytest.mark.parametrize("confidence", [0.68, 0.95, 0.9999])
def test_the_limit_of_the_deviance_is_that_of_student_for_normal_data(predicted, n, confidence):
    likelihood = Likelihood(predicted, np.linspace(3.0, 4.0, n))
    # There are two means and a common spread. One mean is moved to the end of Student's interval.
    left_over = 2.0  # sum of squares about the means, whatever its unit
    spread = math.sqrt(left_over / (n - 2))
    lefts = n // 2
    off = student.ppf(0.5 + 0.5 * confidence, n - 2) * spread / math.sqrt(lefts)
    deviance = n * math.log((left_over + lefts * off**2) / left_over)
    assert likelihood.most(confidence) == pytest.approx(deviance, rel=1e-9, abs=0.0)
    assert likelihood.chance(likelihood.most(confidence)) == pytest.approx(1.0 - confidence)
    if n == 1000:  # Wilks
        assert likelihood.most(confidence) == pytest.approx(chi2.ppf(confidence, 1), rel=0.02)


# Results


@pytest.mark.parametrize(("friction", "seed"), [(0.05, 1), (0.15, 2), (0.25, 3)])
def test_friction_and_bias_are_found_again(predicted, friction, seed):
    bias = math.radians(3.0)
    found = rr.fit(CAN, measured(rr.Coulomb(friction), 80, seed, bias), predicted=predicted)
    # An interval of 95 % is two sigma to each side; within two of them.
    low, high = found.friction.intervals[0][0], found.friction.intervals[-1][1]
    assert 1.5 * low - 0.5 * high < friction < 1.5 * high - 0.5 * low
    low, high = found.bias_interval
    assert 1.5 * low - 0.5 * high < bias < 1.5 * high - 0.5 * low
    assert high - low < math.radians(3.0)
    assert found.unsteadiness == pytest.approx(1.0, rel=0.5)
    assert not any(v.excluded for v in found.verdicts if "two humps" in v.hypothesis)


def excluded(found):
    return {verdict.hypothesis.split()[0] for verdict in found.verdicts if verdict.excluded}


def test_falls_of_a_rim_that_never_slips_exclude_sliding_and_set_no_upper_bound(predicted):
    found = rr.fit(CAN, measured(rr.NoSlip(), 80, seed=4), predicted=predicted)
    assert found.friction.open_above
    assert found.friction.in_words.startswith("above 0.")
    assert found.friction.intervals[0][0] > 0.15
    assert "sliding" in excluded(found) and "rolling" not in excluded(found)


def test_falls_without_friction_exclude_rolling_and_set_no_lower_bound(predicted):
    found = rr.fit(CAN, measured(rr.Frictionless(), 80, seed=5), predicted=predicted)
    assert found.friction.intervals[0][0] == 0.0
    assert found.friction.in_words.startswith("below 0.0")
    assert not found.friction.open_above
    assert "rolling" in excluded(found) and "sliding" not in excluded(found)


def test_mirrored_falls_give_the_same_friction_and_the_opposite_bias(
    predicted, of_the_paper, fit_of_the_paper
):
    one, other = fit_of_the_paper, rr.fit(CAN, TURN - of_the_paper, predicted=predicted)
    assert other.friction.friction == pytest.approx(one.friction.friction, abs=1e-3)
    intervals = np.array(one.friction.intervals), np.array(other.friction.intervals)
    assert intervals[1] == pytest.approx(intervals[0], abs=1e-3)
    assert other.bias == pytest.approx(-one.bias, abs=1e-3)
    low, high = one.bias_interval
    assert other.bias_interval == pytest.approx((-high, -low), abs=1e-3)
    assert other.left.friction == pytest.approx(one.right.friction, abs=1e-3)


def test_turned_falls_give_the_same_friction_and_a_bias_turned_as_much(
    predicted, of_the_paper, fit_of_the_paper
):
    by, one = math.radians(5.0), fit_of_the_paper
    other = rr.fit(CAN, of_the_paper + by, predicted=predicted)
    assert other.friction.friction == pytest.approx(one.friction.friction, abs=1e-3)
    assert other.bias == pytest.approx(one.bias + by, abs=1e-3)
    assert np.array(other.bias_interval) == pytest.approx(np.add(one.bias_interval, by), abs=1e-3)
    assert other.unsteadiness == pytest.approx(one.unsteadiness, rel=0.01)


def test_nine_times_the_falls_leave_a_third_of_the_interval(predicted):
    few, many = (
        rr.fit(CAN, measured(rr.Coulomb(0.2), n, seed=6), predicted=predicted) for n in (30, 270)
    )
    for narrowing in (
        np.ptp(few.friction.intervals) / np.ptp(many.friction.intervals),
        np.ptp(few.bias_interval) / np.ptp(many.bias_interval),
    ):
        assert 2.0 < narrowing < 4.5  # 3 = sqrt(270/30), and the luck of 30 falls


def test_a_known_bias_is_taken_and_leaves_less_to_find(predicted, of_the_paper, fit_of_the_paper):
    found = rr.fit(CAN, of_the_paper, predicted=predicted, bias=fit_of_the_paper.bias)
    assert found.bias == fit_of_the_paper.bias and found.bias_interval is None
    assert found.friction.friction == pytest.approx(fit_of_the_paper.friction.friction, abs=2e-3)
    assert np.ptp(found.friction.intervals) <= np.ptp(fit_of_the_paper.friction.intervals)
    assert not any("without a bias" in verdict.hypothesis for verdict in found.verdicts)


def test_falls_to_one_side_cannot_tell_a_bias_which_is_taken_for_0(predicted):
    directions = measured(rr.Coulomb(0.15), 120, seed=7)
    lefts = directions[directions > math.pi][:40]
    found = rr.fit(CAN, lefts, predicted=predicted)
    assert found.bias == 0.0 and found.bias_interval is None
    assert found.right is None
    assert found.left.friction == pytest.approx(found.friction.friction, abs=1e-3)
    assert found.left_share > 0.95
    low, high = found.friction.intervals[0][0], found.friction.intervals[-1][1]
    assert low < 0.15 < high


@pytest.mark.soak
def test_intervals_hold_the_truth_as_often_as_they_say():
    plan = rr.Study(
        kind="fit",
        body=CAN,
        law="coulomb",
        release=RELEASE,
        fit={"falls": 30, "reading_error": READING, "bias": READING},
        axes={"law.friction": [0.05, 0.15, 0.25]},
        trials=20,
        seed=30,
    ).plan()
    fits = plan.compute(0, plan.rows)
    assert (fits["fitted_falls"] == 30).all()
    for confidence in (0.68, 0.95):
        for name in ("friction", "bias"):
            held = np.count_nonzero(fits[f"fitted_{name}_chance"] >= 1.0 - confidence)
            assert binom.cdf(held, plan.rows, confidence) > 0.5 * TOO_RARE
            assert binom.sf(held - 1, plan.rows, confidence) > 0.5 * TOO_RARE


# Exclusions


def unbiased_chance(predicted, directions):
    """The chance of data as far from dry friction without a bias."""
    likelihood = Likelihood(predicted, directions)
    return likelihood.chance(likelihood.worse(likelihood.best(bias=0.0), likelihood.best()))


def test_the_falls_of_the_paper_exclude_dry_friction_without_a_bias(fit_of_the_paper):
    (verdict,) = (v for v in fit_of_the_paper.verdicts if "without a bias" in v.hypothesis)
    assert verdict.excluded and verdict.chance < 0.01
    assert verdict.sentence.endswith(f"excluded (p = {verdict.chance:.2g})")
    assert excluded(fit_of_the_paper) == {"rolling", "sliding", "one"}


def test_the_two_sides_of_the_paper_tell_different_frictions_unless_there_is_a_bias(
    fit_of_the_paper,
):
    left, right = fit_of_the_paper.left, fit_of_the_paper.right
    # 213.0° takes more friction than 217.9°.
    assert left.friction > right.friction
    assert left.intervals[0][0] > right.intervals[-1][1]
    # Half of 217.9 − 213.0, clockwise.
    assert math.degrees(fit_of_the_paper.bias) == pytest.approx(-2.45, abs=0.15)
    low, high = np.degrees(fit_of_the_paper.bias_interval)
    # Student's for the difference of two means of 21 with those spreads.
    error = 0.5 * math.hypot(3.9, 4.5) / math.sqrt(21)
    assert (low, high) == pytest.approx((-2.45 - 2.02 * error, -2.45 + 2.02 * error), abs=0.25)
    assert high < 0.0
    assert right.friction < fit_of_the_paper.friction.friction < left.friction


@pytest.mark.parametrize("lefts", [10, 16, 26, 32])
def test_whatever_the_split_of_the_papers_falls_a_bias_is_needed(predicted, lefts):
    assert unbiased_chance(predicted, summary(lefts)) < 0.01


def test_falls_that_are_their_own_mirror_image_need_no_bias(predicted, of_the_paper):
    symmetric = np.concatenate([of_the_paper, TURN - of_the_paper])
    assert unbiased_chance(predicted, symmetric) > 0.9


@pytest.mark.parametrize("middle", [178.0, 180.0])
@pytest.mark.parametrize("spread", [4.0, 8.0])
def test_one_hump_is_called_out(predicted, middle, spread):
    directions = np.radians(middle + spread * np.random.default_rng(8).standard_normal(60))
    shape = rr.fit(CAN, directions, predicted=predicted).shape
    assert shape.hypothesis == "two humps as friction makes them"
    # One hump far off by a bias, or two that overlap, also give such data.
    assert shape.excluded or shape.sentence.endswith("as well; take the friction with care")
    middle_found = shape.sentence.partition("one hump about ")[2].partition(" degrees")[0]
    assert float(middle_found) == pytest.approx(middle, abs=4.0 * spread / math.sqrt(60) + 1.0)


def test_of_falls_to_one_side_one_hump_is_no_surprise(predicted):
    directions = np.radians(213.0 + 3.0 * np.random.default_rng(8).standard_normal(40))
    shape = rr.fit(CAN, directions, predicted=predicted).shape
    assert not shape.excluded and "one hump" not in shape.sentence


def test_falls_all_round_are_excluded(predicted):
    directions = TURN * np.random.default_rng(9).random(60)
    found = rr.fit(CAN, directions, predicted=predicted)
    assert found.shape in found.verdicts
    assert found.shape.excluded and not found.supported
    backwards = replace(found, verdicts=found.verdicts[::-1])
    assert not backwards.supported, "the order of the verdicts means nothing"


@pytest.mark.parametrize("values", [[3.7], [3.7, 2.6], [0.0], [math.pi]])
def test_falls_that_are_all_alike_still_give_an_answer(predicted, values):
    found = rr.fit(CAN, np.resize(values, 12), predicted=predicted)
    assert 0.0 <= found.friction.friction <= found.friction.holding_friction
    assert all(verdict.sentence for verdict in found.verdicts)


# Messages


@pytest.mark.parametrize(
    ("intervals", "words", "open_above"),
    [
        (((0.11, 0.16),), "0.110 to 0.160", False),
        (((0.0, 0.16),), "below 0.160", False),
        (((0.31, 0.46),), "above 0.310", True),
        (((0.0, 0.46),), "any friction", True),
        (((0.02, 0.04), (0.11, 0.16)), "0.020 to 0.040 or 0.110 to 0.160", False),
        (((0.0, 0.04), (0.3, 0.46)), "below 0.040 or above 0.300", True),
    ],
)
def test_intervals_in_words(intervals, words, open_above):
    one = Estimate(0.123, intervals, 0.46, np.zeros(2), np.zeros(2), 4.0)
    assert one.in_words == words
    assert str(one) == f"0.123 ({words})"
    assert one.open_above == open_above


def test_two_frictions_with_equal_turns_are_both_reported(predicted):
    """Below 0.15 they hardly change: from 216° at 0.06 to 214° at 0.13."""
    found = rr.fit(CAN, measured(rr.Coulomb(0.07), 150, seed=10), predicted=predicted)
    inside = [low <= 0.07 <= high for low, high in found.friction.intervals]
    assert sum(inside) == 1
    for low, high in found.friction.intervals:
        assert low < high
    ends = np.array(found.friction.intervals).ravel()
    assert np.all(np.diff(ends) > 0.0)


def test_the_deviance_is_0_at_the_best_and_the_limit_at_the_ends(predicted, fit_of_the_paper):
    one = fit_of_the_paper.friction
    assert one.deviance.min() == pytest.approx(0.0, abs=1e-6)
    assert one.frictions[one.deviance.argmin()] == pytest.approx(one.friction, abs=1e-6)
    likelihood = Likelihood(predicted, fit_of_the_paper.directions)
    for end in np.ravel(one.intervals):
        worse = likelihood.worse(likelihood.best(friction=end), fit_of_the_paper.best)
        assert worse == pytest.approx(one.limit, rel=0.01)


def test_a_fit_is_written_as_json(fit_of_the_paper):
    answer = json.loads(json.dumps(fit_of_the_paper.to_dict(), allow_nan=False))
    assert answer["falls"] == 42 and answer["confidence"] == 0.95
    assert answer["friction"] == fit_of_the_paper.friction.friction
    assert answer["left_alone"]["friction"] == fit_of_the_paper.left.friction
    assert len(answer["verdicts"]) == 4
    assert {"hypothesis", "excluded", "chance", "sentence"} == set(answer["verdicts"][0])


def test_a_fit_that_finds_one_hump_or_one_side_is_json_too(predicted):
    rng = np.random.default_rng(12)
    for middle, spread in ((math.pi, 0.2), (3.7, 0.05)):
        found = rr.fit(CAN, middle + spread * rng.standard_normal(30), predicted=predicted)
        json.dumps(found.to_dict(), allow_nan=False)


def test_a_fit_and_what_was_predicted_can_be_kept(fit_of_the_paper):
    kept = pickle.loads(pickle.dumps(fit_of_the_paper))
    assert kept.to_dict() == fit_of_the_paper.to_dict()
    again = rr.fit(CAN, kept.directions, predicted=kept.predicted)
    assert again.to_dict() == fit_of_the_paper.to_dict()


def test_the_fitted_density_integrates_to_1_but_for_its_interpolation(fit_of_the_paper):
    density = fit_of_the_paper.density(GRID)
    assert density.sum() * TURN / ANGLES == pytest.approx(1.0, abs=5e-3)


def test_the_figure_shows_the_falls_three_curves_and_the_deviance(fit_of_the_paper):
    falls, friction = fit_of_the_paper.plot().axes
    assert set(falls.get_legend_handles_labels()[1]) == {
        "measured",
        "no slip",
        "no friction",
        f"friction {fit_of_the_paper.friction.friction:.3f}",
    }
    assert falls.get_xlabel() == "direction of fall (degrees)"
    assert falls.get_ylabel() == "falls (per 2°)"
    bars = [patch.get_height() for patch in falls.patches]
    assert sum(bars) == 42
    fitted = falls.lines[2]
    # The curve counts falls: its area is theirs.
    area = np.trapezoid(fitted.get_ydata(), fitted.get_xdata()) / 2.0
    assert area == pytest.approx(42.0, rel=0.01)
    assert friction.get_legend_handles_labels()[1] == [
        "all falls",
        "left alone, no bias",
        "right alone, no bias",
    ]
    assert friction.get_xlabel() == "coefficient of friction"


# Refusals


@pytest.mark.parametrize(
    ("directions", "message"),
    [
        ([3.7, 2.6, 3.7], "a fit needs at least 8 falls, got 3"),
        ([], "a fit needs at least 8 falls, got 0"),
        (np.full((4, 4), 3.7), r"directions must be a flat array of angles, got shape \(4, 4\)"),
        (3.7, r"directions must be a flat array of angles, got shape \(\)"),
        ([[3.7], [3.7, 2.6]], "directions must be a flat array of angles, got a ragged one"),
        (["3.7 kg"] * 8, '"kg" does not measure an angle'),
        ([True] * 8, "directions must be a flat array of angles, got .* of bool"),
        ([3.7j] * 8, "directions must be a flat array of angles, got .* of complex128"),
        (None, "directions must be a flat array of angles"),
        ([3.7] * 8 + [math.nan], "directions must be radians between -4 pi and 4 pi, got nan"),
        ([3.7] * 8 + [math.inf], "directions must be radians between -4 pi and 4 pi, got inf"),
        ([213.0] * 8, r"directions must be radians .* got 213: degrees are turned into them by"),
    ],
)
def test_directions_are_at_least_8_angles(predicted, directions, message):
    with pytest.raises(rr.RimrollError, match=message):
        rr.fit(CAN, directions, predicted=predicted)


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"confidence": 0.3}, r"confidence must be between 0\.5 and 0\.9999, got 0\.3"),
        ({"confidence": 95}, r"confidence must be between 0\.5 and 0\.9999, got 95"),
        ({"confidence": math.nan}, r"confidence must be between .* got nan"),
        ({"confidence": "95 s"}, "confidence must be a pure number"),
        ({"bias": math.nan}, "bias must be between -2 pi and 2 pi, got nan"),
        ({"bias": 50.0}, "bias must be between -2 pi and 2 pi, got 50"),
        ({"bias": "2 s"}, "bias must be an angle"),
        ({"predicted": "falls"}, r"predicted must be a rimroll\.Predicted or None, got 'falls'"),
        ({"body": rr.bodies.coin()}, "predicted was computed for another body"),
        ({"body": "can"}, r"body must be a rimroll\.Body, got 'can'"),
    ],
)
def test_a_fit_names_what_it_refuses(predicted, of_the_paper, options, message):
    options = {"body": CAN, "predicted": predicted, **options}
    with pytest.raises(rr.RimrollError, match=message):
        rr.fit(options.pop("body"), of_the_paper, **options)


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"body": None}, r"body must be a rimroll\.Body, got None"),
        ({"release": 3}, r"release must be a rimroll\.Release or the name of a preset, got 3"),
        ({"release": "flik"}, "flick"),
        ({"gravity": "g"}, "gravity must be an acceleration"),
        ({"gravity": -9.8}, "gravity must be"),
        ({"reading_error": 0.0}, r"reading_error must be between 0\.5 and 57 degrees, got 0 degr"),
        ({"reading_error": 2.0}, r"reading_error must be between 0\.5 and 57 degrees, got 114"),
        ({"reading_error": math.nan}, "reading_error must be between .* got nan degrees"),
        ({"reading_error": "2 m"}, "reading_error must be an angle"),
        ({"frictions": 24}, "frictions must be at least 25, got 24"),
        ({"frictions": 8.5}, "frictions must be a whole number"),
        ({"falls": 100}, "falls must be at least 128, got 100"),
        # It never comes down, since it is released past the balance tilt.
        (
            {"release": rr.Release(1.0, 1.0, (0.0, 0.1))},
            "of 128 simulated releases at each friction fewer than 20 rocked",
        ),
    ],
)
def test_a_prediction_names_what_it_refuses(options, message):
    small = {"body": CAN, "release": RELEASE, "frictions": MIN_FRICTIONS, "falls": 128}
    options = {**small, **options}
    with pytest.raises(rr.RimrollError, match=message):
        rr.predict_falls(options.pop("body"), options.pop("release"), **options)


def test_progress_is_reported_for_each_friction_and_threads_change_nothing():
    seen = []
    one, other = (
        rr.predict_falls(
            CAN,
            RELEASE,
            frictions=MIN_FRICTIONS,
            falls=128,
            threads=threads,
            progress=lambda done, total: seen.append((done, total)),
        )
        for threads in (1, 2)
    )
    assert seen == 2 * [(i, 25) for i in range(1, 26)]
    assert np.array_equal(one.left, other.left)


def test_a_flick_that_was_slower_or_faster_tells_another_friction(of_the_paper):
    """Faster flicks of the can turn it less at the same friction, so the same turns need less
    friction."""
    found = rr.fit(CAN, of_the_paper, RELEASE, gravity=GRAVITY, tilt_rate_error=0.5)
    (slower, more), (faster, less) = found.at_other_tilt_rates
    assert (slower, faster) == pytest.approx((-4.5, -5.5))
    assert less < found.friction.friction < more
    with pytest.raises(rr.RimrollError, match="tilt_rate_error must be finite and >= 0, got -1"):
        rr.fit(CAN, of_the_paper, RELEASE, tilt_rate_error=-1.0)


def test_the_share_shows_where_hardly_any_flick_topples():
    """At 4.3 rad/s from 20 degrees the can topples if it rolls, and often not with friction."""
    gentle = rr.Release((0.35, 0.03), (-4.3, 0.1), (0.0, 0.3), (0.0, 0.3))
    some = rr.predict_falls(CAN, gentle, frictions=MIN_FRICTIONS, falls=128)
    assert some.outcome == "toppled"
    assert some.share[-1] > 0.95 > 0.9 > some.share.min()
    falls = rr.topple(CAN, rr.Coulomb(some.frictions[10]), 400, gentle, seed=2)
    toppled = np.mean(falls["outcome"].values == "toppled")
    assert some.share[10] == pytest.approx(toppled, abs=0.12)  # 128 draws, weighted
    rocked = rr.predict_falls(CAN, "let_go", frictions=MIN_FRICTIONS, falls=128, outcome="rocked")
    assert np.all(rocked.share > 0.99)
    with pytest.raises(rr.RimrollError, match="outcome must be toppled or rocked, got 'fell'"):
        rr.predict_falls(CAN, "flick", outcome="fell")


@pytest.mark.soak
def test_a_hand_far_unsteadier_than_assumed_does_not_spoil_the_interval():
    predicted = rr.predict_falls(CAN, RELEASE, gravity=GRAVITY)
    hand = rr.Release.named(RELEASE, CAN, GRAVITY).with_unsteadiness(4.0)
    held = 0
    for seed in range(6):
        directions, _ = fallen(rr.Coulomb(0.2), 42, seed, release=hand)
        found = rr.fit(CAN, directions, predicted=predicted)
        assert found.unsteadiness > 2.0
        held += any(low <= 0.2 <= high for low, high in found.friction.intervals)
    assert held >= 4  # of six at 95 %: fewer by chance once in 400


def test_parameters_at_their_bounds_are_reported(predicted):
    wild = np.radians(180.0 + 70.0 * np.random.default_rng(3).standard_normal(60))
    assert any(
        "unsteadiest hand" in warning for warning in rr.fit(CAN, wild, predicted=predicted).warnings
    )
    directions, _ = fallen(rr.Coulomb(0.2), 42, 1, release=RELEASE)
    stray = np.append(directions, math.radians(60.0))
    doubts = rr.fit(CAN, stray, predicted=predicted).warnings
    assert "far from both humps, and taken for writing errors: 60 degrees" in doubts
    left = directions[directions > math.pi]
    doubts = rr.fit(CAN, left, predicted=predicted).warnings
    assert doubts[0].startswith("too few falls to one side")
    askew = rr.fit(CAN, directions + math.radians(25.0), predicted=predicted)
    assert askew.bias == pytest.approx(math.radians(25.0), abs=math.radians(1.0))


def test_parameters_at_the_ends_of_what_is_tried_are_flagged(predicted, fit_of_the_paper):
    assert fit_of_the_paper.supported and fit_of_the_paper.at_bounds == {}
    wild = np.radians(180.0 + 70.0 * np.random.default_rng(3).standard_normal(60))
    assert rr.fit(CAN, wild, predicted=predicted).at_bounds["unsteadiness"] == "highest"
    alike = rr.fit(CAN, np.resize([3.7, 2.6], 30), predicted=predicted)
    assert alike.at_bounds == {"unsteadiness": "lowest"}
    assert any("steadiest hand" in warning for warning in alike.warnings)
    known = rr.fit(CAN, wild, predicted=predicted, bias=0.0)
    assert "bias" not in known.at_bounds


def test_the_command_says_what_it_read_and_the_verdict_before_the_number(monkeypatch, capsys):
    piped = io.TextIOWrapper(io.BytesIO(b"200\n" * 30), "utf-8")
    monkeypatch.setattr(sys, "stdin", piped)
    assert main(["fit", "-", "--tilt-rate-error", "0"]) == 0
    lines = capsys.readouterr().out.splitlines()
    (read,) = (i for i, line in enumerate(lines) if line.startswith("read "))
    assert lines[read] == "read the only column; degrees, anticlockwise; 30 rows"
    (doubt,) = (i for i, line in enumerate(lines) if "the numbers below mean nothing" in line)
    (friction,) = (i for i, line in enumerate(lines) if line.startswith("friction, unsupported"))
    assert read < doubt < friction
    (hand,) = (line for line in lines if line.startswith("spread of the hand"))
    assert "the lowest tried" in hand


def test_the_summary_of_the_falls_leaves_out_what_the_fit_takes_for_slips_of_the_pen(
    tmp_path, capsys
):
    file = tmp_path / "falls.csv"
    directions = np.degrees(fallen(rr.Coulomb(0.2), 42, 1, release=RELEASE)[0]).tolist()
    left, right = ([one for one in directions if (one > 180.0) == side] for side in (True, False))
    file.write_text("\n".join(map(str, [*directions, 60.0])))
    command = ["fit", str(file), "--tilt-rate-error", "0"]
    assert main(command) == 0
    text = " ".join(capsys.readouterr().out.split())
    assert f"43 falls: {len(left)} to the left at {np.mean(left):.1f}°" in text
    assert f"{len(right)} to the right at {np.mean(right):.1f}°" in text
    assert "1 left out as a writing error" in text
    assert main([*command, "--json"]) == 0
    answer = json.loads(capsys.readouterr().out)
    assert answer["falls"] == 43
    assert answer["strays"] == pytest.approx([math.radians(60.0)], rel=1e-12, abs=0.0)


def test_the_command_reads_the_columns_that_it_is_given(tmp_path, capsys):
    file = tmp_path / "falls.csv"
    directions, _ = fallen(rr.Coulomb(0.2), 42, 1, release=RELEASE)
    rows = (f"{i % 3},{angle}" for i, angle in enumerate(np.degrees(directions)))
    file.write_text("\n".join(["group,way", *rows]))
    command = ["fit", str(file), "--tilt-rate-error", "0", "--json"]
    assert main(command) == 2
    assert "--column" in capsys.readouterr().err
    assert main([*command, "--column", "way"]) == 0
    answer = json.loads(capsys.readouterr().out)
    assert answer["read"] == 'column 2 "way"; degrees, anticlockwise; 42 rows'
    assert answer["falls"] == 42 and answer["supported"] is True
    # These angles were read without any error, and 2 degrees are assumed.
    assert answer["at_bounds"] == {"unsteadiness": "lowest"}


def test_many_falls_are_counted_in_bins_that_change_next_to_nothing(predicted):
    directions, _ = fallen(rr.Coulomb(0.2), 2000, 1, release=RELEASE)
    binned = Likelihood(predicted, directions)
    point = binned.best()
    exact = np.log(binned.density(directions, point)).sum()
    # A quarter of a degree's variance, 1/192 degrees squared, over twice that of humps 2 degrees
    # wide is 0.7e-3 a fall; of all parameters alike.
    assert point.log_likelihood == pytest.approx(exact, abs=2e-3 * len(directions))
