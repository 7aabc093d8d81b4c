"""The contents of a film in which the table moves, with the record of its motion below."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from PIL import Image

from rimroll import scene
from rimroll.animation.clock import FilmClock
from rimroll.animation.moving_table import LINE, MovingTable
from rimroll.animation.painter import Painter
from rimroll.animation.stage import CAPTION, LABEL, POINT, TRAIL_WIDTH, Stage
from rimroll.animation.strip import Strip
from rimroll.ground.ground import Ground
from rimroll.scene import Array, Camera, Motion, RoundBody

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
