"""Numbers known from elsewhere: 128-bit arithmetic, and independent integrations of the print."""

import numpy as np
import pytest

import rimroll as rr
from given.motions import CAN, LAWS, PAPER_GRAVITY, by_law, sixty_starts


def paper_start(sideways=0.005):
    """The start of the paper's simulation figure, with other yaw and spin rates (rad/s)."""
    return rr.State(tilt=np.pi / 6, tilt_rate=-0.5, yaw_rate=sideways, spin_rate=sideways)


def paper_motion(body, law, sideways=0.005, duration=2.0, rtol=1e-13):
    start = paper_start(sideways)
    return rr.simulate(body, start, law, duration, gravity=PAPER_GRAVITY, rtol=rtol)


# Sixty starts of the can


def first_turn_of(row, law, rtol):
    names = "tilt", "tilt_rate", "yaw_rate", "spin_rate"
    start = rr.State(**{name: row[name] for name in names})
    duration = row[f"t_{law.name}"] + 0.01
    return rr.simulate(CAN, start, law, duration, gravity=PAPER_GRAVITY, rtol=rtol).turns[0]


# (rtol, error of the turn in rad and of its time in s, relative error of the least tilt). The
# default is meant for tens of rockings, so a single one is more accurate. At 1e-13 rounding
# is left: some units of the last place of a turn of 3.5 rad, after 200 steps.
@by_law
@pytest.mark.parametrize(
    ("rtol", "error", "tilt_error"), [(1e-10, 1e-11, 2e-11), (1e-13, 2e-14, 1e-13)]
)
def test_sixty_turns_of_the_can_agree_with_128_bit_arithmetic(law, rtol, error, tilt_error):
    rows = sixty_starts()
    assert len(rows) == 60
    for row in rows:
        turn = first_turn_of(row, law, rtol)
        assert turn.angle == pytest.approx(row[f"turn_{law.name}"], abs=error, rel=0)
        assert turn.min_tilt == pytest.approx(row[f"min_tilt_{law.name}"], rel=tilt_error)
        assert turn.end == pytest.approx(row[f"t_{law.name}"], abs=error, rel=0)


def test_the_sixty_turns_go_both_ways():
    turns = [first_turn_of(row, rr.NoSlip(), 1e-6).angle for row in sixty_starts()]
    assert min(turns) < -3.5 and max(turns) > 3.5


# The start of the paper's simulation figure: an independent integration of the printed equations,
# to the digits that agreed with a second one. Angles of turn in degrees.
FIGURE = {
    "no_slip": {
        "near_collision": "0.24308731",
        "min_tilt": "1.83292507e-04",
        "yaw_rate": "3.111697e+04",
        "first_turn": "202.6546207673",
        "turn": "202.67510452",
        "period": "0.63365199",
        "max_tilt": "0.54149376",
        "friction_ratio": "0.354996",
        "normal_force": "502.0",
    },
    "frictionless": {
        "near_collision": "0.17648604",
        "min_tilt": "9.65920625e-05",
        "yaw_rate": "8.174367e+04",
        "first_turn": "221.1530871944",
        "turn": "221.16124707",
        "period": "0.41047835",
        "max_tilt": "0.53071394",
        "friction_ratio": "0.000000",
        "normal_force": "1529.4",
    },
}


@by_law
def test_the_simulation_figure_is_reproduced_to_the_digits_printed(law):
    motion = paper_motion(CAN, law)
    first, second = motion.turns[:2]
    # 50 samples a step: the peaks of the forces are between the steps.
    fine = motion.samples(50)
    assert FIGURE[law.name] == {
        "near_collision": f"{first.t:.8f}",
        "min_tilt": f"{first.min_tilt:.8e}",
        "yaw_rate": f"{first.yaw_rate:.6e}",
        "first_turn": f"{np.degrees(first.angle):.10f}",
        "turn": f"{np.degrees(second.angle):.8f}",
        "period": f"{second.end - second.start:.8f}",
        "max_tilt": f"{first.max_tilt:.8f}",
        "friction_ratio": f"{fine.friction_ratio.max():.6f}",
        "normal_force": f"{fine.normal_force.max():.1f}",
    }


def test_yaw_and_spin_nearly_cancel_at_the_near_collision():
    """The paper's "psi_dot + theta_dot = 0": to 2e-7 of either, by independent integration."""
    event = next(e for e in paper_motion(CAN, rr.NoSlip()).events if e.kind == "tilt_min")
    remainder = (event.state.yaw_rate + event.state.spin_rate) / event.state.yaw_rate
    assert 1e-7 < abs(remainder) < 3e-7


# How the turn from tilt maximum to tilt maximum converges as yaw and spin rates go to zero: turn
# minus limit in rad, for rates of 0.1, 0.01, ... rad/s, by independent integration. Their six
# digits are required, and 3e-12 rad beside them, the rounding of that integration's Euler angles;
# rows end where that was larger.
CONVERGENCE = [
    pytest.param(
        CAN,
        rr.NoSlip(),
        "1.05839e-1 1.28566e-2 1.51289e-3 1.74012e-4 1.96736e-5 2.19460e-6 2.42184e-7 2.64909e-8",
        id="can_no_slip",
    ),
    pytest.param(
        CAN,
        rr.Frictionless(),
        "5.13251e-2 6.34129e-3 7.55019e-4 8.75911e-5 9.96802e-6 1.11769e-6 1.23861e-7 1.35954e-8",
        id="can_frictionless",
    ),
    pytest.param(
        rr.bodies.disk(0.051),
        rr.NoSlip(),
        "-7.03353e-3 2.41535e-4 1.16853e-4 2.09343e-5 3.01809e-6 3.94273e-7",
        id="disk_no_slip",
    ),
    pytest.param(
        rr.bodies.ring(0.051),
        rr.Frictionless(),
        "-7.64852e-3 2.49939e-4 1.26466e-4 2.27937e-5 3.29409e-6 4.30882e-7",
        id="ring_frictionless",
    ),
]


@pytest.mark.parametrize(("body", "law", "tabulated"), CONVERGENCE)
def test_turns_converge_to_the_limit_as_tabulated(body, law, tabulated):
    for decade, expected in enumerate(map(float, tabulated.split()), start=1):
        turn = paper_motion(body, law, sideways=10.0**-decade, duration=1.5).turns[1]
        excess = abs(turn.angle) - rr.turn_limit(body, law)
        last_digit = 10.0 ** (np.floor(np.log10(abs(expected))) - 5)
        assert abs(excess - expected) < 0.5 * last_digit + 3e-12, decade


# Limits in degrees. The can's and the disk's follow from the paper's formulas (the no-slip one
# with its fraction the right way up), here with the digits of an independent evaluation.
@pytest.mark.parametrize(
    ("body", "no_slip", "frictionless"),
    [
        pytest.param(CAN, 202.28719483, 220.96915717, id="can"),
        pytest.param(rr.bodies.disk(0.02), 402.49223595, 402.49223595, id="disk"),
        pytest.param(rr.bodies.ring(), 311.76914536, 311.76914536, id="ring"),
        pytest.param(rr.bodies.cylinder(0.1, 0.2), 229.920, 296.552, id="cylinder_H=R"),
        pytest.param(rr.bodies.cylinder(0.1, 0.4), 195.456, 229.920, id="cylinder_H=2R"),
        pytest.param(rr.bodies.cylinder(0.1, 1.0), 182.660, 190.197, id="cylinder_H=5R"),
    ],
)
def test_limiting_turns_are_those_known(body, no_slip, frictionless):
    digits = 8 if no_slip != round(no_slip, 3) else 3
    assert round(np.degrees(rr.turn_limit(body, rr.NoSlip())), digits) == no_slip
    assert round(np.degrees(rr.turn_limit(body, rr.Frictionless())), digits) == frictionless


def test_the_closest_starts_keep_all_digits():
    """The error law, turn = limit + phi_c (b ln phi_c + a), holds at rates of 1e-12 rad/s.

    With a taken from rates of 1e-6 rad/s the law's next term is below 1e-14 rad there; 1e-13 is
    left to rounding. An integration in Euler angles would have no digit of the excess left.
    """
    for law in LAWS:
        limit = rr.turn_limit(CAN, law)
        tipping_rate = rr.composite(CAN, paper_start(1e-12), law, PAPER_GRAVITY).tipping_rate
        b = rr.error_law_coefficient(CAN, law, tipping_rate, PAPER_GRAVITY)
        known, closest = (paper_motion(CAN, law, e, 1.5).turns[1] for e in (1e-6, 1e-12))
        a = (known.angle - limit) / known.min_tilt - b * np.log(known.min_tilt)
        expected = closest.min_tilt * (b * np.log(closest.min_tilt) + a)
        assert closest.min_tilt < 1e-13
        assert closest.angle - limit == pytest.approx(expected, abs=1e-13, rel=0)
