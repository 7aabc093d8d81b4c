"""The contents of a film: what stands still is painted once, the rest for each picture."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace

import numpy as np
from PIL import Image

from rimroll import scene
from rimroll.animation.clock import FilmClock, slowed
from rimroll.animation.painter import Painter, Trail
from rimroll.errors import RimrollError
from rimroll.scene import Array, Camera, Motion, Pose, RoundBody
from rimroll.turn_spans import Span, turn_spans

POINT = 100.0 / 72.0  # pixels
CAPTION, LABEL = 10.0, 9.0  # sizes of type, points
HALO = 1.0  # points of white around text on the scene
TRAIL_WIDTH = 1.5  # points
UNDER_THE_BODY = 0.22  # opacity of the trail where the body hides it
WORTH_A_WEDGE = 0.1  # rad: smaller angles are not drawn


class Stage:
    """All that a film shows; its pictures are ``size`` pixels wide and high."""

    def __init__(
        self,
        motion: Motion,
        body: RoundBody,
        clock: FilmClock,
        fps: float,
        view: str | Camera,
        size: tuple[int, int],
    ) -> None:
        self.body = body
        self.size = size
        self.count = max(2, round(clock.seconds * fps) + 1)
        film = np.linspace(0.0, clock.seconds, self.count)
        self.t = clock.times(film)
        self.slowdown = clock.slowdown(film)
        self.states = motion.evaluate(self.t)
        # The trail has six points per picture, so that its bends have no corners.
        fine = clock.times(np.linspace(0.0, clock.seconds, 6 * (self.count - 1) + 1))
        self._path = scene.contact_path(motion.evaluate(fine), body)
        self._prepare(motion)
        self.camera = _camera(view, body, self.states.center)
        (self._left, right), (low, self._high) = self._limits(size[0] / size[1])
        self._per_meter = np.array([size[0] / (right - self._left), size[1] / (self._high - low)])
        self._set_up()

    def _prepare(self, motion: Motion) -> None:
        """What must be known before the limits of the picture."""
        self.turns = _turns(motion, self.body)

    def _set_up(self) -> None:
        """What stands still, and the trail."""
        self.trail = Trail(self._on_table(self._path), POINT * TRAIL_WIDTH, self.size)
        x, y = self.camera.focus[:2]
        reach = 0.62 * self.size[0] / self._per_meter[0]
        rings, colors = scene.table_rings(self.camera, (x, y), reach)
        self.still = Image.new("RGB", self.size, "white")
        Painter(self.still).facets(self._pixels(rings), colors)

    def _limits(self, aspect: float) -> tuple[tuple[float, float], tuple[float, float]]:
        """Limits of the picture that contain the body at all times, with room for captions."""
        seen = np.concatenate(self._seen())
        low, high = seen.min(axis=0), seen.max(axis=0)
        middle, half = 0.5 * (low + high), 0.5 * (high - low)
        tall = max(1.25 * half[1], 1.08 * half[0] / aspect)
        wide = aspect * tall
        x, y = float(middle[0]), float(middle[1] + 0.08 * tall)
        return (x - wide, x + wide), (y - tall, y + tall)

    def _seen(self) -> list[Array]:
        """Points (..., 2) that must be in the picture, m as the camera sees them."""
        shape = scene.Profile.of(self.body).points(16)
        seen = [
            self._camera_at(k).project(scene.pose_at(self.states, k).place(shape, self.body))
            for k in range(self.count)
        ]
        angle = np.linspace(0.0, 2.0 * np.pi, 24)
        around = 1.8 * self.body.radius * np.stack([np.cos(angle), np.sin(angle), 0 * angle], -1)
        return seen + [
            self.camera.project(around + np.append(turn.center, 0.0)) for turn in self.turns
        ]

    def _camera_at(self, k: int) -> Camera:
        """The camera as seen from the table in the ``k``-th picture."""
        return self.camera

    def _pixels(self, seen: Array) -> Array:
        """Places in pixels of points (..., 2) as the camera sees them, m."""
        return np.asarray((seen - (self._left, self._high)) * self._per_meter * (1.0, -1.0))

    def _on_table(self, points: Array) -> Array:
        """Places in pixels of points (..., 2) of the table, m."""
        return self._pixels(self.camera.project(scene.on_table(points)))

    def shots(self, progress: Callable[[int, int], object] | None = None) -> Iterator[Image.Image]:
        """All pictures, in order."""
        for k in range(self.count):
            yield self.shoot(k)
            if progress is not None:
                progress(k + 1, self.count)

    def shoot(self, k: int) -> Image.Image:
        """The ``k``-th picture, RGB."""
        painter, camera = Painter(self.still.copy()), self._camera_at(k)
        self._paint_table(painter, camera)
        pose = scene.pose_at(self.states, k)
        profile = scene.Profile.of(self.body)
        shadow = scene.shadow_layers(self.body, pose, camera, profile)
        painter.layers(self._pixels(shadow), scene.SHADOW, scene.SHADE)
        wedge = self._wedge(k)
        if wedge is not None:
            painter.layers(self._pixels(wedge.sector)[None], scene.ORANGE, scene.WEDGE)
            painter.line(self._pixels(wedge.arc), POINT * scene.ARC_WIDTH, scene.ORANGE)
        self._paint_trail(painter, k, camera)
        facets, colors = scene.visible_facets(self.body, pose, camera, profile)
        painter.facets(self._pixels(facets), colors)
        for line, seen in scene.rim_stretches(self.body, pose, camera):
            opacity = scene.RIM if seen else scene.HIDDEN_RIM
            painter.line(self._pixels(line), POINT * scene.RIM_WIDTH, scene.INK, opacity)
        self._paint_trail(painter, k, camera, UNDER_THE_BODY)
        self._mark_contact(painter, pose, camera)
        if wedge is not None:
            self._write_angle(painter, wedge)
        self._write_captions(painter, k)
        return painter.picture

    def _paint_table(self, painter: Painter, camera: Camera) -> None:
        """What moves of the table: nothing."""

    def _paint_trail(self, painter: Painter, k: int, camera: Camera, opacity: float = 1.0) -> None:
        """The path of the contact point up to the ``k``-th picture."""
        self.trail.go_to(6 * k)
        painter.trail(self.trail, scene.VERMILLION, opacity)

    def _wedge(self, k: int) -> scene.Wedge | None:
        """The angle turned so far, which stays until the next turn has begun."""
        for turn in reversed(self.turns):
            angle = float(self.states.yaw[k]) - turn.yaw
            if self.t[k] > turn.span.end:
                angle = turn.span.angle
            if self.t[k] > turn.span.start and abs(angle) > WORTH_A_WEDGE:
                size, start = 1.55 * self.body.radius, turn.yaw + np.pi
                return scene.wedge(self.camera, turn.center, size, start, angle)
        return None

    def _mark_contact(self, painter: Painter, pose: Pose, camera: Camera) -> None:
        seen = scene.contact_seen(self.body, pose, camera)
        place = self._pixels(camera.project(pose.contact(self.body)))
        size, edge = POINT * scene.CONTACT_SIZE, POINT * scene.CONTACT_EDGE
        opacity = 1.0 if seen else scene.HIDDEN_CONTACT
        painter.spot(place, size, edge, scene.VERMILLION, opacity)

    def _write_angle(self, painter: Painter, wedge: scene.Wedge) -> None:
        way = scene.way_in_picture(self.camera, wedge.azimuth) * scene.label_offset(LABEL)
        place = self._on_table(wedge.spot) + POINT * way * (1.0, -1.0)
        painter.words(place.tolist(), wedge.text, POINT * LABEL, scene.INK, "mm", POINT * HALO)

    def _write_captions(self, painter: Painter, k: int) -> None:
        width, height = self.size
        tick = max(1e-12, 1.0 / self.slowdown[k])
        digits = int(np.clip(np.ceil(-np.log10(tick)) + 1, 3, 12))
        left = f"t = {self.t[k]:.{digits}f} s\ntilt {np.degrees(self.states.tilt[k]):.3g}°"
        right = slowed(self.slowdown[k])
        for share, text, anchor in ((0.035, left, "la"), (0.965, right, "ra")):
            place = (share * width, 0.045 * height)
            painter.words(place, text, POINT * CAPTION, scene.INK, anchor, 0.0)


@dataclass(frozen=True)
class _Turn:
    """A turn as it is drawn: when, about which point of the table, from which yaw."""

    span: Span
    center: Array
    yaw: float


def _turns(motion: Motion, body: RoundBody) -> list[_Turn]:
    turns = []
    for span in turn_spans(motion):
        states = motion.evaluate(np.array([span.start, span.near]))
        center = scene.pose_at(states, 1).base_center(body)[:2]
        turns.append(_Turn(span, center, float(states.yaw[0])))
    return turns


def _camera(view: str | Camera, body: RoundBody, center: Array) -> Camera:
    if isinstance(view, Camera):
        return view
    middle = 0.5 * (center[:, :2].min(axis=0) + center[:, :2].max(axis=0))
    focus = (float(middle[0]), float(middle[1]), 0.0)
    reach = float(np.ptp(center[:, :2], axis=0).max()) + body.radius + body.height
    cameras = {
        "perspective": replace(Camera.perspective(), distance=7.0 * reach, focus=focus),
        "side": Camera.side(focus=focus),
        "top": Camera.top(focus=focus),
    }
    if view not in cameras:
        raise RimrollError(f'view is "{view}"; it must be one of {", ".join(cameras)}, or a Camera')
    return cameras[view]
