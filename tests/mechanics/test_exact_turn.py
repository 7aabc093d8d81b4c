"""Exact turns by quadrature, against multiprecision, against whole motions, and by themselves."""

from __future__ import annotations

import signal
import time
from dataclasses import fields
from types import SimpleNamespace

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st
from mpmath import mp

import rimroll as rr
from given.motions import CAN, LAWS, PAPER_GRAVITY, by_law, sixty_starts
from given.strategies import bodies, examples, rockings
from oracles import rolling_disk, tabulated_turns, taylor_turns
from rimroll.motion.jacobian import PARAMETERS
from rimroll.theory.exact import CHUNK, NUMBERS

FIELDS = tuple(field.name for field in fields(rr.State))
BODY = tabulated_turns.BODY
ROWS = tabulated_turns.rows()
ALL_KINDS = tabulated_turns.KINDS | tabulated_turns.TOPPLING

START = rr.State(tilt=0.4, tilt_rate=-0.5, yaw_rate=0.02, spin_rate=-0.01)


def states(rows):
    """Rows with the fields of a State as one State of arrays."""
    return rr.State(
        **{name: np.array([getattr(row, name, 0.0) for row in rows]) for name in FIELDS}
    )


def same(one, other, rows=slice(None)):
    """Whether turns have the same bits."""
    numbers = all(
        np.array_equal(getattr(one, name), getattr(other, name)[rows], equal_nan=True)
        for name in NUMBERS
    )
    return numbers and np.array_equal(one.outcome, other.outcome[rows])


# Against multiprecision


@by_law
def test_sixty_turns_of_the_can_are_right_to_1e_12(law):
    rows = sixty_starts()
    start = states([SimpleNamespace(**row) for row in rows])
    found = rr.exact_turn(CAN, start, law, gravity=PAPER_GRAVITY)
    assert set(found.outcome) == {"rocked"}
    known = {
        name: np.array([row[f"{name}_{law.name}"] for row in rows])
        for name in ("turn", "min_tilt", "t")
    }
    assert np.abs(found.turn - known["turn"]).max() < 1e-12
    assert np.abs(found.min_tilt / known["min_tilt"] - 1.0).max() < 1e-12
    assert np.abs(found.end_time - known["t"]).max() < 1e-11


def errors(row, law):
    """Errors of the turn (rad) and relative errors of the other numbers; None without a turn."""
    known = row.turns[law.name]
    found = rr.exact_turn(
        rr.Body(**vars(row.body)),
        rr.State(**vars(row.start)),
        law,
        gravity=row.gravity,
        topple_tilt=row.topple_tilt,
    )
    assert found.outcome == known.outcome, row
    if known.outcome == "fell_back":
        assert np.isnan([getattr(found, name) for name in NUMBERS]).all()
        return None
    off = {
        name: float(abs(getattr(found, name) / getattr(known, name) - 1))
        for name in ("min_tilt", "end_tilt", "end_time")
    }
    # A release at the smallest tilt has no time of its own: times are measured against the turn's.
    off["min_tilt_time"] = float(abs(found.min_tilt_time - known.min_tilt_time) / known.end_time)
    return {"turn": float(abs(found.turn - known.turn)), **off}


@by_law
@pytest.mark.parametrize("kind", ALL_KINDS, ids=lambda kind: kind.__name__)
def test_turns_of_bodies_and_starts_of_all_kinds_are_right_to_1e_12(kind, law):
    rows = [row for row in ROWS if row.kind == kind.__name__]
    assert len(rows) == ALL_KINDS[kind]
    for row in rows:
        if off := errors(row, law):
            assert off["turn"] < 1e-12, (off, row)
            assert off["min_tilt"] < 1e-12 and off["end_tilt"] < 1e-12, (off, row)
            assert off["min_tilt_time"] < 2e-11 and off["end_time"] < 2e-11, (off, row)


@by_law
def test_where_rounding_of_the_start_moves_the_turn_by_more_that_bounds_the_error(law):
    """A coin that stands on its edge but for 5e-7, slowly turning, and takes long to come down."""
    coin = rr.Body(0.00381088, 8.95048, 0.0, 0.152647, 0.305294)
    start = rr.State(
        tilt=1.5707958578442116,
        tilt_rate=9.955968046307476e-08,
        yaw_rate=-0.00315188,
        spin_rate=-6.12253e-07,
    )
    found = rr.exact_turn(coin, start, law, gravity=1.62, jacobian=True)
    turn = turn_in_digits(with_digits(coin, start, 1.62), law)
    moved = {
        name: abs(value * found.jacobian[name]) * np.finfo(float).eps
        for name, value in with_digits(coin, start, 1.62).items()
    }
    assert 5e-12 < sum(moved.values()) < 5e-11
    assert float(abs(found.turn - turn)) < 10.0 * sum(moved.values())


@pytest.mark.parametrize(
    ("body", "yaw_rate", "spin_rate"),
    [
        pytest.param(rr.bodies.disk(0.02), 0.03, 0.05, id="disk"),
        pytest.param(rr.bodies.ring(0.1), -0.4, 0.2, id="ring"),
        pytest.param(rr.Body(0.3, 0.1, 0.0, 0.003, 0.005), 1.0, -2.0, id="thick"),
    ],
)
@pytest.mark.slow
def test_a_rolling_disk_turns_as_appell_and_korteweg_have_it(body, yaw_rate, spin_rate):
    start = rr.State(tilt=0.7, yaw_rate=yaw_rate, spin_rate=spin_rate)
    found = rr.exact_turn(body, start, rr.NoSlip())
    turn, min_tilt = rolling_disk.turn(body, start, rr.STANDARD_GRAVITY)
    assert found.end_tilt == pytest.approx(0.7, rel=1e-14, abs=0.0)
    assert float(abs(found.turn - turn)) < 1e-13
    assert float(abs(found.min_tilt / min_tilt - 1)) < 1e-13


@pytest.mark.parametrize(("law"), LAWS, ids=lambda law: law.name)
def test_towards_a_face_down_collision_the_turn_tends_to_its_limit(law):
    for rate in (1e-6, 1e-9, 1e-12, 1e-13):
        start = rr.State(tilt=np.pi / 6, tilt_rate=-0.5, yaw_rate=rate, spin_rate=rate)
        found = rr.exact_turn(CAN, start, law, gravity=PAPER_GRAVITY)
        assert 0.01 * rate < found.min_tilt < 0.1 * rate
        assert 0.0 < found.turn - rr.turn_limit(CAN, law) < 5.0 * rate or rate < 1e-11
        assert found.turn == pytest.approx(rr.turn_limit(CAN, law), abs=5.0 * rate + 1e-14)


# Against whole motions


OUTCOMES = {"finished": "rocked", "toppled": "toppled", "lifted_off": "lifted_off"}


def outcome_of(motion):
    """The outcome of a body's first turn, from its whole motion."""
    if motion.turns:
        return "rocked"
    came_down = any(event.kind == "tilt_min" for event in motion.events)
    if motion.status == "lifted_off" and came_down:
        return "toppled" if motion.tilt[-1] > rr.balance_tilt(motion.body) else "lifted_off"
    return "fell_back" if motion.status == "toppled" and not came_down else motion.status


@examples(100)
@given(rockings(least_sideways=1e-9), st.sampled_from(LAWS))
def test_an_exact_turn_is_the_first_of_the_motion(rocking, law):
    body, start, gravity = rocking.body, rocking.start, rocking.gravity
    found = rr.exact_turn(body, start, law, gravity=gravity)
    motion = rr.simulate(body, start, law, 4.0 * rocking.time, gravity=gravity, rtol=1e-12)
    assume(motion.turns or motion.status != "finished")
    assert found.outcome == outcome_of(motion)
    if found.outcome == "rocked":
        turn = motion.turns[0]
        assert found.turn == pytest.approx(turn.angle, abs=1e-9)
        assert found.min_tilt == pytest.approx(turn.min_tilt, rel=1e-8)
        assert found.end_tilt == pytest.approx(turn.max_tilt, rel=1e-9, abs=0.0)
        assert found.min_tilt_time == pytest.approx(turn.t, rel=1e-9, abs=0.0)
        assert found.end_time == pytest.approx(turn.end, rel=1e-9, abs=0.0)


@st.composite
def throws(draw):
    """Bodies with starts of all outcomes."""
    body = draw(bodies())
    natural = np.sqrt(9.8 / body.radius)
    rate = st.integers(-1000, 1000).map(lambda rate: 1e-3 * rate * natural)
    tilt = draw(st.floats(0.02, 1.5))
    return body, rr.State(
        tilt=tilt, tilt_rate=draw(rate), yaw_rate=draw(rate), spin_rate=draw(rate)
    )


@examples(100)
@given(throws(), st.sampled_from(LAWS))
def test_what_becomes_of_a_body_is_what_its_motion_says(throw, law):
    """Short of the vertical, past which a disk falls to its other face."""
    body, start = throw
    found = rr.exact_turn(body, start, law, topple_tilt=1.55)
    duration = 30.0 * np.sqrt(body.radius / 9.8)
    motion = rr.simulate(body, start, law, duration, topple_tilt=1.55)
    assume(motion.turns or motion.status != "finished")
    assert found.outcome == outcome_of(motion)
    for name in NUMBERS:
        assert np.isfinite(getattr(found, name)) or found.outcome != "rocked"


CASES = {
    "rocked": START,
    "toppled": rr.State(tilt=0.35, tilt_rate=-5.0, yaw_rate=0.05),
    "fell_back": rr.State(tilt=0.8, yaw_rate=0.05),
    "lifted_off": rr.State(tilt=0.3, tilt_rate=-11.0, yaw_rate=0.05),
    "face_down": rr.State(tilt=0.3),
}


@pytest.mark.parametrize("outcome", CASES)
def test_each_outcome_is_named_and_only_what_comes_down_and_rises_has_a_turn(outcome):
    found = rr.exact_turn(CAN, CASES[outcome], rr.NoSlip())
    assert found.outcome == outcome
    turned = [bool(np.isfinite(getattr(found, name))) for name in ("turn", "end_tilt", "end_time")]
    assert turned == [outcome in ("rocked", "toppled")] * 3


def test_a_topple_tilt_may_be_given():
    start = rr.State(tilt=0.5, yaw_rate=0.05)
    assert rr.exact_turn(CAN, start, rr.NoSlip()).outcome == "rocked"
    found = rr.exact_turn(CAN, rr.State(tilt=0.3, tilt_rate=-2.0, yaw_rate=0.05), rr.NoSlip())
    assert found.outcome == "rocked"
    lower = found.end_tilt - 1e-6
    again = rr.exact_turn(
        CAN, rr.State(tilt=0.3, tilt_rate=-2.0, yaw_rate=0.05), rr.NoSlip(), topple_tilt=lower
    )
    assert again.outcome == "toppled"


# Arrays


def some_starts(count, seed=1):
    random = np.random.default_rng(seed)
    return rr.State(
        tilt=random.uniform(0.2, 0.8, count),
        tilt_rate=random.uniform(-4.0, 1.0, count),
        yaw_rate=random.uniform(-0.5, 0.5, count),
        spin_rate=random.uniform(-0.5, 0.5, count),
    )


@by_law
def test_the_bits_depend_on_neither_threads_nor_order_nor_company(law):
    starts = some_starts(101)
    whole = rr.exact_turn(CAN, starts, law, threads=1)
    assert len(set(whole.outcome)) > 1
    for threads in (2, 3):
        assert same(rr.exact_turn(CAN, starts, law, threads=threads), whole)
    order = np.random.default_rng(2).permutation(101)
    mixed = rr.exact_turn(CAN, one_of(starts, order), law)
    assert same(mixed, whole, order)
    for k in range(0, 101, 10):
        alone = rr.exact_turn(CAN, one_of(starts, k), law)
        assert same(alone, whole, k)


def one_of(starts, rows):
    """Some rows of a State of arrays, where a single number stands for all rows."""
    return rr.State(**{f: np.broadcast_to(getattr(starts, f), starts.shape)[rows] for f in FIELDS})


def test_splitting_into_parts_leaves_no_seam():
    count = CHUNK + 3
    starts = rr.State(tilt=np.linspace(0.2, 0.5, count), yaw_rate=0.01, spin_rate=0.01)
    whole = rr.exact_turn(CAN, starts, rr.Frictionless())
    last = slice(count - 5, None)
    assert same(rr.exact_turn(CAN, one_of(starts, last), rr.Frictionless()), whole, last)


@pytest.mark.parametrize("shape", [(0,), (1,), (7,), (2, 3), (2, 0), (1, 2, 3)])
def test_results_have_the_shape_of_the_start(shape):
    start = rr.State(tilt=np.full(shape, 0.3), yaw_rate=0.01)
    found = rr.exact_turn(CAN, start, rr.NoSlip(), jacobian=True)
    for name in (*NUMBERS, "outcome"):
        assert getattr(found, name).shape == shape
    assert tuple(found.jacobian) == PARAMETERS
    for derivative in found.jacobian.values():
        assert derivative.shape == shape
    assert np.all(found.outcome == "rocked")


def test_a_single_start_has_single_numbers():
    found = rr.exact_turn(CAN, START, rr.NoSlip(), jacobian=True)
    assert isinstance(found.outcome, str)
    numbers = [getattr(found, name) for name in NUMBERS] + list(found.jacobian.values())
    assert all(isinstance(number, float) for number in numbers)
    assert rr.exact_turn(CAN, START, rr.NoSlip()).jacobian is None


def test_yaw_and_spin_at_the_start_do_not_matter():
    turned = rr.State(**{**{f: getattr(START, f) for f in FIELDS}, "yaw": 2.0, "spin": -1.0})
    for law in LAWS:
        assert rr.exact_turn(CAN, turned, law).turn == rr.exact_turn(CAN, START, law).turn


@by_law
@examples(50)
@given(rockings())
def test_mirrored_starts_turn_the_other_way(law, rocking):
    body, start = rocking.body, rocking.start
    mirrored = rr.State(
        tilt=start.tilt,
        tilt_rate=start.tilt_rate,
        yaw_rate=-start.yaw_rate,
        spin_rate=-start.spin_rate,
    )
    one, other = (
        rr.exact_turn(body, each, law, gravity=rocking.gravity) for each in (start, mirrored)
    )
    assert one.outcome == other.outcome
    assert np.array_equal(one.turn, -other.turn, equal_nan=True)
    assert np.array_equal(one.min_tilt, other.min_tilt, equal_nan=True)


# Derivatives


def with_digits(body, start, gravity):
    """All parameters of a turn, by name."""
    named = {name: getattr(body, name) for name in BODY}
    named |= {name: getattr(start, name) for name in FIELDS}
    return named | {"gravity": gravity}


def turn_in_digits(named, law):
    """The first turn by Taylor series, to 20 digits."""
    body = SimpleNamespace(**{name: named[name] for name in BODY})
    start = SimpleNamespace(**{name: named[name] for name in FIELDS})
    return taylor_turns.first_turn(body, law.name, start, named["gravity"], digits=36).turn


@by_law
@pytest.mark.parametrize(
    "start",
    [
        pytest.param(START, id="falling"),
        pytest.param(
            rr.State(tilt=0.3, tilt_rate=0.4, yaw_rate=0.3, spin_rate=0.5),
            id="rising",
            marks=pytest.mark.soak,
        ),
    ],
)
@pytest.mark.slow
def test_the_derivatives_are_those_of_turns_in_multiprecision(law, start):
    given = with_digits(CAN, start, 9.8)
    found = rr.exact_turn(CAN, start, law, gravity=9.8, jacobian=True)
    turn = turn_in_digits(given, law)
    for name in set(PARAMETERS) - {"yaw", "spin"}:
        with mp.workdps(36):
            step = abs(given[name]) * mp.mpf(10) ** -11
            changed = turn_in_digits({**given, name: given[name] + step}, law)
            expected = float((changed - turn) / mp.mpf(10) ** -11)
        # A change as large as the parameter itself.
        change = abs(given[name]) * found.jacobian[name]
        assert change == pytest.approx(expected, rel=1e-9, abs=1e-10)
    assert found.jacobian["yaw"] == found.jacobian["spin"] == 0.0


@examples(50)
@given(rockings(), st.sampled_from(LAWS))
def test_the_derivatives_are_those_of_finite_differences(rocking, law):
    """Where the tilt does not rest at the release: there a turn begins later if it rises."""
    body, start, gravity = rocking.body, rocking.start, rocking.gravity
    assume(abs(start.tilt_rate) > 1e-3 / rocking.time)
    given = with_digits(body, start, gravity)
    found = rr.exact_turn(body, start, law, gravity=gravity, jacobian=True)
    assume(found.outcome == "rocked")
    assume(np.isfinite(found.jacobian["tilt"]))  # not so where a start had to be stepped
    names = set(PARAMETERS) - {"yaw", "spin"}
    scales = {name: abs(given[name]) for name in names}
    size = max(abs(scales[name] * found.jacobian[name]) for name in names)
    for name in names:
        turns = []
        for change in (1e-5, -1e-5):
            there = {**given, name: given[name] + change * scales[name]}
            assume(there["axial_inertia"] <= 2.0 * there["transverse_inertia"])
            turns.append(
                rr.exact_turn(
                    rr.Body(**{n: there[n] for n in BODY}),
                    rr.State(**{n: there[n] for n in FIELDS}),
                    law,
                    gravity=there["gravity"],
                ).turn
            )
        assume(np.isfinite(turns).all())
        derivative = (turns[0] - turns[1]) / 2e-5
        assert scales[name] * found.jacobian[name] == pytest.approx(
            derivative, abs=1e-5 * (1 + size)
        )


# Ctrl-C


def interrupted(start, after, threads, **more):
    """How long it takes until Ctrl-C, so many seconds after the work on turns began, ends it.

    Both are times of the processor, which other processes do not make longer.
    """
    before = signal.signal(signal.SIGVTALRM, signal.default_int_handler)
    begun = time.process_time()
    try:
        with pytest.raises(KeyboardInterrupt):
            signal.setitimer(signal.ITIMER_VIRTUAL, after)
            rr.exact_turn(CAN, start, rr.NoSlip(), threads=threads, **more)
    finally:
        signal.setitimer(signal.ITIMER_VIRTUAL, 0.0)
        signal.signal(signal.SIGVTALRM, before)
    return time.process_time() - begun


@pytest.mark.skipif(not hasattr(signal, "setitimer"), reason="no timer there")
@pytest.mark.parametrize("threads", [1, 2])
def test_ctrl_c_is_heard_while_starts_are_stepped(threads):
    """Steady precession, which is followed for very long, many times over."""
    yaw = precessing(CAN, 0.3, rr.NoSlip())
    tilt = np.full(CHUNK, 0.3)
    interrupted(rr.State(tilt=tilt, yaw_rate=yaw, spin_rate=-yaw * np.cos(0.3)), 0.3, threads)


@pytest.mark.skipif(not hasattr(signal, "setitimer"), reason="no timer there")
@pytest.mark.parametrize("threads", [pytest.param(1, marks=pytest.mark.soak), 2])
@pytest.mark.slow
def test_ctrl_c_is_heard_while_derivatives_are_computed(threads):
    start = rr.State(tilt=np.full(CHUNK, 0.3), yaw_rate=0.1)
    begun = time.process_time()
    rr.exact_turn(CAN, start, rr.NoSlip(), threads=threads, jacobian=True)
    whole = time.process_time() - begun
    assert interrupted(start, 0.05 * whole, threads, jacobian=True) < 0.6 * whole


# Refusals


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"body": "can"}, "body must be a rimroll.Body"),
        ({"start": 0.3}, "start must be a rimroll.State"),
        ({"law": "no_slip"}, "law must be a rimroll.Law"),
        (
            {"law": rr.Coulomb(0.2)},
            r"NoSlip, Frictionless or InPlace .*got Coulomb\(friction=0.2\)",
        ),
        ({"law": rr.NoSlip() + rr.RollingResistance(1e-3)}, "without resistances"),
        ({"law": rr.Coulomb(0.2)}, r"integrals, got Coulomb.*rimroll.ensemble follows falls"),
        ({"gravity": -1.0}, "gravity must be"),
        ({"gravity": np.nan}, "gravity must be"),
        ({"gravity": "much"}, "gravity must be an acceleration"),
        ({"topple_tilt": 4.0}, "topple_tilt must be"),
        ({"topple_tilt": 0.2}, "tilt must be below topple_tilt"),
        ({"threads": 0}, "threads must be a whole number >= 1"),
        ({"threads": 10**6}, "threads must be at most 1024"),
        ({"start": rr.State(tilt=0.3, yaw_rate=1e31)}, "yaw_rate must be"),
    ],
)
def test_what_cannot_be_computed_is_refused_with_a_sentence(change, words):
    arguments = {"body": CAN, "start": START, "law": rr.NoSlip(), **change}
    with pytest.raises(rr.RimrollError, match=words):
        rr.exact_turn(**arguments)


@pytest.mark.parametrize("shape", [(9000,), (90, 100)])
def test_the_start_of_many_that_is_at_fault_is_named(shape):
    tilts, rates = np.full(9000, 0.3), np.zeros(9000)
    tilts[8765], rates[8765] = 1.2, 2e31
    place = "[8765]" if len(shape) == 1 else "[87, 65]"
    for start, topple_tilt, words in (
        (
            rr.State(tilt=tilts.reshape(shape)),
            1.0,
            f"tilt{place} must be below topple_tilt = 1 rad",
        ),
        (rr.State(tilt=0.3, spin_rate=rates.reshape(shape)), None, f"spin_rate{place} must be"),
    ):
        with pytest.raises(rr.RimrollError) as refusal:
            rr.exact_turn(CAN, start, rr.NoSlip(), topple_tilt=topple_tilt, threads=1)
        assert str(refusal.value).startswith(words)


def off_the_stepped(body, start, law, *, rtol=1e-13):
    """Largest differences of turns and times from those by time stepping."""
    found = rr.exact_turn(body, start, law)
    stepped = rr.ensemble(body, start, law, rtol=rtol, duration=100.0)
    defined = ~np.isnan(np.atleast_1d(found.turn))
    assert np.array_equal(defined, ~np.isnan(stepped.turn.values))
    assert defined.any()
    turns, times = found.turn - stepped.turn.values, found.end_time - stepped.end_time.values
    return np.abs(turns[defined]).max(), np.abs(times[defined]).max()


@by_law
@pytest.mark.parametrize("rate", [-2.66, -2.7, -3.0, -4.0, -5.0, -8.0])
def test_turns_that_hardly_or_easily_pass_the_balance_point_are_those_of_steps(law, rate):
    """The can released at half its balance tilt; the slower ones rock without friction."""
    yaw, spin = np.random.default_rng(1).uniform(-1.0, 1.0, (2, 60))
    start = rr.State(tilt=0.31826, tilt_rate=rate, yaw_rate=yaw, spin_rate=spin)
    turn, time = off_the_stepped(rr.bodies.can_2007(), start, law)
    assert turn < 2e-11 and time < 2e-10  # near the balance point the steps' errors are larger, too


@by_law
def test_turns_that_yaw_or_spin_holds_past_the_balance_point_are_those_of_steps(law):
    random = np.random.default_rng(2)
    start = rr.State(
        tilt=random.uniform(0.1, 0.7, 6000),
        tilt_rate=random.uniform(-4.0, 4.0, 6000),
        yaw_rate=random.uniform(-12.0, 12.0, 6000),
        spin_rate=random.uniform(-20.0, 20.0, 6000),
    )
    found = rr.exact_turn(rr.bodies.can_2007(), start, law)
    held = (found.outcome == "rocked") & (found.end_tilt > rr.balance_tilt(rr.bodies.can_2007()))
    assert held.sum() > 20
    kept = rr.State(
        **{
            name: getattr(start, name)[held]
            for name in ("tilt", "tilt_rate", "yaw_rate", "spin_rate")
        }
    )
    turn, _ = off_the_stepped(rr.bodies.can_2007(), kept, law)
    assert turn < 1e-9  # of steps, whose errors grow there


@by_law
def test_a_disk_thrown_over_the_vertical_rocks_or_leaves_the_table(law):
    start = rr.State(tilt=1.4344446, tilt_rate=7.7169, yaw_rate=-1.93e-5, spin_rate=-10.4288)
    found = rr.exact_turn(rr.bodies.disk(0.02), start, law)
    stepped = rr.ensemble(rr.bodies.disk(0.02), start, law, rtol=1e-12)
    assert found.outcome == stepped.outcome.item()
    assert found.turn == pytest.approx(stepped.turn.item(), abs=1e-9)


def precessing(body, tilt, law):
    """Yaw rate of a steady precession with no spin about the axis: φ̈ = 0 of both laws."""
    m, r, h, a = body.mass, body.radius, body.height, body.transverse_inertia
    sin, cos = np.sin(tilt), np.cos(tilt)
    weight = m * 9.80665 * (r * cos - h * sin)
    if law == rr.Frictionless():
        return np.sqrt(weight * sin / (a * cos)) / sin
    return np.sqrt(weight / ((a + m * h * h) * cos / sin + m * h * r)) / sin


@by_law
@pytest.mark.parametrize("rate", [1e-8, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2])
def test_nearly_steady_precession_is_that_of_steps(law, rate):
    can = rr.bodies.can_2007()
    yaw = precessing(can, 0.3, law)
    start = rr.State(tilt=0.3, tilt_rate=rate, yaw_rate=yaw, spin_rate=-yaw * np.cos(0.3))
    found = rr.exact_turn(can, start, law)
    assert found.outcome == "rocked" and 0.0 < found.min_tilt_time < found.end_time < 1.0
    turn, time = off_the_stepped(can, start, law)
    # The phase of a swing of 0.01 rate has its digits from what is left of those of the tilt.
    assert turn < 1e-13 / rate + 1e-10 and time < 1e-13 / rate + 1e-10


@by_law
def test_steady_precession_hovers(law):
    can = rr.bodies.can_2007()
    yaw = precessing(can, 0.3, law)
    start = rr.State(tilt=0.3, tilt_rate=0.0, yaw_rate=yaw, spin_rate=-yaw * np.cos(0.3))
    found = rr.exact_turn(can, start, law)
    assert found.outcome in ("hovered", "rocked") and (found.outcome == "rocked") != np.isnan(
        found.turn
    )
