"""The mechanics, from Newton and Euler alone: the paper's equations, its errata and what follows.

Nothing of rimroll is used. `newton_euler` derives in symbols, `paper_equations` transcribes the
print of Srinivasan & Ruina (2007), and each test proves one claim or one erratum of the print.
"""

from types import SimpleNamespace

import numpy as np
import pytest
import sympy as sp
from scipy.optimize import brentq

from oracles import newton_euler as ne
from oracles import paper_equations as paper
from oracles.newton_euler import (
    ACCELERATIONS,
    BODY,
    OMEGA,
    RATES,
    A,
    C,
    D,
    H,
    J,
    K,
    R,
    e_x1,
    e_x2,
    e_y1,
    e_y2,
    e_z,
    g,
    l,
    m,
    near_collision,
    on_tilted,
    on_yawed,
    phi,
    phi_ddot,
    phi_dot,
    psi,
    psi_ddot,
    psi_dot,
    r_PG,
    rate,
    rho,
    s,
    theta_ddot,
    theta_dot,
    vanishes,
    w,
    z,
)
from oracles.paper_equations import integrate

LAWS = ["no_slip", "frictionless"]
# K and J of each law: the turn is pi sqrt(J/K), with K = A alone where friction cannot act.
K_OF = {"no_slip": K, "frictionless": A}
VELOCITY_OF = {"no_slip": ne.ROLLING_VELOCITY, "frictionless": ne.SLIDING_VELOCITY}
PLANAR = {psi_dot: 0, theta_dot: 0}  # the tipping phase: no yaw, no spin
NO_SPIN = -psi_dot * sp.cos(phi)  # the theta_dot that leaves s = 0

# The can of the paper's experiment; C/m = 2.0e-3 m2 is an estimate, the paper gives none possible.
CAN_VALUES = {R: 0.051, H: 0.069, m: 0.070, A: 0.070 * 5.13e-3, C: 0.070 * 2.0e-3, g: 9.8}


def body(mass=0.070, radius=0.051, height=0.069, transverse=5.13e-3, axial=2.0e-3):
    """A body from its moments of inertia per unit mass (m2)."""
    return SimpleNamespace(
        mass=mass,
        radius=radius,
        height=height,
        transverse_inertia=mass * transverse,
        axial_inertia=mass * axial,
    )


CAN = body()


def start(epsilon, tilt=np.pi / 6, tilt_rate=-0.5):
    """The paper's release, with yaw and spin rates epsilon (the paper: 0.005 rad/s)."""
    return SimpleNamespace(
        tilt=tilt, tilt_rate=tilt_rate, yaw=0.0, yaw_rate=epsilon, spin=0.0, spin_rate=epsilon
    )


def limit_degrees(K_value, mass, radius):
    return 180 * np.sqrt((K_value + mass * radius**2) / K_value)


def printed_residual(law):
    """Q q_ddot - S of the print, a column."""
    Q, S = paper.LAWS[law](BODY, phi, *RATES, g, sp)
    return sp.Matrix(Q) * sp.Matrix(ACCELERATIONS) - sp.Matrix(S)


def accelerations_of(law):
    return paper.angular_accelerations(BODY, law, phi, *RATES, g, sp)


def contact_force_of(law):
    """T_x, T_y, N on (e_x1, e_y1, e_z) along a motion."""
    force = on_yawed(ne.contact_force(VELOCITY_OF[law]))
    return force.subs(dict(zip(ACCELERATIONS, accelerations_of(law), strict=True)))


# Equations of motion and appendix A


@pytest.mark.parametrize("law", LAWS)
def test_printed_equations_of_motion_are_newton_and_euler(law):
    residual = ne.euler_residual(ne.contact_force(VELOCITY_OF[law]))
    assert vanishes(residual - printed_residual(law))


def test_printed_angular_velocity_is_that_of_the_three_rotations():
    spin_tensor = rate(ne.SPUN) * ne.SPUN.T
    angular_velocity = sp.Matrix([spin_tensor[2, 1], spin_tensor[0, 2], spin_tensor[1, 0]])
    at_reference_spin = on_yawed(angular_velocity.subs(ne.theta, 0))
    assert vanishes(at_reference_spin - on_yawed(OMEGA))
    assert vanishes(on_tilted(OMEGA) - sp.Matrix([w, -phi_dot, s]))


def test_printed_angular_momentum_and_its_rate_are_right():
    assert vanishes(on_tilted(ne.ANGULAR_MOMENTUM) - sp.Matrix([A * w, -A * phi_dot, C * s]))
    sin, cos = sp.sin(phi), sp.cos(phi)
    printed = sp.Matrix(
        [
            2 * A * psi_dot * phi_dot * cos
            + A * psi_ddot * sin
            - C * phi_dot * (theta_dot + psi_dot * cos),
            -A * phi_ddot
            + A * psi_dot**2 * sin * cos
            - C * psi_dot * sin * (theta_dot + psi_dot * cos),
            C * (-psi_dot * phi_dot * sin + psi_ddot * cos + theta_ddot),
        ]
    )
    assert vanishes(on_tilted(rate(ne.ANGULAR_MOMENTUM)) - printed)


def test_printed_velocity_and_accelerations_of_the_center_are_right():
    velocity = sp.Matrix([-H * phi_dot, R * s - H * w, R * phi_dot])
    assert vanishes(on_tilted(ne.ROLLING_VELOCITY) - velocity)
    for law in LAWS:
        printed = paper.CENTER_ACCELERATIONS[law](BODY, phi, RATES, ACCELERATIONS, sp)
        assert vanishes(on_tilted(rate(VELOCITY_OF[law])) - sp.Matrix(printed))


def test_printed_moments_about_the_center_are_right():
    sin, cos = sp.sin(phi), sp.cos(phi)
    sideways = (
        -2 * R * psi_dot * phi_dot * sin
        - 2 * H * psi_dot * phi_dot * cos
        + R * psi_ddot * cos
        - H * psi_ddot * sin
        + R * theta_ddot
    )
    B_2 = m * (
        -g * H * sin
        + H**2 * phi_ddot
        + H * R * psi_dot * theta_dot * cos
        + 2 * H * R * psi_dot**2 * cos**2
        - H**2 * psi_dot**2 * cos * sin
        + g * R * cos
        + R**2 * phi_ddot
        + R**2 * psi_dot * theta_dot * sin
        + R**2 * psi_dot**2 * sin * cos
        - R * H * psi_dot**2
    )
    rolling = on_tilted(ne.moment(ne.contact_force(ne.ROLLING_VELOCITY)))
    assert vanishes(rolling - sp.Matrix([m * H * sideways, B_2, -m * R * sideways]))
    M_2 = (
        m
        * (R * cos - H * sin)
        * (
            -R * phi_dot**2 * sin
            + R * phi_ddot * cos
            - H * phi_dot**2 * cos
            - H * phi_ddot * sin
            + g
        )
    )
    sliding = on_tilted(ne.moment(ne.contact_force(ne.SLIDING_VELOCITY)))
    assert vanishes(sliding - sp.Matrix([0, M_2, 0]))


# The forms that are better to compute with


def test_no_slip_is_linear_in_l_and_s_with_the_tilt_as_clock():
    row_1, _, row_3 = printed_residual("no_slip")
    L, s_dot = rate(l) / sp.sin(phi), rate(s)
    assert vanishes(row_1 - (K * L - m * H * R * s_dot) + (C * s - m * H * R * w) * phi_dot)
    assert vanishes(row_3 - (C + m * R**2) * s_dot + m * R * H * L + m * R**2 * w * phi_dot)


def test_no_slip_rates_of_l_and_s_solve_that_linear_system():
    accelerations = accelerations_of("no_slip")
    L = rate(l, accelerations) / sp.sin(phi)
    assert vanishes(L - C * phi_dot * ((C + m * R**2) * s - m * H * R * w) / D)
    s_rate = phi_dot * (m * R**2 * A * w + m * R * H * C * s) / D
    assert vanishes(rate(s, accelerations) - s_rate)


def test_spin_about_the_axis_has_a_logarithm_at_zero_tilt_and_l_has_none():
    l_, s_ = sp.symbols("l s")
    w_ = l_ / sp.sin(phi)
    dl_dphi = sp.expand(sp.sin(phi) * C * ((C + m * R**2) * s_ - m * H * R * w_) / D)
    ds_dphi = (m * R**2 * A * w_ + m * R * H * C * s_) / D
    assert vanishes(dl_dphi.subs(phi, 0) + m * H * R * C * l_ / D)
    residue = sp.limit(phi * ds_dphi, phi, 0)
    assert vanishes(residue - m * R**2 * A / (C * K + m * R**2 * A) * l_)


def test_tilt_acceleration_without_slip_in_terms_of_w_and_s():
    acceleration = (
        K * w * psi_dot * sp.cos(phi)
        - m * H * R * sp.cos(phi) * psi_dot * s
        - (C + m * R**2) * w * s
        + m * H * R * w**2
        - m * g * rho
    ) / J
    assert vanishes(accelerations_of("no_slip")[1] - acceleration)


def test_frictionless_motion_conserves_axial_spin_and_vertical_angular_momentum():
    accelerations = accelerations_of("frictionless")
    vertical = A * l + C * s * sp.cos(phi)
    assert vanishes(on_yawed(ne.ANGULAR_MOMENTUM)[2] - vertical)
    assert vanishes(rate(s, accelerations))
    assert vanishes(rate(vertical, accelerations))


@pytest.mark.parametrize("law", LAWS)
def test_energy_is_the_sum_of_its_parts_and_is_conserved(law):
    velocity = VELOCITY_OF[law]
    doubled = m * velocity.dot(velocity) + OMEGA.dot(ne.ANGULAR_MOMENTUM)
    of_center = {
        "no_slip": m * (R**2 + H**2) * phi_dot**2 + m * (R * s - H * w) ** 2,
        "frictionless": m * rho**2 * phi_dot**2,
    }[law]
    expected = of_center + A * phi_dot**2 + A * w**2 + C * s**2
    assert vanishes(doubled.subs(psi, 0) - expected)
    assert vanishes(paper.doubled_kinetic_energy(BODY, law, phi, *RATES, sp) - expected)
    assert vanishes(rate(expected + 2 * m * g * z, accelerations_of(law)))


@pytest.mark.parametrize("law", LAWS)
def test_table_pushes_with_the_stated_normal_force_and_friction(law):
    force = on_yawed(ne.contact_force(VELOCITY_OF[law]))
    assert vanishes(force[2] - m * (g + rho * phi_ddot - z * phi_dot**2))
    if law == "frictionless":
        assert vanishes(force[:2])
        return
    T_x = m * (-rho * phi_dot**2 - z * phi_ddot - psi_dot * R * s + H * w * psi_dot)
    assert vanishes(force[0] - T_x)
    T_y = contact_force_of(law)[1]
    assert vanishes(T_y + C * rate(s, accelerations_of(law)) / R)


def test_rolling_contact_point_runs_along_e_y1_at_the_rate_r_theta_dot():
    center_to_contact = -rho * e_x1
    x1, y1, _ = on_yawed(ne.ROLLING_VELOCITY + rate(center_to_contact))
    assert vanishes((x1, y1 - R * theta_dot))


# The near collision


@pytest.mark.parametrize("law", LAWS)
def test_near_collision_solution_satisfies_the_equations_of_motion_at_leading_order(law):
    t = sp.symbols("t", real=True)
    phi_c, b_2, b_3 = sp.symbols("phi_c b_2 b_3", positive=True)
    K_law, J_law = K_OF[law], K_OF[law] + m * R**2
    leading = near_collision(accelerations_of(law)[1].subs(theta_dot, NO_SPIN))
    assert vanishes(leading - K_law / J_law * phi * psi_dot**2)
    # So phi_ddot = b_3 / phi3 with b_3 = b_2^2 K/J, where psi_dot = b_2 / phi2.
    tilt = sp.sqrt(phi_c**2 + b_3 * t**2 / phi_c**2)
    assert sp.simplify(tilt.diff(t, 2) - b_3 / tilt**3) == 0
    assert tilt.diff(t).subs(t, 0) == 0
    # The tilt rate far out is omega, that of the tipping motion: b_2 = phi_c omega sqrt(J/K).
    omega = sp.limit(tilt.diff(t), t, sp.oo)
    b_2_squared = phi_c**2 * omega**2 * J_law / K_law
    assert vanishes(b_2_squared.subs(b_3, b_2**2 * K_law / J_law) - b_2**2)


def test_a_rolling_near_collision_needs_the_friction_mhr_over_k_throughout():
    T_x, T_y, N = contact_force_of("no_slip").subs(theta_dot, NO_SPIN)
    T_x, T_y, N = (near_collision(component) for component in (T_x, T_y, N))
    assert vanishes(T_y)
    assert vanishes(T_x * K - N * m * H * R)
    needed = (m * H * R / K).subs(CAN_VALUES)
    assert needed == pytest.approx(0.35577798, abs=1e-8)


def test_a_disk_rolls_through_its_near_collision_without_friction():
    force = contact_force_of("no_slip").subs(theta_dot, NO_SPIN).subs(H, 0)
    assert vanishes([near_collision(component) for component in force[:2]])
    assert not vanishes(near_collision(force[2]))


@pytest.mark.parametrize("law", LAWS)
def test_end_of_the_tipping_phase_presses_with_the_stated_normal_force(law):
    omega = sp.symbols("omega", positive=True)
    N = contact_force_of(law)[2].subs(PLANAR).subs(phi, 0).subs(phi_dot, -omega)
    # The two laws differ: what slides pays for the lift of G alone, not for its swing about P.
    expected = {
        "no_slip": m * (g * K / J - H * omega**2),
        "frictionless": m * (g - H * omega**2) * A / (A + m * R**2),
    }[law]
    assert vanishes(N - expected)


def test_a_rolling_can_lifts_off_at_the_stated_tilt_rate():
    omega_squared = sp.symbols("omega_squared", positive=True)
    N = contact_force_of("no_slip")[2].subs(PLANAR).subs(phi, 0)
    N = N.subs(phi_dot, -sp.sqrt(omega_squared))
    (lift_off,) = sp.solve(N, omega_squared)
    assert sp.simplify(lift_off - g * K / (J * H)) == 0
    assert np.sqrt(float(lift_off.subs(CAN_VALUES))) == pytest.approx(10.605, abs=5e-4)


def test_end_of_the_tipping_phase_needs_more_friction_than_the_roll_only_if_fast():
    omega_squared = sp.symbols("omega_squared", positive=True)
    T_x, _, N = contact_force_of("no_slip").subs(PLANAR).subs(phi, 0)
    T_x, N = (f.subs(phi_dot, -sp.sqrt(omega_squared)) for f in (T_x, N))
    needed = m * H * R / K
    (threshold,) = sp.solve(sp.numer(sp.together(-T_x - needed * N)), omega_squared)
    assert sp.simplify(threshold - 2 * m * g * H * K / (J * (K + m * H**2))) == 0
    assert np.sqrt(float(threshold.subs(CAN_VALUES))) == pytest.approx(8.549, abs=5e-4)
    # The other direction of friction needs less for every omega > 0, and as much for omega = 0.
    assert vanishes(needed * N - T_x - m * R * omega_squared * A / K)


def test_a_flat_body_may_need_more_friction_while_it_still_tips_than_when_it_rolls():
    # From rest at the tilt phi, |T|/N = m rho z / (A + m z2), which rises from its value at phi = 0
    # if the body is flat enough: the threshold above speaks of the end of the tipping phase only.
    T_x, _, N = contact_force_of("no_slip").subs(PLANAR).subs(phi_dot, 0)
    ratio = m * rho * z / (A + m * z**2)
    assert vanishes(T_x / N - ratio)
    slope = ratio.diff(phi).subs(phi, 0)
    assert slope.subs(CAN_VALUES) < 0
    assert slope.subs(CAN_VALUES | {H: 0.2 * CAN_VALUES[R], A: 0.070 * 0.051**2 / 4}) > 0


@pytest.mark.parametrize("law", LAWS)
def test_steady_wobble_with_the_center_at_rest_satisfies_both_laws(law):
    at_rest = {
        phi_dot: 0,
        theta_dot: H * w / R - psi_dot * sp.cos(phi),
        **dict.fromkeys(ACCELERATIONS, 0),
    }
    row_1, row_2, row_3 = printed_residual(law).subs(at_rest)
    assert vanishes((row_1, row_3))
    wobble_squared = m * g * R * rho / (sp.sin(phi) * (A * R * sp.cos(phi) - C * H * sp.sin(phi)))
    Psi = sp.symbols("Psi")
    (solved,) = sp.solve(sp.expand(row_2).subs(psi_dot**2, Psi), Psi)
    assert vanishes(solved - wobble_squared)
    assert vanishes(on_yawed(ne.ROLLING_VELOCITY).subs(at_rest))
    assert vanishes(on_yawed(rate(ne.ROLLING_VELOCITY)).subs(at_rest))


def binet_tilt(yaw, l_, spin, omega):
    """1 / tilt along the near collision of a body with spin, a conic in the plane of the lean."""
    q = sp.sqrt(K / J)
    center = m * H * R * spin / (K * l_)
    return center + sp.sqrt(center**2 + omega**2 / (q * l_) ** 2) * sp.cos(q * yaw)


def test_turn_with_a_finite_spin_is_that_of_a_conic_off_its_center():
    l_, spin = sp.symbols("l s", real=True, nonzero=True)
    yaw, omega = sp.symbols("yaw omega", positive=True)
    u = binet_tilt(yaw, l_, spin, omega)
    # With s and w = l / phi both finite, only these terms of the tilt equation are ~ 1/phi.
    finite_spin = accelerations_of("no_slip")[1].subs(theta_dot, spin - psi_dot * sp.cos(phi))
    leading = near_collision(finite_spin).subs(psi_dot, l_ / phi**2)
    assert vanishes(J * leading - K * l_**2 / phi**3 + m * H * R * spin * l_ / phi**2)
    # With l constant, d/dt = (l / phi2) d/dyaw, so phi_ddot = -l2 u2 u''.
    acceleration = -(l_**2) * u**2 * u.diff(yaw, 2)
    assert sp.simplify(J * acceleration - K * l_**2 * u**3 + m * H * R * spin * l_ * u**2) == 0
    # The turn is twice the yaw at which u = 0; for the arctangent, compare it with the claim.
    claimed = sp.sqrt(J / K) * (
        sp.pi + 2 * sp.atan(m * H * R * spin * sp.sign(l_) / (omega * sp.sqrt(J * K)))
    )
    for numbers in ({l_: 3e-5, spin: 0.7}, {l_: -3e-5, spin: 0.7}, {l_: 3e-5, spin: -2.0}):
        values = CAN_VALUES | numbers | {omega: 5.0}
        end = u.subs(yaw, claimed / 2).subs(values)
        assert abs(sp.N(end / u.subs(yaw, 0).subs(values))) < 1e-12


@pytest.mark.parametrize("spin", [2.0, -2.0])
def test_turn_with_a_finite_spin_is_what_the_printed_equations_integrate_to(spin):
    least_tilt, last_tilt, omega = 1e-7, 1e-5, 5.0
    K_can, J_can = (float(x.subs(CAN_VALUES)) for x in (K, J))
    coupling = CAN.mass * CAN.height * CAN.radius * spin
    # At the least tilt J omega2 = K w2 - 2 mHR s w.
    w_c = (coupling + np.sqrt(coupling**2 + K_can * J_can * omega**2)) / K_can
    yaw_rate = w_c / least_tilt
    release = SimpleNamespace(
        tilt=least_tilt,
        tilt_rate=0.0,
        yaw=0.0,
        yaw_rate=yaw_rate,
        spin=0.0,
        spin_rate=spin - yaw_rate * np.cos(least_tilt),
    )
    motion = integrate(CAN, release, "no_slip", 1.2 * last_tilt / omega, rtol=1e-10)
    t = brentq(lambda t: motion(t).phi[0] - last_tilt, 0.1 * last_tilt / omega, motion.t[-1])
    offset = np.arctan(coupling / (omega * np.sqrt(J_can * K_can)))
    half_turn = np.sqrt(J_can / K_can) * (np.pi / 2 + offset)
    # Beyond last_tilt the conic still has about l / (omega phi) to go.
    rest = w_c * least_tilt / (omega * last_tilt)
    assert motion(t).psi[0] + rest == pytest.approx(half_turn, abs=2e-3 * rest + 1e-4)


def error_law(law):
    """b of |turn| = limit + phi_c (b log phi_c + a), and the omega in it.

    The turn is from one tilt maximum to the next and omega the tilt rate of the tipping motion at
    zero tilt. N_p, the normal force there, is not the same function of omega in the two laws.
    """
    omega = sp.symbols("omega", positive=True)
    K_law, J_law = K_OF[law], K_OF[law] + m * R**2
    N_p = contact_force_of(law)[2].subs(PLANAR).subs(phi, 0).subs(phi_dot, -omega)
    return -2 * sp.sqrt(J_law / K_law) * R * N_p / (K_law * omega**2), omega


@pytest.mark.parametrize("law", LAWS)
def test_turn_approaches_its_limit_as_phi_c_log_phi_c(law):
    b, omega = error_law(law)
    K_law, J_law = K_OF[law], K_OF[law] + m * R**2
    # Towards phi = 0, l = l_c (1 - eta phi) and s = kappa l_c log phi.
    eta, kappa = (m * H * R * C / D, m * R**2 * A / D) if law == "no_slip" else (0, 0)
    l_c = omega * sp.sqrt(J_law / K_law)  # over phi_c
    # Tipping: d yaw / d phi = l / (phi2 |phi_dot|), with |phi_dot| = omega (1 + growth phi). Its
    # term in 1/phi, cut off near phi_c, gives a logarithm while falling and one while rising.
    tilt_acceleration = accelerations_of(law)[1].subs(PLANAR).subs(phi, 0).subs(phi_dot, -omega)
    growth = tilt_acceleration / omega**2
    tipping = -2 * l_c / omega * (-eta - growth)
    # Rolling: the spin kappa l_c log phi_c that tipping leaves, in the turn with a finite spin.
    rolling = 2 * sp.sqrt(J_law / K_law) * m * H * R * kappa * l_c
    rolling /= omega * sp.sqrt(J_law * K_law)
    assert vanishes(sp.simplify(tipping + rolling - b))


@pytest.mark.parametrize(("law", "tabulated"), [("no_slip", -2.6919), ("frictionless", -2.7181)])
def test_coefficient_of_phi_c_log_phi_c_is_what_the_printed_equations_give(law, tabulated):
    b, omega = error_law(law)
    K_can, J_can = (float(x.subs(CAN_VALUES)) for x in (K_OF[law], K_OF[law] + m * R**2))
    # What tips from the start's tilt and tilt rate reaches zero tilt at this rate.
    fall = [
        float((x.subs(CAN_VALUES)).subs({phi: np.pi / 6, phi_dot: -0.5}))
        for x in (paper.doubled_kinetic_energy(BODY, law, phi, 0, phi_dot, 0, sp), z - H)
    ]
    omega_can = np.sqrt((fall[0] + 2 * CAN.mass * 9.8 * fall[1]) / J_can)
    stated = float(b.subs(CAN_VALUES).subs(omega, omega_can))
    assert stated == pytest.approx(tabulated, abs=1e-4)

    excess, log_tilt = [], []
    for epsilon in (1e-3, 1e-4):
        motion = integrate(CAN, start(epsilon), law, 1.5)
        turn = abs(np.diff(motion.maxima.psi)[0])
        excess.append((turn - np.pi * np.sqrt(J_can / K_can)) / motion.minima.phi[0])
        log_tilt.append(np.log(motion.minima.phi[0]))
    assert np.diff(excess)[0] / np.diff(log_tilt)[0] == pytest.approx(stated, rel=3e-4)


DISK = body(height=0, transverse=0.051**2 / 4, axial=0.051**2 / 2)
RING = body(height=0, transverse=0.051**2 / 2, axial=0.051**2)


@pytest.mark.parametrize(
    ("rolls", "law", "tabulated"),
    [
        (CAN, "no_slip", [1.05839e-1, 1.28566e-2, 1.51289e-3]),
        (CAN, "frictionless", [5.13251e-2, 6.34129e-3, 7.55019e-4]),
        (DISK, "no_slip", [-7.03353e-3, 2.41535e-4, 1.16853e-4]),
        (RING, "frictionless", [-7.64852e-3, 2.49939e-4, 1.26466e-4]),
    ],
    ids=["can no_slip", "can frictionless", "disk no_slip", "ring frictionless"],
)
def test_turn_between_tilt_maxima_differs_from_its_limit_by_the_tabulated_radians(
    rolls, law, tabulated
):
    # Release to first maximum is another number: for the can without slip, 0.0987 at epsilon = 0.1.
    K_body = rolls.transverse_inertia
    if law == "no_slip":
        K_body += rolls.mass * rolls.height**2
    limit = np.radians(limit_degrees(K_body, rolls.mass, rolls.radius))
    for epsilon, expected in zip((1e-1, 1e-2, 1e-3), tabulated, strict=True):
        motion = integrate(rolls, start(epsilon), law, 1.5)
        turn = abs(motion.maxima.psi[1] - motion.maxima.psi[0])
        assert turn - limit == pytest.approx(expected, abs=1e-5 * abs(expected) + 1e-9)


@pytest.mark.parametrize(
    ("law", "turn", "min_tilt", "yaw_rate", "needed_friction", "max_normal"),
    [
        ("no_slip", 202.6546207673, 1.83292507e-4, 3.111697e4, 0.354996, 502.0),
        ("frictionless", 221.1530871945, 9.65920625e-5, 8.174367e4, 0, 1529.4),
    ],
)
def test_the_can_of_the_paper_released_as_in_its_figure(
    law, turn, min_tilt, yaw_rate, needed_friction, max_normal
):
    motion = integrate(CAN, start(0.005), law, 0.6)
    least = motion.minima
    assert np.degrees(motion.maxima.psi[0]) == pytest.approx(turn, abs=1e-8)
    assert least.phi[0] == pytest.approx(min_tilt, rel=1e-8)
    assert least.psi_dot[0] == pytest.approx(yaw_rate, rel=1e-6)
    # The paper's figure: psi_dot + theta_dot is next to nothing where both are enormous.
    assert abs(least.psi_dot[0] + least.theta_dot[0]) < 2e-7 * least.psi_dot[0]
    energies = paper.energy(CAN, motion, law)
    assert np.ptp(energies) < 1e-11 * energies[0]
    force = paper.contact_force(CAN, motion(np.append(motion.t, least.t[0])), law)
    assert force.ratio.max() == pytest.approx(needed_friction, abs=2e-6)
    assert force.normal.max() == pytest.approx(max_normal, abs=0.05)
    assert force.normal.min() > 0
    in_world = np.hypot(*force.friction_in_world)
    assert in_world == pytest.approx(np.hypot(*force.friction), abs=1e-12)


# Coulomb friction


def test_body_with_any_friction_obeys_the_stated_equations():
    v_x, v_y, v_x_dot, v_y_dot, T_x, T_y, N = sp.symbols("v_x v_y v_x_dot v_y_dot T_x T_y N")
    force = T_x * e_x1 + T_y * e_y1 + N * e_z
    x2, y2, z2 = ne.euler_residual(force)
    stated = A * (rate(w) + psi_dot * phi_dot * sp.cos(phi)) - C * phi_dot * s - H * T_y
    assert vanishes(x2 - stated)
    stated = -A * phi_ddot + A * w * psi_dot * sp.cos(phi) - C * w * s - N * rho + T_x * z
    assert vanishes(y2 - stated)
    assert vanishes(z2 - (C * rate(s) + R * T_y))
    velocity = v_x * e_x1 + v_y * e_y1
    acceleration = rate(velocity) + v_x_dot * e_x1 + v_y_dot * e_y1
    expected = sp.Matrix([v_x_dot - psi_dot * v_y, v_y_dot + psi_dot * v_x, 0])
    assert vanishes(on_yawed(acceleration) - expected)
    slip = on_yawed(velocity - OMEGA.cross(r_PG))
    assert vanishes(slip[:2, 0] - sp.Matrix([v_x + z * phi_dot, v_y - R * s + H * w]))


def test_normal_force_of_a_sliding_body_is_defined_only_below_the_painleve_friction():
    N, mu, along = sp.symbols("N mu along")  # along = u_x / |u|
    T_x = -mu * N * along
    phi_ddot_of_N = sp.solve(
        -A * phi_ddot + A * w * psi_dot * sp.cos(phi) - C * w * s - N * rho + T_x * z, phi_ddot
    )[0]
    balance = N - m * (g + rho * phi_ddot_of_N - z * phi_dot**2)
    assert vanishes(A * balance.diff(N) - (A + m * rho * (rho + mu * z * along)))

    def largest_friction(height, transverse):
        tilt = np.linspace(1e-6, np.pi / 2 - 1e-6, 200_001)
        rho_, z_ = np.cos(tilt) - height * np.sin(tilt), np.sin(tilt) + height * np.cos(tilt)
        tilt_up = rho_ > 0
        return np.min(((transverse + rho_**2) / (rho_ * z_))[tilt_up])

    assert largest_friction(0.069 / 0.051, 5.13e-3 / 0.051**2) == pytest.approx(2.175, abs=5e-4)
    assert largest_friction(0, 1 / 4) == pytest.approx(1.118, abs=5e-4)
    assert largest_friction(0, 1 / 2) == pytest.approx(1.732, abs=5e-4)


# The errata of the print: what is printed is wrong, and the correction is right


def can_value(expression):
    return float(sp.sympify(expression).subs(CAN_VALUES))


def test_erratum_inverted_fraction():
    t = sp.symbols("t", real=True)
    phi_c, b_2, b_3 = sp.symbols("phi_c b_2 b_3", positive=True)
    turn = sp.integrate(b_2 / (phi_c**2 + b_3 * t**2 / phi_c**2), (t, -sp.oo, sp.oo))
    turn = turn.subs(b_3, b_2**2 * K / J)
    right, printed = sp.pi * sp.sqrt(J / K), sp.pi * sp.sqrt(K / J)
    assert vanishes((turn / right) ** 2 - 1)
    assert not vanishes((turn / printed) ** 2 - 1)
    assert np.degrees(can_value(right)) == pytest.approx(202.287, abs=5e-4)
    assert np.degrees(can_value(printed)) == pytest.approx(160.168, abs=5e-4)
    motion = integrate(CAN, start(1e-4), "no_slip", 0.7)
    assert np.degrees(motion.maxima.psi[0]) == pytest.approx(202.287, abs=0.02)


def test_erratum_flipped_integration_limits():
    t_c, t = sp.symbols("t_c t", real=True)
    phi_c, b_2, b_3, dt = sp.symbols("phi_c b_2 b_3 dt", positive=True)
    psi_rate = b_2 / (phi_c**2 + b_3 * (t - t_c) ** 2 / phi_c**2)
    stated = 2 * b_2 / sp.sqrt(b_3) * sp.atan(sp.sqrt(b_3) * dt / phi_c**2)
    antiderivative = b_2 / sp.sqrt(b_3) * sp.atan(sp.sqrt(b_3) * (t - t_c) / phi_c**2)
    assert sp.simplify(antiderivative.diff(t) - psi_rate) == 0
    before, after = antiderivative.subs(t, t_c - dt), antiderivative.subs(t, t_c + dt)
    assert sp.simplify(after - before - stated) == 0
    assert sp.simplify(before - after + stated) == 0  # as printed: the turn with its sign changed


def test_erratum_inertias_are_per_unit_mass():
    read_as_absolute = body(transverse=5.1e-3 / 0.070, axial=8e-3 / 0.070)
    read_per_mass = body(transverse=5.1e-3, axial=8e-3)

    def limits(can):
        K_can = can.transverse_inertia + can.mass * can.height**2
        return [limit_degrees(k, can.mass, can.radius) for k in (K_can, can.transverse_inertia)]

    assert limits(read_as_absolute) == pytest.approx([182.99, 183.18], abs=5e-3)
    # The paper says 202 and about 220; its text gives A/m = 5.13e-3 m2.
    assert limits(read_per_mass) == pytest.approx([202.35, 221.19], abs=5e-3)

    # The figure shows the can rocking for ever; read as kg m2 its start topples at the first rise.
    topples = integrate(read_as_absolute, start(0.005), "no_slip", 2.2)
    t = brentq(lambda t: topples(t).phi[0] - 1.5, topples.minima.t[0], 2.2)
    assert t == pytest.approx(2.129, abs=1e-3)
    assert len(topples.maxima) == 0
    rocks = integrate(read_per_mass, start(0.005), "no_slip", 2.2)
    assert len(rocks.maxima) == 3
    assert np.ptp(rocks.maxima.phi) < 1e-9


def test_erratum_axial_inertia_is_impossible_for_a_can_no_wider_than_its_rim():
    # C is the mean of m r2 and no mass is farther out than R.
    assert CAN.axial_inertia < CAN.mass * CAN.radius**2
    assert CAN.radius**2 == pytest.approx(2.601e-3)
    assert CAN.radius**2 < 8e-3


def small_tilt_row_1(gyroscopic):
    """Eq. (eq1atsmallphi), left minus right, with its last term as given."""
    return (
        (A * phi - m * H * R + m * H**2 * phi) * psi_ddot
        - m * H * R * theta_ddot
        - (C - 2 * A - 2 * m * H**2) * psi_dot * phi_dot
        - gyroscopic
    )


def small_tilt_row_3():
    """Eq. (eq3atsmallphi), left minus right."""
    return (
        (C + m * R**2 - m * R * H * phi) * psi_ddot
        + (C + m * R**2) * theta_ddot
        - 2 * m * R * H * psi_dot * phi_dot
    )


def test_erratum_missing_dot_on_phi_at_small_tilt():
    right = small_tilt_row_1(C * theta_dot * phi_dot)
    printed = small_tilt_row_1(C * theta_dot * phi)
    exact, _, exact_3 = printed_residual("no_slip")
    assert vanishes(near_collision(exact - right))
    assert not vanishes(near_collision(exact - printed))
    assert vanishes(near_collision(exact_3 - small_tilt_row_3()))
    # Only the corrected one has the solution that the paper draws from it.
    solution = {theta_dot: -psi_dot, theta_ddot: -psi_ddot}
    solution_psi = {psi_ddot: -2 * psi_dot * phi_dot / phi}
    assert vanishes(right.subs(solution).subs(solution_psi))
    assert vanishes(small_tilt_row_3().subs(solution).subs(solution_psi))
    assert not vanishes(printed.subs(solution).subs(solution_psi))


def test_erratum_yaw_plus_spin_zero_is_only_one_solution():
    # sigma = psi_dot + theta_dot and B = phi2 psi_dot as functions of the tilt: these two linear
    # equations have a solution for any sigma and B at one tilt, and not only for sigma = 0.
    sigma, B = (sp.Function(name)(phi) for name in ("sigma", "B"))
    sigma_slope = m * R * H * C / D * sigma
    B_slope = C * (C + m * R**2) / D * phi * sigma

    def along_tilt(quantity):
        slope = quantity.diff(phi).subs({sigma.diff(phi): sigma_slope, B.diff(phi): B_slope})
        return slope * phi_dot

    psi_rate = B / phi**2
    theta_rate = sigma - psi_rate
    rates = {psi_dot: psi_rate, theta_dot: theta_rate}
    accelerations = {psi_ddot: along_tilt(psi_rate), theta_ddot: along_tilt(theta_rate)}
    for row in (small_tilt_row_1(C * theta_dot * phi_dot), small_tilt_row_3()):
        assert vanishes(row.subs(accelerations).subs(rates))
    # The printed pair claims to be equivalent, and holds for sigma = 0 alone.
    printed_2 = along_tilt(psi_rate) / psi_rate + 2 * phi_dot / phi
    assert vanishes(printed_2.subs(sigma, 0))
    assert not vanishes(printed_2)


def test_erratum_contact_point():
    cos_phi, sin_phi, cos_psi, sin_psi = sp.cos(phi), sp.sin(phi), sp.cos(psi), sp.sin(psi)
    right = sp.Matrix([-rho * cos_psi, -rho * sin_psi, -R * sin_phi - H * cos_phi])
    printed = sp.Matrix(
        [
            -R * cos_phi * cos_psi + H * sin_phi,
            -R * sin_psi,
            -R * sin_phi * cos_psi - H * cos_phi,
        ]
    )
    assert sp.simplify(-r_PG - right) == sp.zeros(3, 1)
    # The print is what comes of tilting first and yawing the body inside: the wrong order.
    on_body = sp.Matrix([-R, 0, -H])
    assert sp.simplify(ne.turned(2, psi) * ne.turned(1, -phi) * on_body - right) == sp.zeros(3, 1)
    assert sp.simplify(ne.turned(1, -phi) * ne.turned(2, psi) * on_body - printed) == sp.zeros(3, 1)
    # The contact point stays on the table, z_P = 0, whatever the yaw; the printed one does not.
    assert vanishes(z + right[2])
    assert not vanishes((z + printed[2]).subs(psi, 1))
    # At small tilt both are the circle of radius R that the argument needs.
    circle = sp.Matrix([-R * cos_psi, -R * sin_psi, -H])
    assert right.subs(phi, 0) == circle == printed.subs(phi, 0)


def test_erratum_contact_circle_needs_no_condition_on_the_yaw():
    cos_psi, sin_psi = sp.cos(psi), sp.sin(psi)
    horizontal = [
        (-r_PG)[i].subs(phi, 0) + phi * sp.diff(-r_PG, phi)[i].subs(phi, 0) for i in (0, 1)
    ]
    scale = 1 - phi * H / R
    assert vanishes(horizontal[0] + R * cos_psi * scale)
    assert vanishes(horizontal[1] + R * sin_psi * scale)
    # As printed, x_P is off by H phi at every yaw: without bound relative to R cos(psi) near pi/2.
    printed = -R * sp.cos(phi) * cos_psi + H * sp.sin(phi)
    error = sp.diff(printed + R * cos_psi, phi).subs(phi, 0)
    assert vanishes(error - H)


def test_erratum_omega_2_turns_the_frame_of_the_velocity():
    velocity = on_tilted(ne.ROLLING_VELOCITY)
    omega = on_tilted(OMEGA)
    omega_2 = on_tilted(psi_dot * e_z - phi_dot * e_y1)
    printed_result = sp.Matrix(
        paper.center_acceleration_no_slip(BODY, phi, RATES, ACCELERATIONS, sp)
    )
    assert vanishes(rate(velocity) + omega_2.cross(velocity) - printed_result)
    assert not vanishes(rate(velocity) + omega.cross(velocity) - printed_result)
    assert vanishes(on_yawed(rate(e_x2) - (psi_dot * e_z - phi_dot * e_y1).cross(e_x2)))


@pytest.mark.parametrize("law", LAWS)
def test_erratum_halved_potential_energy(law):
    doubled_kinetic = paper.doubled_kinetic_energy(BODY, law, phi, *RATES, sp)
    accelerations = accelerations_of(law)
    assert not vanishes(rate(doubled_kinetic + m * g * z, accelerations))
    assert vanishes(rate(doubled_kinetic + 2 * m * g * z, accelerations))


def test_erratum_missing_dot_on_psi_in_the_frictionless_energy():
    right = paper.doubled_kinetic_energy(BODY, "frictionless", phi, *RATES, sp) + 2 * m * g * z
    printed = right - C * s**2 + C * (theta_dot + psi * sp.cos(phi)) ** 2
    accelerations = accelerations_of("frictionless")
    assert vanishes(rate(right, accelerations))
    assert not vanishes(rate(printed, accelerations).subs(psi, 1))
    assert right.diff(psi) == 0  # the direction of zero yaw must not matter
    assert printed.diff(psi) != 0


@pytest.mark.parametrize("law", LAWS)
def test_erratum_b_2_is_of_order_phi_c(law):
    phi_c, omega, beta = sp.symbols("phi_c omega beta", positive=True)
    K_law, J_law = K_OF[law], K_OF[law] + m * R**2
    # At the least tilt, without spin: the energy that falls as J omega2 must be all in K w2.
    kinetic = paper.doubled_kinetic_energy(BODY, law, phi, psi_dot, 0, NO_SPIN, sp)
    of_b_2 = kinetic.subs(psi_dot, beta / phi**2).subs(phi, phi_c)
    right = of_b_2.subs(beta, phi_c * omega * sp.sqrt(J_law / K_law))
    printed = of_b_2.subs(beta, phi_c**2 * omega)
    assert vanishes(sp.limit(right, phi_c, 0) - J_law * omega**2)
    assert sp.limit(printed, phi_c, 0) == 0  # the body would stop dead at the collision
    far, near = two_minima(law)
    tilt_ratio = near.phi[0] / far.phi[0]
    b_2_ratio = near.psi_dot[0] / far.psi_dot[0] * tilt_ratio**2
    assert np.log(b_2_ratio) / np.log(tilt_ratio) == pytest.approx(1, abs=1e-3)


def two_minima(law):
    """The first near collision of two releases, one ten times nearer to collision."""
    return [integrate(CAN, start(epsilon), law, 0.4).minima for epsilon in (1e-2, 1e-3)]


def test_erratum_yaw_plus_spin_is_of_order_phi_c_log_phi_c():
    phi_c, omega, phi_0 = sp.symbols("phi_c omega phi_0", positive=True)
    sigma = sp.symbols("sigma", real=True)
    kappa = m * R**2 * A / D
    b_2 = phi_c * omega * sp.sqrt(J / K)
    # ds/dphi = kappa b_2 / phi, from a start with s of the order of b_2.
    s_c = phi_c * sigma + kappa * b_2 * sp.log(phi_c / phi_0)
    yaw_plus_spin = s_c + b_2 / 2  # since 1 - cos phi_c = phi_c2 / 2
    psi_rate = b_2 / phi_c**2
    in_logs = sp.expand_log(sp.expand(yaw_plus_spin / (phi_c * sp.log(phi_c))))
    assert vanishes(sp.limit(in_logs, phi_c, 0) - kappa * omega * sp.sqrt(J / K))
    printed_ratio = sp.expand_log(sp.expand(yaw_plus_spin / (psi_rate * phi_c)))
    assert sp.limit(printed_ratio, phi_c, 0) == 0

    far, near = two_minima("no_slip")
    far_sum, near_sum = (x.psi_dot[0] + x.theta_dot[0] for x in (far, near))
    slope = near_sum / near.phi[0] - far_sum / far.phi[0]
    slope /= np.log(near.phi[0] / far.phi[0])
    w_c = near.psi_dot[0] * near.phi[0]  # omega sqrt(J/K), and the printed size of the sum
    assert slope == pytest.approx(can_value(kappa) * w_c, rel=5e-3)
    assert abs(near_sum) < 0.2 * abs(far_sum) < 0.2 * w_c


# The heuristic section. It leans the body about +e_y1, so its contact point is on the +e_x1 side.

LEAN = phi * e_y1
LEAN_RATE = rate(LEAN)
CENTER_FROM_CONTACT = -(R - H * phi) * e_x1 + (R * phi + H) * e_z
SWING = phi * psi_ddot + 2 * phi_dot * psi_dot
PULL = phi_ddot - phi * psi_dot**2


def heuristic_force():
    """m r_G_ddot at leading order, on (e_x1, e_y1, e_z)."""
    acceleration = on_yawed(rate(LEAN_RATE.cross(CENTER_FROM_CONTACT)))
    return m * acceleration.applyfunc(near_collision)


def heuristic_moment():
    arm = -on_yawed(CENTER_FROM_CONTACT).subs(phi, 0)
    return arm.cross(heuristic_force())


def printed_heuristic_moment():
    return sp.Matrix([-(H**2) * SWING, -(R**2 * phi_ddot + H**2 * PULL), -R * H * SWING])


def test_heuristic_momentum_rate_and_acceleration_are_printed_right():
    assert vanishes(on_yawed(LEAN_RATE) - sp.Matrix([-phi * psi_dot, phi_dot, 0]))
    assert vanishes(on_yawed(A * rate(LEAN_RATE)) - A * sp.Matrix([-SWING, PULL, 0]))
    assert vanishes(heuristic_force() - m * sp.Matrix([H * PULL, H * SWING, R * phi_ddot]))


def test_heuristic_equations_are_those_of_the_small_tilt():
    # No slip. Along e_z the lean has no momentum at all, so H S = 0 again.
    balance = on_yawed(A * rate(LEAN_RATE)) - heuristic_moment()
    assert vanishes(balance[0] + K * SWING)
    assert vanishes(balance[1] - (J * phi_ddot - K * phi * psi_dot**2))
    # No friction.
    sliding = on_yawed(A * rate(LEAN_RATE)) + sp.Matrix([0, m * R**2 * phi_ddot, 0])
    assert vanishes(sliding[0] + A * SWING)
    assert vanishes(sliding[1] - ((A + m * R**2) * phi_ddot - A * phi * psi_dot**2))
    # S = 0 is Eq. (noslip1), and integrates to psi_dot phi2 constant.
    assert vanishes(rate(phi**2 * psi_dot) - phi * SWING)


def test_erratum_heuristic_moment_lacks_the_mass():
    right, printed = heuristic_moment(), printed_heuristic_moment()
    assert vanishes(right[1] - m * printed[1])
    assert not vanishes(right[1] - printed[1])
    assert vanishes(right.diff(m) * m - right)  # every term of a moment of m a has the mass


def test_erratum_heuristic_moment_has_two_signs_wrong():
    right, printed = heuristic_moment(), m * printed_heuristic_moment()
    assert vanishes((right[0] + printed[0], right[1] - printed[1], right[2] + printed[2]))
    assert not vanishes(right[0] - printed[0])
    assert not vanishes(right[2] - printed[2])
    # Right, yaw obeys (A + mH2) S = 0; printed, (A - mH2) S = 0, which says nothing if A = mH2.
    momentum_rate = on_yawed(A * rate(LEAN_RATE))
    assert vanishes((momentum_rate - right)[0] + K * SWING)
    assert vanishes((momentum_rate - printed)[0] + (A - m * H**2) * SWING)


def test_erratum_heuristic_capital_m_is_the_mass():
    capital_m = sp.symbols("M", positive=True)
    force = m * near_collision(rate(rate(z)))  # m z_G_ddot, gravity neglected
    arm = -on_yawed(CENTER_FROM_CONTACT).subs(phi, 0)
    moment = arm.cross(sp.Matrix([0, 0, force]))
    assert vanishes(moment - sp.Matrix([0, -m * R**2 * phi_ddot, 0]))
    assert not vanishes(moment - sp.Matrix([0, -capital_m * R**2 * phi_ddot, 0]))


def test_erratum_heuristic_section_flips_the_sign_of_the_tilt():
    # The body leans about -e_y1 in the rest of the paper and about +e_y1 here.
    small_omega = on_yawed(psi_dot * phi * e_x1 - phi_dot * e_y1)
    small_tilt = {sp.sin(phi): phi, sp.cos(phi): 1}
    exact = on_yawed(w * e_x2 - phi_dot * e_y2).subs(small_tilt)
    assert vanishes((exact - small_omega)[:2])
    assert not vanishes((on_yawed(LEAN_RATE) - small_omega)[:2])
    center = on_yawed(r_PG).subs(small_tilt)
    assert not vanishes(on_yawed(CENTER_FROM_CONTACT) - center)
    # They are one lean seen from a yaw half a turn apart, so that no turn depends on it.
    half_turn = ne.turned(2, sp.pi)
    assert vanishes((half_turn * on_yawed(LEAN_RATE) - small_omega)[:2])
    assert vanishes(half_turn * on_yawed(CENTER_FROM_CONTACT) - center)


# Rounded numbers of the text


def test_erratum_homogeneous_disk_turns_42_degrees_more_than_once():
    k = sp.sqrt(sp.Rational(1, 2))
    disk = {H: 0, A: m * R**2 * k**2 / 2}
    for law in LAWS:
        K_law = K_OF[law].subs(disk)
        turn = sp.pi * sp.sqrt((K_law + m * R**2) / K_law)
        assert sp.simplify(turn - sp.pi * sp.sqrt(2 + k**2) / k) == 0
        assert sp.simplify(turn - sp.pi * sp.sqrt(5)) == 0
    more = 180 * np.sqrt(5) - 360
    assert more == pytest.approx(42.49, abs=5e-3)
    assert round(more) != 41
    # The print uses 2.23 pi, which is sqrt(5) pi truncated instead of rounded.
    assert round(180 * 2.23 - 360) == 41


def test_erratum_frictionless_can_turns_221_degrees():
    turn = np.degrees(can_value(sp.pi * sp.sqrt((A + m * R**2) / A)))
    assert turn == pytest.approx(220.97, abs=5e-3)
    assert round(turn) == 221  # "about 220", and so about 41 from straight over, not 40
    assert round(turn - 180) == 41
    assert round(np.degrees(can_value(sp.pi * sp.sqrt(J / K)))) == 202  # printed right
