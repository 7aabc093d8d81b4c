"""Films in which the table moves: where it is, what stands still, and the record below."""

from pathlib import Path

import numpy as np
import pytest
from PIL import Image

import rimroll as rr
from rimroll.figures import scene
from rimroll.figures.animation.clock import film_clock
from rimroll.figures.animation.stage import MovingTable, ShakenStage, extremes, round_step

COLUMN = rr.Body(1000, 0.5, 2.0, 1395.8333333333333, 125.0)
GROUND = rr.ground.sine((3.0, 1.5, 2.0), (1.2, 0.8, 0.5), (1, 1, 2))
SIZE = (240, 180)


def shaken(ground: rr.Ground, duration: float = 1.5) -> rr.Motion:
    start = rr.State(tilt=0.05, yaw=0.3)
    return rr.simulate(COLUMN, start, rr.NoSlip(), duration=duration, ground=ground)


def stage_of(ground: rr.Ground, view: str = "perspective", duration: float = 1.5) -> ShakenStage:
    motion = shaken(ground, duration)
    clock = film_clock(motion, speed=1.0, slow_collision=False)
    return ShakenStage(motion, ground, COLUMN, clock, 10.0, view, SIZE)


@pytest.mark.parametrize("view", ["perspective", "side", "top"])
def test_the_table_is_where_its_displacement_says_for_an_eye_at_rest(view: str) -> None:
    stage = stage_of(GROUND, view)
    moved = GROUND.displacement(stage.t)
    assert np.ptp(moved[:, 0]) > 0.3
    corners = stage.table.corners()
    for k in range(stage.count):
        seen = stage._camera_at(k).project(corners)
        np.testing.assert_allclose(seen, stage.camera.project(corners + moved[k]), atol=1e-12)
    inside = stage._pixels(stage.camera.project(corners + moved[:, np.newaxis]))
    assert inside.min() > 0.0 and np.all(inside < stage.size)


def is_blue(picture: Image.Image) -> np.ndarray:
    """Which pixels have the colour of the outline that stands still."""
    return (
        np.asarray(np.abs(np.asarray(picture, float) / 255.0 - scene.rgb(scene.BLUE)).max(-1)) < 0.1
    )


def test_the_outline_stays_while_the_table_moves_below_the_body() -> None:
    stage = stage_of(GROUND)
    upper = (0, 0, *stage.size)
    first, last = (stage.shoot(k).crop(upper) for k in (0, stage.count - 1))
    corners = stage._pixels(stage.camera.project(stage.table.corners()))
    x, y = np.rint(corners[0]).astype(int)
    for picture in (first, last):
        assert is_blue(picture)[y - 2 : y + 3, x - 2 : x + 3].any()
    # The plate has left the corner at which it was at first.
    x, y = np.rint(corners[0] + [4.0, -1.0]).astype(int)
    assert first.getpixel((x, y)) != (255, 255, 255) == last.getpixel((x, y))


def test_the_record_is_below_with_the_present_moment() -> None:
    stage = stage_of(GROUND)
    strip = stage.strip
    for k in (0, stage.count // 2, stage.count - 1):
        picture = stage.shoot(k)
        assert picture.size == SIZE
        below = np.asarray(picture.crop((0, stage.size[1], *SIZE)), float) / 255.0
        marked = np.abs(below - scene.rgb(scene.VERMILLION)).max(axis=-1) < 0.15
        columns = np.flatnonzero(marked.sum(axis=0) > 0.25 * strip.size[1])
        expected = (0.035 + 0.93 * stage.t[k] / stage.t[-1]) * SIZE[0]
        assert columns.size and abs(columns.mean() + 0.5 - expected) < 1.0


def test_a_curve_of_the_record_is_its_acceleration() -> None:
    strip = stage_of(GROUND).strip
    color, curve = strip.curves[0]
    assert color == scene.BLUE and len(strip.curves) == 3
    x = strip._place(np.linspace(0.05, 1.15, 40))
    drawn = np.interp(x, *curve.T)
    expected = GROUND(np.linspace(0.05, 1.15, 40))[:, 0]
    scale = 0.5 * (strip._bottom - strip._top) / 3.0
    np.testing.assert_allclose(strip._middle - drawn, scale * expected, atol=0.05)


def test_a_dense_curve_keeps_its_extremes() -> None:
    x = np.linspace(0.0, 50.0, 20001)
    y = np.random.default_rng(1).standard_normal(20001)
    thin = extremes(x, y)
    assert len(thin) <= 4 * 51 and np.all(np.diff(thin[:, 0]) >= 0.0)
    for pixel in range(50):
        inside = np.floor(x) == pixel
        kept = np.floor(thin[:, 0]) == pixel
        assert thin[kept, 1].max() == y[inside].max() and thin[kept, 1].min() == y[inside].min()
    np.testing.assert_array_equal(extremes(x[::500], y[::500]), np.stack([x, y], -1)[::500])


def test_an_eye_goes_with_a_table_that_moves_far() -> None:
    far = rr.ground.rectangular((0.0, 30.0, 0.0), 0.5)
    t = np.linspace(0.0, 3.0, 10)
    table = MovingTable.under(COLUMN, np.zeros((2, 2)), far, t)
    assert table.is_seen_from_itself and not table.moved.any()
    assert table.farthest == pytest.approx(30.0 * 0.5 * (3.0 - 0.25), rel=1e-12)
    near = MovingTable.under(COLUMN, np.zeros((2, 2)), GROUND, t)
    assert not near.is_seen_from_itself
    calm = rr.ground.rectangular(0.0, 0.5)
    assert not MovingTable.under(COLUMN, np.zeros((2, 2)), calm, t).is_seen_from_itself


@pytest.mark.parametrize(("length", "step"), [(0.53, 0.5), (0.2, 0.2), (1.99, 1.0), (0.0031, 2e-3)])
def test_steps_are_round(length: float, step: float) -> None:
    assert round_step(length) == pytest.approx(step)


def test_a_film_of_a_shaken_motion_runs_in_real_time(tmp_path: Path) -> None:
    motion = shaken(GROUND, 0.8)
    with Image.open(motion.animate(tmp_path / "film.gif", fps=10.0, size=SIZE)) as film:
        assert (getattr(film, "n_frames", 1), film.size) == (9, SIZE)
    with Image.open(motion.animate(tmp_path / "slow.gif", fps=5.0, speed=0.5, size=SIZE)) as film:
        assert getattr(film, "n_frames", 1) == 9
    assert motion.film(fps=2.0).data.startswith(b"GIF")
