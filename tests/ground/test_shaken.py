"""What became of a body on a table that moved, against motions that can be computed by hand."""

import math
import pickle
from pathlib import Path

import numpy as np
import pytest
import xarray as xr
from hypothesis import given
from hypothesis import strategies as st

import rimroll as rr
from given.motions import CAN, PAPER_START, same_bits
from given.strategies import examples
from rimroll.motion.words import shaken_in_words

COLUMN = rr.Body(
    mass=1000.0,
    radius=0.5,
    height=2.0,
    transverse_inertia=1395.8333333333333,
    axial_inertia=125.0,
)
"""A solid cylinder of stone, 4 m high."""

G = 9.81
EXAMPLES = Path(__file__).parents[2] / "examples"
REST = rr.ground.rectangular(1e-6, 1e-3)
"""A ground that is as good as at rest."""


def shaken(ground, start=None, law=None, duration=3.0, **options):
    start = start or rr.State.standing()
    law = law or rr.NoSlip()
    return rr.simulate(COLUMN, start, law, duration, gravity=G, ground=ground, **options)


def test_a_column_that_slides_flat_ends_where_its_impulse_takes_it():
    a, friction, pulse = 2.0, 0.1, 0.5
    motion = shaken(
        rr.ground.rectangular((0.0, a, 0.0), pulse),
        rr.State.standing(yaw=0.7, spin=0.2),
        rr.Coulomb(friction),
    )
    speed = (a - friction * G) * pulse
    slid = 0.5 * speed * pulse + 0.5 * speed**2 / (friction * G)
    assert motion.residual_displacement == pytest.approx([0.0, -slid], abs=1e-9)
    assert motion.max_tilt == 0.0 and motion.residual_yaw == 0.0
    assert motion.uplift_time is None and motion.overturned is False


@pytest.mark.parametrize(("longer", "overturns"), [(0.999, False), (1.001, True)])
def test_the_least_pulse_that_overturns(longer, overturns):
    """0.580520881038643 s: energy and quadrature, as in the tests of the core."""
    a = 1.5 * G * COLUMN.radius / COLUMN.height
    ground = rr.ground.rectangular(a, longer * 0.580520881038643)
    motion = shaken(ground, duration=12.0)
    balance = math.atan(COLUMN.radius / COLUMN.height)
    assert motion.uplift_time == 0.0
    assert motion.overturned is overturns
    assert (motion.max_tilt > balance) is overturns
    assert motion.max_tilt_ratio == motion.max_tilt / balance
    if overturns:
        assert motion.overturning_time == motion.t[-1]
        # Without slip it lifts off on the way, beyond the balance tilt.
        assert motion.status == "lifted_off"
    else:
        assert motion.overturning_time is None


def test_a_column_that_only_loses_its_hold_has_not_overturned():
    falling = shaken(rr.ground.rectangular((0.0, 0.0, -15.0), 0.5), rr.State(tilt=0.05))
    assert falling.status == "lifted_off" and falling.overturned is None


def test_the_largest_tilt_is_that_of_the_energy_between_the_steps():
    """A pulse ends at the tilt φ₁; the energy m a Δ that it gave lifts the centre of mass."""
    a, radius, height = 1.3 * G * 0.25, COLUMN.radius, COLUMN.height
    motion = shaken(rr.ground.rectangular(a, 0.3), duration=1.2)
    end = motion(0.3).tilt

    def rise(tilt):
        return radius * math.sin(tilt) + height * (math.cos(tilt) - 1.0)

    given = a * (radius - radius * math.cos(end) + height * math.sin(end)) / G
    assert motion.max_tilt > motion.tilt.max()
    assert rise(motion.max_tilt) == pytest.approx(given, rel=1e-8)


shaken_motions = st.fixed_dictionaries(
    {
        "ground": st.builds(
            rr.ground.sine,
            st.tuples(st.floats(0.5, 8.0), st.sampled_from([0.0, 1.0, 3.0]), st.just(0.0)),
            st.floats(0.3, 1.5),
        ),
        "start": st.sampled_from([rr.State.standing(), rr.State(tilt=0.1, yaw=0.3)]),
        "law": st.sampled_from([rr.NoSlip(), rr.InPlace(), rr.Coulomb(0.6), rr.Coulomb(0.2)]),
        "flat": st.sampled_from([None, "stop", "smooth", 0.5]),
        "duration": st.floats(0.2, 6.0),
    }
)


@given(shaken_motions)
@examples(200)
def test_what_is_decided_stays_so(case):
    """A body that has not overturned never does; where it stands, it stays."""
    motion = shaken(**case, rtol=1e-8)
    longer = shaken(**case | {"duration": case["duration"] + 20.0}, rtol=1e-8)
    if motion.overturned is not None:
        assert longer.overturned is motion.overturned
    if motion.stands:
        assert longer.residual_displacement == pytest.approx(motion.residual_displacement, abs=0)
        assert longer.residual_yaw == motion.residual_yaw
    table_moves = motion.t[-1] < case["ground"].duration
    stopped = motion.status in ("painleve", "failed")
    if stopped or (motion.status in ("finished", "face_down") and table_moves):
        assert motion.overturned is None
        assert "It is undecided whether it overturns" in shaken_in_words(motion)
    if not motion.stands:
        assert motion.residual_displacement is motion.residual_yaw is None


def test_planar_rocking_leaves_the_footprint_where_it_was():
    motion = shaken(rr.ground.sine(3.5, 0.6), flat="housner", duration=20.0)
    assert [event.kind for event in motion.events].count("face_down") > 3
    assert abs(motion.footprint).max() < 1e-9
    assert np.ptp(motion.contact_path[:, 0]) > 1.9 * COLUMN.radius
    assert abs(motion.body_yaw).max() < 1e-9


def test_rolling_carries_the_footprint_and_the_yaw_away():
    """The contact point runs along the rim by R dθ, at a right angle to the line of lean."""
    ground = rr.ground.sine((3.0, 1.5, 0.0), (1.2, 0.8, 1.0))
    motion = shaken(ground, rr.State(tilt=0.05, yaw=0.3), duration=2.0)
    fine = motion.samples(200)
    path = rr.motion.moments.footprint_of(fine, COLUMN)
    along = np.stack([-np.sin(fine.yaw), np.cos(fine.yaw)], axis=-1)
    middle = 0.5 * (along[1:] + along[:-1])
    moved = COLUMN.radius * np.diff(fine.body_yaw)[:, None] * middle
    assert path[-1] - path[0] == pytest.approx(moved.sum(axis=0), abs=1e-4)
    moved = motion.footprint[-1] - motion.footprint[0]
    assert moved == pytest.approx(path[-1] - path[0], abs=1e-12)
    assert motion.body_yaw[-1] - motion.body_yaw[0] == pytest.approx(
        np.diff(fine.body_yaw).sum(), abs=1e-12
    )
    assert np.hypot(*(path[-1] - path[0])) > 0.01
    assert motion.residual_displacement is None and motion.residual_yaw is None  # it still rocks


def test_a_body_on_a_table_at_rest_has_the_same_results():
    motion = rr.simulate(CAN, PAPER_START, rr.NoSlip(), 2.0)
    assert motion.uplift_time is None and motion.overturned is not True
    tops = [event.state.tilt for event in motion.events if event.kind == "tilt_max"]
    assert motion.max_tilt == pytest.approx(max(*tops, PAPER_START.tilt), abs=1e-12)
    toppled = rr.simulate(CAN, rr.State(tilt=1.3), rr.Coulomb(0.3), 5.0)
    assert toppled.overturned and toppled.max_tilt == pytest.approx(math.pi / 2, abs=1e-9)


def test_events_of_uplift_and_standing_are_in_order():
    pulses = rr.ground.rectangular(3.0, 0.2)
    motion = shaken(pulses, flat="housner", duration=40.0)
    kinds = [event.kind for event in motion.events if event.kind in ("uplift", "stand")]
    assert kinds == ["uplift", "stand"]
    assert motion.phases[-1].kind == "standing"
    assert motion.uplift_time == 0.0


@pytest.mark.parametrize("excess", [1e-6, 1e-4, 3e-3])
@pytest.mark.parametrize("law", [rr.NoSlip(), rr.InPlace()])
def test_a_body_that_hardly_lifts_stands_again(law, excess):
    """A record hardly exceeds the limit; then the body rocks by less than 1e-11 rad, very fast."""
    limit = G * COLUMN.radius / COLUMN.height
    corners = [[0.3, -0.6, 0.0], [0.8, 0.6, 0.0], [-0.9, -0.2, 0.0], [0.1, 0.0, 0.0]]
    record = rr.ground.sampled(0.02, limit * (1.0 + excess) * np.array(corners))
    motion = shaken(record, law=law, flat="housner", duration=10.0)
    assert motion.uplift_time == pytest.approx(0.02, abs=1e-4) and motion.max_tilt < 1e-11
    assert motion.status == "finished"
    assert motion.stats.steps < 10_000


RECORD = rr.ground.sampled(0.01, 3.0 * np.random.default_rng(3).standard_normal((300, 3)))
GROUNDS = {
    "record": RECORD,
    "record with a heading": rr.ground.read(*sorted(EXAMPLES.glob("*.at2"))),
    "pulses": rr.ground.ricker((3.1, 1.0, 0.3), 0.7) + rr.ground.rectangular(1.0 / 3.0, 0.4),
    "both": RECORD + rr.ground.sine((0.1, 3.0, 0.0), (1.0, 0.7, 1.0), 2.5),
}


@pytest.mark.parametrize("ground", GROUNDS.values(), ids=GROUNDS)
@pytest.mark.parametrize("flat", ["housner", ("smooth", 7), 0.3])
def test_a_shaken_motion_comes_back_from_its_file_and_its_pickle_bit_for_bit(
    tmp_path, ground, flat
):
    motion = shaken(
        ground, rr.State.standing(yaw=0.1), rr.Coulomb(0.5), 4.0, flat=flat, flat_gap="1 mm"
    )
    assert len(motion.t) > 10 and motion.flat_gap == 1e-3
    path = tmp_path / "motion.nc"
    motion.to_xarray().to_netcdf(path, engine="scipy")
    with xr.open_dataset(path) as read:
        stored = rr.Motion.from_xarray(read)
    for again in (stored, pickle.loads(pickle.dumps(motion))):
        assert (again.ground, again.flat) == (ground, flat)
        assert again.parameters() == motion.parameters()
        assert same_bits(again, motion)


def test_a_dataset_whose_record_was_dropped_is_refused():
    dataset = shaken(RECORD).to_xarray()
    assert dataset["ground_record"].dims == ("ground_t", "component")
    with pytest.raises(rr.RimrollError, match="without its record: there is no ground_record"):
        rr.Motion.from_xarray(dataset.drop_vars("ground_record"))
    with pytest.raises(rr.RimrollError, match="ground_pulses must be pulses in JSON"):
        rr.Motion.from_xarray(dataset.assign_attrs(ground_pulses="[1]"))
    with pytest.raises(rr.RimrollError, match="tilt_rate must be 0 where the tilt is 0"):
        rr.Motion.from_xarray(dataset.assign_attrs(start_tilt_rate=0.1))


def test_a_motion_shows_what_the_ground_was():
    motion = shaken(rr.ground.rectangular(3.0, 0.2), flat="housner", duration=40.0)
    assert repr(motion).startswith("<Motion on a ground of 1 pulse, 0.2 s, peaks 3, 0, 0 m/s²:")
    html = motion._repr_html_()
    assert "The ground: 1 pulse, 0.2 s" in html and "lifted at 0 s" in html
    assert "It did not overturn" in html
