"""Random bodies that are tipped, held and let go, with a simulated sensor inside."""

from dataclasses import dataclass

import numpy as np

import rimroll as rr
from rimroll.sensors.gyro.sensor import TIPPING

REST, HELD = 1.0, 0.5
RELEASE = REST + TIPPING + HELD
"""When the body is let go, in the time of the record, s."""


@dataclass(frozen=True)
class Rocked:
    """A motion under known friction, and what a sensor recorded of it."""

    body: rr.Body
    friction: float
    motion: rr.Motion
    record: rr.gyro.Record

    def true_turn(self, collision):
        """The turn of the motion that goes with a near-collision that was read, rad."""
        return self._turn(collision).angle

    def true_energy_kept(self, collision):
        """What the near-collision leaves of the energy of height and rotation."""
        turn = self._turn(collision)
        (before,) = self.motion.evaluate(turn.start).energy
        if turn.start > 0.0:  # at a release the translation counts, too
            before = self._seen(turn.start)
        return self._seen(turn.end) / before

    def _seen(self, t):
        """The energy of height and rotation over that of standing, J."""
        at, body = self.motion.evaluate(t), self.body
        across = np.hypot(at.tilt_rate, at.yaw_rate * np.sin(at.tilt))
        turning = body.transverse_inertia * across**2 + body.axial_inertia * at.axial_spin**2
        return (at.potential_energy + 0.5 * turning)[0]

    def _turn(self, collision):
        near = [turn for turn in self.motion.turns if abs(turn.t + RELEASE - collision.time) < 0.02]
        assert len(near) == 1, "a near-collision that is none"
        return near[0]


def rocked(seed):
    """A body, a start, a friction and a sensor, all random but for the seed."""
    draw = np.random.default_rng(seed)
    radius = draw.uniform(0.03, 0.06)
    height = radius * draw.uniform(0.7, 1.8)
    mass = draw.uniform(0.1, 0.5)
    transverse = mass * (height**2 * draw.uniform(0.4, 1.2) + 0.3 * radius**2)
    axial = min(mass * radius**2 * draw.uniform(0.4, 0.9), 1.8 * transverse)
    body = rr.Body(mass, radius, height, transverse, axial)
    friction = draw.uniform(0.03, 1.2 * rr.needed_friction(body))
    start = rr.State(
        tilt=rr.balance_tilt(body) * draw.uniform(0.5, 0.85),
        tilt_rate=-draw.choice([0.0, draw.uniform(0.1, 1.0)]),
        yaw_rate=draw.normal(0.0, 0.15),
        spin_rate=draw.normal(0.0, 0.15),
    )
    motion = rr.simulate(body, start, rr.Coulomb(friction), duration=1.2)
    sensor = rr.gyro.phone(float(draw.choice([100.0, 200.0, 400.0])))
    record = sensor.record(motion, rest=REST, held=HELD, seed=seed)
    return Rocked(body, friction, motion, record)
