"""A rigid body that rocks in a plane on a table that moves along a line: an oracle.

The full nonlinear equation of Housner's problem: about the point of the rim from which the body
leans to a side (1 or -1, along the line), J φ̈ = m (side a z - g ρ), with ρ = R cos φ - H sin φ,
z = R sin φ + H cos φ and J = A + m (R² + H²). In an impact the body goes on about the opposite
point with φ̇ smaller by the factor (J - 2 m R²)/J. The acceleration a is linear between samples.

With a gap, the impact is where the tilt falls below that at which the opposite point of the rim is
so far above the table, with the φ̇ that it would have at the tilt 0 under the acceleration of this
time; there it goes on. A body that cannot reach this tilt any more stands.
"""

from dataclasses import dataclass
from itertools import pairwise
from math import asin, cos, hypot, pi, sin, sqrt

from scipy.integrate import solve_ivp

STANDS = 1e-7
"""A body that cannot reach this tilt any more stands, rad."""


@dataclass(frozen=True)
class Line:
    """An acceleration (m/s2) that changes at a constant rate from a time (s) on."""

    begin: float
    first: float
    slope: float

    def __call__(self, t):
        return self.first + self.slope * (t - self.begin)


@dataclass(frozen=True)
class PlanarRocking:
    body: object
    gravity: float
    gap: float = 0.0

    @property
    def lowest(self):
        """The tilt at which the gap is closed, rad."""
        return asin(self.gap / (2 * self.body.radius))

    @property
    def inertia(self):
        body = self.body
        return body.transverse_inertia + body.mass * hypot(body.radius, body.height) ** 2

    def impacts(self, samples, step, tilt=0.0):
        """The times of the impacts (s), and the tilt at the end or where the body topples.

        The body stands at first, or is let go from a tilt, to the side 1. `samples` are those of
        the acceleration (m/s2), one every `step` (s).
        """
        times, side, state = [], 1 if tilt else 0, (tilt, 0.0)
        for index, ends in enumerate(pairwise(samples)):
            t, end = index * step, (index + 1) * step
            line = Line(t, ends[0], (ends[1] - ends[0]) / step)
            while t < end:
                if side == 0:
                    t, side = self._lifted(t, end, line)
                    continue
                t, state, lands = self._rocked(t, end, state, side, line)
                if state[0] >= pi / 2:
                    return times, state[0]
                if lands:
                    times.append(t)
                    side, state = self._landed(side, state, line(t))
        return times, state[0]

    def _lifted(self, t, end, line):
        """When, from t on, a body that stands is lifted, and to which side; 0 if it is not."""
        lifting = self.gravity * self.body.radius / self.body.height
        for time in (t, end):
            if abs(line(time)) > lifting:
                side = 1 if line(time) > 0 else -1
                crossing = line.begin + (side * lifting - line.first) / line.slope
                return (t if time == t else crossing), side
        return end, 0

    def _rocked(self, t, end, state, side, line):
        """Time and state at the end or, if that is earlier, at an impact, and whether it is one."""
        mass, radius, height = self.body.mass, self.body.radius, self.body.height

        def rates(time, state):
            c, s = cos(state[0]), sin(state[0])
            push = side * line(time) * (radius * s + height * c)
            return state[1], mass * (push - self.gravity * (radius * c - height * s)) / self.inertia

        def impact(time, state):
            # A body that turns back below the gap comes down there.
            return max(state[0] - self.lowest, state[1]) if self.gap else state[0]

        impact.terminal, impact.direction = True, -1
        found = solve_ivp(rates, (t, end), state, "DOP853", rtol=1e-13, atol=1e-16, events=impact)
        return found.t[-1], found.y[:, -1], found.status == 1

    def _energy(self, side, tilt, acceleration):
        """The integral of J φ̈ from a tilt to 0 under a constant acceleration, J."""
        radius, height = self.body.radius, self.body.height
        lift = radius * sin(tilt) - height * (1 - cos(tilt))
        along = radius * (1 - cos(tilt)) + height * sin(tilt)
        return self.body.mass * (self.gravity * lift - side * acceleration * along)

    def _landed(self, side, state, acceleration):
        body = self.body
        gained = self._energy(side, state[0], acceleration) if self.gap else 0.0
        factor = 1 - 2 * body.mass * body.radius**2 / self.inertia
        speed = factor * sqrt(state[1] ** 2 + 2 * gained / self.inertia)
        needed = body.mass * self.gravity * STANDS * body.radius
        needed = max(needed, self._energy(-side, self.lowest, acceleration))
        stands = self.inertia * speed**2 / 2 < needed
        return (0, (0.0, 0.0)) if stands else (-side, (0.0, speed))
