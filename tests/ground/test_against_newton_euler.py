"""Motions on a moving table against Newton and Euler in an inertial frame, piece by piece.

The oracle (`shaken_body.py`) follows pieces of each phase from the state at a step of rimroll's, so
that errors do not grow from piece to piece. The forces, which both compute, show why a phase ends.
"""

from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import rimroll as rr
from given.shakings import ShakenStart, added, rectangular, shaken_starts, sine
from given.strategies import examples
from oracles import rigid_body as rb
from oracles.shaken_body import CENTER, FRICTION_LOSS, GROUND_WORK, OMEGA, TABLE, TURN, Shaken

pytestmark = pytest.mark.slow

GRAVITY = 9.81
KIND = {"rolling": "stick", "sliding": "slide", "flying": "flight"}

# The oracle's coordinates lose digits where the base is nearly level, and the direction of a dry
# slip is stiff where the slip is slow. The oracle follows what has a larger tilt, and a larger slip
# over sqrt(g R). It follows bounces until they are slower than that.
MIN_TILT, MIN_SLIP, MIN_BOUNCE = 3e-3, 1e-3, 1e-3
# Between its steps, rimroll interpolates by a polynomial of lower order.
DENSE = 1e-7
# The steps of rimroll's in a piece: a near-collision has several pieces.
STEPS = 30
# In units of R, sqrt(g R), m g and m g R, and of how fast the body turns. Both programs have errors
# of 1e-12, which grow at most a hundredfold within a piece; ten times as much is allowed.
AGREE = 1e-9


@dataclass(frozen=True)
class Comparison:
    """A motion of rimroll and the oracle for it."""

    motion: rr.Motion
    oracle: Shaken

    @cached_property
    def speed(self):
        return np.sqrt(GRAVITY * self.oracle.body.radius)

    @property
    def is_dry(self):
        return isinstance(self.motion.law, rr.Coulomb)

    @cached_property
    def phases(self):
        """Kind, first node and last node of each phase that lasts."""
        t, lasting = self.motion.t, [p for p in self.motion.phases if p.start < p.end]
        # A time at which the contact changes is there at least twice: before and after.
        return [
            (p.kind, np.flatnonzero(t == p.start)[-1], np.flatnonzero(t == p.end)[0])
            for p in lasting
        ]

    def state(self, i):
        """The oracle's state at rimroll's node i, in contact or as a flight begins."""
        motion = self.motion
        numbers = {name: float(values[i]) for name, values in vars(motion.state).items()}
        rim_velocity = np.array((*motion.slip[i], 0.0))
        return self.oracle.state(rr.State.computed(**numbers), motion.center[i], rim_velocity)

    def velocity_errors(self, i, y):
        """How far angular velocity and slip are from rimroll's at node i."""
        radius, speed = self.oracle.body.radius, self.speed
        fast = 1 + radius / speed * np.abs(y[OMEGA]).max()
        omega, slip = self.state(i)[OMEGA], self.motion.slip[i]
        return {
            "angular velocity": radius * np.abs(y[OMEGA] - omega).max() / speed / fast,
            "slip": np.abs(self.oracle.rim_velocity(y)[:2] - slip).max() / speed / fast,
        }

    def errors(self, kind, i, y, begin):
        """How far the oracle is from rimroll at node i, having followed a phase from `begin`."""
        motion, oracle, body = self.motion, self.oracle, self.oracle.body
        fast = 1 + body.radius / self.speed * np.abs(y[OMEGA]).max()
        turn = self.state(i)[TURN]
        found = self.velocity_errors(i, y)
        found["attitude"] = min(np.abs(y[TURN] - sign * turn).max() for sign in (1, -1))
        found["center"] = np.abs(y[CENTER] - y[TABLE] - motion.center[i]).max() / body.radius
        found["gap"] = abs(oracle.gap(y) - motion.gap[i]) / body.radius
        for name, place in (("ground_work", GROUND_WORK), ("friction_loss", FRICTION_LOSS)):
            done = motion[name][i] - motion[name][begin]
            found[name] = abs(y[place] - done) / (body.mass * (fast * self.speed) ** 2)
        if kind != "flight":
            force = oracle.force(kind, y, motion.t[i])
            ours = np.array((*motion.friction_force[i], motion.normal_force[i]))
            # The table's acceleration can be several times gravity.
            acceleration = GRAVITY + np.abs(motion.ground.peak[:3]).sum()
            found["force"] = np.abs(force - ours).max() / (body.mass * acceleration * fast**2)
        return found

    def pieces(self, kind, first, last):
        """Pairs of nodes between which the oracle can follow a phase on the table."""
        motion = self.motion
        can = (np.sin(motion.tilt) > MIN_TILT) & (motion.normal_force > 0.0)
        if self.is_dry and kind == "slide":
            can &= np.hypot(*motion.slip.T) > MIN_SLIP * self.speed
        follows = can[first : last + 1].astype(int)
        edges = np.flatnonzero(np.diff(follows, prepend=0, append=0)) + first
        for begin, end in zip(edges[::2], edges[1::2] - 1, strict=True):
            nodes = [*range(begin, end, STEPS), end]
            yield from pairwise(nodes)

    def compare_on_table(self, kind, first, last):
        for begin, end in self.pieces(kind, first, last):
            t = self.motion.t
            y = self.oracle.follow(kind, self.state(begin), t[begin], t[end])
            yield self.errors(kind, end, y, begin)

    def compare_flight(self, first, last):
        """A phase of flight with the landings in it and at its end, except for tiny bounces."""
        motion, oracle = self.motion, self.oracle
        landings = {event.t for event in motion.events if event.kind == "land"}
        nodes = range(first, last)
        landed = [i for i in nodes if motion.t[i] == motion.t[i + 1] and motion.t[i] in landings]
        y = self.state(first)
        for begin, end in zip([first, *(i + 1 for i in landed)], [*landed, last], strict=True):
            y[[GROUND_WORK, FRICTION_LOSS]] = 0.0
            y = oracle.follow("flight", y, motion.t[begin], motion.t[end])
            yield self.errors("flight", end, y, begin)
            if motion.t[end] in landings:
                y = oracle.land(y, oracle.law.landing_friction, oracle.law.restitution)
                yield self.velocity_errors(end + 1, y)
                if oracle.rim_velocity(y)[2] < MIN_BOUNCE * self.speed:
                    return

    def compare(self):
        """How far the programs are apart, at the end of each piece."""
        for name, first, last in self.phases:
            if name == "flying":
                yield from self.compare_flight(first, last)
            elif name in KIND:
                yield from self.compare_on_table(KIND[name], first, last)

    def check_contact(self):
        """The table only pushes; the friction is that of the law."""
        motion = self.motion
        for name, first, last in self.phases:
            if name not in KIND:
                continue
            inside = motion.evaluate(np.linspace(motion.t[first], motion.t[last], 52)[1:-1])
            fast = 1 + (self.oracle.body.radius / self.speed * inside.yaw_rate) ** 2
            size = self.oracle.body.mass * GRAVITY * fast
            friction, normal = inside.friction_force, inside.normal_force
            assert (normal > -DENSE * size).all()
            if name == "flying":
                assert (normal == 0.0).all() and (
                    inside.gap > -DENSE * self.oracle.body.radius
                ).all()
            elif name == "rolling" and self.is_dry:
                excess = np.hypot(*friction.T) - motion.law.static * normal
                assert (excess < DENSE * size).all()
            elif name == "sliding" and self.is_dry:
                slip = np.hypot(*inside.slip.T)
                holding = motion.law.friction * normal / slip
                apart = friction + holding[:, np.newaxis] * inside.slip
                assert (np.abs(apart).max(axis=1) < DENSE * size).all()

    def check_ends(self):
        """Each phase ends for the reason that the next one, or the status, gives."""
        motion, phases = self.motion, self.phases
        if not phases:  # The rim leaves the table at the start.
            return
        for (name, _, last), after in zip(phases, [*phases[1:], None], strict=True):
            if name not in KIND:
                continue
            next_name = motion.status if after is None else after[0]
            if name == "flying":
                assert next_name in ("finished", "toppled") or motion.gap[last] < 1e-9
                continue
            fast = 1 + (self.oracle.body.radius / self.speed * motion.yaw_rate[last]) ** 2
            size = self.oracle.body.mass * GRAVITY * fast
            if np.sin(motion.tilt[last]) < MIN_TILT:
                continue
            if next_name in ("flying", "lifted_off"):
                force = self.oracle.force(KIND[name], self.state(last), motion.t[last])
                assert force[2] < AGREE * size
            if (name, next_name) in (("rolling", "sliding"), ("sliding", "rolling")):
                # Where the slip begins or has ended, it is zero.
                force = self.oracle.force("stick", self.state(last), motion.t[last])
                holds = np.hypot(*force[:2]) - motion.law.static * force[2]
                assert (holds > -AGREE * size) if name == "rolling" else (holds < AGREE * size)
                if name == "sliding":
                    assert np.hypot(*motion.slip[last]) < 1e-6 * self.speed
        if motion.status == "finished":
            assert motion.t[-1] == motion.duration
        elif motion.status == "toppled":
            assert motion.tilt[-1] == pytest.approx(np.pi / 2, abs=1e-9)
        elif motion.status == "face_down":
            assert min(motion.tilt[-1], np.pi - motion.tilt[-1]) < 1e-12
        else:
            assert motion.status == "lifted_off" and not isinstance(motion.law, rr.Coulomb)


def compare(case, law, its_law):
    motion = rr.simulate(
        case.body,
        case.start,
        law,
        case.duration,
        gravity=GRAVITY,
        rtol=1e-12,
        ground=case.shaking.ground,
    )
    comparison = Comparison(motion, Shaken(case.body, its_law, case.shaking.table, GRAVITY))
    for errors in comparison.compare():
        assert max(errors.values()) < AGREE, errors
    comparison.check_contact()
    comparison.check_ends()
    return motion


def rolling(body, friction, more, restitution):
    return rr.NoSlip(), rb.Rolling()


def frictionless(body, friction, more, restitution):
    return rr.Frictionless(), rb.Coulomb(0.0)


def viscous(body, friction, more, restitution):
    coefficient = friction * body.mass * np.sqrt(GRAVITY / body.radius)
    law = rr.Viscous(coefficient, restitution=restitution)
    return law, rb.Viscous(coefficient, restitution)


def dry(body, friction, more, restitution):
    # Well below the Painlevé paradox, in which rigid-body mechanics ends.
    friction = min(friction, 0.8 * rr.painleve_friction(body))
    law = rr.Coulomb(friction, static=more * friction, restitution=restitution)
    return law, rb.Coulomb(friction, restitution)


LAWS = [rolling, frictionless, viscous, dry]
shaken_bodies_on_tables = given(
    case=shaken_starts(),
    friction=st.floats(0.02, 0.8),
    more=st.floats(1.0, 1.5),
    restitution=st.sampled_from([0.0, 0.5]),
)


@pytest.mark.parametrize("law", LAWS)
@shaken_bodies_on_tables
@examples(60, derandomize=True)
def test_any_body_on_any_ground(law, case, friction, more, restitution):
    compare(case, *law(case.body, friction, more, restitution))


@pytest.mark.soak
@pytest.mark.parametrize("law", LAWS)
@shaken_bodies_on_tables
@examples(300)
def test_many_bodies_on_many_grounds(law, case, friction, more, restitution):
    compare(case, *law(case.body, friction, more, restitution))


@pytest.mark.parametrize("restitution", [0.0, 0.6])
@pytest.mark.parametrize("law", [viscous, dry])
def test_a_table_that_falls_away_throws_the_body(law, restitution):
    """The rim lands on a table that moves sideways, slides, and is thrown again."""
    body = rr.bodies.can_2007()
    down = rectangular(np.array([0.0, 0.0, -14.0]), 0.1, 1.0)
    shaking = added(down, sine(np.array([4.0, -3.0, 6.0]), 0.15, 3.0))
    start = rr.State(tilt=0.3, tilt_rate=0.5, yaw_rate=-2.0, spin_rate=1.0)
    case = ShakenStart(body, start, shaking, 0.4)
    motion = compare(case, *law(body, 0.25, 1.2, restitution))
    kinds = [event.kind for event in motion.events]
    assert kinds.count("land") >= (4 if restitution else 1)
    assert motion.impact_loss[-1] > 0.0
