"""A film of the can beside the true one, in ``rolling_near``, as an animated WebP file."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from PIL import Image

from rimroll.figures import scene
from rimroll.figures.animation.painter import Painter
from rimroll_score.cases import cases
from rimroll_score.paths import NEAR, Path5, true_path
from rimroll_score.protocol import Body
from rimroll_score.results import EngineResult

Array = NDArray[np.float64]

SIZE = 200
"""Width and height of a picture of one can, pixels."""
PAUSE = 40
"""Between two pictures, ms: eight times as slow as the motion."""
HOLD = 1200
"""For the last picture, ms."""
LETTERS = 13.0
"""Height of the words, pixels."""


def write(folder: Path, result: EngineResult) -> Path | None:
    """Write ``NAME.webp``: the true can, then one for each setting; None without paths."""
    if not result.paths:
        return None
    (case,) = (one for one in cases() if one.name == NEAR)
    true = true_path(case)
    stage = Stage(case.scene.body, true)
    shown = {"truth": true} | {setting: np.array(path) for setting, path in result.paths.items()}
    pictures = [stage.row(shown, k) for k in range(len(true))]
    file = folder / f"{result.name}.webp"
    pauses = [PAUSE] * (len(pictures) - 1) + [HOLD]
    pictures[0].save(
        file, "WEBP", save_all=True, append_images=pictures[1:], duration=pauses, loop=0,
        quality=60, method=3,
    )  # fmt: skip
    return file


class Stage:
    """The table and the camera, which all cans share."""

    def __init__(self, body: Body, true: Path5) -> None:
        self.body = body
        middle = 0.5 * (true[:, :2].min(axis=0) + true[:, :2].max(axis=0))
        reach = body.radius + body.height
        focus = (float(middle[0]), float(middle[1]), 0.5 * body.height)
        self.camera = replace(scene.Camera.perspective(), distance=8.0 * reach, focus=focus)
        self._scale = SIZE / (3.4 * reach)
        self._still = Image.new("RGB", (SIZE, SIZE), "white")
        rings, colors = scene.table_rings(self.camera, focus[:2], 2.2 * reach)
        Painter(self._still).facets(self._pixels(rings), colors)

    def row(self, shown: dict[str, Path5], k: int) -> Image.Image:
        """The cans side by side at the ``k``-th time."""
        picture = Image.new("RGB", (SIZE * len(shown), SIZE))
        for column, (name, path) in enumerate(shown.items()):
            picture.paste(self.shoot(name, path[min(k, len(path) - 1)]), (SIZE * column, 0))
        return picture

    def shoot(self, name: str, row: Array) -> Image.Image:
        """One can: ``row`` is x, y, z (m), tilt and yaw (rad)."""
        painter = Painter(self._still.copy())
        x, y, z, tilt, yaw = (float(number) for number in row)
        pose, camera = scene.Pose(tilt, yaw, 0.0, (x, y, z)), self.camera
        profile = scene.Profile.of(self.body)
        shadow = scene.shadow_layers(self.body, pose, camera, profile)
        painter.layers(self._pixels(shadow), scene.SHADOW, scene.SHADE)
        facets, colors = scene.visible_facets(self.body, pose, camera, profile)
        painter.facets(self._pixels(facets), colors)
        for line, seen in scene.rim_stretches(self.body, pose, camera):
            opacity = scene.RIM if seen else scene.HIDDEN_RIM
            painter.line(self._pixels(line), scene.RIM_WIDTH, scene.INK, opacity)
        seen = scene.contact_seen(self.body, pose, camera)
        place = self._pixels(camera.project(pose.contact(self.body)))
        opacity = 1.0 if seen else scene.HIDDEN_CONTACT
        painter.spot(place, scene.CONTACT_SIZE, scene.CONTACT_EDGE, scene.VERMILLION, opacity)
        painter.words((0.5 * SIZE, 6.0), name, LETTERS, scene.INK, "ma", 0.0)
        return painter.picture

    def _pixels(self, seen: Array) -> Array:
        """Places in pixels of points (..., 2) as the camera sees them, m."""
        return np.asarray(0.5 * SIZE + self._scale * seen * (1.0, -1.0))
