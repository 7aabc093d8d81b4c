"""Friction that slips, from Newton and Euler alone: equations of motion, slip, impulse, moments.

Each test proves in symbols one formula that the sliding laws of rimroll compute with. The body may
slip on its rim, so that the velocity of G is free but for its vertical part; friction T and normal
force N act on the rim, and moments L on (e_x2, e_y2, e_z2) stand for whatever else resists.
"""

import numpy as np
import pytest
import sympy as sp
from scipy.optimize import minimize_scalar

from oracles import newton_euler as ne
from oracles.newton_euler import (
    ANGULAR_MOMENTUM,
    OMEGA,
    A,
    C,
    H,
    R,
    e_x1,
    e_x2,
    e_y1,
    e_z,
    e_z2,
    g,
    m,
    near_collision,
    on_tilted,
    on_yawed,
    phi,
    phi_ddot,
    phi_dot,
    psi_ddot,
    psi_dot,
    r_PG,
    rho,
    s,
    theta_ddot,
    theta_dot,
    vanishes,
    w,
    z,
)

v_x, v_y, v_x_dot, v_y_dot = sp.symbols("v_x v_y v_x_dot v_y_dot", real=True)
T_x, T_y, N, L_x, L_y, L_z = sp.symbols("T_x T_y N L_x L_y L_z", real=True)
mu, along = sp.symbols("mu u_x/|u|", real=True)  # along is the cosine of the slip from e_x1

VELOCITY = v_x * e_x1 + v_y * e_y1 + ne.rate(z) * e_z
FORCE = T_x * e_x1 + T_y * e_y1 + N * e_z
RESISTING = L_x * e_x2 + L_y * e_y1 + L_z * e_z2  # e_y2 is e_y1
SLIP = VELOCITY - OMEGA.cross(r_PG)

sin, cos = sp.sin(phi), sp.cos(phi)
s_dot, w_dot = ne.rate(s), ne.rate(w)


def rate(quantity):
    """d/dt, of the velocity of G too."""
    own = quantity.diff(v_x) * v_x_dot + quantity.diff(v_y) * v_y_dot
    return ne.rate(quantity) + own


def along_the_motion():
    """What Newton and Euler make of the accelerations, linear in T, N and L."""
    newton = on_yawed(m * rate(VELOCITY) + m * g * e_z - FORCE)
    euler = on_tilted(ne.rate(ANGULAR_MOMENTUM) - ne.moment(FORCE) - RESISTING)
    of_velocity = sp.solve(newton[:2], (v_x_dot, v_y_dot))
    (tilting,) = sp.solve(euler[1], phi_ddot)
    (yawing,) = sp.solve(euler[0], psi_ddot)
    (spinning,) = sp.solve(euler[2], theta_ddot)
    return {
        **of_velocity,
        phi_ddot: tilting,
        psi_ddot: yawing,
        theta_ddot: spinning.subs(psi_ddot, yawing),
    }


MOTION = along_the_motion()
SLIP_RATE = on_yawed(rate(SLIP))[:2]  # of the vector, seen from the inertial frame
# Newton along e_z: what N must be for the rim to stay on the table.
LIFTING = m * (g + rho * phi_ddot - z * phi_dot**2) - N
# The mobility of the rim: what a force on it does to its acceleration, an impulse to its velocity.
M_X, M_Y, M_N, M_XN = (
    1 / m + z**2 / A,
    1 / m + R**2 / C + H**2 / A,
    1 / m + rho**2 / A,
    -rho * z / A,
)


# Equations of motion


def test_newton_in_the_yawed_frame():
    newton = on_yawed(m * rate(VELOCITY) + m * g * e_z - FORCE)
    assert vanishes(newton[0] - m * (v_x_dot - psi_dot * v_y) + T_x)
    assert vanishes(newton[1] - m * (v_y_dot + psi_dot * v_x) + T_y)
    assert vanishes(newton[2] - LIFTING)


def test_euler_in_the_tilted_frame():
    euler = on_tilted(ne.rate(ANGULAR_MOMENTUM) - ne.moment(FORCE) - RESISTING)
    across = A * (w_dot + psi_dot * phi_dot * cos) - C * phi_dot * s - H * T_y - L_x
    tilting = -A * phi_ddot + A * w * psi_dot * cos - C * w * s - N * rho + T_x * z - L_y
    assert vanishes(euler - sp.Matrix([across, tilting, C * s_dot + R * T_y - L_z]))


def test_slip_is_the_velocity_of_the_material_rim_point():
    assert vanishes(on_yawed(SLIP) - sp.Matrix([v_x + z * phi_dot, v_y - R * s + H * w, 0]))
    # The rim point is lowest: the point of contact moves on along the table, never through it.
    assert vanishes(on_yawed(ne.rate(r_PG) - ne.rate(z) * e_z)[2])


def test_rate_of_the_slip_along_e_x1():
    u_x, u_y, _ = on_yawed(SLIP)
    carried = psi_dot * (u_y + R * s - H * w) + rho * phi_dot**2 + z * phi_ddot
    u_x_dot = rate(u_x)
    assert vanishes((u_x_dot - carried - T_x / m).subs(v_x_dot, MOTION[v_x_dot]))


def test_rate_of_the_slip_along_e_y1():
    u_x, u_y, _ = on_yawed(SLIP)
    carried = -psi_dot * u_x + R * w * phi_dot + H * C / A * phi_dot * s
    pushed = T_y * M_Y + H * L_x / A - R * L_z / C
    assert vanishes(rate(u_y).subs(MOTION) - carried - pushed)


def test_rate_of_the_slip_in_the_yawed_frame_is_that_of_the_vector():
    u_x, u_y, _ = on_yawed(SLIP)
    assert vanishes(SLIP_RATE[0] - rate(u_x) + psi_dot * u_y)
    assert vanishes(SLIP_RATE[1] - rate(u_y) - psi_dot * u_x)


# The normal force in slip


def test_normal_force_in_slip():
    eta = rho + mu * z * along
    gyroscopic = A * w * psi_dot * cos - C * w * s
    normal = m * ((g - z * phi_dot**2) * A + rho * gyroscopic) / (A + m * rho * eta)
    sliding = LIFTING.subs(phi_ddot, MOTION[phi_ddot]).subs({L_y: 0, T_x: -mu * N * along})
    assert vanishes(sliding.subs(N, normal))
    # So this is the tilt acceleration that goes with it.
    tilting = MOTION[phi_ddot].subs({L_y: 0, T_x: -mu * N * along})
    assert vanishes(tilting - (gyroscopic - N * eta) / A)


def painleve_friction(ratio, tilt):
    """(A + m rho2)/(m rho z) of a body with A = ratio m (R2 + H2), by its tilt from atan(R/H)."""
    return (ratio + np.cos(tilt) ** 2) / (np.cos(tilt) * np.sin(tilt))


@pytest.mark.parametrize(
    ("height", "transverse", "expected"),
    [
        (0.069 / 0.051, 5.13e-3 / 0.051**2, 2.175),  # the paper's can
        (0.0, 0.25, np.sqrt(5) / 2),  # disk
        (0.0, 0.5, np.sqrt(3)),  # ring
    ],
)
def test_least_friction_that_can_jam(height, transverse, expected):
    ratio = transverse / (1 + height**2)
    upright, balance = np.arctan(height), np.pi / 2
    least = minimize_scalar(
        lambda tilt: painleve_friction(ratio, tilt), bounds=(upright, balance), method="bounded"
    )
    assert least.fun == pytest.approx(expected, abs=5e-4)
    assert least.fun == pytest.approx(2 * np.sqrt(ratio * (1 + ratio)), rel=1e-9, abs=0.0)


def test_least_friction_that_can_jam_in_closed_form():
    # With rho = d cos(alpha), z = d sin(alpha) and A = a m d2, the denominator over m d2.
    a, alpha = sp.symbols("a alpha", positive=True)
    denominator = a + sp.cos(alpha) ** 2 - mu * sp.cos(alpha) * sp.sin(alpha)
    doubled = 2 * a + 1 + sp.cos(2 * alpha) - mu * sp.sin(2 * alpha)
    assert sp.simplify(sp.expand_trig(doubled) - 2 * denominator) == 0
    # cos - mu sin is at least -sqrt(1 + mu2): the denominator first touches zero at this mu.
    assert sp.expand((2 * a + 1) ** 2 - 1 - (2 * sp.sqrt(a * (1 + a))) ** 2) == 0
    # There tan(alpha)2 = 1 + 1/a, which is a tilt above zero only if the body is not too tall.
    at = sp.atan(sp.sqrt(1 + 1 / a))
    assert sp.simplify(denominator.subs({mu: 2 * sp.sqrt(a * (1 + a)), alpha: at})) == 0


def test_tall_body_jams_first_when_it_is_flat():
    ratio, upright = 0.3, np.arctan(5.0)
    tilts = np.linspace(upright, np.pi / 2 - 1e-6, 1000)
    frictions = painleve_friction(ratio, tilts)
    assert np.argmin(frictions) == 0
    assert frictions[0] > 2 * np.sqrt(ratio * (1 + ratio))


# Impulses and moments


def test_mobility_of_the_rim():
    P_x, P_y, P_n = sp.symbols("P_x P_y P_n")
    impulse = P_x * e_x1 + P_y * e_y1 + P_n * e_z
    moment = ne.moment(impulse)
    turned = moment / A + (1 / C - 1 / A) * moment.dot(e_z2) * e_z2
    change = on_yawed(impulse / m - turned.cross(r_PG))
    expected = [P_x * M_X + P_n * M_XN, P_y * M_Y, P_n * M_N + P_x * M_XN]
    assert vanishes(change - sp.Matrix(expected))


def test_impulse_changes_the_rates_of_tilt_yaw_and_spin():
    P_x, P_y, P_n = sp.symbols("P_x P_y P_n")
    moment = on_tilted(ne.moment(P_x * e_x1 + P_y * e_y1 + P_n * e_z))
    # On (e_x2, e_y2, e_z2) the angular momentum is (A w, -A phi_dot, C s).
    assert vanishes(moment - sp.Matrix([H * P_y, P_n * rho - P_x * z, -R * P_y]))


def test_moments_change_the_friction_that_sticking_needs():
    sticking = [rate(component).subs(MOTION) for component in on_yawed(SLIP)[:2]]
    sticking.append(LIFTING.subs(phi_ddot, MOTION[phi_ddot]))

    def holds(moment, response):
        """Whether (T_x, T_y, N) answer a unit of this moment so that the rim still sticks."""
        answers = list(zip((T_x, T_y, N), response, strict=True))
        return vanishes(
            [
                condition.diff(moment) + sum(condition.diff(force) * d for force, d in answers)
                for condition in sticking
            ]
        )

    assert holds(L_x, (0, -H / A / M_Y, 0))
    assert holds(L_z, (0, R / C / M_Y, 0))
    # A moment along e_y1 asks for T_x and N, through the coupling of the two, and not for T_y.
    across = sp.Matrix([[M_X, M_XN], [M_XN, M_N]]).inv() * sp.Matrix([z, -rho]) / A
    assert holds(L_y, (across[0], 0, across[1]))


def test_moments_do_not_change_the_normal_force_in_slip_but_about_e_y1():
    sliding = LIFTING.subs(phi_ddot, MOTION[phi_ddot]).subs(T_x, -mu * N * along)
    assert vanishes([sliding.diff(moment) for moment in (L_x, L_z)])
    assert not vanishes(sliding.diff(L_y))


def test_power_of_the_moments_of_rolling_pivoting_and_air():
    Q, vertical, drag = sp.symbols("Q vertical drag")
    # Rolling works on the spin alone, pivoting is vertical, air acts along e_x2.
    for moment, on_tilted_frame, power in (
        (-Q / sin * e_x1, (-Q * cos / sin, 0, Q), Q * theta_dot),
        (
            vertical * e_z,
            (vertical * sin, 0, vertical * cos),
            vertical * (psi_dot + theta_dot * cos),
        ),
        (-drag / (psi_dot * sin) * e_x2, (-drag / (psi_dot * sin), 0, 0), -drag),
    ):
        assert vanishes(on_tilted(moment) - sp.Matrix(on_tilted_frame))
        assert vanishes(on_yawed(moment).dot(on_yawed(OMEGA)) - power)


def test_energy_is_lost_to_the_slip_and_the_moments_alone():
    kinetic = m * VELOCITY.dot(VELOCITY) / 2 + OMEGA.dot(ANGULAR_MOMENTUM) / 2
    energy = kinetic.subs(ne.psi, 0) + m * g * z
    power = T_x * (v_x + z * phi_dot) + T_y * (v_y - R * s + H * w)
    power += L_x * w - L_y * phi_dot + L_z * s
    # What is left is what N would do to a rim that left the table.
    assert vanishes((rate(energy) - power - LIFTING * ne.rate(z)).subs(MOTION))


# The near collision


def test_inner_problem_is_the_limit_of_the_sliding_equations():
    # Forces grow like 1/tilt; rates of v and s with them, but v and s stay finite.
    spin, tau_x, tau_y, nu = sp.symbols("s tau_x tau_y nu")
    finite = {theta_dot: spin - psi_dot * cos}
    lifting = m * R * phi_ddot
    forces = {T_x: tau_x / phi, T_y: tau_y / phi, N: nu / phi}
    lean_acceleration = on_yawed(ne.rate(ne.rate(phi * e_x1)))
    push = H * sp.Matrix([T_x, T_y, 0]) - N * R * sp.Matrix([1, 0, 0])
    short_of_it = A * lean_acceleration - push
    euler = on_tilted(ne.rate(ANGULAR_MOMENTUM) - ne.moment(FORCE))
    for residual in (euler[0] - short_of_it[1], euler[1] + short_of_it[0], LIFTING + N - lifting):
        assert vanishes(near_collision(residual.subs(forces).subs(finite)))
    # None of these is the limit of nothing.
    for part in (euler[0], euler[1], lifting):
        assert near_collision(part.subs(forces).subs(finite)) != 0
