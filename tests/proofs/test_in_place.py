"""Wobbling in place, from Newton and Euler alone: the equations of the law ``in_place``.

The rim rolls without slip and θ = −ψ. The table exerts a force on the rim and a moment that does no
work on the rotations that are left.
"""

import pytest
import sympy as sp

from oracles import newton_euler as ne
from oracles.newton_euler import (
    ANGULAR_MOMENTUM,
    OMEGA,
    ROLLING_VELOCITY,
    A,
    C,
    H,
    J,
    K,
    R,
    e_x1,
    e_y1,
    e_z,
    g,
    m,
    on_yawed,
    phi,
    phi_ddot,
    phi_dot,
    psi_ddot,
    psi_dot,
    rho,
    theta_ddot,
    theta_dot,
    vanishes,
    z,
)

a_1, a_2 = sp.symbols("a_1 a_2", real=True)  # the table's acceleration along e_x1 and e_y1
sin, cos = sp.sin(phi), sp.cos(phi)
half_tangent = sin / (1 + cos)

INERTIA = A * sin**2 + C * (1 - cos) ** 2 + m * (R - rho) ** 2
E = K * (1 + cos) + (C + m * R**2) * (1 - cos) + 2 * m * H * R * sin


def in_place(quantity):
    """A quantity of a body that is held in its place."""
    return quantity.subs({theta_dot: -psi_dot, theta_ddot: -psi_ddot})


FORCE = in_place(m * (ne.rate(ROLLING_VELOCITY) + g * e_z + a_1 * e_x1 + a_2 * e_y1))
ABOUT_G = on_yawed(in_place(ne.rate(ANGULAR_MOMENTUM)) - ne.moment(FORCE))
"""What the reaction's moment must be, on (e_x1, e_y1, e_z)."""
AXIS = sp.Matrix([1, 0, half_tangent])
"""The body rotates about this and about e_y1."""


def along_the_motion():
    """The accelerations for which the reaction does no work."""
    residual = [ABOUT_G[1], (AXIS.T * ABOUT_G)[0]]
    return sp.solve(residual, (phi_ddot, psi_ddot), dict=True)[0]


MOTION = along_the_motion()


def test_the_rotations_that_are_left():
    omega = on_yawed(in_place(OMEGA))
    assert vanishes(omega - psi_dot * sin * AXIS + phi_dot * sp.Matrix([0, 1, 0]))


def test_the_equations_are_those_of_the_lagrangian():
    slope = INERTIA.diff(phi)
    tilting = (slope * psi_dot**2 / 2 - m * g * rho + m * z * a_1) / J
    assert vanishes(MOTION[phi_ddot] - tilting)
    yawing = INERTIA * MOTION[psi_ddot] + slope * phi_dot * psi_dot
    assert vanishes(yawing - m * (R - rho) * a_2)


def test_the_tilt_accelerates_as_without_slip():
    free = ne.euler_residual(m * (ne.rate(ROLLING_VELOCITY) + g * e_z))
    (tilting,) = sp.solve(free[1], phi_ddot)
    assert vanishes(in_place(tilting) - MOTION[phi_ddot].subs(a_1, 0))


def test_the_reaction_is_nearly_vertical():
    reaction = ABOUT_G.subs(MOTION)
    assert vanishes(reaction[1])
    assert vanishes(reaction[0] + half_tangent * reaction[2])


@pytest.mark.parametrize("sign", [1, -1])
def test_the_moment_of_inertia_has_a_factor_that_is_never_zero(sign):
    assert vanishes(INERTIA - (1 - cos) * E)
    # E is a quadratic form in cos(φ/2) and sin(φ/2), with this determinant over 4.
    determinant = K * (C + m * R**2) - (m * H * R) ** 2
    assert sp.expand(determinant - (C * K + m * R**2 * A)) == 0
    assert E.subs(phi, (1 - sign) * sp.pi / 2) == 2 * (K if sign == 1 else C + m * R**2)


def test_the_rates_with_respect_to_tau():
    """`law/in_place.rs` has the rates of w = ψ̇ sin φ and s = −ψ̇ (1 − cos φ) with (a₁, a₂)."""
    w, s = psi_dot * sin, -psi_dot * (1 - cos)
    rate = [sin * ne.rate(quantity).subs(MOTION) for quantity in (w, s)]
    lever = R * sin + H * (1 + cos)
    arm = R * (1 - cos) + H * sin
    shaking = m * sin * a_2 / E
    of_cos, of_sin = K - C - m * R**2, 2 * m * H * R
    growth = phi_dot * sin * (of_cos * sin - of_sin * cos) / E
    dw = w * (growth - phi_dot) + lever * shaking
    ds = s * growth - arm * shaking
    assert vanishes(rate[0] - dw)
    assert vanishes(rate[1] - ds)
    across = m * (R * ds - H * dw) - m * w * z * phi_dot + m * sin * a_2
    assert vanishes(sin * on_yawed(FORCE).subs(MOTION)[1] - across)


def test_applied_moments_turn_the_inertia_of_w():
    """L_x about e_x2 and L_z about e_z2 do the work L_x w + L_z s on w alone."""
    w_dot, L_x, L_z = sp.symbols("w_dot L_x L_z")
    spin = -half_tangent
    inertia = INERTIA / sin**2
    assert vanishes(inertia - E / (1 + cos))
    (found,) = sp.solve(inertia * w_dot - (L_x + spin * L_z), w_dot)
    assert vanishes(found - ((1 + cos) * L_x - sin * L_z) / E)
    assert vanishes(spin * found + (sin * L_x - (1 - cos) * L_z) / E)


def test_the_limit_of_the_turn_is_that_without_slip():
    """As φ → 0, J φ̇² + I ψ̇² is constant, with I = K φ² and I ψ̇ constant: ψ = √(J/K) arctan."""
    assert sp.limit(INERTIA / phi**2, phi, 0) == sp.expand(K)
