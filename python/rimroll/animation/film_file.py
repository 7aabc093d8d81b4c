"""Writes a film of a motion to a file."""

from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path

from rimroll.animation.clock import film_clock
from rimroll.animation.files import writer_for
from rimroll.animation.stage import Stage
from rimroll.errors import RimrollError, callback
from rimroll.output import writing
from rimroll.scene import Camera, Motion, RoundBody


def animate(
    motion: Motion,
    path: str | os.PathLike[str],
    *,
    body: RoundBody | None = None,
    speed: float = 0.25,
    fps: float = 25.0,
    seconds: float | None = None,
    view: str | Camera = "perspective",
    slow_collision: bool = True,
    size: tuple[int, int] = (480, 360),
    progress: Callable[[int, int], object] | None = None,
) -> Path:
    """Film ``motion`` and write it to ``path``, a .gif, .html or .mp4 file; return the path.

    ``speed`` is film speed over real speed, ``fps`` the number of pictures per second (at
    most 50 in a .gif), ``seconds`` the length of the film if it is to be fixed, ``view``
    "perspective", "side", "top" or a camera, and ``size`` the picture in pixels. With
    ``slow_collision`` the film slows down while the contact point runs round the rim, and says how
    much. ``body`` replaces the motion's own, to give it a profile. ``progress`` is called with
    pictures done and pictures to do.

    The file appears under its name only when it is whole. Raises ``RimrollError`` for an unknown
    suffix or view, for numbers out of range, and for .mp4 where there is no ffmpeg.
    """
    path = Path(path)
    if not 0.0 < fps <= 100.0:
        raise RimrollError(f"fps is {fps:g}; it must be above 0 and at most 100")
    write = writer_for(path, fps)
    callback("progress", progress)
    clock = film_clock(motion, speed=speed, seconds=seconds, slow_collision=slow_collision)
    stage = Stage(motion, body or motion.body, clock, fps, view, size)
    with writing(path) as part:
        write(part, stage.shots(progress), stage, fps)
    return path
