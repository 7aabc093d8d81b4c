"""The boundary between Python and the core: threads, copies, signals, and wrong types."""

import pickle
import signal
import threading

import numpy as np
import pytest

import rimroll as rr

CAN = rr.bodies.can_2007()
START = rr.State(tilt=np.pi / 6, tilt_rate=-0.5, yaw_rate=0.005, spin_rate=0.005)


def test_a_motion_can_be_read_in_another_thread():
    motion = rr.simulate(CAN, START, rr.NoSlip())
    got = []

    def read():
        try:
            got.append(motion(0.1).tilt)
        except BaseException as error:
            got.append(error)

    thread = threading.Thread(target=read)
    thread.start()
    thread.join()
    assert got == [motion(0.1).tilt]


def test_a_motion_survives_pickling():
    motion = rr.simulate(CAN, START, rr.NoSlip())
    again = pickle.loads(pickle.dumps(motion))
    np.testing.assert_array_equal(again.yaw, motion.yaw)


def test_parameters_hold_everything_a_motion_was_computed_from():
    given = rr.simulate(CAN, START, rr.NoSlip(), 1.5, max_steps=40).parameters()
    assert given["duration"] == 1.5
    assert given["max_steps"] == 40


@pytest.mark.skipif(not hasattr(signal, "setitimer"), reason="no timer there")
def test_an_exception_of_a_signal_handler_arrives_as_it_was_raised():
    def alarm(*_):
        raise TimeoutError("too long")

    before = signal.signal(signal.SIGALRM, alarm)
    try:
        with pytest.raises(TimeoutError, match="too long"):
            signal.setitimer(signal.ITIMER_REAL, 0.05)
            rr.simulate(CAN, START, rr.NoSlip(), 1e7)
    finally:
        signal.signal(signal.SIGALRM, before)


@pytest.mark.parametrize("steps", [-1, 1.5, "many", np.nan, 10**30])
def test_a_wrong_max_steps_is_refused_with_a_sentence(steps):
    with pytest.raises(rr.RimrollError, match="max_steps"):
        rr.simulate(CAN, START, rr.NoSlip(), max_steps=steps)


@pytest.mark.parametrize("rate", [-9.5, -11.0])
def test_friction_ratio_is_never_negative(rate):
    start = rr.State(tilt=0.3, tilt_rate=rate, yaw_rate=0.005, spin_rate=0.005)
    assert (rr.simulate(CAN, start, rr.NoSlip()).friction_ratio >= 0.0).all()


def test_composite_refuses_arrays_with_a_sentence():
    with pytest.raises(rr.RimrollError):
        rr.composite(CAN, rr.State(tilt=np.array([0.1, 0.2]), yaw_rate=1e-3), rr.NoSlip())


@pytest.mark.parametrize("t", [[[0.0, 1.0]], "soon"])
def test_odd_times_are_refused_with_a_sentence(t):
    with pytest.raises(rr.RimrollError):
        rr.simulate(CAN, START, rr.NoSlip()).evaluate(t)


@pytest.mark.parametrize("tilt", ["half", "0.5 m", True])
def test_a_state_refuses_what_a_body_refuses(tilt):
    with pytest.raises(rr.RimrollError):
        rr.State(tilt=tilt)


def test_a_state_does_not_change_with_the_array_it_was_made_from():
    tilts = np.array([0.1, 0.2])
    state = rr.State(tilt=tilts)
    tilts[0] = -1.0
    assert state.tilt[0] == 0.1


def test_a_long_motion_reports_how_far_it_is():
    reached = []
    rr.simulate(CAN, START, rr.NoSlip(), 100.0, progress=reached.append)
    assert len(reached) >= 2
    assert reached == sorted(reached)
    assert 0.0 < reached[0] < reached[-1] <= 100.0


def test_progress_that_cannot_be_called_is_refused_before_the_motion():
    with pytest.raises(rr.RimrollError, match="progress must be None or something to call, got 3"):
        rr.simulate(CAN, START, rr.NoSlip(), progress=3)


def test_what_the_progress_callback_raises_ends_the_motion():
    def stop(t):
        raise LookupError(f"enough at {t:.0f} s")

    with pytest.raises(LookupError, match="enough at"):
        rr.simulate(CAN, START, rr.NoSlip(), 1e6, progress=stop)


@pytest.mark.parametrize(
    ("body", "start", "law", "words"),
    [
        (
            rr.bodies.can_2007,
            START,
            rr.NoSlip(),
            "body must be a rimroll.Body, got can_2007 itself",
        ),
        ("can_2007", START, rr.NoSlip(), "body must be a rimroll.Body, got 'can_2007'"),
        (CAN, {"tilt": 1.0}, rr.NoSlip(), "start must be a rimroll.State"),
        (CAN, START, "no_slip", "law must be a rimroll.Law, got 'no_slip'"),
        (CAN, START, rr.NoSlip, "got NoSlip itself: call it"),
    ],
)
def test_things_of_the_wrong_kind_are_refused_by_name(body, start, law, words):
    with pytest.raises(rr.RimrollError, match=words):
        rr.simulate(body, start, law)
    with pytest.raises(rr.RimrollError, match=words):
        rr.composite(body, start, law)


@pytest.mark.parametrize(
    "call",
    [
        lambda: rr.bodies.soda_can(True),
        lambda: rr.disk_turn_limit(True),
        lambda: rr.solids.wall("0.05 m", 0.1, 0.1),
        lambda: rr.Body(10**400, 0.05, 0.07, 1e-4, 1e-4),
        lambda: rr.simulate(CAN, START, rr.NoSlip(), 10**400),
        lambda: rr.Solid(-1.0, 0.0, 1.0, 1.0),
        lambda: rr.Solid(1.0, 0.0, 1.0, 3.0),
        lambda: rr.Body(1e-170, 0.05, 0.07, 1e-173, 1e-173),
        lambda: rr.State(tilt=0.5, yaw_rate=1e200) and simulate(yaw_rate=1e200),
        lambda: simulate(yaw=1e12),
        lambda: rr.composite(CAN, rr.State(tilt=0.3, yaw_rate=1e5), rr.NoSlip()),
        lambda: rr.composite(CAN, START, rr.NoSlip(), gravity=0.0),
        lambda: rr.composite(
            rr.bodies.disk(0.1), rr.State(tilt=2.0, yaw_rate=1e-3), rr.Frictionless()
        ),
        *(
            lambda until=until: rr.NearCollision(CAN, rr.NoSlip(), 1e-4, 2.0).lean_vector(until)
            for until in (np.nan, np.inf, -1.0)
        ),
    ],
)
def test_what_cannot_be_computed_is_refused_and_not_guessed(call):
    with pytest.raises(rr.RimrollError):
        call()


def simulate(**changed):
    return rr.simulate(CAN, rr.State(tilt=0.5, **changed), rr.NoSlip())


def test_a_motion_too_close_to_flat_says_that_the_clock_cannot_tell():
    start = rr.State(tilt=0.01, yaw_rate=1e-14, spin_rate=1e-14)
    motion = rr.simulate(CAN, start, rr.NoSlip())
    assert motion.status == "face_down"
    assert "larger yaw rate or spin rate" in motion.message


def test_a_body_of_next_to_no_inertia_slides_without_lifting_off():
    # N = m (g + z'') would be rounding error only; the centre falls freely, N -> 0 from above.
    body = rr.Body(1.0, 0.05, 0.05, 1e-20, 1e-20)
    motion = rr.simulate(body, rr.State(tilt=0.23, yaw_rate=0.05), rr.Frictionless(), 0.01)
    assert motion.status == "finished"
    assert (motion.normal_force > 0.0).all()
