"""Random numbers of studies: their distributions, and that a row keeps its own."""

import numpy as np
import pytest
import scipy.stats
from hypothesis import given
from hypothesis import strategies as st

import rimroll as rr
from given.strategies import examples
from rimroll.study.draws import Sampling, stream

MANY = 20_000

DISTRIBUTIONS = {
    "uniform": ({"low": 0.1, "high": 0.4}, scipy.stats.uniform(0.1, 0.3)),
    "normal": ({"mean": 0.3, "spread": 0.02}, scipy.stats.norm(0.3, 0.02)),
    "lognormal": ({"median": 0.2, "dispersion": 0.3}, scipy.stats.lognorm(0.3, scale=0.2)),
    "triang": ({"c": 0.25, "loc": 0.1, "scale": 0.5}, scipy.stats.triang(0.25, 0.1, 0.5)),
    "gamma": ({"a": 9.0, "scale": 0.02}, scipy.stats.gamma(9.0, scale=0.02)),
}


def sampled(distribution, **more):
    """A study in which the friction is drawn."""
    return rr.Study(
        body={"preset": "can_2007"},
        start=rr.State(tilt=0.3, yaw_rate=0.1),
        random={"law.friction": {"distribution": distribution, **DISTRIBUTIONS[distribution][0]}},
        trials=MANY,
        seed=5,
        law="coulomb",
        **more,
    ).description


def frictions(description, first, last):
    return description.block(first, last).given[-1].array


@pytest.mark.parametrize("distribution", DISTRIBUTIONS)
def test_quantities_are_distributed_as_scipy_says(distribution):
    drawn = frictions(sampled(distribution), 0, MANY)
    assert scipy.stats.kstest(drawn, DISTRIBUTIONS[distribution][1].cdf).pvalue > 0.01


@pytest.mark.parametrize("sampling", ["sobol", "latin_hypercube"])
def test_even_designs_fill_a_distribution_more_evenly_than_chance(sampling):
    of = DISTRIBUTIONS["normal"][1]
    distance = {
        method: scipy.stats.kstest(
            frictions(sampled("normal", sampling=method), 0, MANY), of.cdf
        ).statistic
        for method in ("independent", sampling)
    }
    assert distance[sampling] < 0.1 * distance["independent"]


@examples(40)
@given(
    name=st.text(max_size=5),
    seed=st.integers(0, 2**63 - 1),
    first=st.integers(0, 2**40),
    cut=st.integers(1, 30),
)
def test_a_part_of_a_sequence_is_that_part_of_the_whole(name, seed, first, cut):
    whole = stream(seed, name, first, first + 31)
    parts = [stream(seed, name, first, first + cut), stream(seed, name, first + cut, first + 31)]
    assert np.array_equal(whole, np.concatenate(parts))
    assert ((whole > 0.0) & (whole < 1.0)).all()


def test_sequences_of_other_names_and_seeds_are_uncorrelated():
    drawn = [stream(*key, 0, MANY) for key in ((1, "a"), (1, "b"), (2, "a"))]
    correlations = np.corrcoef(drawn)[np.triu_indices(3, 1)]
    assert np.abs(correlations).max() < 4.0 / np.sqrt(MANY)


def test_common_numbers_are_the_same_at_every_place_and_independent_ones_are_not():
    axes = {"body.height": ["5 cm", "6 cm", "7 cm"]}
    common, independent = (
        frictions(sampled("uniform", sampling=method, axes=axes), 0, 3 * MANY).reshape(3, MANY)
        for method in ("common", "independent")
    )
    assert (common == common[0]).all()
    assert (independent[0] != independent[1]).any()
    assert np.array_equal(common[0], independent[0])


def test_another_random_quantity_leaves_the_numbers_of_the_first_as_they_are():
    alone = Sampling("independent", 7, 10, ("a",), release=False)
    both = Sampling("independent", 7, 10, ("a", "b"), release=True)
    assert np.array_equal(alone.chances(3, 9)[0]["a"], both.chances(3, 9)[0]["a"])
