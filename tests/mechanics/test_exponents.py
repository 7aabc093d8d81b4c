"""Exponents with intervals: what they hold, and which of Euler's disk they find."""

import numpy as np
import pytest

import rimroll as rr
from given.motions import DISK


def correlated(random, count, correlation):
    """Normal numbers of variance 1, each correlated with the one before."""
    found = random.standard_normal(count)
    for i in range(1, count):
        found[i] = correlation * found[i - 1] + np.sqrt(1.0 - correlation**2) * found[i]
    return found


def test_a_power_law_is_found_to_rounding():
    t = np.linspace(0.0, 9.0, 50)
    fit = rr.fit_exponent(t, 3.0 * (10.0 - t) ** (4 / 9))
    assert fit.exponent == pytest.approx(4 / 9, abs=1e-8)
    assert fit.end == pytest.approx(10.0, abs=1e-8)
    assert fit.amplitude == pytest.approx(3.0, rel=1e-8)
    np.testing.assert_allclose(fit([0.0, 5.0]), 3.0 * np.array([10.0, 5.0]) ** (4 / 9), rtol=1e-8)
    rate = rr.fit_exponent(t, 3.0 * (10.0 - t) ** (-1 / 3), window=(2.0, 8.0))
    assert rate.exponent == pytest.approx(-1 / 3, abs=1e-8)
    assert rate.count == 33


@pytest.mark.parametrize("correlation", [0.0, 0.9])
def test_intervals_hold_the_truth_also_where_errors_follow_each_other(correlation):
    """With independent errors they are wide. Ordinary least squares would hold half the truths."""
    random = np.random.default_rng(1)
    t = np.linspace(0.0, 9.0, 400)
    held = ends = 0
    for _ in range(60):
        curve = (10.0 - t) ** 0.5 * np.exp(0.02 * correlated(random, len(t), correlation))
        fit = rr.fit_exponent(t, curve)
        held += fit.exponent_interval[0] < 0.5 < fit.exponent_interval[1]
        ends += fit.end_interval[0] < 10.0 < fit.end_interval[1]
    # Nine in ten of the 95 % that are promised.
    assert min(held, ends) >= 51


def test_the_interval_of_the_exponent_includes_that_of_the_end():
    """Whoever takes the best end for the true one believes in an interval that is too narrow."""
    random = np.random.default_rng(2)
    t = np.linspace(0.0, 5.0, 200)
    fit = rr.fit_exponent(t, (10.0 - t) ** 0.5 * np.exp(0.01 * random.standard_normal(len(t))))
    x = np.log(fit.end - t)
    x -= x.mean()
    with_known_end = 4.0 * fit.residual / np.sqrt(x @ x)
    assert np.ptp(fit.exponent_interval) > 3.0 * with_known_end


def test_more_points_of_one_smooth_curve_do_not_narrow_the_intervals():
    widths = []
    for count in 100, 400, 1600:
        t = np.linspace(0.0, 9.0, count)
        fit = rr.fit_exponent(t, (10.0 - t) ** 0.5 * (1.0 + 0.01 * np.sin(5.0 * t)))
        widths.append(np.ptp(fit.exponent_interval))
    np.testing.assert_allclose(widths, widths[0], rtol=0.2)


@pytest.mark.parametrize(
    ("resistance", "exponent"),
    [
        (rr.RollingResistance(dry=2e-4), 2 / 3),
        (rr.RollingResistance(viscous=5e-4), 1 / 2),
        (rr.AirDrag(2e-7, exponent=2.5), 4 / 9),
        (rr.AirDrag(2e-11, exponent=4.0), 1 / 3),
    ],
    ids=["dry", "viscous", "boundary layer", "film"],
)
def test_each_resistance_has_its_exponents_of_the_tilt_and_of_the_yaw_rate(resistance, exponent):
    """Between 0.1 and 0.03 rad. There the decay is off the power law by some 0.01."""
    rate = rr.steady_wobble_rate(DISK, 0.1)
    start = rr.State(tilt=0.1, yaw_rate=rate, spin_rate=-rate * np.cos(0.1))
    motion = rr.simulate(DISK, start, rr.NoSlip() + resistance, 200.0, rtol=1e-8)
    (stop,) = [event.t for event in motion.crossings(lambda at: at.tilt - 0.03)][:1]
    at = motion.evaluate(np.linspace(0.0, stop, 300))
    tilt, yaw_rate = rr.fit_exponent(at.t, at.tilt), rr.fit_exponent(at.t, at.yaw_rate)
    assert tilt.exponent == pytest.approx(exponent, abs=0.012)
    assert yaw_rate.exponent == pytest.approx(-exponent / 2, abs=0.012)
    assert tilt.end == pytest.approx(motion.t[-1], rel=0.003)


def test_what_is_refused():
    t = np.linspace(0.0, 9.0, 50)
    for curve, why in [
        (np.exp(-t), "shows no end"),
        (np.ones(50), "shows no end"),
        (t, r"curve\[0\] must be > 0"),
        (t[:9], "same length"),
    ]:
        with pytest.raises(rr.RimrollError, match=why):
            rr.fit_exponent(t, curve)
    with pytest.raises(rr.RimrollError, match="at least 10 points, got 6"):
        rr.fit_exponent(t, 10.0 - t, window=(0.0, 1.0))
    with pytest.raises(rr.RimrollError, match="confidence must be between 0 and 1, got 95"):
        rr.fit_exponent(t, 10.0 - t, confidence=95)
    with pytest.raises(rr.RimrollError, match=r"t\[1\] must be rising"):
        rr.fit_exponent(np.zeros(50), 10.0 - t)


def test_a_window_that_allows_an_exponential_bounds_neither_end_nor_exponent():
    rng = np.random.default_rng(3)
    t = np.linspace(0.0, 1.0, 200)
    curve = (20.0 - t) ** 2.0 * np.exp(rng.normal(0.0, 3e-3, t.size))
    fit = rr.fit_exponent(t, curve)
    assert fit.end_interval[1] == np.inf
    assert fit.exponent_interval[1] == np.inf
    assert fit.exponent_interval[0] < 2.0
    assert fit.end_interval[0] < 20.0
