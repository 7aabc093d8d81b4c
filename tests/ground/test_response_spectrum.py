"""Response spectra against closed forms and an independent integration."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.signal import lsim

import rimroll as rr
from given.strategies import examples


def largest(ground, period, damping=0.0):
    return ground.response_spectrum([period], damping).displacement.values[0]


@given(ratio=st.floats(0.05, 30.0))
@examples(100)
def test_half_a_sine_on_an_undamped_oscillator(ratio):
    """Closed form: during the pulse two sines, after it a free vibration."""
    length, amplitude, period = 0.4, 2.0, 0.4 * ratio
    w, p = 2 * np.pi / period, np.pi / length
    if abs(w / p - 1.0) < 1e-3:
        return
    t = np.linspace(0.0, length, 100_001)
    factor = amplitude / (w**2 - p**2)
    u = factor * (np.sin(p * t) - p / w * np.sin(w * t))
    v = factor * p * (np.cos(p * length) - np.cos(w * length))
    exact = max(np.abs(u).max(), np.hypot(u[-1], v / w))
    found = largest(rr.ground.half_sine(amplitude, length), period)
    assert found.tolist() == pytest.approx([exact, 0.0, 0.0], rel=1e-4)


@given(ratio=st.floats(0.05, 30.0))
@examples(100)
def test_a_block_on_an_undamped_oscillator(ratio):
    """Closed form: twice the static displacement, or less if the block is over before."""
    length, amplitude, period = 0.4, 2.0, 0.4 * ratio
    w = 2 * np.pi / period
    exact = 2 * amplitude / w**2 * (1.0 if period <= 2 * length else np.sin(w * length / 2))
    found = largest(rr.ground.rectangular((0.0, amplitude, 0.0), length), period)
    assert found.tolist() == pytest.approx([0.0, exact, 0.0], rel=1e-4)


@given(
    seed=st.integers(0, 10_000),
    period=st.floats(0.03, 8.0),
    damping=st.floats(0.0, 0.5),
    last=st.floats(-2.0, 2.0),
)
@examples(60)
def test_a_record_against_an_integration_by_matrix_exponentials(seed, period, damping, last):
    """With a jump at the beginning and at the end."""
    step, count = 0.02, 150
    samples = np.random.default_rng(seed).standard_normal((count, 3))
    samples[-1] = last
    finer = max(20, int(np.ceil(step / (period / 200))))
    fine = step / finer
    shaken = np.arange((count - 1) * finer + 1) * fine
    free = np.arange(int(np.ceil(period / fine)) + 1) * fine
    w = 2 * np.pi / period
    oscillator = ([[0, 1], [-(w**2), -2 * damping * w]], [[0], [-1]], np.eye(2), [[0], [0]])
    for axis in range(3):
        forced = np.interp(shaken, np.arange(count) * step, samples[:, axis])
        _, during, _ = lsim(oscillator, forced, shaken)
        _, after, _ = lsim(oscillator, np.zeros_like(free), free, during[-1])
        exact = max(np.abs(during[:, 0]).max(), np.abs(after[:, 0]).max())
        found = largest(rr.ground.sampled(step, samples), period, damping)[axis]
        # At 200 points in a period the oracle misses at most 1.3e-4 of a peak.
        assert found == pytest.approx(exact, rel=2.5e-4)


def test_stiff_oscillators_follow_the_ground_and_soft_ones_stay_behind():
    ground = rr.ground.ricker((3.0, 2.0, 1.0), 0.5)  # which ends at rest
    spectrum = ground.response_spectrum([0.005, 200.0])
    stiff, soft = spectrum.pseudo_acceleration[0], spectrum.displacement[1]
    np.testing.assert_allclose(stiff, ground.peak[:3], rtol=0.01)
    np.testing.assert_allclose(soft, ground.peak_displacement[:3], rtol=0.05)


def test_pseudo_spectra_have_units_and_differ_by_the_frequency():
    spectrum = rr.ground.sine(2.0, 0.5).response_spectrum(["200 ms", 1.0], "5 %")
    omega = 2 * np.pi / spectrum.period
    np.testing.assert_allclose(spectrum.pseudo_velocity, omega * spectrum.displacement)
    np.testing.assert_allclose(spectrum.pseudo_acceleration, omega**2 * spectrum.displacement)
    assert spectrum.period.values.tolist() == [0.2, 1.0] and spectrum.attrs["damping"] == 0.05
    units = {"displacement": "m", "pseudo_velocity": "m/s", "pseudo_acceleration": "m/s^2"}
    assert {name: spectrum[name].attrs["units"] for name in units} == units


@pytest.mark.parametrize(
    ("periods", "damping", "message"),
    [
        ([0.1, 0.0], 0.05, "periods[1] must be > 0 and finite, got 0 s"),
        ([[0.1]], 0.05, "periods must be a flat array, got shape (1, 1)"),
        ([], 0.05, "periods must be a flat array"),
        ([np.nan], 0.05, "periods[0] must be > 0 and finite, got nan s"),
        (["1 m"], 0.05, '"m" does not measure a time'),
        ([1e-9], 0.05, "a period of 1e-09 s needs more than 10000000 points"),
        ([0.1], 1.0, "damping must be between 0 and below 1, got 1"),
        ([0.1], -0.1, "damping must be between 0 and below 1, got -0.1"),
    ],
)
def test_what_is_no_oscillator_is_refused(periods, damping, message):
    with pytest.raises(rr.RimrollError) as refusal:
        rr.ground.sine(2.0, 0.5).response_spectrum(periods, damping)
    assert message in str(refusal.value)


@given(st.integers(0, 1000), st.integers(0, 359), st.sampled_from(["pga", "pgv", "sa"]))
@examples(40)
def test_intensities_of_two_components_do_not_depend_on_the_axes(
    seed: int, degrees: int, measure: str
) -> None:
    """Turning a record by whole degrees, over which RotD50 is a median, changes neither."""
    record = rr.ground.synthetic(seed, (1.0, 0.6, 0.3), duration=5.0)
    period = 0.7 if measure == "sa" else None
    for how, tolerance in (("vector", 2e-4), ("rotd50", 1e-3)):
        one, other = (
            ground.intensity(measure, how, period=period)
            for ground in (record, record.rotated(np.radians(degrees)))
        )
        assert other == pytest.approx(one, rel=tolerance)
    largest, median, mean = (
        record.intensity(measure, how, period=period) for how in ("vector", "rotd50", "geomean")
    )
    assert largest / math.sqrt(2.0) * (1.0 - 1e-3) <= median <= largest * (1.0 + 1e-3)
    assert mean <= largest * (1.0 + 1e-3)
    assert record.scaled(2.5).intensity(measure, "rotd50", period=period) == pytest.approx(
        2.5 * median
    )


def test_intensities_are_those_of_the_components_along_one_line() -> None:
    record = rr.ground.synthetic(3, 1.0, duration=5.0)
    spectrum = record.response_spectrum([0.7])["pseudo_acceleration"].values[0, 0]
    for measure, along, period in (
        ("pga", record.peak.x, None),
        ("pgv", record.peak_velocity.x, None),
        ("sa", spectrum, 0.7),
    ):
        assert record.intensity(measure, period=period) == pytest.approx(along, rel=1e-9)
        assert record.intensity(measure, "rotd50", period=period) == pytest.approx(
            along * np.median(np.abs(np.cos(np.radians(range(180))))), rel=1e-9
        )
        assert record.intensity(measure, "geomean", period=period) == 0.0
