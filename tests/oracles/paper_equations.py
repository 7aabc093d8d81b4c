"""The printed equations of Srinivasan & Ruina (2007), an oracle that shares nothing with rimroll.

Srinivasan & Ruina, "Rocking and rolling: a can that appears to rock might actually roll".
The symbols are the paper's: psi is yaw, phi tilt, theta spin, and a suffix _dot is a rate. The
transcriptions take `xp`, the module that supplies sin and cos, so that the very same lines are
integrated in numbers (math, numpy) and proved from Newton-Euler in symbols (sympy).

A `body` has mass, radius, height, transverse_inertia, axial_inertia (kg, m, m, kg m2, kg m2); a
`start` has tilt, tilt_rate, yaw, yaw_rate, spin, spin_rate (rad, rad/s). A `law` is "no_slip" or
"frictionless".
"""

import math
from dataclasses import dataclass

import numpy as np
from scipy.integrate import solve_ivp


def no_slip(body, phi, psi_dot, phi_dot, theta_dot, gravity, xp=math):
    """Q and S of Q (psi_ddot, phi_ddot, theta_ddot) = S, Eq. (noslip_eqs)."""
    m, R, H, A, C, g = *_symbols(body), gravity
    sin, cos = xp.sin, xp.cos
    Q = (
        (A * sin(phi) - m * H * R * cos(phi) + m * H**2 * sin(phi), 0, -m * H * R),
        (0, -m * R**2 - m * H**2 - A, 0),
        (C * cos(phi) + m * R**2 * cos(phi) - m * R * H * sin(phi), 0, C + m * R**2),
    )
    S = (
        (C - 2 * A - 2 * m * H**2) * psi_dot * phi_dot * cos(phi)
        + C * phi_dot * theta_dot
        - 2 * m * H * R * psi_dot * phi_dot * sin(phi),
        (C - A + m * R**2 - m * H**2) * psi_dot**2 * sin(2 * phi) / 2
        + (C + m * R**2) * theta_dot * psi_dot * sin(phi)
        + m * H * R * psi_dot * theta_dot * cos(phi)
        + m * H * R * psi_dot**2 * cos(2 * phi)
        + m * g * (R * cos(phi) - H * sin(phi)),
        C * psi_dot * phi_dot * sin(phi)
        + 2 * m * R * psi_dot * phi_dot * (R * sin(phi) + H * cos(phi)),
    )
    return Q, S


def frictionless(body, phi, psi_dot, phi_dot, theta_dot, gravity, xp=math):
    """Q and S of Q (psi_ddot, phi_ddot, theta_ddot) = S, Eq. (nofric_eqs)."""
    m, R, H, A, C, g = *_symbols(body), gravity
    sin, cos = xp.sin, xp.cos
    Q = (
        (A * sin(phi), 0, 0),
        (
            0,
            -A + m * H * R * sin(2 * phi) - m * H**2 * sin(phi) ** 2 - m * R**2 * cos(phi) ** 2,
            0,
        ),
        (C * cos(phi), 0, C),
    )
    S = (
        -2 * A * psi_dot * phi_dot * cos(phi)
        + C * phi_dot * theta_dot
        + C * phi_dot * psi_dot * cos(phi),
        (C - A) * psi_dot**2 * sin(2 * phi) / 2
        + C * theta_dot * psi_dot * sin(phi)
        + m * g * R * cos(phi)
        - m * g * H * sin(phi)
        - m * H * R * phi_dot**2 * cos(2 * phi)
        + m * (H**2 - R**2) * phi_dot**2 * sin(2 * phi) / 2,
        C * psi_dot * phi_dot * sin(phi),
    )
    return Q, S


LAWS = {"no_slip": no_slip, "frictionless": frictionless}


def angular_accelerations(body, law, phi, psi_dot, phi_dot, theta_dot, gravity, xp=math):
    """(psi_ddot, phi_ddot, theta_ddot), in rad/s2, from the printed Q and S."""
    Q, S = LAWS[law](body, phi, psi_dot, phi_dot, theta_dot, gravity, xp)
    # Tilt stands alone in both laws; Cramer's rule for yaw and spin also serves arrays.
    determinant = Q[0][0] * Q[2][2] - Q[0][2] * Q[2][0]
    psi_ddot = (S[0] * Q[2][2] - Q[0][2] * S[2]) / determinant
    theta_ddot = (Q[0][0] * S[2] - S[0] * Q[2][0]) / determinant
    return psi_ddot, S[1] / Q[1][1], theta_ddot


def center_acceleration_no_slip(body, phi, rates, accelerations, xp=math):
    """a_G of a rolling body on (e_x2, e_y2, e_z2), as appendix A prints it."""
    _, R, H, _, _ = _symbols(body)
    sin, cos = xp.sin, xp.cos
    psi_dot, phi_dot, theta_dot = rates
    psi_ddot, phi_ddot, theta_ddot = accelerations
    return (
        -H * phi_ddot
        - R * phi_dot**2
        - R * psi_dot * cos(phi) * theta_dot
        - R * psi_dot**2 * cos(phi) ** 2
        + H * psi_dot**2 * cos(phi) * sin(phi),
        -2 * R * psi_dot * phi_dot * sin(phi)
        - 2 * H * psi_dot * phi_dot * cos(phi)
        + R * psi_ddot * cos(phi)
        - H * psi_ddot * sin(phi)
        + R * theta_ddot,
        R * phi_ddot
        + R * psi_dot * theta_dot * sin(phi)
        + R * psi_dot**2 * sin(phi) * cos(phi)
        - H * psi_dot**2 * sin(phi) ** 2
        - H * phi_dot**2,
    )


def center_acceleration_frictionless(body, phi, rates, accelerations, xp=math):
    """a_G of a sliding body on (e_x2, e_y2, e_z2), as appendix A prints it: vertical."""
    _, R, H, _, _ = _symbols(body)
    sin, cos = xp.sin, xp.cos
    phi_dot, phi_ddot = rates[1], accelerations[1]
    lift = (R * cos(phi) - H * sin(phi)) * phi_ddot - (R * sin(phi) + H * cos(phi)) * phi_dot**2
    return sin(phi) * lift, 0, cos(phi) * lift


CENTER_ACCELERATIONS = {
    "no_slip": center_acceleration_no_slip,
    "frictionless": center_acceleration_frictionless,
}


def doubled_kinetic_energy(body, law, phi, psi_dot, phi_dot, theta_dot, xp=math):
    """2T of appendix B, with the dot that its frictionless C (theta_dot + psi cos phi)^2 lacks."""
    m, R, H, A, C = _symbols(body)
    sin, cos = xp.sin, xp.cos
    about_axis = C * (theta_dot + psi_dot * cos(phi)) ** 2
    across_axis = A * phi_dot**2 + A * psi_dot**2 * sin(phi) ** 2
    if law == "no_slip":
        of_center = (
            m * phi_dot**2 * (H**2 + R**2)
            + m * (R * theta_dot + R * psi_dot * cos(phi) - H * psi_dot * sin(phi)) ** 2
        )
    else:
        of_center = m * phi_dot**2 * (R * cos(phi) - H * sin(phi)) ** 2
    return of_center + across_axis + about_axis


@dataclass(frozen=True)
class States:
    """Instants of a motion; every field is an array over them (s, rad, rad/s)."""

    t: np.ndarray
    psi: np.ndarray
    phi: np.ndarray
    theta: np.ndarray
    psi_dot: np.ndarray
    phi_dot: np.ndarray
    theta_dot: np.ndarray

    def __len__(self):
        return len(self.t)


@dataclass(frozen=True)
class PaperMotion(States):
    """The accepted steps of a motion, its tilt extrema, and any instant between: motion(t)."""

    minima: States
    maxima: States
    _dense: object

    def __call__(self, t):
        t = np.atleast_1d(np.asarray(t, dtype=float))
        return States(t, *self._dense(t))


@dataclass(frozen=True)
class ContactForce:
    """What the table does to the body (N): normal, and friction on (e_x1, e_y1) and (e_x, e_y)."""

    normal: np.ndarray
    friction: np.ndarray
    friction_in_world: np.ndarray

    @property
    def ratio(self):
        """|T| / N, the friction coefficient that the motion needs."""
        return np.hypot(*self.friction) / self.normal


def contact_force(body, states, law, gravity=9.8):
    """F_P = m a_G + m g e_z (appendix A), resolved; friction arrays have shape (2, len(states))."""
    rates = states.psi_dot, states.phi_dot, states.theta_dot
    accelerations = angular_accelerations(body, law, states.phi, *rates, gravity, np)
    x2, y2, z2 = CENTER_ACCELERATIONS[law](body, states.phi, rates, accelerations, np)
    sin, cos = np.sin(states.phi), np.cos(states.phi)
    # e_x2 = cos phi e_x1 + sin phi e_z and e_z2 = -sin phi e_x1 + cos phi e_z.
    x1 = body.mass * (cos * x2 - sin * z2)
    y1 = body.mass * (y2 + np.zeros_like(x1))
    normal = body.mass * (sin * x2 + cos * z2 + gravity)
    turn_sin, turn_cos = np.sin(states.psi), np.cos(states.psi)
    in_world = np.array([turn_cos * x1 - turn_sin * y1, turn_sin * x1 + turn_cos * y1])
    return ContactForce(normal, np.array([x1, y1]), in_world)


def energy(body, states, law, gravity=9.8):
    """E in joules at each instant, with the height of G over the table.

    Appendix B adds m g z_G to both of its 2E; that is half of what it should add. Here 2E = 2T +
    2 m g z_G.
    """
    doubled = doubled_kinetic_energy(
        body, law, states.phi, states.psi_dot, states.phi_dot, states.theta_dot, np
    )
    height = body.radius * np.sin(states.phi) + body.height * np.cos(states.phi)
    return doubled / 2 + body.mass * gravity * height


def integrate(body, start, law, duration, rtol=1e-12, gravity=9.8):
    """The motion from `start` for `duration` seconds, by the printed equations of `law`.

    The Euler angles lose about 1e-16 / (least tilt) of the rates to cancellation, which the step
    control sees as noise: turns are good to 1e-10 rad down to least tilts of 1e-6, to 1e-8 at 1e-7,
    and below that the integration stops and says so, unless `rtol` is relaxed.
    """

    def derivatives(_, y):
        _, phi, _, psi_dot, phi_dot, theta_dot = y.tolist()
        return (
            psi_dot,
            phi_dot,
            theta_dot,
            *angular_accelerations(body, law, phi, psi_dot, phi_dot, theta_dot, gravity),
        )

    def tilt_minimum(_, y):
        return y[4]

    def tilt_maximum(_, y):
        return y[4]

    tilt_minimum.direction, tilt_maximum.direction = 1, -1
    solution = solve_ivp(
        derivatives,
        (0.0, duration),
        (start.yaw, start.tilt, start.spin, start.yaw_rate, start.tilt_rate, start.spin_rate),
        method="DOP853",
        rtol=rtol,
        # Tilt falls to 1e-8 while the rates rise to 1e8: only relative accuracy has a meaning.
        atol=1e-6 * rtol,
        events=(tilt_minimum, tilt_maximum),
        dense_output=True,
    )
    if not solution.success:
        raise ArithmeticError(f"integration stopped at t = {solution.t[-1]} s: {solution.message}")
    minima, maxima = (
        States(t, *np.reshape(y, (-1, 6)).T)
        for t, y in zip(solution.t_events, solution.y_events, strict=True)
    )
    return PaperMotion(solution.t, *solution.y, minima, maxima, solution.sol)


def _symbols(body):
    return body.mass, body.radius, body.height, body.transverse_inertia, body.axial_inertia
