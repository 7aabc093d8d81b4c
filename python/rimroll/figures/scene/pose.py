"""Where a body is, its turns, and what pictures need to know of bodies and motions."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Protocol

import numpy as np
import numpy.typing as npt

from rimroll.errors import RimrollError

if TYPE_CHECKING:
    from rimroll.motion.moments import Turn


Array = npt.NDArray[np.float64]
Point = tuple[float, float, float]


class RoundBody(Protocol):
    """What the renderer needs of a body: radius of the rim and height of the centre of mass, m.

    A body may also carry ``profile``, a :class:`Profile`, when it is not just a can or a disk, and
    ``corners``, when its base is a polygon.
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
    """An event and its time (s); pictures use ``tilt_min``, ``tilt_max`` and ``on_edge``."""

    @property
    def kind(self) -> str: ...
    @property
    def t(self) -> float: ...


class Motion(Protocol):
    """What the pictures need of a motion: its samples, its dense output and its events."""

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
        """The rim's lowest point, (3,), m: it lies at azimuth yaw + pi from the base's centre.

        If the base has corners, it is the lowest corner.
        """
        corners = corner_ways(body)
        if corners is not None:
            placed = self.place(body.radius * corners, body)
            return np.asarray(placed[np.argmin(placed[:, 2])])
        return np.asarray(self.base_center(body) - body.radius * self.axes()[0])

    def place(self, points: Array, body: RoundBody) -> Array:
        """Points (..., 3) of the body, from the centre of its base, to the frame of the table."""
        return np.asarray(points @ self.rotation().T + self.base_center(body))


def corner_ways(body: RoundBody) -> Array | None:
    """Unit vectors (n, 3) of the body to the corners of its base; None for a round one."""
    count = getattr(body, "corners", 0)
    if not count:
        return None
    angle = np.pi + 2.0 * np.pi * np.arange(count) / count
    return np.stack([np.cos(angle), np.sin(angle), np.zeros(count)], axis=-1)


def pose_at(states: States, k: int) -> Pose:
    """The ``k``-th pose of a motion's states."""
    x, y, z = (float(c) for c in states.center[k])
    return Pose(float(states.tilt[k]), float(states.yaw[k]), float(states.spin[k]), (x, y, z))


def contact_path(states: States, body: RoundBody) -> Array:
    """The contact point on the table, (n, 2), m: behind G by R cos(tilt) - H sin(tilt).

    A motion of a body with corners knows its path itself.
    """
    own: Array | None = (
        getattr(states, "contact_path", None) if corner_ways(body) is not None else None
    )
    if own is not None:
        return own
    out = body.radius * np.cos(states.tilt) - body.height * np.sin(states.tilt)
    way = np.stack([np.cos(states.yaw), np.sin(states.yaw)], axis=-1)
    return np.asarray(states.center[:, :2] - out[:, None] * way)


@dataclass(frozen=True)
class Span:
    """A turn: times of its start, tilt minimum and end, s; and its angle, rad.

    Unlike the last of :attr:`rimroll.Motion.turns`, the last span may end early, as by toppling.
    """

    start: float
    near: float
    end: float
    angle: float


def turn_spans(motion: Motion) -> list[Span]:
    """All turns of a motion, in order of time, from its events.

    A motion of a body with corners has many small extrema, and knows its turns itself.
    """
    if getattr(motion.body, "corners", 0):
        turns: list[Turn] = getattr(motion, "turns", [])
        return [Span(turn.start, turn.t, turn.end, turn.angle) for turn in turns]
    highest = ("tilt_max", "on_edge")
    near = [float(event.t) for event in motion.events if event.kind == "tilt_min"]
    high = np.array([float(event.t) for event in motion.events if event.kind in highest])
    first, last = float(motion.t[0]), float(motion.t[-1])
    spans = []
    for t in near:
        start, end = max(high[high < t], default=first), min(high[high > t], default=last)
        yaw = motion.evaluate(np.array([start, end])).yaw
        spans.append(Span(float(start), t, float(end), float(yaw[1] - yaw[0])))
    return spans


def turn_span(motion: Motion, turn: int = 0) -> Span:
    """The turn numbered ``turn``; ``RimrollError`` if the motion has no such turn."""
    spans = turn_spans(motion)
    if not -len(spans) <= turn < len(spans):
        count = f"{len(spans)} near collision{'' if len(spans) == 1 else 's'}"
        raise RimrollError(f"turn is {turn}, but the motion has {count} (counted from 0)")
    return spans[turn]
