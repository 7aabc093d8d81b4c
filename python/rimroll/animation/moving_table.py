"""A table that moves: where it is, and its plate with a grid, as a camera sees them."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from rimroll import scene
from rimroll.ground.ground import Ground
from rimroll.scene import Array, Camera, RoundBody

FAR = 4.0
"""The eye moves with a table that moves by more than this many sizes (R + H) of the body."""

LINES = 3
"""The plate has about this many lines of its grid from its middle to its edge."""

THICKNESS = 0.07
"""The thickness of the plate, as a fraction of half its length."""

FRONT, LINE = "#c3c8cc", "#b4babf"
"""The colours of the plate's sides and of its grid."""


@dataclass(frozen=True, eq=False)
class MovingTable:
    """A square plate that a table carries, and its displacement at the pictures of a film.

    Attributes
    ----------
    middle
        The plate's middle (2,), m on the table.
    half
        Half of its length, m.
    moved
        The table's displacement since t = 0 (n, 3), m, as it is shown.
    farthest
        The largest displacement, m.
    """

    middle: Array
    half: float
    moved: Array
    farthest: float

    @classmethod
    def under(cls, body: RoundBody, contacts: Array, ground: Ground, t: Array) -> MovingTable:
        """The plate for contact points (m, 2) on the table, at times (n,).

        A table that moves too far for a picture is shown as seen from itself.
        """
        middle = 0.5 * (contacts.min(axis=0) + contacts.max(axis=0))
        path = float(np.abs(contacts - middle).max())
        moved = ground.displacement(t)
        farthest = float(np.linalg.norm(moved, axis=-1).max())
        if farthest > FAR * (body.radius + body.height):
            moved = np.zeros_like(moved)
        half = path + body.radius + 0.4 * (body.radius + body.height)
        return cls(middle, half, moved, farthest)

    @property
    def is_seen_from_itself(self) -> bool:
        """Whether the eye that sees the pictures moves with the table."""
        return self.farthest > 0.0 and not self.moved.any()

    def corners(self) -> Array:
        """The corners of its upper side (4, 3), m on the table."""
        square = np.array([[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]])
        return scene.on_table(self.middle + self.half * square)

    def faces(self, camera: Camera) -> tuple[Array, Array]:
        """Its sides and its upper side: polygons (5, 4, 2) in the picture, colours (5, 3)."""
        top = self.corners()
        below = top - [0.0, 0.0, THICKNESS * self.half]
        sides = [
            np.array([top[i], top[i - 1], below[i - 1], below[i]])
            for i in np.argsort(camera.depth(0.5 * (top + np.roll(top, 1, axis=0))))
        ]
        colors = [scene.rgb(FRONT)] * 4 + [scene.rgb(scene.TABLE)]
        return camera.project(np.array([*sides, top])), np.array(colors)

    def grid(self, camera: Camera) -> list[Array]:
        """The lines (2, 2) of its grid in the picture; they are fixed to the table."""
        step = round_step(self.half / LINES)
        lines = []
        for axis in (0, 1):
            low, high = self.middle[axis] - self.half, self.middle[axis] + self.half
            for place in np.arange(np.ceil(low / step), np.floor(high / step) + 1.0) * step:
                ends = np.tile(self.middle, (2, 1))
                ends[:, 1 - axis] += [-self.half, self.half]
                ends[:, axis] = place
                lines.append(camera.project(scene.on_table(ends)))
        return lines


def round_step(length: float) -> float:
    """The largest of 1, 2 or 5 times a power of ten up to a length."""
    power = 10.0 ** np.floor(np.log10(length))
    return float(max(factor * power for factor in (1.0, 2.0, 5.0) if factor * power <= length))
