"""The camera: from where a picture is taken."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from rimroll.scene.pose import Array, Point


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
