"""The turns of a motion as pictures show them: their times and angles."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from rimroll.errors import RimrollError
from rimroll.figures.scene import Motion

if TYPE_CHECKING:
    from rimroll.motion.parts import Turn


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
