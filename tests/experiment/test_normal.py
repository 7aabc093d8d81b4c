"""Normal quantiles, chances and densities against SciPy's."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.special import ndtr, ndtri
from scipy.stats import norm

from rimroll.experiment.normal import chance_below, density, quantiles


def test_quantiles_are_right_from_the_middle_to_the_last_chance_that_is_drawn():
    near_zero = np.concatenate([2.0 ** np.linspace(-1074.0, -1.0, 4001), [0.075, 0.5 - 0.425]])
    chances = np.concatenate([near_zero, np.linspace(0.001, 0.999, 2000), 1.0 - near_zero[1000:]])
    chances = chances[(chances > 0.0) & (chances < 1.0)]
    assert quantiles(chances) == pytest.approx(ndtri(chances), rel=4e-15, abs=4e-16)
    assert quantiles(np.array([0.5])) == 0.0


def test_quantiles_are_the_inverse_of_chances():
    for x in np.linspace(-30.0, 8.0, 77).tolist():
        # An ulp of x = -30 changes the chance there by 1e-13 of it.
        assert chance_below(x) == pytest.approx(ndtr(x), rel=4e-13, abs=0.0)
        # Above 0 the rounding of the chance, 1e-16 of 1, is all that there is.
        error = 1e-13 + 2e-16 / norm.pdf(x)
        assert quantiles(np.array([chance_below(x)]))[0] == pytest.approx(x, abs=error)


def test_densities_are_the_slope_of_chances():
    x = np.linspace(-9.0, 9.0, 19)
    assert density(x) == pytest.approx(norm.pdf(x), rel=1e-14, abs=0.0)
