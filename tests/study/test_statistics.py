"""Statistics are merged exactly, and are those of NumPy."""

import dataclasses
import itertools
import random
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import rimroll as rr
from given.strategies import examples
from rimroll.study.statistics import HEADER, added, mean, sums, whole


def flicks():
    return rr.Study(
        kind="topple",
        body={"preset": "can_2007"},
        law={"kind": "coulomb"},
        release="paper",
        axes={"law.friction": [0.05, 0.3], "body.height": ["5 cm", "6 cm", "7 cm"]},
        trials=30,
        seed=3,
        statistics={
            "over": ["trial", "friction"],
            "count": ["outcome", "slid"],
            "mean": ["turn", "end_time"],
            "extremes": ["turn"],
            "histogram": {"direction": {"range": ["90 deg", "270 deg"], "bins": 9}},
        },
    ).plan()


@pytest.fixture(scope="module")
def plan():
    return flicks()


@pytest.fixture(scope="module")
def columns(plan):
    return plan.compute(0, plan.rows)


def parts(plan, columns, ends):
    for first, last in itertools.pairwise(ends):
        yield plan.statistics.of(
            first, last, {name: one[first:last] for name, one in columns.items()}
        )


@examples(20)
@given(cuts=st.sets(st.integers(1, 179), max_size=6), seed=st.integers(0, 100))
def test_statistics_depend_on_no_chunk_and_no_order(plan, columns, cuts, seed):
    whole = plan.statistics.merged(parts(plan, columns, [0, plan.rows]))
    pieces = list(parts(plan, columns, [0, *sorted(cuts), plan.rows]))
    random.Random(seed).shuffle(pieces)
    for name, one in plan.statistics.merged(pieces).items():
        assert np.array_equal(one, whole[name], equal_nan=True), name


def test_statistics_are_those_of_numpy(plan, columns):
    found = plan.statistics.merged(parts(plan, columns, [0, 77, plan.rows]))
    assert dict(plan.statistics.groups) == {"height": 3}

    def groups(name):
        return np.moveaxis(columns[name].reshape(2, 3, 30), 1, 0).reshape(3, 60)

    assert (found["number"] == 60).all()
    turn = groups("turn")
    np.testing.assert_allclose(found["turn_mean"], np.nanmean(turn, axis=1), rtol=1e-13)
    np.testing.assert_allclose(found["turn_sd"], np.nanstd(turn, axis=1, ddof=1), rtol=1e-12)
    assert (found["turn_min"] == np.nanmin(turn, axis=1)).all()
    assert (found["turn_max"] == np.nanmax(turn, axis=1)).all()
    assert (found["slid_count"] == groups("slid").sum(axis=1)).all()
    for k in range(3):
        words = groups("outcome")[k]
        assert (found["outcome_count"][k] == np.bincount(words, minlength=9)).all()
        direction = groups("direction")[k]
        edges = np.linspace(0.5 * np.pi, 1.5 * np.pi, 10)
        counts, _ = np.histogram(direction[~np.isnan(direction)], edges)
        assert (found["direction_histogram"][k] == counts).all()
        assert found["direction_below"][k] == (direction < edges[0]).sum()
        assert found["direction_above"][k] == (direction > edges[-1]).sum()


@given(st.lists(st.floats(-1e18, 1e18).filter(lambda x: x == 0 or abs(x) > 1e-20), min_size=1))
def test_sums_are_exact(numbers):
    values = np.array(numbers)
    pieces = sums(values, np.zeros(len(values), np.int64), 1)[0]
    exact = sum(map(Fraction, numbers))
    assert Fraction(whole(pieces), 2**128) == exact
    assert mean(pieces, len(numbers)) == float(exact / len(numbers))


@given(
    st.lists(st.floats(-1e18, 1e18).filter(lambda x: x == 0 or abs(x) > 1e-20), min_size=1),
    st.integers(31, 62),
)
def test_sums_of_more_numbers_than_fit_into_64_bits_are_exact(numbers, doublings):
    values = np.array(numbers)
    total = sums(values, np.zeros(len(values), np.int64), 1)
    for _ in range(doublings):
        total = added(total, total)
    exact = sum(map(Fraction, numbers)) * 2**doublings
    assert Fraction(whole(total[0]), 2**128) == exact


def test_fragility_is_that_of_the_counts():
    axes = {
        "record": {"of": "ground.synthetic", "range": [1, 12], "number": 12},
        "length": {"of": "body.length", "values": ["4 m", "6 m"]},
        "intensity": {"of": "ground.scale", "log_range": [0.15, 1.5], "number": 5},
    }
    plan = rr.Study(
        kind="shake",
        body={"preset": "cylinder", "radius": "0.5 m", "length": "4 m"},
        ground={"synthetic": 1, "amplitude": "1 g", "duration": "8 s"},
        simulation={"flat": "housner", "rtol": 1e-6},
        axes=axes,
        statistics={"over": ["record"], "fragility": "intensity"},
    ).plan()
    columns = plan.compute(0, plan.rows)
    found = plan.statistics.merged([plan.statistics.of(0, plan.rows, columns)])
    intensity = plan.coords["intensity"].values
    for k in range(2):
        overturned = columns["overturned"].reshape(12, 2, 5)[:, k].sum(axis=0)
        assert (found["overturned_count"][k] == overturned).all()
        curve = rr.fragility(overturned, intensity, trials=12)
        assert found["fragility_median"][k] == curve.median
        assert found["fragility_dispersion"][k] == curve.dispersion


def test_the_size_of_statistics_counts_the_parts_of_chunks(plan, columns):
    smaller = dataclasses.replace(plan, chunk=10)
    parts_of_chunks = [
        plan.statistics.of(a, b, {name: one[a:b] for name, one in columns.items()})
        for a, b in smaller
    ]
    numbers = sum(one.nbytes for part in parts_of_chunks for one in part.values())
    arrays = len(parts_of_chunks[0])
    variables = plan.bytes - plan.statistics.bytes_of_parts(plan.blocks)
    assert smaller.bytes == variables + numbers + 18 * arrays * HEADER


def test_the_bins_of_a_histogram_have_the_unit_of_their_column(plan):
    assert plan.statistics.coords["direction_bin"].unit == "rad"
