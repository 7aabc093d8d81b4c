"""The events, phases and turns of a motion, and the solver's work."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from rimroll.motion.moments import ROW_OF, Array
from rimroll.state import State


@dataclass(frozen=True)
class Event:
    """An event of a motion.

    ``kind`` is ``tilt_min`` (the near-collision), ``tilt_max``, ``on_edge`` (a disk between its
    faces), a change of the contact (``slip``, ``stick``, ``lift_off``, ``land``, ``uplift`` where a
    body that stood flat begins to rock, ``stand`` where it stands again) or an ending
    (``topple``, ``lift_off``, ``face_down``, ``rest``, ``painleve``), a ``crossing`` (see
    :meth:`Motion.crossings`) or a ``cusp`` (see :attr:`Motion.cusps`); ``t`` in s; ``state`` as
    single numbers.
    """

    kind: str
    t: float
    state: State[float]


@dataclass(frozen=True)
class Phase:
    """A part of a motion of one kind; times in s.

    The kinds are ``rolling``, ``sliding`` and ``flying``; with a level base ``standing``,
    ``sliding_flat`` and ``flying_level``; and ``lying``, once the body has toppled.
    """

    kind: str
    start: float
    end: float


@dataclass(frozen=True)
class Turn:
    """The motion from one tilt maximum to the next, through a tilt minimum; rad and s.

    That of a body that falls over ends there instead: see :attr:`Motion.first_turn`.

    The first turn begins at the release if the tilt falls then, else at the next tilt maximum. The
    sign of ``tilt_rate`` decides, however small it is; at exactly 0, the sign of the tilt's
    acceleration decides. When a disk passes the vertical, one turn ends and another begins.

    When the minimum is a near-collision, ``angle`` is the paper's angle of turn. ``angle``: change
    of yaw, with its sign. ``min_tilt``, ``t``, ``yaw_rate``: the smallest tilt, its time and the
    yaw rate then. ``start``, ``end``: times of the maxima (or release) before and after.
    ``max_tilt``: the maximum after.
    """

    angle: float
    """Change of yaw from one tilt maximum (or the release) to the next, with its sign."""
    min_tilt: float
    """Smallest tilt; for a disk on its other face, counted from that face."""
    t: float
    """Time of the smallest tilt."""
    yaw_rate: float
    """dψ/dt there, rad/s."""
    start: float
    """Time of the tilt maximum (or release) before."""
    end: float
    """Time of the tilt maximum after."""
    max_tilt: float
    """The tilt maximum after."""

    def _repr_html_(self) -> str:
        """The view in notebooks."""
        from rimroll.figures.notebook import table, view

        return view("Turn", table([turn_cells(self)], TURN_HEAD))


TURN_HEAD = ("angle", "smallest tilt", "at t")
"""The head of a table of turns."""


def turn_cells(turn: Turn) -> tuple[str, ...]:
    """The cells of a turn under :data:`TURN_HEAD`."""
    angle, smallest = np.degrees([turn.angle, turn.min_tilt])
    return f"{angle:.4f}°", f"{smallest:.4g}°", f"{turn.t:.6g} s"


@dataclass(frozen=True)
class Stats:
    """The solver's work: accepted steps, rejected steps, right-hand sides evaluated.

    An explicit step takes 12 evaluations, an implicit one about a hundred.
    """

    steps: int
    rejected: int
    evaluations: int


def events_of(kinds: list[str], table: Array) -> list[Event]:
    """The events of these kinds at the moments of a table of the core."""
    names = ("tilt", "tilt_rate", "yaw", "yaw_rate", "spin", "spin_rate")
    times = table[ROW_OF["t"]].tolist()
    states = zip(*(table[ROW_OF[name]].tolist() for name in names), strict=True)
    return [
        Event(kind, t, State.computed(**dict(zip(names, numbers, strict=True))))
        for kind, t, numbers in zip(kinds, times, states, strict=True)
    ]
