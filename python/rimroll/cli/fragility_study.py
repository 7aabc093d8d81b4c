"""What ``rimroll fragility`` computes: motions over records and levels, and their curve."""

from __future__ import annotations

import warnings
from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from rimroll.cli.records import Levels
from rimroll.cli.request import Request
from rimroll.cli.screen import working
from rimroll.errors import RimrollError
from rimroll.ground.ground import Ground
from rimroll.many.falls import Column, Falls, Interrupted
from rimroll.shaking.incremental import Measure, Rocking
from rimroll.shaking.lognormal import Fragility, UndecidedWarning, reached
from rimroll.shaking.lognormal import fragility as fitted

Flags = NDArray[np.bool_]

OF_CURVE = (
    "median",
    "dispersion",
    "median_interval",
    "dispersion_interval",
    "level",
    "method",
    "records",
)
"""What files and JSON say of a :class:`Fragility`."""


@dataclass(frozen=True)
class LimitState:
    """A limit state: the curve that fits the motions, or why there is none."""

    limit: float | None
    """The largest tilt over the balance tilt; None for overturning."""
    failed: Flags
    """Which motions reached it (records, levels)."""
    is_open: Flags
    """Which of the motions are undecided."""
    undecided: Counter[str]
    """How many motions that are undecided ended in which status."""
    curve: Fragility | None
    why_not: str

    @classmethod
    def of(cls, motions: Falls, measure: str, limit: float | None) -> LimitState:
        """The limit state of motions over records and levels."""
        failed, is_open = reached(motions, limit)
        undecided = Counter(map(str, motions["status"][is_open].tolist()))
        curve, why_not = _fitted(motions, measure, limit)
        return cls(limit, failed, is_open, undecided, curve, why_not)

    def rows(self, study: Study) -> list[dict[str, Any]]:
        """What became of the motions at each level."""
        return [
            {
                study.axis: float(value),
                "motions": len(self.failed),
                "overturned": int(study.motions["overturned"][:, place].sum()),
                "failed": int(self.failed[:, place].sum()),
                "undecided": int(self.is_open[:, place].sum()),
            }
            for place, value in enumerate(study.motions[study.axis])
        ]


@dataclass(frozen=True)
class Study:
    """Motions over records and levels, and their limit states."""

    request: Request
    rocking: Rocking
    levels: Levels
    grounds: Mapping[str, Ground]
    motions: Falls
    states: tuple[LimitState, ...]

    @property
    def axis(self) -> str:
        """The name of the dimension of the levels."""
        return list(self.motions.axes)[1]

    def done(self) -> dict[str, Ground]:
        """The records whose motions are all done."""
        return {name: self.grounds[name] for name in map(str, self.motions["ground"])}


def follow(
    what: Request, rocking: Rocking, asked: Levels, grounds: Mapping[str, Ground]
) -> tuple[Study, bool]:
    """The motions and their curve, and whether Ctrl-C cut them short."""
    measure, levels = asked.measure, asked.values
    with working(f"shaking {what.name}") as bar:
        strength = rocking.measured(grounds, measure)
        if levels is None:
            bar(0, 1, "how strong?")
            levels = rocking.usual_levels(grounds, measure, asked.points)
        factors = np.broadcast_to(levels, (len(grounds), len(levels)))
        if not asked.are_factors:
            factors = levels / strength[:, np.newaxis]
        attrs: dict[str, Any] = {"records": len(grounds)}
        try:
            found = rocking.follow(grounds, factors, lambda done, total: bar(done, total, ""))
        except Interrupted as interrupted:
            found = interrupted.falls
            done = found.size // len(levels)
            if done == 0:
                raise
            attrs["interrupted"] = f"after {done} of {len(grounds)} records"
    axis, level = measure.name, Column(levels, measure.unit, measure.long_name)
    if asked.are_factors:
        axis, level = "scale", Column(levels, "", "factor on the acceleration of the ground")
    motions = rocking.laid_out(found, grounds, level, axis, measure)
    states = tuple(LimitState.of(motions, measure.name, limit) for limit in rocking.limits)
    named = {"body": what.name, **attrs, **_numbers(states[0].curve)}
    motions = motions.with_attrs(named)
    return Study(what, rocking, asked, grounds, motions, states), "interrupted" in attrs


def _fitted(motions: Falls, measure: str, limit: float | None) -> tuple[Fragility | None, str]:
    """The curve, or None and why there is none."""
    dataset = motions.to_xarray()
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", UndecidedWarning)  # the answer counts them
        try:
            return fitted(dataset, dataset[measure], limit=limit), ""
        except RimrollError as error:
            return None, str(error)


def _numbers(curve: Fragility | None) -> dict[str, Any]:
    """The numbers of a curve in the attributes of a file."""
    found = {} if curve is None else {name: getattr(curve, name) for name in OF_CURVE}
    return {f"fragility_{name}": value for name, value in found.items() if value is not None}


def answer(study: Study) -> dict[str, Any]:
    """The study without its single motions, as a dictionary in SI units.

    The first limit state is at the top, too.
    """
    measure, rocking = study.levels.measure, study.rocking
    states = [_state(study, one) for one in study.states]
    return {
        "parameters": study.motions.attrs,
        "measure": measure.name,
        "horizontal": measure.horizontal,
        "unit": measure.unit,
        "records": {
            name: {
                "duration": ground.duration,
                **{
                    one.name: one.of(ground, rocking.body, rocking.options.gravity)
                    for one in (Measure("pga"), Measure("pgv"), measure)
                },
            }
            for name, ground in study.done().items()
        },
        **states[0],
        "limit_states": states,
    }


def _state(study: Study, one: LimitState) -> dict[str, Any]:
    curve = one.curve
    return {
        "limit": one.limit,
        "levels": one.rows(study),
        "curve": None if curve is None else {name: getattr(curve, name) for name in OF_CURVE},
        "why_no_curve": one.why_not or None,
        "undecided": dict(one.undecided),
    }
