"""What a camera sees: the parts of a body, the table with shadows and angles."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
import numpy.typing as npt

from rimroll.figures.scene.pose import Array, Point, Pose, RoundBody, corner_ways
from rimroll.figures.scene.shape import TABLE, Profile, mesh, rgb


@dataclass(frozen=True)
class Camera:
    """Where the picture is taken from: azimuth and elevation (rad) of the eye, seen from ``focus``.

    ``distance`` (m) is the eye's distance from the focus; infinity makes the view orthographic.
    Lengths at the focus are drawn to scale.
    """

    azimuth: float = -np.pi / 2
    elevation: float = 0.0
    distance: float = np.inf
    focus: Point = (0.0, 0.0, 0.0)

    @classmethod
    def side(cls, azimuth: float = -np.pi / 2, focus: Point = (0.0, 0.0, 0.0)) -> Camera:
        """From the side, orthographic, raised by 7 degrees so that the table has a surface."""
        return cls(azimuth, np.radians(7.0), np.inf, focus)

    @classmethod
    def top(cls, azimuth: float = -np.pi / 2, focus: Point = (0.0, 0.0, 0.0)) -> Camera:
        """From straight above; the direction away from a viewer at ``azimuth`` is up in the
        picture."""
        return cls(azimuth, np.pi / 2, np.inf, focus)

    @classmethod
    def perspective(
        cls,
        azimuth: float = np.radians(-65.0),
        elevation: float = np.radians(28.0),
        distance: float = np.inf,
        focus: Point = (0.0, 0.0, 0.0),
    ) -> Camera:
        """From above the table's edge, in perspective if ``distance`` is finite."""
        return cls(azimuth, elevation, distance, focus)

    def axes(self) -> Array:
        """Rows: right and up in the picture, and the direction toward the eye."""
        ca, sa = np.cos(self.azimuth), np.sin(self.azimuth)
        ce, se = np.cos(self.elevation), np.sin(self.elevation)
        return np.array([[-sa, ca, 0.0], [-se * ca, -se * sa, ce], [ce * ca, ce * sa, se]])

    def project(self, points: npt.ArrayLike) -> Array:
        """Points (..., 3) to picture coordinates (..., 2), m at the distance of the focus."""
        seen = (np.asarray(points, float) - self.focus) @ self.axes().T
        return np.asarray(seen[..., :2] / (1.0 - seen[..., 2:] / self.distance))

    def depth(self, points: npt.ArrayLike) -> Array:
        """How near points (..., 3) are: their distance from the focus toward the eye, (...), m."""
        return np.asarray((np.asarray(points, float) - self.focus) @ self.axes()[2])

    def sight(self, points: Array) -> Array:
        """Unit vectors from points (..., 3) to the eye."""
        toward = self.axes()[2]
        if np.isinf(self.distance):
            return np.broadcast_to(toward, points.shape)
        rays = self.focus + self.distance * toward - points
        return np.asarray(rays / np.linalg.norm(rays, axis=-1, keepdims=True))

    def light(self, elevation: float = np.radians(65.0)) -> Array:
        """Unit vector to the lamp: high, over the viewer's left shoulder."""
        azimuth, flat = self.azimuth - np.radians(48.0), np.cos(elevation)
        return np.array([flat * np.cos(azimuth), flat * np.sin(azimuth), np.sin(elevation)])


def visible_facets(
    body: RoundBody, pose: Pose, camera: Camera, profile: Profile
) -> tuple[Array, Array]:
    """Facets that face the eye, far to near: polygons (n, 4, 2) in the picture, colours (n, 3)."""
    shape = mesh(profile)
    corners = pose.place(shape.corners, body)
    normals = shape.normals @ pose.rotation().T
    middle = corners.mean(axis=1)
    sight = camera.sight(middle)
    seen = np.flatnonzero(np.einsum("ij,ij->i", normals, sight) > 0.0)
    seen = seen[np.argsort(camera.depth(middle[seen]), kind="stable")]
    lamps = camera.light(), camera.light(np.radians(20.0))
    colors = _lit(shape.colors[seen], normals[seen], sight[seen], *lamps)
    return camera.project(corners[seen]), colors


def _lit(colors: Array, normals: Array, sight: Array, lamp: Array, window: Array) -> Array:
    """Lambert's law for a lamp and a uniform sky, with the reflection of a low window."""
    lambert = np.clip(normals @ lamp, 0.0, None)
    sky = 0.6 + 0.06 * normals[:, 2]
    half = window + sight
    half = half / np.linalg.norm(half, axis=-1, keepdims=True)
    gleam = 0.2 * np.clip(np.einsum("ij,ij->i", normals, half), 0.0, None) ** 28
    return np.asarray(np.clip(colors * (sky + 0.5 * lambert)[:, None] + gleam[:, None], 0.0, 1.0))


def rim_stretches(body: RoundBody, pose: Pose, camera: Camera) -> list[tuple[Array, bool]]:
    """The rim of the base as lines (n, 2), and whether each is seen or behind the body."""
    points, outward = _rim(body)
    ring = pose.place(points, body)
    seen = rim_seen(outward @ pose.rotation().T, ring, pose, camera)
    flat = camera.project(ring)
    firm = seen[1:] & seen[:-1]
    # Each stretch is one line, so that a faint one has no dark joints.
    ends = [0, *(np.flatnonzero(firm[1:] != firm[:-1]) + 1).tolist(), len(firm)]
    return [(flat[start : end + 1], bool(firm[start])) for start, end in pairwise(ends)]


def _rim(body: RoundBody) -> tuple[Array, Array]:
    """Points (n, 3) once round the rim, from the base's centre, m, and outward unit vectors."""
    corners = corner_ways(body)
    if corners is None:
        angle = np.linspace(0.0, 2.0 * np.pi, 121)
        way = np.stack([np.cos(angle), np.sin(angle), np.zeros_like(angle)], axis=-1)
        return body.radius * way, way
    share = np.linspace(0.0, 1.0, 12)[:, None]
    ends = list(zip(corners, np.roll(corners, -1, axis=0), strict=True))
    points = np.concatenate([(1.0 - share) * one + share * other for one, other in ends])
    middles = np.array([one + other for one, other in ends])
    outward = middles / np.linalg.norm(middles, axis=1, keepdims=True)
    return body.radius * points, np.repeat(outward, len(share), axis=0)


def rim_seen(
    outward: Array, ring: Array, pose: Pose, camera: Camera, limb: float = 0.0
) -> npt.NDArray[np.bool_]:
    """Whether the camera sees points ``ring`` (n, 3) of the rim, where the wall faces ``outward``.

    Points count as seen as far as ``limb`` (sine of an angle) behind the body's edge.
    """
    sight = camera.sight(ring)
    wall = np.einsum("ij,ij->i", outward, sight)
    return np.asarray((wall > -1e-9 - limb) | (sight @ -pose.axes()[2] > 0.0))


def contact_seen(body: RoundBody, pose: Pose, camera: Camera) -> bool:
    """Whether the camera sees the contact point; else the body hides it."""
    spot = pose.contact(body)[None]
    outward = (spot - pose.base_center(body)) / body.radius
    return bool(rim_seen(outward, spot, pose, camera, limb=0.25)[0])


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
