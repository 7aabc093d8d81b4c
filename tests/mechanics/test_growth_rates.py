"""Growth rates from the derivatives of motions, against closed forms and linearised laws."""

import numpy as np
import pytest

import rimroll as rr
from given.motions import CAN, DISK

G = rr.STANDARD_GRAVITY
M, R = DISK.mass, DISK.radius
A, C = DISK.transverse_inertia, DISK.axial_inertia
ROLLING = np.sqrt(A * M * G * R / (C * (C - A)))
SPINNING = np.sqrt(M * G * R / A)


def rolls(spin):
    return rr.State(tilt=np.pi / 2, spin_rate=spin)


def spins(yaw_rate):
    return rr.State(tilt=np.pi / 2, yaw_rate=yaw_rate)


def of_rolling(spin, c):
    """Newton and Euler for (δ, δ̇, v_x) of an upright rolling disk, w = C s δ/A, T = −c u."""
    return np.array(
        [
            [0.0, 1.0, 0.0],
            [(M * G * R - (C * spin) ** 2 / A) / A, -c * R**2 / A, -c * R / A],
            [R * C * spin**2 / A, -c * R / M, -c / M],
        ]
    )


def of_spinning(rate, c):
    """The matrix for (δ, δ̇, s, v_x, v_y) of a disk that spins about its vertical diameter."""
    return np.array(
        [
            [0.0, 1.0, 0.0, 0.0, 0.0],
            [M * G * R / A - rate**2, -c * R**2 / A, -C * rate / A, -c * R / A, 0.0],
            [0.0, 0.0, -c * R**2 / C, 0.0, c * R / C],
            [0.0, -c * R / M, 0.0, -c / M, rate],
            [0.0, 0.0, c * R / M, -rate, -c / M],
        ]
    )


def assert_among(expected, found, tolerance):
    for rate in expected:
        assert np.abs(found - rate).min() < tolerance, (rate, found)


@pytest.mark.parametrize("law", [rr.NoSlip(), rr.Frictionless()], ids=lambda law: law.name)
@pytest.mark.parametrize("body", [CAN, DISK], ids=["can", "disk"])
def test_growth_and_nutation_are_those_of_steady_motions(law, body):
    for tilt in 0.3, 1.2:
        for motion in rr.steady_motions(body, law, tilt, axial_spin=6.0):
            found = rr.growth_rates(body, motion.start, law)
            root = np.sqrt(complex(-motion.nutation_squared))
            assert_among([root, -root], found, 2e-4 * abs(root))
            assert found[0].real == pytest.approx(motion.growth_rate, abs=1e-3 * abs(root))


def test_dry_friction_that_holds_the_rim_changes_no_growth_rate():
    for factor in 0.99, 1.01:
        start = spins(factor * rr.critical_spinning_rate(DISK))
        held, rolling = (
            rr.growth_rates(DISK, start, law) for law in (rr.Coulomb(0.3), rr.NoSlip())
        )
        np.testing.assert_allclose(held, rolling, atol=1e-4)
        assert (held[0].real > 0.5) == (factor < 1.0)


@pytest.mark.parametrize("viscosity", [2.0, 5.0, 20.0])
def test_growth_rates_under_sliding_friction_are_those_of_the_linearised_laws(viscosity):
    for factor in 0.6, 0.9, 1.2:
        for start, generator in [
            (rolls(factor * ROLLING), of_rolling(factor * ROLLING, viscosity)),
            (spins(factor * SPINNING), of_spinning(factor * SPINNING, viscosity)),
        ]:
            found = rr.growth_rates(DISK, start, rr.Viscous(viscosity))
            exact = np.linalg.eigvals(generator)
            assert_among(exact[exact.real > -0.1 * ROLLING], found, 2e-3 * ROLLING)


@pytest.mark.parametrize("viscosity", [1.0, 5.0, 20.0])
def test_a_sliding_disk_rolls_stably_above_its_own_threshold_whatever_the_friction(viscosity):
    """s² = A m g R/(C (C − A)): six times as large as without slip for a uniform disk."""
    assert rr.critical_rolling_spin(DISK) ** 2 == pytest.approx(ROLLING**2 / 6.0)
    for factor in 0.99, 1.01:
        found = rr.growth_rates(DISK, rolls(factor * ROLLING), rr.Viscous(viscosity))
        (nutation,) = [rate for rate in found if rate.imag > 1.0]
        assert (nutation.real > 0.01) == (factor < 1.0)
        assert (nutation.real < -0.01) == (factor > 1.0)


def test_a_sliding_disk_that_spins_falls_below_the_threshold_without_friction():
    """ψ̇² = m g R/A, and not the m g R/(A + mR²) without slip."""
    for viscosity in 1.0, 5.0:
        for factor in 0.99, 1.01:
            found = rr.growth_rates(DISK, spins(factor * SPINNING), rr.Viscous(viscosity))
            assert (found[0].real > 0.1) == (factor < 1.0)
    between = 2.0 * rr.critical_spinning_rate(DISK)
    assert rr.growth_rates(DISK, spins(between), rr.NoSlip())[0].real < 1e-3
    assert rr.growth_rates(DISK, spins(between), rr.Viscous(5.0))[0].real > 1.0


def test_a_disturbance_grows_as_the_rates_say():
    """A whole motion, slid from a small lean."""
    rate = rr.growth_rates(DISK, spins(10.0), rr.Viscous(5.0))[0].real
    start = rr.State(tilt=np.pi / 2 - 1e-8, yaw_rate=10.0)
    motion = rr.simulate(DISK, start, rr.Viscous(5.0), 12.0 / rate, rtol=1e-12)
    lean = np.abs(motion.evaluate([8.0 / rate, 11.0 / rate]).tilt - np.pi / 2)
    assert np.log(lean[1] / lean[0]) == pytest.approx(3.0, rel=1e-3)


def test_what_is_refused():
    for name in ("gravity", "duration"):
        for wrong in (0.0, -1.0, np.nan):
            with pytest.raises(rr.RimrollError, match=name):
                rr.growth_rates(CAN, rr.State(tilt=0.5, yaw_rate=1.0), rr.NoSlip(), **{name: wrong})
    with pytest.raises(rr.RimrollError, match="the motion is not steady"):
        rr.growth_rates(CAN, rr.State(tilt=0.5, yaw_rate=1.0), rr.NoSlip())
