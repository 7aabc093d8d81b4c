"""The paper's approximations against computed motions: where they hold, and how well."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

import rimroll as rr
from given.strategies import bodies, drawn, examples, rockings, sizes

LAWS = [rr.NoSlip(), rr.Frictionless()]
by_law = pytest.mark.parametrize("law", LAWS, ids=lambda law: law.name)
few = examples(60, derandomize=True)

CAN = rr.bodies.can_2007()
PAPER_START = rr.State(tilt=np.pi / 6, tilt_rate=-0.5, yaw_rate=0.005, spin_rate=0.005)


def near_collisions(law):
    """A near-collision of any body, at any closeness and pace."""
    return st.builds(
        rr.NearCollision,
        bodies(),
        st.just(law),
        min_tilt=sizes(1e-12, 1e-2),
        tipping_rate=sizes(0.1, 30.0),
        direction=st.sampled_from([-1.0, 1.0]),
    )


def order(tilt):
    """phi_c ln phi_c, the size of what the approximations leave out."""
    return -tilt * np.log(tilt)


# The near-collision by itself


@by_law
@few
@given(body=bodies(), min_tilt=sizes(1e-12, 1e-2), rate=sizes(0.1, 30.0))
def test_a_near_collision_turns_by_the_limit_in_all(law, body, min_tilt, rate):
    near = rr.NearCollision(body, law, min_tilt, rate)
    far = 1e16 * min_tilt / rate
    before, at_least_tilt, after = near.yaw([-far, 0.0, far])
    assert after - before == pytest.approx(rr.turn_limit(body, law), rel=1e-14, abs=0.0)
    assert at_least_tilt == 0.0 and after == -before


@by_law
def test_a_near_collision_is_a_hyperbola_in_time_and_an_arctangent_in_yaw(law):
    """The paper, Eqs. phiandt and psidotandphi."""

    @few
    @given(near_collisions(law), st.floats(-50.0, 50.0))
    def holds(near, times):
        t = times * near.min_tilt / near.tipping_rate
        (tilt,), (yaw_rate,), (fastest,) = near.tilt(t), near.yaw_rate(t), near.yaw_rate(0.0)
        assert tilt == pytest.approx(near.min_tilt * np.hypot(1.0, times), rel=1e-14, abs=0.0)
        # l = psi_dot phi^2 is conserved: the paper's b_2.
        assert yaw_rate * tilt**2 == pytest.approx(fastest * near.min_tilt**2, rel=1e-14, abs=0.0)
        stretch = near.yaw(1e16 * near.min_tilt / near.tipping_rate)[0] / (np.pi / 2)
        # Below the smallest normal double fewer digits are left.
        assert near.yaw(t)[0] == pytest.approx(stretch * np.arctan(times), rel=1e-14, abs=1e-300)
        assert fastest == pytest.approx(
            stretch * near.tipping_rate / near.min_tilt, rel=1e-14, abs=0.0
        )

    holds()


def test_the_direction_is_the_sign_of_the_turn():
    left, right = (rr.NearCollision(CAN, rr.NoSlip(), 1e-3, 2.0, sign) for sign in (1, -1))
    times = np.linspace(-0.01, 0.01, 11)
    np.testing.assert_array_equal(left.yaw(times), -right.yaw(times))
    np.testing.assert_array_equal(left.tilt(times), right.tilt(times))
    assert left.yaw_rate(0.0)[0] > 0.0


@pytest.mark.parametrize(
    ("numbers", "complaint"),
    [
        ((0.0, 2.0), "min_tilt must be > 0, got 0 rad"),
        ((1e-3, -2.0), "tipping_rate must be > 0, got -2 rad/s"),
        ((1e-3, np.nan), "tipping_rate must be a finite number, got NaN"),
        ((1e-3, 2.0, 0.5), "direction must be 1 or -1, got 0.5"),
    ],
)
def test_what_is_no_near_collision_is_refused_with_a_sentence(numbers, complaint):
    with pytest.raises(rr.RimrollError) as refusal:
        rr.NearCollision(CAN, rr.NoSlip(), *numbers)
    assert complaint in str(refusal.value)


def computed_near_collision(law, sideways):
    """The can's near-collision within three times its smallest tilt, and the formula for it."""
    start = replace(PAPER_START, yaw_rate=sideways, spin_rate=sideways)
    motion = rr.simulate(CAN, start, law, 0.4, gravity=9.8, rtol=1e-13)
    (low,) = (event for event in motion.events if event.kind == "tilt_min")
    rate = rr.composite(CAN, start, law, 9.8).tipping_rate
    fine = motion.samples(8)
    close = fine.tilt < 3 * low.state.tilt
    formula = rr.NearCollision(CAN, law, low.state.tilt, rate)
    return low, fine, close, formula


@by_law
def test_a_computed_near_collision_is_the_formula_the_better_the_closer(law):
    errors = []
    for sideways in 1e-2, 1e-3, 1e-4:
        low, fine, close, formula = computed_near_collision(law, sideways)
        t = fine.t[close] - low.t
        tilt = np.abs(formula.tilt(t) / fine.tilt[close] - 1).max()
        yaw = np.abs(formula.yaw(t) - (fine.yaw[close] - low.state.yaw)).max()
        rate = np.abs(formula.yaw_rate(t) / fine.yaw_rate[close] - 1).max()
        assert close.sum() > 100
        errors.append(np.array([tilt, yaw, rate]) / order(low.state.tilt))
    # The part that is left out stays the same part of phi_c ln phi_c.
    for error in errors:
        assert (error < 10.0).all()
        np.testing.assert_array_less(error / errors[0], 1.5)


# The lean as a vector in the plane


@by_law
def test_the_lean_vector_moves_as_the_near_collision(law):
    """The paper's heuristic and its small-angle treatment are the same motion."""

    @few
    @given(near_collisions(law), sizes(0.1, 1e3))
    def holds(near, times):
        until = times * near.min_tilt / near.tipping_rate
        t, tilt, yaw = near.lean_vector(until)
        assert t.shape == tilt.shape == yaw.shape
        assert (t[0], tilt[0], yaw[0]) == (0.0, near.min_tilt, 0.0)
        assert 0.5 * until < t[-1] <= until and (np.diff(t) > 0.0).all()
        np.testing.assert_allclose(tilt, near.tilt(t), rtol=1e-11)
        np.testing.assert_allclose(yaw, near.yaw(t), rtol=1e-11, atol=1e-12)

    holds()


@by_law
def test_the_lean_vector_turns_by_half_the_limit_on_its_way_out(law):
    near = rr.NearCollision(CAN, law, 1e-6, 5.0)
    _, tilt, yaw = near.lean_vector(1.0)
    missing = near.min_tilt / tilt[-1]
    assert yaw[-1] == pytest.approx(rr.turn_limit(CAN, law) / 2, abs=2 * missing)


def test_the_lean_of_a_thin_tall_body_runs_straight():
    """J'/K' near 1: no force, so a turn by pi, as of a pencil."""
    pencil = rr.bodies.cylinder(1e-4, 1.0)
    near = rr.NearCollision(pencil, rr.NoSlip(), 1e-4, 1.0)
    t, tilt, yaw = near.lean_vector(1e-2)
    np.testing.assert_allclose(tilt * np.cos(yaw), near.min_tilt, rtol=1e-5)
    np.testing.assert_allclose(tilt * np.sin(yaw), t, rtol=1e-5)


# The composite approximation


@by_law
def test_composite_errors_shrink_as_phi_c_ln_phi_c_for_any_body(law):
    """Ten times smaller yaw and spin rates: ten times smaller errors, but for the logarithm.

    For yaw, that is; where the contact point runs, all of it is the lateness of the collision. The
    tilt, which is itself of the order of phi_c there, has errors of the order of phi_c^2.
    """
    tried = []

    @examples(40, derandomize=True)
    @given(rockings())
    def holds(rocking):
        (tilt, yaw), (closer_tilt, closer_yaw) = (
            composite_errors(rocking, law, part) for part in (1e-2, 1e-3)
        )
        assert closer_yaw < 0.25 * yaw
        assert closer_tilt < 0.03 * tilt
        tried.append(rocking)

    holds()
    assert len(tried) >= drawn(30)


def composite_errors(rocking, law, part):
    """Largest errors of tilt and yaw when yaw and spin rates are this part of what they were."""
    body, start, gravity = rocking.body, rocking.start, rocking.gravity
    start = replace(start, yaw_rate=start.yaw_rate * part, spin_rate=start.spin_rate * part)
    try:
        composite = rr.composite(body, start, law, gravity)
    except rr.RimrollError as refusal:
        assert "lifted off" in str(refusal)
        assume(False)
    end = composite.min_tilt_time + composite.half_width
    motion = rr.simulate(body, start, law, end, gravity=gravity, rtol=1e-13)
    assume(motion.status == "finished")
    # It covers one rocking, which begins at the top if the body is released upward.
    now = motion.evaluate(motion.t[motion.t >= composite.min_tilt_time - composite.half_width])
    tilt_error = np.abs(composite.tilt(now.t) - now.tilt).max()
    return tilt_error, np.abs(composite.yaw(now.t) - now.yaw).max()


@by_law
def test_the_start_alone_tells_the_near_collision_of_the_can(law):
    """Least tilt and time, from a pendulum and a linear equation, to the order left out."""
    for sideways in 1e-1, 1e-3, 1e-5:
        start = replace(PAPER_START, yaw_rate=sideways, spin_rate=sideways)
        composite = rr.composite(CAN, start, law, 9.8)
        motion = rr.simulate(CAN, start, law, 0.4, gravity=9.8, rtol=1e-13)
        low = next(event for event in motion.events if event.kind == "tilt_min")
        scale = order(low.state.tilt)
        assert composite.min_tilt == pytest.approx(low.state.tilt, rel=2 * scale)
        lasts = low.state.tilt / composite.tipping_rate
        assert abs(composite.min_tilt_time - low.t) < 10 * scale * lasts + 1e-15


@by_law
def test_a_composite_rocking_is_its_own_mirror_image(law):
    composite = rr.composite(CAN, PAPER_START, law, 9.8)
    away = np.linspace(0.0, composite.half_width, 50)
    before, after = composite.min_tilt_time - away, composite.min_tilt_time + away
    np.testing.assert_allclose(composite.tilt(before), composite.tilt(after), rtol=1e-12)
    middle = composite.yaw(composite.min_tilt_time)
    np.testing.assert_allclose(
        composite.yaw(after) - middle, middle - composite.yaw(before), rtol=1e-12
    )
    assert composite.tilt(composite.min_tilt_time)[0] == pytest.approx(
        composite.min_tilt, rel=1e-9, abs=0.0
    )


@by_law
def test_a_composite_rocking_turns_by_the_limit_but_for_what_the_arctangent_leaves(law):
    composite = rr.composite(CAN, PAPER_START, law, 9.8)
    ends = composite.min_tilt_time + composite.half_width * np.array([-1.0, 1.0])
    before, after = composite.yaw(ends)
    limit = rr.turn_limit(CAN, law)
    left = 2 * limit / np.pi * composite.min_tilt / (composite.tipping_rate * composite.half_width)
    assert limit - (after - before) == pytest.approx(left, rel=1e-5)


@by_law
@pytest.mark.parametrize("tilt_rate", [-0.5, 0.0, 0.5])
def test_a_composite_rocking_goes_through_the_release_and_both_tops(law, tilt_rate):
    """Released upward or downward, it is the rocking from the top before to the top after."""
    start = replace(PAPER_START, tilt_rate=tilt_rate, yaw_rate=1e-6, spin_rate=1e-6, yaw=1.0)
    composite = rr.composite(CAN, start, law, 9.8)
    first = composite.min_tilt_time - composite.half_width
    assert np.sign(first) == np.sign(tilt_rate)
    step = 1e-4 * composite.half_width
    top, later = composite.tilt([first, first + step])
    assert 0.0 < top - later < 1e-6
    if first <= 0.0:
        assert composite.tilt(0.0)[0] == pytest.approx(start.tilt, rel=1e-9, abs=0.0)
    assert composite.yaw(first)[0] == pytest.approx(1.0, abs=1e-6)


@by_law
def test_reversed_yaw_and_spin_reverse_the_composite_turn(law):
    start = replace(PAPER_START, yaw_rate=-0.005, spin_rate=-0.005)
    one, other = rr.composite(CAN, PAPER_START, law, 9.8), rr.composite(CAN, start, law, 9.8)
    times = np.linspace(0.0, one.min_tilt_time + one.half_width, 20)
    np.testing.assert_array_equal(one.tilt(times), other.tilt(times))
    np.testing.assert_allclose(one.yaw(times), -other.yaw(times), rtol=1e-14, atol=1e-16)


def test_a_body_flicked_too_fast_to_come_from_a_top_is_approximated_from_its_release():
    """Continued backward, it comes from beyond the balance point."""
    start = replace(PAPER_START, tilt_rate=-4.0)
    composite = rr.composite(CAN, start, rr.NoSlip(), 9.8)
    assert composite.min_tilt_time == composite.half_width
    assert composite.tilt(0.0)[0] == pytest.approx(start.tilt, rel=1e-6)


@pytest.mark.parametrize(
    ("changed", "complaint"),
    [
        ({"yaw_rate": 0.0, "spin_rate": 0.0}, "with hardly any yaw rate and spin rate"),
        ({"tilt_rate": 5.0}, "its plane pendulum does not come down: toppled"),
        ({"tilt_rate": -11.0}, "its plane pendulum does not come down: lifted off"),
    ],
)
def test_a_start_without_a_near_collision_is_refused_with_the_reason(changed, complaint):
    with pytest.raises(rr.RimrollError) as refusal:
        rr.composite(CAN, replace(PAPER_START, **changed), rr.NoSlip())
    assert "this start has no near-collision" in str(refusal.value)
    assert complaint in str(refusal.value)


def test_times_outside_the_composite_rocking_are_refused():
    composite = rr.composite(CAN, PAPER_START, rr.NoSlip(), 9.8)
    late = composite.min_tilt_time + 1.01 * composite.half_width
    for t, name in (
        (late, "t"),
        (-0.1, "t"),
        ([composite.min_tilt_time, late], r"t\[1\]"),
        (np.nan, "t"),
    ):
        with pytest.raises(rr.RimrollError, match=f"^{name} must be inside the rocking"):
            composite.tilt(t)
        with pytest.raises(rr.RimrollError, match=f"^{name} must be inside the rocking"):
            composite.yaw(t)


def test_gravity_of_the_composite_rocking_is_standard_unless_given():
    default = rr.composite(CAN, PAPER_START, rr.NoSlip())
    given = rr.composite(CAN, PAPER_START, rr.NoSlip(), rr.STANDARD_GRAVITY)
    assert (
        default.min_tilt_time
        == given.min_tilt_time
        != rr.composite(CAN, PAPER_START, rr.NoSlip(), 9.8).min_tilt_time
    )
