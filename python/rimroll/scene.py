"""What is to be seen of a body of revolution on the rim of its base: shapes, places, colours.

Shapes are given as a camera sees them, in metres in the picture. The body is a mesh of flat facets,
to be painted from far to near, those that face away left out, each as bright as Lambert's law makes
it. What lies on the table (shadow, trail, wedge) comes before the body, which always hides it.
:mod:`rimroll.artists` draws all this in vectors on matplotlib axes, :mod:`rimroll.animation` paints
it in pixels.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache
from itertools import pairwise
from typing import Protocol

import numpy as np
import numpy.typing as npt
from PIL import ImageColor

Array = npt.NDArray[np.float64]
Point = tuple[float, float, float]

# Okabe and Ito's palette: told apart whatever the reader's colour vision.
BLUE, VERMILLION, ORANGE, GREEN, SKY = "#0072B2", "#D55E00", "#E69F00", "#009E73", "#56B4E9"
MARK = -0.5 * np.pi  # rad: where the mark is on the body; it faces who looks from there
INK, METAL, TABLE, SHADOW = "#2b2f33", "#d4d9de", "#e6e8ea", "#1d2733"

# Opacities of a layer of shadow, a wedge, the rim (seen and hidden) and a hidden contact point.
SHADE, WEDGE, RIM, HIDDEN_RIM, HIDDEN_CONTACT = 0.05, 0.28, 0.85, 0.16, 0.65

# Widths of lines and the size of the contact point, points.
RIM_WIDTH, ARC_WIDTH, CONTACT_SIZE, CONTACT_EDGE = 0.9, 1.4, 6.0, 0.8


def rgb(color: str) -> Array:
    """Red, green and blue (3,) of a named colour, from 0 to 1."""
    return np.array(ImageColor.getrgb(color)[:3]) / 255.0


class RoundBody(Protocol):
    """What the renderer asks of a body: radius of the rim and height of the centre of mass, m.

    A body may also carry ``profile``, a :class:`Profile`, when it is not just a can or a disk.
    """

    @property
    def radius(self) -> float: ...
    @property
    def height(self) -> float: ...


class States(Protocol):
    """A motion at n times: tilt, yaw, spin (n,), rad; centre of mass (n, 3), m."""

    @property
    def tilt(self) -> Array: ...
    @property
    def yaw(self) -> Array: ...
    @property
    def spin(self) -> Array: ...
    @property
    def center(self) -> Array: ...


class Event(Protocol):
    """What happened, and when (s); pictures heed ``tilt_min``, ``tilt_max`` and ``on_edge``."""

    @property
    def kind(self) -> str: ...
    @property
    def t(self) -> float: ...


class Motion(Protocol):
    """What the pictures ask of a motion: its samples, its dense output and its events."""

    @property
    def t(self) -> Array: ...
    @property
    def body(self) -> RoundBody: ...
    @property
    def events(self) -> Sequence[Event]: ...
    def evaluate(self, t: Array, /) -> States: ...


@dataclass(frozen=True)
class Pose:
    """Where a body is: tilt, yaw, spin (rad) and its centre of mass (m), z up from the table."""

    tilt: float
    yaw: float
    spin: float
    center: Point

    def axes(self) -> Array:
        """Rows e_x2, e_y1, e_z2: the yaw-tilt frame, in which the contact point is at rest."""
        c, s = np.cos(self.yaw), np.sin(self.yaw)
        e_x1, e_y1, e_z = np.array([[c, s, 0.0], [-s, c, 0.0], [0.0, 0.0, 1.0]])
        e_x2 = np.cos(self.tilt) * e_x1 + np.sin(self.tilt) * e_z
        e_z2 = -np.sin(self.tilt) * e_x1 + np.cos(self.tilt) * e_z
        return np.array([e_x2, e_y1, e_z2])

    def rotation(self) -> Array:
        """Matrix (3, 3) that takes vectors of the body frame to the frame of the table."""
        e_x2, e_y1, e_z2 = self.axes()
        c, s = np.cos(self.spin), np.sin(self.spin)
        return np.column_stack([c * e_x2 + s * e_y1, c * e_y1 - s * e_x2, e_z2])

    def base_center(self, body: RoundBody) -> Array:
        """Centre of the base disk, (3,), m."""
        return np.asarray(self.center - body.height * self.axes()[2])

    def contact(self, body: RoundBody) -> Array:
        """The rim's lowest point, (3,), m: it lies at azimuth yaw + pi from the base's centre."""
        return np.asarray(self.base_center(body) - body.radius * self.axes()[0])

    def place(self, points: Array, body: RoundBody) -> Array:
        """Points (..., 3) of the body, from the centre of its base, to the frame of the table."""
        return np.asarray(points @ self.rotation().T + self.base_center(body))


def pose_at(states: States, k: int) -> Pose:
    """The ``k``-th pose of a motion's states."""
    x, y, z = (float(c) for c in states.center[k])
    return Pose(float(states.tilt[k]), float(states.yaw[k]), float(states.spin[k]), (x, y, z))


def contact_path(states: States, body: RoundBody) -> Array:
    """The contact point on the table, (n, 2), m: behind G by R cos(tilt) - H sin(tilt)."""
    out = body.radius * np.cos(states.tilt) - body.height * np.sin(states.tilt)
    way = np.stack([np.cos(states.yaw), np.sin(states.yaw)], axis=-1)
    return np.asarray(states.center[:, :2] - out[:, None] * way)


@dataclass(frozen=True)
class Camera:
    """Where the picture is taken from: azimuth and elevation (rad) of the eye, seen from ``focus``.

    ``distance`` (m) is the eye's distance from the focus; infinity makes the view orthographic.
    Lengths at the focus are drawn true.
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
        """From straight above; a viewer standing at ``azimuth`` sees away from him as up."""
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


@dataclass(frozen=True)
class Profile:
    """Outline of a body of revolution: points (r, z), m, from the base's rim up to the top.

    z is counted from the base. ``label`` is the range of z that wears the label's colour.
    """

    outline: tuple[tuple[float, float], ...]
    label: tuple[float, float]

    @classmethod
    def can(cls, radius: float, length: float) -> Profile:
        """A can: straight wall, a slight neck, a rim and a sunk lid."""
        r, bead, top = radius, 0.1 * min(radius, length), length
        outline = (
            (r, 0.0),
            (r, top - 2.0 * bead),
            (r - 0.8 * bead, top - 0.7 * bead),
            (r - 0.8 * bead, top),
            (r - 1.3 * bead, top),
            (r - 1.4 * bead, top - 0.8 * bead),
        )
        return cls(outline, (0.9 * bead, top - 2.0 * bead))

    @classmethod
    def disk(cls, radius: float, thickness: float = 0.0) -> Profile:
        """A disk, drawn at least 0.04 radii thick."""
        top = max(thickness, 0.04 * radius)
        return cls(((radius, 0.0), (radius, top), (0.9 * radius, top)), (top, top))

    @classmethod
    def of(cls, body: RoundBody) -> Profile:
        """The body's own profile; else a can, or a disk if flat, twice as long as G is high."""
        own: Profile | None = getattr(body, "profile", None)
        if own is not None:
            return own
        length = 2.0 * body.height
        flat = length < 0.4 * body.radius
        return cls.disk(body.radius, length) if flat else cls.can(body.radius, length)

    def points(self, count: int = 48) -> Array:
        """Points (n, 3) of the surface, m, from the base's centre: enough for hulls and limits."""
        angle = np.linspace(0.0, 2.0 * np.pi, count, endpoint=False)
        r, z = np.array(self.outline).T[:, :, None]
        x, y, z = np.broadcast_arrays(r * np.cos(angle), r * np.sin(angle), z)
        return np.stack([x, y, z], axis=-1).reshape(-1, 3)


@dataclass(frozen=True, eq=False)
class Mesh:
    """Facets in the body frame: corners (n, 4, 3), outward normals (n, 3), colours (n, 3)."""

    corners: Array
    normals: Array
    colors: Array


@lru_cache(maxsize=32)
def mesh(profile: Profile, count: int = 80) -> Mesh:
    """The profile revolved in ``count`` sectors, with base and lid closed."""
    r, z = _closed_outline(profile)
    angle = np.linspace(0.0, 2.0 * np.pi, count + 1)
    ring = np.stack([np.cos(angle), np.sin(angle), np.zeros_like(angle)], axis=-1)
    grid = r[:, None, None] * ring + z[:, None, None] * np.array([0.0, 0.0, 1.0])
    corners = np.stack([grid[:-1, :-1], grid[:-1, 1:], grid[1:, 1:], grid[1:, :-1]], axis=2)
    middle = 0.5 * (angle[1:] + angle[:-1])
    outward, upward = np.diff(z), -np.diff(r)
    size = np.hypot(outward, upward)
    normals = np.empty((len(r) - 1, count, 3))
    normals[..., 0] = (outward / size)[:, None] * np.cos(middle)
    normals[..., 1] = (outward / size)[:, None] * np.sin(middle)
    normals[..., 2] = (upward / size)[:, None]
    colors = _colors(profile, r, z, middle)
    return Mesh(corners.reshape(-1, 4, 3), normals.reshape(-1, 3), colors.reshape(-1, 3))


def _closed_outline(profile: Profile) -> tuple[Array, Array]:
    """r and z of the outline from axis to axis, with a point at each edge of the label."""
    points = [(0.0, profile.outline[0][1]), *profile.outline, (0.0, profile.outline[-1][1])]
    out = [points[0]]
    for (r0, z0), (r1, z1) in pairwise(points):
        cuts = [z for z in profile.label if z0 < z < z1]
        out += [(r0 + (r1 - r0) * (z - z0) / (z1 - z0), z) for z in cuts]
        if (r1, z1) != out[-1]:
            out.append((r1, z1))
    r, z = np.array(out).T
    return r, z


def _colors(profile: Profile, r: Array, z: Array, angle: Array) -> Array:
    """Colours (rows, sectors, 3): metal, the label, and the marks that make the spin visible."""
    low, high = profile.label
    tolerance = 1e-9 * r.max()
    worn = (z[:-1] >= low - tolerance) & (z[1:] <= high + tolerance)
    colors = np.where(worn[:, None, None], rgb(GREEN), rgb(METAL)) * np.ones((angle.size, 1))
    away = np.abs((angle - MARK + np.pi) % (2.0 * np.pi) - np.pi)
    wall = worn & (np.diff(z) > 0.0)
    colors[np.ix_(wall, away < np.radians(14.0))] = rgb("white")
    lid = np.diff(z) == 0.0
    lid[0] = False
    colors[np.ix_(lid & (r[1:] == 0.0), away < np.radians(14.0))] = rgb(GREEN)
    if not wall.any():
        colors[np.ix_(lid, away < np.radians(14.0))] = rgb("white")
    return colors


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
    """Lambert's law for a lamp and an even sky, with the gleam of a low window."""
    lambert = np.clip(normals @ lamp, 0.0, None)
    sky = 0.6 + 0.06 * normals[:, 2]
    half = window + sight
    half = half / np.linalg.norm(half, axis=-1, keepdims=True)
    gleam = 0.2 * np.clip(np.einsum("ij,ij->i", normals, half), 0.0, None) ** 28
    return np.asarray(np.clip(colors * (sky + 0.5 * lambert)[:, None] + gleam[:, None], 0.0, 1.0))


def shadow_layers(body: RoundBody, pose: Pose, camera: Camera, profile: Profile) -> Array:
    """Outlines (8, n, 2) of the shadow on the table, one inside the other.

    Painted over one another they make a shadow that is softer the higher the part that casts it.
    """
    points = pose.place(profile.points(), body)
    angle = np.linspace(0.0, 2.0 * np.pi, 72, endpoint=False)
    ways = np.stack([np.cos(angle), np.sin(angle)], axis=-1)
    z = np.clip(points[:, 2:], 0.0, None)
    # The hull by its support function; a part at height z casts a half-shade of width z.
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


def rim_stretches(body: RoundBody, pose: Pose, camera: Camera) -> list[tuple[Array, bool]]:
    """The rim of the base as lines (n, 2), and whether each is seen or behind the body."""
    angle = np.linspace(0.0, 2.0 * np.pi, 121)
    way = np.stack([np.cos(angle), np.sin(angle), np.zeros_like(angle)], axis=-1)
    ring = pose.place(body.radius * way, body)
    seen = rim_seen(way @ pose.rotation().T, ring, pose, camera)
    flat = camera.project(ring)
    firm = seen[1:] & seen[:-1]
    # Each stretch is one line, so that a faint one has no dark joints.
    ends = [0, *(np.flatnonzero(firm[1:] != firm[:-1]) + 1).tolist(), len(firm)]
    return [(flat[start : end + 1], bool(firm[start])) for start, end in pairwise(ends)]


def rim_seen(
    outward: Array, ring: Array, pose: Pose, camera: Camera, limb: float = 0.0
) -> npt.NDArray[np.bool_]:
    """Whether the eye sees points ``ring`` (n, 3) of the rim, where the wall faces ``outward``.

    Points count as seen as far as ``limb`` (sine of an angle) behind the body's edge.
    """
    sight = camera.sight(ring)
    wall = np.einsum("ij,ij->i", outward, sight)
    return np.asarray((wall > -1e-9 - limb) | (sight @ -pose.axes()[2] > 0.0))


def contact_seen(body: RoundBody, pose: Pose, camera: Camera) -> bool:
    """Whether the eye sees the contact point, or the body hides it."""
    spot = pose.contact(body)[None]
    return bool(rim_seen(-pose.axes()[:1], spot, pose, camera, limb=0.25)[0])


def table_rings(camera: Camera, center: tuple[float, float], radius: float) -> tuple[Array, Array]:
    """The table, a round patch of ``radius`` (m) that fades out toward its edge.

    Given as outlines (n, c, 2) and colours (n, 3), the largest first, each over the one before.
    """
    share = np.linspace(1.0, 0.35, 14)
    rings = np.array([_circle(center, radius * k) for k in share])
    tone = np.linspace(0.06, 1.0, share.size)[:, None] ** 0.8
    return camera.project(on_table(rings)), 1.0 - tone * (1.0 - rgb(TABLE))


@dataclass(frozen=True, eq=False)
class Wedge:
    """An angle on the table: its area (n, 2), its arc (n, 2), and what to write where."""

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
    ``label_at`` radii. More than a full turn goes on in a spiral.
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
    """How far (right, up) of its spot the middle of a wedge's text lies at most, points."""
    return 1.9 * fontsize, 0.9 * fontsize


def _around(center: Sequence[float] | Array, radius: Array, azimuth: Array | float) -> Array:
    way = np.stack([np.cos(azimuth), np.sin(azimuth)], axis=-1)
    return np.asarray(np.asarray(center)[:2] + radius[..., None] * way)


def _circle(center: tuple[float, float], radius: float) -> Array:
    angle = np.linspace(0.0, 2.0 * np.pi, 120, endpoint=False)
    return np.asarray(center) + radius * np.stack([np.cos(angle), np.sin(angle)], axis=-1)


def on_table(points: Array) -> Array:
    """Points (..., 2) of the table as points (..., 3) of space."""
    return np.concatenate([points, np.zeros((*points.shape[:-1], 1))], axis=-1)
