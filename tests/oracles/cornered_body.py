"""A body on a base with corners in Newton and Euler's vectors, an oracle.

Everything is in axes fixed to the table: a rotation matrix, the angular velocity, and the place and
velocity of the centre of mass. What the table does to the corners on it follows from demanding that
they have no acceleration; what it does in an impact, from demanding velocities. No Euler angle, no
equation about a corner and no energy is used.

A corner that comes down takes the impulse that brings it to rest. If the corner that was down would
then go through the table, both take impulses. With restitution the upward impulse goes on until it
is 1 + e times that of the compression, while friction keeps the corner in place and a corner that
stays down at rest. A body without corners on the table flies.
"""

from dataclasses import dataclass

import numpy as np
from scipy.integrate import solve_ivp
from scipy.spatial.transform import Rotation

UP = np.array([0.0, 0.0, 1.0])


@dataclass
class Cornered:
    """A body (mass, radius, height, inertias, corners) on a table that holds corners or not."""

    body: object
    sticks: bool
    gravity: float
    restitution: float = 0.0

    def __post_init__(self):
        body = self.body
        angle = np.pi + 2.0 * np.pi * np.arange(body.corners) / body.corners
        across, along = body.radius * np.cos(angle), body.radius * np.sin(angle)
        self.corners = np.stack([across, along, np.full(angle.shape, -body.height)], axis=-1)
        inertias = body.transverse_inertia, body.transverse_inertia, body.axial_inertia
        self.inertia = np.diag(inertias)
        self.time = np.sqrt(body.radius / self.gravity)

    def start(self, state):
        """Orientation, place, angular velocity and velocity, one after another."""
        turn = (
            Rotation.from_euler("z", state.yaw)
            * Rotation.from_euler("y", -state.tilt)
            * Rotation.from_euler("z", state.spin)
        ).as_matrix()
        across = np.array([-np.sin(state.yaw), np.cos(state.yaw), 0.0])
        omega = state.yaw_rate * UP + state.spin_rate * turn[:, 2] - state.tilt_rate * across
        arms = self.corners @ turn.T
        lowest = int(np.argmin(arms[:, 2]))
        place = np.array([0.0, 0.0, -arms[lowest, 2]])
        velocity = -np.cross(omega, arms[lowest])
        if not self.sticks:
            velocity[:2] = 0.0
        return np.concatenate([turn.ravel(), place, omega, velocity]), [lowest]

    def demands(self, turn, down):
        """Rows that take (velocity, angular velocity) to what corners ``down`` may not do."""
        arms = self.corners[down] @ turn.T
        directions = np.eye(3) if self.sticks else UP[None]
        return np.array(
            [np.concatenate([way, np.cross(arm, way)]) for arm in arms for way in directions]
        )

    def mobility(self, turn):
        """The inverse of the mass matrix."""
        inverse = np.zeros((6, 6))
        inverse[:3, :3] = np.eye(3) / self.body.mass
        inverse[3:, 3:] = turn @ np.linalg.inv(self.inertia) @ turn.T
        return inverse

    def rates(self, u, down):
        turn, omega, velocity = u[:9].reshape(3, 3), u[12:15], u[15:18]
        inertia = turn @ self.inertia @ turn.T
        load = np.concatenate(
            [-self.body.mass * self.gravity * UP, -np.cross(omega, inertia @ omega)]
        )
        rows, inverse = self.demands(turn, down), self.mobility(turn)
        acceleration = inverse @ load
        if not down:
            return self.joined(omega, turn, velocity, acceleration)
        arms = self.corners[down] @ turn.T
        directions = np.eye(3) if self.sticks else UP[None]
        centripetal = np.array(
            [way @ np.cross(omega, np.cross(omega, arm)) for arm in arms for way in directions]
        )
        needed = -(rows @ inverse @ load + centripetal)
        forces = np.linalg.lstsq(rows @ inverse @ rows.T, needed, rcond=1e-12)[0]
        return self.joined(omega, turn, velocity, inverse @ (load + rows.T @ forces))

    @staticmethod
    def joined(omega, turn, velocity, acceleration):
        spinning = np.cross(omega, turn, axisb=0, axisc=0)
        return np.concatenate([spinning.ravel(), velocity, acceleration[3:], acceleration[:3]])

    def struck(self, u, down):
        """After impulses at the corners ``down`` that leave them without forbidden velocity."""
        turn = u[:9].reshape(3, 3)
        rows, inverse = self.demands(turn, down), self.mobility(turn)
        before = np.concatenate([u[15:18], u[12:15]])
        wanted = -(rows @ before)
        impulses = np.linalg.lstsq(rows @ inverse @ rows.T, wanted, rcond=1e-12)[0]
        after = before + inverse @ rows.T @ impulses
        return np.concatenate([u[:12], after[3:], after[:3]])

    def rebounding(self, u, down, struck):
        """After an impact at the corner ``struck``; those of ``down`` that it is not stay down."""
        turn = u[:9].reshape(3, 3)
        rows, inverse = self.demands(turn, down), self.mobility(turn)
        each = len(rows) // len(down)
        upward = (down.index(struck) + 1) * each - 1
        held = np.delete(rows, upward, axis=0)
        before = np.concatenate([u[15:18], u[12:15]])

        def stopped(velocities, rows):
            if not len(rows):
                return velocities
            middle = rows @ inverse @ rows.T
            return velocities - inverse @ rows.T @ np.linalg.lstsq(middle, rows @ velocities)[0]

        stuck = stopped(before, held)
        compressed = stopped(stuck, rows)
        # The upward impulse at the corner follows from what the others let it change.
        free = inverse @ rows[upward]
        change = stopped(free, held)
        impulse = (compressed - stuck) @ change / (change @ change)
        after = compressed + self.restitution * impulse * change
        return np.concatenate([u[:12], after[3:], after[:3]])

    def upward_force(self, down):
        """An event of SciPy: the force of the table on the one corner that is down vanishes."""

        def force(t, u):
            acceleration = self.rates(u, down)[15:18]
            return float(acceleration[2] + self.gravity)

        force.terminal, force.direction = True, -1
        return force

    def rise(self, u, corner):
        """The vertical velocity of a corner."""
        arm = u[:9].reshape(3, 3) @ self.corners[corner]
        return u[17] + np.cross(u[12:15], arm)[2]

    def height_of(self, corner, down, after=-1.0):
        """An event of SciPy: a corner comes down to one that is down, or to the table (None).

        It sees none until shortly after the time ``after``: a rebounding corner is at the table.
        """

        def over(t, u):
            if t < after + 1e-6 * self.time:
                return 1.0
            turn = u[:9].reshape(3, 3)
            below = u[11] * -UP if down is None else turn @ self.corners[down]
            return float((turn @ self.corners[corner] - below)[2])

        over.terminal, over.direction = True, -1
        return over

    def bounces(self, state, impacts):
        """(time, u, corners down) after each of the first impacts with restitution."""
        u, down = self.start(state)
        t, found, count = 0.0, [], len(self.corners)
        while len(found) < impacts:
            if down:
                candidates = [(down[0] - 1) % count, (down[-1] + 1) % count]
                events = [self.height_of(corner, down[0], t) for corner in candidates]
                events.append(self.upward_force(down))
            else:
                candidates = list(range(count))
                events = [self.height_of(corner, None, t) for corner in candidates]
            solution = solve_ivp(
                lambda t, u, down=down: self.rates(u, down),
                (t, t + 10.0),
                u,
                "DOP853",
                events=events,
                rtol=1e-12,
                atol=1e-14,
                max_step=0.01 * self.time,
            )
            t, u = solution.t[-1], solution.y[:, -1]
            first = [len(times) > 0 for times in solution.t_events].index(True)
            if first == len(candidates):
                down = []
                continue
            new = candidates[first]
            old = [corner for corner in down if (corner - new) % count in (1, count - 1)]
            alone = self.struck(u, [new])
            if old and self.rise(alone, old[0]) < 0.0:
                u, down = self.rebounding(u, [old[0], new], new), [old[0]]
            else:
                u, down = self.rebounding(u, [new], new), []
            found.append((t, u, down))
        return found

    def follow(self, state, impacts):
        """(time, u, corners down) at the start and after each of the first impacts."""
        u, down = self.start(state)
        t, found = 0.0, []
        count = len(self.corners)
        found.append((t, u, down))
        for _ in range(impacts):
            beside = [(down[0] - 1) % count, (down[-1] + 1) % count]

            solution = solve_ivp(
                lambda t, u, down=down: self.rates(u, down),
                (t, t + 10.0),
                u,
                "DOP853",
                events=[self.height_of(corner, down[0]) for corner in beside],
                rtol=1e-12,
                atol=1e-14,
            )
            t, u = solution.t[-1], solution.y[:, -1]
            (new,) = [c for c, times in zip(beside, solution.t_events, strict=True) if len(times)]
            old = [corner for corner in down if (corner - new) % count in (1, count - 1)]
            alone = self.struck(u, [new])
            if self.rise(alone, old[0]) >= 0.0:
                u, down = alone, [new]
            else:
                pair = [old[0], new]
                down = pair if (pair[0] + 1) % count == pair[1] else pair[::-1]
                u = self.struck(u, down)
            found.append((t, u, down))
        return found


def tilt_and_heading(u):
    """Tilt and yaw + spin (rad) of an orientation, regular where the body stands flat."""
    turn = u[:9].reshape(3, 3)
    x, y, z, w = Rotation.from_matrix(turn).as_quat()
    return 2.0 * np.arctan2(np.hypot(x, y), np.hypot(z, w)), 2.0 * np.arctan2(z, w)
