"""Newton and Euler for an axisymmetric body on its rim, in symbols: nothing here is from a paper.

Vectors are columns in the inertial axes. A quantity is an expression in the Euler angles and their
first two derivatives, each a plain symbol; `rate` is d/dt by the chain rule. The yaw drops out of
every result, so after all differentiation the inertial axes may be laid along e_x1, e_y1, e_z.
"""

from types import SimpleNamespace

import sympy as sp

m, R, A, C, g = sp.symbols("m R A C g", positive=True)
H = sp.symbols("H", nonnegative=True)
BODY = SimpleNamespace(mass=m, radius=R, height=H, transverse_inertia=A, axial_inertia=C)

psi, phi, theta = sp.symbols("psi phi theta", real=True)
RATES = psi_dot, phi_dot, theta_dot = sp.symbols("psi_dot phi_dot theta_dot", real=True)
ACCELERATIONS = sp.symbols("psi_ddot phi_ddot theta_ddot", real=True)
psi_ddot, phi_ddot, theta_ddot = ACCELERATIONS

s = theta_dot + psi_dot * sp.cos(phi)
w = psi_dot * sp.sin(phi)
l = psi_dot * sp.sin(phi) ** 2
rho = R * sp.cos(phi) - H * sp.sin(phi)
z = R * sp.sin(phi) + H * sp.cos(phi)
K = A + m * H**2
J = K + m * R**2
D = K * C + m * R**2 * A


def rate(quantity, accelerations=ACCELERATIONS):
    """d/dt of a scalar or a vector; pass a law's accelerations to take it along a motion."""
    chain = zip((psi, phi, theta, *RATES), (*RATES, *accelerations), strict=True)
    return sum((quantity.diff(q) * q_dot for q, q_dot in chain), start=0 * quantity)


def turned(axis, angle):
    """The matrix that turns a vector about e_x, e_y or e_z (axis 0, 1, 2) by `angle`."""
    cos, sin = sp.cos(angle), sp.sin(angle)
    i, j = (axis + 1) % 3, (axis + 2) % 3
    matrix = sp.eye(3)
    matrix[i, i], matrix[i, j], matrix[j, i], matrix[j, j] = cos, -sin, sin, cos
    return matrix


YAWED = turned(2, psi)
TILTED = YAWED * turned(1, -phi)
SPUN = TILTED * turned(2, theta)
e_x1, e_y1, e_z = (YAWED[:, i] for i in range(3))
e_x2, e_y2, e_z2 = (TILTED[:, i] for i in range(3))

r_PG = R * e_x2 + H * e_z2
OMEGA = psi_dot * e_z - phi_dot * e_y1 + theta_dot * e_z2
# I_G = A 1 + (C - A) e_z2 e_z2 whatever the spin angle: that is what axisymmetric means.
ANGULAR_MOMENTUM = A * OMEGA + (C - A) * OMEGA.dot(e_z2) * e_z2
ROLLING_VELOCITY = OMEGA.cross(r_PG)
SLIDING_VELOCITY = rate(r_PG.dot(e_z)) * e_z


def contact_force(center_velocity):
    """Newton: what the table must do to the body for G to move so."""
    return m * rate(center_velocity) + m * g * e_z


def moment(force):
    """The moment about G of a force at the contact point."""
    return -r_PG.cross(force)


def euler_residual(force):
    """H_dot - M on (e_x2, e_y2, e_z2): zero along every motion."""
    return on_tilted(rate(ANGULAR_MOMENTUM) - moment(force))


def on_yawed(vector):
    """Components on (e_x1, e_y1, e_z)."""
    return sp.Matrix(vector).subs(psi, 0)


def on_tilted(vector):
    """Components on (e_x2, e_y2, e_z2)."""
    return turned(1, phi) * on_yawed(vector)


def vanishes(expression):
    """Whether an expression, rational in sin and cos of the tilt, is identically zero: a proof.

    What is left of its numerator after sin2 = 1 - cos2, a + b sin, is zero only if a and b are.
    """
    if isinstance(expression, sp.MatrixBase | tuple | list):
        return all(vanishes(entry) for entry in expression)
    sine, cosine = sp.symbols("sine cosine")
    expression = sp.expand_trig(sp.sympify(expression))
    expression = expression.subs({sp.sin(phi): sine, sp.cos(phi): cosine})
    numerator = sp.expand(sp.numer(sp.together(expression)))
    return sp.rem(numerator, sine**2 + cosine**2 - 1, sine) == 0


def near_collision(quantity):
    """The limit of eps x quantity in the near collision, the part of it that grows like 1/eps.

    There tilt ~ eps, its rate ~ 1 and its acceleration ~ 1/eps; yaw and spin turn at rates ~ 1/eps,
    with accelerations ~ 1/eps2.
    """
    eps = sp.symbols("epsilon", positive=True)
    scaled = sp.expand_trig(sp.sympify(quantity)).subs(
        {
            phi: eps * phi,
            psi_dot: psi_dot / eps,
            theta_dot: theta_dot / eps,
            phi_ddot: phi_ddot / eps,
            psi_ddot: psi_ddot / eps**2,
            theta_ddot: theta_ddot / eps**2,
        },
        simultaneous=True,
    )
    # These Taylor terms are enough: the accelerations bring back no more than 1/eps2.
    sine, cosine = eps * phi - (eps * phi) ** 3 / 6, 1 - (eps * phi) ** 2 / 2
    scaled = scaled.subs({sp.sin(eps * phi): sine, sp.cos(eps * phi): cosine})
    over, under = (sp.Poly(part, eps) for part in sp.fraction(sp.together(eps * scaled)))
    if over.is_zero:
        return sp.S.Zero
    # The ratio of the lowest terms; a power of eps left over makes it zero or infinite.
    power = over.monoms()[-1][0] - under.monoms()[-1][0]
    return over.coeffs()[-1] / under.coeffs()[-1] * sp.S.Zero**power
