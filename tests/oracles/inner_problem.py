"""The near collision with Coulomb friction in the limit of no yaw at the start, an oracle.

As the least tilt goes to zero, gravity and the gyroscopic terms drop out of the near collision.
What is left has no scale: the lean q = tilt e, a vector in the plane of the table along the
direction e of the yaw, the horizontal velocity v of the center of mass and the spin s about the
axis obey

    A q_ddot = -N R e + H T,   m v_dot = T,   C s_dot = -R T.e_y,   N = m R d2|q|/dt2

with the slip u = v + H q_dot - R s e_y. Everything is kept in the inertial plane and in the clock
tau, dt = |q| dtau, which makes the arrival from afar and the leaving exponentials; a force times
|q| is then finite. The lean arrives along a line that misses the origin by a small fraction of the
tilt where the integration begins, and leaves along another: the yaw between the two is the turn.
A force grows no slower than the sideways rate w = |q| yaw_rate, like its square if there is no
spin, so that cutting the lines where w/omega = 1e-10 leaves errors of that order at most.

A `body` has mass, radius, height, transverse_inertia, axial_inertia, in SI units.
"""

from dataclasses import dataclass

import numpy as np
from scipy.integrate import solve_ivp

from oracles.rigid_body import crossing, ending

# Where the arriving line is picked up and the leaving one dropped: w/omega, and how precisely.
MISS = 1e-10
RTOL, ATOL = 1e-13, 1e-20
# Slips relative to that of a swing about the rim: one to begin a slide with (it forgets a wrong
# start but for its size), and one from which the direction of the slip, which relaxes at a rate
# like 1/|u|, is not stiff; one that begins to stop, and one that has stopped but for a last step.
FIRST_SLIP, STIFF_SLIP, SLOW_SLIP, LAST_SLIP = 1e-13, 1e-5, 1e-6, 1e-13
LEAN, LEAN_RATE, SLIP, SPIN, YAW = slice(0, 2), slice(2, 4), slice(4, 6), 6, 7


@dataclass(frozen=True)
class Departure:
    """How a near collision ends: turn (rad), rates (rad/s) and slip on the new e_x1, e_y1 (m/s)."""

    turn: float
    tilt_rate: float
    spin_rate: float
    slip: np.ndarray
    phases: tuple


def near_collision(body, friction, slip=0.0, spin=0.0, omega=1.0):
    """The turn and the departure of a body that arrives at zero tilt with tilt rate -omega.

    `slip` (m/s) is the arriving slip, along e_x1, and `spin` (rad/s) the arriving rotation about
    the axis; yaw increases. `friction` inf is a rim that cannot slip.
    """
    phase, y = _arrival(body, friction, slip, spin, omega)
    phases = [phase]
    while True:
        event, y = _follow(body, friction, omega, phase, y)
        if event is None:
            raise ArithmeticError("the near collision does not end")
        if event == "left":
            return _departure(y, tuple(phases))
        phase, y = _next_phase(body, friction, omega, event, y)
        phases.append(phase)


def tipping(body, friction, tilt, tilt_rate, gravity=9.8):
    """(omega, slip): tilt rate and slip at zero tilt of a body let go at rest on its rim, no yaw.

    Planar Newton-Euler: a mass whose foot G stands rho from the contact point P, z over it.
    """
    y, sign = np.array([tilt, tilt_rate, 0.0]), None
    _, _, T, N = _planar_acceleration(body, friction, None, y, gravity)
    if abs(T) > friction * N:
        sign = -np.sign(T)
    while True:
        end, y = _follow_tipping(body, friction, sign, y, gravity)
        if end == "flat":
            return -y[1], y[2]
        if end != "changed":
            raise ArithmeticError("the rim does not stay on the table down to zero tilt")
        starts, y[2] = sign is None, 0.0
        _, _, T, N = _planar_acceleration(body, friction, None, y, gravity)
        # The slip starts against the friction that held it; what stops may stick or turn round.
        sign = -np.sign(T) if starts or abs(T) > friction * N else None


def turn_after_tipping(body, friction, tilt, tilt_rate, gravity=9.8):
    """The limiting turn of a body let go at rest on its rim, without yaw but for a trace."""
    omega, slip = tipping(body, friction, tilt, tilt_rate, gravity)
    return near_collision(body, friction, slip, 0.0, omega).turn


def _rates(body, friction, phase, y):
    """d/dtau of everything, with |q| times the contact force on (e, e_y, e_z) beside it."""
    m, R, H, A, C = _symbols(body)
    q_dot, u, s = y[LEAN_RATE], y[SLIP], y[SPIN]
    tilt = np.hypot(*y[LEAN])
    e = y[LEAN] / tilt
    e_y = np.array([-e[1], e[0]])
    w = e_y @ q_dot
    # The slip's rate for a friction T: T/m + H q_ddot - R s_dot e_y + R s yaw_rate e.
    on_x = np.array([1 / m + H**2 / A, 0.0, -H * R / A])
    on_y = np.array([0.0, 1 / m + H**2 / A + R**2 / C, 0.0])
    turning = R * s * w
    # N = m R (e.q_ddot + w yaw_rate).
    pressing = np.array([-m * R * H / A, 0.0, 1 + m * R**2 / A])
    if phase == "stick":
        force = np.linalg.solve([on_x, on_y, pressing], [-turning, 0.0, m * R * w**2])
    else:
        slip = np.hypot(*u) if friction else 1.0
        against = -friction * np.array([u @ e, u @ e_y]) / slip
        per_normal = np.array([*against, 1.0])
        if pressing @ per_normal <= 0.0:
            raise ArithmeticError("the sliding rim jams: no force keeps it on the table")
        force = per_normal * (m * R * w**2 / (pressing @ per_normal))
    T = force[0] * e + force[1] * e_y
    q_ddot = (H * T - R * force[2] * e) / A
    u_dot = (on_x @ force + turning) * e + (on_y @ force) * e_y
    if phase == "stick":
        u_dot = np.zeros(2)
    return np.array([*tilt * q_dot, *q_ddot, *u_dot, -R * force[1] / C, w]), force


def _arrival(body, friction, slip, spin, omega):
    """The phase and the state on the arriving line, which runs along -e_x past the origin."""
    y = np.zeros(8)
    y[LEAN], y[LEAN_RATE], y[SPIN], y[YAW] = (1.0, MISS), (-omega, 0.0), spin, np.arctan(MISS)
    if np.isinf(friction):
        return "stick", y
    # v and s have not changed on the line: what slips is what e_y has turned since.
    e = np.array([1.0, MISS]) / np.hypot(1.0, MISS)
    y[SLIP] = slip, 0.0
    y[SLIP] += body.radius * spin * (np.array([0.0, 1.0]) - [-e[1], e[0]])
    if slip or spin:
        return "slide", y
    if friction and _cone(body, friction, y) >= 0.0:
        return "stick", y
    # A slip from rest grows like the force that drives it, like w^2 = e^(2 omega tau).
    y[SLIP] = -e
    y[SLIP] = _rates(body, friction, "slide", y)[0][SLIP] / (2 * omega)
    return "slide", y


def _cone(body, friction, y):
    """friction N - |T| of the rim if it sticks (times |q|): negative where it cannot."""
    *T, N = _rates(body, friction, "stick", y)[1]
    return friction * N - np.hypot(*T)


def _follow(body, friction, omega, phase, y):
    """Run a phase to its end: (what ends it, the state there)."""
    slip_unit = omega * np.hypot(body.radius, body.height)
    events = _events(body, friction, slip_unit, phase)
    solution = solve_ivp(
        lambda _, y: _rates(body, friction, "stick" if phase == "stick" else "slide", y)[0],
        (0.0, 1e4 / omega),
        y,
        method="Radau" if phase == "onset" else "DOP853",
        rtol=RTOL,
        atol=ATOL * np.array([1.0, 1.0, omega, omega, slip_unit, slip_unit, omega, 1.0]),
        events=events,
    )
    return ending(solution, events), solution.y[:, -1]


def _events(body, friction, slip_unit, phase):
    def sideways(y):
        """How far from the leaving line, where w is MISS times the tilt rate."""
        q_dot, q = y[LEAN_RATE], y[LEAN]
        return abs(q[0] * q_dot[1] - q[1] * q_dot[0]) - MISS * (q @ q_dot)

    def slip(y):
        return np.hypot(*y[SLIP]) / slip_unit

    left = crossing("left", -1, sideways)
    if friction in (0.0, np.inf):
        return [left]
    if phase == "stick":
        return [left, crossing("slipped", -1, lambda y: _cone(body, friction, y))]
    stopped = crossing("stopped", -1, lambda y: slip(y) / LAST_SLIP - 1)
    others = {
        "onset": crossing("soft", 1, lambda y: slip(y) / STIFF_SLIP - 1),
        "slide": crossing("slow", -1, lambda y: slip(y) / SLOW_SLIP - 1),
        "stopping": crossing("quick", 1, lambda y: slip(y) / SLOW_SLIP - 2),
    }
    return [left, stopped, others[phase]]


def _next_phase(body, friction, omega, event, y):
    y = y.copy()
    if event in ("soft", "quick", "slow"):
        return "stopping" if event == "slow" else "slide", y
    if event == "stopped":
        y_dot, _ = _rates(body, friction, "slide", y)
        y -= y_dot * (y[SLIP] @ y[SLIP]) / (y[SLIP] @ y_dot[SLIP])
    if event == "stopped" and _cone(body, friction, y) >= 0.0:
        y[SLIP] = 0.0
        return "stick", y
    # From rest, the slip starts against the friction that would have held it.
    T_x, T_y, _ = _rates(body, friction, "stick", y)[1]
    e = y[LEAN] / np.hypot(*y[LEAN])
    against = -(T_x * e + T_y * np.array([-e[1], e[0]])) / np.hypot(T_x, T_y)
    y[SLIP] = FIRST_SLIP * omega * np.hypot(body.radius, body.height) * against
    return "onset", y


def _departure(y, phases):
    q, q_dot = y[LEAN], y[LEAN_RATE]
    p, w = (q @ q_dot) / np.hypot(*q), (q[0] * q_dot[1] - q[1] * q_dot[0]) / np.hypot(*q)
    # On the leaving line the yaw still goes from the direction of q to that of q_dot.
    e = q_dot / np.hypot(*q_dot)
    slip = np.array([y[SLIP] @ e, y[SLIP] @ [-e[1], e[0]]])
    return Departure(y[YAW] + np.arctan2(w, p), p, y[SPIN], slip, phases)


def _planar_acceleration(body, friction, sign, y, gravity):
    """(tilt_ddot, slip_dot, T, N) of a rim that sticks (sign None) or slides the way of `sign`."""
    m, R, H, A, _ = _symbols(body)
    phi, p, _ = y
    rho, z = R * np.cos(phi) - H * np.sin(phi), R * np.sin(phi) + H * np.cos(phi)
    # Unknown tilt_ddot, T, N: turning about G, the foot's height, and how the friction comes about.
    turning = ([A, -z, rho], 0.0)
    lifting = ([-m * rho, 0.0, 1.0], m * (gravity - z * p**2))
    if sign is None:
        friction_law = ([z, 1 / m, 0.0], -rho * p**2)
    else:
        friction_law = ([0.0, 1.0, friction * sign], 0.0)
    matrix, right = zip(turning, lifting, friction_law, strict=True)
    p_dot, T, N = np.linalg.solve(matrix, right)
    return p_dot, T / m + rho * p**2 + z * p_dot, T, N


def _follow_tipping(body, friction, sign, y, gravity):
    """Fall until zero tilt, until sticking or the sense of the slip ends, or until lift-off."""

    def acceleration(y):
        return _planar_acceleration(body, friction, sign, y, gravity)

    def rates(_, y):
        p_dot, u_dot, _, _ = acceleration(y)
        return y[1], p_dot, 0.0 if sign is None else u_dot

    def lasts(y):
        if sign is not None:
            # Just over nothing, so that a slip that starts from nothing is not its own end.
            return y[2] * sign + 1e-14
        _, _, T, N = acceleration(y)
        return friction * N - abs(T)

    events = [
        crossing("flat", -1, lambda y: y[0]),
        crossing("changed", -1, lasts),
        crossing("lifted", -1, lambda y: acceleration(y)[3]),
    ]
    solution = solve_ivp(
        rates, (0.0, 100.0), y, method="DOP853", rtol=RTOL, atol=1e-16, events=events
    )
    return ending(solution, events), solution.y[:, -1].copy()


def _symbols(body):
    return (
        body.mass,
        body.radius,
        body.height,
        body.transverse_inertia,
        body.axial_inertia,
    )
