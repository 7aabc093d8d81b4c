"""Rocking spectra, overturning spectra, and distributions of maxima."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.stats import ks_2samp

import rimroll as rr

COLUMN = rr.Body(1000, 0.5, 2.0, 1395.8333333333333, 125.0)


def half_square(amplitude: float, period: float) -> rr.Ground:
    return rr.ground.rectangular(amplitude, period / 2)


def test_slender_bodies_overturn_as_in_housners_formula() -> None:
    """cosh(p t) = 1 + 1/(2 a (a − 1)) with a = a_p/(g α), for slender bodies (Housner 1963)."""
    slender = rr.bodies.cylinder(radius=0.005, length=2.0)
    expected = np.array([1.2, 2.0, 5.0])
    duration = np.arccosh(1.0 + 1.0 / (2.0 * expected * (expected - 1.0)))
    spectrum = rr.overturning_spectrum(slender, half_square, math.pi / duration)
    np.testing.assert_allclose(spectrum.amplitude_ratio, expected, rtol=3e-4)


def test_the_columns_exact_pulse_is_on_its_spectrum() -> None:
    p = rr.rocking_frequency(COLUMN, gravity=9.81)
    ratio = math.pi / (p * 0.580520881038643)
    spectrum = rr.overturning_spectrum(
        COLUMN, half_square, [ratio], [1.0, 1.4, 1.9], gravity=9.81, precision=1e-6, rtol=1e-10
    )
    assert spectrum.amplitude_ratio[0] == pytest.approx(1.5, rel=2e-6)


def test_the_least_scale_is_the_lowest_of_several_intervals() -> None:
    """A full sine of this frequency overturns the column, then does not, then does."""
    ratio = 4.0
    tried = np.linspace(1.0, 12.0, 56)
    spectrum = rr.overturning_spectrum(COLUMN, rr.ground.sine, [ratio], tried)
    overturned = spectrum.overturned[0]
    changes = np.flatnonzero(np.diff(overturned.astype(int)))
    first = int(overturned.argmax())
    assert len(changes) >= 3, "the case has one interval only"
    assert tried[first - 1] < spectrum.amplitude_ratio[0] <= tried[first]


def test_motions_that_end_undecided_are_told() -> None:
    """So strong a pulse throws the rim off the table; a law without flight cannot follow that."""
    spectrum = rr.overturning_spectrum(COLUMN, rr.ground.sine, [4.0], [1.0, 3.0, 25.0])
    assert spectrum.overturned.tolist() == [[False, True, False]]
    assert spectrum.undecided.tolist() == [[False, False, True]]


def test_an_interval_holds_the_least_scale() -> None:
    ground = rr.ground.sine(1.0, 2.0)
    found = rr.overturning_scale(
        COLUMN,
        rr.State.standing(),
        rr.NoSlip(),
        ground,
        np.geomspace(2.0, 20.0, 15),
        precision=1e-5,
    )
    ends = [found["below"].item(), found["scale"].item()]
    assert 0.0 < ends[1] - ends[0] <= 1e-5 * ends[1]
    shaken = rr.shake_many(
        COLUMN, rr.State.standing(), rr.NoSlip(), ground, scale=np.array(ends), flat="housner"
    )
    assert list(shaken["overturned"].values) == [False, True]


def test_scales_that_do_not_overturn_and_that_all_do() -> None:
    calm, strong = rr.ground.sine(1.0, 0.1), rr.ground.rectangular(20.0, 2.0)
    found = rr.overturning_scale(
        COLUMN, rr.State.standing(), rr.NoSlip(), [calm, strong], [1.0, 2.0]
    )
    assert np.isnan(found["scale"][0])
    assert found["below"].values.tolist() == [2.0, 0.0]
    assert found["scale"][1] == 1.0


def test_a_rocking_spectrum_is_of_bodies_of_one_shape() -> None:
    periods = np.array([2.0, 3.0, 5.0])
    ground = rr.ground.sine(2.9, 0.8)
    spectrum = rr.rocking_spectrum(COLUMN, ground, periods)
    bodies = rr.Body.from_xarray(spectrum.dataset)
    p = np.asarray(rr.rocking_frequency(bodies))
    np.testing.assert_allclose(2.0 * math.pi / p, periods, rtol=1e-12)
    for ratio in (
        bodies.radius / bodies.height,
        bodies.transverse_inertia / bodies.height**2,
        bodies.axial_inertia / bodies.height**2,
    ):
        np.testing.assert_allclose(ratio, ratio[0], rtol=1e-12)
    # Larger bodies are more stable.
    assert np.all(np.diff(spectrum.max_tilt_ratio) < 0.0)


def test_bodies_and_times_scaled_together_rock_alike() -> None:
    """Under the same accelerations, times are scaled by √L."""
    longer = rr.rocking_spectrum(COLUMN, rr.ground.sine(2.9, 1.6), [4.0])
    shorter = rr.rocking_spectrum(COLUMN, rr.ground.sine(2.9, 0.8), [2.0])
    assert longer.max_tilt_ratio[0] == pytest.approx(shorter.max_tilt_ratio[0], rel=1e-6)


def test_the_rocking_frequency_of_many_bodies() -> None:
    bodies = rr.Body.stack({"column": COLUMN, "can": rr.bodies.can_2007()})
    p = rr.rocking_frequency(bodies, "9.81 m/s2")
    assert p.dims == ("body",)
    assert p.sel(body="column").item() == rr.rocking_frequency(COLUMN, 9.81)


def test_maxima_depend_on_the_seed_alone() -> None:
    def maxima(seed: int, threads: int) -> rr.Maxima:
        return rr.random_maxima(
            COLUMN,
            rr.State.standing(),
            rr.NoSlip(),
            rr.ground.sine((2.7, 1.0, 0.0), 1.0),
            40,
            tilt_noise=1e-3,
            seed=seed,
            threads=threads,
        )

    one, same, other = maxima(1, 1), maxima(1, 3), maxima(2, 2)
    np.testing.assert_array_equal(one.values, same.values)
    assert not np.array_equal(one.values, other.values)
    assert one.distance(same).statistic == 0.0
    expected = ks_2samp(one.values, other.values)
    assert one.distance(other) == (expected.statistic, expected.pvalue)


HALF_SINE_THEN_FAINT = rr.ground.half_sine(1.0, 1.0) + rr.ground.sine(1e-3, 1.0, cycles=60)
"""A table that still moves when a body comes down flat, so that it is undecided what follows."""


def test_undecided_motions_are_no_maxima() -> None:
    shaken = rr.shake_many(
        COLUMN,
        rr.State.standing(),
        rr.NoSlip(),
        HALF_SINE_THEN_FAINT,
        scale=np.array([1.0, 3.0, 9.0]),
        flat="stop",
    )
    assert shaken["undecided"].values.tolist() == [False, True, False]
    with pytest.warns(rr.UndecidedWarning, match="1 of 3 motions are left out"):
        assert rr.Maxima.of(shaken).values.tolist() == [0.0, np.inf]
    with (
        pytest.warns(rr.UndecidedWarning),
        pytest.raises(rr.RimrollError, match="all motions are undecided"),
    ):
        rr.Maxima.of(shaken.isel(trial=[1]))


def test_undecided_factors_are_not_those_that_a_body_survives() -> None:
    """Planar motions come down flat: below what overturns at once, nothing is decided."""
    found = rr.overturning_scale(
        COLUMN,
        rr.State.standing(),
        rr.NoSlip(),
        HALF_SINE_THEN_FAINT,
        np.array([1.0, 2.0, 3.0, 9.0]),
        flat="stop",
    )
    assert found["undecided"].values.tolist() == [[False, False, True, False]]
    assert found["below"].item() == 2.0 and found["scale"].item() > 3.0
    ground = rr.ground.sine(3.0, 1.0) + rr.ground.sine(1e-3, 1.0, cycles=60)
    spectrum = rr.rocking_spectrum(COLUMN, ground, np.array([2.0, 3.3]), flat="stop")
    assert spectrum.undecided.any()
    assert np.isnan(spectrum.max_tilt_ratio[spectrum.undecided]).all()
    assert spectrum.plot() is not None


def test_the_distribution_counts_bodies_that_overturned() -> None:
    maxima = rr.Maxima(np.array([0.5, np.inf, 0.2, 0.5]))
    assert maxima.overturned == 0.25
    np.testing.assert_array_equal(maxima.cdf([0.1, 0.2, 0.5, 9.0]), [0.0, 0.25, 0.75, 0.75])
    with pytest.raises(rr.RimrollError, match="values must be a flat array"):
        rr.Maxima(np.array([]))


def test_imperfect_starts_scatter_about_the_start() -> None:
    start = rr.State(tilt=0.1, yaw=0.7, yaw_rate=0.2)
    starts = rr.imperfect_starts(start, 4000, "0.1 deg", seed=3)
    x, y = starts.tilt * np.cos(starts.yaw), starts.tilt * np.sin(starts.yaw)
    noise = np.radians(0.1)
    for component, mean in ((x, 0.1 * np.cos(0.7)), (y, 0.1 * np.sin(0.7))):
        assert abs(component.mean() - mean) < 5.0 * noise / math.sqrt(4000)
        assert component.std() == pytest.approx(noise, rel=0.06)
    assert np.all(starts.yaw_rate == 0.2)


def test_refusals() -> None:
    with pytest.raises(rr.RimrollError, match="a disk has no balance tilt"):
        rr.overturning_spectrum(rr.bodies.disk(0.1), rr.ground.sine, [1.0])
    with pytest.raises(rr.RimrollError, match="scales must increase"):
        rr.overturning_scale(
            COLUMN, rr.State.standing(), rr.NoSlip(), rr.ground.sine(1.0, 1.0), [2.0, 1.0]
        )
    with pytest.raises(rr.RimrollError, match=r"periods\[1\] must be > 0"):
        rr.rocking_spectrum(COLUMN, rr.ground.sine(1.0, 1.0), [1.0, -1.0])
    with pytest.raises(rr.RimrollError, match="tilt_noise must be > 0"):
        rr.imperfect_starts(rr.State.standing(), 3, 0.0, seed=0)
