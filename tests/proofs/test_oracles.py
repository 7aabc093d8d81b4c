"""The oracles of dry friction, tested against independent results.

Sources of the numbers: the closed forms of Srinivasan & Ruina (2007), the integrations of their
printed equations in `paper_equations`, and conservation laws.
"""

from types import SimpleNamespace

import numpy as np
import pytest

from oracles import inner_problem
from oracles import paper_equations as paper
from oracles import rigid_body as rb


def body(mass=0.070, radius=0.051, height=0.069, transverse=5.13e-3, axial=2.0e-3):
    """A body from its moments of inertia per unit mass (m2)."""
    return SimpleNamespace(
        mass=mass,
        radius=radius,
        height=height,
        transverse_inertia=mass * transverse,
        axial_inertia=mass * axial,
    )


CAN = body()  # of the paper; the axial inertia, 2e-3 m2 per unit mass, is an estimate
RING = body(radius=0.1, height=0.0, transverse=0.005, axial=0.01)
SQUAT = body(mass=0.3, radius=0.08, height=0.03, transverse=4e-3, axial=5e-3)


def start(sideways=0.1, tilt=np.pi / 6, tilt_rate=-0.5, **others):
    """The paper's release, with more yaw and spin (rad/s) than its 0.005."""
    at = {"yaw": 0.3, "spin": -0.2, "yaw_rate": sideways, "spin_rate": sideways}
    return SimpleNamespace(tilt=tilt, tilt_rate=tilt_rate, **{**at, **others})


def inertias(body):
    """K and J: the turn of a rolling body is pi sqrt(J/K)."""
    K = body.transverse_inertia + body.mass * body.height**2
    return K, K + body.mass * body.radius**2


def works_and_landings(motion):
    """All the work done on the body but by gravity (J)."""
    landings = sum(event.landing.work for event in motion.of_kind("landing"))
    return landings + sum(motion.look(motion.end).works.values())


def energy_gained(motion):
    return motion.look(motion.end).energy - motion.look(0.0).energy


# A rigid body on its rim


def test_euler_angles_go_in_and_come_out():
    at = start(tilt=0.4, tilt_rate=-3.0, yaw=-8.0, spin=5.0, yaw_rate=20.0, spin_rate=-7.0)
    motion = rb.follow(CAN, rb.release(CAN, at, slip=(0.3, -0.2)), rb.Coulomb(0.2), 1e-3)
    look = motion.look(0.0)
    assert (look.tilt, look.yaw, look.spin) == pytest.approx((0.4, -8.0, 5.0), rel=1e-14, abs=0.0)
    assert look.rates == pytest.approx((20.0, -3.0, -7.0), rel=1e-13, abs=0.0)
    assert look.slip == pytest.approx((0.3, -0.2), rel=1e-14, abs=0.0)


@pytest.mark.parametrize(
    ("law", "name", "slip"),
    [
        (rb.Rolling(), "no_slip", (0.0, 0.0)),
        (rb.Coulomb(0.0, unilateral=False), "frictionless", "center at rest"),
    ],
)
def test_without_a_choice_of_friction_it_moves_by_the_printed_equations(law, name, slip):
    motion = rb.follow(CAN, rb.release(CAN, start(), slip), law, 0.4)
    printed = paper.integrate(CAN, start(), name, 0.4)
    for t in (0.1, 0.25, 0.4):
        look, states = motion.look(t), printed(t)
        angles = states.phi[0], states.psi[0], states.theta[0]
        assert (look.tilt, look.yaw, look.spin) == pytest.approx(angles, abs=1e-11)
        rates = states.psi_dot[0], states.phi_dot[0], states.theta_dot[0]
        assert look.rates == pytest.approx(rates, rel=1e-10, abs=1e-10)
        force = paper.contact_force(CAN, states, name)
        assert look.normal_force == pytest.approx(force.normal[0], rel=1e-10, abs=0.0)
        assert look.friction_force == pytest.approx(force.friction[:, 0], rel=1e-9, abs=1e-12)
    minimum, printed_minimum = motion.of_kind("tilt_min")[0].t, printed.minima.t[0]
    assert minimum == pytest.approx(printed_minimum, abs=1e-11)
    assert energy_gained(motion) == pytest.approx(0.0, abs=1e-13)


def test_coulomb_friction_holds_slips_holds_again_and_takes_the_energy_that_is_lost():
    motion = rb.follow(CAN, rb.release(CAN, start()), rb.Coulomb(0.3), 0.27)
    kinds = [event.kind for event in motion.events]
    assert kinds == ["slip", "tilt_min", "stick"]
    assert energy_gained(motion) < -1e-4
    assert energy_gained(motion) == pytest.approx(works_and_landings(motion), rel=1e-8)
    for t in np.linspace(0.0, 0.27, 28):
        look = motion.look(t)
        friction, u = look.friction_force, look.slip
        assert look.contact[2] == 0.0
        assert look.normal_force > 0.0
        if look.phase == "stick":
            assert np.hypot(*friction) <= 0.3 * look.normal_force
        else:
            against = -0.3 * look.normal_force * u / np.hypot(*u)
            assert friction == pytest.approx(against, rel=1e-12, abs=0.0)


def test_slip_starts_against_the_friction_that_held_and_grows_like_the_square_of_time():
    motion = rb.follow(CAN, rb.release(CAN, start()), rb.Coulomb(0.2), 0.2)
    (slip,) = motion.of_kind("slip")
    held = motion.look(slip.t).friction_force
    early, late = (motion.look(slip.t + dt).slip for dt in (1e-5, 2e-5))
    assert np.hypot(*late) / np.hypot(*early) == pytest.approx(4.0, rel=1e-3)
    assert early / np.hypot(*early) == pytest.approx(-held / np.hypot(*held), abs=1e-3)


@pytest.mark.parametrize("law", [rb.Rolling(), rb.Coulomb(0.15), rb.Viscous(0.5)])
def test_resistances_take_the_energy_that_is_lost(law):
    resistances = rb.Resistances(
        rolling=0.01, rolling_viscosity=0.002, pivoting=5e-4, air=1e-7, air_exponent=2.5
    )
    state = rb.release(CAN, start(sideways=5.0))
    motion = rb.follow(CAN, state, law, 0.2, resistances=resistances)
    works = motion.look(motion.end).works
    assert all(work < -1e-5 for kind, work in works.items() if kind != "friction")
    assert works["friction"] <= 0.0
    assert energy_gained(motion) == pytest.approx(sum(works.values()), rel=1e-10, abs=0.0)


def test_regularized_friction_tends_to_coulombs():
    state = rb.release(CAN, start(), slip=(0.3, 0.2))
    ends = []
    for smoothing in (2e-3, 1e-3):
        law = rb.Regularized(0.2, 0.2, 1.0, smoothing)
        ends.append(rb.follow(CAN, state, law, 0.02)(0.02))
    coulomb = rb.follow(CAN, state, rb.Coulomb(0.2), 0.02)(0.02)
    first, second = (np.abs(end - coulomb)[rb.VELOCITY].max() for end in ends)
    assert first == pytest.approx(4 * second, rel=1e-2)
    assert second < 1e-5


def test_free_flight_keeps_the_angular_momentum_and_g_falls_freely():
    at = start(sideways=8.0, tilt_rate=3.0)
    state = rb.release(CAN, at, slip=(0.5, 0.3), lift=0.1, lift_rate=1.0)
    motion = rb.follow(CAN, state, rb.Coulomb(0.2), 0.1)
    first, last = motion.look(0.0), motion.look(0.1)
    assert motion.phases[0].kind == "flight" and len(motion.phases) == 1
    momenta = [rb.angular_momentum(CAN, look.attitude) for look in (first, last)]
    assert momenta[1] == pytest.approx(momenta[0], rel=1e-11, abs=0.0)
    fallen = first.center + 0.1 * first.center_velocity - 0.5 * 9.8 * 0.1**2 * rb.E_Z
    assert last.center == pytest.approx(fallen, abs=1e-13)
    assert energy_gained(motion) == pytest.approx(0.0, abs=1e-13)


@pytest.mark.parametrize("restitution", [0.0, 0.5])
def test_a_fast_can_flies_lands_and_takes_no_more_energy_than_it_has_lost(restitution):
    # Faster than the lift-off of a rolling can, 10.605 rad/s.
    state = rb.release(CAN, start(sideways=1.0, tilt=np.radians(5), tilt_rate=-12.0))
    motion = rb.follow(CAN, state, rb.Coulomb(0.3, restitution), 0.0074)
    assert motion.phases[0].kind == "flight"
    # The bounces decrease geometrically, and the last has 1e-9 of a falling speed.
    bounces = len(motion.of_kind("landing"))
    assert bounces == 1 if restitution == 0.0 else 20 < bounces < 40
    assert all(event.landing.work < 0.0 for event in motion.of_kind("landing"))
    assert energy_gained(motion) == pytest.approx(works_and_landings(motion), rel=1e-9, abs=0.0)
    assert motion.events[-1].kind == "stick"


def test_contour_friction_stops_the_spin_and_lays_the_can_flat():
    resistances = rb.Resistances(rolling=0.02, smoothing=0.1)
    motion = rb.follow(
        CAN,
        rb.release(CAN, start(sideways=0.1)),
        rb.Rolling(),
        0.5,
        resistances=resistances,
        rtol=1e-7,
        method="Radau",
    )
    assert [event.kind for event in motion.events] == ["face_down"]
    end = motion.look(motion.end)
    assert abs(end.rates[2] * np.sin(end.tilt)) < 0.01


# Landing


def mobility(tilt=0.5, yaw=0.7):
    return rb.mobility(CAN, rb.Attitude(CAN, rb.release(CAN, start(tilt=tilt, yaw=yaw))))


def brute_force_landing(W, velocity, friction, restitution, steps):
    """Routh's impact in equal steps of normal impulse, by Euler's method."""
    v, impulse, work, compression = velocity.copy(), np.zeros(3), 0.0, None
    step = -velocity[2] / W[2, 2] / steps
    while compression is None or work < (1 - restitution**2) * compression:
        held = np.linalg.solve(W[:2, :2], -v[:2] - step * W[:2, 2])
        sticks = np.hypot(*held) <= friction * step
        push = np.array([*(held if sticks else -friction * step * v[:2] / np.hypot(*v[:2])), step])
        change = W @ push
        work += step * (v[2] + change[2] / 2)
        v, impulse = v + change, impulse + push
        if compression is None and v[2] >= 0.0:
            compression = work
    return v, impulse


def test_a_greased_landing_gives_back_the_velocity_times_the_restitution():
    W = mobility()
    landing = rb.land(W, np.array([0.3, -0.1, -2.0]), 0.0, restitution=0.6)
    assert landing.velocity[2] == pytest.approx(1.2, rel=1e-11, abs=0.0)
    assert landing.impulse == pytest.approx([0.0, 0.0, 3.2 / W[2, 2]], abs=1e-13)


def test_a_landing_that_sticks_from_the_start_has_the_impulse_of_a_hinge():
    W = mobility()
    landing = rb.land(W, np.array([0.0, 0.0, -2.0]), 5.0)
    assert landing.stuck
    assert landing.velocity == pytest.approx([0.0, 0.0, 0.0], abs=1e-12)
    assert landing.impulse == pytest.approx(np.linalg.solve(W, [0.0, 0.0, 2.0]), rel=1e-11, abs=0.0)


def test_a_landing_that_only_slips_one_way_is_amontons():
    # With H = 0 and no sideways slip everything stays in the plane of the tilt.
    W = rb.mobility(RING, rb.Attitude(RING, rb.release(RING, start(yaw=0.0))))
    landing = rb.land(W, np.array([5.0, 0.0, -1.0]), 0.3, restitution=0.5)
    normal = landing.impulse[2]
    assert landing.impulse == pytest.approx([-0.3 * normal, 0.0, normal], abs=1e-14)
    pressing = W[2, 2] - 0.3 * W[2, 0]
    assert normal == pytest.approx(1.5 / pressing, rel=1e-11, abs=0.0)


@pytest.mark.parametrize(
    ("velocity", "friction", "restitution", "ends"),
    [
        ((1.5, 0.7, -1.0), 0.2, 0.5, "slipping"),
        ((0.1, 0.2, -1.0), 0.6, 0.5, "sticking"),
        ((0.1, 0.1, -1.0), 0.2, 0.8, "turned round"),
        ((-0.3, 0.3, -1.0), 0.2, 0.0, "turned aside"),
    ],
)
def test_a_landing_in_space_agrees_with_brute_force(velocity, friction, restitution, ends):
    W, velocity = mobility(tilt=0.05, yaw=0.0), np.array(velocity)
    landing = rb.land(W, velocity, friction, restitution)
    v, impulse = brute_force_landing(W, velocity, friction, restitution, steps=2000)
    # Steps of a 2000th of the compression, and errors of the first order.
    assert landing.velocity == pytest.approx(v, abs=1e-3)
    assert landing.impulse == pytest.approx(impulse, abs=1e-3 / W[2, 2])
    onward = landing.velocity[:2] @ velocity[:2] > 0.0
    assert landing.stuck == (ends == "sticking")
    assert onward == (ends in ("slipping", "turned aside"))
    assert landing.velocity == pytest.approx(velocity + W @ landing.impulse, abs=1e-11)
    # Stronge's restitution never gives energy, whatever the slip does.
    assert landing.normal_work == pytest.approx((1 - restitution**2) * landing.compression_work)
    assert landing.work <= landing.normal_work


# The inner problem of the near collision


@pytest.mark.parametrize("rolls", [CAN, RING, SQUAT])
def test_inner_problem_has_the_closed_forms_of_no_friction_and_of_enough(rolls):
    K, J = inertias(rolls)
    A = rolls.transverse_inertia
    needed = rolls.mass * rolls.height * rolls.radius / K
    sliding = inner_problem.near_collision(rolls, 0.0)
    sticking = inner_problem.near_collision(rolls, needed + 1e-3)
    assert sliding.turn == pytest.approx(np.pi * np.sqrt((A + J - K) / A), abs=1e-11)
    assert sticking.turn == pytest.approx(np.pi * np.sqrt(J / K), abs=1e-11)
    assert sticking.phases == ("stick",)
    for departure in (sliding, sticking):
        assert departure.tilt_rate == pytest.approx(1.0, abs=1e-11)


@pytest.mark.parametrize("spin", [-3.0, 2.0, 10.0])
def test_inner_problem_has_the_closed_form_of_a_spinning_rim_that_cannot_slip(spin):
    K, J = inertias(CAN)
    swing = CAN.mass * CAN.height * CAN.radius * spin / (2.0 * np.sqrt(J * K))
    departure = inner_problem.near_collision(CAN, np.inf, spin=spin, omega=2.0)
    # The lines are cut where w/omega = 1e-10, and spin makes that count once, not squared.
    expected = np.sqrt(J / K) * (np.pi + 2 * np.arctan(swing))
    assert departure.turn == pytest.approx(expected, abs=1e-9)


def test_inner_problem_of_a_ring_knows_no_friction():
    for friction in (0.1, 0.5):
        assert inner_problem.near_collision(RING, friction).turn == pytest.approx(
            np.pi * np.sqrt(3), abs=1e-11
        )


@pytest.mark.parametrize(
    ("friction", "sticking", "sliding"),
    # Degrees: if the tipping phase sticks, and let go at 30 degrees with -0.5 rad/s. From an
    # independent integration in the rates of tilt and yaw.
    [(0.05, 218.4468, 220.5720), (0.15, 212.7315, 214.9925), (0.25, 207.0289, 207.0289)],
)
def test_inner_problem_turns_the_can_by_the_known_angles(friction, sticking, sliding):
    turn = inner_problem.near_collision(CAN, friction).turn
    assert np.degrees(turn) == pytest.approx(sticking, abs=6e-5)
    turn = inner_problem.turn_after_tipping(CAN, friction, np.pi / 6, -0.5)
    assert np.degrees(turn) == pytest.approx(sliding, abs=6e-5)


def test_inner_problem_has_no_scale():
    turn = inner_problem.near_collision(CAN, 0.2, slip=-0.1, spin=1.0, omega=2.0).turn
    faster = inner_problem.near_collision(CAN, 0.2, slip=-0.3, spin=3.0, omega=6.0).turn
    assert faster == pytest.approx(turn, abs=1e-11)


def test_inner_problem_is_what_a_rigid_body_does_at_small_tilts():
    slip, spin, omega, tilt = -0.3, 1.0, 5.0, 1e-4
    expected = inner_problem.near_collision(CAN, 0.2, slip, spin, omega)
    at = start(tilt=tilt, tilt_rate=-omega, yaw=0.0, yaw_rate=0.02 / tilt)
    at.spin_rate = spin - at.yaw_rate * np.cos(tilt)
    # On the arriving line the slip turns with the yaw against the velocities of G and of the lean.
    arriving = np.arctan2(0.02, omega)
    inertial = np.array([slip + CAN.height * omega, CAN.radius * spin])
    e_x1 = np.array([np.cos(arriving), np.sin(arriving)])
    e_y1 = np.array([-e_x1[1], e_x1[0]])
    lean_rate = np.array([-omega, 0.02])
    carried = CAN.height * lean_rate - [0.0, CAN.radius * spin]
    u = np.array([inertial @ e_x1, inertial @ e_y1]) + carried
    motion = rb.follow(CAN, rb.release(CAN, at, slip=tuple(u)), rb.Coulomb(0.2), 6e-5, rtol=1e-9)
    look = motion.look(motion.end)
    yaw_rate, tilt_rate, spin_rate = look.rates
    leaving = look.yaw + np.arctan2(yaw_rate * np.sin(look.tilt), tilt_rate)
    assert leaving + arriving == pytest.approx(expected.turn, abs=2e-3)
    assert tilt_rate == pytest.approx(expected.tilt_rate, rel=1e-3)
    about_axis = spin_rate + yaw_rate * np.cos(look.tilt)
    assert about_axis == pytest.approx(expected.spin_rate, rel=1e-3)
