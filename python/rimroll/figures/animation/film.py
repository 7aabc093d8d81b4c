"""Films in memory and as files: GIF, a page with controls, or MP4."""

from __future__ import annotations

import base64
import io
import os
import shutil
import subprocess
import tempfile
from collections.abc import Callable, Iterable, Iterator
from contextlib import suppress
from importlib.resources import files
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
from PIL import Image, ImageChops

from rimroll.errors import RimrollError, callback
from rimroll.figures import scene
from rimroll.figures.animation.clock import film_clock
from rimroll.figures.animation.stage import ShakenStage, Stage
from rimroll.figures.scene import Camera, Motion, RoundBody
from rimroll.files.output import writing
from rimroll.ground.ground import Ground

HOLD = 1.2  # s for which the last picture of a film stays
GIF_FASTEST = 50.0
"""Pictures a second: browsers show a pause below 20 ms as one of 100 ms."""
TINTS = 14
"""The number of colours, from its own to white, that each thin bright line gets."""

UNCHANGED = 255
"""The colour of a GIF that leaves a pixel as in the previous picture."""

Writer = Callable[[Path, Iterable[Image.Image], Stage, float], None]


def writer_for(path: Path, fps: float) -> Writer:
    """The function that writes pictures to a file of this suffix; ``RimrollError`` if there is
    none."""
    writers: dict[str, Writer] = {".gif": _write_gif, ".html": _write_page, ".mp4": _write_mp4}
    suffix = path.suffix.lower()
    if suffix not in writers:
        known = ", ".join(writers)
        raise RimrollError(f'a film can be {known}, not "{suffix}" (asked for: {path.name})')
    if suffix == ".gif" and fps > GIF_FASTEST:
        raise RimrollError(
            f"fps is {fps:g}; a .gif has at most {GIF_FASTEST:g} pictures a second, .html and .mp4"
            " have up to 100"
        )
    if suffix == ".mp4" and shutil.which("ffmpeg") is None:
        raise RimrollError("an .mp4 film needs ffmpeg, which was not found; write .gif or .html")
    return writers[suffix]


def _palette(stage: Stage) -> Image.Image:
    """One palette of 255 colours for all pictures, so that colours do not flicker."""
    bright = np.array([scene.rgb(c) for c in (scene.VERMILLION, scene.ORANGE, scene.INK)])
    most = UNCHANGED - TINTS * len(bright)
    some = [
        np.asarray(stage.shoot(k))[::2, ::2]  # a quarter of the pixels is enough
        for k in np.linspace(0, stage.count - 1, 6).astype(int)
    ]
    palette = Image.fromarray(np.vstack(some)).quantize(most)
    # Thin bright lines have too few pixels to get colours of their own, so some are reserved.
    tints = 1.0 - np.linspace(1.0, 0.2, TINTS)[:, None, None] * (1.0 - bright)
    found = (palette.getpalette() or [])[: 3 * most]
    found += [0] * (3 * most - len(found))
    tinted = np.rint(255.0 * tints).astype(int).ravel().tolist()
    palette.putpalette([*found, *tinted])
    return palette


def _reduced(shots: Iterable[Image.Image], palette: Image.Image) -> Iterator[Image.Image]:
    for shot in shots:
        yield shot.quantize(palette=palette, dither=Image.Dither.NONE)


def _changes(pictures: Iterable[Image.Image]) -> Iterator[Image.Image]:
    """Pictures without the pixels that are equal in the previous one, which makes them small."""
    before = None
    for picture in pictures:
        changes = picture.copy()
        if before is not None:
            same = ImageChops.difference(picture, before).point([255] + 255 * [0], "1")
            changes.paste(UNCHANGED, mask=same)
        before = picture
        yield changes


def gif_pauses(count: int, fps: float) -> list[int]:
    """How long each of ``count`` pictures of a GIF stays, ms: multiples of 10, as in the format.

    Their sums are rounded and not each by itself, so that the film runs at ``fps``: at 30 pictures
    a second 30, 40, 30, 30, ...
    """
    ends = [10 * round(100.0 * k / fps) for k in range(count + 1)]
    return [end - start for start, end in pairwise(ends)]


def _write_gif(path: Path, shots: Iterable[Image.Image], stage: Stage, fps: float) -> None:
    pictures = _changes(_reduced(shots, _palette(stage)))
    pause = [*gif_pauses(stage.count - 1, fps), round(1000.0 * HOLD)]
    first = next(pictures)
    with path.open("wb") as file:
        first.save(
            file,
            "GIF",
            save_all=True,
            append_images=pictures,
            duration=pause,
            loop=0,
            transparency=UNCHANGED,
            disposal=1,  # leave each picture for the next to change
            optimize=False,  # it would choose palettes and find changes again, which takes long
        )


def _write_mp4(path: Path, shots: Iterable[Image.Image], stage: Stage, fps: float) -> None:
    width, height = stage.shoot(0).size
    source = ["-f", "rawvideo", "-pix_fmt", "rgb24", "-s", f"{width}x{height}", "-r", f"{fps:g}"]
    # Four pixels share a colour in H.264: the sides must be even.
    even = ["-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2", "-pix_fmt", "yuv420p"]
    command = ["ffmpeg", "-loglevel", "error", "-y", *source, "-i", "-", *even, str(path)]
    with subprocess.Popen(command, stdin=subprocess.PIPE, stderr=subprocess.PIPE) as ffmpeg:
        assert ffmpeg.stdin is not None
        assert ffmpeg.stderr is not None
        try:
            for shot in shots:
                ffmpeg.stdin.write(shot.tobytes())
            ffmpeg.stdin.close()
        except BrokenPipeError:
            # It stopped early; closing may raise the same again, but the reason is on its stderr.
            with suppress(BrokenPipeError):
                ffmpeg.stdin.close()
        except BaseException:
            ffmpeg.kill()
            raise
        reason = ffmpeg.stderr.read().decode(errors="replace").strip()
    if ffmpeg.returncode:
        raise RimrollError(f"ffmpeg could not write the film: {reason or 'it gave no reason'}")


def _write_page(path: Path, shots: Iterable[Image.Image], stage: Stage, fps: float) -> None:
    player = files("rimroll.figures.animation").joinpath("player.html").read_text(encoding="utf-8")
    head, tail = player.replace("FPS", f"{fps:g}").split("PICTURES")
    with path.open("w", encoding="utf-8") as page:
        page.write(head)
        for shot in _reduced(shots, _palette(stage)):
            png = io.BytesIO()
            shot.save(png, "PNG")
            page.write(f'"{base64.b64encode(png.getvalue()).decode()}",\n')
        page.write(tail)


SMALL: dict[str, Any] = {"fps": 15.0, "size": (400, 300)}
SHORT = {"seconds": 6.0}
"""Options of a film in a notebook, whose file holds the film as text."""


class Film:
    """A film as a GIF in memory; :meth:`rimroll.Motion.film` makes it, and a notebook shows it."""

    data: bytes
    """The content of the GIF."""

    def __init__(self, data: bytes) -> None:
        self.data = data

    def save(self, path: str | os.PathLike[str]) -> Path:
        """Write the film to a .gif file and return its path.

        Raises ``RimrollError`` for another suffix, and for a place that cannot be written to.
        """
        path = Path(path)
        if path.suffix.lower() != ".gif":
            raise RimrollError(
                f"a film in memory is a .gif (asked for: {path.name}); the motion's method animate"
                " writes other kinds"
            )
        with writing(path) as part:
            part.write_bytes(self.data)
        return path

    def __repr__(self) -> str:
        return f"<Film, GIF of {len(self.data) / 1e3:.0f} kB>"

    def _repr_html_(self) -> str:
        """The view in notebooks."""
        text = base64.b64encode(self.data).decode()
        alt = "The body rocks and rolls on the rim of its base."
        return f'<img src="data:image/gif;base64,{text}" alt="{alt}">'


def film(motion: Motion, **options: Any) -> Film:
    """The film that :func:`rimroll.figures.animation.animate` would write with these options.

    Unless they are given, it has 15 pictures a second of 400 × 300 pixels and lasts 6 s.
    """
    length = {} if options.keys() & {"seconds", "speed"} else SHORT
    with tempfile.TemporaryDirectory(prefix="rimroll-") as folder:
        path = animate(motion, Path(folder) / "film.gif", **{**SMALL, **length, **options})
        return Film(path.read_bytes())


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
