"""Fragility curves by maximum likelihood."""

from __future__ import annotations

import math

import numpy as np
import pytest
import xarray as xr
from scipy.optimize import minimize
from scipy.special import log_ndtr, ndtr
from scipy.stats import chi2, t

import rimroll as rr


def drawn(theta: float, beta: float, count: int, seed: int) -> tuple[np.ndarray, np.ndarray]:
    random = np.random.default_rng(seed)
    intensity = np.exp(random.normal(math.log(theta), 1.2 * beta, count))
    return random.random(count) < ndtr(np.log(intensity / theta) / beta), intensity


def iteratively_reweighted(overturned: np.ndarray, intensity: np.ndarray) -> tuple[float, float]:
    """Median and dispersion by the textbook's Fisher scoring of a probit regression."""
    x = np.column_stack([np.ones(len(intensity)), np.log(intensity)])
    coefficients = np.zeros(2)
    for _ in range(100):
        z = x @ coefficients
        mean, density = ndtr(z), np.exp(-0.5 * z * z) / math.sqrt(2.0 * math.pi)
        weight = density**2 / (mean * (1.0 - mean))
        working = z + (overturned - mean) / density
        coefficients = np.linalg.solve(x.T @ (weight[:, None] * x), x.T @ (weight * working))
    return math.exp(-coefficients[0] / coefficients[1]), 1.0 / coefficients[1]


def profile(fixed: str, value: float, overturned: np.ndarray, intensity: np.ndarray) -> float:
    """The largest likelihood at a median or a dispersion, by a search for the other one."""

    def minus(other: np.ndarray) -> float:
        theta, beta = (
            (value, math.exp(other[0])) if fixed == "median" else (math.exp(other[0]), value)
        )
        z = np.log(intensity / theta) / beta
        return -float(np.sum(np.where(overturned, log_ndtr(z), log_ndtr(-z))))

    best = min(minimize(minus, [x], method="Nelder-Mead").fun for x in (-1.0, 0.0, 1.0))
    return -float(best)


def test_it_is_the_probit_regression() -> None:
    overturned, intensity = drawn(3.0, 0.4, 300, seed=1)
    curve = rr.fragility(overturned, intensity)
    theta, beta = iteratively_reweighted(overturned, intensity)
    assert curve.median == pytest.approx(theta, rel=1e-6)
    assert curve.dispersion == pytest.approx(beta, rel=1e-6)
    assert curve(theta) == pytest.approx(0.5, abs=1e-6)


def test_the_intervals_are_those_of_the_likelihood_ratio() -> None:
    overturned, intensity = drawn(3.0, 0.4, 60, seed=2)
    curve = rr.fragility(overturned, intensity, level=0.9)
    drop = 0.5 * chi2.ppf(0.9, 1)
    for fixed, ends in (
        ("median", curve.median_interval),
        ("dispersion", curve.dispersion_interval),
    ):
        assert ends[0] < getattr(curve, fixed) < ends[1]
        for end in ends:
            fallen = curve.log_likelihood - profile(fixed, end, overturned, intensity)
            assert fallen == pytest.approx(drop, rel=1e-4)


@pytest.mark.parametrize("seed", range(3))
def test_the_truth_is_found_back(seed: int) -> None:
    overturned, intensity = drawn(0.35, 0.5, 2000, seed=10 + seed)
    curve = rr.fragility(overturned, intensity, level=0.999)
    assert curve.median_interval[0] < 0.35 < curve.median_interval[1]
    assert curve.dispersion_interval[0] < 0.5 < curve.dispersion_interval[1]
    assert curve.median == pytest.approx(0.35, rel=0.1)


@pytest.mark.soak
def test_the_intervals_hold_the_truth_as_often_as_they_say() -> None:
    held = np.zeros(2)
    for seed in range(300):
        curve = rr.fragility(*drawn(2.0, 0.4, 120, seed=1000 + seed), level=0.9)
        held += [
            curve.median_interval[0] < 2.0 < curve.median_interval[1],
            curve.dispersion_interval[0] < 0.4 < curve.dispersion_interval[1],
        ]
    assert np.all(np.abs(held / 300 - 0.9) < 0.06)


def thresholds(records: int, points: int, beta: float, seed: int) -> tuple[np.ndarray, np.ndarray]:
    """Whether records with lognormal thresholds of median 1 overturn at each of the intensities."""
    random = np.random.default_rng(seed)
    threshold = np.exp(beta * random.standard_normal((records, 1)))
    intensity = np.linspace(0.25, 2.5, points)
    return intensity >= threshold, intensity


def held(records: int, points: int, repeats: int) -> np.ndarray:
    """How often intervals of the median, the dispersion and a probability contain the truth."""
    record, hits = np.arange(records)[:, np.newaxis], []
    for seed in range(repeats):
        curve = rr.fragility(*thresholds(records, points, 0.4, 5000 + seed), records=record)
        low, high = curve.band(0.6)
        hits.append(
            [
                curve.median_interval[0] < 1.0 < curve.median_interval[1],
                curve.dispersion_interval[0] < 0.4 < curve.dispersion_interval[1],
                low < ndtr(math.log(0.6) / 0.4) < high,
            ]
        )
    return np.mean(hits, axis=0)


def test_intervals_over_records_hold_the_truth() -> None:
    # 2.5 standard errors of 95 % in 100 samples are 0.054; independent motions would give 0.75.
    median, dispersion, probability = held(20, 10, 100)
    assert median >= 0.89 and probability >= 0.89
    # In 2000 samples the interval of the dispersion holds it in 92 %.
    assert dispersion >= 0.85


@pytest.mark.soak
@pytest.mark.parametrize("points", [10, 30, 100])
@pytest.mark.parametrize("records", [15, 20, 40])
def test_intervals_over_records_hold_the_truth_whatever_the_points(
    records: int, points: int
) -> None:
    # 3 standard errors of 600 samples are 0.027, to which 0.03 is added for the dispersion, whose
    # interval is a little too narrow for few records.
    median, dispersion, probability = held(records, points, 600)
    assert 0.92 <= median <= 0.98
    assert 0.89 <= dispersion <= 0.98
    assert 0.92 <= probability <= 0.99


def test_the_interval_over_records_does_not_narrow_with_the_number_of_intensities() -> None:
    record = np.arange(20)[:, np.newaxis]
    few, many = (
        rr.fragility(*thresholds(20, points, 0.4, 7), records=record) for points in (10, 100)
    )
    assert few.records == many.records == 20 and many.method == "jackknife"
    widths = [math.log(c.median_interval[1] / c.median_interval[0]) for c in (few, many)]
    assert widths[1] == pytest.approx(widths[0], rel=0.15)
    alone = rr.fragility(*thresholds(20, 100, 0.4, 7))
    assert alone.method == "profile likelihood" and alone.records is None
    assert math.log(alone.median_interval[1] / alone.median_interval[0]) < 0.5 * widths[1]


def test_the_jackknife_is_that_of_curves_without_one_record_each() -> None:
    fell, intensity = thresholds(12, 10, 0.4, 3)
    strength = intensity * np.linspace(0.8, 1.3, 12)[:, np.newaxis]  # other levels for each record
    names = np.array([f"record {k}" for k in range(12)])[:, np.newaxis]
    curve = rr.fragility(fell, strength, records=names, level=0.9)
    others = [np.delete(np.arange(12), k) for k in range(12)]
    without = [rr.fragility(fell[kept], strength[kept]) for kept in others]
    pairs = (
        (curve.median, curve.median_interval, [one.median for one in without]),
        (curve.dispersion, curve.dispersion_interval, [one.dispersion for one in without]),
    )
    for value, ends, found in pairs:
        pseudo = 12 * math.log(value) - 11 * np.log(found)
        error = pseudo.std(ddof=1) / math.sqrt(12)
        expected = np.exp(pseudo.mean() + error * t.ppf([0.05, 0.95], 11))
        assert ends == pytest.approx(expected, rel=1e-5)
    low, high = curve.band([0.5, 1.0])
    assert np.all((low < curve([0.5, 1.0])) & (curve([0.5, 1.0]) < high))


def test_records_that_alone_decide_the_curve_leave_the_intervals_open() -> None:
    fell, intensity = np.array([[0, 0, 1], [0, 1, 0], [0, 0, 1]]), [1.0, 2.0, 3.0]
    curve = rr.fragility(fell, intensity, records=np.arange(3)[:, np.newaxis])
    assert curve.median_interval == (0.0, math.inf) == curve.dispersion_interval
    assert [end.tolist() for end in curve.band([1.0])] == [[0.0], [1.0]]
    one = rr.fragility([0, 1, 0, 1], [1.0, 2.0, 3.0, 4.0], records=0)
    assert one.records == 1 and one.median_interval == (0.0, math.inf)


def test_records_of_one_motion_each_are_independent() -> None:
    overturned, intensity = drawn(3.0, 0.4, 60, seed=2)
    each = rr.fragility(overturned, intensity, records=np.arange(60))
    plain = rr.fragility(overturned, intensity)
    assert each.method == "profile likelihood" and each.median_interval == plain.median_interval
    with pytest.raises(rr.RimrollError, match="band is for motions that share records"):
        plain.band(1.0)
    with pytest.raises(rr.RimrollError, match="records must broadcast with overturned"):
        rr.fragility(overturned, intensity, records=[1, 2])


def test_the_unit_of_the_intensity_scales_the_median_alone() -> None:
    overturned, intensity = drawn(3.0, 0.4, 80, seed=3)
    one, other = (rr.fragility(overturned, scale * intensity) for scale in (1.0, 9.81))
    assert other.median == pytest.approx(9.81 * one.median, rel=1e-6)
    assert other.dispersion == pytest.approx(one.dispersion, rel=1e-6)


def test_its_text_is_a_line() -> None:
    curve = rr.fragility([0, 3, 7, 10], [2.0, 3.0, 4.0, 6.0], trials=10)
    assert repr(curve).startswith("<Fragility: median 3.464 (")
    assert repr(curve).endswith("dispersion 0.221 (0.125 to 0.416), 40 trials>")


def test_counts_are_as_good_as_single_trials() -> None:
    counted = rr.fragility([1, 4, 9], [1.0, 2.0, 4.0], trials=10)
    single = rr.fragility(
        np.concatenate([np.arange(10) < fell for fell in (1, 4, 9)]), np.repeat([1.0, 2.0, 4.0], 10)
    )
    assert counted.median == pytest.approx(single.median, rel=1e-7)
    assert counted.dispersion_interval == pytest.approx(single.dispersion_interval, rel=1e-6)


def test_a_dataset_of_motions_is_taken_as_it_is() -> None:
    column = rr.Body(1000, 0.5, 2.0, 1395.8333333333333, 125.0)
    soft = {"duration": 8.0, "step": 0.02, "soil_period": 1.5}
    grounds = {str(seed): rr.ground.synthetic(seed, 1.0, **soft) for seed in range(8)}  # type: ignore[arg-type]
    shaken = rr.shake_many(
        column,
        rr.State.standing(),
        rr.NoSlip(),
        grounds,
        scale=rr.axis("scale", [3.0, 4.0, 5.0, 6.0]),
        flat="housner",
    )
    curve = rr.fragility(shaken, shaken["scale"])
    assert not curve.undecided.any()
    same = rr.fragility(shaken["overturned"], shaken["scale"])
    assert curve.median == same.median and curve.median_interval == same.median_interval
    assert (curve.method, curve.records) == ("jackknife", 8)
    assert curve.overturned.sum() == shaken["overturned"].sum().item()
    assert 3.0 < curve.median < 9.0


def test_motions_that_ended_undecided_are_left_out_and_counted() -> None:
    fell, intensity = [1, 4, 9, 6, 0], [1.0, 2.0, 4.0, 4.0, 8.0]
    open_ = [0, 3, 0, 2, 5]
    with pytest.warns(rr.UndecidedWarning, match=r"10 of 45 .* overturns: 3 at 2, 2 at 4, 5 at 8$"):
        curve = rr.fragility(fell, intensity, trials=[10, 10, 10, 10, 5], undecided=open_)
    without = rr.fragility(fell[:4], intensity[:4], trials=[10, 7, 10, 8])
    assert (curve.median, curve.dispersion) == (without.median, without.dispersion)
    assert curve.undecided.tolist() == open_ and curve.trials.tolist() == [10, 10, 10, 10, 5]
    assert curve.plot() is not None


def test_motions_that_stop_flat_while_the_table_moves_or_still_fall_are_undecided() -> None:
    column = rr.Body(1000, 0.5, 2.0, 1395.8333333333333, 125.0)
    pulse = rr.ground.rectangular(3.6, 0.58) + rr.ground.sine(1e-3, 1.0, cycles=60)
    falling, flat, fell = (
        rr.shake_many(
            column, start, rr.NoSlip(), pulse, scale=scale, duration=duration, flat="stop"
        )
        for start, scale, duration in (
            (rr.State(tilt=0.26), 1e-3, 1.0),
            (rr.State.standing(), 0.9, 20.0),
            (rr.State.standing(), 1.2, 20.0),
        )
    )
    assert falling.status.item() == "finished" and falling.end_tilt > math.atan(0.25)
    assert flat.status.item() == "face_down"
    assert [bool(one.undecided) for one in (falling, flat, fell)] == [True, True, False]
    assert [bool(one.overturned) for one in (falling, flat, fell)] == [False, False, True]
    standing = rr.shake_many(column, rr.State.standing(), rr.NoSlip(), pulse, scale=0.3)
    assert not standing.undecided.item()


def test_a_dataset_brings_its_undecided_motions() -> None:
    column = rr.Body(1000, 0.5, 2.0, 1395.8333333333333, 125.0)
    soft = {"duration": 8.0, "step": 0.02, "soil_period": 1.5}
    grounds = {str(seed): rr.ground.synthetic(seed, 1.0, **soft) for seed in range(8)}  # type: ignore[arg-type]
    shaken = rr.shake_many(
        column,
        rr.State.standing(),
        rr.NoSlip(),
        grounds,
        scale=rr.axis("scale", [2.0, 3.0, 4.0, 5.0, 6.0]),
        flat="stop",
    )
    # Planar motions come down flat at their first impact: all columns that were lifted.
    assert shaken.undecided.sum("ground").values.tolist() == [0, 8, 8, 8, 8]
    words = "^32 of 40 motions are left out"
    with (
        pytest.warns(rr.UndecidedWarning, match=words),
        pytest.raises(rr.RimrollError, match="no body overturned"),
    ):
        rr.fragility(shaken, shaken["scale"])


def test_data_that_bound_no_parameter_have_an_open_interval() -> None:
    curve = rr.fragility([False, True, False, True], [1.0, 2.0, 3.0, 4.0])
    assert curve.dispersion_interval[1] == math.inf
    assert curve.median_interval[0] == 0.0
    assert curve.median_interval[1] == math.inf


@pytest.mark.parametrize(
    ("overturned", "intensity", "message"),
    [
        ([False, False, True, True], [1.0, 2.0, 3.0, 4.0], "separable"),
        ([False, False, True, True], [1.0, 2.0, 2.0, 4.0], "separable"),
        ([True, True], [1.0, 2.0], "every body overturned"),
        ([False, False], [1.0, 2.0], "no body overturned"),
        ([True, False], [1.0, 2.0], "does not grow"),
        ([True, False, True, False], [1.0, 2.0, 3.0, 4.0], "does not grow"),
        ([True, False], [0.0, 2.0], r"intensity\[0\] must be > 0"),
        ([2, 0], [1.0, 2.0], r"overturned\[0\] must be whole"),
        ([1, 0, 1], [1.0, 2.0], "must broadcast"),
    ],
)
def test_refusals(overturned: list[int], intensity: list[float], message: str) -> None:
    with pytest.raises(rr.RimrollError, match=message):
        rr.fragility(overturned, intensity)


def test_undecided_motions_are_some_of_those_that_did_not_overturn() -> None:
    with pytest.raises(rr.RimrollError, match=r"undecided\[1\] must be whole"):
        rr.fragility([0, 1], [1.0, 2.0], undecided=[0, 1])
    with (
        pytest.warns(rr.UndecidedWarning),
        pytest.raises(rr.RimrollError, match="all motions are undecided"),
    ):
        rr.fragility([0, 0], [1.0, 2.0], undecided=[True, True])


def test_a_limit_counts_large_tilts_in_place_of_overturning() -> None:
    column = rr.Body(1000, 0.5, 2.0, 1395.8333333333333, 125.0)
    grounds = [rr.ground.synthetic(seed, (1.0, 1.0, 0.0), step=0.02) for seed in range(8)]
    scale = rr.axis("scale", [2.8, 3.3, 4.0, 6.0])
    shaken = rr.shake_many(
        column, rr.State.standing(), rr.InPlace(), grounds, scale=scale, flat="housner"
    )
    curve = rr.fragility(shaken, scale, limit=0.5)
    far = shaken["max_tilt_ratio"] >= 0.5
    assert curve.overturned.sum() == far.sum().item() > shaken["overturned"].sum().item()
    assert curve.limit == 0.5 and curve.median < rr.fragility(shaken, scale).median
    label = curve.plot("PGA (m/s²)").axes[0].get_ylabel()
    assert label == "probability of a tilt ≥ 0.5 of the balance tilt"
    with pytest.raises(rr.RimrollError, match="limit must be above 0 and at most 1, got 2"):
        rr.fragility(shaken, scale, limit=2)
    with pytest.raises(rr.RimrollError, match="limit is for a dataset"):
        rr.fragility([1, 2], [1.0, 2.0], trials=3, limit=0.5)
    with pytest.raises(rr.RimrollError, match="no body reached the limit"):
        rr.fragility(shaken.sel(scale=[2.8]).isel(ground=[1]), [1.0], limit=1)


def test_intensities_with_names_go_along_the_dimensions_of_the_motions() -> None:
    column = rr.Body(1000, 0.5, 2.0, 1395.8333333333333, 125.0)
    grounds = [rr.ground.synthetic(seed, (1.0, 1.0, 0.0), step=0.02) for seed in range(4)]
    scale = rr.axis("scale", [3.0, 4.0, 5.0, 6.0])  # as many as grounds
    shaken = rr.shake_many(
        column, rr.State.standing(), rr.InPlace(), grounds, scale=scale, flat="housner"
    )
    peaks = xr.DataArray([ground.peak.horizontal for ground in grounds], dims="ground")
    one, other = (rr.fragility(shaken, product) for product in (peaks * scale, scale * peaks))
    expected = np.outer(peaks.values, scale.values).ravel()
    np.testing.assert_allclose(one.intensity, expected)
    assert one.median == other.median
    with pytest.raises(rr.RimrollError, match="the dimension seed, which the motions have not"):
        rr.fragility(shaken, rr.axis("seed", [1.0, 2.0]))
    with pytest.raises(rr.RimrollError, match="other labels along scale than the motions"):
        rr.fragility(shaken, rr.axis("scale", [3.0, 4.0, 5.0, 7.0]))
