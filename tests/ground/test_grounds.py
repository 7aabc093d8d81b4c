"""Pulses, records and functions as motions of the ground: values, algebra, peaks, refusals."""

import doctest
import math
import pickle
import time
from importlib import import_module

import numpy as np
import pint
import pytest
from hypothesis import given
from hypothesis import strategies as st

import rimroll as rr
from given.strategies import examples

u = pint.UnitRegistry()
G = rr.STANDARD_GRAVITY
RECORD = rr.ground.sampled(0.1, [[0.0, 1.0, -2.0], [3.0, 1.0, 4.0], [-1.0, 0.5, 2.0]])
SINES = rr.ground.sine(amplitude=(3.0, 1.5, 2.0), period=(1.2, 0.8, 0.5), cycles=(1, 1, 2))
GROUNDS = {
    "sines": SINES,
    "cosine": rr.ground.cosine(2.0, 0.7, 2),
    "half a sine": rr.ground.half_sine((0.0, 2.0, 0.0), 0.4),
    "ricker": rr.ground.ricker(2.0, 0.5),
    "rectangular": rr.ground.rectangular((3.67875, 0.0, 0.0), duration=0.58),
    "record": RECORD,
    "sum": RECORD + SINES,
}

each_ground = pytest.mark.parametrize("ground", GROUNDS.values(), ids=GROUNDS)


@pytest.mark.parametrize(
    "module",
    [
        "ground",
        "ground.ground",
        "ground.pulses",
        "ground.columns",
    ],
)
def test_examples_in_the_docstrings_are_true(module):
    results = doctest.testmod(import_module(f"rimroll.{module}"))
    assert results.attempted > 0 and results.failed == 0


def test_pulses_are_what_their_formulas_say():
    t = np.linspace(0.0, 3.0, 601)[:-1] + 1e-9
    x = np.pi * (t - 1.0) / 0.5
    formulas = {
        "sines": (3.0 * np.sin(2 * np.pi * t / 1.2), 1.2),
        "cosine": (2.0 * np.cos(2 * np.pi * t / 0.7), 1.4),
        "ricker": (2.0 * (1 - 2 * x**2) * np.exp(-(x**2)), 2.0),
        "rectangular": (np.full_like(t, 3.67875), 0.58),
    }
    for name, (values, end) in formulas.items():
        expected = np.where(t < end, values, 0.0)
        np.testing.assert_allclose(GROUNDS[name](t)[:, 0], expected, atol=1e-13)
    half = np.where(t < 0.4, 2.0 * np.sin(np.pi * t / 0.4), 0.0)
    np.testing.assert_allclose(GROUNDS["half a sine"](t)[:, 1], half, atol=1e-13)
    assert GROUNDS["half a sine"].peak.x == 0.0


def test_components_have_their_own_periods_and_cycles():
    assert SINES.duration == 1.2
    np.testing.assert_allclose(SINES(0.1), [1.5, 1.5 / math.sqrt(2.0), 2 * np.sin(0.4 * np.pi)])
    assert SINES([0.9, 1.1])[:, 1:].tolist() == [[0.0, SINES(0.9)[2]], [0.0, 0.0]]


def test_a_ricker_wavelet_begins_and_ends_with_nothing():
    wavelet = rr.ground.ricker(2.0, 0.5)
    assert wavelet.duration == 2.0 and wavelet(1.0)[0] == 2.0
    assert abs(wavelet(0.0)[0]) < 1e-14 > abs(wavelet(2.0 - 1e-12)[0])
    assert wavelet.peak_velocity.x > 0.1
    assert abs(float(wavelet.to_xarray().velocity[-1, 0])) < 1e-12
    assert rr.ground.ricker(2.0, 0.5, center="300 ms")(0.3)[0] == 2.0


@pytest.mark.parametrize(
    ("one", "other"),
    [
        (rr.ground.sine("0.3 g", "400 ms"), rr.ground.sine(0.3 * u.standard_gravity, 0.4 * u.s)),
        (rr.ground.sine("0.3 g", 0.4), rr.ground.sine((0.3 * G, 0.0, 0.0), (0.4, 0.4, 0.4))),
        (rr.ground.sine(("0.3 g", 0, 0), 0.4), rr.ground.sine("294.1995 gal", 0.4)),
        (rr.ground.rectangular("50 cm/s^2", 1.0), rr.ground.rectangular(0.5, "1 s")),
        (
            rr.ground.sampled("20 ms", [1.0, 2.0] * u.cm / u.s**2),
            rr.ground.sampled(0.02, [[0.01, 0.0, 0.0], [0.02, 0.0, 0.0]]),
        ),
    ],
)
def test_units_are_converted(one, other):
    assert one == other and hash(one) == hash(other)


def test_times_have_any_shape_and_units():
    assert SINES(0.3).shape == (3,)
    assert SINES(np.zeros((2, 5))).shape == (2, 5, 3)
    assert SINES([]).shape == (0, 3)
    assert SINES([300.0, 600.0] * u.ms).tolist() == SINES([0.3, 0.6]).tolist()
    with pytest.raises(rr.RimrollError, match=r"^t\[1\] must be finite"):
        SINES([0.0, np.nan])


@each_ground
def test_a_ground_is_at_rest_outside_its_duration(ground):
    assert not ground([-1.0, -1e-9, ground.duration, 1e3]).any()


@each_ground
def test_grounds_are_compared_hashed_pickled_and_cannot_be_changed(ground):
    again = pickle.loads(pickle.dumps(ground))
    assert again == ground and hash(again) == hash(ground) and again is not ground
    assert ground != ground.scaled(1.5) and ground != ground.rotated(0.1) and ground != "ground"
    with pytest.raises(AttributeError):
        ground.heading = 1.0
    assert (
        repr(ground).startswith("<Ground of ") and "<td>velocity, m/s</td>" in ground._repr_html_()
    )


@each_ground
@given(factor=st.floats(0.01, 100.0), angle=st.floats(-7.0, 7.0), t=st.floats(0.0, 2.0))
@examples(40)
def test_scaling_and_turning_are_those_of_vectors(ground, factor, angle, t):
    x, y, z = ground(t)
    turned = [x * np.cos(angle) - y * np.sin(angle), x * np.sin(angle) + y * np.cos(angle), z]
    changed = ground.rotated(angle).scaled(factor)
    np.testing.assert_allclose(changed(t), factor * np.array(turned), atol=1e-12 * factor)
    assert changed.duration == ground.duration
    assert changed.peak.horizontal == pytest.approx(factor * ground.peak.horizontal, rel=1e-12)


def test_grounds_add_up():
    t = np.linspace(0.0, 1.3, 50)
    np.testing.assert_allclose((RECORD + SINES)(t), RECORD(t) + SINES(t), atol=1e-14)
    assert RECORD.scaled(2.0) == RECORD + RECORD
    with pytest.raises(rr.RimrollError, match="step must be that of the record it is added to"):
        _ = RECORD + rr.ground.sampled(0.2, np.zeros((3, 3)))
    with pytest.raises(rr.RimrollError, match="as many samples as the record it is added to, 3"):
        _ = RECORD + rr.ground.sampled(0.1, np.zeros((4, 3)))
    with pytest.raises(TypeError):
        _ = RECORD + 1.0


def test_north_turns_with_a_ground():
    north = rr.Ground(RECORD.core, 0.5)
    assert north.rotated("30 deg").heading == pytest.approx(0.5 + np.pi / 6)
    assert (north.scaled(2.0) + RECORD).heading == 0.5
    with pytest.raises(rr.RimrollError, match="same heading"):
        _ = north + north.rotated(0.1)


def test_a_record_is_a_line_between_samples():
    np.testing.assert_allclose(RECORD(0.025), [0.75, 1.0, -0.5])
    np.testing.assert_allclose(RECORD(0.15), [1.0, 0.75, 3.0])
    assert RECORD.duration == 0.2
    assert RECORD.peak == (3.0, 1.0, 4.0, math.hypot(3.0, 1.0))


@pytest.mark.parametrize(
    ("ground", "amplitude"),
    [
        (rr.ground.sine(3.0, 1.2), 3.0),
        (rr.ground.sine(3.0, 1.2, 0.2), 3.0 * np.sin(0.4 * np.pi)),
        (rr.ground.cosine(3.0, 1.2), 3.0),
        (rr.ground.half_sine(3.0, 0.7), 3.0),
        (rr.ground.rectangular(3.0, 0.7), 3.0),
        (rr.ground.ricker(3.0, 0.7), 3.0),
    ],
)
def test_the_peak_of_a_pulse_is_its_amplitude(ground, amplitude):
    assert ground.peak.x == ground.peak.horizontal == pytest.approx(amplitude, rel=1e-12)
    assert ground.rotated(0.5).peak.horizontal == pytest.approx(amplitude, rel=1e-12)


def test_peak_velocity_and_displacement_are_the_integrals():
    sine = rr.ground.sine(3.0, 1.2)
    assert sine.peak_velocity.x == pytest.approx(3.0 * 1.2 / np.pi, rel=5e-6)
    assert sine.peak_displacement.x == pytest.approx(3.0 * 1.2**2 / (2 * np.pi), rel=5e-6)
    block = rr.ground.rectangular(3.0, 0.5)
    assert block.peak_velocity.x == pytest.approx(1.5, rel=1e-12)
    assert block.peak_displacement.x == pytest.approx(0.375, rel=1e-12)
    assert RECORD.peak_velocity.x == pytest.approx(0.05 * (0.0 + 2 * 3.0 - 1.0), rel=1e-12)
    # The acceleration is 30 t until 0.1 s, and then 3 − 40 (t − 0.1).
    moved = 30 * 0.1**3 / 6 + 0.15 * 0.1 + 3.0 * 0.1**2 / 2 - 40 * 0.1**3 / 6
    assert RECORD.peak_displacement.x == pytest.approx(moved, rel=1e-12)


def by_quadrature(ground, t):
    """Velocity and displacement at t, (2, 3), by Gauss-Legendre quadrature between the corners."""
    corners = [*np.linspace(0.0, t, 41), *(0.1 * i for i in range(3)), 0.4, 0.58, 0.8, 1.0, 1.2]
    ends = np.unique([corner for corner in [*corners, ground.duration] if corner <= t])
    nodes, weights = np.polynomial.legendre.leggauss(8)
    half, middle = 0.5 * np.diff(ends)[:, None], 0.5 * (ends[1:] + ends[:-1])[:, None]
    at, share = (middle + half * nodes).ravel(), (half * weights).ravel()[:, None]
    values = share * ground(at)
    return np.array([values.sum(axis=0), (values * (t - at)[:, None]).sum(axis=0)])


@each_ground
def test_velocity_and_displacement_are_integrals_of_the_acceleration(ground):
    for t in (0.0, 0.03, 0.15, 0.2, 0.5, 0.93, 2.5):
        velocity, displacement = by_quadrature(ground, t)
        np.testing.assert_allclose(ground.velocity(t), velocity, atol=1e-12)
        np.testing.assert_allclose(ground.displacement(t), displacement, atol=1e-12)
    times = np.array([[-1.0, 0.0], [0.3, 2.5]])
    for integral in (ground.velocity, ground.displacement):
        assert integral(times).shape == (2, 2, 3) and integral([]).shape == (0, 3)
        assert not integral(times)[0].any()
        with pytest.raises(rr.RimrollError, match=r"^t\[1\] must be finite"):
            integral([0.0, np.inf])


def test_a_table_coasts_after_the_end_of_a_ground():
    block = rr.ground.rectangular(3.0, 0.5)
    np.testing.assert_allclose(block.velocity([0.5, 9.0])[:, 0], 1.5, rtol=1e-15)
    assert block.displacement(2.5)[0] == pytest.approx(0.375 + 1.5 * 2.0, rel=1e-14)


def test_a_baseline_that_is_off_makes_the_table_drift():
    wave = rr.ground.function(lambda t: math.sin(40.0 * t) + 0.2, 4.0, 0.01)
    assert wave.displacement(4.0)[0] > 1.5
    assert abs(wave.detrended().displacement(4.0)[0]) < 0.1


def test_a_detrended_record_has_no_line_in_it():
    t = np.arange(200) * 0.01
    drifting = rr.ground.sampled(0.01, np.sin(40.0 * t) + 0.3 + 0.2 * t)
    fits = [
        np.polyfit(t, ground.to_xarray().acceleration[:, 0], 1)
        for ground in (drifting, drifting.detrended())
    ]
    assert np.abs(fits[0]).max() > 0.1 and np.abs(fits[1]).max() < 1e-12
    with pytest.raises(rr.RimrollError, match="only a record"):
        SINES.detrended()


@given(step=st.floats(0.001, 0.2), period=st.floats(0.2, 3.0), duration=st.floats(0.5, 3.0))
@examples(40)
def test_a_sampled_function_is_within_its_bound(step, period, duration):
    def wave(t):
        return (0.0, 2.0 * np.sin(2 * np.pi * t / period), 0.0)

    ground = rr.ground.function(wave, duration, step)
    t = np.linspace(0.0, duration * (1 - 1e-9), 500)
    bound = step**2 / 8 * 2.0 * (2 * np.pi / period) ** 2
    assert np.abs(ground(t)[:, 1] - 2.0 * np.sin(2 * np.pi * t / period)).max() <= bound + 1e-12
    assert ground.duration == pytest.approx(duration, rel=1e-12)


def test_a_synthetic_record_is_that_of_its_seed_and_ends_almost_at_rest():
    ground = rr.ground.synthetic(7, amplitude=(3.0, 2.0, 1.0), duration=30)
    assert ground == rr.ground.synthetic(7, amplitude=(3.0, 2.0, 1.0), duration=30)
    assert ground != rr.ground.synthetic(8, amplitude=(3.0, 2.0, 1.0), duration=30)
    assert ground.peak[:3] == pytest.approx((3.0, 2.0, 1.0), rel=1e-12)
    assert abs(float(ground.to_xarray().velocity[-1, 0])) < 0.2 * ground.peak_velocity.x
    assert rr.ground.synthetic(7).peak[1:3] == (0.0, 0.0)


def test_synthetic_records_have_the_spectrum_of_kanai_tajimi_and_clough_penzien():
    count, period, damping = 2001, 0.5, 0.4
    power = np.zeros(2 * count + 1)
    for seed in range(150):
        ground = rr.ground.synthetic(
            seed, (0.0, 1.0, 2.0), soil_period=period, soil_damping=damping
        )
        found = np.abs(np.fft.rfft(ground.core.samples()[1][:, 1:].T, 4 * count)) ** 2
        power += (found / found.sum(axis=1, keepdims=True)).sum(axis=0)
    frequency = np.fft.rfftfreq(4 * count, 0.01)
    r, q = frequency * period, frequency * period / 0.1
    soil = (1.0 + 2j * damping * r) / (1.0 - r**2 + 2j * damping * r)
    expected = np.abs(soil * q**2 / (1.0 - q**2 + 1.2j * q)) ** 2
    # In bands, whose 300 periodograms have an error of a few per cent.
    edges = np.searchsorted(frequency, [0.1, 0.3, 0.6, 1.0, 1.4, 1.8, 2.2, 2.6, 3.2, 4.0, 6.0])
    ratio = np.add.reduceat(power, edges)[:-1] / np.add.reduceat(expected, edges)[:-1]
    np.testing.assert_allclose(ratio, ratio.mean(), rtol=0.1)


def test_a_dataset_has_each_time_once_with_units():
    dataset = (RECORD + rr.ground.rectangular(1.0, 0.15)).to_xarray()
    assert dataset.indexes["t"].is_unique
    assert dataset.acceleration.sel(t=0.15, component="x") == pytest.approx(1.0)
    assert dataset.acceleration.isel(t=-1).values.tolist() == pytest.approx([-1.0, 0.5, 2.0])
    assert [dataset[name].attrs["units"] for name in dataset] == ["m/s^2", "m/s", "m"]
    assert rr.Ground(RECORD.core, 0.5).to_xarray().attrs["heading"] == 0.5


@each_ground
def test_the_figure_has_a_line_for_each_component_that_moves(ground):
    figure = ground.plot()
    moving = [axis for axis, peak in zip("xyz", ground.peak[:3], strict=True) if peak]
    for ax in figure.axes:
        assert [line.get_label() for line in ax.lines] == moving
    assert figure.axes[0].get_xlim() == (0.0, ground.duration)


SHAPE = "acceleration must have the shape (n, 3), or (n,) for x alone, got "


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda g: g.sine(3.0, 0.0), "period must be > 0, got 0 s"),
        (lambda g: g.sine(3.0, (1.0, -1.0, 1.0)), "period[1] must be > 0, got -1 s"),
        (lambda g: g.sine((3.0, 1.0), 1.0), "amplitude must be one number or three (x, y, z)"),
        (lambda g: g.sine(np.nan, 1.0), "amplitude must be finite, got nan m/s^2"),
        (lambda g: g.sine(2e9, 1.0), "amplitude must be between -1e9 and 1e9"),
        (lambda g: g.sine("3 m", 1.0), '"m" does not measure an acceleration'),
        (lambda g: g.sine("3 zorks", 1.0), 'unknown unit "zorks"'),
        (lambda g: g.sine(3.0, "2 kg"), '"kg" does not measure a time'),
        (lambda g: g.sine(3.0, 1.0, cycles=0), "cycles must be > 0, got 0"),
        (
            (lambda g: (g.sine(3.0, 1.0, 1e6) + g.ricker(1.0, 1.0)).peak),
            "for at most 10000 periods",
        ),
        (lambda g: g.rectangular(3.0, -1.0), "duration must be > 0, got -1 s"),
        (lambda g: g.half_sine(3.0, np.inf), "duration must be finite, got inf s"),
        (lambda g: g.ricker(3.0, 1.0, center=-9.0), "duration must be > 0"),
        (lambda g: g.sampled(0.0, [1.0, 2.0]), "step must be > 0 and finite, got 0 s"),
        (lambda g: g.sampled(0.1, []), "acceleration must have at least 2 samples, got 0"),
        (lambda g: g.sampled(0.1, [[1, 2, 3]]), "acceleration must have at least 2 samples, got 1"),
        (lambda g: g.sampled(0.1, np.zeros((5, 2))), SHAPE + "(5, 2)"),
        (lambda g: g.sampled(0.1, np.zeros((3, 9))), SHAPE + "(3, 9): transpose it to (9, 3)"),
        (lambda g: g.sampled(0.1, 3.0), SHAPE + "()"),
        (lambda g: g.sampled(0.1, [1.0, np.nan]), "acceleration[1] must be between -1e9 and 1e9"),
        (lambda g: g.sampled(0.1, ["a", 1.0]), "acceleration[0] must be an acceleration such as"),
        (lambda g: g.sampled(0.1, [[1.0, 2.0], [1.0]]), "must be a number or an array of numbers"),
        (
            lambda g: g.sampled(0.1, np.broadcast_to(0.0, 10_000_001)),
            "acceleration must have at most 10000000 samples, got 10000001",
        ),
        (lambda g: g.function(lambda t: [1.0, 2.0], 1.0, 0.1), "f(0) must be a number, or three"),
        (
            lambda g: g.function(lambda t: 1.0 / (t - 0.5) if t != 0.5 else np.nan, 1.0, 0.5),
            "f(0.5)",
        ),
        (lambda g: g.function(lambda t: 1.0, 1.0, 1e-9), "duration/step must be below 10000000"),
        (lambda g: g.function(3.0, 1.0, 0.1), "f must be a function of the time, got 3"),
        (lambda g: g.synthetic(-1), "seed must be a whole number >= 0"),
        (lambda g: g.synthetic(1, -2.0), "amplitude must be between 0 and 1e9, got -2"),
        (lambda g: g.synthetic(1, step=1.0), "duration/step must be between 100 and 10000000"),
        (lambda g: RECORD.scaled(0.0), "factor must be > 0 and finite, got 0"),
        (lambda g: RECORD.scaled(-1.0), "factor must be > 0 and finite, got -1"),
        (lambda g: RECORD.scaled(1e7), "factor must be between 1e-6 and 1e6, got 10000000"),
        (lambda g: RECORD.rotated(np.inf), "angle must be finite"),
        (lambda g: RECORD.rotated("3 m"), '"m" does not measure an angle'),
    ],
)
def test_what_is_no_ground_is_refused_in_one_sentence(make, message):
    with pytest.raises(rr.RimrollError) as refusal:
        make(rr.ground)
    assert message in str(refusal.value) and "\n" not in str(refusal.value)


@pytest.mark.slow
def test_ten_million_samples_are_taken():
    samples = np.zeros(10_000_000)
    samples[-1] = 2.0
    ground = rr.ground.sampled(0.01, samples)
    assert ground.duration == pytest.approx(99999.99)
    assert ground(99999.985)[0] == pytest.approx(1.0)


@examples(200)
@given(
    st.sampled_from(["sine", "cosine", "half_sine", "ricker", "rectangular"]),
    st.floats(0.05, 3.0),
    st.floats(0.05, 2.0),
)
def test_the_peak_of_a_pulse_is_that_of_its_formula(kind, period, cycles):
    amplitude = (3.0, -1.0, 4.0)
    length = (cycles,) if kind in ("sine", "cosine") else ()
    pulse = getattr(rr.ground, kind)(amplitude, period, *length)
    values = pulse(np.linspace(0.0, pulse.duration, 5001)[:-1])
    expected = [*np.abs(values).max(axis=0), np.hypot(values[:, 0], values[:, 1]).max()]
    np.testing.assert_allclose(pulse.peak, expected, rtol=1e-3)
    assert np.all(np.asarray(pulse.peak) >= expected)


@pytest.mark.parametrize("cycles", [100, 10_001, 10_000_000])
def test_a_ground_of_any_length_is_shown_at_once(cycles):
    one = rr.ground.sine((3.0, 0.0, 4.0), 0.01, cycles)
    begun = time.process_time()
    assert repr(one) == f"<Ground of 1 pulse: {0.01 * cycles:.6g} s, peaks 3, 0, 4 m/s²>"
    sums = [one + rr.ground.ricker(2.0, 0.5), one + RECORD]
    texts = [repr(ground) + ground._repr_html_() for ground in (one, *sums)]
    assert all("peaks at most 5, " in text for text in texts[1:2])
    assert time.process_time() - begun < 2.0  # searching all cycles would take minutes
