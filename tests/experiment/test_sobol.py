"""Sobol's points against SciPy's, and how evenly they lie."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.stats import qmc

from rimroll.experiment.fitting.sobol import DIMENSIONS, SEED, points


@pytest.mark.parametrize("power", [0, 1, 5, 8, 12])
def test_the_points_are_those_of_scipy(power):
    theirs = qmc.Sobol(DIMENSIONS, seed=SEED).random_base2(power)
    assert np.array_equal(points(2**power), theirs)


def test_each_part_of_a_cube_s_edge_has_one_point():
    for column in points(1024).T:
        assert np.array_equal(np.sort(np.floor(1024 * column)), np.arange(1024))
