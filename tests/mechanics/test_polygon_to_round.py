"""With many corners a polygon tends to the circle, and loses what the derived power says."""

import numpy as np
import pytest

import rimroll as rr

CAN = rr.bodies.can_2007()
LAWS = [rr.NoSlip(), rr.Frictionless()]


def with_corners(body, corners):
    return rr.PolygonalBody(
        corners,
        body.mass,
        body.radius,
        body.height,
        body.transverse_inertia,
        body.axial_inertia,
    )


def lost_power(body, law, tilt, yaw_rate, spin_rate):
    """n times the power that the impacts take, from the mobility of the contact."""
    sin, cos = np.sin(tilt), np.cos(tilt)
    rho, z = body.radius * cos - body.height * sin, body.radius * sin + body.height * cos
    rotation = np.array([[z * z, -z * rho], [-z * rho, rho * rho]]) / body.transverse_inertia
    mobility = np.eye(2) / body.mass + rotation
    u = -np.array([yaw_rate + spin_rate * cos, spin_rate * sin])
    along = law.name == "no_slip"
    losing = u @ np.linalg.solve(mobility, u) if along else u[1] ** 2 / mobility[1, 1]
    return np.pi * body.radius**2 * abs(spin_rate) * losing


@pytest.mark.parametrize("law", LAWS, ids=lambda law: law.name)
@pytest.mark.parametrize("tilt", [0.1, 0.4])
def test_a_wobble_loses_the_derived_power(law, tilt):
    yaw_rate = rr.steady_wobble_rate(CAN, tilt)
    slope = CAN.height / CAN.radius
    spin_rate = slope * yaw_rate * np.sin(tilt) - yaw_rate * np.cos(tilt)
    start = rr.State(tilt=tilt, yaw_rate=yaw_rate, spin_rate=spin_rate)
    corners, duration = 2048, 0.1
    motion = rr.simulate(with_corners(CAN, corners), start, law, duration)
    power = lost_power(CAN, law, tilt, yaw_rate, spin_rate)
    assert motion.impact_loss[-1] * corners == pytest.approx(duration * power, rel=0.01)
    assert motion.tilt == pytest.approx(tilt, abs=0.01 * tilt)
    assert motion.yaw[-1] == pytest.approx(yaw_rate * duration, rel=0.01)


@pytest.mark.parametrize("law", LAWS, ids=lambda law: law.name)
def test_turn_and_loss_converge_like_the_inverse_number_of_corners(law):
    start = {"tilt": np.pi / 6, "tilt_rate": -0.5, "yaw_rate": 0.3, "spin_rate": 0.3}
    limit = rr.simulate(CAN, rr.State(**start), law).turns[0].angle
    counts = np.array([128, 512, 2048])
    differences, losses = [], []
    for n in counts:
        spins = 2.0 * np.pi / n * np.arange(6) / 6
        body = with_corners(CAN, n)
        each = [rr.simulate(body, rr.State(**start, spin=spin), law, 0.7) for spin in spins]
        angles = np.array([abs(motion.turns[0].angle) for motion in each]) - limit
        differences.append(np.sqrt(np.mean(angles**2)))
        losses.append(np.mean([motion(motion.turns[0].end).impact_loss[0] for motion in each]))
    exponent = np.polyfit(np.log(counts), np.log(losses), 1)[0]
    assert exponent == pytest.approx(-1.0, abs=0.02)
    assert np.polyfit(np.log(counts), np.log(differences), 1)[0] < -0.9
    assert differences[-1] < np.radians(0.1)
