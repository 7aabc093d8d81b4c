"""What ``rimroll fragility`` computes: motions over records and levels, and their curve."""

from __future__ import annotations

import warnings
from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from rimroll.cli.records import Levels
from rimroll.cli.request import Request
from rimroll.cli.screen import working
from rimroll.errors import RimrollError
from rimroll.falls import Column, Falls, Interrupted
from rimroll.ground.ground import Ground
from rimroll.shaking.incremental import MEASURES, Rocking, laid_out, measured
from rimroll.shaking.lognormal import Fragility, UndecidedWarning, reached
from rimroll.shaking.lognormal import fragility as fitted

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
class Study:
    """Motions over records and levels, and the curve that fits them, or why there is none."""

    request: Request
    rocking: Rocking
    levels: Levels
    grounds: Mapping[str, Ground]
    motions: Falls
    curve: Fragility | None
    why_not: str

    @property
    def axis(self) -> str:
        """The name of the dimension of the levels."""
        return list(self.motions.axes)[1]

    def done(self) -> dict[str, Ground]:
        """The records whose motions are all done."""
        return {name: self.grounds[name] for name in map(str, self.motions["ground"])}

    def rows(self) -> list[dict[str, Any]]:
        """What became of the motions at each level."""
        far, undecided = reached(self.motions, self.rocking.limit)
        return [
            {
                self.axis: float(value),
                "motions": len(far),
                "overturned": int(self.motions["overturned"][:, place].sum()),
                "failed": int(far[:, place].sum()),
                "undecided": int(undecided[:, place].sum()),
            }
            for place, value in enumerate(self.motions[self.axis])
        ]

    def undecided(self) -> Counter[str]:
        """How many of the motions that are undecided ended in which status."""
        _, undecided = reached(self.motions, self.rocking.limit)
        return Counter(map(str, self.motions["status"][undecided].tolist()))


def follow(
    what: Request, rocking: Rocking, asked: Levels, grounds: Mapping[str, Ground]
) -> tuple[Study, bool]:
    """The motions and their curve, and whether Ctrl-C cut them short."""
    measure, levels = asked.measure, asked.values
    with working(f"shaking {what.name}") as bar:
        strength = measured(grounds, measure)
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
    motions = laid_out(found, grounds, level, axis)
    curve, why_not = _fitted(motions, asked, rocking.limit)
    named = {"body": what.name, **attrs, **_numbers(curve)}
    motions = motions.with_attrs(named)
    return Study(what, rocking, asked, grounds, motions, curve, why_not), "interrupted" in attrs


def _fitted(motions: Falls, asked: Levels, limit: float | None) -> tuple[Fragility | None, str]:
    """The curve, or None and why there is none."""
    dataset = motions.to_xarray()
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", UndecidedWarning)  # the answer counts them
        try:
            return fitted(dataset, dataset[asked.measure.name], limit=limit), ""
        except RimrollError as error:
            return None, str(error)


def _numbers(curve: Fragility | None) -> dict[str, Any]:
    """The numbers of a curve in the attributes of a file."""
    found = {} if curve is None else {name: getattr(curve, name) for name in OF_CURVE}
    return {f"fragility_{name}": value for name, value in found.items() if value is not None}


def answer(study: Study) -> dict[str, Any]:
    """The study without its single motions, as a dictionary in SI units."""
    measure, curve = study.levels.measure, study.curve
    return {
        "parameters": study.motions.attrs,
        "measure": measure.name,
        "unit": measure.unit,
        "limit": study.rocking.limit,
        "records": {
            name: {"duration": ground.duration, **{m.name: m.of(ground) for m in MEASURES.values()}}
            for name, ground in study.done().items()
        },
        "levels": study.rows(),
        "curve": None if curve is None else {name: getattr(curve, name) for name in OF_CURVE},
        "why_no_curve": study.why_not or None,
        "undecided": dict(study.undecided()),
    }
