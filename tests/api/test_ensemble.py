"""An ensemble has the first turns of as many motions, in any order and on any number of threads."""

from __future__ import annotations

import signal

import numpy as np
import pytest
import xarray as xr
from hypothesis import assume, given
from hypothesis import strategies as st

import rimroll as rr
from given.ctrl_c import heard
from given.strategies import bodies, examples, rockings
from rimroll import _core
from rimroll.bodies.body import body_of
from rimroll.files.recorded import OUTCOMES, STATUSES
from rimroll.laws import law_of
from rimroll.many.ensemble import VARIABLES

CAN = rr.bodies.can_2007()
FIELDS = ("tilt", "tilt_rate", "yaw", "yaw_rate", "spin", "spin_rate")
LAWS = (
    rr.NoSlip(),
    rr.Frictionless(),
    rr.Coulomb(0.2),
    rr.Coulomb(0.1, static=0.3),
    rr.Coulomb(0.3) + rr.RollingResistance(1e-5),
)


def one(starts, k):
    """The k-th of a State of arrays."""
    return rr.State(**{name: float(getattr(starts, name)[k]) for name in FIELDS})


def several(starts):
    """Single starts as a State of arrays."""
    return rr.State(**{name: np.array([getattr(s, name) for s in starts]) for name in FIELDS})


def outcome(body, motion):
    """The outcome of a whole motion, by the definitions of OUTCOMES."""
    if motion.turns:
        return "rocked"
    came_down = any(event.kind == "tilt_min" for event in motion.events)
    if motion.status == "finished":
        assert motion.t[-1] == motion.duration
        return "hovered"
    over = motion.tilt[-1] > rr.balance_tilt(body)
    if motion.status == "lifted_off" and came_down and over:
        return "toppled"
    return "fell_back" if motion.status == "toppled" and not came_down else motion.status


@examples(40)
@given(rockings(), st.sampled_from(LAWS))
def test_a_fall_is_the_first_turn_of_its_motion(rocking, law):
    options = {"duration": 3.0 * rocking.time, "gravity": rocking.gravity, "rtol": 1e-8}
    falls = rr.ensemble(rocking.body, rocking.start, law, **options)
    motion = rr.simulate(rocking.body, rocking.start, law, **options)
    assert falls.sizes["trial"] == 1
    assert falls["outcome"].item() == outcome(rocking.body, motion)
    turn = motion.first_turn
    assert (turn is None) == bool(np.isnan(falls["turn"].item()))
    if turn is not None:
        assert motion.turns[:1] in ([turn], [])
        # Its steps differ, so results agree within the tolerance as a collision amplifies it.
        assert falls["turn"].item() == pytest.approx(turn.angle, abs=1e-6)
        assert falls["min_tilt"].item() == pytest.approx(turn.min_tilt, rel=1e-5)
        assert falls["min_tilt_time"].item() == pytest.approx(turn.t, rel=1e-6)
        assert falls["end_time"].item() == pytest.approx(turn.end, rel=1e-6)
        went = motion.evaluate(turn.end).yaw[0] - rocking.start.yaw
        assert np.cos(falls["direction"].item() - went) == pytest.approx(1.0, abs=1e-10)
        assert 0.0 <= falls["direction"].item() <= 2.0 * np.pi


@st.composite
def trials(draw):
    """A body and up to seven starts of it, some of which topple, lift off or fall back."""
    body = draw(bodies())
    scale = np.sqrt(9.8 / body.radius)
    rates = st.floats(-0.3, 0.3).map(lambda rate: rate * scale)
    starts = st.builds(
        lambda tilt, rate, yaw, spin: rr.State(
            tilt=tilt, tilt_rate=rate * scale, yaw_rate=yaw, spin_rate=spin
        ),
        st.floats(0.05, 1.4),
        st.floats(-0.6, 0.2),
        rates,
        rates,
    )
    return body, draw(st.lists(starts, min_size=1, max_size=7))


@examples(25)
@given(trials(), st.sampled_from(LAWS), st.randoms())
def test_the_bits_depend_on_neither_threads_nor_order_nor_splitting(drawn, law, random):
    body, starts = drawn
    options = {"duration": 10.0 * np.sqrt(body.radius / 9.8), "max_steps": 2000}
    whole = rr.ensemble(body, several(starts), law, threads=1, **options)
    for threads in (2, 3):
        assert rr.ensemble(body, several(starts), law, threads=threads, **options).identical(whole)
    order = list(range(len(starts)))
    random.shuffle(order)
    mixed = rr.ensemble(body, several([starts[k] for k in order]), law, **options)
    for place, k in enumerate(order):
        alone = rr.ensemble(body, starts[k], law, **options)
        for name in whole.data_vars:
            expected = whole[name].values[k : k + 1]
            assert np.array_equal(mixed[name].values[place : place + 1], expected, _nan(expected))
            assert np.array_equal(alone[name].values, expected, _nan(expected))


def _nan(values):
    return bool(values.dtype.kind == "f")


def test_a_long_ensemble_has_no_seams_and_tells_how_far_it_is():
    count = 2003
    starts = rr.State(tilt=np.linspace(0.2, 0.5, count), yaw_rate=0.01, spin_rate=0.01)
    reports = []
    whole = rr.ensemble(CAN, starts, rr.NoSlip(), progress=lambda *done: reports.append(done))
    assert reports[-1] == (count, count) and reports == sorted(reports)
    last = rr.ensemble(CAN, one_of(starts, slice(count - 5, None)), rr.NoSlip())
    for name in whole.data_vars:
        assert np.array_equal(whole[name].values[-5:], last[name].values), name


def one_of(starts, rows):
    """Some rows of a State of arrays, where a single number stands for all rows."""
    shape = starts.shape
    columns = {name: np.broadcast_to(getattr(starts, name), shape)[rows] for name in FIELDS}
    return rr.State(**columns)


WOBBLE = rr.steady_wobble_rate(CAN, 0.3)

CASES = {
    "toppled": (CAN, rr.State(tilt=0.35, tilt_rate=-5.0, yaw_rate=0.05), rr.NoSlip(), {}),
    "rocked": (CAN, rr.State(tilt=0.35, yaw_rate=0.05), rr.NoSlip(), {}),
    "fell_back": (CAN, rr.State(tilt=0.8, yaw_rate=0.05), rr.NoSlip(), {}),
    "hovered": (
        CAN,
        rr.State(
            tilt=0.3,
            yaw_rate=WOBBLE,
            spin_rate=WOBBLE * (CAN.height / CAN.radius * np.sin(0.3) - np.cos(0.3)),
        ),
        rr.NoSlip(),
        {"duration": 0.01},
    ),
    "lifted_off": (CAN, rr.State(tilt=0.3, tilt_rate=-11.0, yaw_rate=0.05), rr.NoSlip(), {}),
    "face_down": (CAN, rr.State(tilt=0.3), rr.NoSlip(), {}),
    "failed": (CAN, rr.State(tilt=0.3, yaw_rate=0.05), rr.NoSlip(), {"max_steps": 3}),
}


@pytest.mark.parametrize("law", [rr.NoSlip(), rr.Frictionless()], ids=lambda law: law.name)
@pytest.mark.parametrize("way", [1.0, -1.0])
def test_a_body_that_dips_and_falls_over_where_it_leaned_has_toppled_after_a_small_turn(law, way):
    """Always past the balance point, it turns back a little and falls over."""
    start = rr.State(tilt=0.8, tilt_rate=-1.1, yaw_rate=0.5 * way)
    falls, found = rr.ensemble(CAN, start, law), rr.exact_turn(CAN, start, law)
    assert falls.outcome.item() == found.outcome == "toppled"
    assert rr.balance_tilt(CAN) < found.min_tilt < 0.8
    assert 5.0 < np.degrees(found.turn) * way < 15.0
    assert falls.turn.item() == pytest.approx(found.turn, abs=1e-7)
    # The direction is a bearing: 13.6 degrees to the other side are 346.4 degrees.
    assert falls.direction.item() == pytest.approx(found.turn % (2.0 * np.pi), abs=1e-7)


def test_every_outcome_of_the_core_has_a_meaning():
    assert sorted(OUTCOMES) == sorted(_core.OUTCOMES)
    assert set(STATUSES) - {"finished"} <= set(OUTCOMES)


@pytest.mark.parametrize("name", CASES)
def test_each_outcome_is_named(name):
    body, start, law, options = CASES[name]
    falls = rr.ensemble(body, start, law, **options)
    assert falls["outcome"].item() == name
    came_down = name in ("toppled", "rocked")
    for column in ("turn", "direction", "min_tilt", "min_tilt_time"):
        assert bool(np.isnan(falls[column].item())) != came_down
    assert name in OUTCOMES


@examples(25)
@given(rockings(), st.sampled_from(LAWS), st.floats(0.05, 0.95))
def test_a_fall_whose_time_is_up_on_its_way_up_has_no_turn(rocking, law, part):
    options = {"gravity": rocking.gravity, "rtol": 1e-8}
    whole = rr.ensemble(rocking.body, rocking.start, law, duration=3.0 * rocking.time, **options)
    assume(whole["outcome"].item() == "rocked")
    near, end = whole["min_tilt_time"].item(), whole["end_time"].item()
    duration = near + part * (end - near)
    cut = rr.ensemble(rocking.body, rocking.start, law, duration=duration, **options)
    assert cut["outcome"].item() == "hovered"
    for name in ("turn", "direction", "min_tilt", "min_tilt_time"):
        assert np.isnan(cut[name].item())
    assert cut["end_time"].item() == duration


def test_a_tall_body_whose_rim_leaves_the_table_as_it_falls_over_has_toppled():
    # A thin rod that falls over from rest lifts off at 70.5 degrees; this one is flicked.
    battery = rr.bodies.battery()
    start = rr.State(tilt=0.15, tilt_rate=-4.0, yaw_rate=0.1)
    ends = {}
    for law in (rr.NoSlip(), rr.Coulomb(0.6)):
        falls = rr.ensemble(battery, start, law)
        assert falls["outcome"].item() == "toppled"
        ends[law.name] = falls["turn"].item()
    assert rr.simulate(battery, start, rr.NoSlip()).status == "lifted_off"
    assert ends["no_slip"] == pytest.approx(ends["coulomb"], abs=np.radians(0.5))


def test_rows_carry_units_meanings_starts_and_everything_else_they_came_from():
    starts = rr.State(tilt=np.array([0.3, 0.4]), yaw=0.5, yaw_rate=0.02, spin_rate=0.01)
    law = rr.Coulomb(0.2, static=0.25) + rr.AirDrag(1e-12) + rr.PivotingFriction(1e-5)
    falls = rr.ensemble(CAN, starts, law, friction_scale=[1.0, 0.5], duration=2.0, topple_tilt=1.5)
    for name, (unit, long_name, comment) in VARIABLES.items():
        meaning = {"long_name": long_name} | ({"comment": comment} if comment else {})
        assert falls[name].attrs == {"units": unit, **meaning}
        assert len(f"{long_name} [{unit}]") <= 40  # fits an axis
    assert falls["start_yaw"].values.tolist() == [0.5, 0.5]
    assert falls["friction_scale"].values.tolist() == [1.0, 0.5]
    assert falls.attrs["law_friction"] == 0.2 and falls.attrs["law_air_exponent"] == 4.0
    assert falls.attrs["body_mass"] == CAN.mass and falls.attrs["gravity"] == rr.STANDARD_GRAVITY
    assert falls.attrs["topple_tilt"] == 1.5 and falls.attrs["duration"] == 2.0
    assert falls.attrs["rtol"] == 1e-8 and falls.attrs["max_steps"] == 100_000
    assert falls.attrs["rimroll_version"] == rr.__version__
    assert body_of(falls) == CAN
    assert law_of(falls) == law


@pytest.mark.parametrize(
    "law", [*LAWS, rr.Viscous(2.0), rr.Stribeck(0.2) + rr.RollingResistance(0.0, 1e-9)]
)
def test_the_law_is_found_again_in_the_attributes(law):
    assert law_of(rr.ensemble(CAN, rr.State(tilt=0.3), law, duration=0.01)) == law


def test_friction_scale_is_a_factor_on_the_friction():
    start = rr.State(tilt=0.35, tilt_rate=-0.5, yaw_rate=0.02)
    scaled = rr.ensemble(CAN, start, rr.Coulomb(0.1, static=0.2), friction_scale=1.5)
    plain = rr.ensemble(CAN, start, rr.Coulomb(1.5 * 0.1, static=1.5 * 0.2))
    assert scaled["turn"].item() == plain["turn"].item()
    none = rr.ensemble(CAN, start, rr.Coulomb(0.1), friction_scale=0.0)
    frictionless = rr.ensemble(CAN, start, rr.Frictionless())
    assert none["turn"].item() == pytest.approx(frictionless["turn"].item(), abs=1e-6)


def test_losses_add_up_to_the_energy_lost():
    starts = rr.State(tilt=np.linspace(0.2, 0.5, 8), yaw_rate=0.02)
    falls = rr.ensemble(CAN, starts, rr.Coulomb(0.15) + rr.RollingResistance(1e-5))
    losses = falls["friction_loss"] + falls["resistance_loss"] + falls["impact_loss"]
    xr.testing.assert_allclose(falls["energy_lost"], losses)
    assert (falls["friction_loss"] > 0.0).all() and (falls["resistance_loss"] > 0.0).all()
    assert falls["slid"].all() and not falls["flew"].any()


START = rr.State(tilt=0.3)


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"body": "can"}, "body must be a rimroll.Body"),
        ({"law": "no_slip"}, "law must be a rimroll.Law"),
        ({"starts": 0.3}, "starts must be a rimroll.State"),
        ({"starts": rr.State(tilt=np.full((2, 2), 0.3))}, r"flat arrays, got shape \(2, 2\)"),
        ({"friction_scale": -0.1}, "friction_scale must be finite and >= 0, got -0.1"),
        ({"friction_scale": np.nan}, "friction_scale must be finite and >= 0, got nan"),
        (
            {"friction_scale": "much"},
            'friction_scale must be a pure number such as "0.5", got "much"',
        ),
        ({"threads": 0}, "threads must be a whole number >= 1"),
        ({"threads": 10**6}, "threads must be at most 1024"),
        ({"gravity": -1.0}, "gravity must be"),
        ({"duration": "long"}, 'duration must be a time such as "2 s"'),
        ({"rtol": 0.5}, "rtol must be"),
        ({"max_steps": 0}, "max_steps must be a whole number >= 1"),
        ({"topple_tilt": 4.0}, "topple_tilt must be"),
        ({"topple_tilt": 0.2}, r"^tilt must be below topple_tilt = 0.2 rad, got 0.3 rad"),
        ({"progress": 3}, "progress must be None or something to call, got 3"),
    ],
)
def test_what_cannot_be_computed_is_refused_with_a_sentence(change, words):
    arguments = {"body": CAN, "starts": START, "law": rr.NoSlip(), **change}
    with pytest.raises(rr.RimrollError, match=words):
        rr.ensemble(**arguments)


@pytest.mark.parametrize(
    "law",
    [
        rr.Coulomb(0.3),
        rr.Tabulated([0.0, 1.0], [0.1, 0.3]),
        rr.Tabulated([0.0, 1.0], [0.3, 0.1]),
        rr.Tabulated([0.0, 1.0], [0.1, 0.1], static=0.3),
    ],
)
def test_the_bound_on_friction_holds_for_friction_times_its_scale(law):
    rr.ensemble(CAN, START, law, friction_scale=0.999e6 / 0.3, duration=1e-9)
    for friction_scale in (1.001e6 / 0.3, 1e9, 1e308):
        with pytest.raises(rr.RimrollError, match=r"(friction|frictions|static) must be .*1e6"):
            rr.ensemble(CAN, START, law, friction_scale=friction_scale, duration=1e-9)


@pytest.mark.parametrize("place", [0, 3, 4999])
def test_the_start_of_many_that_is_at_fault_is_named(place):
    tilts, yaws = np.full(5000, 0.3), np.zeros(5000)
    tilts[place], yaws[place] = 1.2, 2e6
    friction_scale = np.where(np.arange(5000) == place, -1.0, 1.0)
    for change, message in (
        ({"starts": rr.State(tilt=tilts), "topple_tilt": 1.0}, "tilt[{}] must be below topple_"),
        ({"starts": rr.State(tilt=0.3, yaw=yaws)}, "yaw[{}] must be between -1e6 and 1e6, got 200"),
        (
            {"starts": rr.State(tilt=tilts), "friction_scale": friction_scale},
            "friction_scale[{}] must be finite and >= 0, got",
        ),
    ):
        with pytest.raises(rr.RimrollError) as refusal:
            rr.ensemble(**{"body": CAN, "law": rr.Coulomb(0.2), **change})
        assert str(refusal.value).startswith(message.format(place))


def test_a_dataset_of_something_else_is_refused():
    with pytest.raises(rr.RimrollError, match="records no body_mass"):
        body_of(xr.Dataset())


@pytest.mark.parametrize("threads", [1, 2])
def test_ctrl_c_hands_back_the_falls_done_so_far(threads):
    starts = rr.State(tilt=np.linspace(0.2, 0.5, 500_000), yaw_rate=0.02)

    def stop(done, total):
        if done:
            raise KeyboardInterrupt

    with pytest.raises(rr.Interrupted) as caught:
        rr.ensemble(CAN, starts, rr.NoSlip(), threads=threads, progress=stop)
    assert isinstance(caught.value, KeyboardInterrupt)
    some = caught.value.done
    count = some.sizes["trial"]
    assert 0 < count < 500_000 and f"after {count} falls" in str(caught.value)
    assert some.identical(rr.ensemble(CAN, one_of(starts, slice(count)), rr.NoSlip()))


@pytest.mark.parametrize("threads", [1, 2])
def test_a_signal_stops_the_work_at_once(threads):
    starts = rr.State(tilt=np.linspace(0.2, 0.5, 500_000), yaw_rate=0.02)

    def press(done, total):
        if done:
            signal.raise_signal(signal.SIGINT)

    with heard(), pytest.raises(rr.Interrupted) as caught:
        rr.ensemble(CAN, starts, rr.NoSlip(), threads=threads, progress=press)
    assert 0 < caught.value.done.sizes["trial"] < 500_000


def test_another_error_of_the_progress_callback_arrives_as_it_was_raised():
    def stop(done, total):
        raise LookupError("enough")

    with pytest.raises(LookupError, match="enough"):
        rr.ensemble(CAN, START, rr.NoSlip(), progress=stop)


def test_no_starts_are_no_falls():
    falls = rr.ensemble(CAN, rr.State(tilt=np.array([])), rr.NoSlip())
    assert falls.sizes["trial"] == 0 and set(VARIABLES) <= set(falls)


def test_bad_options_are_refused_even_where_nothing_starts():
    with pytest.raises(rr.RimrollError, match="gravity must be > 0, got -1"):
        rr.ensemble(CAN, rr.State(tilt=np.array([])), rr.NoSlip(), gravity=-1.0)
