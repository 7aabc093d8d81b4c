"""What lies on the table: the table itself, shadows, and angles."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from rimroll.scene.camera import Camera
from rimroll.scene.palette import TABLE, rgb
from rimroll.scene.pose import Array, Pose, RoundBody
from rimroll.scene.shape import Profile


def table_rings(camera: Camera, center: tuple[float, float], radius: float) -> tuple[Array, Array]:
    """The table, a round patch of ``radius`` (m) that fades out toward its edge.

    It consists of outlines (n, c, 2) and colours (n, 3), the largest first, each over the previous.
    """
    share = np.linspace(1.0, 0.35, 14)
    rings = np.array([_circle(center, radius * k) for k in share])
    tone = np.linspace(0.06, 1.0, share.size)[:, None] ** 0.8
    return camera.project(on_table(rings)), 1.0 - tone * (1.0 - rgb(TABLE))


def shadow_layers(body: RoundBody, pose: Pose, camera: Camera, profile: Profile) -> Array:
    """Outlines (8, n, 2) of the shadow on the table, one inside the other.

    Together they make a shadow that is softer under higher parts of the body.
    """
    points = pose.place(profile.points(), body)
    angle = np.linspace(0.0, 2.0 * np.pi, 72, endpoint=False)
    ways = np.stack([np.cos(angle), np.sin(angle)], axis=-1)
    z = np.clip(points[:, 2:], 0.0, None)
    # The hull by its support function; a part at height z has a penumbra of width z.
    cast = cast_shadow(points, camera)
    support = cast @ ways.T
    layers = []
    for blur in np.linspace(0.14, -0.1, 8):
        last = np.argmax(support + blur * z, axis=0)
        layers.append(cast[last] + blur * z[last] * ways)
    return camera.project(on_table(np.array(layers)))


def cast_shadow(points: Array, camera: Camera) -> Array:
    """Where on the table, (n, 2), the shadows of points (n, 3) fall, m."""
    light = camera.light()
    return np.asarray(points[:, :2] - np.clip(points[:, 2:], 0.0, None) * light[:2] / light[2])


@dataclass(frozen=True, eq=False)
class Wedge:
    """An angle on the table: its area (n, 2), its arc (n, 2), its label and the label's place."""

    sector: Array
    arc: Array
    text: str
    spot: Array
    """Where the text belongs, (2,), m on the table; it is written beside it, toward ``azimuth``."""
    azimuth: float


def wedge(
    camera: Camera,
    center: Sequence[float] | Array,
    radius: float,
    start: float,
    turn: float,
    label_at: float = 1.0,
) -> Wedge:
    """An angle from azimuth ``start`` through ``turn`` (rad, signed).

    ``center`` is (x, y), ``radius`` in m. The angle in degrees is written outside the circle of
    ``label_at`` radii. Beyond a full turn the arc is a spiral.
    """
    swept = np.linspace(0.0, turn, 2 + int(abs(turn) * 30.0))
    spiral = radius * (1.0 + 0.12 * np.clip(np.abs(swept) - 2.0 * np.pi + 0.5, 0.0, None))
    arc = _around(center, spiral, start + swept)
    sector = start + np.clip(swept, -2.0 * np.pi, 2.0 * np.pi)
    inside = np.vstack([np.asarray(center)[None, :2], _around(center, np.array(radius), sector)])
    middle = float(start + np.sign(turn) * min(0.5 * abs(turn), 0.5 * np.pi))
    return Wedge(
        camera.project(on_table(inside)),
        camera.project(on_table(arc)),
        f"{abs(np.degrees(turn)):.1f}°",
        _around(center, np.array(label_at * radius), middle),
        middle,
    )


def way_in_picture(camera: Camera, azimuth: float) -> Array:
    """The direction (2,), of length 1, that an azimuth on the table has in the picture."""
    way = camera.axes()[:2] @ np.array([np.cos(azimuth), np.sin(azimuth), 0.0])
    return np.asarray(way / max(float(np.hypot(*way)), 1e-9))


def label_offset(fontsize: float) -> tuple[float, float]:
    """The largest distance (right, up) of the middle of a wedge's text from its spot, points."""
    return 1.9 * fontsize, 0.9 * fontsize


def on_table(points: Array) -> Array:
    """Points (..., 2) of the table as points (..., 3) of space."""
    return np.concatenate([points, np.zeros((*points.shape[:-1], 1))], axis=-1)


def _around(center: Sequence[float] | Array, radius: Array, azimuth: Array | float) -> Array:
    way = np.stack([np.cos(azimuth), np.sin(azimuth)], axis=-1)
    return np.asarray(np.asarray(center)[:2] + radius[..., None] * way)


def _circle(center: tuple[float, float], radius: float) -> Array:
    angle = np.linspace(0.0, 2.0 * np.pi, 120, endpoint=False)
    return np.asarray(center) + radius * np.stack([np.cos(angle), np.sin(angle)], axis=-1)
