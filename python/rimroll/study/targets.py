"""What of a study can vary: the keys of its tables, as ``law.friction``, with their units."""

from __future__ import annotations

import inspect
from collections.abc import Mapping
from dataclasses import fields
from functools import cache

from rimroll.body import Body
from rimroll.errors import RimrollError
from rimroll.experiment.release import Release
from rimroll.ground.described import NUMBERS
from rimroll.laws import LAWS, parameters_of
from rimroll.names import nearest
from rimroll.scenario import RESISTANCES, presets
from rimroll.units import START_UNIT_OF, UNIT_OF

SPREAD = "_spread"
"""The end of the name of a standard deviation of a release."""


@cache
def targets() -> Mapping[str, str | None]:
    """The keys that can vary and their SI units; None for those whose values are not numbers."""
    return {
        **_body(),
        **_law(),
        **{f"start.{name}": unit for name, unit in START_UNIT_OF.items()},
        **_release(),
        **_ground(),
        "fit.falls": "1",
        "fit.reading_error": "rad",
        "fit.bias": "rad",
        "simulation.gravity": "m/s^2",
        "simulation.duration": "s",
        "simulation.rtol": "1",
        "simulation.topple_tilt": "rad",
        "simulation.flat": None,
        "simulation.flat_gap": "m",
    }


def unit_of(target: str) -> str | None:
    """The SI unit of a key, None for words and tables; ``RimrollError`` for an unknown key."""
    known = targets()
    if target not in known:
        section = target.partition(".")[0]
        near = [name for name in known if name.partition(".")[0] == section] or list(known)
        raise RimrollError(f"unknown quantity {target!r}{nearest(target, near)}")
    return known[target]


def _body() -> dict[str, str | None]:
    numbers = [field.name for field in fields(Body)]
    arguments = {name for make in presets().values() for name in inspect.signature(make).parameters}
    return {
        "body": None,
        "body.preset": None,
        **{f"body.{name}": UNIT_OF[name] for name in (*numbers, *sorted(arguments))},
        **{f"body.factors.{name}": "1" for name in numbers},
    }


def _law() -> dict[str, str | None]:
    found: dict[str, str | None] = {"law": None, "law.kind": None, "law.surface": None}
    for kind in LAWS.values():
        for name, parameter in parameters_of(kind).items():
            found[f"law.{name}"] = None if parameter.is_list else parameter.unit
    for table, resistance in RESISTANCES.items():
        for name, parameter in parameters_of(resistance).items():
            found[f"law.{table}.{name}"] = parameter.unit
    return found


def _release() -> dict[str, str | None]:
    found: dict[str, str | None] = {"release": None, "release.preset": None}
    for field in fields(Release):
        unit = "1" if field.name == "friction_scale" else START_UNIT_OF.get(field.name, "rad/s")
        found |= {f"release.{field.name}": unit, f"release.{field.name}{SPREAD}": unit}
    return found | {"release.unsteadiness": "1"}


def _ground() -> dict[str, str | None]:
    return {
        "ground": None,
        "ground.record": None,
        "ground.pulse": None,
        "ground.synthetic": "1",
        **{f"ground.{name}": unit for name, unit in NUMBERS.items()},
        "ground.scale": "1",
        "ground.rotation": "rad",
    }
