"""Incremental dynamic analysis: one body under several records, each scaled to several intensities.

Each record is multiplied by factors, its vertical component too. The statistics of fragility are in
`lognormal`.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from rimroll.bodies.body import Body
from rimroll.errors import RimrollError
from rimroll.ground.ground import Ground
from rimroll.laws import Law
from rimroll.many.falls import Column, Falls
from rimroll.options import Options
from rimroll.shaking.curve import Counts
from rimroll.shaking.lognormal import reached
from rimroll.shaking.many import follow_shaken
from rimroll.shaking.scales import rocking_frequency, tangent
from rimroll.state import State

Array = NDArray[np.float64]
Progress = Callable[[int, int], object]


MEASURES = {
    "pga": ("pga", "m/s^2", "peak ground acceleration", "PGA"),
    "pgv": ("pgv", "m/s", "peak ground velocity", "PGV"),
    "sa": ("sa", "m/s^2", "spectral acceleration", "Sa"),
    "pga_ratio": ("pga", "", "peak ground acceleration over g tan α", "PGA/(g tan α)"),
    "pgv_ratio": ("pgv", "", "p times peak ground velocity over g tan α", "p PGV/(g tan α)"),
}
"""The measures of intensity: the quantity of the ground, the unit, words and a symbol.

tan α is R/H, and p the rocking frequency of the body."""

HORIZONTAL_IN_WORDS = {"vector": "", "rotd50": ", RotD50", "geomean": ", geometric mean"}


@dataclass(frozen=True)
class Measure:
    """A measure of the intensity of the horizontal motion, one of :data:`MEASURES`.

    ``horizontal``, ``period`` and ``damping`` are those of ``Ground.intensity``.
    """

    name: str
    horizontal: str = "vector"
    period: float | None = None
    damping: float = 0.05

    @property
    def unit(self) -> str:
        """The SI unit, empty for a ratio."""
        return MEASURES[self.name][1]

    @property
    def long_name(self) -> str:
        """The measure in words."""
        period = "" if self.period is None else f" at {self.period:g} s"
        return MEASURES[self.name][2] + period + HORIZONTAL_IN_WORDS[self.horizontal]

    @property
    def symbol(self) -> str:
        """The measure as figures name it."""
        period = "" if self.period is None else f"({self.period:g} s)"
        return MEASURES[self.name][3] + period + HORIZONTAL_IN_WORDS[self.horizontal]

    def of(self, ground: Ground, body: Body, gravity: float) -> float:
        """The measure of a ground; ratios are those of a body."""
        quantity, unit, *_ = MEASURES[self.name]
        value = ground.intensity(
            quantity, self.horizontal, period=self.period, damping=self.damping
        )
        if unit:
            return value
        rate = rocking_frequency(body, gravity) if quantity == "pgv" else 1.0
        return float(rate * value / (gravity * tangent(body)))


DOUBLINGS = 5
"""How often the search for strong shaking doubles the lowest level."""

ENOUGH = 0.9
"""The part of the bodies that overturns at the upper end of the usual range."""


@dataclass(frozen=True)
class Rocking:
    """A body, how it starts, how it meets the table, and how its motions are followed.

    ``duration`` is None for the default of :func:`rimroll.shake_many`.
    """

    body: Body
    start: State
    law: Law
    options: Options
    duration: float | None = None
    limits: tuple[float | None, ...] = (None,)
    """The limit states: largest tilts over the balance tilt, and None for overturning."""
    threads: int | None = None

    def follow(
        self, grounds: Mapping[str, Ground], factors: Array, progress: Progress | None = None
    ) -> Falls:
        """The motions under each ground with each of its factors (grounds, k), in rows.

        The columns are those of :func:`rimroll.shake_many`. On Ctrl-C, ``Interrupted`` carries
        those that are done.
        """
        import xarray as xr

        return follow_shaken(
            self.body,
            self.start,
            self.law,
            grounds,
            scale=xr.DataArray(factors, dims=("ground", "level")),
            duration=self.duration,
            options=self.options,
            threads=self.threads,
            progress=progress,
        )

    def usual_levels(self, grounds: Mapping[str, Ground], measure: Measure, points: int) -> Array:
        """Usual levels of the measure (points,).

        They run from g R/H of horizontal acceleration, evenly to one that overturns nine tenths of
        the bodies, which is found by doubling; if none does, to that which overturns the most. A
        horizontal acceleration of g R/H is the weakest that lifts a body that stands flat, unless
        the ground also moves vertically, or friction is below R/H, where the body slides.
        """
        if math.isinf(tangent(self.body)):
            raise RimrollError("a disk stands on no base: give --intensities or --scale")
        strength = self.measured(grounds, measure)
        lifting = self.options.gravity * tangent(self.body) / self.measured(grounds, Measure("pga"))
        least = float((lifting * strength).min())
        doubled = least * 2.0 ** np.arange(DOUBLINGS + 1)
        severest = None if None in self.limits else max(filter(None, self.limits))
        parts = []
        for level in doubled:
            found = self.follow(grounds, level / strength[:, np.newaxis])
            far, undecided = reached(found, severest)
            parts.append(float(far.sum() / max(1, (~undecided).sum())))
            if parts[-1] >= ENOUGH:
                break
        highest = doubled[int(np.argmax(parts))] if max(parts) > 0.0 else doubled[2]
        lowest = least if highest > least else least / 8.0
        return np.linspace(lowest, highest, points)

    def measured(self, grounds: Mapping[str, Ground], measure: Measure) -> Array:
        """The measure of each ground; ``RimrollError`` for one where it is 0."""
        if math.isinf(tangent(self.body)) and not measure.unit:
            raise RimrollError(f"a disk has no {measure.symbol}: its balance tilt is 90°")
        gravity = self.options.gravity
        values = np.array([measure.of(one, self.body, gravity) for one in grounds.values()])
        for name, value in zip(grounds, values, strict=True):
            if not value > 0.0:
                raise RimrollError(f"{name} has no {measure.symbol}: it cannot be scaled")
        return values

    def laid_out(
        self,
        motions: Falls,
        grounds: Mapping[str, Ground],
        level: Column,
        axis: str,
        measure: Measure,
    ) -> Falls:
        """Motions in rows over ``ground`` and the axis of the levels, of the grounds that are done.

        The columns also have the PGA, the PGV and the measure of the scaled ground.
        """
        points = len(level.values)
        done = motions.size // points
        shape = (done, points)
        axes = {"ground": Column(np.array(list(grounds)[:done])), axis: level}
        columns = {
            name: replace(one, values=one.values.ravel()[: done * points].reshape(shape))
            for name, one in motions.columns.items()
            if name not in ("ground", "level")
        }
        for one in (Measure("pga"), Measure("pgv"), measure):
            peaks = [one.of(ground, self.body, self.options.gravity) for ground in grounds.values()]
            strength = np.array(peaks)[:done, np.newaxis] * columns["scale"].values
            columns[one.name] = Column(strength, one.unit, one.long_name)
        kept = {name: one for name, one in columns.items() if name not in axes}
        return Falls(kept, axes, motions.attrs)


def counts(motions: Falls, measure: Measure, limit: float | None) -> Counts:
    """The data of a fragility curve, one trial for each motion."""
    far, undecided = reached(motions, limit)
    if measure.name in motions.columns:
        intensity = motions[measure.name]
    else:
        intensity = np.broadcast_to(motions[measure.name], far.shape)
    fell, open_ = far.ravel().astype(np.float64), undecided.ravel().astype(np.float64)
    return Counts(intensity.ravel(), fell, np.ones(far.size), open_)
