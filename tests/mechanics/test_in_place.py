"""Bodies that wobble in place, as Python users see them."""

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import rimroll as rr

CAN = rr.bodies.can_2007()
START = rr.State(tilt=0.5, tilt_rate=-0.5, yaw=0.3, yaw_rate=0.02)


@pytest.fixture(scope="module")
def motion():
    return rr.simulate(CAN, START, rr.InPlace(), duration=1.0, rtol=1e-12)


def test_the_body_stays_on_its_circle_and_its_yaw_and_spin_are_opposite(motion):
    at = motion.evaluate(np.linspace(0.0, 1.0, 101))
    assert at.spin + at.yaw == pytest.approx(np.full(101, 0.3), abs=1e-9)
    toward = np.column_stack([np.cos(at.yaw), np.sin(at.yaw)])
    center = at.contact_path + CAN.radius * toward
    assert np.ptp(center, axis=0) == pytest.approx([0.0, 0.0], abs=1e-10)


def test_the_motion_is_that_of_the_lagrangian(motion):
    """Tilt and yaw from L = J φ̇²/2 + I ψ̇²/2 − mgz by SciPy, with dI/dφ by a difference."""
    m, radius, height = CAN.mass, CAN.radius, CAN.height
    a, c = CAN.transverse_inertia, CAN.axial_inertia
    j = a + m * (radius**2 + height**2)

    def inertia(tilt):
        out = radius * (1 - np.cos(tilt)) + height * np.sin(tilt)
        return a * np.sin(tilt) ** 2 + c * (1 - np.cos(tilt)) ** 2 + m * out**2

    momentum = inertia(START.tilt) * START.yaw_rate

    def rates(_, u):
        tilt, rate, _ = u
        slope = (inertia(tilt + 1e-5) - inertia(tilt - 1e-5)) / 2e-5
        lever = radius * np.cos(tilt) - height * np.sin(tilt)
        yaw_rate = momentum / inertia(tilt)
        pull = 0.5 * slope * yaw_rate**2 - m * rr.STANDARD_GRAVITY * lever
        return [rate, pull / j, yaw_rate]

    start = [START.tilt, START.tilt_rate, START.yaw]
    times = np.array([0.05, 0.15, 0.2])
    found = solve_ivp(rates, (0, 0.2), start, t_eval=times, rtol=1e-11, atol=1e-13, method="DOP853")
    at = motion(times)
    assert at.tilt == pytest.approx(found.y[0], abs=1e-8)
    assert at.yaw == pytest.approx(found.y[2], abs=1e-7)


def test_the_limit_is_that_without_slip():
    assert rr.turn_limit(CAN, rr.InPlace()) == rr.turn_limit(CAN, rr.NoSlip())
    passed = rr.passage(CAN, rr.InPlace())
    assert passed.turn == pytest.approx(rr.turn_limit(CAN, rr.NoSlip()), abs=3e-8)
    start = rr.State(tilt=0.5, yaw_rate=1e-9)
    turn = rr.simulate(CAN, start, rr.InPlace(), duration=1.0).turns[0].angle
    assert turn == pytest.approx(rr.turn_limit(CAN, rr.InPlace()), abs=1e-6)


@pytest.mark.parametrize(
    "ask",
    [
        lambda start: rr.simulate(CAN, start, rr.InPlace(), duration=0.1),
        lambda start: rr.ensemble(CAN, start, rr.InPlace(), threads=1),
    ],
)
def test_a_start_has_no_spin_of_its_own(ask):
    with pytest.raises(rr.RimrollError, match=r"^spin_rate must be 0 or -yaw_rate for a body that"):
        ask(rr.State(tilt=0.5, yaw_rate=0.1, spin_rate=0.2))
    ask(rr.State(tilt=0.5, yaw_rate=0.1, spin_rate=-0.1))


def test_a_refusal_names_the_start_among_many():
    starts = rr.State(tilt=0.5, yaw_rate=0.1, spin_rate=[0.0, -0.1, 0.2])
    with pytest.raises(rr.RimrollError, match=r"^spin_rate\[2\] must be 0 or -yaw_rate"):
        rr.ensemble(CAN, starts, rr.InPlace())
    assert rr.ensemble(CAN, starts, rr.NoSlip()).sizes["trial"] == 3


def test_falls_are_those_of_single_motions():
    starts = rr.State(tilt=0.5, yaw_rate=[0.1, -0.3])
    falls = rr.ensemble(CAN, starts, rr.InPlace(), rtol=1e-10)
    for turn, yaw_rate in zip(falls.turn, (0.1, -0.3), strict=True):
        start = rr.State(tilt=0.5, yaw_rate=yaw_rate)
        single = rr.simulate(CAN, start, rr.InPlace(), duration=1.0)
        assert float(turn) == pytest.approx(single.turns[0].angle, abs=1e-8)


def test_a_hand_that_gives_the_body_spin_is_refused():
    with pytest.raises(rr.RimrollError, match=r"^spin_rate(\[\d+\])? must be 0 or -yaw_rate"):
        rr.topple(CAN, rr.InPlace(), 5, seed=1)


def test_resistance_brings_it_to_rest_and_the_budget_closes():
    law = rr.InPlace() + rr.RollingResistance(dry=0.02)
    motion = rr.simulate(CAN, rr.State(tilt=0.2, yaw_rate=8.0), law, duration=10.0)
    assert motion.status in ("at_rest", "face_down")
    energy = motion.kinetic_energy + motion.potential_energy + motion.resistance_loss
    assert energy == pytest.approx(np.full(len(energy), energy[0]), rel=1e-8)
    assert motion.resistance_loss[-1] > 0.0


def test_turns_by_quadrature_are_those_of_steps():
    tilts, rates = [0.2, 0.5, 0.2, 0.5], [0.1, -0.3, 1e-7, 1e-7]
    turns = rr.exact_turn(CAN, rr.State(tilt=tilts, yaw_rate=rates), rr.InPlace())
    assert set(turns.outcome) == {"rocked"}
    for row, (tilt, rate) in enumerate(zip(tilts, rates, strict=True)):
        start = rr.State(tilt=tilt, yaw_rate=rate, spin_rate=-rate)
        stepped = rr.simulate(CAN, start, rr.InPlace(), duration=2.0, rtol=1e-12).turns[0]
        assert turns.turn[row] == pytest.approx(stepped.angle, abs=1e-9)
        assert turns.end_time[row] == pytest.approx(stepped.end, rel=1e-9)
    assert turns.turn[2:] == pytest.approx(rr.turn_limit(CAN, rr.NoSlip()), abs=1e-5)


def test_the_first_start_with_a_spin_of_its_own_is_named_by_the_quadrature():
    starts = rr.State(tilt=0.5, yaw_rate=0.1, spin_rate=[0.0, -0.1, 0.2, 0.3])
    with pytest.raises(rr.RimrollError, match=r"^spin_rate\[2\] must be 0 or -yaw_rate .*got 0\.2"):
        rr.exact_turn(CAN, starts, rr.InPlace())


def test_a_map_is_by_quadrature():
    start = rr.State(tilt=0.5)
    mapped = rr.turn_map(CAN, start, rr.InPlace(), [-0.1, 0.1, 0.3], [0.0])
    assert "steps" not in mapped
    assert (
        mapped.turn.values[0, 1]
        == rr.exact_turn(CAN, rr.State(tilt=0.5, yaw_rate=0.1), rr.InPlace()).turn
    )


def test_turns_by_quadrature_have_no_derivatives():
    with pytest.raises(rr.RimrollError, match="jacobian must be False under InPlace"):
        rr.exact_turn(CAN, START, rr.InPlace(), jacobian=True)


def test_the_law_survives_a_dataset(motion):
    assert rr.Law.from_xarray(motion.to_xarray()) == rr.InPlace()
