"""Planar rocking against the solution by G. W. Housner, Bull. Seismol. Soc. Am. 53, 403 (1963).

For a slender body and small tilts, the planar motion about a point of the rim is linear:
φ̈ = p² (φ − α + a/g), with the balance tilt α = atan(R/H) and p² = m g √(R² + H²)/J. As α tends to
zero, with φ/α, a/(g α) and p t fixed, what it neglects is of relative order α².
"""

import numpy as np
import pytest

import rimroll as rr
from oracles.planar_rocking import PlanarRocking

GRAVITY = 9.81
STRENGTH = 1.8
"""The largest acceleration over that which lifts the body, g tan α."""
SLENDERNESS = np.array([0.16, 0.08, 0.04, 0.02])


def column(alpha):
    """A solid cylinder that is 4 m high."""
    radius, height, mass = 2.0 * np.tan(alpha), 2.0, 1000.0
    return rr.Body(
        mass=mass,
        radius=radius,
        height=height,
        transverse_inertia=mass * (radius**2 / 4 + height**2 / 3),
        axial_inertia=mass * radius**2 / 2,
    )


def frequency(body):
    """p, rad/s."""
    arm = np.hypot(body.radius, body.height)
    return np.sqrt(body.mass * GRAVITY * arm / (body.transverse_inertia + body.mass * arm**2))


def freely(time, tilt, rate):
    """φ/α and its rate by p t without acceleration, after a time (p t) from a state."""
    cosh, sinh = np.cosh(time), np.sinh(time)
    return 1 + (tilt - 1) * cosh + rate * sinh, (tilt - 1) * sinh + rate * cosh


class Rectangular:
    """A constant acceleration for p t < 1.2."""

    end = 1.2

    @staticmethod
    def ground(amplitude, p):
        return rr.ground.rectangular(amplitude, Rectangular.end / p)

    @staticmethod
    def during(time):
        """φ/α and its rate."""
        return (STRENGTH - 1) * (np.cosh(time) - 1), (STRENGTH - 1) * np.sinh(time)


class HalfSine:
    """Half a sine of the angular frequency 1.6 p."""

    frequency = 1.6
    end = np.pi / frequency

    @staticmethod
    def ground(amplitude, p):
        return rr.ground.half_sine(amplitude, HalfSine.end / p)

    @staticmethod
    def during(time):
        """It lifts where the acceleration is g α, and is at rest until then."""
        w = HalfSine.frequency
        lift = np.arcsin(1 / STRENGTH) / w
        forced = -STRENGTH / (1 + w**2)
        # 1 + forced sin(w t) + of_cosh cosh + of_sinh sinh, with tilt and rate 0 at the lift.
        of_cosh = -1 - forced * np.sin(w * lift)
        of_sinh = -forced * w * np.cos(w * lift)
        later = np.maximum(time - lift, 0.0)
        cosh, sinh = np.cosh(later), np.sinh(later)
        tilt = 1 + forced * np.sin(w * (lift + later)) + of_cosh * cosh + of_sinh * sinh
        rate = forced * w * np.cos(w * (lift + later)) + of_cosh * sinh + of_sinh * cosh
        return tilt, rate


@pytest.mark.parametrize("law", [rr.NoSlip(), rr.InPlace(), rr.Coulomb(0.9)], ids=repr)
@pytest.mark.parametrize("pulse", [Rectangular, HalfSine])
def test_slender_columns_rock_as_housner_says(pulse, law):
    time = np.linspace(0.05, 2.2, 44)
    at_end = pulse.during(pulse.end)
    after = freely(np.maximum(time - pulse.end, 0.0), *at_end)
    expected = np.where(time < pulse.end, pulse.during(time), after)
    assert expected[0].max() > 0.3 and (expected[0, 10:] > 0.0).all()

    def error(alpha):
        body = column(alpha)
        p = frequency(body)
        amplitude = STRENGTH * GRAVITY * np.tan(alpha)
        ground = pulse.ground((0.6 * amplitude, 0.8 * amplitude, 0.0), p)
        motion = rr.simulate(
            body, rr.State.standing(), law, 2.3 / p, gravity=GRAVITY, rtol=1e-12, ground=ground
        )
        found = motion.evaluate(time / p)
        assert motion.status == "finished"
        assert motion.uplift_time is not None
        return max(
            np.abs(found.tilt / alpha - expected[0]).max(),
            np.abs(found.tilt_rate / (p * alpha) - expected[1]).max(),
        )

    errors = np.array([error(alpha) for alpha in SLENDERNESS])
    assert (errors < 3 * SLENDERNESS**2).all()
    # Half the slenderness has a quarter of the error, but for terms of order α⁴.
    assert errors[:-1] / errors[1:] == pytest.approx(4.0, abs=0.3)
    assert errors[-2] / errors[-1] == pytest.approx(4.0, abs=0.02)


STEP = 0.01
"""Between the samples of a record, s."""

LAWS = [
    rr.NoSlip(),
    rr.Frictionless(),
    rr.InPlace(),
    rr.Coulomb(0.9, restitution=0.3),
    rr.Coulomb(0.2),
    rr.Stribeck(0.15, static=0.25, stribeck_speed=0.1),
    rr.Viscous(2000.0),
    rr.Tabulated(speeds=(0.0, 0.1, 1.0), frictions=(0.3, 0.25, 0.2)),
]


def along_a_line(rng, weakest, samples=400):
    """Random samples of an acceleration (m/s2) that exceeds `weakest` at times."""
    t = STEP * np.arange(samples)
    waves = [
        rng.normal() * np.sin(2 * np.pi * f * t + rng.uniform(0, 6))
        for f in rng.uniform(0.3, 5, 12)
    ]
    shape = np.sum(waves, axis=0)
    return rng.uniform(1.3, 2.2) * weakest / np.abs(shape).max() * shape


def record(acceleration, heading, vertical=0.0):
    none = np.zeros_like(acceleration)
    samples = np.stack([acceleration, none, vertical * acceleration], axis=-1)
    return rr.ground.sampled(STEP, samples).rotated(heading)


@pytest.mark.parametrize("gap", [0.0, 1e-4, 0.01])
@pytest.mark.parametrize("seed", range(3))
def test_planar_rocking_is_that_of_an_independent_integration(seed, gap):
    rng = np.random.default_rng(seed)
    body = column(rng.uniform(0.12, 0.45))
    tilt = 0.04 if seed == 2 else 0.0
    acceleration = along_a_line(rng, GRAVITY * body.radius / body.height)
    heading = rng.uniform(-3, 3)
    oracle = PlanarRocking(body, GRAVITY, gap)
    expected, _ = oracle.impacts(acceleration.tolist(), STEP, tilt)
    twin, _ = oracle.impacts((acceleration * (1 + 1e-12)).tolist(), STEP, tilt)
    common = min(len(expected), len(twin))
    separation = np.abs(np.subtract(expected[:common], twin[:common]))
    # Beyond, two motions that differ by rounding have separated.
    count = int((np.maximum.accumulate(separation) < 1e-10).sum())
    assert count >= 5
    motion = rr.simulate(
        body,
        rr.State(tilt=tilt, yaw=heading) if tilt else rr.State.standing(),
        rr.NoSlip(),
        STEP * (len(acceleration) - 1),
        gravity=GRAVITY,
        rtol=1e-13,
        ground=record(acceleration, heading),
        flat="housner",
        flat_gap=gap,
    )
    times = [event.t for event in motion.events if event.kind == "face_down"]
    assert times[:count] == pytest.approx(expected[:count], rel=0, abs=1e-9)


@pytest.mark.parametrize("law", LAWS, ids=repr)
def test_motions_in_a_plane_stay_in_it_whatever_the_heading(law):
    rng = np.random.default_rng(5)
    body = column(rng.uniform(0.15, 0.4))
    acceleration = along_a_line(rng, GRAVITY * body.radius / body.height, samples=200)
    headings = [0.0, np.pi / 6, -2.2]
    grounds = [record(acceleration, heading, 0.3) for heading in headings]
    for tilt, flat in [(0.0, "housner"), (0.05, 0.9)]:
        starts = [
            rr.State(tilt=tilt, yaw=heading) if tilt else rr.State.standing()
            for heading in headings
        ]
        motions = [
            rr.simulate(body, start, law, 2.5, ground=ground, flat=flat, rtol=1e-11)
            for start, ground in zip(starts, grounds, strict=True)
        ]
        for motion, heading in zip(motions, headings, strict=True):
            assert motion.status == motions[0].status
            assert (motion.yaw_rate == 0.0).all() and (motion.spin_rate == 0.0).all()
            assert motion.max_tilt == pytest.approx(motions[0].max_tilt, rel=1e-7, abs=1e-12)
            x, y = motion["x"], motion["y"]
            across = (y - y[0]) * np.cos(heading) - (x - x[0]) * np.sin(heading)
            assert np.abs(across).max() < 1e-13 * (1 + np.hypot(x, y).max())
        for start, ground, motion in zip(starts, grounds, motions, strict=True):
            shaken = rr.shake_many(
                body, start, law, [ground] * 5, duration=2.5, flat=flat, rtol=1e-11
            )
            assert (shaken.max_tilt == shaken.max_tilt[0]).all()
            assert shaken.max_tilt[0] == pytest.approx(motion.max_tilt, rel=1e-12)
            assert np.abs(shaken.end_yaw).max() < 1e-12
