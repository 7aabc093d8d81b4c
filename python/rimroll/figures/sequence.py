"""The paper's second figure: a container released, falling, rocking up elsewhere, step by step."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch

from rimroll.figures import artists, scene
from rimroll.figures.scene import Array, Camera, Motion, Pose, RoundBody
from rimroll.figures.scene.pose import Span, turn_span

NAMES = ("a", "b", "b′", "c", "d", "e")
HEAD, FOOT = 0.46, 0.34  # inches for the captions above and the legend below


def falling_times(motion: Motion, span: Span) -> Array:
    """The six instants of a turn that the figure shows, (6,), s.

    a: start of the turn; b and b′: nearly upright, before and after the contact point's run; c, d
    and e: tipping up again, to the end of the turn.
    """
    fall = np.linspace(span.start, span.near, 400)
    rise = np.linspace(span.near, span.end, 400)
    falling, rising = (_from_a_face(motion.evaluate(t).tilt) for t in (fall, rise))
    upright = rising[0] + 0.08 * (falling[0] - rising[0])
    up = rising[0] + np.array([0.36, 0.68]) * (rising[-1] - rising[0])
    before = np.interp(upright, falling[::-1], fall[::-1])
    after = np.interp([upright, *up], rising, rise)
    return np.array([span.start, before, *after, span.end])


def _from_a_face(tilt: Array) -> Array:
    """The tilt from the nearer face: a disk may lie on either."""
    return np.minimum(tilt, np.pi - tilt)


@dataclass(frozen=True)
class _Marks:
    """What is marked on the table: O under the upright body, azimuths of A and B, turn (rad)."""

    center: Array
    first: float
    turn: float

    def spot(self, azimuth: float, radius: float) -> Array:
        return np.asarray(self.center + radius * np.array([np.cos(azimuth), np.sin(azimuth)]))


def falling_figure(
    motion: Motion, *, turn: int = 0, body: RoundBody | None = None, width: float = 7.2
) -> Figure:
    """Draw six instants of a turn, from the side (top row) and from above (bottom row).

    A is where the base first touched the table, B where it touches afterwards, O the centre of the
    base when it is nearly flat on the table; the wedge A-O-B is the angle of turn. An open circle
    marks the point opposite A, where a symmetric fall would have brought B. ``body`` replaces the
    motion's own (to give it a profile); ``width`` is in inches. Returns a vector figure.

    Raises ``RimrollError`` if the motion has no turn numbered ``turn``.
    """
    body = body or motion.body
    span = turn_span(motion, turn)
    times = falling_times(motion, span)
    states = motion.evaluate(np.append(times, span.near))
    poses = [scene.pose_at(states, k) for k in range(len(times))]
    upright = scene.pose_at(states, len(times))
    first = poses[0].yaw + np.pi
    marks = _Marks(upright.base_center(body)[:2], first, span.angle)
    focus = (float(marks.center[0]), float(marks.center[1]), 0.0)
    azimuth = poses[0].yaw - 0.5 * np.pi
    side, top = Camera.side(azimuth, focus), Camera.top(azimuth, focus)
    figure, rows = _layout(body, poses, (side, top), width)
    for k, (pose, time) in enumerate(zip(poses, times, strict=True)):
        _draw_side(rows[0][k], body, pose, side, marks, after=k >= 2)
        _draw_top(rows[1][k], body, pose, top, marks, after=k >= 2)
        caption = f"$t$ = {time:.3f} s\n$\\varphi$ = {np.degrees(pose.tilt):.1f}°"
        rows[0][k].set_title(f"({NAMES[k]})", fontsize=9, fontweight="bold", pad=21)
        rows[0][k].text(
            0.5, 1.0, caption, transform=rows[0][k].transAxes, ha="center", va="bottom", size=7
        )
    _legend(figure, marks)
    return figure


def _layout(
    body: RoundBody, poses: list[Pose], cameras: tuple[Camera, Camera], width: float
) -> tuple[Figure, list[list[Axes]]]:
    """A figure with two rows of frameless axes, all to one scale."""
    shape = scene.Profile.of(body).points()
    placed = np.concatenate([pose.place(shape, body) for pose in poses])
    shade = np.column_stack([scene.cast_shadow(placed, cameras[0]), np.zeros(len(placed))])
    reach, gap = 1.6 * body.radius, 0.12 * body.radius
    corners = []
    for camera, things, down, up in (
        (cameras[0], np.vstack([placed, shade]), 0.4 * body.radius, 0.0),
        (cameras[1], placed, reach, reach),
    ):
        flat = camera.project(things)
        low = np.minimum(flat.min(axis=0), (-reach, -down)) - gap
        corners.append((low, np.maximum(flat.max(axis=0), (reach, up)) + gap))
    left = min(low[0] for low, _ in corners)
    right = max(high[0] for _, high in corners)
    inch = width / len(poses) / (right - left)
    tall = [inch * float(high[1] - low[1]) for low, high in corners]
    height = HEAD + sum(tall) + FOOT
    figure = Figure(figsize=(width, height))
    FigureCanvasAgg(figure)
    rows = []
    for (low, high), bottom, size in zip(corners, (FOOT + tall[1], FOOT), tall, strict=True):
        row = []
        for k in range(len(poses)):
            box = (k / len(poses), bottom / height, 1.0 / len(poses), size / height)
            ax = figure.add_axes(box, xlim=(left, right), ylim=(low[1], high[1]))
            ax.set_axis_off()
            row.append(ax)
        rows.append(row)
    return figure, rows


def _draw_side(
    ax: Axes, body: RoundBody, pose: Pose, camera: Camera, marks: _Marks, *, after: bool
) -> None:
    x, y = (float(c) for c in marks.center)
    artists.draw_table(ax, camera, center=(x, y), radius=2.1 * body.radius)
    artists.draw_body(ax, body, pose, camera)
    color = scene.VERMILLION if after else scene.BLUE
    artists.draw_contact(ax, body, pose, camera, color=color)


def _draw_top(
    ax: Axes, body: RoundBody, pose: Pose, camera: Camera, marks: _Marks, *, after: bool
) -> None:
    radius, last = body.radius, marks.first + marks.turn
    artists.draw_body(ax, body, pose, camera, fade=0.72, shadow=False)
    around = marks.first + np.linspace(0.0, 2.0 * np.pi, 90)
    footprint = np.array([marks.spot(a, radius) for a in around])
    _line(ax, camera, footprint, color=scene.INK, lw=0.6, ls=(0, (3, 2)))
    first = marks.spot(marks.first, radius)
    _line(ax, camera, np.array([first, marks.center]), color=scene.INK, lw=0.9)
    artists.draw_point(ax, camera, first, color=scene.BLUE, size=5.0)
    _letter(ax, camera, "A", first, marks.first, scene.BLUE)
    if after:
        wedge = (marks.center, 0.55 * radius, marks.first, marks.turn)
        artists.draw_wedge(ax, camera, *wedge, label_at=1.0 / 0.55, fontsize=7.0, zorder=4.0)
        second, opposite = marks.spot(last, radius), marks.spot(marks.first + np.pi, radius)
        _line(ax, camera, np.array([marks.center, second]), color=scene.INK, lw=0.9)
        _line(ax, camera, np.array([marks.center, opposite]), color=scene.INK, lw=0.6, ls=":")
        _ring(ax, camera, opposite)
        artists.draw_point(ax, camera, second, color=scene.VERMILLION, size=5.0)
        _letter(ax, camera, "B", second, last, scene.VERMILLION)
    artists.draw_point(ax, camera, pose.contact(body)[:2], color=scene.INK, size=2.2, zorder=5.5)
    artists.draw_point(ax, camera, marks.center, color=scene.INK, size=3.0, zorder=4.6)
    _letter(ax, camera, "O", marks.center, marks.first - np.copysign(1.75, marks.turn), scene.INK)


def _line(ax: Axes, camera: Camera, path: Array, **style: Any) -> None:
    x, y = camera.project(np.column_stack([path, np.zeros(len(path))])).T
    ax.plot(x, y, zorder=4.5, **style)


def _ring(ax: Axes, camera: Camera, spot: Array) -> None:
    x, y = camera.project(np.array([*spot, 0.0]))
    ax.plot(x, y, "o", mfc="white", mec=scene.INK, mew=0.8, ms=4.0, zorder=4.8)


def _letter(ax: Axes, camera: Camera, letter: str, spot: Array, azimuth: float, color: str) -> None:
    style = {"color": color, "size": 7, "weight": "bold"}
    artists.write_beside(ax, camera, letter, spot, azimuth, far=(7.0, 7.0), **style)


def _legend(figure: Figure, marks: _Marks) -> None:
    dot: dict[str, Any] = {"marker": "o", "ls": "none", "mec": "white", "ms": 6.0}
    ring: dict[str, Any] = {"marker": "o", "ls": "none", "mec": scene.INK, "ms": 4.5}
    turn = f"angle of turn AOB = {abs(np.degrees(marks.turn)):.1f}°"
    handles = [
        Line2D([], [], color=scene.BLUE, label="A: contact before", **dot),
        Line2D([], [], color=scene.VERMILLION, label="B: contact after", **dot),
        Line2D([], [], mfc="white", label="opposite A", **ring),
        Patch(facecolor=scene.ORANGE, alpha=0.5, label=turn),
    ]
    figure.legend(handles=handles, loc="lower center", ncols=4, frameon=False, fontsize=7.5)
