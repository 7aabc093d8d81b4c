"""Films of a motion: GIF, a page with controls, or MP4, slowed where the contact point runs."""

from __future__ import annotations

import base64
import io
import os
import shutil
import subprocess
from collections.abc import Callable, Iterable, Iterator
from contextlib import suppress
from dataclasses import dataclass, replace
from functools import cache
from pathlib import Path

import numpy as np
from matplotlib.artist import Artist
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.colors import to_rgb
from matplotlib.figure import Figure
from matplotlib.font_manager import FontProperties, findfont
from matplotlib.text import Annotation
from PIL import Image, ImageDraw, ImageFont

from rimroll import scene
from rimroll.errors import RimrollError, callback
from rimroll.falling import Span, turn_spans
from rimroll.output import writing
from rimroll.scene import Array, Camera, Motion, RoundBody

PACE = 1.1 * np.pi  # rad of yaw in a second of film: as fast as an eye likes to follow the contact
LONGEST = 1.5  # the runs of the contact point take at most this many times the rest of the film
DPI = 100
POINT = DPI / 72.0  # pixels
CAPTION = 10.0  # points
WORTH_A_WEDGE = 0.1  # rad: less is not yet a turn
HOLD = 1.2  # s for which the last picture of a film stays


@dataclass(frozen=True)
class FilmClock:
    """A monotone map between film time and the motion's time, both (n,), s."""

    film: Array
    t: Array

    @property
    def seconds(self) -> float:
        """Length of the film, s."""
        return float(self.film[-1])

    def times(self, film: Array) -> Array:
        """The motion's times at film times, s."""
        return np.interp(film, self.film, self.t)

    def slowdown(self, film: Array) -> Array:
        """Film seconds per second of the motion at film times; infinite if no time passes."""
        step = np.clip(np.searchsorted(self.film, film, side="right") - 1, 0, len(self.t) - 2)
        with np.errstate(divide="ignore"):
            return np.asarray(np.diff(self.film)[step] / np.diff(self.t)[step])


def film_clock(
    motion: Motion, *, speed: float, seconds: float | None = None, slow_collision: bool = True
) -> FilmClock:
    """Tell film time by the motion's own samples, which are dense where the contact point runs.

    Film time is t / ``speed``, plus time for the yaw that the film could not show at that speed.
    ``seconds`` stretches the whole film to a given length. A run that is over within the spacing
    of floating-point times is passed in one step.
    """
    for name, value in (("speed", speed), ("seconds", 1.0 if seconds is None else seconds)):
        if not 0.0 < value < np.inf:
            raise RimrollError(f"{name} is {value:g}; it must be positive and finite")
    steps = np.arange(len(motion.t))
    # Four points a step: the yaw is far from linear in time within one step of the solver.
    t = np.interp(np.linspace(0, steps[-1], 4 * steps[-1] + 1), steps, motion.t)
    t = t[np.append(True, np.diff(t) > 0.0)]
    if len(t) < 2:
        raise RimrollError("the motion has no duration: there is nothing to film")
    plain = np.diff(t) / speed
    film = plain
    if slow_collision:
        excess = np.clip(np.abs(np.diff(motion.evaluate(t).yaw)) - PACE * plain, 0.0, None)
        run = excess / PACE
        film = plain + run * min(1.0, LONGEST * plain.sum() / max(run.sum(), 1e-300))
    film = np.append(0.0, np.cumsum(film))
    if seconds is not None:
        film *= seconds / film[-1]
    return FilmClock(film, t)


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

    ``speed`` is film speed over real speed, ``fps`` the pictures a second, ``seconds`` the length
    of the film if it is to be fixed, ``view`` "perspective", "side", "top" or a camera, and
    ``size`` the picture in pixels. With ``slow_collision`` the film slows down while the contact
    point runs round the rim, and says how much. ``body`` replaces the motion's own, to lend it a
    profile. ``progress`` is called with pictures done and pictures to do.

    The file appears under its name only when it is whole. Raises ``RimrollError`` for an unknown
    suffix or view, for numbers out of range, and for .mp4 where there is no ffmpeg.
    """
    path = Path(path)
    write = _writer(path)
    callback("progress", progress)
    if not 0.0 < fps <= 100.0:
        raise RimrollError(f"fps is {fps:g}; it must be above 0 and at most 100")
    clock = film_clock(motion, speed=speed, seconds=seconds, slow_collision=slow_collision)
    stage = Stage(motion, body or motion.body, clock, fps, view, size)
    with writing(path) as part:
        write(part, stage.shots(progress), stage, fps)
    return path


class Stage:
    """The set of a film: what stands still is painted once, the rest anew for each picture."""

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
        self.count = max(2, round(clock.seconds * fps) + 1)
        film = np.linspace(0.0, clock.seconds, self.count)
        self.t = clock.times(film)
        self.slowdown = clock.slowdown(film)
        self.states = motion.evaluate(self.t)
        # The trail has six points to a picture, so that it bends round the rim without corners.
        fine = clock.times(np.linspace(0.0, clock.seconds, 6 * (self.count - 1) + 1))
        self.trail = scene.contact_path(motion.evaluate(fine), body)
        self.turns = _turns(motion, body)
        self.camera = _camera(view, body, self.states.center)
        self._build(size)

    def _build(self, size: tuple[int, int]) -> None:
        figure = Figure(figsize=(size[0] / DPI, size[1] / DPI), dpi=DPI)
        self.canvas = FigureCanvasAgg(figure)
        (left, right), (low, high) = self._limits(size[0] / size[1])
        self.ax = figure.add_axes((0, 0, 1, 1), xlim=(left, right), ylim=(low, high))
        self.ax.set_axis_off()
        x, y = self.camera.focus[:2]
        scene.draw_table(self.ax, self.camera, center=(x, y), radius=0.62 * (right - left))
        self.canvas.draw()  # type: ignore[no-untyped-call]
        self.still = self.canvas.copy_from_bbox(figure.bbox)  # type: ignore[no-untyped-call]

    def _limits(self, aspect: float) -> tuple[tuple[float, float], tuple[float, float]]:
        """Limits of the picture that hold the body all the time, with room for the captions."""
        shape = scene.Profile.of(self.body).points(16)
        poses = [scene.pose_at(self.states, k) for k in range(self.count)]
        placed = [pose.place(shape, self.body) for pose in poses]
        angle = np.linspace(0.0, 2.0 * np.pi, 24)
        around = 1.8 * self.body.radius * np.stack([np.cos(angle), np.sin(angle), 0 * angle], -1)
        placed += [around + np.append(turn.center, 0.0) for turn in self.turns]
        seen = self.camera.project(np.concatenate(placed))
        low, high = seen.min(axis=0), seen.max(axis=0)
        middle, half = 0.5 * (low + high), 0.5 * (high - low)
        tall = max(1.25 * half[1], 1.08 * half[0] / aspect)
        wide = aspect * tall
        x, y = float(middle[0]), float(middle[1] + 0.08 * tall)
        return (x - wide, x + wide), (y - tall, y + tall)

    def shots(self, progress: Callable[[int, int], object] | None = None) -> Iterator[Image.Image]:
        """All pictures, in order."""
        for k in range(self.count):
            yield self.shoot(k)
            if progress is not None:
                progress(k + 1, self.count)

    def shoot(self, k: int) -> Image.Image:
        """The ``k``-th picture, RGB."""
        artists = sorted(self._artists(k), key=lambda artist: artist.get_zorder())
        words = [artist for artist in artists if isinstance(artist, Annotation)]
        self.canvas.restore_region(self.still)  # type: ignore[no-untyped-call]
        for artist in artists:
            if artist not in words:
                self.ax.draw_artist(artist)
            artist.remove()
        pixels = np.asarray(self.canvas.buffer_rgba())  # type: ignore[no-untyped-call]
        picture = Image.fromarray(pixels).convert("RGB")
        self._write(picture, k, words)
        return picture

    def _artists(self, k: int) -> list[Artist]:
        ax, camera, pose = self.ax, self.camera, scene.pose_at(self.states, k)
        trail = self.trail[: 6 * k + 1]
        artists = scene.draw_trail(ax, camera, trail)
        artists += scene.draw_trail(ax, camera, trail, alpha=0.22, zorder=4.0)
        artists += self._wedge(k)
        artists += scene.draw_body(ax, self.body, pose, camera)
        return artists + scene.draw_contact(ax, self.body, pose, camera)

    def _wedge(self, k: int) -> list[Artist]:
        """The angle turned so far, which stays until the next turn is under way."""
        for turn in reversed(self.turns):
            angle = float(self.states.yaw[k]) - turn.yaw
            if self.t[k] > turn.span.end:
                angle = turn.span.angle
            if self.t[k] > turn.span.start and abs(angle) > WORTH_A_WEDGE:
                size, start = 1.55 * self.body.radius, turn.yaw + np.pi
                return scene.draw_wedge(self.ax, self.camera, turn.center, size, start, angle)
        return []

    def _write(self, picture: Image.Image, k: int, words: list[Annotation]) -> None:
        """Write on a picture, over all else: what matplotlib would, in a fifth of the time."""
        draw = ImageDraw.Draw(picture)
        width, height = picture.size
        for one in words:
            x, y = self.ax.transData.transform(one.xy)
            right, up = (POINT * offset for offset in one.xyann)
            draw.text(
                (float(x) + right, height - float(y) - up),
                one.get_text(),
                scene.INK,
                _font(POINT * float(one.get_fontsize())),
                anchor="mm",
                stroke_width=POINT,
                stroke_fill="white",
            )
        top, font = 0.045 * height, _font(POINT * CAPTION)
        tick = max(1e-12, 1.0 / self.slowdown[k])
        digits = int(np.clip(np.ceil(-np.log10(tick)) + 1, 3, 12))
        left = f"t = {self.t[k]:.{digits}f} s\ntilt {np.degrees(self.states.tilt[k]):.3g}°"
        draw.multiline_text((0.035 * width, top), left, scene.INK, font, anchor="la")
        right_text = slowed(self.slowdown[k])
        draw.text((0.965 * width, top), right_text, scene.INK, font, anchor="ra")


@cache
def _font(pixels: float) -> ImageFont.FreeTypeFont:
    """The font of the figures, at a height in pixels."""
    return ImageFont.truetype(findfont(FontProperties()), pixels)


def slowed(factor: float) -> str:
    """How a film that runs ``factor`` times slower than life says so, in two digits."""
    if not np.isfinite(factor):
        return "time stands still"
    if factor < 0.95:
        return f"sped up {1.0 / factor:.2g}×"
    if factor < 1.05:
        return "real time"
    if factor < 9.5:
        return f"slowed {factor:.2g}×"
    power = 10.0 ** (np.floor(np.log10(factor)) - 1.0)
    return f"slowed {round(factor / power) * power:,.0f}×"


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


Writer = Callable[[Path, Iterable[Image.Image], Stage, float], None]


def _writer(path: Path) -> Writer:
    writers: dict[str, Writer] = {".gif": _write_gif, ".html": _write_page, ".mp4": _write_mp4}
    suffix = path.suffix.lower()
    if suffix not in writers:
        known = ", ".join(writers)
        raise RimrollError(f'a film can be {known}, not "{suffix}" (asked for: {path.name})')
    if suffix == ".mp4" and shutil.which("ffmpeg") is None:
        raise RimrollError("an .mp4 film needs ffmpeg, which was not found; write .gif or .html")
    return writers[suffix]


def _palette(stage: Stage) -> Image.Image:
    """One palette for all pictures, so that colours do not flicker."""
    some = [np.asarray(stage.shoot(k)) for k in np.linspace(0, stage.count - 1, 6).astype(int)]
    palette = Image.fromarray(np.vstack(some)).quantize(256 - 3 * 14)
    # The thin bright lines are too few pixels to win colours of their own: they are given some.
    bright = np.array([to_rgb(c) for c in (scene.VERMILLION, scene.ORANGE, scene.INK)])
    tints = 1.0 - np.linspace(1.0, 0.2, 14)[:, None, None] * (1.0 - bright)
    most = (palette.getpalette() or [])[: 3 * (256 - 3 * 14)]
    palette.putpalette([*most, *np.rint(255.0 * tints).astype(int).ravel().tolist()])
    return palette


def _reduced(shots: Iterable[Image.Image], palette: Image.Image) -> Iterator[Image.Image]:
    for shot in shots:
        yield shot.quantize(palette=palette, dither=Image.Dither.NONE)


def _write_gif(path: Path, shots: Iterable[Image.Image], stage: Stage, fps: float) -> None:
    pictures = _reduced(shots, _palette(stage))
    pause = [round(100.0 / fps) * 10] * (stage.count - 1) + [round(1000.0 * HOLD)]
    first = next(pictures)
    with path.open("wb") as file:
        first.save(file, "GIF", save_all=True, append_images=pictures, duration=pause, loop=0)


def _write_mp4(path: Path, shots: Iterable[Image.Image], stage: Stage, fps: float) -> None:
    width, height = stage.canvas.get_width_height()
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
            # It gave up early; closing may say so again, but the reason is on its error stream.
            with suppress(BrokenPipeError):
                ffmpeg.stdin.close()
        except BaseException:
            ffmpeg.kill()
            raise
        said = ffmpeg.stderr.read().decode(errors="replace").strip()
    if ffmpeg.returncode:
        raise RimrollError(f"ffmpeg could not write the film: {said or 'it gave no reason'}")


def _write_page(path: Path, shots: Iterable[Image.Image], stage: Stage, fps: float) -> None:
    head, tail = PAGE.replace("FPS", f"{fps:g}").split("PICTURES")
    with path.open("w", encoding="utf-8") as page:
        page.write(head)
        for shot in _reduced(shots, _palette(stage)):
            png = io.BytesIO()
            shot.save(png, "PNG")
            page.write(f'"{base64.b64encode(png.getvalue()).decode()}",\n')
        page.write(tail)


PAGE = """<!doctype html>
<html lang="en">
<meta charset="utf-8">
<meta name="viewport" content="width=device-width">
<title>A body on the rim of its base</title>
<style>
  body { font: 16px/1.4 system-ui, sans-serif; max-width: 44rem; margin: 1rem auto }
  img { display: block; width: 100% }
  form { display: flex; gap: .75rem; align-items: center }
  input { flex: 1 }
  button, select { font: inherit; min-width: 5rem }
</style>
<img id="picture" alt="The body rocks and rolls on the rim of its base.">
<form onsubmit="return false">
  <button id="play" type="button">Play</button>
  <input id="place" type="range" min="0" value="0" aria-label="picture">
  <select id="rate" aria-label="speed of the film">
    <option value="0.25">¼×</option><option value="0.5">½×</option>
    <option value="1" selected>1×</option><option value="2">2×</option>
  </select>
</form>
<script>
const pictures = [
PICTURES];
const [picture, play, place, rate] = ["picture", "play", "place", "rate"].map(
  (name) => document.getElementById(name));
let at = 0, last = 0, timer = 0;
place.max = pictures.length - 1;
function show(k) {
  at = k;
  place.value = Math.floor(k);
  picture.src = "data:image/png;base64," + pictures[Math.floor(k)];
}
function step(now) {
  const next = at + (now - last) / 1000 * FPS * rate.value;
  last = now;
  if (next >= pictures.length) { show(pictures.length - 1); pause(); return; }
  show(next);
  timer = requestAnimationFrame(step);
}
function pause() { cancelAnimationFrame(timer); timer = 0; play.textContent = "Play"; }
function run() {
  if (at >= pictures.length - 1) show(0);
  last = performance.now();
  timer = requestAnimationFrame(step);
  play.textContent = "Pause";
}
play.onclick = () => (timer ? pause() : run());
place.oninput = () => { pause(); show(Number(place.value)); };
show(0);
if (!matchMedia("(prefers-reduced-motion: reduce)").matches) run();
</script>
</html>
"""
