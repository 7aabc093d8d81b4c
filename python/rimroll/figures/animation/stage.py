"""The contents of a film: what stands still is painted once, the rest for each picture."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace

import numpy as np
from PIL import Image

from rimroll.errors import RimrollError
from rimroll.figures import scene
from rimroll.figures.animation.clock import FilmClock, slowed
from rimroll.figures.animation.painter import Painter, Trail
from rimroll.figures.scene import Array, Camera, Motion, Pose, RoundBody
from rimroll.figures.scene.pose import Span, turn_spans
from rimroll.ground.ground import Ground

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


FAR = 4.0
"""The eye moves with a table that moves by more than this many sizes (R + H) of the body."""

LINES = 3
"""The plate has about this many lines of its grid from its middle to its edge."""

THICKNESS = 0.07
"""The thickness of the plate, as a fraction of half its length."""

FRONT, LINE = "#c3c8cc", "#b4babf"
"""The colours of the plate's sides and of its grid."""


@dataclass(frozen=True, eq=False)
class MovingTable:
    """A square plate that a table carries, and its displacement at the pictures of a film.

    Attributes
    ----------
    middle
        The plate's middle (2,), m on the table.
    half
        Half of its length, m.
    moved
        The table's displacement since t = 0 (n, 3), m, as it is shown.
    farthest
        The largest displacement, m.
    """

    middle: Array
    half: float
    moved: Array
    farthest: float

    @classmethod
    def under(cls, body: RoundBody, contacts: Array, ground: Ground, t: Array) -> MovingTable:
        """The plate for contact points (m, 2) on the table, at times (n,).

        A table that moves too far for a picture is shown as seen from itself.
        """
        middle = 0.5 * (contacts.min(axis=0) + contacts.max(axis=0))
        path = float(np.abs(contacts - middle).max())
        moved = ground.displacement(t)
        farthest = float(np.linalg.norm(moved, axis=-1).max())
        if farthest > FAR * (body.radius + body.height):
            moved = np.zeros_like(moved)
        half = path + body.radius + 0.4 * (body.radius + body.height)
        return cls(middle, half, moved, farthest)

    @property
    def is_seen_from_itself(self) -> bool:
        """Whether the eye that sees the pictures moves with the table."""
        return self.farthest > 0.0 and not self.moved.any()

    def corners(self) -> Array:
        """The corners of its upper side (4, 3), m on the table."""
        square = np.array([[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]])
        return scene.on_table(self.middle + self.half * square)

    def faces(self, camera: Camera) -> tuple[Array, Array]:
        """Its sides and its upper side: polygons (5, 4, 2) in the picture, colours (5, 3)."""
        top = self.corners()
        below = top - [0.0, 0.0, THICKNESS * self.half]
        sides = [
            np.array([top[i], top[i - 1], below[i - 1], below[i]])
            for i in np.argsort(camera.depth(0.5 * (top + np.roll(top, 1, axis=0))))
        ]
        colors = [scene.rgb(FRONT)] * 4 + [scene.rgb(scene.TABLE)]
        return camera.project(np.array([*sides, top])), np.array(colors)

    def grid(self, camera: Camera) -> list[Array]:
        """The lines (2, 2) of its grid in the picture; they are fixed to the table."""
        step = round_step(self.half / LINES)
        lines = []
        for axis in (0, 1):
            low, high = self.middle[axis] - self.half, self.middle[axis] + self.half
            for place in np.arange(np.ceil(low / step), np.floor(high / step) + 1.0) * step:
                ends = np.tile(self.middle, (2, 1))
                ends[:, 1 - axis] += [-self.half, self.half]
                ends[:, axis] = place
                lines.append(camera.project(scene.on_table(ends)))
        return lines


def round_step(length: float) -> float:
    """The largest of 1, 2 or 5 times a power of ten up to a length."""
    power = 10.0 ** np.floor(np.log10(length))
    return float(max(factor * power for factor in (1.0, 2.0, 5.0) if factor * power <= length))


COLORS = (scene.BLUE, scene.ORANGE, scene.GREEN)
TO_COME = 0.3  # opacity of what is still to come


class Strip:
    """The record of a ground from t = 0 to ``end`` (s) in a picture of ``size`` pixels."""

    def __init__(self, ground: Ground, end: float, size: tuple[int, int]) -> None:
        self.size = size
        width, height = size
        self._left, self._right = 0.035 * width, 0.965 * width
        self._end = end
        self._top, self._bottom = POINT * LABEL * 1.7, height - POINT * LABEL * 1.6
        self._curves(ground)
        self.past, self.to_come = self._painted(1.0), self._painted(TO_COME)

    def _curves(self, ground: Ground) -> None:
        lines = ground._lines
        last = max(self._end, float(lines.t[-1]))
        t = np.concatenate([lines.t, [lines.t[-1], last]])
        values = np.concatenate([lines.acceleration, np.zeros((2, 3))])
        self._peaks = np.abs(values[t <= self._end]).max(axis=0)
        largest = float(self._peaks.max()) or 1.0
        middle, half = 0.5 * (self._top + self._bottom), 0.5 * (self._bottom - self._top)
        x, y = self._place(t), middle - half * values / largest
        shown = np.searchsorted(t, self._end, side="right") + 1
        self.curves = [
            (color, extremes(x[:shown], y[:shown, axis]))
            for axis, color in enumerate(COLORS)
            if self._peaks[axis] > 0.0
        ]
        self._middle = middle

    def _place(self, t: Array | float) -> Array:
        """Where times are, pixels from the left."""
        return np.asarray(self._left + (self._right - self._left) * np.asarray(t) / self._end)

    def _painted(self, opacity: float) -> Image.Image:
        picture = Image.new("RGB", self.size, "white")
        painter = Painter(picture)
        axis = np.array([[self._left, self._middle], [self._right, self._middle]])
        painter.line(axis, 0.5 * POINT, scene.INK, 0.4)
        for color, curve in self.curves:
            painter.line(curve, 0.8 * POINT, color, opacity)
        # What runs beyond the end is covered.
        picture.paste("white", (round(self._right) + 2, 0, *self.size))
        self._write(painter)
        return picture

    def _write(self, painter: Painter) -> None:
        size = POINT * LABEL
        x = self._left
        head = "ground acceleration:" if self._peaks.any() else "the ground is at rest"
        painter.words((x, 0.1 * size), head, size, scene.INK, "la", 0.0)
        x += 0.57 * size * len(head)
        for axis, color, peak in zip("xyz", COLORS, self._peaks, strict=True):
            if peak > 0.0:
                text = f"{axis} ≤ {peak:.3g}"
                painter.words((x, 0.1 * size), text, size, color, "la", 0.0)
                x += 0.62 * size * (len(text) + 1)
        if self._peaks.any():
            painter.words((x, 0.1 * size), "m/s²", size, scene.INK, "la", 0.0)
        below = self.size[1] - 0.25 * size
        for x, text, anchor in (
            (self._left, "0", "ls"),
            (self._right, f"{self._end:.3g} s", "rs"),
        ):
            painter.words((x, below), text, size, scene.INK, anchor, 0.0)

    def at(self, t: float) -> Image.Image:
        """The strip at a time, s: what is still to come is pale."""
        picture = self.to_come.copy()
        x = float(self._place(min(max(t, 0.0), self._end)))
        whole = round(x)
        picture.paste(self.past.crop((0, 0, whole, self.size[1])), (0, 0))
        painter = Painter(picture)
        mark = np.array([[x, self._top - 2.0], [x, self._bottom + 2.0]])
        painter.line(mark, 1.2 * POINT, scene.VERMILLION)
        return picture


def extremes(x: Array, y: Array) -> Array:
    """A curve (m, 2) that looks like that through the points (n,), with at most four a pixel.

    It has the first, the last, the lowest and the highest point of each column of pixels.
    """
    column = np.floor(x).astype(int)
    starts = np.flatnonzero(np.diff(column, prepend=column[0] - 1))
    if len(starts) * 4 >= len(x):
        return np.stack([x, y], axis=-1)
    ends = np.append(starts[1:], len(x))
    keep = []
    for start, end in zip(starts, ends, strict=True):
        part = y[start:end]
        keep += sorted({start, start + int(part.argmin()), start + int(part.argmax()), end - 1})
    return np.stack([x[keep], y[keep]], axis=-1)


STRIP = 0.24
"""The part of the picture's height that the record takes."""

MIN_HEIGHT = round(4.5 * POINT * LABEL)
"""The smallest height of the record, pixels."""

MARK_WIDTH, GRID_WIDTH = 1.2, 0.6  # points


class ShakenStage(Stage):
    """A film of a motion on a table that moves.

    The eye is at rest. The table's plate with its grid, the body and its trail move over a dashed
    outline that stays where the plate was at t = 0. What is on the table is painted in the frame of
    the table, as seen by an eye that moves the other way. A table that moves far away, as that of a
    record whose baseline was not corrected, is shown by an eye that moves with it.
    """

    def __init__(
        self,
        motion: Motion,
        ground: Ground,
        body: RoundBody,
        clock: FilmClock,
        fps: float,
        view: str | Camera,
        size: tuple[int, int],
    ) -> None:
        self._ground = ground
        # In a small picture the record's captions need a larger part.
        width, height = size[0], max(round(STRIP * size[1]), min(MIN_HEIGHT, size[1] // 2))
        super().__init__(motion, body, clock, fps, view, (width, size[1] - height))
        self.strip = Strip(ground, float(motion.t[-1]), (width, height))

    def _prepare(self, motion: Motion) -> None:
        # A wedge says little of a body that rocks on a table that moves.
        self.turns = []
        self.table = MovingTable.under(self.body, self._path, self._ground, self.t)

    def _set_up(self) -> None:
        self.still = Image.new("RGB", self.size, "white")

    def _camera_at(self, k: int) -> Camera:
        x, y, z = np.asarray(self.camera.focus) - self.table.moved[k]
        return replace(self.camera, focus=(float(x), float(y), float(z)))

    def _seen(self) -> list[Array]:
        plate = [self._camera_at(k).project(self.table.corners()) for k in range(self.count)]
        return super()._seen() + plate

    def _paint_table(self, painter: Painter, camera: Camera) -> None:
        faces, colors = self.table.faces(camera)
        painter.facets(self._pixels(faces), colors)
        for line in self.table.grid(camera):
            painter.line(self._pixels(line), POINT * GRID_WIDTH, LINE)
        if self.table.is_seen_from_itself:
            return
        corners = self._pixels(self.camera.project(self.table.corners()))
        for i in range(4):
            for dash in _dashes(corners[i - 1], corners[i]):
                painter.line(dash, POINT * MARK_WIDTH, scene.BLUE)

    def _paint_trail(self, painter: Painter, k: int, camera: Camera, opacity: float = 1.0) -> None:
        if k > 0:
            seen = camera.project(scene.on_table(self._path[: 6 * k + 1]))
            painter.line(self._pixels(seen), POINT * TRAIL_WIDTH, scene.VERMILLION, opacity)

    def shoot(self, k: int) -> Image.Image:
        """The ``k``-th picture, RGB, with the record below."""
        seen, strip = super().shoot(k), self.strip.at(float(self.t[k]))
        picture = Image.new("RGB", (seen.width, seen.height + strip.height))
        picture.paste(seen)
        picture.paste(strip, (0, seen.height))
        return picture

    def _write_captions(self, painter: Painter, k: int) -> None:
        super()._write_captions(painter, k)
        if self.table.is_seen_from_itself:
            text = f"seen from the table, which moves by {self.table.farthest:.2g} m"
            width, height = self.size
            place = (0.965 * width, 0.045 * height + 1.3 * POINT * CAPTION)
            painter.words(place, text, POINT * CAPTION, scene.INK, "ra", 0.0)


def _dashes(start: Array, end: Array, length: float = 7.0) -> list[Array]:
    """The dashes (2, 2) of a line, pixels; it begins and ends with one."""
    count = 2 * int(np.hypot(*(end - start)) / (2.0 * length)) + 1
    edges = start + np.linspace(0.0, 1.0, count + 1)[:, np.newaxis] * (end - start)
    return [edges[i : i + 2] for i in range(0, count, 2)]
