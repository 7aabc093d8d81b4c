"""One nutation and the path of the contact point, against whole motions and the quadrature."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st
from scipy.integrate import solve_ivp

import rimroll as rr
from given.motions import CAN, DISK
from given.strategies import bodies, few
from oracles.paper_equations import angular_accelerations

CUSPED = rr.State(tilt=1.4, yaw_rate=20.0, spin_rate=-5.0)
WAVY = rr.State(tilt=1.0, yaw_rate=5.0, spin_rate=5.0)


def printed_path(body, start, duration, gravity):
    """Tilt, yaw, the contact point from its start, and the rates, by the printed equations."""

    def rates(t, u):
        tilt, yaw, _x, _y, tilt_rate, yaw_rate, spin_rate = u
        accelerations = angular_accelerations(
            body, "no_slip", tilt, yaw_rate, tilt_rate, spin_rate, gravity
        )
        speed = body.radius * spin_rate
        return (
            tilt_rate,
            yaw_rate,
            -speed * np.sin(yaw),
            speed * np.cos(yaw),
            accelerations[1],
            accelerations[0],
            accelerations[2],
        )

    first = (start.tilt, start.yaw, 0.0, 0.0, start.tilt_rate, start.yaw_rate, start.spin_rate)
    found = solve_ivp(rates, (0.0, duration), first, method="DOP853", rtol=1e-12, atol=1e-13)
    return found.y[:, -1]


@pytest.mark.parametrize("start", [CUSPED, WAVY], ids=["cusps", "inflections"])
def test_a_nutation_of_the_printed_equations_returns_and_has_its_advance_and_drift(start):
    found = rr.nutation(DISK, start, gravity=9.81)
    tilt, yaw, x, y, *rates = printed_path(DISK, start, found.period, 9.81)
    assert tilt == pytest.approx(start.tilt, rel=1e-9)
    assert rates == pytest.approx([0.0, start.yaw_rate, start.spin_rate], abs=1e-8)
    assert yaw == pytest.approx(found.yaw_advance, rel=1e-9)
    if start == WAVY:  # begins at a tilt maximum
        assert np.hypot(x, y) == pytest.approx(found.drift, rel=1e-8)


@few
@given(
    body=bodies(),
    part=st.floats(0.1, 0.9),
    yaw_rate=st.floats(-3.0, 3.0),
    spin_rate=st.floats(-10.0, 10.0),
)
def test_a_path_is_turned_about_its_center_and_stays_in_its_ring(body, part, yaw_rate, spin_rate):
    start = rr.State(tilt=part * rr.balance_tilt(body), yaw_rate=yaw_rate, spin_rate=spin_rate)
    try:
        found = rr.nutation(body, start)
    except rr.RimrollError as refusal:
        assert "there is no nutation" in str(refusal)
        return
    assume(found.is_bounded and found.outer_radius < 1e3 * body.radius)
    motion = rr.simulate(body, start, rr.NoSlip(), 7.3 * found.period, rtol=1e-12)
    assume(motion.status == "finished")
    path = motion.samples(8).contact_path - found.center
    distances = np.linalg.norm(path, axis=1)
    # The path is known to the solver's tolerance, after some hundred steps.
    size = 1e-8 * (found.outer_radius + body.radius)
    assert distances.min() >= found.inner_radius - size
    assert distances.max() == pytest.approx(found.outer_radius, abs=0.02 * body.radius)
    assert distances.max() <= found.outer_radius + size
    chord = 2.0 * np.sin(found.yaw_advance / 2.0)
    at_maximum = [event.t for event in motion.crossings(lambda at: at.tilt_rate, rising=False)]
    points = motion.evaluate(np.array(at_maximum)).contact_path - found.center
    assert found.drift == pytest.approx(abs(chord) * np.hypot(*points[0]), abs=size)
    cos, sin = np.cos(found.yaw_advance), np.sin(found.yaw_advance)
    turned = points[:-1] @ np.array([[cos, sin], [-sin, cos]])
    np.testing.assert_allclose(points[1:], turned, atol=10 * size)


@few
@given(body=bodies(), part=st.floats(0.3, 0.9), spin_rate=st.floats(1.0, 10.0))
def test_the_yaw_advance_is_the_turn_of_the_quadrature(body, part, spin_rate):
    start = rr.State(tilt=part * rr.balance_tilt(body), spin_rate=spin_rate)
    turn = rr.exact_turn(body, start, rr.NoSlip())
    assume(turn.outcome == "rocked" and turn.end_tilt < np.pi / 2 - 1e-3)
    found = rr.nutation(body, start)
    assert found.yaw_advance == pytest.approx(turn.turn, abs=1e-8)
    assert found.min_tilt == pytest.approx(turn.min_tilt, abs=1e-10)
    assert found.max_tilt == pytest.approx(turn.end_tilt, abs=1e-9)


def test_the_contact_point_stops_at_a_cusp_and_turns_back():
    found = rr.nutation(DISK, CUSPED)
    assert found.cusps == 2
    motion = rr.simulate(DISK, CUSPED, rr.NoSlip(), found.period, rtol=1e-12)
    for cusp in motion.crossings(lambda at: at.spin_rate):
        around = cusp.t + np.array([-2e-5, -1e-5, 0.0, 1e-5, 2e-5])
        path = motion.evaluate(around).contact_path
        before, after = path[1] - path[0], path[4] - path[3]
        assert before @ after < -0.99 * np.linalg.norm(before) * np.linalg.norm(after)
    assert rr.nutation(DISK, WAVY).cusps == 0


def test_cusps_of_a_long_motion_are_where_those_of_the_printed_equations_are():
    found = rr.nutation(DISK, CUSPED, gravity=9.81)
    motion = rr.simulate(DISK, CUSPED, rr.NoSlip(), 10 * found.period, gravity=9.81, rtol=1e-12)
    assert {event.kind for event in motion.cusps} == {"cusp"}
    assert len(motion.cusps) == 10 * found.cusps
    for cusp in motion.cusps[:: found.cusps + 1]:
        spin_rate = printed_path(DISK, CUSPED, cusp.t, 9.81)[-1]
        assert spin_rate == pytest.approx(0.0, abs=1e-8)
    gaps = np.diff([cusp.t for cusp in motion.cusps])
    assert gaps[0] + gaps[1] == pytest.approx(found.period, rel=1e-10)


def test_a_rim_has_cusps_while_it_rolls_and_none_while_it_slips():
    rolling = rr.simulate(DISK, CUSPED, rr.NoSlip(), 1.0, rtol=1e-12)
    held = rr.simulate(DISK, CUSPED, rr.Coulomb(0.3), 1.0, rtol=1e-12)
    assert [phase.kind for phase in held.phases] == ["rolling"]
    np.testing.assert_allclose(
        [cusp.t for cusp in held.cusps], [cusp.t for cusp in rolling.cusps], rtol=1e-9
    )
    for law in rr.Coulomb(0.1), rr.Frictionless():
        motion = rr.simulate(DISK, replace(CUSPED, spin_rate=0.1), law, 2.0)
        zeros = motion.crossings(lambda at: at.spin_rate)
        slips = [p for p in motion.phases if p.kind == "sliding"]
        assert any(p.start < zero.t < p.end for zero in zeros for p in slips)
        assert all(np.hypot(*motion.evaluate(cusp.t).slip[0]) < 1e-12 for cusp in motion.cusps)
    wobbling = rr.simulate(DISK, rr.State(tilt=0.5, yaw_rate=1.0, spin_rate=-1.0), rr.InPlace())
    assert wobbling.cusps == []


def test_the_kind_of_a_path():
    assert rr.nutation(DISK, CUSPED).kind == "cusps"
    assert rr.nutation(DISK, WAVY).kind == "inflections"
    assert rr.nutation(DISK, rr.State(tilt=0.5, spin_rate=-20.0)).kind == "petals"


def test_inflections_are_where_the_yaw_turns_back():
    found = rr.nutation(DISK, WAVY)
    assert found.inflections == 2
    motion = rr.simulate(DISK, WAVY, rr.NoSlip(), found.period, rtol=1e-12)
    assert np.ptp(np.sign(motion.yaw_rate)) == 2.0


def test_at_a_resonance_the_path_goes_on_for_ever():
    """Borisov, Mamaev and Kilin (2003): the path of a disk is bounded unless it is resonant."""

    start = rr.resonant_start(DISK, rr.State(tilt=0.5), "spin_rate", (-60.0, -1.0))
    spin_rate = start.spin_rate
    found = rr.nutation(DISK, start)
    assert not found.is_bounded
    motion = rr.simulate(DISK, start, rr.NoSlip(), 50.5 * found.period, rtol=1e-12)
    maxima = [event.t for event in motion.crossings(lambda at: at.tilt_rate, rising=False)]
    path = motion.evaluate(np.array(maxima)).contact_path
    steps = np.diff(path, axis=0)
    np.testing.assert_allclose(np.linalg.norm(steps, axis=1), found.drift, rtol=1e-6)
    assert np.linalg.norm(path[-1] - path[0]) == pytest.approx(found.drift * len(steps), rel=1e-6)
    # Half a percent beside the resonance the path is bounded, in a ring many times as wide.
    beside = rr.nutation(DISK, replace(start, spin_rate=1.005 * spin_rate))
    assert beside.is_bounded and beside.outer_radius > 10 * found.drift


def test_small_nutations_resonate_where_their_rate_is_the_yaw_rate():
    """The resonance of small nutations, by the stability of steady motions."""

    def excess(tilt):
        slow, _ = rr.steady_motions(DISK, rr.NoSlip(), tilt, axial_spin=8.0)
        return slow, slow.nutation_rate - abs(slow.yaw_rate)

    low, high = 0.1, 0.4
    assert excess(low)[1] * excess(high)[1] < 0.0
    while high - low > 1e-12:
        middle = 0.5 * (low + high)
        low, high = (middle, high) if excess(low)[1] * excess(middle)[1] > 0.0 else (low, middle)
    steady = excess(low)[0]
    near = replace(steady.start, tilt=steady.tilt + 1e-4)
    found = rr.nutation(DISK, near)
    assert abs(found.yaw_advance) == pytest.approx(2.0 * np.pi, rel=1e-3)


def test_what_is_refused_of_a_resonance():
    start = rr.State(tilt=0.5)
    with pytest.raises(rr.RimrollError, match="between must enclose a resonance"):
        rr.resonant_start(DISK, start, "spin_rate", (-60.0, -50.0))
    with pytest.raises(rr.RimrollError, match="quantity"):
        rr.resonant_start(DISK, start, "spin", (-60.0, -50.0))


def test_what_has_no_nutation_is_refused():
    with pytest.raises(rr.RimrollError, match="there is no nutation"):
        rr.nutation(CAN, rr.State(tilt=0.8, yaw_rate=0.1))
    motion, _ = rr.steady_motions(DISK, rr.NoSlip(), 1.0, axial_spin=20.0)
    with pytest.raises(rr.RimrollError, match="there is no nutation: the motion is steady"):
        rr.nutation(DISK, motion.start)
    with pytest.raises(rr.RimrollError, match="start must be"):
        rr.nutation(CAN, 3)
