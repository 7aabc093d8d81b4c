"""A rim with an imperfection: against impulses by Newton and Euler, and against time stepping."""

from dataclasses import dataclass

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st
from scipy.optimize import brentq, nnls

import rimroll as rr
from given.strategies import bodies, drawn, examples

LAWS = [rr.NoSlip(), rr.Frictionless()]
by_law = pytest.mark.parametrize("law", LAWS, ids=lambda law: law.name)
many = examples(150, derandomize=True)

CAN = rr.bodies.can_2007()
BODIES = {"can": CAN, "disk": rr.bodies.disk(0.1), "ring": rr.bodies.ring(0.1)}

angles = st.floats(1e-3, 2 * np.pi - 1e-3)


def shares(body, law):
    """K' and mR², per J'."""
    k = body.transverse_inertia + (body.mass * body.height**2 if law.name == "no_slip" else 0.0)
    m = body.mass * body.radius**2
    return k / (k + m), m / (k + m)


def toward(azimuth):
    return np.array([np.cos(azimuth), np.sin(azimuth)])


# The collisions, from Newton's and Euler's laws for six velocities alone


@dataclass(frozen=True)
class Velocities:
    """Velocities of the centre of mass and of rotation: e_x points to A on the rim, e_z upward."""

    center: np.ndarray
    rotation: np.ndarray

    @property
    def lean(self):
        """The rate of the axis: rotation × e_z."""
        return np.array([self.rotation[1], -self.rotation[0]])


def rim_point(body, azimuth):
    """From the centre of mass of the upright body."""
    return np.array([*(body.radius * toward(azimuth)), -body.height])


def rows(body, law, azimuth):
    """The velocities of a rim point that the table stops, as rows on the six velocities."""
    x, y, z = rim_point(body, azimuth)
    across = np.array([[0, z, -y], [-z, 0, x], [y, -x, 0]])
    all_three = np.hstack([np.eye(3), across])
    return all_three if law.name == "no_slip" else all_three[2:]


def plastic(body, law, before, struck, held):
    """Newton and Euler with impulses that stop the struck point, and the held one if it must be.

    Returns the velocities after and the upward impulses at both.
    """
    inertia = [body.mass] * 3 + [body.transverse_inertia] * 2 + [body.axial_inertia]
    velocity = np.concatenate([before.center, before.rotation])

    def stop(*azimuths):
        stopped = np.vstack([rows(body, law, azimuth) for azimuth in azimuths])
        # Both points held by sticking: one combination of impulses, along the chord, does nothing.
        response = np.linalg.pinv(stopped / inertia @ stopped.T, rcond=1e-12)
        impulses = -response @ stopped @ velocity
        after = velocity + stopped.T @ impulses / inertia
        return after, impulses.reshape(len(azimuths), -1)[:, -1]

    after, upward = stop(struck)
    if (rows(body, law, held) @ after)[-1] < 0.0:
        after, upward = stop(struck, held)
    return Velocities(after[:3], after[3:]), np.append(upward, 0.0)[:2]


def tipping(body, law, rate):
    """Toward face down, about the tangent at A: no slip there, or no sideways motion at all."""
    rotation = np.array([0.0, -rate, 0.0])
    center = np.cross(rotation, -rim_point(body, 0.0))
    if law.name == "frictionless":
        center[:2] = 0.0
    return Velocities(center, rotation)


def kinetic_energy(body, v):
    a, c = body.transverse_inertia, body.axial_inertia
    inertia = np.array([a, a, c])
    return (body.mass * v.center @ v.center + inertia * v.rotation @ v.rotation) / 2


@by_law
def test_collisions_obey_newton_and_euler(law):
    held = {True: 0, False: 0}

    @many
    @given(bodies(), angles, st.floats(0.1, 10.0))
    def holds(body, angle, rate):
        k, m = shares(body, law)
        assume(abs(k + m * np.cos(angle)) > 1e-9 and abs(k - m) > 1e-6)
        assume(abs(angle - np.pi) > 1e-3)
        before = tipping(body, law, rate)
        arrival = kinetic_energy(body, before)
        rested = 0.0
        for collision in rr.imperfect_rim(body, angle, law, rate).collisions:
            after, impulses = plastic(body, law, before, collision.azimuth, rested)
            size = body.mass * body.radius * rate
            given = collision.impulse, collision.held_impulse
            assert impulses == pytest.approx(given, rel=1e-8, abs=1e-9 * size)
            lean = collision.lean_rate * toward(collision.lean_azimuth)
            assert after.lean == pytest.approx(lean, abs=1e-9 * rate)
            assert after.center[2] == pytest.approx(
                collision.vertical_velocity, abs=1e-9 * rate * body.radius
            )
            # Collisions leave it without spin, and the base's centre without sideways motion.
            assert after.rotation[2] == pytest.approx(0.0, abs=1e-9 * rate)
            glide = body.height * lean if law.name == "no_slip" else np.zeros(2)
            assert after.center[:2] == pytest.approx(
                glide, abs=1e-9 * rate * (body.radius + body.height)
            )
            assert kinetic_energy(body, after) == pytest.approx(
                collision.energy_kept_fraction * arrival, abs=1e-9 * arrival
            )
            held[collision.held_impulse > 0.0] += 1
            before, rested = after, collision.azimuth

    holds()
    assert min(held.values()) > drawn(20)


def test_sticking_collisions_ask_for_the_friction_of_rolling_through_the_near_collision():
    angle = 2.0
    before = tipping(CAN, rr.NoSlip(), 1.0)
    after, (upward, _) = plastic(CAN, rr.NoSlip(), before, angle, 0.0)
    sideways = CAN.mass * (after.center - before.center)[:2]
    assert np.hypot(*sideways) / upward == pytest.approx(
        rr.needed_friction(CAN), rel=1e-12, abs=0.0
    )


@by_law
@pytest.mark.parametrize("body", BODIES.values(), ids=BODIES)
@pytest.mark.parametrize("degrees", [20.0, 75.0, 100.0])
def test_the_rim_strikes_again_where_it_first_comes_down(body, law, degrees):
    """Heights over the table while the body rotates about B: δ + R (q·e_B − |q|) at the lowest."""
    angle = np.radians(degrees)
    first, second = rr.imperfect_rim(body, angle, law).collisions
    start = first.scaled_tilt * toward(0.0)
    rate = first.lean_rate * toward(first.lean_azimuth)

    def clearance(t):
        lean = start[:, None] + rate[:, None] * np.atleast_1d(t)
        return (1.0 + toward(angle) @ lean - np.hypot(*lean)).squeeze()

    longest = (first.scaled_tilt + second.scaled_tilt) / first.lean_rate
    moments = np.linspace(0.0, 1.01, 100_001)[1:] * longest
    below = moments[np.argmax(clearance(moments) < 0.0)]
    struck = start + brentq(clearance, below - 2e-5 * longest, below) * rate
    assert np.hypot(*struck) == pytest.approx(second.scaled_tilt, rel=1e-9, abs=0.0)
    assert struck / np.hypot(*struck) == pytest.approx(toward(second.azimuth), abs=1e-9)


# The whole fall by time stepping, without knowledge of its parts


def stepped(body, law, angle, step=2e-3, far=300.0):
    """Moreau's time stepping: the lean q and the base's height over a cone and a plane.

    At each step the velocity is replaced by the nearest one, in the metric of the kinetic energy,
    that enters neither of them. Returns the direction of the lean once |q| = `far`, and the energy
    that is left.
    """
    k, m = shares(body, law)
    weights = np.sqrt([k, k, m])
    imperfection = toward(angle)
    q = 1.5 / (1 - np.cos(angle)) * toward(0.0)
    z = np.hypot(*q)
    velocity = np.array([-1.0, 0.0, -1.0]) * weights
    turned = 0.0
    while np.hypot(*q) < far:
        half = 0.5 * step * max(np.hypot(*q), 0.05)
        middle, height = q + half * (velocity / weights)[:2], z + half * velocity[2] / weights[2]
        rim = middle / np.hypot(*middle)
        touching = [
            np.array([-e[0], -e[1], 1.0]) / weights
            for e, over in ((rim, 0.0), (imperfection, 1.0))
            if height <= middle @ e + over
        ]
        if touching:
            normals = np.array(touching).T
            velocity = velocity + normals @ nnls(normals, -velocity)[0]
        moved = middle + half * (velocity / weights)[:2]
        z = max(
            height + half * velocity[2] / weights[2],
            np.hypot(*moved),
            1 + moved @ imperfection,
        )
        turned += np.arctan2(q[0] * moved[1] - q[1] * moved[0], q @ moved)
        q = moved
    return turned % (2 * np.pi), velocity @ velocity


@by_law
@pytest.mark.parametrize("body", BODIES.values(), ids=BODIES)
@pytest.mark.parametrize("degrees", [40.0, 110.0, 155.0, 230.0])
def test_the_outcome_is_that_of_stepping_through_time(body, law, degrees):
    end = rr.imperfect_rim(body, np.radians(degrees), law)
    turned, energy = stepped(body, law, np.radians(degrees))
    # Where the lean points at |q| = 300 is 1/300 of a radian or so from where it points in the end.
    assert np.degrees(end.turn) == pytest.approx(np.degrees(turned), abs=0.3)
    assert end.energy_kept_fraction == pytest.approx(energy, abs=0.01)


@by_law
@pytest.mark.parametrize("degrees", [10.0, 60.0, 130.0, 170.0])
def test_after_the_last_collision_the_can_rolls_off_as_simulated(law, degrees):
    """Started just after it, close to the table, the full motion rises in the direction found."""
    end = rr.imperfect_rim(CAN, np.radians(degrees), law, tipping_rate=4.0)
    last = end.collisions[-1]
    tilt = 1e-9 * last.scaled_tilt
    away = last.lean_azimuth - last.azimuth
    yaw_rate = last.lean_rate * np.sin(away) / tilt
    start = rr.State(
        tilt=tilt,
        tilt_rate=last.lean_rate * np.cos(away),
        yaw_rate=yaw_rate,
        spin_rate=-yaw_rate * np.cos(tilt),
    )
    motion = rr.simulate(CAN, start, law, 1.0)
    top = next(event for event in motion.events if event.kind == "tilt_max")
    assert last.azimuth + top.state.yaw == pytest.approx(end.turn, abs=1e-5)
    j = CAN.transverse_inertia + CAN.mass * CAN.radius**2
    j += CAN.mass * CAN.height**2 if law.name == "no_slip" else 0.0
    assert motion.energy[-1] == pytest.approx(j * end.rising_rate**2 / 2, rel=1e-6)


# The paper's statements about the theory


@by_law
def test_an_imperfection_opposite_to_the_contact_is_a_rocking_block(law):
    k, m = shares(CAN, law)
    end = rr.imperfect_rim(CAN, np.pi, law, 2.0)
    assert end.turn == np.pi
    assert end.rising_rate == pytest.approx(2.0 * (k - m), rel=1e-14, abs=0.0)
    (only,) = end.collisions
    assert only.azimuth == np.pi and only.held_impulse == 0.0


@by_law
def test_a_disk_stops_dead_on_an_imperfection_opposite_to_the_contact(law):
    end = rr.imperfect_rim(rr.bodies.disk(0.1), np.pi, law)
    assert end.turn is None and end.rising_rate == end.energy_kept_fraction == 0.0
    assert end.collisions[0].lean_azimuth is None


@by_law
@many
@given(body=bodies(), angle=st.floats(1e-3, np.pi - 1e-3))
def test_the_outcome_depends_on_where_the_imperfection_is(law, body, angle):
    """ "the consequences of the collision would depend on the location": right is left mirrored."""
    left, right = (rr.imperfect_rim(body, a, law) for a in (angle, 2 * np.pi - angle))
    assert left.turn + right.turn == pytest.approx(2 * np.pi, abs=1e-9)
    assert left.energy_kept_fraction == pytest.approx(right.energy_kept_fraction, abs=1e-9)
    assert 0.0 <= left.energy_kept_fraction <= 1.0 + 1e-12


@by_law
def test_no_imperfection_turns_the_can_as_far_as_it_was_seen_to_turn(law):
    places = np.radians(np.linspace(0.5, 359.5, 719))
    turns = np.degrees([rr.imperfect_rim(CAN, angle, law).turn for angle in places])
    assert np.abs(turns - 180.0).max() < 33.0  # the smaller of the measured means


def test_the_example_of_the_docstring():
    fall = rr.imperfect_rim(CAN, np.radians(120.0), rr.NoSlip())
    assert (round(float(np.degrees(fall.turn)), 2), round(fall.energy_kept_fraction, 3)) == (
        195.53,
        0.553,
    )


@pytest.mark.parametrize(
    ("arguments", "complaint"),
    [
        ((CAN, 0.0, rr.NoSlip()), "angle must be inside (0, 2 pi), got 0 rad"),
        ((CAN, 7.0, rr.NoSlip()), "angle must be inside (0, 2 pi), got 7 rad"),
        ((CAN, np.nan, rr.NoSlip()), "angle must be a finite number, got NaN"),
        ((CAN, "half", rr.NoSlip()), "angle must be an angle such as"),
        ((CAN, 1.0, rr.NoSlip(), 0.0), "tipping_rate must be > 0, got 0 rad/s"),
        ((CAN, 1.0, "no_slip"), "law must be a rimroll.Law"),
        ((None, 1.0, rr.NoSlip()), "body must be a rimroll.Body"),
    ],
)
def test_what_cannot_be_computed_is_refused_with_a_sentence(arguments, complaint):
    with pytest.raises(rr.RimrollError) as refusal:
        rr.imperfect_rim(*arguments)
    assert complaint in str(refusal.value)
