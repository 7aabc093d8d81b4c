"""Writes a film of a motion to a file."""

from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path

from rimroll.animation.clock import film_clock
from rimroll.animation.files import writer_for
from rimroll.animation.shaken_stage import ShakenStage
from rimroll.animation.stage import Stage
from rimroll.errors import RimrollError, callback
from rimroll.ground.ground import Ground
from rimroll.output import writing
from rimroll.scene import Camera, Motion, RoundBody


def animate(
    motion: Motion,
    path: str | os.PathLike[str],
    *,
    body: RoundBody | None = None,
    speed: float | None = None,
    fps: float = 25.0,
    seconds: float | None = None,
    view: str | Camera = "perspective",
    slow_collision: bool | None = None,
    size: tuple[int, int] = (480, 360),
    progress: Callable[[int, int], object] | None = None,
) -> Path:
    """Film ``motion`` and write it to ``path``, a .gif, .html or .mp4 file; return the path.

    ``speed`` is film speed over real speed, by default 0.25, ``fps`` the number of pictures per
    second (at most 50 in a .gif), ``seconds`` the length of the film if it is to be fixed, ``view``
    "perspective", "side", "top" or a camera, and ``size`` the picture in pixels. With
    ``slow_collision`` the film slows down while the contact point runs round the rim, and says how
    much; this is the default. ``body`` replaces the motion's own, to give it a profile.
    ``progress`` is called with pictures done and pictures to do.

    The film of a motion on a table that moves runs in real time and is not slowed, unless ``speed``
    or ``slow_collision`` say otherwise. The eye is at rest: the table, which has a grid, and the
    body on it move over a dashed outline that stays where the table was at first. The record is
    below, with the present moment marked. The table's place is :meth:`rimroll.Ground.displacement`;
    where this exceeds four times the body's radius and height, as in a record that drifts
    (:meth:`rimroll.Ground.detrended` corrects the baseline) or after a pulse that leaves the table
    with a velocity, the eye moves with the table, and the film says so.

    The file appears under its name only when it is whole. Raises ``RimrollError`` for an unknown
    suffix or view, for numbers out of range, and for .mp4 where there is no ffmpeg.
    """
    path = Path(path)
    if not 0.0 < fps <= 100.0:
        raise RimrollError(f"fps is {fps:g}; it must be above 0 and at most 100")
    write = writer_for(path, fps)
    callback("progress", progress)
    ground: Ground | None = getattr(motion, "ground", None)
    clock = film_clock(
        motion,
        speed=(0.25 if ground is None else 1.0) if speed is None else speed,
        seconds=seconds,
        slow_collision=ground is None if slow_collision is None else slow_collision,
    )
    shown = (body or motion.body, clock, fps, view, size)
    stage = Stage(motion, *shown) if ground is None else ShakenStage(motion, ground, *shown)
    with writing(path) as part:
        write(part, stage.shots(progress), stage, fps)
    return path
