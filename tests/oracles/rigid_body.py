"""A body of revolution on the rim of its base in Newton and Euler's vectors, an oracle.

Nothing here comes from the paper and no equation of motion is written in Euler angles. A body is
where its frame points (a quaternion), where the lowest point of its rim is, how it turns (angular
velocity in the inertial frame) and how fast the material point of the rim is that is lowest now. In
contact that point is at height 0 and has no vertical velocity, and its acceleration
d/dt (v + Omega x r), r from G to it, is linear in the contact force: what the table does follows
from demanding a zero of it.

Where the base lies nearly flat the lowest point is ill defined: Cartesian coordinates serve tilts
down to some 1e-6 rad.

A `body` has mass, radius, height, transverse_inertia, axial_inertia (kg, m, m, kg m2, kg m2); a
`start` has tilt, tilt_rate, yaw, yaw_rate, spin, spin_rate (rad, rad/s). `follow` joins phases
("stick", "slide", "onset", "stopping", "flight"); an onset is the stiff beginning of a slide, and
a stopping its end, with a clock of its own that resolves it.
"""

from dataclasses import dataclass, field
from functools import cached_property

import numpy as np
from scipy.integrate import solve_ivp

# What `follow` integrates; the works are done on the body by the table and by the air (J).
TURN, RIM, OMEGA, VELOCITY = slice(0, 4), slice(4, 7), slice(7, 10), slice(10, 13)
YAW, SPIN, WORKS = 13, 14, slice(15, 19)
WORK_OF = ("friction", "rolling", "pivoting", "air")
E_Z, NOTHING, IDENTITY = np.array([0.0, 0.0, 1.0]), np.zeros(3), np.eye(3)

RTOL = 1e-12
# Slips in units of sqrt(g R): one to begin a slide with (it forgets a wrong start but for its
# size), and one from which the direction of the slip, which relaxes at a rate like 1/|u|, is not
# stiff; one that begins to stop, and one that has stopped but for a straight step.
FIRST_SLIP, STIFF_SLIP, SLOW_SLIP, LAST_SLIP = 1e-12, 1e-4, 1e-6, 1e-13
# How far under the table, in radii, what has lifted off lands: it rises from nothing, like t^3.
GRAZE = 1e-13
# A rim that lands more slowly, in units of sqrt(g R), stays.
MIN_BOUNCE = 1e-9
# Tilts (rad) at which a motion ends: nearly on the side, and too flat for a lowest point.
TOPPLED, FACE_DOWN = 1.5, 1e-7


# The laws of contact


@dataclass(frozen=True)
class Rolling:
    """The rim does not slip, however large the force."""

    unilateral: bool = False
    restitution: float = 0.0

    static_friction = landing_friction = np.inf


@dataclass(frozen=True)
class Coulomb:
    """|T| <= friction N at rest, T = -friction N u/|u| in slip; friction 0 is a greased table.

    `restitution` is Stronge's: its square is the part of the work of compression that comes back.
    """

    friction: float
    restitution: float = 0.0
    unilateral: bool = True

    @property
    def static_friction(self):
        return self.friction

    @property
    def landing_friction(self):
        return self.friction

    def friction_force(self, u):
        """T = free + N per_normal: (free, per_normal)."""
        return NOTHING, -self.friction * u / np.hypot(u[0], u[1]) if self.friction else NOTHING


@dataclass(frozen=True)
class DryCurve:
    """|T| <= static N at rest, T = -mu(|u|) N u/|u| in slip; a landing has the mu of its slip."""

    mu: object
    static_friction: float
    restitution: float = 0.0
    unilateral: bool = True

    def friction_force(self, u):
        speed = np.hypot(u[0], u[1])
        return NOTHING, -self.mu(speed) * u / speed


@dataclass(frozen=True)
class Viscous:
    """T = -coefficient u, with the coefficient in N s/m: nothing in the instant of a landing."""

    coefficient: float
    restitution: float = 0.0
    unilateral: bool = True

    static_friction = landing_friction = 0.0

    def friction_force(self, u):
        return -self.coefficient * u, NOTHING


@dataclass(frozen=True)
class Regularized:
    """T = -mu(|u|) N u/sqrt(u2 + v02), mu falling from `static` to `kinetic` (Stribeck)."""

    kinetic: float
    static: float
    stribeck_velocity: float
    smoothing_velocity: float
    restitution: float = 0.0
    unilateral: bool = True

    static_friction = 0.0

    def landing_friction(self, u):
        """What friction adds to a unit normal impulse: a law without a threshold sets it by u."""
        return self.friction_force(u)[1]

    def friction_force(self, u):
        squared = u @ u
        over = np.exp(-squared / self.stribeck_velocity**2)
        mu = self.kinetic + (self.static - self.kinetic) * over
        return NOTHING, -mu * u / np.sqrt(squared + self.smoothing_velocity**2)


@dataclass(frozen=True)
class Resistances:
    """What else resists while the rim is on the table; s1(x) = x/sqrt(x2 + smoothing2) is a sign.

    rolling (1) and rolling_viscosity (N s/m): Q = -(rolling N R s1(spin_rate sin tilt) +
    rolling_viscosity R2 spin_rate) works on the spin alone. pivoting (m): a vertical moment
    -pivoting N s1(Omega_z).
    air (W s^exponent): a moment across the axis in the plane of the tilt, of power
    -air |yaw_rate|^air_exponent.
    """

    rolling: float = 0.0
    rolling_viscosity: float = 0.0
    pivoting: float = 0.0
    air: float = 0.0
    air_exponent: float = 2.0
    smoothing: float = 1e-3

    def sign(self, x):
        return x / np.hypot(x, self.smoothing)

    def moments(self, body, at):
        """Rolling, pivoting, air: each a pair (free, per normal force) of vectors."""
        # A moment works on the spin alone if it is across e_z and e_y1: Q e_x1 / (e_x1.e_z2).
        of_spin = at.e_x1 / (at.e_x1 @ at.axis)
        rolling = -self.rolling * body.radius * self.sign(at.spin_rate * at.sin) * of_spin
        viscous = -self.rolling_viscosity * body.radius**2 * at.spin_rate * of_spin
        pivoting = -self.pivoting * self.sign(at.omega[2]) * E_Z
        air = np.zeros(3)
        if self.air and at.yaw_rate:
            drag = self.air * abs(at.yaw_rate) ** self.air_exponent
            air = -drag / (at.yaw_rate * at.sin) * at.e_x2
        return (viscous, rolling), (NOTHING, pivoting), (air, NOTHING)


NONE = Resistances()


# Kinematics


class Attitude:
    """Directions, arms and rates of a body at one instant, all in the inertial frame."""

    def __init__(self, body, y):
        w, i, j, k = (y[TURN] / np.sqrt(y[TURN] @ y[TURN])).tolist()
        self.omega = y[OMEGA]
        self.axis = n = np.array(
            (2 * (i * k + w * j), 2 * (j * k - w * i), w * w - i * i - j * j + k * k)
        )
        self.sin = np.hypot(n[0], n[1])
        # The steepest line of the base, upward; its lowest rim point is the other way.
        steep = np.array((-n[0] * n[2], -n[1] * n[2], self.sin**2))
        self.e_x2 = steep / self.sin
        self.e_x1 = np.array((-n[0], -n[1], 0.0)) / self.sin
        self.arm = -body.height * n - body.radius * self.e_x2
        n_dot = cross(self.omega, n)
        steep_dot = -n_dot[2] * n - n[2] * n_dot
        e_dot = (steep_dot - self.e_x2 * (self.e_x2 @ steep_dot)) / self.sin
        self.arm_dot = -body.height * n_dot - body.radius * e_dot
        # Omega = yaw_rate e_z - tilt_rate e_y1 + spin_rate e_z2.
        self.yaw_rate = (self.omega @ self.e_x2) / self.sin
        self.tilt_rate = -self.omega @ cross(E_Z, self.e_x1)
        self.spin_rate = self.omega @ n - self.yaw_rate * n[2]

    @property
    def tilt(self):
        return np.arctan2(self.sin, self.axis[2])


def cross(a, b):
    (a1, a2, a3), (b1, b2, b3) = a.tolist(), b.tolist()
    return np.array((a2 * b3 - a3 * b2, a3 * b1 - a1 * b3, a1 * b2 - a2 * b1))


def quaternion(yaw, tilt, spin):
    """The frame turned by yaw about e_z, then -tilt about e_y1, then spin about e_z2."""
    together, apart = (yaw + spin) / 2, (yaw - spin) / 2
    sin, cos = np.sin(-tilt / 2), np.cos(tilt / 2)
    return np.array(
        (
            cos * np.cos(together),
            -sin * np.sin(apart),
            sin * np.cos(apart),
            cos * np.sin(together),
        )
    )


def angular_velocity(start):
    """In the inertial frame (rad/s)."""
    sin, cos = np.sin(start.tilt), np.cos(start.tilt)
    e_x1 = np.array((np.cos(start.yaw), np.sin(start.yaw), 0.0))
    axis = -sin * e_x1 + cos * E_Z
    return start.yaw_rate * E_Z - start.tilt_rate * cross(E_Z, e_x1) + start.spin_rate * axis


def release(body, start, slip=(0.0, 0.0), contact=(0.0, 0.0), lift=0.0, lift_rate=0.0):
    """The state of a body let go in these Euler angles and rates.

    `slip` (m/s) is that of the material rim point, on e_x1 and e_y1, or "center at rest" for a
    center of mass that moves only vertically; `contact` (m) is where the lowest rim point is,
    `lift` its height (m) and `lift_rate` its vertical velocity.
    """
    y = np.zeros(19)
    y[TURN], y[OMEGA] = quaternion(start.yaw, start.tilt, start.spin), angular_velocity(start)
    y[RIM], y[YAW], y[SPIN] = (*contact, lift), start.yaw, start.spin
    at = Attitude(body, y)
    if isinstance(slip, str):
        y[VELOCITY] = cross(at.omega, at.arm)
    else:
        y[VELOCITY] = slip[0] * at.e_x1 + slip[1] * cross(E_Z, at.e_x1)
    y[VELOCITY][2] = lift_rate
    return y


# Dynamics


def inverse_inertia(body, at):
    A, C = body.transverse_inertia, body.axial_inertia
    return IDENTITY / A + (1 / C - 1 / A) * at.axis[:, np.newaxis] * at.axis


def angular_momentum(body, at):
    A, C = body.transverse_inertia, body.axial_inertia
    return A * at.omega + (C - A) * (at.omega @ at.axis) * at.axis


def mobility(body, at):
    """W: what a unit force (or impulse) on the rim does to the acceleration (velocity) there."""
    x, y, z = at.arm.tolist()
    arm_cross = np.array(((0.0, -z, y), (z, 0.0, -x), (-y, x, 0.0)))
    return IDENTITY / body.mass - arm_cross @ inverse_inertia(body, at) @ arm_cross


@dataclass(frozen=True)
class Dynamics:
    """The force on the rim, and d/dt of the state."""

    force: np.ndarray
    y_dot: np.ndarray


def dynamics(body, law, resistances, phase, y, gravity):
    at = Attitude(body, y)
    u = y[VELOCITY]
    inverse = inverse_inertia(body, at)
    torque = -cross(at.omega, angular_momentum(body, at))
    # d/dt (v + Omega x r) if the table were not there.
    free = cross(inverse @ torque, at.arm) + cross(at.omega, at.arm_dot) - gravity * E_Z
    rim_velocity = u - cross(at.omega, at.arm) + at.arm_dot
    force, rim_acceleration, powers = NOTHING, free, (0.0, 0.0, 0.0, 0.0)
    if phase != "flight":
        rim_velocity[2] = 0.0
        moments = [] if resistances is NONE else resistances.moments(body, at)
        W = mobility(body, at)
        for moment, per_normal in moments:
            free = free + cross(inverse @ moment, at.arm)
            W[:, 2] += cross(inverse @ per_normal, at.arm)
        force, rim_acceleration = contact_force(law, phase, u, W, free)
        moments = [moment + force[2] * per_normal for moment, per_normal in moments]
        torque = torque + cross(at.arm, force) + sum(moments, start=NOTHING)
        powers = [force[:2] @ u[:2], 0.0, 0.0, 0.0]
        powers[1 : 1 + len(moments)] = [moment @ at.omega for moment in moments]
    rates = (turning(y[TURN], at.omega), rim_velocity, inverse @ torque, rim_acceleration)
    return Dynamics(force, np.concatenate((*rates, (at.yaw_rate, at.spin_rate), powers)))


def contact_force(law, phase, u, W, free):
    """The force that leaves the rim point no vertical acceleration (sticking: none), and u_dot.

    `free` is its acceleration without contact, `W` its mobility, both relative to the table.
    """
    if phase == "stick":
        return np.linalg.solve(W, -free), np.zeros(3)
    without_normal, per_normal = law.friction_force(u)
    per_normal = per_normal + E_Z
    pressing = W[2] @ per_normal
    if pressing <= 0.0:
        raise ArithmeticError("Painleve: no normal force keeps the sliding rim on the table")
    normal = -(free[2] + W[2] @ without_normal) / pressing
    force = without_normal + normal * per_normal
    u_dot = W @ force + free
    u_dot[2] = 0.0
    return force, u_dot


def turning(quaternion, omega):
    """q_dot = Omega q / 2, Omega in the inertial frame."""
    scalar, vector = quaternion[0], quaternion[1:]
    return np.concatenate(
        ((-omega @ vector / 2,), (scalar * omega + cross(omega, vector)) / 2),
    )


def kinetic_energy(body, y):
    at = Attitude(body, y)
    v = y[VELOCITY] - cross(at.omega, at.arm)
    return body.mass * (v @ v) / 2 + at.omega @ angular_momentum(body, at) / 2


def energy(body, y, gravity=9.8):
    """Kinetic and potential (J)."""
    center = y[RIM] - Attitude(body, y).arm
    return kinetic_energy(body, y) + body.mass * gravity * center[2]


# Landing


@dataclass(frozen=True)
class Landing:
    """An impulse (N s) on the rim, the rim velocity after, and the work done on the body (J)."""

    impulse: np.ndarray
    velocity: np.ndarray
    work: float
    normal_work: float
    compression_work: float
    stuck: bool


def land(W, velocity, friction, restitution=0.0):
    """Routh's incremental impact: the normal impulse is the clock, and friction is Coulomb's.

    W is the mobility at the rim, `velocity` that of the rim point before (velocity[2] < 0).
    Compression ends when the rim point no longer approaches; restitution, when it has given back
    restitution^2 of the work of compression (Stronge). `friction` is a coefficient, or a function
    of the slip that is the friction impulse per normal impulse.
    """
    least = 1e-14 * np.sqrt(velocity @ velocity)
    y = np.array([*velocity, 0.0, 0.0, 0.0, 0.0])  # rim velocity, impulse, normal work
    stuck, compression = False, None
    if not callable(friction) and np.isinf(friction):
        y, stuck = _stopped_at_once(W, y), True
    while True:
        if not (stuck or callable(friction)) and np.hypot(*y[:2]) <= least:
            stuck, y[:2] = _from_rest(W, friction, least)
        end, y = _press(W, friction, stuck, y, restitution, compression, least)
        if end == "stopped":
            y[:2] = 0.0
        if end == "compressed":
            y[2], compression = 0.0, y[6]
        if end == "restored" or (end == "compressed" and restitution == 0.0):
            break
    if stuck:
        y[:2] = 0.0
    impulse, mean_velocity = y[3:6], (velocity + y[:3]) / 2
    return Landing(impulse, y[:3], impulse @ mean_velocity, y[6], compression, stuck)


def _stopped_at_once(W, y):
    """A rim that cannot slip is stopped before the normal impulse has begun."""
    y = y.copy()
    y[3:5] = np.linalg.solve(W[:2, :2], -y[:2])
    y[:3] += W[:, :2] @ y[3:5]
    y[:2] = 0.0
    if y[2] >= 0.0:
        raise ArithmeticError("stopping the slip alone throws the rim up")
    return y


def _per_normal_impulse(W, friction, stuck, u):
    """d(impulse)/d(normal impulse)."""
    if stuck:
        return np.array((*np.linalg.solve(W[:2, :2], -W[:2, 2]), 1.0))
    if callable(friction):
        return friction(np.array((*u, 0.0))) + E_Z
    if friction == 0.0:
        return E_Z
    return np.array((*(-friction * u / np.hypot(*u)), 1.0))


def _press(W, friction, stuck, y, restitution, compression, least):
    """Add normal impulse until the slip stops, the compression ends or the restitution does."""

    def rates(_, y):
        impulse = _per_normal_impulse(W, friction, stuck, y[:2])
        return np.array([*(W @ impulse), *impulse, y[2]])

    events = []
    if not (stuck or callable(friction) or friction == 0.0):
        events.append(crossing("stopped", -1, lambda y: np.hypot(*y[:2]) - least))
    if compression is None:
        events.append(crossing("compressed", 1, lambda y: y[2]))
    else:
        left = (1 - restitution**2) * compression
        events.append(crossing("restored", 1, lambda y: y[6] - left))
    enough = 1e3 * (np.sqrt(y[:3] @ y[:3]) / W[2, 2] + np.linalg.norm(y[3:6]))
    # Slips that are small against the landing speed do not matter, but their directions do.
    atol = np.array([1e-2 * least] * 2 + [1e-15 * enough] * 5)
    solution = solve_ivp(
        rates, (0.0, enough), y, method="DOP853", rtol=RTOL, atol=atol, events=events
    )
    return ending(solution, events), solution.y[:, -1].copy()


def _from_rest(W, friction, least):
    """Whether a rim point at rest stays so under more impulse, and else the slip that begins."""
    holding = _per_normal_impulse(W, friction, True, None)[:2]
    needed = np.hypot(*holding)
    if needed <= friction:
        return True, np.zeros(2)

    def acceleration(direction):
        return (W @ _per_normal_impulse(W, friction, False, direction))[:2]

    return False, 2 * least * slip_from_rest(acceleration, -holding / needed)


def slip_from_rest(acceleration, guess):
    """The direction in which a slip grows from nothing: that in which it is accelerated.

    Every other direction turns into it at a rate like 1/|u|: follow the turning. `acceleration` is
    a function of the direction.
    """

    def turning(_, angle):
        cos, sin = np.cos(angle[0]), np.sin(angle[0])
        x, y = acceleration(np.array((cos, sin)))
        return [cos * y - sin * x]

    angle = np.arctan2(guess[1], guess[0])
    pull = np.hypot(*acceleration(-guess)) + np.hypot(*acceleration(guess))
    relaxed = solve_ivp(turning, (0.0, 1e3 / pull), [angle], method="Radau", rtol=1e-8, atol=1e-12)
    angle = relaxed.y[0, -1]
    return np.array((np.cos(angle), np.sin(angle)))


# Events


def crossing(kind, direction, value, terminal=True):
    """An event of solve_ivp, of this kind, where value(y) crosses zero upward (1) or down (-1)."""

    def event(_, y):
        return value(y)

    event.kind, event.direction, event.terminal = kind, direction, terminal
    return event


def ending(solution, events):
    """The kind of the event that ended an integration, None if it went on to its end."""
    if solution.status < 0:
        raise ArithmeticError(f"stopped at {solution.t[-1]}: {solution.message}")
    for event, times in zip(events, solution.t_events, strict=True):
        if event.terminal and len(times):
            return event.kind
    return None


# Motions


@dataclass(frozen=True)
class Event:
    """An event: a tilt_min, tilt_max, slip, stick, lift_off or landing, toppled or face_down.

    `y` is the state just after it.
    """

    kind: str
    t: float
    y: np.ndarray
    landing: Landing | None = None


@dataclass(frozen=True)
class Phase:
    kind: str
    start: float
    end: float
    dense: object

    def __call__(self, t):
        return self.dense(t - self.start)


@dataclass
class Trajectory:
    """A motion as phases and events; call it with a time for the state y."""

    body: object
    law: object
    resistances: Resistances
    gravity: float
    phases: list = field(default_factory=list)
    events: list = field(default_factory=list)

    @property
    def end(self):
        return self.phases[-1].end

    def of_kind(self, kind):
        return [event for event in self.events if event.kind == kind]

    def phase_at(self, t):
        return next((phase for phase in self.phases if t <= phase.end), self.phases[-1])

    def __call__(self, t):
        return self.phase_at(t)(t)

    def look(self, t):
        """All quantities for comparison at one instant."""
        phase = self.phase_at(t)
        return Look(self, phase.kind, phase(t))


@dataclass(frozen=True)
class Look:
    """One instant of a trajectory: Euler angles and rates, center, slip, contact force, energy."""

    trajectory: Trajectory
    phase: str
    y: np.ndarray

    @cached_property
    def attitude(self):
        return Attitude(self.trajectory.body, self.y)

    @property
    def tilt(self):
        return self.attitude.tilt

    @property
    def yaw(self):
        """From the frame; the integral of its rate only says how many times it went round."""
        return _nearest_turn(
            np.arctan2(-self.attitude.axis[1], -self.attitude.axis[0]), self.y[YAW]
        )

    @property
    def spin(self):
        w, _, _, k = self.y[TURN]
        return _nearest_turn(2 * np.arctan2(k, w) - self.yaw, self.y[SPIN])

    @property
    def rates(self):
        """Yaw, tilt and spin rate (rad/s)."""
        at = self.attitude
        return np.array((at.yaw_rate, at.tilt_rate, at.spin_rate))

    @property
    def contact(self):
        """Where the lowest rim point is (m)."""
        return self.y[RIM]

    @property
    def center(self):
        return self.y[RIM] - self.attitude.arm

    @property
    def center_velocity(self):
        return self.y[VELOCITY] - cross(self.attitude.omega, self.attitude.arm)

    @property
    def slip(self):
        """The slip of the material rim point along e_x1 and e_y1 (m/s)."""
        return self._on_yawed(self.y[VELOCITY])

    @cached_property
    def dynamics(self):
        of = self.trajectory
        return dynamics(of.body, of.law, of.resistances, self.phase, self.y, of.gravity)

    @property
    def normal_force(self):
        return self.dynamics.force[2]

    @property
    def friction_force(self):
        """On e_x1 and e_y1 (N)."""
        return self._on_yawed(self.dynamics.force)

    @property
    def energy(self):
        return energy(self.trajectory.body, self.y, self.trajectory.gravity)

    @property
    def works(self):
        """Work done on the body since the start (J), except in landings, by WORK_OF."""
        return dict(zip(WORK_OF, self.y[WORKS].tolist(), strict=True))

    def _on_yawed(self, vector):
        e_x1 = self.attitude.e_x1
        return np.array((vector @ e_x1, vector @ cross(E_Z, e_x1)))


def follow(body, state, law, duration, gravity=9.8, resistances=NONE, rtol=RTOL, method="DOP853"):
    """The motion from `state` (see `release`) for `duration` (s), or until it lies or falls flat.

    Give method "Radau" where a smoothing velocity or rate is so small that it makes the law stiff.
    """
    run = _Run(body, law, resistances, gravity, rtol, method)
    motion = Trajectory(body, law, resistances, gravity)
    t, y = 0.0, np.array(state)
    phase, y = run.begin(y)
    while phase is not None:
        solution, events = run.integrate(phase, duration - t, y)
        for event, times, states in zip(events, solution.t_events, solution.y_events, strict=True):
            if not event.terminal:
                motion.events += map(Event, [event.kind] * len(times), t + times, states)
        motion.phases.append(Phase(phase, t, t + solution.t[-1], solution.sol))
        t, y = motion.end, solution.y[:, -1].copy()
        end = ending(solution, events)
        if end is None:
            break
        phase, y, kind, landing = run.join(end, y)
        if kind is not None:
            motion.events.append(Event(kind, t, y, landing))
    motion.events.sort(key=lambda event: event.t)
    return motion


@dataclass(frozen=True)
class _Run:
    """What stays the same from phase to phase."""

    body: object
    law: object
    resistances: Resistances
    gravity: float
    rtol: float
    method: str

    @property
    def slip_unit(self):
        return np.sqrt(self.gravity * self.body.radius)

    @property
    def has_threshold(self):
        return 0.0 < self.law.static_friction < np.inf

    def slip(self, y):
        return np.hypot(y[VELOCITY][0], y[VELOCITY][1]) / self.slip_unit

    def dynamics(self, phase, y):
        return dynamics(self.body, self.law, self.resistances, phase, y, self.gravity)

    def cone(self, y):
        """friction N - |T| of the rim if it sticks: negative where it cannot."""
        *T, N = self.dynamics("stick", y).force
        return self.law.static_friction * N - np.hypot(*T)

    def begin(self, y):
        """The phase that a state is in, and the state with a trace of slip where it must start."""
        if y[RIM][2] > 0.0 or y[VELOCITY][2] > 0.0:
            return "flight", y
        y[RIM][2] = y[VELOCITY][2] = 0.0
        phase = "stick" if np.isinf(self.law.static_friction) else "slide"
        if self.has_threshold and self.slip(y) <= FIRST_SLIP:
            phase, y = self.from_rest(y)
        if self.law.unilateral and self.dynamics(phase, y).force[2] < 0.0:
            return "flight", y
        return phase, y

    def from_rest(self, y, starts=False):
        """Sticking, if it can and does not start to slip just now, else the onset of a slide."""
        y[VELOCITY] = 0.0
        if not starts and self.cone(y) >= 0.0:
            return "stick", y
        holding = self.dynamics("stick", y).force[:2]
        direction = -holding / np.hypot(*holding)

        def acceleration(direction):
            at = y.copy()
            at[VELOCITY][:2] = direction
            return self.dynamics("slide", at).y_dot[VELOCITY][:2]

        if not starts:
            direction = slip_from_rest(acceleration, direction)
        y[VELOCITY][:2] = FIRST_SLIP * self.slip_unit * direction
        return "onset", y

    def stop(self, y):
        """The state when the last trace of slip is gone."""
        y_dot = self.dynamics("slide", y).y_dot
        u = y[VELOCITY]
        return y - y_dot * (u @ u) / (u @ y_dot[VELOCITY])

    def land(self, y):
        at = Attitude(self.body, y)
        law = self.law
        # Invisible bounces end here; there would be infinitely many.
        bounces = -y[VELOCITY][2] > MIN_BOUNCE * self.slip_unit
        restitution = law.restitution if bounces else 0.0
        if isinstance(law, DryCurve):
            friction = law.mu(np.hypot(*y[VELOCITY][:2]))
        else:
            friction = law.landing_friction
        landing = land(mobility(self.body, at), y[VELOCITY], friction, restitution)
        y[OMEGA] += inverse_inertia(self.body, at) @ cross(at.arm, landing.impulse)
        y[VELOCITY], y[RIM][2] = landing.velocity, 0.0
        return landing, y

    def join(self, end, y):
        """From the end of a phase to the next: (phase, state, kind of event, landing)."""
        if end == "landed":
            landing, y = self.land(y)
            return *self.begin(y), "landing", landing
        y[RIM][2] = y[VELOCITY][2] = 0.0
        if end in ("toppled", "face_down"):
            return None, y, end, None
        if end in ("soft", "quick", "slow"):
            return "stopping" if end == "slow" else "slide", y, None, None
        if end == "slipped":
            return *self.from_rest(y, starts=True), "slip", None
        if end == "stopped":
            phase, y = self.from_rest(self.stop(y))
            return phase, y, "stick" if phase == "stick" else "slip", None
        return "flight", y, "lift_off", None

    def events(self, phase, y):
        """What may happen in a phase that begins at y."""
        body = self.body

        def tilt_rate(y):
            return Attitude(body, y).tilt_rate

        events = [
            crossing("tilt_min", 1, tilt_rate, terminal=False),
            crossing("tilt_max", -1, tilt_rate, terminal=False),
            crossing("toppled", 1, lambda y: Attitude(body, y).tilt - TOPPLED),
            crossing("face_down", -1, lambda y: Attitude(body, y).sin - FACE_DOWN),
        ]
        if phase == "flight":
            graze = GRAZE if y[VELOCITY][2] == 0.0 else 0.0
            return [*events, crossing("landed", -1, lambda y: y[RIM][2] / body.radius + graze)]
        if self.law.unilateral:
            events.append(crossing("lifted", -1, lambda y: self.dynamics(phase, y).force[2]))
        if not self.has_threshold:
            return events
        if phase == "stick":
            return [*events, crossing("slipped", -1, self.cone)]
        events.append(crossing("stopped", -1, lambda y: self.slip(y) / LAST_SLIP - 1))
        others = {
            "onset": crossing("soft", 1, lambda y: self.slip(y) / STIFF_SLIP - 1),
            "slide": crossing("slow", -1, lambda y: self.slip(y) / SLOW_SLIP - 1),
            "stopping": crossing("quick", 1, lambda y: self.slip(y) / SLOW_SLIP - 2),
        }
        return [*events, others[phase]]

    def longest_step_of_flight(self, y):
        """Short enough that no bounce is missed within one step (s)."""
        up, acceleration = y[VELOCITY][2], self.dynamics("flight", y).y_dot[VELOCITY][2]
        turning = 0.1 / (np.linalg.norm(y[OMEGA]) + np.sqrt(self.gravity / self.body.radius))
        if up > 0.0 > acceleration:
            return min(turning, -up / acceleration / 2)
        return turning

    def integrate(self, phase, duration, y):
        """One phase, with time from its beginning: (solution, its events)."""
        body, slip_unit = self.body, self.slip_unit
        atol = np.full(19, 1e-3 * self.rtol)
        atol[RIM] *= body.radius
        atol[OMEGA] *= np.sqrt(self.gravity / body.radius)
        atol[VELOCITY] = 1e-2 * LAST_SLIP * slip_unit
        atol[WORKS] *= body.mass * slip_unit**2
        options = {"method": "Radau" if phase == "onset" else self.method}
        if phase == "flight":
            longest = min(self.longest_step_of_flight(y), duration)
            options = {"method": "DOP853", "max_step": longest, "first_step": longest}
        events = self.events(phase, y)
        solution = solve_ivp(
            lambda _, y: self.dynamics(phase, y).y_dot,
            (0.0, duration),
            y,
            rtol=self.rtol,
            atol=atol,
            events=events,
            dense_output=True,
            **options,
        )
        return solution, events


def _nearest_turn(angle, count):
    return angle + 2 * np.pi * np.round((count - angle) / (2 * np.pi))
