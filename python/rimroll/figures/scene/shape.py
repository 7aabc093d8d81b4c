"""The shape of a body of revolution, a mesh of flat facets, and the colours of pictures."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from itertools import pairwise

import numpy as np
from PIL import ImageColor

from rimroll.figures.scene.pose import Array, RoundBody


@dataclass(frozen=True)
class Profile:
    """Outline of a body of revolution: points (r, z), m, from the base's rim up to the top.

    z is counted from the base. ``label`` is the range of z that has the label's colour. With
    ``corners`` the cross-sections are regular polygons, and r is that of the corners.
    """

    outline: tuple[tuple[float, float], ...]
    label: tuple[float, float]
    corners: int = 0

    @property
    def first(self) -> float:
        """The material azimuth of the first corner, rad."""
        return np.pi if self.corners else 0.0

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
    def prism(cls, corners: int, radius: float, length: float) -> Profile:
        """A prism, drawn at least 0.04 radii long."""
        top = max(length, 0.04 * radius)
        return cls(((radius, 0.0), (radius, top)), (0.0, top), corners)

    @classmethod
    def of(cls, body: RoundBody) -> Profile:
        """The body's own profile; else a can, or a disk if flat, twice as long as the height of
        G."""
        own: Profile | None = getattr(body, "profile", None)
        if own is not None:
            return own
        length = 2.0 * body.height
        corners = getattr(body, "corners", 0)
        if corners:
            return cls.prism(corners, body.radius, length)
        flat = length < 0.4 * body.radius
        return cls.disk(body.radius, length) if flat else cls.can(body.radius, length)

    def points(self, count: int = 48) -> Array:
        """Points (n, 3) of the surface, m, from the base's centre: enough for hulls and limits."""
        angle = np.linspace(0.0, 2.0 * np.pi, self.corners or count, endpoint=False) + self.first
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
    count = profile.corners or count
    angle = np.linspace(0.0, 2.0 * np.pi, count + 1) + profile.first
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
    # One side is marked, if sides are wide.
    mark = MARK + (0.01 if profile.corners else 0.0)
    away = np.abs((angle - mark + np.pi) % (2.0 * np.pi) - np.pi)
    width = max(np.radians(14.0), away.min() + 1e-9)
    wall = worn & (np.diff(z) > 0.0)
    colors[np.ix_(wall, away < width)] = rgb("white")
    lid = np.diff(z) == 0.0
    lid[0] = False
    colors[np.ix_(lid & (r[1:] == 0.0), away < width)] = rgb(GREEN)
    if not wall.any():
        colors[np.ix_(lid, away < width)] = rgb("white")
    return colors


# Okabe and Ito's palette, distinguishable with any colour vision.
BLUE, VERMILLION, ORANGE, GREEN = "#0072B2", "#D55E00", "#E69F00", "#009E73"
MARK = -0.5 * np.pi  # rad: azimuth of the mark on the body
INK, METAL, TABLE, SHADOW = "#2b2f33", "#d4d9de", "#e6e8ea", "#1d2733"

# Opacities of a layer of shadow, a wedge, the rim (seen and hidden) and a hidden contact point.
SHADE, WEDGE, RIM, HIDDEN_RIM, HIDDEN_CONTACT = 0.05, 0.28, 0.85, 0.16, 0.65

# Widths of lines and the size of the contact point, points.
RIM_WIDTH, ARC_WIDTH, CONTACT_SIZE, CONTACT_EDGE = 0.9, 1.4, 6.0, 0.8


def rgb(color: str) -> Array:
    """Red, green and blue (3,) of a named colour, from 0 to 1."""
    return np.array(ImageColor.getrgb(color)[:3]) / 255.0
