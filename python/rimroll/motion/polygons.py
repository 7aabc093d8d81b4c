"""A computed motion of a body with corners, and its figure."""

from __future__ import annotations

import os
from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from rimroll import _core
from rimroll.bodies.polygons import PolygonalBody
from rimroll.errors import RimrollError
from rimroll.laws import Frictionless, Law, NoSlip
from rimroll.motion.moments import Phase, Stats, Turn
from rimroll.options import Options
from rimroll.state import State, times
from rimroll.units import Values, whole_number

if TYPE_CHECKING:
    import xarray as xr
    from matplotlib.figure import Figure

    from rimroll.figures.animation import Film


Array = NDArray[np.float64]

_ROW = {name: row for row, name in enumerate(_core.POLYGON_COLUMNS)}
_ANGLES = ("tilt", "tilt_rate", "yaw", "yaw_rate", "spin", "spin_rate")


@dataclass(frozen=True)
class PolygonEvent:
    """An event of a body with corners.

    ``kind`` is ``tilt_max``, ``tilt_min``, ``impact``, ``corner_lift`` (one end of an edge leaves
    the table), ``lift_off`` (the force of the table vanishes) or ``topple``; ``t`` in s; ``state``
    as single numbers, after the event; ``support`` what carries the body afterwards, ``corner``,
    ``edge``, ``face`` or ``flight``; ``loss`` the energy that an impact took, J.
    """

    kind: str
    t: float
    state: State[float]
    support: str
    loss: float


class PolygonMoments:
    """A motion of a body with corners at n moments: arrays (n,), or (n, 2) and (n, 3)."""

    def __init__(self, table: Array) -> None:
        self._table = table

    def __getitem__(self, column: str) -> Array:
        """One column by its name in :meth:`keys`."""
        values: Array = self._table[_ROW[column]]
        return values

    def keys(self) -> list[str]:
        """The names of the columns."""
        return list(_ROW)

    def __len__(self) -> int:
        return int(self._table.shape[1])

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
        """θ, rad: where it is a multiple of 2π/n, the body leans over a corner."""
        return self["spin"]

    @property
    def spin_rate(self) -> Array:
        """dθ/dt, rad/s."""
        return self["spin_rate"]

    @property
    def center(self) -> Array:
        """Centre of mass (x, y, z), m, shape (n, 3); it starts above the origin."""
        return np.stack([self["x"], self["y"], self["z"]], axis=-1)

    @property
    def contact_path(self) -> Array:
        """The supporting corner, or the middle of the edge or the face (x, y), m, shape (n, 2).

        In flight, the place below the lowest corner.
        """
        return np.stack([self["contact_x"], self["contact_y"]], axis=-1)

    @property
    def corner(self) -> NDArray[np.int64]:
        """The (first) corner that carries the body, from 0 to corners − 1; in flight the lowest."""
        return self["corner"].astype(np.int64)

    @property
    def normal_force(self) -> Array:
        """The table's upward push, N."""
        return self["normal"]

    @property
    def friction_ratio(self) -> Array:
        """|T|/N: the coefficient of friction that the motion needs between impacts; 0 in flight."""
        touching = self["normal"] > 0.0
        ratio = np.zeros(len(self))
        np.divide(self["friction"], self["normal"], out=ratio, where=touching)
        return ratio

    @property
    def energy(self) -> Array:
        """Kinetic and potential energy, J; the latter is counted from the table."""
        return self["energy"]

    @property
    def impact_loss(self) -> Array:
        """Energy that impacts have taken so far, J."""
        return self["impact_loss"]


class PolygonMotion(PolygonMoments):
    """A computed motion of a body with corners; its arrays are at the solver's steps.

    An impact is there twice, before and after. For other times, call it: ``motion(t)``.

    Attributes
    ----------
    body, start, law, restitution, options
        What it was computed from; :class:`rimroll.Options` are one object.
    duration, gravity, rtol, topple_tilt, max_steps
        The options one by one.
    status
        ``finished``, ``toppled``, ``at_rest`` (it stands on its base: impacts, if endless, took
        the energy), ``lifted_off`` (without slip, a corner came down so that its friction lifts it,
        and to stay it would have to be pulled down) or ``failed``.
    """

    def __init__(
        self,
        core: _core.CorePolygonMotion,
        body: PolygonalBody,
        start: State[float],
        law: Law,
        options: Options,
        restitution: float,
    ) -> None:
        super().__init__(core.samples(1))
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
        self.restitution = restitution
        self.status = core.status

    def __reduce__(self) -> tuple[Any, ...]:
        """Pickling computes the motion again, with the same bits."""
        return follow, (self.body, self.start, self.law, self.options, self.restitution)

    def __repr__(self) -> str:
        return f"<PolygonMotion, {self.body.corners} corners, {self.message}>"

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
        """The turns from one large tilt maximum to the next, as of a round body.

        As one corner follows another the tilt has small maxima, too. Only maxima count between
        which the tilt falls below half of the lower one.
        """
        return [Turn(*numbers) for numbers in self._core.turns()]

    @cached_property
    def events(self) -> list[PolygonEvent]:
        """The events in order of time."""
        kinds, supports, losses, table = self._core.events()
        rows = zip(*(table[_ROW[name]].tolist() for name in ("t", *_ANGLES)), strict=True)
        return [
            PolygonEvent(
                kind,
                t,
                State.computed(**dict(zip(_ANGLES, numbers, strict=True))),
                support,
                loss,
            )
            for kind, support, loss, (t, *numbers) in zip(
                kinds, supports, losses, rows, strict=True
            )
        ]

    @cached_property
    def impacts(self) -> list[PolygonEvent]:
        """The events that are impacts."""
        return [event for event in self.events if event.kind == "impact"]

    @cached_property
    def phases(self) -> list[Phase]:
        """What carries the body, and when: ``corner``, ``edge``, ``face`` or ``flight``."""
        kinds, starts = zip(*self._core.phases(), strict=True)
        ends = [*starts[1:], float(self.t[-1])]
        return [Phase(*phase) for phase in zip(kinds, starts, ends, strict=True)]

    def __call__(self, t: Values) -> PolygonMoments:
        """All quantities at times t (s) of the motion; after the impact, if one is then."""
        moments = times(t)
        if not np.all((moments >= 0.0) & (moments <= self.t[-1])):
            raise RimrollError(f"must be inside the motion, 0 to {self.t[-1]:.6g} s", "t")
        return PolygonMoments(self._core.at(np.atleast_1d(moments)))

    evaluate = __call__

    def samples(self, per_step: int = 4) -> PolygonMoments:
        """All quantities at the accepted steps and evenly inside each, for smooth curves."""
        count = whole_number("per_step", per_step)
        if not 0 < count <= 1000:
            raise RimrollError(field="per_step", value=count, bound="between 1 and 1000")
        return PolygonMoments(self._core.samples(count))

    def plot(self) -> Figure:
        """Tilt, yaw, energy and the path of the supporting corner, with the impacts."""

        return polygon_figure(self)

    def animate(self, path: str | os.PathLike[str], **options: Any) -> Path:
        """Write the motion as a film: GIF, HTML page or MP4; see :meth:`rimroll.Motion.animate`."""
        from rimroll.figures.animation import animate

        return animate(self, path, **options)

    def film(self, **options: Any) -> Film:
        """The motion as a film that a notebook shows; see :meth:`rimroll.Motion.film`."""
        from rimroll.figures.animation.film import film

        return film(self, **options)

    def to_xarray(self) -> xr.Dataset:
        """The motion as a dataset over ``t``, the moments after impacts."""
        import xarray as xr

        last = np.append(np.diff(self.t) > 0.0, True)
        columns = {name: ("t", self[name][last]) for name in _ROW if name != "t"}
        attributes = {"status": self.status, "message": self.message, "law": self.law.name}
        return xr.Dataset(columns, coords={"t": self.t[last]}, attrs=attributes)


def follow(
    body: PolygonalBody,
    start: State[float],
    law: Law,
    options: Options,
    restitution: float,
    progress: Callable[[float], object] | None = None,
) -> PolygonMotion:
    """What :func:`rimroll.simulate` computes for a body with corners."""
    if not isinstance(law, NoSlip | Frictionless) or law.resistances:
        raise RimrollError(
            field="law",
            value=law,
            bound="NoSlip() or Frictionless() for a body with corners, without resistances",
        )
    core = _core.simulate_polygonal_body(
        body, start, law.name, *options.values, restitution, progress
    )
    return PolygonMotion(core, body, start, law, options, restitution)


def polygon_figure(motion: PolygonMotion) -> Figure:
    """Tilt, yaw and energy over time, and the way of the supporting corner on the table."""
    from matplotlib.figure import Figure

    from rimroll.figures.scene.shape import BLUE, GREEN, INK, VERMILLION

    figure = Figure(figsize=(8.0, 5.2), layout="constrained")
    (tilt, yaw), (energy, path) = figure.subplots(2, 2)
    fine = motion.samples(8)
    for axes, values, label in (
        (tilt, np.degrees(fine.tilt), "tilt (°)"),
        (yaw, np.degrees(fine.yaw), "yaw (°)"),
        (energy, 1e3 * fine.energy, "energy (mJ)"),
    ):
        axes.plot(fine.t, values, color=BLUE, lw=1.2)
        axes.set(xlabel="time (s)", ylabel=label)
    struck = np.array([event.t for event in motion.impacts])
    angles = np.degrees([event.state.tilt for event in motion.impacts])
    tilt.plot(struck, angles, ".", color=VERMILLION, ms=4, label=f"{len(struck)} impacts")
    if len(struck):
        tilt.legend(frameon=False)
    # The face has no corner of its own to show.
    standing = motion.phases[-1].kind == "face"
    supports = fine.contact_path[: -1 if standing else None]
    path.plot(*(1e3 * fine.center[:, :2].T), color=GREEN, lw=1.0, label="centre of mass")
    path.plot(*(1e3 * supports.T), ".-", color=VERMILLION, lw=0.6, ms=4, label="support")
    path.set(xlabel="x (mm)", ylabel="y (mm)", aspect="equal")
    path.legend(frameon=False, fontsize="small", loc="center left", bbox_to_anchor=(1.0, 0.5))
    figure.suptitle(
        f"{motion.body.corners} corners, {motion.law!r}: {motion.message_in_degrees}",
        fontsize="medium",
        color=INK,
    )
    return figure
