"""Tests of shape against those of SciPy."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.stats import cramervonmises, vonmises

from rimroll.experiment.fitting.shape import Hump, chance_of_uniform


@pytest.mark.parametrize("n", [8, 15, 42, 300, 1000])
@pytest.mark.parametrize("power", [0.5, 0.8, 1.0, 1.3, 2.0])
def test_the_chance_is_that_of_cramer_and_von_mises_test(n, power):
    for seed in range(5):
        numbers = np.random.default_rng(seed).random(n) ** power
        theirs = cramervonmises(numbers, "uniform").pvalue
        assert chance_of_uniform(numbers) == pytest.approx(theirs, abs=1e-6)


def test_evenly_spread_numbers_are_as_near_to_even_as_can_be():
    assert chance_of_uniform((np.arange(42) + 0.5) / 42) > 0.999
    assert chance_of_uniform(np.full(42, 0.5)) < 1e-5


@pytest.mark.parametrize("concentration", [0.05, 0.7, 3.0, 40.0, 900.0])
def test_the_likeliest_hump_is_the_one_that_scipy_finds(concentration):
    drawn = vonmises.rvs(concentration, 2.5, size=200, random_state=3)
    narrowness, middle, _ = vonmises.fit(drawn, fscale=1.0)
    found = Hump.of(drawn)
    assert found.concentration == pytest.approx(narrowness, rel=1e-6)
    assert np.cos(found.middle - middle) == pytest.approx(1.0, abs=1e-12)
    expected = vonmises.pdf(drawn, narrowness, middle)
    assert found.density(drawn) == pytest.approx(expected, rel=1e-5)
