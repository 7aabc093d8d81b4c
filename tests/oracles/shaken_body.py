"""A body of revolution on a table that moves, in Newton and Euler's vectors: an oracle.

It is integrated in an inertial frame, in which the table has a place and a velocity of its own. The
acceleration of the table moves the table and nothing else; the body feels it only through the
contact force. That force leaves the lowest point of the rim no acceleration relative to the table:
no vertical one in a slide, and none at all where the rim sticks. (rimroll computes in the frame of
the table, with inertial forces.)

Kinematics and laws of contact are those of `rigid_body`: no equation of motion is written in Euler
angles. A phase ("stick", "slide" or "flight") is followed from a given state to a given time.
"""

from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise

import numpy as np
from scipy.integrate import solve_ivp

from oracles import rigid_body as rb
from oracles.rigid_body import cross

# What is integrated, in the inertial frame: where the body's frame points (a quaternion), its
# angular velocity, its center and the table with their velocities, the work of the inertial force
# in the table's frame, and the energy lost to friction (rad/s, m, m/s, J).
TURN, OMEGA, CENTER, VELOCITY = slice(0, 4), slice(4, 7), slice(7, 10), slice(10, 13)
TABLE, TABLE_VELOCITY, GROUND_WORK, FRICTION_LOSS = slice(13, 16), slice(16, 19), 19, 20
SIZE = 21


@dataclass(frozen=True)
class Pulse:
    """An acceleration: `amplitude` (3,) in m/s2 times shape(t) from t = 0 to `end` (s)."""

    amplitude: np.ndarray
    shape: object
    end: float


@dataclass(frozen=True)
class Table:
    """The motion of a table: pulses, and samples (n, 3) at every `step` (s) with lines between."""

    pulses: tuple = ()
    step: float = 1.0
    samples: np.ndarray | None = None

    @cached_property
    def sample_times(self):
        count = 0 if self.samples is None else len(self.samples)
        return self.step * np.arange(count)

    def corners(self, begin, end):
        """The times between two others at which the acceleration is not smooth."""
        times = np.unique([*(pulse.end for pulse in self.pulses), *self.sample_times])
        return times[(times > begin) & (times < end)].tolist()

    def acceleration(self, moment):
        """The acceleration as a function of time (s), true from a moment to the next corner."""
        acting = [pulse for pulse in self.pulses if moment < pulse.end]
        before, slope = np.zeros(3), np.zeros(3)
        i = int(np.searchsorted(self.sample_times, moment, side="right")) - 1
        if 0 <= i < len(self.sample_times) - 1:
            slope = (self.samples[i + 1] - self.samples[i]) / self.step
            before = self.samples[i] - slope * self.sample_times[i]

        def at(t):
            line = before + slope * t
            return sum((pulse.shape(t) * pulse.amplitude for pulse in acting), start=line)

        return at


@dataclass(frozen=True)
class Shaken:
    """A body under a law of contact (see `rigid_body`) on a moving table, under gravity (m/s2)."""

    body: object
    law: object
    table: Table
    gravity: float

    def state(self, start, center, rim_velocity):
        """The state of a body with the Euler angles and rates of `start`.

        `center` (m) and `rim_velocity` (m/s), of the lowest point of the rim as a point of the
        body, are relative to the table. The table is taken to be at the origin and at rest just
        then, since its place and a constant velocity change nothing.
        """
        y = np.zeros(SIZE)
        y[TURN] = rb.quaternion(start.yaw, start.tilt, start.spin)
        y[OMEGA], y[CENTER] = rb.angular_velocity(start), center
        y[VELOCITY] = rim_velocity - cross(y[OMEGA], self.arm(y))
        return y

    def arm(self, y):
        """From the center of mass to the lowest point of the rim (m)."""
        return self._attitude(y).arm

    def rim_velocity(self, y):
        """The velocity of the lowest point of the body's rim relative to the table (m/s)."""
        return y[VELOCITY] + cross(y[OMEGA], self.arm(y)) - y[TABLE_VELOCITY]

    def gap(self, y):
        """The height of the lowest point of the rim over the table (m)."""
        return (y[CENTER] + self.arm(y) - y[TABLE])[2]

    def force(self, phase, y, t):
        """The force of the table on the rim (N); where the acceleration jumps, after the jump."""
        return self._force_and_rates(phase, y, self.table.acceleration(t)(t))[0]

    def follow(self, phase, y, begin, end, rtol=rb.RTOL):
        """The state at `end` (s) of a phase that is in the state `y` at `begin`."""
        size = np.sqrt(self.gravity * self.body.radius)
        atol = np.full(SIZE, 1e-3 * rtol)
        atol[CENTER] = atol[TABLE] = 1e-3 * rtol * self.body.radius
        atol[OMEGA] *= size / self.body.radius
        atol[VELOCITY] = atol[TABLE_VELOCITY] = 1e-3 * rtol * size
        atol[GROUND_WORK:] *= self.body.mass * size**2
        corners = [begin, *self.table.corners(begin, end), end]
        for t, after in pairwise(corners):
            acceleration = self.table.acceleration((t + after) / 2)
            solution = solve_ivp(
                lambda t, y: self._force_and_rates(phase, y, acceleration(t))[1],  # noqa: B023
                (t, after),
                y,
                method="DOP853",
                rtol=rtol,
                atol=atol,
            )
            if solution.status < 0:
                raise ArithmeticError(f"stopped at {solution.t[-1]} s: {solution.message}")
            y = solution.y[:, -1]
        return y

    def land(self, y, friction, restitution):
        """The state after the landing of a rim that has come down on the table."""
        at = self._attitude(y)
        landing = rb.land(rb.mobility(self.body, at), self.rim_velocity(y), friction, restitution)
        y = y.copy()
        y[OMEGA] += rb.inverse_inertia(self.body, at) @ cross(at.arm, landing.impulse)
        y[VELOCITY] += landing.impulse / self.body.mass
        return y

    def _attitude(self, y):
        return rb.Attitude(self.body, np.concatenate((y[TURN], np.zeros(3), y[OMEGA])))

    def _force_and_rates(self, phase, y, acceleration):
        at = self._attitude(y)
        inverse = rb.inverse_inertia(self.body, at)
        torque = -cross(at.omega, rb.angular_momentum(self.body, at))
        weight = -self.gravity * rb.E_Z
        relative = y[VELOCITY] - y[TABLE_VELOCITY]
        slip, force = np.zeros(3), np.zeros(3)
        if phase != "flight":
            # What would be the acceleration of the lowest point of the rim if nothing touched it.
            free = cross(inverse @ torque, at.arm) + cross(at.omega, at.arm_dot) + weight
            slip = relative + cross(at.omega, at.arm)
            W = rb.mobility(self.body, at)
            force, _ = rb.contact_force(self.law, phase, slip, W, free - acceleration)
            torque = torque + cross(at.arm, force)
        rates = (
            rb.turning(y[TURN], at.omega),
            inverse @ torque,
            y[VELOCITY],
            weight + force / self.body.mass,
            y[TABLE_VELOCITY],
            acceleration,
            (-self.body.mass * (acceleration @ relative), -(force[:2] @ slip[:2])),
        )
        return force, np.concatenate(rates)
