"""Pictures: geometry of the scene, clock of films, the figure of a fall, and files."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
import pytest

pytest.importorskip("matplotlib")

from matplotlib.figure import Figure
from PIL import Image, ImageSequence

from rimroll.errors import RimrollError
from rimroll.figures import artists, scene
from rimroll.figures.animation import animate
from rimroll.figures.animation.clock import film_clock, slowed
from rimroll.figures.animation.film import gif_pauses
from rimroll.figures.animation.painter import Painter, Trail
from rimroll.figures.animation.stage import Stage
from rimroll.figures.scene import Array, Camera, Pose, Profile
from rimroll.figures.scene.pose import turn_span, turn_spans
from rimroll.figures.sequence import falling_figure, falling_times
from rimroll.files.output import ensure_folder, writing


@dataclass(frozen=True)
class Can:
    """The paper's can (caption of its simulation figure), m."""

    radius: float = 0.051
    height: float = 0.069


@dataclass(frozen=True)
class Event:
    kind: str
    t: float


@dataclass(frozen=True)
class States:
    tilt: Array
    yaw: Array
    spin: Array
    center: Array


@dataclass
class NearCollision:
    """A fall by the paper's closed form: tilt² = φc² + (ωt)², yaw = √(J/K) arctan(ωt/φc).

    K = A + mH² and J = K + mR² per unit mass, A/m = 5.13e-3 m²; t from the near collision, which
    is at 0.24 s. The base turns about a fixed point, as in the limit of no slip.
    """

    min_tilt: float = 1e-5
    rate: float = 2.2
    near: float = 0.24
    end: float = 0.48
    body: Can = field(default_factory=Can)

    def __post_init__(self) -> None:
        brief = self.min_tilt / self.rate
        ends = np.arcsinh(np.array([-self.near, self.end - self.near]) / brief)
        even = np.linspace(ends[0], ends[1], 120)
        self.t = np.clip(self.near + brief * np.sinh(even), 0.0, self.end)
        self.events = [Event("tilt_min", self.near)]

    def evaluate(self, t: Array) -> States:
        radius, height = self.body.radius, self.body.height
        inertia = 5.13e-3 + height**2
        fall = self.rate * (np.asarray(t) - self.near)
        tilt = np.hypot(self.min_tilt, fall)
        yaw = np.sqrt(1.0 + radius**2 / inertia) * np.arctan(fall / self.min_tilt)
        way = np.stack([np.cos(yaw), np.sin(yaw)], axis=-1)
        out = radius * np.cos(tilt) - height * np.sin(tilt)
        up = radius * np.sin(tilt) + height * np.cos(tilt)
        center = np.column_stack([(out - radius)[:, None] * way, up])
        return States(tilt, yaw, -yaw, center)


def random_poses(count: int = 40) -> list[Pose]:
    random = np.random.default_rng(7)
    can, poses = Can(), []
    for tilt, yaw, spin in random.uniform((0.01, -7.0, -7.0), (1.5, 7.0, 7.0), (count, 3)):
        axes = Pose(tilt, yaw, spin, (0.0, 0.0, 0.0)).axes()
        x, y, z = can.radius * axes[0] + can.height * axes[2] + [*random.normal(size=2), 0.0]
        poses.append(Pose(tilt, yaw, spin, (x, y, z)))
    return poses


def rim_of(pose: Pose, count: int = 3600) -> Array:
    angle = np.linspace(0.0, 2.0 * np.pi, count, endpoint=False)
    ring = np.stack([np.cos(angle), np.sin(angle), np.zeros(count)], axis=-1)
    return pose.place(Can().radius * ring, Can())


@pytest.mark.parametrize("pose", random_poses())
def test_the_lowest_point_of_the_rim_is_the_contact_and_touches_the_table(pose: Pose) -> None:
    rim = rim_of(pose)
    lowest = rim[np.argmin(rim[:, 2])]
    contact = pose.contact(Can())
    assert contact[2] == pytest.approx(0.0, abs=1e-15)
    assert rim[:, 2].min() >= -1e-15
    assert np.linalg.norm(lowest - contact) < 2.0 * np.pi * Can().radius / 3600


@pytest.mark.parametrize("pose", random_poses(8))
def test_the_contact_is_at_azimuth_yaw_plus_pi_and_the_axis_leans_toward_it(pose: Pose) -> None:
    out = (pose.contact(Can()) - pose.base_center(Can()))[:2]
    assert np.exp(1j * np.angle(complex(*out))) == pytest.approx(-np.exp(1j * pose.yaw))
    assert pose.axes()[2][:2] @ out > 0.0


@pytest.mark.parametrize("pose", random_poses(8))
def test_the_rotation_is_yaw_then_minus_tilt_then_spin(pose: Pose) -> None:
    def about_z(a: float) -> Array:
        return np.array([[np.cos(a), -np.sin(a), 0], [np.sin(a), np.cos(a), 0], [0, 0, 1.0]])

    c, s = np.cos(-pose.tilt), np.sin(-pose.tilt)
    about_y = np.array([[c, 0, s], [0, 1, 0], [-s, 0, c]])
    expected = about_z(pose.yaw) @ about_y @ about_z(pose.spin)
    np.testing.assert_allclose(pose.rotation(), expected, atol=1e-15)


def test_the_spin_turns_the_mark_on_the_side_but_moves_no_other_point_of_the_rim() -> None:
    before, after = (Pose(0.4, 1.0, spin, (0.0, 0.0, 0.1)) for spin in (0.0, 2.0))
    np.testing.assert_allclose(before.contact(Can()), after.contact(Can()))
    assert not np.allclose(before.rotation()[:, 0], after.rotation()[:, 0])


def test_a_closed_mesh_has_normals_that_point_outward_and_areas_that_cancel() -> None:
    shape = scene.mesh(Profile.of(Can()))
    sides = shape.corners[:, 2] - shape.corners[:, 0], shape.corners[:, 3] - shape.corners[:, 1]
    areas = 0.5 * np.cross(*sides)
    size = np.linalg.norm(areas, axis=1)
    np.testing.assert_allclose(areas / size[:, None], shape.normals, atol=1e-3)
    np.testing.assert_allclose(areas.sum(axis=0), 0.0, atol=1e-15)


@pytest.mark.parametrize("camera", [Camera.side(), Camera.top(), Camera.perspective(distance=0.8)])
@pytest.mark.parametrize("pose", random_poses(6))
def test_facets_in_view_are_those_that_wind_left_and_near_ones_come_last(
    pose: Pose, camera: Camera
) -> None:
    pose = Pose(pose.tilt, pose.yaw, pose.spin, (0.0, 0.0, pose.center[2]))
    polygons, colors = scene.visible_facets(Can(), pose, camera, Profile.of(Can()))
    x, y = np.moveaxis(polygons, -1, 0)
    area = 0.5 * (x * np.roll(y, -1, axis=1) - y * np.roll(x, -1, axis=1)).sum(axis=1)
    shape = scene.mesh(Profile.of(Can()))
    assert 0.2 * len(shape.corners) < len(polygons) < 0.8 * len(shape.corners)
    assert area.min() > -1e-12
    assert colors.min() >= 0.0 and colors.max() <= 1.0


def test_a_point_at_the_focus_plane_is_drawn_true_and_a_nearer_one_larger() -> None:
    camera = Camera(distance=2.0)
    far, near = camera.project([[0.1, 0.0, 0.2], [0.1, -1.0, 0.2]])
    np.testing.assert_allclose(far, [0.1, 0.2])
    np.testing.assert_allclose(near, [0.2, 0.4])


def test_a_disc_is_drawn_thin_a_can_twice_as_long_as_g_is_high_and_a_bottle_as_it_says() -> None:
    outline = Profile(((0.03, 0.0), (0.03, 0.1), (0.01, 0.2)), (0.02, 0.08))

    @dataclass(frozen=True)
    class Bottle(Can):
        profile: Profile = outline

    assert Profile.of(Can(0.02, 0.0)).points()[:, 2].max() == pytest.approx(0.04 * 0.02)
    assert Profile.of(Can()).points()[:, 2].max() == pytest.approx(2 * 0.069)
    assert Profile.of(Bottle()) is outline


def test_drawing_a_body_adds_shadow_facets_and_rim_in_this_order() -> None:
    ax = Figure().add_subplot()
    drawn = artists.draw_body(ax, Can(), random_poses(1)[0], Camera.perspective())
    heights = [artist.get_zorder() for artist in drawn]
    assert len(drawn) == 3 and heights == sorted(heights)


@pytest.mark.parametrize("min_tilt", [1e-2, 1e-4, 1e-6, 1e-9])
def test_the_film_clock_is_monotone_and_gives_the_collision_its_share(min_tilt: float) -> None:
    motion = NearCollision(min_tilt)
    clock = film_clock(motion, speed=0.25)
    assert np.all(np.diff(clock.film) > 0.0) and np.all(np.diff(clock.t) > 0.0)
    assert (clock.t[0], clock.t[-1]) == (motion.t[0], motion.t[-1])
    yaw = motion.evaluate(clock.times(np.linspace(0.0, clock.seconds, 80))).yaw
    assert np.abs(np.diff(yaw)).max() < np.radians(30.0)
    assert np.count_nonzero((yaw > np.radians(-90)) & (yaw < np.radians(90))) > 15


def test_a_film_in_plain_time_passes_the_collision_between_two_pictures() -> None:
    motion = NearCollision(1e-6)
    clock = film_clock(motion, speed=0.25, slow_collision=False)
    assert clock.seconds == pytest.approx(4 * 0.48)
    np.testing.assert_allclose(clock.slowdown(np.array([0.0, 1.0])), 4.0)
    yaw = motion.evaluate(clock.times(np.linspace(0.0, clock.seconds, 80))).yaw
    assert np.abs(np.diff(yaw)).max() > np.radians(180.0)


def test_the_film_has_the_given_length_and_shows_how_much_it_is_slowed() -> None:
    motion = NearCollision(1e-6)
    clock = film_clock(motion, speed=0.25, seconds=5.0)
    film = np.linspace(0.0, 5.0, 200)
    assert clock.seconds == pytest.approx(5.0)
    assert clock.slowdown(film).max() > 1e5 > 100 > clock.slowdown(film).min()
    assert slowed(3947.0) == "slowed 3,900×"
    assert slowed(4.0) == "slowed 4×"
    assert slowed(1.0) == "real time"
    assert slowed(0.5) == "sped up 2×"


def test_many_runs_of_the_contact_point_do_not_make_the_film_endless() -> None:
    motion = NearCollision(1e-4)
    motion.evaluate = lambda t: States(*(1e5 * np.asarray(t) for _ in range(4)))  # type: ignore[method-assign]
    assert film_clock(motion, speed=1.0).seconds == pytest.approx(0.48 * 2.5)


def test_the_figure_shows_the_instants_of_the_fall_in_order() -> None:
    motion = NearCollision()
    span = turn_span(motion)
    times = falling_times(motion, span)
    assert (times[0], times[-1]) == (motion.t[0], motion.t[-1])
    tilt, yaw = motion.evaluate(times).tilt, motion.evaluate(times).yaw
    assert np.all(np.diff(times) > 0.0)
    assert tilt[1] == pytest.approx(tilt[2], rel=1e-3) and tilt[1] < np.radians(5.0)
    assert np.all(np.diff(tilt[2:]) > 0.0)
    assert yaw[2] - yaw[1] == pytest.approx(span.angle, abs=1e-3)
    figure = falling_figure(motion)
    words = [text.get_text() for ax in figure.axes for text in ax.texts]
    assert len(figure.axes) == 12
    assert words.count("A") == 6 and words.count("B") == 4 and words.count("O") == 6
    # The paper's limit for the can, erratum E1 corrected: π √(J/K) = 202.287°.
    assert words.count("202.3°") == 4


def test_turns_reach_from_one_tilt_maximum_to_the_next_or_to_the_end() -> None:
    motion = NearCollision()
    kinds = ("tilt_max", "tilt_min", "tilt_max", "tilt_min", "topple")
    motion.events = [Event(kind, t) for kind, t in zip(kinds, np.arange(1, 6) * 0.08, strict=True)]
    spans = turn_spans(motion)
    np.testing.assert_allclose([s.start for s in spans], [0.08, 0.24])
    np.testing.assert_allclose([s.end for s in spans], [0.24, motion.t[-1]])


def test_the_trail_is_where_the_poses_touch_the_table() -> None:
    states = NearCollision().evaluate(np.linspace(0.0, 0.48, 9))
    touched = [scene.pose_at(states, k).contact(Can())[:2] for k in range(9)]
    np.testing.assert_allclose(scene.contact_path(states, Can()), touched, atol=1e-15)


def test_a_turn_that_the_motion_has_not_got_is_refused() -> None:
    with pytest.raises(RimrollError, match="turn is 1, but the motion has 1 near collision "):
        turn_span(NearCollision(), 1)
    motion = NearCollision()
    motion.events = []
    with pytest.raises(RimrollError, match="0 near collisions"):
        falling_figure(motion)


@pytest.mark.parametrize("view", ["perspective", "side", "top", Camera(elevation=0.3)])
def test_a_gif_has_the_pictures_it_should_and_they_move(view: str | Camera, tmp_path: Path) -> None:
    calls: list[tuple[int, int]] = []
    path = animate(
        NearCollision(),
        tmp_path / "fall.gif",
        seconds=0.4,
        size=(160, 120),
        view=view,
        progress=lambda done, total: calls.append((done, total)),
    )
    with Image.open(path) as film:
        assert (getattr(film, "n_frames", 1), film.size) == (11, (160, 120))
        first = np.asarray(film.convert("RGB"), int)
        film.seek(10)
        assert np.abs(np.asarray(film.convert("RGB"), int) - first).max() > 60
    assert calls == [(k, 11) for k in range(1, 12)]
    assert [each.name for each in path.parent.iterdir()] == ["fall.gif"]


def test_the_pictures_of_a_gif_are_those_of_the_stage_but_for_their_colours(tmp_path: Path) -> None:
    motion, size = NearCollision(), (160, 120)
    path = animate(motion, tmp_path / "fall.gif", seconds=0.4, size=size)
    clock = film_clock(motion, speed=0.25, seconds=0.4)
    stage = Stage(motion, motion.body, clock, 25.0, "perspective", size)
    with Image.open(path) as film:
        for k in range(stage.count):
            film.seek(k)
            shown, painted = (
                np.asarray(one.convert("RGB"), float) for one in (film, stage.shoot(k))
            )
            # 255 colours for a can, its shadow and the table: neighbours differ by a few levels.
            assert np.abs(shown - painted).mean() < 2.5


def painted(paint: Callable[[Painter], None]) -> tuple[float, Array]:
    """Area, pixels, and centroid of the black parts of a white picture."""
    painter = Painter(Image.new("RGB", (80, 60), "white"))
    paint(painter)
    part = 1.0 - np.asarray(painter.picture.convert("L"), float) / 255.0
    y, x = np.mgrid[:60, :80] + 0.5
    return float(part.sum()), np.array([(part * x).sum(), (part * y).sum()]) / part.sum()


def test_shapes_are_painted_in_their_place_as_large_as_they_are() -> None:
    angle = np.linspace(0.0, 2.0 * np.pi, 200)
    disk = np.array([40.3, 29.6]) + 20.0 * np.stack([np.cos(angle), np.sin(angle)], axis=-1)
    # Pillow fills also the parts of pixels in which an edge lies: half a third of a pixel more.
    grown = 1.0 / 6.0
    area, middle = painted(lambda painter: painter.layers(disk[None], "black", 0.3))
    assert area == pytest.approx(0.3 * np.pi * (20.0 + grown) ** 2, rel=0.01)
    np.testing.assert_allclose(middle, (40.3, 29.6), atol=0.1)
    area, middle = painted(lambda painter: painter.facets(disk[None], np.zeros((1, 3))))
    assert area == pytest.approx(np.pi * (20.0 + grown) ** 2, rel=0.01)
    area, middle = painted(lambda painter: painter.line(disk, 3.0, "black"))
    assert area == pytest.approx(2.0 * np.pi * 20.0 * 3.0, rel=0.03)
    np.testing.assert_allclose(middle, (40.3, 29.6), atol=0.1)
    area, middle = painted(lambda one: one.spot(disk[0], 10.0, 1.0, "black", 1.0))
    assert area == pytest.approx(np.pi * (4.5 + grown) ** 2, rel=0.03)
    np.testing.assert_allclose(middle, disk[0], atol=0.2)


def test_what_lies_outside_the_picture_is_left_out() -> None:
    far = np.array([[[200.0, 200.0], [300.0, 200.0], [300.0, 300.0]]])

    def paint(painter: Painter) -> None:
        painter.facets(far, np.zeros((1, 3)))
        painter.layers(far, "black", 1.0)
        painter.line(far[0], 2.0, "black")
        painter.spot(far[0, 0], 8.0, 1.0, "black", 1.0)
        painter.layers(np.array([[[-9.0, -9.0], [9.0, -9.0], [9.0, 9.0], [-9.0, 9.0]]]), "black", 1)

    area, _ = painted(paint)
    assert area == pytest.approx((9.0 + 1.0 / 3.0) ** 2, rel=0.01)


@pytest.mark.parametrize("fps", [0.3, 7.0, 12.0, 24.0, 25.0, 29.97, 30.0, 48.0, 50.0])
def test_a_gif_runs_at_the_pictures_a_second_that_were_asked_for(fps: float) -> None:
    pauses = gif_pauses(600, fps)
    assert all(pause % 10 == 0 and pause >= 20 for pause in pauses)
    assert max(pauses) - min(pauses) in (0, 10)
    # A GIF counts in hundredths of a second.
    assert sum(pauses) == pytest.approx(1e3 * 600 / fps, abs=5.0)


def test_the_pauses_of_a_gif_are_those_in_its_file(tmp_path: Path) -> None:
    path = animate(NearCollision(), tmp_path / "fall.gif", seconds=0.5, fps=30.0, size=(80, 60))
    with Image.open(path) as film:
        pauses = [frame.info["duration"] for frame in ImageSequence.Iterator(film)]
    assert sum(pauses[:-1]) == 500
    assert pauses[:-1] == gif_pauses(15, 30.0)


def test_a_trail_is_the_same_whether_it_grows_or_is_drawn_anew() -> None:
    angle = np.linspace(0.0, 8.0, 61)
    path = np.array([40.0, 30.0]) + 20.0 * np.stack([np.cos(angle), np.sin(angle)], axis=-1)
    grown, anew = (Trail(path, 2.0, (80, 60)) for _ in range(2))
    for last in (12, 36, 60, 24):
        grown.go_to(last)
    anew.go_to(12)
    anew.go_to(24)
    assert anew.mask.getbbox() == grown.mask.getbbox()
    difference = np.asarray(anew.mask, int) - np.asarray(grown.mask, int)
    # Only where pieces meet, at rounded ends, may a ninth or two of a pixel be another.
    assert np.abs(difference).max() <= 3 * 255 / 9


def test_a_page_stands_alone_and_holds_every_picture(tmp_path: Path) -> None:
    page = animate(NearCollision(), tmp_path / "fall.html", seconds=0.2, size=(80, 60)).read_text()
    assert page.count("iVBORw0KGgo") == 6
    player = re.sub(r'"iVBORw0KGgo[A-Za-z0-9+/=]*"', "", page)
    assert "http" not in player and "FPS" not in player and "PICTURES" not in player


def test_a_film_of_unknown_kind_or_with_numbers_out_of_range_is_refused(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    motion = NearCollision()
    with pytest.raises(RimrollError, match=r"\.gif, \.html, \.mp4"):
        animate(motion, tmp_path / "fall.avi")
    with pytest.raises(RimrollError, match="speed is 0"):
        animate(motion, tmp_path / "fall.gif", speed=0.0)
    with pytest.raises(RimrollError, match=r"fps is 60; a \.gif has at most 50 pictures a second"):
        animate(motion, tmp_path / "fall.gif", fps=60)
    with pytest.raises(RimrollError, match="fps is 200"):
        animate(motion, tmp_path / "fall.gif", fps=200)
    with pytest.raises(RimrollError, match='view is "below"'):
        animate(motion, tmp_path / "fall.gif", view="below")
    monkeypatch.setattr("shutil.which", lambda name: None)
    with pytest.raises(RimrollError, match="ffmpeg"):
        animate(motion, tmp_path / "fall.mp4")
    assert not list(tmp_path.iterdir())


def ffmpeg_stand_in(folder: Path, script: str) -> None:
    program = folder / "ffmpeg"
    program.write_text(f"#!/bin/sh\n{script}\n")
    program.chmod(0o755)


def test_mp4_pictures_go_to_ffmpeg_raw_and_its_complaint_comes_back(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("PATH", str(tmp_path), prepend=":")
    ffmpeg_stand_in(tmp_path, 'for last; do :; done; cat > "$last"')
    film = animate(NearCollision(), tmp_path / "fall.mp4", seconds=0.2, size=(80, 60))
    assert film.stat().st_size == 6 * 80 * 60 * 3
    ffmpeg_stand_in(tmp_path, "echo no such codec >&2; exit 1")
    with pytest.raises(RimrollError, match="no such codec"):
        animate(NearCollision(), film, seconds=4.0, size=(480, 360))
    assert sorted(each.name for each in tmp_path.iterdir()) == ["fall.mp4", "ffmpeg"]
    assert film.stat().st_size == 6 * 80 * 60 * 3


@pytest.mark.parametrize("suffix", [".gif", ".html"])
@pytest.mark.parametrize("failure", [KeyboardInterrupt, RuntimeError])
def test_a_film_that_is_interrupted_leaves_nothing_and_harms_no_older_film(
    tmp_path: Path, failure: type[BaseException], suffix: str
) -> None:
    def stop(done: int, total: int) -> None:
        if done == 3:
            raise failure

    path = tmp_path / f"fall{suffix}"
    path.write_text("older")
    with pytest.raises(failure):
        animate(NearCollision(), path, seconds=0.4, size=(80, 60), progress=stop)
    assert [each.name for each in tmp_path.iterdir()] == [path.name]
    assert path.read_text() == "older"


def test_a_file_appears_only_when_it_is_whole(tmp_path: Path) -> None:
    with writing(tmp_path / "table.csv") as part:
        assert (part.parent, part.suffix) == (tmp_path, ".csv")
        part.write_text("whole")
        assert not (tmp_path / "table.csv").exists()
    assert (tmp_path / "table.csv").read_text() == "whole"
    assert len(list(tmp_path.iterdir())) == 1


def test_a_folder_that_cannot_be_is_refused(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    with pytest.raises(RimrollError, match="a file is in the way"):
        ensure_folder(tmp_path / "file")
    with pytest.raises(RimrollError, match="a file is in the way"):
        ensure_folder(tmp_path / "file" / "folder")
    with pytest.raises(RimrollError, match="it is a folder"), writing(tmp_path):
        pass
    assert ensure_folder(tmp_path / "a" / "b").is_dir()
