"""All quantities of a motion at some times; its events, phases and turns, and the solver's work."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import cast

import numpy as np
from numpy.typing import NDArray

from rimroll import _core
from rimroll.bodies.body import Body
from rimroll.state import START_NUMBERS, State

Array = NDArray[np.float64]

ROW_OF = {name: row for row, name in enumerate(_core.COLUMNS)}
"""The row of each column in a table of the core."""

UNITS = {
    "t": "s",
    **{name: one.unit for name, one in START_NUMBERS.items()},
    "axial_spin": "rad/s",
    "x": "m",
    "y": "m",
    "z": "m",
    "contact_x": "m",
    "contact_y": "m",
    "normal_force": "N",
    "friction_x": "N",
    "friction_y": "N",
    "friction_ratio": "1",
    "slip_x": "m/s",
    "slip_y": "m/s",
    "gap": "m",
    "kinetic_energy": "J",
    "potential_energy": "J",
    "friction_loss": "J",
    "resistance_loss": "J",
    "impact_loss": "J",
    "ground_work": "J",
}
"""The unit of each column of a table of moments."""


class Moments:
    """A motion at n moments: arrays (n,), or (n, 2) and (n, 3) for vectors."""

    def __init__(self, table: Array) -> None:
        self._table = table

    def __getitem__(self, column: str) -> Array:
        """One column by its name in :data:`rimroll.motion.UNITS`."""
        values: Array = self._table[ROW_OF[column]]
        return values

    def _vector(self, *columns: str) -> Array:
        return np.stack([self[column] for column in columns], axis=-1)

    @property
    def t(self) -> Array:
        """Time, s."""
        return self["t"]

    @property
    def tilt(self) -> Array:
        """φ, rad."""
        return self["tilt"]

    @property
    def tilt_rate(self) -> Array:
        """dφ/dt, rad/s."""
        return self["tilt_rate"]

    @property
    def yaw(self) -> Array:
        """ψ, rad."""
        return self["yaw"]

    @property
    def yaw_rate(self) -> Array:
        """dψ/dt, rad/s."""
        return self["yaw_rate"]

    @property
    def spin(self) -> Array:
        """θ, rad."""
        return self["spin"]

    @property
    def spin_rate(self) -> Array:
        """dθ/dt, rad/s."""
        return self["spin_rate"]

    @property
    def axial_spin(self) -> Array:
        """s = dθ/dt + dψ/dt cos φ, the angular velocity about the symmetry axis, rad/s."""
        return self["axial_spin"]

    @property
    def body_angular_velocity(self) -> Array:
        """The angular velocity along axes fixed in the body (x, y, z), rad/s, shape (n, 3).

        It is what an ideal gyroscope in the body shows. The z axis is the symmetry axis; x and y
        are those that the spin θ turns: ω_x + i ω_y = (dψ/dt sin φ − i dφ/dt) exp(−iθ), and ω_z is
        :attr:`axial_spin`. These stay bounded through a near-collision, where the rates of yaw and
        spin do not.
        """
        along = self.yaw_rate * np.sin(self.tilt)
        across = (along - 1j * self.tilt_rate) * np.exp(-1j * self.spin)
        return np.stack([across.real, across.imag, self.axial_spin], axis=-1)

    @property
    def center(self) -> Array:
        """Centre of mass (x, y, z), m, shape (n, 3); it starts above the origin."""
        return self._vector("x", "y", "z")

    @property
    def contact_path(self) -> Array:
        """The contact point on the table (x, y), m, shape (n, 2)."""
        return self._vector("contact_x", "contact_y")

    @property
    def body_yaw(self) -> Array:
        """ψ + θ, rad: the heading of the body's own x axis where the body is upright.

        It does not jump where the body stands up, is lifted or lands on its flat base, as yaw and
        spin do.
        """
        return self.yaw + self.spin

    @property
    def normal_force(self) -> Array:
        """N, the table's upward push, N."""
        return self["normal_force"]

    @property
    def friction_force(self) -> Array:
        """T, the table's horizontal force on the rim (x, y), N, shape (n, 2)."""
        return self._vector("friction_x", "friction_y")

    @property
    def friction_ratio(self) -> Array:
        """|T|/N: the friction coefficient that the motion needs.

        While the rim slides under dry friction, it is the law's coefficient. It is infinite where a
        rolling rim needs friction but the normal force is zero, as at a lift-off.
        """
        return self["friction_ratio"]

    @property
    def slip(self) -> Array:
        """Horizontal velocity of the rim's lowest point (x, y), m/s, shape (n, 2)."""
        return self._vector("slip_x", "slip_y")

    @property
    def gap(self) -> Array:
        """Height of the rim's lowest point over the table, m: zero except in flight."""
        return self["gap"]

    @property
    def kinetic_energy(self) -> Array:
        """Kinetic energy, J."""
        return self["kinetic_energy"]

    @property
    def potential_energy(self) -> Array:
        """m g (z − H), J: zero when the body stands upright."""
        return self["potential_energy"]

    @property
    def energy(self) -> Array:
        """Kinetic and potential energy together, J."""
        return self.kinetic_energy + self.potential_energy

    @property
    def friction_loss(self) -> Array:
        """Energy lost to friction so far, J."""
        return self["friction_loss"]

    @property
    def resistance_loss(self) -> Array:
        """Energy lost so far to rolling resistance, pivoting friction and air, J."""
        return self["resistance_loss"]

    @property
    def impact_loss(self) -> Array:
        """Energy lost in landings so far, J."""
        return self["impact_loss"]

    @property
    def ground_work(self) -> Array:
        """Work of the moving table on the body so far, in the frame of the table, J."""
        return self["ground_work"]

    @property
    def energy_budget(self) -> Array:
        """Energy and all losses so far less the work of the moving table, J.

        It is constant except for numerical errors.
        """
        losses = self.friction_loss + self.resistance_loss + self.impact_loss
        return self.energy + losses - self.ground_work

    @property
    def state(self) -> State[Array]:
        """Euler angles and rates as a :class:`rimroll.State` of arrays."""
        names = ("tilt", "tilt_rate", "yaw", "yaw_rate", "spin", "spin_rate")
        return cast("State[Array]", State.computed(**{name: self[name] for name in names}))

    def __len__(self) -> int:
        return int(self._table.shape[1])

    def __iter__(self) -> Iterator[str]:
        """The names of the columns: ``dict(moments)`` and ``pandas.DataFrame(dict(moments))``."""
        return iter(UNITS)

    def __contains__(self, column: object) -> bool:
        return column in UNITS

    def keys(self) -> list[str]:
        """The names of the columns."""
        return list(UNITS)

    def __repr__(self) -> str:
        span = f", t from {self.t.min():.6g} to {self.t.max():.6g} s" if len(self) else ""
        return f"<Moments at {len(self)} times{span}; columns: {', '.join(UNITS)}>"


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


def footprint_of(moments: Moments, body: Body) -> Array:
    """Centre of the footprint (x, y), m, shape (n, 2): R from the contact point toward the axis.

    It is the centre of the circle on which the base would stand if the body turned upright about
    the contact point. Rocking about a point of the rim does not move it; rolling and sliding do.
    """
    heading = np.stack([np.cos(moments.yaw), np.sin(moments.yaw)], axis=-1)
    return np.asarray(moments.contact_path + body.radius * heading)
