"""Steady motions and their stability, against the paper's printed equations and whole motions."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

import rimroll as rr
from given.motions import CAN, DISK, by_law
from given.strategies import bodies, disks, few
from oracles.paper_equations import angular_accelerations

GRAVITY = 9.81
HOOP = rr.Body(1.0, 0.3, 0.0, 0.045, 0.09)


def printed_accelerations(motion, tilt, rates):
    """(ψ̈, φ̈, θ̈) by the printed equations, for (ψ̇, φ̇, θ̇)."""
    yaw_rate, tilt_rate, spin_rate = rates
    return angular_accelerations(
        motion.body, motion.law.name, tilt, yaw_rate, tilt_rate, spin_rate, motion.gravity
    )


def eigenvalues(motion):
    """Eigenvalues of the printed equations, linearised about a steady motion by differences."""

    def rate(u):
        return np.array([u[2], *printed_accelerations(motion, u[0], u[1:])])

    at = np.array([motion.tilt, motion.yaw_rate, 0.0, motion.spin_rate])
    scale = max(1.0, abs(motion.yaw_rate), abs(motion.spin_rate))
    steps = 1e-6 * np.array([motion.tilt, scale, scale, scale])
    columns = [
        (rate(at + d) - rate(at - d)) / (2 * h) for d, h in zip(np.diag(steps), steps, strict=True)
    ]
    return np.linalg.eigvals(np.column_stack(columns))


@by_law
@few
@given(body=bodies(), part=st.floats(0.05, 0.95), spin=st.floats(-30.0, 30.0))
def test_steady_motions_solve_the_printed_equations_and_have_their_eigenvalues(
    law, body, part, spin
):
    for motion in rr.steady_motions(body, law, part * np.pi / 2, axial_spin=spin, gravity=GRAVITY):
        assume(abs(motion.yaw_rate) < 1e4)
        rates = (motion.yaw_rate, 0.0, motion.spin_rate)
        accelerations = printed_accelerations(motion, motion.tilt, rates)
        scale = GRAVITY / body.radius + motion.yaw_rate**2 + spin**2
        np.testing.assert_allclose(accelerations, 0.0, atol=1e-11 * scale)
        # Two eigenvalues vanish: the neighbouring steady motions. The others are ± a root.
        square = max((np.square(eigenvalues(motion))), key=abs).real
        # Rounding leaves 1e-16/1e-6 of the scale in a difference, and roots of it in an eigenvalue.
        assert -motion.nutation_squared == pytest.approx(square, rel=1e-4, abs=1e-4 * scale)


@by_law
@few
@given(body=bodies(), part=st.floats(0.1, 0.9), spin=st.floats(1.0, 30.0))
def test_either_rate_leads_to_the_other(law, body, part, spin):
    tilt = part * np.pi / 2
    for motion in rr.steady_motions(body, law, tilt, axial_spin=spin):
        assume(1e-3 < abs(motion.yaw_rate) < 1e4)
        (same,) = rr.steady_motions(body, law, tilt, yaw_rate=motion.yaw_rate)
        # The axial spin is a difference of terms that may be larger than it.
        size = abs(spin) + abs(motion.yaw_rate)
        size += rr.STANDARD_GRAVITY / body.radius / abs(motion.yaw_rate)
        assert same.axial_spin == pytest.approx(spin, abs=1e-9 * size)
        (again,) = rr.steady_motions(
            body, law, tilt, yaw_rate=motion.yaw_rate, axial_spin=motion.axial_spin
        )
        assert (again.yaw_rate, again.axial_spin) == (motion.yaw_rate, motion.axial_spin)


@by_law
@few
@given(body=bodies(), tilt=st.floats(0.1, 3.0))
def test_the_steady_wobble_is_one_of_them(law, body, tilt):
    A, C, R, H = body.transverse_inertia, body.axial_inertia, body.radius, body.height
    rho = R * np.cos(tilt) - H * np.sin(tilt)
    stiffness = np.cos(tilt) - C * H / (A * R) * np.sin(tilt)
    assume(rho / R * stiffness > 0.0 and abs(stiffness) > 0.1)
    rate = rr.steady_wobble_rate(body, tilt)
    spin = H * rate * np.sin(tilt) / R
    (wobble,) = rr.steady_motions(body, law, tilt, yaw_rate=rate, axial_spin=spin)
    assert wobble.friction == pytest.approx(0.0, abs=1e-12 * rate**2 * R / rr.STANDARD_GRAVITY)
    assert wobble.path_radius == pytest.approx(abs(rho), abs=1e-12 * R)


@pytest.mark.parametrize(
    ("body", "expected"), [(CAN, 1.27008), (DISK, np.sqrt(3 / 5))], ids=["can", "disk"]
)
def test_nutation_at_vanishing_tilt(body, expected):
    assert rr.nutation_ratio(body, rr.NoSlip()) == pytest.approx(expected, rel=4e-6)


@by_law
@few
@given(body=bodies())
def test_the_nutation_of_a_wobble_tends_to_its_ratio(law, body):
    tilt = 1e-7
    rate = rr.steady_wobble_rate(body, tilt)
    spin = body.height * rate * np.sin(tilt) / body.radius
    (wobble,) = rr.steady_motions(body, law, tilt, yaw_rate=rate, axial_spin=spin)
    # The relative error is of the order of the tilt, times ratios of lengths and inertias.
    ratio = wobble.nutation_rate / rate
    assert ratio == pytest.approx(rr.nutation_ratio(body, law), rel=1e-3)


@pytest.mark.parametrize(("disk", "square"), [(DISK, 1 / 3), (HOOP, 1 / 4)], ids=["disk", "hoop"])
def test_critical_spin_of_rolling_disks(disk, square):
    spin = rr.critical_rolling_spin(disk, GRAVITY)
    assert spin**2 == pytest.approx(square * GRAVITY / disk.radius, rel=1e-14)


def test_critical_rate_of_a_spinning_disk():
    rate = rr.critical_spinning_rate(DISK, GRAVITY)
    assert rate**2 == pytest.approx(0.8 * GRAVITY / DISK.radius, rel=1e-14)


def upright(disk, **rates):
    (motion,) = rr.steady_motions(disk, rr.NoSlip(), np.pi / 2, **rates)
    return motion


@few
@given(disk=disks())
def test_upright_disks_are_stable_above_their_critical_rates_only(disk):
    spin, rate = rr.critical_rolling_spin(disk), rr.critical_spinning_rate(disk)
    for factor in 0.99, 1.01:
        rolling = upright(disk, yaw_rate=0.0, axial_spin=factor * spin)
        spinning = upright(disk, yaw_rate=factor * rate)
        assert rolling.is_stable == spinning.is_stable == (factor > 1.0)
        # ω² is a difference of m g R/J and the same multiplied by the square of the factor.
        J = disk.transverse_inertia + disk.mass * disk.radius**2
        weight = disk.mass * rr.STANDARD_GRAVITY * disk.radius / J
        for motion in rolling, spinning:
            expected = (factor**2 - 1.0) * weight
            assert motion.nutation_squared == pytest.approx(expected, abs=1e-11 * weight)


@pytest.mark.parametrize("kind", ["rolling", "spinning"])
def test_a_disturbed_upright_disk_leaves_below_the_critical_rate_and_not_above(kind):
    """1 % below and above; linear theory with the first acceleration by the printed equations."""
    for factor in 0.99, 1.01:
        if kind == "rolling":
            motion = upright(DISK, yaw_rate=0.0, axial_spin=factor * rr.critical_rolling_spin(DISK))
        else:
            motion = upright(DISK, yaw_rate=factor * rr.critical_spinning_rate(DISK))
        size = 1e-9
        start = disturbed(motion, size)
        rates = (start.yaw_rate, 0.0, start.spin_rate)
        first = abs(printed_accelerations(motion, start.tilt, rates)[1])
        square = motion.nutation_squared
        duration = 8.0 / np.sqrt(abs(square))
        moved = rr.simulate(DISK, start, rr.NoSlip(), duration, rtol=1e-12)
        largest = np.abs(moved.tilt - np.pi / 2).max()
        if motion.is_stable:
            assert largest < 1.1 * (size + 2.0 * first / square)
        else:
            # cosh 8 = 1490
            assert largest == pytest.approx(first / -square * (np.cosh(8.0) - 1.0), rel=0.05)


def disturbed(motion, size):
    """The start of a steady motion, at a tilt that is larger by ``size``."""
    return replace(motion.start, tilt=motion.tilt + size)


@by_law
@few
@given(body=bodies(), part=st.floats(0.2, 0.8), spin=st.floats(-20.0, 20.0))
def test_a_disturbed_steady_motion_nutates_with_its_rate_or_leaves(law, body, part, spin):
    for motion in rr.steady_motions(body, law, part * np.pi / 2, axial_spin=spin):
        frequency = np.sqrt(abs(motion.nutation_squared))
        assume(abs(motion.yaw_rate) < 20 * frequency and abs(spin) < 20 * frequency)
        size = 1e-6
        start = disturbed(motion, size)
        rates = (start.yaw_rate, 0.0, start.spin_rate)
        first = abs(printed_accelerations(motion, start.tilt, rates)[1])
        assume(first > 0.1 * size * frequency**2)
        assume(first < 1e3 * size * frequency**2)
        duration = (4.5 * np.pi if motion.is_stable else 5.0) / frequency
        topple_tilt = motion.tilt + 0.1
        moved = rr.simulate(body, start, law, duration, rtol=1e-12, topple_tilt=topple_tilt)
        assume(moved.status != "lifted_off")
        if motion.is_stable:
            times = [event.t for event in moved.events if event.kind == "tilt_max"]
            period = np.diff(times).mean()
            # The frequency changes by the order of the disturbance, times ratios of inertias.
            assert period == pytest.approx(2 * np.pi / frequency, rel=5e-3)
        else:
            grown = first / frequency**2 * (np.cosh(5.0) - 1.0)
            assert np.abs(moved.tilt - motion.tilt).max() == pytest.approx(grown, rel=0.2)


def test_the_contact_point_of_a_steady_motion_runs_on_its_circle():
    for motion in rr.steady_motions(CAN, rr.NoSlip(), 0.3, axial_spin=5.0):
        moved = rr.simulate(CAN, motion.start, rr.NoSlip(), 2.0, rtol=1e-12)
        np.testing.assert_allclose(moved.tilt, 0.3, rtol=1e-9)
        path = moved.contact_path[:, :2]
        center = np.linalg.lstsq(
            np.column_stack([2 * path, np.ones(len(path))]), (path**2).sum(axis=1), rcond=None
        )[0]
        radius = np.sqrt(center[2] + (center[:2] ** 2).sum())
        assert radius == pytest.approx(motion.path_radius, rel=1e-8)
        np.testing.assert_allclose(moved.friction_ratio, motion.friction, rtol=1e-8)


@few
@given(body=bodies(), part=st.floats(0.05, 0.95))
def test_a_body_that_spins_about_the_vertical_keeps_its_tilt(body, part):
    tilt = part * np.pi / 2
    try:
        rate = rr.spinning_rate(body, tilt)
    except rr.RimrollError:
        excess = body.transverse_inertia - body.axial_inertia
        rho = body.radius * np.cos(tilt) - body.height * np.sin(tilt)
        assert excess * rho <= 0.0
        return
    spin = rate * np.cos(tilt)
    (motion,) = rr.steady_motions(body, rr.Frictionless(), tilt, yaw_rate=rate, axial_spin=spin)
    assert motion.spin_rate == pytest.approx(0.0, abs=1e-12 * rate)


def test_a_cylinder_changes_its_kind_of_spinning_where_its_inertias_are_equal():
    for length, below in (0.99 * np.sqrt(3), False), (1.01 * np.sqrt(3), True):
        body = rr.Body.from_solids(1.0, [rr.solids.cylinder(1.0, 1.0, length)])
        balance = rr.balance_tilt(body)
        for tilt, exists in ((0.9 * balance, below), (1.1 * balance, not below)):
            if exists:
                assert rr.spinning_rate(body, tilt) > 0.0
            else:
                with pytest.raises(rr.RimrollError, match="spin about the vertical"):
                    rr.spinning_rate(body, tilt)


def test_what_is_refused():
    with pytest.raises(rr.RimrollError, match="give yaw_rate, axial_spin or both"):
        rr.steady_motions(CAN, rr.NoSlip(), 0.3)
    with pytest.raises(rr.RimrollError, match=r"tilt must be inside \(0, pi\), got 0"):
        rr.steady_motions(CAN, rr.NoSlip(), 0.0, yaw_rate=1.0)
    with pytest.raises(rr.RimrollError, match="NoSlip or Frictionless"):
        rr.steady_motions(CAN, rr.Coulomb(0.3), 0.3, yaw_rate=1.0)
    with pytest.raises(rr.RimrollError, match=r"without thickness, as from disk\(radius\)"):
        rr.critical_rolling_spin(CAN)
    assert rr.steady_motions(CAN, rr.NoSlip(), 0.3, yaw_rate=1.0, axial_spin=100.0) == ()
