"""The contact law that the options describe, with the law of a scenario file."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from rimroll import laws, surfaces
from rimroll.body import Body
from rimroll.cli.options import LawOptions, ResistanceOptions
from rimroll.errors import RimrollError, UnitError
from rimroll.laws import (
    AirDrag,
    Coulomb,
    Law,
    NoSlip,
    PivotingFriction,
    Resistance,
    RollingResistance,
    Stribeck,
    Viscous,
)
from rimroll.names import typed
from rimroll.scenario import FILM
from rimroll.units import LAW_UNIT_OF, air_unit, quantity

NUMBER_OF = {
    "friction": "friction",
    "static_friction": "static",
    "viscous_coefficient": "coefficient",
    "stribeck_speed": "stribeck_speed",
    "creep_speed": "creep_speed",
    "restitution": "restitution",
}
"""The number of a law that each option gives."""

OPTION_OF = {number: option for option, number in NUMBER_OF.items()}


def option(name: str) -> str:
    """The option of a field: ``--tilt-rate``."""
    return "--" + typed(name)


def law_asked(options: LawOptions, resistances: ResistanceOptions, law: Law | None) -> Law:
    """The law that options ask for, over that of a file; resistances are another matter.

    Raises ``RimrollError`` naming the option that is at fault.
    """
    numbers = _numbers(options, resistances)
    if options.surface is not None:
        return _surface(options, numbers)
    kind = _kind(options, numbers, type(law) if law else NoSlip)
    takes = laws.numbers_of(kind)
    for name in numbers:
        if name not in takes:
            known = ", ".join(map(_asked_by, takes)) or "no numbers"
            raise RimrollError(
                f"{option(OPTION_OF[name])} does not go with {typed(kind.name)}, which takes"
                f" {known}"
            )
    if law is not None and type(law) is kind:
        return replace(law, resistances=(), **numbers)
    for name, needed in takes.items():
        if needed and name not in numbers:
            raise RimrollError(f"{typed(kind.name)} needs {_asked_by(name)}")
    return laws.by_name(kind.name, numbers)


def _asked_by(name: str) -> str:
    """The option that gives a number of a law; tables are given in a file."""
    if name in laws.TABLES:
        return f"{name} from a scenario file"
    return option(OPTION_OF[name])


def _numbers(options: LawOptions, resistances: ResistanceOptions) -> dict[str, float]:
    given = {**vars(options), "restitution": resistances.restitution}
    return {
        number: _number(name, number, text)
        for name, number in NUMBER_OF.items()
        if (text := given[name]) is not None
    }


def _number(name: str, number: str, text: str) -> float:
    try:
        return quantity(text, LAW_UNIT_OF[number], option(name))
    except UnitError as error:
        word = text.strip().lower()
        if name not in ("friction", "static_friction") or not word[:1].isalpha() or _is_float(word):
            raise
        if word in surfaces.SURFACES:
            hint = f"for this table write --surface {word}"
        elif word.replace("-", "_") in laws.LAWS:
            hint = f"for this law write --law {word}"
        else:
            hint = f"the tables that have a name are {', '.join(surfaces.SURFACES)} (--surface)"
        raise RimrollError(f"{error}; {hint}") from None


def _is_float(word: str) -> bool:
    """Whether a word is a number, as ``nan`` and ``inf`` are."""
    try:
        float(word)
    except ValueError:
        return False
    return True


def _surface(options: LawOptions, numbers: Mapping[str, float]) -> Law:
    if options.law is not None and laws.kind(options.law) is not Coulomb:
        raise RimrollError(f"--surface is dry friction and --law is {options.law}: give one")
    for name in numbers:
        if name not in ("static", "restitution"):
            raise RimrollError(f"--surface and {option(OPTION_OF[name])}: give one")
    assert options.surface is not None
    return surfaces.by_name(options.surface, **numbers)


def _kind(options: LawOptions, numbers: Mapping[str, float], usual: type[Law]) -> type[Law]:
    """The kind of law that is named, or else implied by the numbers given."""
    if options.law is not None:
        return laws.kind(options.law)
    if all(name in laws.numbers_of(usual) for name in numbers):
        return usual
    if "stribeck_speed" in numbers or "creep_speed" in numbers:
        return Stribeck
    if "coefficient" in numbers:
        return Viscous
    return Coulomb if "friction" in numbers or "static" in numbers else usual


def with_resistances(law: Law, options: ResistanceOptions, body: Body, gravity: float) -> Law:
    """The law with the resistances that are asked for in place of those of the same kind."""
    kept: dict[type[Resistance], Resistance] = {type(item): item for item in law.resistances}
    for item in (
        _rolling(options, kept.get(RollingResistance)),
        _pivoting(options),
        _air(options, body, gravity),
    ):
        if item is not None:
            kept[type(item)] = item
    return replace(law, resistances=tuple(kept.values()))


def _rolling(options: ResistanceOptions, old: Resistance | None) -> RollingResistance | None:
    given = {}
    if options.rolling_resistance is not None:
        given["dry"] = quantity(options.rolling_resistance, "1", "--rolling-resistance")
    if options.rolling_viscous is not None:
        given["viscous"] = quantity(options.rolling_viscous, "N s/m", "--rolling-viscous")
    before = old if isinstance(old, RollingResistance) else RollingResistance()
    return replace(before, **given) if given else None


def _pivoting(options: ResistanceOptions) -> PivotingFriction | None:
    text = options.pivoting_friction
    return None if text is None else PivotingFriction(quantity(text, "m", "--pivoting-friction"))


def _air(options: ResistanceOptions, body: Body, gravity: float) -> AirDrag | None:
    exponent = AirDrag.exponent
    if options.air_exponent is not None:
        if options.air_drag is None:
            raise RimrollError("--air-exponent goes with --air-drag")
        exponent = quantity(options.air_exponent, "1", "--air-exponent")
    if options.air_drag is None:
        return None
    if options.air_drag == FILM:
        if options.air_exponent is not None:
            raise RimrollError("--air-drag film has its own exponent, 4: leave out --air-exponent")
        return AirDrag.film(body.radius, gravity=gravity)
    return AirDrag(quantity(options.air_drag, air_unit(exponent), "--air-drag"), exponent)


def in_words(law: Law) -> str:
    """A law as it is typed, its numbers, and its resistances: ``coulomb, friction 0.2``."""
    units = {name: "" if unit == "1" else unit for name, unit in LAW_UNIT_OF.items()}
    said = [typed(law.name)]
    for name in laws.numbers_of(type(law)):
        value = getattr(law, name)
        if value is not None and not (name == "restitution" and value == 0.0):
            amount = laws.in_brief(value)
            said.append(f"{name.replace('_', ' ')} {amount} {units[name]}".strip())
    return " + ".join([", ".join(said), *map(_resisting, law.resistances)])


def _resisting(resistance: Resistance) -> str:
    match resistance:
        case RollingResistance(dry, viscous):
            parts = [f"{dry:g}"] if dry or not viscous else []
            parts += [f"{viscous:g} N s/m"] if viscous else []
            return "rolling resistance " + " and ".join(parts)
        case PivotingFriction(length):
            return f"pivoting friction {length:g} m"
        case AirDrag(coefficient, exponent):
            return f"air drag {coefficient:g} {air_unit(exponent)}"
