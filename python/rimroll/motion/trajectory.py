"""A computed motion as data: quantities, events, phases, turns and derivatives at any time."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import asdict, replace
from functools import cached_property
from typing import TYPE_CHECKING, Any, overload

import numpy as np
from numpy.typing import NDArray

from rimroll import _core
from rimroll.bodies.body import Body
from rimroll.errors import RimrollError, hold
from rimroll.files.recorded import parameters
from rimroll.laws import InPlace, Law
from rimroll.motion.crossings import checked, crossings
from rimroll.motion.jacobian import QUANTITIES, SHAKEN_PARAMETERS, Jacobian
from rimroll.motion.moments import (
    ROW_OF,
    UNITS,
    Array,
    Event,
    Moments,
    Phase,
    Stats,
    Turn,
    events_of,
    footprint_of,
)
from rimroll.motion.validity import Validity, validity_of
from rimroll.options import Options, flat_as_text, landing_given
from rimroll.state import State, times
from rimroll.theory.closed_forms import balance_tilt
from rimroll.units import Values, whole_number

if TYPE_CHECKING:
    import xarray as xr

    from rimroll.ground.ground import Ground

MAX_SAMPLES = 10_000_000
"""Samples at a time: some 1.5 GB."""


class Trajectory(Moments):
    """A computed motion as data: all that :class:`Motion` has but figures, films and views."""

    def __init__(
        self,
        core: _core.CoreMotion,
        body: Body,
        start: State[float],
        law: Law,
        options: Options,
        has_jacobian: bool = False,
        ground: Ground | None = None,
    ) -> None:
        self._core = core
        self.body = body
        self.start = start
        self.law = law
        self.options = options
        self.duration = options.duration
        self.gravity = options.gravity
        self.rtol = options.rtol
        self.topple_tilt = options.topple_tilt
        self.max_steps = options.max_steps
        self.status = core.status
        self._has_jacobian = has_jacobian
        self.ground = ground
        self.flat = landing_given(options.flat, ground is not None)
        self.flat_gap = options.flat_gap

    @cached_property
    def _table(self) -> Array:  # type: ignore[override]
        return self._core.nodes()

    @cached_property
    def _poses(self) -> Array:
        return self._core.poses()

    def __getitem__(self, column: str) -> Array:
        """One column by its name in :data:`rimroll.motion.UNITS`."""
        row = ROW_OF[column]
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
        """The complete turns, in order of time.

        A body that falls over in its first turn has none: see :attr:`first_turn`.
        """
        return [Turn(*numbers) for numbers in self._core.turns()]

    @cached_property
    def first_turn(self) -> Turn | None:
        """The first turn, which toppling or another ending may cut short, as in an ensemble.

        It is the first of :attr:`turns`. If the motion ends before, it goes up to that ending: a
        body that topples turns until then, and ``end`` and ``max_tilt`` are the time and the tilt
        at which it topples. None for a body that does not come down, and where the duration or the
        steps ran out first.

        >>> import numpy as np, rimroll as rr
        >>> start = rr.State(tilt="20 deg", tilt_rate=-5.0, yaw_rate=0.01)
        >>> motion = rr.simulate(rr.bodies.can_2007(), start, rr.NoSlip())
        >>> motion.status, motion.turns, round(float(np.degrees(motion.first_turn.angle)), 1)
        ('toppled', [], 202.4)
        """
        numbers = self._core.first_turn()
        return None if numbers is None else Turn(*numbers)

    @cached_property
    def validity(self) -> list[Validity]:
        """How far the model of a rigid body on a rigid, smooth table holds in each of the turns.

        >>> import rimroll as rr
        >>> start = rr.State(tilt=0.5, yaw_rate=0.001)
        >>> print(rr.simulate(rr.bodies.can_2007(), start, rr.NoSlip()).validity[0])
        beyond the model: the gap closes to 4.1e-06 m; a rim is flat within 0.0001 to 0.0004 m
        beyond the model: the contact point runs at 7.15e+03 m/s; sound runs at 5000 m/s
        beyond the model: most of the angle takes 4.94e-05 s; sound crosses the base in 2.04e-05 s
        beyond the model: the turn loses 0 % of the energy; a real can loses 1 % or more
        the largest force is 3.25e+03 weights, at one point
        """
        return validity_of(self._core)

    @cached_property
    def events(self) -> list[Event]:
        """The events, in order of time."""
        return events_of(*self._core.events())

    @cached_property
    def phases(self) -> list[Phase]:
        """The phases of contact, in order of time."""
        begins = self._core.phases()
        ends = [*(start for _, start in begins[1:]), float(self.t[-1])][: len(begins)]
        return [Phase(kind, start, end) for (kind, start), end in zip(begins, ends, strict=True)]

    @property
    def footprint(self) -> Array:
        """Centre of the base's footprint on the table (x, y), m, shape (n, 2).

        It is the centre of the circle on which the base would stand if the body turned upright
        about its contact point. Rocking does not move it; rolling and sliding do.
        """
        return footprint_of(self, self.body)

    @property
    def overturned(self) -> bool | None:
        """Whether the body toppled, that is, reached :attr:`topple_tilt`; None if undecided.

        Under a law without flight, a rim that lifts off beyond the balance tilt also counts. It is
        decided that a body does not overturn where the table no longer moves and the body stands,
        slides flat, has less energy than at its balance tilt, or repeats a rocking without loss. A
        motion that stops before that is undecided, for instance where the base came down flat with
        ``flat="stop"`` while the table still moved.
        """
        return None if self._core.undecided else self._core.overturning_time is not None

    @property
    def overturning_time(self) -> float | None:
        """The time at which the body toppled, s; None unless it :attr:`overturned`."""
        return self._core.overturning_time

    @property
    def uplift_time(self) -> float | None:
        """The time at which a body that stood flat first began to rock, s; None if it never did."""
        return next((event.t for event in self.events if event.kind == "uplift"), None)

    @cached_property
    def max_tilt(self) -> float:
        """The largest tilt, rad, also between the solver's steps."""
        highest = [event.state.tilt for event in self.events if event.kind in ("tilt_max", "land")]
        toppled = [event.state.tilt for event in self.events if event.kind == "topple"]
        return max(float(self.tilt[0]), *highest, *toppled or [float(self.tilt[-1])])

    @property
    def max_tilt_ratio(self) -> float:
        """The largest tilt over the balance tilt atan(R/H)."""
        return self.max_tilt / float(balance_tilt(self.body))

    @property
    def stands(self) -> bool:
        """Whether the body stands at the end, on a table that no longer moves."""
        return self._core.stands

    @property
    def residual_displacement(self) -> Array | None:
        """How far the :attr:`footprint` has moved on the table (x, y) in the end, m.

        None unless the body :attr:`stands` at the end: a body that rolls or slides still moves.
        """
        displacement: Array = self.footprint[-1] - self.footprint[0]
        return displacement if self.stands else None

    @property
    def residual_yaw(self) -> float | None:
        """The angle by which the body has turned about the vertical in the end, rad.

        It is the change of yaw + spin; None unless the body :attr:`stands` at the end.
        """
        return float(self.body_yaw[-1] - self.body_yaw[0]) if self.stands else None

    def __repr__(self) -> str:
        turns = ", ".join(f"{np.degrees(turn.angle):.4f} deg" for turn in self.turns[:3])
        if len(self.turns) > 3:
            turns += f", {len(self.turns) - 3} more"
        ending = f"{self.law.name}, {self.status} at t = {self.t[-1]:.6g} s"
        if self.ground is None:
            return f"<Motion {ending}; turns: [{turns}]>"
        return (
            f"<Motion on a ground of {self.ground.in_words()}: {ending};"
            f" largest tilt {self.max_tilt_ratio:.4g} of the balance tilt>"
        )

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
        numbers = {name: float(values[0]) for name, values in vars(states).items()}
        state: State[float] = State.computed(**numbers)
        return state

    def evaluate(self, t: Values) -> Moments:
        """All quantities at times t (s, shape (n,), inside the motion)."""
        return Moments(self._core.at(np.atleast_1d(self._inside(t))))

    def jacobian(self, t: Values) -> Jacobian:
        """Derivatives of the state at a time t (s, inside the motion), or at times (n,).

        They are exact derivatives by the start, the body and gravity, for a motion from
        ``simulate(..., jacobian=True)``, and about as accurate as the motion. On a table that moves
        there is also ``ground_scale``, the factor s on the acceleration s a(t) of the table, at s =
        1. They include the change of the times at which the contact changes. NaN stands where there
        is no derivative: by tilt and rates of a start that stands, by the spin rate under
        ``InPlace``, which is not free, by parameters that would take the motion out of its plane
        after the whole base has come down flat at once or the rim has landed in that plane, and
        after a slip that fades without a deceleration.

        >>> import rimroll as rr
        >>> start = rr.State(tilt=0.5, tilt_rate=-0.5, yaw_rate=0.1)
        >>> motion = rr.simulate(rr.bodies.can_2007(), start, rr.NoSlip(), jacobian=True)
        >>> round(float(motion.jacobian(0.1)["tilt", "tilt_rate"]), 3)
        0.111

        Raises ``RimrollError`` for a motion simulated without.
        """
        moments = self._inside(t)
        rows = self._core.jacobian(np.atleast_1d(moments))
        values = rows.reshape(-1, len(QUANTITIES), rows.shape[-1])
        return Jacobian(values if moments.ndim else values[0], moments)

    @cached_property
    def turn_jacobians(self) -> list[dict[str, float]]:
        """For each of the turns, the derivative of its angle by each parameter, rad over SI units.

        They include the change of the times at which the tilt is largest. Like :meth:`jacobian`,
        they need a motion simulated with ``jacobian=True``.
        """
        return [_by_parameter(row) for row in self._core.turn_jacobian()]

    @cached_property
    def outcome_jacobian(self) -> dict[str, dict[str, float]]:
        """What becomes of a body on a table that moves: derivatives by each parameter.

        For each of ``max_tilt`` (rad), ``uplift_time`` (s), ``end_time`` (s), ``residual_x`` and
        ``residual_y`` (m) and ``residual_yaw`` (rad), the derivative by each parameter, in SI
        units. The last three are those of the displacement of the footprint and of the turn of the
        body at the end of the motion, whether or not the body stands there. They include the change
        of the times of events: the largest tilt follows its maximum, and the end of a motion that
        topples is the moment at which it does. Like :meth:`jacobian`, they need a motion simulated
        with ``jacobian=True``.

        >>> import rimroll as rr
        >>> column = rr.bodies.cylinder(radius=0.5, length=4.0)
        >>> ground = rr.ground.sine(amplitude=3.0, period=1.2)
        >>> motion = rr.simulate(
        ...     column, rr.State.standing(), rr.NoSlip(), ground=ground, jacobian=True
        ... )
        >>> round(motion.outcome_jacobian["uplift_time"]["ground_scale"], 4)
        -0.2708
        """
        rows = self._core.outcome_jacobian()
        return {name: _by_parameter(row) for name, row in zip(OUTCOMES, rows, strict=True)}

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

        Raises ``RimrollError`` where the function returns anything but n numbers.

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

        Examples
        --------
        >>> import rimroll as rr
        >>> start = rr.State(tilt=0.5, tilt_rate=-0.5, yaw_rate=0.1)
        >>> motion = rr.simulate(rr.bodies.can_2007(), start, rr.NoSlip())
        >>> down, *_ = motion.crossings(lambda at: at.tilt - 0.3, rising=False)
        >>> round(down.state.tilt, 12), round(down.t, 4)
        (0.3, 0.1455)
        """
        if not callable(function):
            raise RimrollError(field="function", value=function, bound="something to call")
        if rising is not None and not isinstance(rising, bool | np.bool_):
            raise RimrollError(field="rising", value=rising, bound="None, True or False")
        count = self._fitting(whole_number("per_step", per_step))

        def values(steps: NDArray[np.int64], fractions: Array) -> Array:
            moments = Moments(self._core.inside(steps, fractions))
            return checked(function(moments), len(moments), moments.t)

        found = crossings(values, self._core.step_count(), count)
        wanted = slice(None) if rising is None else found.rises == bool(rising)
        table = self._core.inside(found.steps[wanted], found.fractions[wanted])
        return events_of(["crossing"] * table.shape[1], table)

    @cached_property
    def cusps(self) -> list[Event]:
        """The cusps of the contact point's path, as events of kind ``cusp``.

        A rim that rolls moves its contact point at R dθ/dt along its tangent. So the path has a
        cusp exactly where the spin rate passes through zero without slip. A rim that slips moves
        its contact point by the slip, too, and has no cusp there. Under ``InPlace`` the contact
        point goes back on its circle, which is no cusp either.
        """
        if isinstance(self.law, InPlace):
            return []
        rolling = [phase for phase in self.phases if phase.kind == "rolling"]
        return [
            replace(event, kind="cusp")
            for event in self.crossings(lambda at: at.spin_rate)
            if any(phase.start < event.t < phase.end for phase in rolling)
        ]

    def _fitting(self, per_step: int) -> int:
        """The number of samples a step, or ``RimrollError`` if there are too many in all."""
        if per_step * len(self) > MAX_SAMPLES:
            allowed = MAX_SAMPLES // len(self)
            raise RimrollError(
                field="per_step",
                value=per_step,
                bound=f"at most {allowed} for this motion of {len(self)} steps",
            )
        return per_step

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
        dataset = dataset.assign_attrs(self.parameters(), status=self.status, message=self.message)
        if self.ground is None:
            return dataset
        from rimroll.ground.dataset import with_record

        return with_record(dataset, self.ground)

    def parameters(self) -> dict[str, Any]:
        """Everything that the motion was computed from, as plain numbers and texts.

        Only the samples of a record of the ground are left out; the dataset has them.
        """
        return parameters(
            self.law.name,
            {**asdict(self.options), "flat": flat_as_text(self.flat), **self._ground_in_words()},
            law=self.law.numbers,
            body=asdict(self.body),
            start=asdict(self.start),
        )

    def _ground_in_words(self) -> dict[str, Any]:
        if self.ground is None:
            return {}
        from rimroll.ground.dataset import attributes

        return attributes(self.ground)


OUTCOMES = ("max_tilt", "uplift_time", "end_time", "residual_x", "residual_y", "residual_yaw")
"""The rows of the core's derivatives of what becomes of a shaken body."""


def _by_parameter(row: Array) -> dict[str, float]:
    return dict(zip(SHAKEN_PARAMETERS, row.tolist(), strict=False))
