"""The contact law that the options describe, with the law of a scenario file."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

from rimroll import laws
from rimroll.bodies.body import Body
from rimroll.cli.options import PARAMETERS, LawOptions, ResistanceOptions
from rimroll.errors import RimrollError, UnitError, typed
from rimroll.laws import (
    AirDrag,
    Coulomb,
    Law,
    NoSlip,
    PivotingFriction,
    Resistance,
    RollingResistance,
    surfaces,
)
from rimroll.scenario import RESISTANCES, resistance
from rimroll.units import Quantity, air_unit, quantities_of, quantity


def option(name: str) -> str:
    """The option of a field: ``--tilt-rate``."""
    return "--" + typed(name)


def requested_law(options: LawOptions, resistances: ResistanceOptions, law: Law | None) -> Law:
    """The law that options describe, or else that of a file; without the options' resistances.

    Raises ``RimrollError`` naming the option that is at fault.
    """
    given = _given(options, resistances)
    if options.surface is not None:
        return _surface(options, given)
    kind = _kind(options, given, type(law) if law else NoSlip)
    takes = _number_of(kind)
    for name in given:
        if name not in takes:
            known = ", ".join(map(_given_by, quantities_of(kind).items())) or "no numbers"
            raise RimrollError(
                f"{option(name)} does not go with {typed(kind.name)}, which takes {known}"
            )
    numbers = {takes[name]: value for name, value in given.items()}
    if law is not None and type(law) is kind:
        return replace(law, resistances=(), **numbers)
    for item in quantities_of(kind).items():
        if item[1].required and item[0] not in numbers:
            raise RimrollError(f"{typed(kind.name)} needs {_given_by(item)}")
    return laws.by_name(kind.name, numbers)


def _number_of(kind: type[Law]) -> dict[str, str]:
    """The numbers of a law by the options that give them."""
    return {
        parameter.option: name
        for name, parameter in quantities_of(kind).items()
        if not parameter.is_list
    }


def _given_by(item: tuple[str, Quantity]) -> str:
    """The option that gives a number of a law; tables are given in a file."""
    name, parameter = item
    return f"{name} from a scenario file" if parameter.is_list else option(parameter.option)


def _given(options: LawOptions, resistances: ResistanceOptions) -> dict[str, float]:
    """The numbers of laws that are given, by option."""
    texts = {**vars(options), "restitution": resistances.restitution}
    return {
        name: _number(name, parameter.unit, text)
        for name, parameter in PARAMETERS.items()
        if (text := texts[name]) is not None
    }


def _number(name: str, unit: str, text: str) -> float:
    try:
        return quantity(text, unit, option(name))
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
        raise error.with_hint(f"; {hint}") from None


def _is_float(word: str) -> bool:
    """Whether a word is a number, as ``nan`` and ``inf`` are."""
    try:
        float(word)
    except ValueError:
        return False
    return True


def _surface(options: LawOptions, given: Mapping[str, float]) -> Law:
    if options.law is not None and laws.kind(options.law) is not Coulomb:
        raise RimrollError(f"--surface is dry friction and --law is {options.law}: give one")
    takes = _number_of(Coulomb)
    for name in given:
        if takes.get(name) not in ("static", "restitution"):
            raise RimrollError(f"--surface and {option(name)}: give one")
    assert options.surface is not None
    return surfaces.by_name(options.surface, **{takes[name]: given[name] for name in given})


def _kind(options: LawOptions, given: Mapping[str, float], usual: type[Law]) -> type[Law]:
    """The kind of law that is named, or else implied by the options given."""
    if options.law is not None:
        return laws.kind(options.law)
    if all(name in _number_of(usual) for name in given):
        return usual
    takers = [
        [law for law in laws.LAWS.values() if name in _number_of(law)]
        for name in given
        if name != "restitution"
    ]
    if not takers:
        return usual
    fitting = [law for law in laws.LAWS.values() if all(law in each for each in takers)]
    if fitting:
        return fitting[0]
    # A law to which one of them belongs: the error says which options that law takes.
    owners = [each[0] for each in takers if len(each) == 1]
    return owners[-1] if owners else usual


def with_resistances(law: Law, options: ResistanceOptions, body: Body, gravity: float) -> Law:
    """The law with the resistances of the options, which replace those of the same kind."""
    kept: dict[type[Resistance], Resistance] = {type(item): item for item in law.resistances}
    for kind in RESISTANCES.values():
        given = {
            name: text
            for name, one in quantities_of(kind).items()
            if (text := getattr(options, one.option)) is not None
        }
        if given:
            kept[kind] = _resistance(kind, given, kept.get(kind), body, gravity)
    found = tuple(kept.values())
    return law if found == law.resistances else replace(law, resistances=found)


def _resistance(
    kind: type[Resistance],
    given: Mapping[str, str],
    before: Resistance | None,
    body: Body,
    gravity: float,
) -> Resistance:
    """A resistance of some options; one without required numbers keeps its others."""
    numbers = quantities_of(kind)

    def called(name: str) -> str:
        return option(numbers[name].option)

    required = [name for name, one in numbers.items() if one.required]
    for name in required:
        if name not in given:
            raise RimrollError(f"{called(next(iter(given)))} needs {called(name)}")
    found = resistance(kind, given, body, gravity, called)
    if before is None or required:
        return found
    changes: dict[str, Any] = {name: getattr(found, name) for name in given}
    return replace(before, **changes)


def in_words(law: Law) -> str:
    """A law as it is typed, its numbers, and its resistances: ``coulomb, friction 0.2``."""
    words = [typed(law.name)]
    for name, parameter in quantities_of(type(law)).items():
        value = getattr(law, name)
        if value is not None and not (name == "restitution" and value == 0.0):
            unit = "" if parameter.unit == "1" else parameter.unit
            words.append(f"{name.replace('_', ' ')} {laws.in_brief(value)} {unit}".strip())
    return " + ".join([", ".join(words), *map(_resisting, law.resistances)])


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
