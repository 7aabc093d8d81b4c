"""Whole motions: simulate one, and read all its quantities."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Sequence
from dataclasses import asdict, dataclass
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any, cast, overload

import numpy as np
from numpy.typing import NDArray

from rimroll import _core
from rimroll.body import Body, one_body
from rimroll.errors import RimrollError, callback, expect, hold
from rimroll.given import Number, Values, whole_number
from rimroll.jacobian import PARAMETERS, Jacobian
from rimroll.laws import Law, one_law
from rimroll.options import Options
from rimroll.state import State, single, times
from rimroll.units import START_UNIT_OF

if TYPE_CHECKING:
    import xarray as xr
    from matplotlib.figure import Figure

Array = NDArray[np.float64]

_ROW = {name: i for i, name in enumerate(_core.COLUMNS)}

MOST_SAMPLES = 10_000_000
"""Samples at a time: some 1.5 GB."""

MOST_THREADS = 1024

UNITS = {
    "t": "s",
    **START_UNIT_OF,
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
}
"""The unit of each column of a table of moments."""


class Moments:
    """A motion at n moments: arrays (n,), or (n, 2) and (n, 3) for vectors."""

    def __init__(self, table: Array) -> None:
        self._table = table

    def __getitem__(self, column: str) -> Array:
        """One column by its name in :data:`rimroll.motion.UNITS`."""
        values: Array = self._table[_ROW[column]]
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
    def center(self) -> Array:
        """Centre of mass (x, y, z), m, shape (n, 3); it starts above the origin."""
        return self._vector("x", "y", "z")

    @property
    def contact_path(self) -> Array:
        """The contact point on the table (x, y), m, shape (n, 2)."""
        return self._vector("contact_x", "contact_y")

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
    def energy_budget(self) -> Array:
        """Energy and all losses so far, J: constant except for numerical errors."""
        return self.energy + self.friction_loss + self.resistance_loss + self.impact_loss

    @property
    def state(self) -> State[Array]:
        """Euler angles and rates as a :class:`rimroll.State` of arrays."""
        names = ("tilt", "tilt_rate", "yaw", "yaw_rate", "spin", "spin_rate")
        return cast("State[Array]", State(**{name: self[name] for name in names}))

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
    faces), a change of the contact (``slip``, ``stick``, ``lift_off``, ``land``) or an ending
    (``topple``, ``lift_off``, ``face_down``, ``rest``, ``painleve``), or a ``crossing`` (see
    :meth:`Motion.crossings`); ``t`` in s; ``state`` as single numbers.
    """

    kind: str
    t: float
    state: State[float]


@dataclass(frozen=True)
class Phase:
    """A part of a motion of one kind: ``rolling``, ``sliding`` or ``flying``; times in s."""

    kind: str
    start: float
    end: float


@dataclass(frozen=True)
class Turn:
    """The motion from one tilt maximum to the next, through a tilt minimum; rad and s.

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


@dataclass(frozen=True)
class Stats:
    """The solver's work: accepted steps, rejected steps, right-hand sides evaluated.

    An explicit step takes 12 evaluations, an implicit one about a hundred.
    """

    steps: int
    rejected: int
    evaluations: int


class Motion(Moments):
    """A computed motion.

    Its arrays are at the solver's accepted steps, which are close together where the motion is
    fast. A moment at which the contact changes is there twice, before and after the change. For
    other times, call it: ``motion(t)``.

    Attributes
    ----------
    body, start, law, duration, gravity, rtol, topple_tilt, max_steps
        What it was computed from.
    status
        ``finished``, ``toppled``, ``lifted_off``, ``face_down``, ``at_rest``, ``painleve`` or
        ``failed``.
    """

    def __init__(
        self,
        core: _core.CoreMotion,
        body: Body,
        start: State[float],
        law: Law,
        options: Options,
        has_jacobian: bool = False,
    ) -> None:
        self._core = core
        self.body = body
        self.start = start
        self.law = law
        self._options = options
        self.duration = options.duration
        self.gravity = options.gravity
        self.rtol = options.rtol
        self.topple_tilt = options.topple_tilt
        self.max_steps = options.max_steps
        self.status = core.status
        self._has_jacobian = has_jacobian

    @cached_property
    def _table(self) -> Array:  # type: ignore[override]
        return self._core.nodes()

    @cached_property
    def _poses(self) -> Array:
        return self._core.poses()

    def __getitem__(self, column: str) -> Array:
        """One column by its name in :data:`rimroll.motion.UNITS`."""
        row = _ROW[column]
        # Forces and energies are computed only when needed.
        table = self._poses if row < len(self._poses) else self._table
        values: Array = table[row]
        return values

    def __len__(self) -> int:
        return len(self.t)

    @cached_property
    def message(self) -> str:
        """The ending in a sentence with angles in radians."""
        return self._core.message(False)

    @property
    def message_in_degrees(self) -> str:
        """The ending in a sentence with angles in degrees."""
        return self._core.message(True)

    @cached_property
    def stats(self) -> Stats:
        """The solver's work."""
        return Stats(*self._core.work)

    @cached_property
    def turns(self) -> list[Turn]:
        """The turns, in order of time."""
        return [Turn(*numbers) for numbers in self._core.turns()]

    @cached_property
    def events(self) -> list[Event]:
        """The events, in order of time."""
        return _events(*self._core.events())

    @cached_property
    def phases(self) -> list[Phase]:
        """The phases of contact, in order of time."""
        begins = self._core.phases()
        ends = [*(start for _, start in begins[1:]), float(self.t[-1])][: len(begins)]
        return [Phase(kind, start, end) for (kind, start), end in zip(begins, ends, strict=True)]

    def __repr__(self) -> str:
        turns = ", ".join(f"{np.degrees(turn.angle):.4f} deg" for turn in self.turns[:3])
        if len(self.turns) > 3:
            turns += f", {len(self.turns) - 3} more"
        return (
            f"<Motion {self.law.name}, {self.status} at t = {self.t[-1]:.6g} s; turns: [{turns}]>"
        )

    def _repr_html_(self) -> str:
        """The view in notebooks: the ending, the first turns in degrees and the losses."""
        from rimroll.notebook import motion_in_html

        return motion_in_html(self)

    def __reduce__(self) -> tuple[Any, ...]:
        """Pickling computes the motion again, with the same bits."""
        return _follow, (self.body, self.start, self.law, self._options, self._has_jacobian)

    @overload
    def __call__(self, t: float | str) -> State[float]: ...
    @overload
    def __call__(self, t: Array | Sequence[float]) -> State[Array]: ...
    @overload
    def __call__(self, t: Values) -> State: ...
    def __call__(self, t: Values) -> State:
        """Dense output: the state at a time t (s, inside the motion), or at times (n,).

        At the time of a landing it is the state after it.
        """
        moments = self._inside(t)
        states = self.evaluate(moments).state
        if moments.ndim:
            return states
        return State(**{name: float(values[0]) for name, values in vars(states).items()})

    def evaluate(self, t: Values) -> Moments:
        """All quantities at times t (s, shape (n,), inside the motion)."""
        return Moments(self._core.at(np.atleast_1d(self._inside(t))))

    def jacobian(self, t: Values) -> Jacobian:
        """Derivatives of the state at a time t (s, inside the motion), or at times (n,).

        They are exact derivatives by the start, the body and gravity, for a motion from
        ``simulate(..., jacobian=True)``, and about as accurate as the motion.

        >>> import rimroll as rr
        >>> start = rr.State(tilt=0.5, tilt_rate=-0.5, yaw_rate=0.1)
        >>> motion = rr.simulate(rr.bodies.can_2007(), start, rr.NoSlip(), jacobian=True)
        >>> round(float(motion.jacobian(0.1)["tilt", "tilt_rate"]), 3)
        0.116

        Raises ``RimrollError`` for a motion simulated without.
        """
        moments = self._inside(t)
        values = self._core.jacobian(np.atleast_1d(moments))
        return Jacobian(values if moments.ndim else values[0], moments)

    @cached_property
    def turn_jacobians(self) -> list[dict[str, float]]:
        """For each of the turns, the derivative of its angle by each parameter, rad over SI units.

        They include the change of the times at which the tilt is largest. Like :meth:`jacobian`,
        they need a motion simulated with ``jacobian=True``.
        """
        rows = self._core.turn_jacobian().tolist()
        return [dict(zip(PARAMETERS, row, strict=True)) for row in rows]

    def _inside(self, t: Values) -> Array:
        moments = times(t)
        last = float(self.t[-1])
        bound = f"inside the motion, 0 to {last:.6g} s ({self.status})"
        hold("t", moments, (moments >= 0.0) & (moments <= last), bound, "s")
        return moments

    def samples(self, per_step: int = 4) -> Moments:
        """All quantities at the accepted steps and evenly inside each, for smooth curves."""
        return Moments(self._core.samples(self._fitting(whole_number("per_step", per_step))))

    def crossings(
        self,
        function: Callable[[Moments], Array],
        *,
        rising: bool | None = None,
        per_step: int = 4,
    ) -> list[Event]:
        """Events of your own: where a function of the motion passes through zero.

        Parameters
        ----------
        function
            Takes the :class:`Moments` at n times of the motion and returns n numbers that
            change sign at the event, such as ``lambda at: at.tilt - 0.3``.
        rising
            True for zeros at which the function rises, False for those at which it falls; both by
            default.
        per_step
            Samples in each of the solver's steps. Two zeros between two samples are missed, and
            a zero without a change of sign is not an event.

        Returns
        -------
        list of Event
            In order of time, of kind ``crossing``: where the function changes its sign inside a
            step or becomes exactly 0, as the slip does when the rim sticks, or a clipped function
            at its bound. Times are as accurate as the dense output. A jump over zero where the
            contact changes, as of a velocity in a landing, is not an event.

        >>> import rimroll as rr
        >>> start = rr.State(tilt=0.5, tilt_rate=-0.5, yaw_rate=0.1)
        >>> motion = rr.simulate(rr.bodies.can_2007(), start, rr.NoSlip())
        >>> down, *_ = motion.crossings(lambda at: at.tilt - 0.3, rising=False)
        >>> round(down.state.tilt, 12), round(down.t, 4)
        (0.3, 0.1423)

        Raises ``RimrollError`` where the function returns anything but n numbers.
        """
        from rimroll.crossings import checked, crossings

        if not callable(function):
            raise RimrollError(f"function must be something to call, got {function!r}")
        if rising is not None and not isinstance(rising, bool | np.bool_):
            raise RimrollError(f"rising must be None, True or False, got {rising!r}")
        count = self._fitting(whole_number("per_step", per_step))

        def values(steps: NDArray[np.int64], fractions: Array) -> Array:
            moments = Moments(self._core.inside(steps, fractions))
            return checked(function(moments), len(moments), moments.t)

        found = crossings(values, self._core.step_count(), count)
        wanted = slice(None) if rising is None else found.rises == bool(rising)
        table = self._core.inside(found.steps[wanted], found.fractions[wanted])
        return _events(["crossing"] * table.shape[1], table)

    def _fitting(self, per_step: int) -> int:
        """The number of samples a step, or ``RimrollError`` if there are too many in all."""
        if per_step * len(self) > MOST_SAMPLES:
            most = MOST_SAMPLES // len(self)
            raise RimrollError(
                f"per_step must be at most {most} for this motion of {len(self)} steps,"
                f" got {per_step}"
            )
        return per_step

    def plot(self) -> Figure:
        """The paper's nine-panel simulation figure of this motion."""
        from rimroll.plot import nine_panels

        return nine_panels(self)

    def animate(self, path: str | os.PathLike[str], **options: Any) -> Path:
        """Write the motion as a film: GIF, self-contained HTML page or MP4, by the suffix.

        Time slows down while the contact point runs fast round the rim. For ``seconds``,
        ``speed``, ``fps``, ``view`` and the other options see :func:`rimroll.animation.animate`.
        """
        from rimroll.animation import animate

        return animate(self, path, **options)

    def to_xarray(self) -> xr.Dataset:
        """The motion as a dataset over ``t`` with units and everything that it was computed from.

        A moment at which the contact changes is there once, after the change.
        """
        import xarray as xr

        # An index has each time once: at a change of contact, the moment after it.
        last = np.append(np.diff(self.t) > 0.0, True)
        dataset = xr.Dataset(
            {
                name: ("t", self[name][last], {"units": UNITS[name]})
                for name in UNITS
                if name != "t"
            },
            coords={"t": ("t", self.t[last], {"units": "s"})},
        )
        return dataset.assign_attrs(self.parameters(), status=self.status, message=self.message)

    @classmethod
    def from_xarray(cls, dataset: xr.Dataset, *, jacobian: bool = False) -> Motion:
        """The motion of a dataset from :meth:`to_xarray`, or from a file that holds one.

        It is computed again from the attributes: the same to the last bit, whichever points the
        dataset holds. ``jacobian`` as for :func:`simulate`. Raises ``RimrollError`` for a dataset
        of something else.
        """
        from rimroll.many_falls import body_of, law_of
        from rimroll.recorded import expect_dataset, options_of, start_of

        expect_dataset(dataset)
        if "outcome" in dataset:
            raise RimrollError("dataset must be that of a motion, got one of falls")
        start = single(start_of(dataset))
        return _follow(body_of(dataset), start, law_of(dataset), options_of(dataset), jacobian)

    def parameters(self) -> dict[str, Any]:
        """Everything that the motion was computed from, as plain numbers and texts."""
        options = {k: v for k, v in asdict(self._options).items() if v is not None}
        return {
            "law": self.law.name,
            **{f"law_{name}": value for name, value in self.law.numbers.items()},
            **{f"body_{name}": value for name, value in asdict(self.body).items()},
            **{f"start_{name}": value for name, value in asdict(self.start).items()},
            **options,
            "rimroll_version": _core.__version__,
        }


def _events(kinds: list[str], table: Array) -> list[Event]:
    names = ("tilt", "tilt_rate", "yaw", "yaw_rate", "spin", "spin_rate")
    times = table[_ROW["t"]].tolist()
    states = zip(*(table[_ROW[name]].tolist() for name in names), strict=True)
    return [
        Event(kind, t, State(**dict(zip(names, numbers, strict=True))))
        for kind, t, numbers in zip(kinds, times, states, strict=True)
    ]


def simulate(
    body: Body,
    start: State,
    law: Law,
    duration: Number = 2.0,
    *,
    gravity: Number = _core.STANDARD_GRAVITY,
    rtol: float = 1e-10,
    topple_tilt: Number | None = None,
    max_steps: int = 1_000_000,
    progress: Callable[[float], object] | None = None,
    jacobian: bool = False,
) -> Motion:
    """Follow a body from a start under a contact law.

    Parameters
    ----------
    body, start, law
        What rolls, how it is released (single numbers), and how its rim meets the table.
    duration
        Length of the motion, s. The motion may end earlier; its status says why.
    gravity
        m/s²; 9.80665 unless given. The paper used 9.8.
    rtol
        Intended error over some tens of rockings, relative to the size of each quantity, 1e-14 to
        1e-3; below 1e-13 rounding dominates. Each step may have a fiftieth of this error, and the
        errors add up: after thousands of steps, the energy may be wrong by a hundred times
        ``rtol``, which matters if ``rtol`` is large.
    topple_tilt
        The tilt that counts as toppled, rad. By default π/2 for a body with height, whose side
        then meets the table; none for a disk, which may stand on its edge and fall to either face.
    max_steps
        Largest number of steps, after which the status is ``failed``; a step takes 0.3 kB.
    progress
        Called occasionally in a long motion with the time reached, s. With ``jacobian`` the
        derivatives are computed after the motion, and the times begin again at 0.
    jacobian
        Whether to compute derivatives, too: see :meth:`Motion.jacobian`. They exist for ``NoSlip``
        and ``Frictionless`` without resistance, and take about thirty times as long.

    Returns
    -------
    Motion
        A valid start never raises an error: the status of the motion says how it ended. A start
        with yaw_rate = spin_rate = 0 falls exactly face down and ends there.

    Notes
    -----
    Near-collisions are computed down to a tilt of 1e-16 rad; below it a motion ends as
    ``face_down``. With a resistance it ends below 1e-9 rad, but only if the resistance has stopped
    the contact point on the rim for good. The criterion: the resistance would slow down a contact
    point that is fast enough to raise the body again a hundred times as strongly as the falling
    tilt accelerates it. A weaker resistance ends no motion, and as it vanishes the motion becomes
    that without it. Such an ending is ``at_rest`` if at most 1 % of the energy at the start is
    left, which the last slap takes; the message says how much. With friction or a resistance, a
    motion is also ``at_rest`` when 1e-10 of its energy is left.

    Raises
    ------
    RimrollError
        A number outside its bounds, or a start of arrays; derivatives of a motion whose contact
        changes on the way, or under a law without derivatives.
    """
    one_body(body)
    expect("start", start, State)
    one_law(law)
    options = Options.read(duration, gravity, rtol, topple_tilt, max_steps)
    callback("progress", progress)
    return _follow(body, single(start), law, options, bool(jacobian), progress)


def _follow(
    body: Body,
    start: State[float],
    law: Law,
    options: Options,
    has_jacobian: bool = False,
    progress: Callable[[float], object] | None = None,
) -> Motion:
    core = _core.simulate(body, start, law, *options.values, progress, has_jacobian)
    return Motion(core, body, start, law, options, has_jacobian)


def thread_count(threads: object) -> int:
    """As many as were asked for; 0, which stands for as many as there are processors, for None."""
    count = 0 if threads is None else whole_number("threads", threads)
    if count > MOST_THREADS:
        raise RimrollError(f"threads must be at most {MOST_THREADS}, got {count}")
    return count
