"""What an ideal gyroscope sees, against differences of the rotation and against Newton and Euler.

The rotation is composed here from three turns (yaw about z, −tilt about y, spin about z); the
oracle ``rigid_body.py`` follows a quaternion and the angular velocity in space.
"""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import rimroll as rr
from oracles import rigid_body as rb

CAN = rr.bodies.can_2007()
START = rr.State(tilt=0.5, tilt_rate=-0.5, yaw_rate=0.6, spin_rate=-0.3)


def attitude(motion, t):
    """The rotation from the body to the inertial frame."""
    state = motion(t)
    return Rotation.from_euler("ZYZ", np.stack([state.yaw, -state.tilt, state.spin], axis=-1))


@pytest.mark.parametrize("law", [rr.NoSlip(), rr.Frictionless(), rr.Coulomb(0.2)])
def test_body_angular_velocity_is_the_rate_of_the_rotation(law):
    motion = rr.simulate(CAN, START, law, duration=0.6, rtol=1e-12)
    # Between the changes of contact, at which friction has corners.
    edges = [edge for phase in motion.phases for edge in (phase.start, phase.end)]
    t = np.linspace(0.01, float(motion.t[-1]) - 0.01, 400)
    t = t[np.abs(np.subtract.outer(t, edges)).min(axis=1) > 1e-3]
    small = 2e-6
    turned = attitude(motion, t - small).inv() * attitude(motion, t + small)
    differences = turned.as_rotvec() / (2.0 * small)
    rates = motion.evaluate(t).body_angular_velocity
    # Central differences err by the second derivative, which is large near the collision.
    slow = np.abs(motion.evaluate(t).yaw_rate) < 50.0
    assert slow.sum() > 300
    assert np.abs(differences - rates)[slow].max() < 2e-6


@pytest.mark.slow
@pytest.mark.parametrize(
    ("law", "its_law"),
    [
        (rr.NoSlip(), rb.Rolling()),
        (rr.Coulomb(0.15), rb.Coulomb(0.15)),
        (rr.Frictionless(), rb.Coulomb(0.0)),
    ],
)
def test_body_angular_velocity_is_that_of_newton_and_euler(law, its_law):
    slip = "center at rest" if isinstance(law, rr.Frictionless) else (0.0, 0.0)
    oracle = rb.follow(CAN, rb.release(CAN, START, slip=slip), its_law, 0.4)
    motion = rr.simulate(CAN, START, law, duration=0.4, gravity=9.8, rtol=1e-12)
    for t in np.linspace(0.0, 0.39, 40):
        y = oracle(t)
        w, x, y_, z = y[rb.TURN] / np.linalg.norm(y[rb.TURN])
        into_body = Rotation.from_quat([x, y_, z, w]).inv()
        seen = motion.evaluate(t).body_angular_velocity[0]
        assert seen == pytest.approx(into_body.apply(y[rb.OMEGA]), abs=1e-6)


def test_the_rates_stay_bounded_while_the_yaw_rate_passes_30000():
    """The paper's start: 5.3 rad/s at most, ω √(J/K) (the physics of the near-collision)."""
    start = rr.State(tilt=np.pi / 6, tilt_rate=-0.5, yaw_rate=0.005, spin_rate=0.005)
    motion = rr.simulate(CAN, start, rr.NoSlip(), duration=0.6, gravity=9.8)
    rates = motion.body_angular_velocity
    assert np.abs(motion.yaw_rate).max() > 3e4
    across = np.hypot(rates[:, 0], rates[:, 1])
    m, R, H, A = CAN.mass, CAN.radius, CAN.height, CAN.transverse_inertia
    K = A + m * H**2
    arriving = float(motion.evaluate(motion.turns[0].t - 1e-3).tilt_rate[0])
    assert across.max() == pytest.approx(abs(arriving) * np.sqrt((K + m * R**2) / K), rel=0.02)


def test_the_direction_across_jumps_by_the_turn_less_180_degrees():
    start = rr.State(tilt=np.pi / 6, tilt_rate=-0.5, yaw_rate=1e-5, spin_rate=1e-5)
    motion = rr.simulate(CAN, start, rr.NoSlip(), duration=0.6)
    turn = motion.turns[0]
    before, after = motion.evaluate([turn.t - 0.01, turn.t + 0.01]).body_angular_velocity
    jump = np.arctan2(after[1], after[0]) - np.arctan2(before[1], before[0])
    veer = rr.turn_limit(CAN, rr.NoSlip()) - np.pi
    assert np.remainder(jump + np.pi, 2 * np.pi) - np.pi == pytest.approx(veer, abs=2e-3)
