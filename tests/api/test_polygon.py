"""Bodies with corners as users meet them."""

import copy
import pickle

import numpy as np
import pytest

import rimroll as rr

NUT = rr.polygons.hexagonal_nut()
START = rr.State(tilt=0.4, tilt_rate=-0.5, yaw_rate=0.3, spin=0.2)


@pytest.fixture(scope="module")
def motion():
    return rr.simulate(NUT, START, rr.NoSlip(), 2.0)


def test_a_motion_begins_at_its_start_and_keeps_its_books(motion):
    assert motion.tilt[0] == pytest.approx(START.tilt, rel=1e-14)
    assert motion.yaw_rate[0] == pytest.approx(START.yaw_rate, rel=1e-12)
    assert motion.spin[0] == pytest.approx(START.spin, rel=1e-14)
    total = motion.energy + motion.impact_loss
    assert total == pytest.approx(total[0], rel=1e-9)
    assert sum(event.loss for event in motion.impacts) == pytest.approx(motion.impact_loss[-1])
    assert motion.status == "at_rest"
    assert motion.tilt[-1] == pytest.approx(0.0, abs=1e-8)


def test_phases_follow_each_other_without_gaps(motion):
    assert motion.phases[0].start == 0.0
    for one, other in zip(motion.phases, motion.phases[1:], strict=False):
        assert one.end == other.start
    assert {phase.kind for phase in motion.phases} >= {"corner", "face"}


def test_a_supporting_corner_stays_in_place(motion):
    moments = motion.samples(3)
    same = (np.diff(moments.corner) == 0) & (moments.t[1:] < motion.phases[-1].start)
    moved = np.linalg.norm(np.diff(moments.contact_path, axis=0), axis=1)
    assert np.max(moved[same]) < 1e-9 * NUT.radius


def test_a_motion_can_be_read_at_any_time(motion):
    t = 0.5 * motion.t[-1]
    assert motion(t).t == pytest.approx([t])
    with pytest.raises(rr.RimrollError, match="inside the motion"):
        motion(2.0 * motion.t[-1])
    assert set(motion.keys()) == set(motion.to_xarray().variables)


def test_an_edge_carries_a_body_that_leans_over_it():
    column = rr.polygons.square_column(0.1, 0.5)
    start = rr.State(tilt=0.1, spin=np.pi / 4)
    motion = rr.simulate(column, start, rr.NoSlip(), 1.0)
    assert {phase.kind for phase in motion.phases} == {"edge"}
    ratio = np.sqrt(_above_rest(motion, motion.impacts[0].t) / _above_rest(motion, 0.0))
    assert ratio == pytest.approx(1.0 - 1.5 * 0.1**2 / (0.1**2 + 0.5**2), abs=1e-9)
    assert column.housner_ratio == pytest.approx(ratio, abs=1e-9)


def _above_rest(motion, t):
    return motion(t).energy[0] - motion.body.mass * motion.gravity * motion.body.height


@pytest.mark.parametrize(
    ("arguments", "reason"),
    [
        ({"corners": 2}, "corners must be between 3 and 100000"),
        ({"corners": 6, "axial_inertia": 1.0}, "axial_inertia must be at most"),
        ({"corners": 6, "mass": -1.0}, "mass must be > 0"),
    ],
)
def test_impossible_bodies_are_refused(arguments, reason):
    numbers = {name: getattr(NUT, name) for name in NUT.__dataclass_fields__}
    with pytest.raises(rr.RimrollError, match=reason):
        rr.PolygonalBody(**{**numbers, **arguments})


@pytest.mark.parametrize(
    ("law", "options", "reason"),
    [
        (rr.Coulomb(0.3), {}, "NoSlip"),
        (rr.NoSlip(), {"jacobian": True}, "takes no ground, flat, flat_gap or jacobian"),
        (rr.NoSlip(), {"topple_tilt": 2.0}, "topple_tilt"),
    ],
)
def test_what_corners_cannot_do_is_refused(law, options, reason):
    with pytest.raises(rr.RimrollError, match=reason):
        rr.simulate(NUT, START, law, 1.0, **options)


def test_a_motion_can_be_pickled_and_copied(motion):
    for again in (pickle.loads(pickle.dumps(motion)), copy.deepcopy(motion)):
        assert np.array_equal(again.samples(3).energy, motion.samples(3).energy)
        assert repr(again) == repr(motion)


def test_a_motion_is_drawn_and_filmed(motion, tmp_path):
    panels = motion.plot().axes
    assert len(panels) == 4
    struck = next(line for line in panels[0].lines if line.get_linestyle() == "None")
    assert len(struck.get_xdata()) == len(motion.impacts)
    film = motion.animate(tmp_path / "nut.gif", seconds=0.5, fps=8)
    assert film.read_bytes()[:4] == b"GIF8"
