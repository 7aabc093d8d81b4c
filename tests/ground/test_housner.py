"""Planar rocking against the solution by G. W. Housner, Bull. Seismol. Soc. Am. 53, 403 (1963).

For a slender body and small tilts, the planar motion about a point of the rim is linear:
φ̈ = p² (φ − α + a/g), with the balance tilt α = atan(R/H) and p² = m g √(R² + H²)/J. As α tends to
zero, with φ/α, a/(g α) and p t fixed, what it neglects is of relative order α².
"""

import numpy as np
import pytest

import rimroll as rr

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
