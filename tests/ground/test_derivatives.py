"""Derivatives of motions on a table that moves, against neighbouring motions and by hand."""

import math
import pickle
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

import rimroll as rr
from given.strategies import examples
from rimroll.motion.jacobian import PARAMETERS, QUANTITIES, SHAKEN_PARAMETERS

COLUMN = rr.Body(
    mass=1000.0,
    radius=0.5,
    height=2.0,
    transverse_inertia=1395.8333333333333,
    axial_inertia=125.0,
)
"""A solid cylinder of stone, 4 m high."""

GROUND = rr.ground.sine(amplitude=(3.0, 1.5, 2.0), period=(1.2, 0.8, 0.5), cycles=(1, 1, 2))
LEANING = rr.State(tilt=0.05, yaw=0.3)


def shaken(start=LEANING, *, body=COLUMN, scale=1.0, law=None, duration=1.5, **options):
    ground = GROUND.scaled(scale)
    options = {"rtol": 1e-12, "gravity": 9.81, "jacobian": True} | options
    return rr.simulate(body, start, law or rr.NoSlip(), duration, ground=ground, **options)


def slope(function, width):
    """A difference quotient of the fourth order."""
    near, far = ((function(h) - function(-h)) / (2.0 * h) for h in (width, 2.0 * width))
    return (4.0 * near - far) / 3.0


CHANGES = {
    "tilt": lambda by: {"start": replace(LEANING, tilt=LEANING.tilt + by)},
    "height": lambda by: {"body": replace(COLUMN, height=COLUMN.height + by)},
    "gravity": lambda by: {"gravity": 9.81 + by},
    "ground_scale": lambda by: {"scale": 1.0 + by},
}


@pytest.mark.parametrize("parameter", CHANGES)
def test_a_jacobian_is_the_difference_of_neighbouring_motions(parameter):
    """Differences over 2e-4 of motions that are right to 1e-12 have some eight digits."""
    t = np.array([0.3, 0.7, 1.4])
    jacobian = shaken().jacobian(t)
    assert jacobian.values.shape == (3, len(QUANTITIES), len(SHAKEN_PARAMETERS))
    assert jacobian.parameters == SHAKEN_PARAMETERS == (*PARAMETERS, "ground_scale")
    for quantity in QUANTITIES:

        def state(by, quantity=quantity):
            return getattr(shaken(**CHANGES[parameter](by), jacobian=False)(t), quantity)

        expected = slope(state, 1e-4)
        np.testing.assert_allclose(jacobian[quantity, parameter], expected, rtol=1e-6, atol=1e-6)


def test_a_jacobian_on_a_moving_table_names_the_scale():
    motion = shaken()
    dataset = motion.jacobian([0.1, 0.2]).to_xarray()
    assert dataset.parameter.values.tolist() == list(SHAKEN_PARAMETERS)
    assert dataset.sel(parameter="ground_scale").parameter_units == "1"
    assert "ground_scale" in repr(motion.jacobian(0.1))
    at_rest = rr.simulate(COLUMN, LEANING, rr.NoSlip(), 1.0, jacobian=True).jacobian(0.1)
    assert at_rest.parameters == PARAMETERS
    with pytest.raises(rr.RimrollError, match="unknown parameter 'ground_scale'"):
        at_rest["tilt", "ground_scale"]


def test_what_becomes_of_a_body_has_derivatives():
    start = rr.State.standing()
    motion = shaken(start)
    found = motion.outcome_jacobian
    names = ("max_tilt", "uplift_time", "residual_x", "residual_yaw")

    def outcome(by):
        other = shaken(start, scale=1.0 + by, jacobian=False)
        x, _ = other.footprint[-1] - other.footprint[0]
        turned = other.body_yaw[-1] - other.body_yaw[0]
        return np.array([other.max_tilt, other.uplift_time, x, turned])

    expected = slope(outcome, 1e-4)
    for name, value in zip(names, expected, strict=True):
        assert found[name]["ground_scale"] == pytest.approx(value, rel=1e-6, abs=1e-7)
        assert tuple(found[name]) == SHAKEN_PARAMETERS
        assert math.isnan(found[name]["tilt"])
    assert found["end_time"]["ground_scale"] == 0.0


@st.composite
def lifted(draw):
    """A body, a law, a ground whose direction turns and that lifts the body, and the yaw."""
    radius, slenderness = draw(st.floats(0.02, 0.6)), draw(st.floats(0.5, 6.0))
    height = radius * slenderness
    across = draw(st.floats(0.2, 1.5)) * (radius**2 / 4 + height**2 / 3)
    body = rr.Body(1.0, radius, height, across, draw(st.floats(0.1, 1.9)) * across)
    laws = [rr.NoSlip(), rr.InPlace(), rr.Coulomb(4.0), rr.Coulomb(1.2 / slenderness)]
    # It slides flat before it is lifted.
    laws += [rr.Viscous(draw(st.floats(1.0, 9.0)))]
    limit, time = 9.81 / slenderness, math.sqrt(height / 9.81)
    turned, sense = draw(st.floats(0.0, 6.0)), draw(st.sampled_from([-1, 1]))
    size, period = draw(st.floats(1.3, 3.0)) * limit, draw(st.floats(1.0, 6.0)) * time
    vertical = draw(st.floats(-0.2, 0.2)) * 9.81
    pulses = rr.ground.half_sine((size, 0.0, vertical), period)
    pulses += rr.ground.sine((0.0, sense * size, 0.0), draw(st.floats(0.7, 2.0)) * period)
    if draw(st.booleans()):
        t = np.linspace(0.0, pulses.duration, 60)
        samples = pulses(t) * np.minimum(1.0, (pulses.duration - t)[:, None] / t[1])
        pulses = rr.ground.sampled(t[1], samples)
    return body, draw(st.sampled_from(laws)), pulses.rotated(turned), draw(st.floats(-3.0, 3.0))


@examples(60, deadline=None)
@given(
    lifted(),
    st.sampled_from(["ground_scale", "gravity", "yaw", "radius", "height", "axial_inertia"]),
    st.sampled_from([1e-8, 1e-10, 1e-12]),
    st.floats(0.05, 1.0),
)
def test_a_body_that_a_turning_force_lifts_has_the_derivatives_of_its_neighbours(
    case, parameter, rtol, part
):
    body, law, ground, yaw = case
    size = {"yaw": 1.0, "gravity": 9.81, "ground_scale": 1.0}.get(parameter)
    size = size or getattr(body, parameter)

    def motion(by, duration, rtol=1e-12, jacobian=False):
        change = {parameter: (size * (1.0 + by))}
        moved = replace(body, **change) if hasattr(body, parameter) else body
        shaking = ground.scaled(change.get("ground_scale", 1.0))
        start = rr.State.standing(yaw=yaw + (by if parameter == "yaw" else 0.0))
        options = {"gravity": change.get("gravity", 9.81), "ground": shaking, "rtol": rtol}
        return rr.simulate(moved, start, law, duration, jacobian=jacobian, **options)

    lifted_at = motion(0.0, ground.duration, 1e-6).uplift_time
    assume(lifted_at is not None)
    t = lifted_at + part * math.sqrt(body.height / 9.81)
    found = motion(0.0, t + 1e-3, rtol, jacobian=True)
    kinds = {event.kind for event in found.events}
    assume(kinds <= {"uplift", "slip", "stick", "tilt_max"} and found.status == "finished")

    def state(by):
        at = motion(by, t + 1e-3)(t)
        return np.array([at.tilt, at.yaw])

    values = [float(found.jacobian(t)[name, parameter]) * size for name in ("tilt", "yaw")]
    np.testing.assert_allclose(values, slope(state, 1e-5), rtol=1e-5, atol=3e-5)


def test_a_sine_lifts_a_column_earlier_if_it_is_stronger():
    """A sin(2πt/T) = gR/H: s dt/ds = -tan(2πt/T) T/2π."""
    ground = rr.ground.sine(amplitude=4.0, period=1.2)
    options = {"gravity": 9.81, "ground": ground, "jacobian": True}
    motion = rr.simulate(COLUMN, rr.State.standing(), rr.NoSlip(), 0.6, **options)
    rate = 2.0 * math.pi / 1.2
    expected = -math.tan(rate * motion.uplift_time) / rate
    found = motion.outcome_jacobian["uplift_time"]
    assert found["ground_scale"] == pytest.approx(expected, abs=1e-13)
    assert found["radius"] * COLUMN.radius == pytest.approx(-expected, abs=1e-13)


def test_a_motion_that_topples_has_a_derivative_of_its_end():
    def ending(by):
        motion = shaken(scale=2.5 + by, duration=6.0, jacobian=False)
        assert motion.status == "toppled"
        return motion.overturning_time

    motion = shaken(scale=2.5, duration=6.0)
    found = motion.outcome_jacobian
    # The factor is that on the ground that was given, which is 2.5 times the other.
    expected = 2.5 * slope(ending, 1e-4)
    assert found["end_time"]["ground_scale"] == pytest.approx(expected, rel=1e-6)
    assert found["max_tilt"]["ground_scale"] == pytest.approx(0.0, abs=1e-12)


def test_pickles_keep_derivatives():
    motion = shaken()
    copy = pickle.loads(pickle.dumps(motion))
    assert np.array_equal(copy.jacobian(1.0).values, motion.jacobian(1.0).values)


def test_derivatives_that_there_are_not_are_refused():
    planar = {"ground": rr.ground.sine(amplitude=3.0, period=1.2), "flat": "smooth"}
    with pytest.raises(rr.RimrollError, match="comes down flat and smoothly under friction"):
        rr.simulate(COLUMN, rr.State(tilt=0.05), rr.Coulomb(2.0), 2.0, jacobian=True, **planar)
    at_rest = rr.simulate(COLUMN, LEANING, rr.NoSlip(), 1.0, jacobian=True)
    with pytest.raises(rr.RimrollError, match="on a table at rest"):
        _ = at_rest.outcome_jacobian
    with pytest.raises(rr.RimrollError, match="jacobian=True"):
        _ = shaken(jacobian=False).outcome_jacobian
