"""The tables of a scenario file, and their errors."""

from __future__ import annotations

import inspect
import json
import tomllib
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from functools import cache, partial
from pathlib import Path
from typing import Annotated, Any, TypeVar

from pydantic import (
    BaseModel,
    BeforeValidator,
    ConfigDict,
    Field,
    ValidationError,
    ValidationInfo,
    create_model,
)
from pydantic_core import ErrorDetails

from rimroll import laws
from rimroll.bodies import solids
from rimroll.bodies.body import Body
from rimroll.errors import RimrollError, choose, nearest, typed
from rimroll.ground.described import CHANGES, NUMBERS, Description
from rimroll.ground.ground import Ground
from rimroll.laws import Coulomb, Law, NoSlip, Resistance, surfaces
from rimroll.options import FlatLanding, Options, landing_given
from rimroll.scenario.scenario import (
    AFTER,
    MAX_STEPS,
    RESISTANCES,
    Scenario,
    presets,
    resistance,
)
from rimroll.state import START_NUMBERS, State
from rimroll.units import Quantity, quantities_of, quantity

SOLIDS: dict[str, Callable[..., solids.Solid]] = {
    "cylinder": solids.cylinder,
    "hollow_cylinder": solids.hollow_cylinder,
    "disk": solids.disk,
    "ring": solids.ring,
    "wall": solids.wall,
    "box": solids.box,
    "filling": solids.filling,
    "solid": solids.Solid,
}
"""The kinds of [[body.solids]]; "solid" is a part given by its four numbers."""


@dataclass(frozen=True)
class _Shown:
    """A value that messages show as it is written in the file."""

    value: object

    def __repr__(self) -> str:
        return as_toml(self.value)


def readable(value: object) -> object:
    """A number or text unchanged; another value in a form that messages show as TOML."""
    known = isinstance(value, str | int | float) and not isinstance(value, bool)
    return value if known else _Shown(value)


def as_toml(value: object) -> str:
    """A value in TOML: ``true``, ``"text"``, ``[1, 2]``, ``{ a = 1 }``."""
    match value:
        case bool():
            return str(value).lower()
        case str():
            return json.dumps(value, ensure_ascii=False)
        case list():
            return f"[{', '.join(map(as_toml, value))}]"
        case dict():
            items = ", ".join(f"{key} = {as_toml(item)}" for key, item in value.items())
            return f"{{ {items} }}" if items else "{}"
        case _:
            return str(value)


def in_unit(unit: str) -> BeforeValidator:
    """Reads a field of a table as a quantity in an SI unit."""
    return reading(Quantity(unit))


def reading(number: Quantity) -> BeforeValidator:
    """Reads a field of a table as this number."""

    def read(value: object, info: ValidationInfo) -> float:
        return number.read(readable(value), info.field_name or "the value")

    return BeforeValidator(read)


class Table(BaseModel):
    """A table of the file, without unknown keys and without silent conversions."""

    model_config = ConfigDict(extra="forbid", strict=True, frozen=True)


T = TypeVar("T")
TableT = TypeVar("TableT", bound=Table)


class _File(Table):
    body: dict[str, Any]
    start: dict[str, Any] | None = None
    law: Any = NoSlip.name
    ground: dict[str, Any] | None = None
    simulation: dict[str, Any] = {}


def defaults_of(function: Callable[..., object]) -> dict[str, Any]:
    """The arguments of a function that may be left out, and what they are then."""
    arguments = inspect.signature(function).parameters.values()
    return {one.name: one.default for one in arguments if one.default is not one.empty}


def fields_of(numbers: Mapping[str, Quantity], defaults: Mapping[str, Any]) -> dict[str, Any]:
    """The fields of a table with these numbers; those without a default must be there."""
    fields: dict[str, Any] = {}
    for name, number in numbers.items():
        hint: Any = Annotated[float, reading(number)]
        if number.is_list:
            hint = list[hint]
        default = defaults.get(name, ...)
        fields[name] = (hint if default is not None else hint | None, default)
    return fields


StartTable = create_model("start", __base__=Table, **fields_of(START_NUMBERS, defaults_of(State)))


class _Simulation(Table):
    max_steps: Annotated[int, Field(gt=0, le=MAX_STEPS)] = Options.max_steps
    flat: Any = None


SimulationTable = create_model(
    "simulation", __base__=_Simulation, **fields_of(quantities_of(Options), defaults_of(Options))
)


def in_three(unit: str) -> BeforeValidator:
    """Reads a quantity in an SI unit, or a list of three (x, y, z)."""

    def read(value: object, info: ValidationInfo) -> float | list[float]:
        name = info.field_name or "the value"
        if not isinstance(value, list):
            return quantity(readable(value), unit, name)
        if len(value) != 3:
            raise RimrollError(f"must be one or three, x, y and z, got {as_toml(value)}", name)
        return [quantity(readable(one), unit, name) for one in value]

    return BeforeValidator(read)


class _GroundTable(Table):
    record: str | list[str] = []
    headings: list[str] | None = None
    units: str | None = None
    component: str | None = None
    pad: bool = False
    columns: dict[str, str | int] | None = None
    step: Annotated[float | None, in_unit("s")] = None
    time_unit: str | None = None
    pulse: str | None = None


_OF_PULSES: dict[str, Any] = {
    name: (Annotated[Any, in_three(one.unit)], None) for name, one in NUMBERS.items()
}
GroundTable = create_model(
    "ground",
    __base__=_GroundTable,
    **_OF_PULSES,
    **fields_of(CHANGES, dict.fromkeys(CHANGES)),
)


class _Composed(Table):
    radius: Annotated[float, reading(solids.SIZES["radius"])]
    solids: list[dict[str, Any]]


@cache
def arguments_of(function: Callable[..., object]) -> type[Table]:
    """A table with a field for each argument of a function that describes a body or a solid."""
    numbers = {name: solids.SIZES[name] for name in inspect.signature(function).parameters}
    fields = fields_of(numbers, defaults_of(function))
    return create_model(function.__name__, __base__=Table, **fields)


def read(file: Path) -> dict[str, Any]:
    """The content of a TOML file."""
    try:
        text = file.read_bytes().decode("utf-8-sig")
    except FileNotFoundError:
        raise RimrollError("there is no such file") from None
    except OSError as error:
        raise RimrollError(f"cannot be read: {error.strerror}") from None
    except UnicodeDecodeError:
        raise RimrollError("cannot be read: it is not a text in UTF-8") from None
    try:
        return tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        raise RimrollError(f"is not valid TOML: {error}") from None


def scenario(content: dict[str, Any], folder: Path = Path()) -> Scenario:
    """The scenario that the content of a file in that folder describes."""
    if "body" not in content and content.keys() <= _File.model_fields.keys():
        what = "has no table [body]" if content else "is empty"
        raise RimrollError(f'{what}: write what rolls, such as [body] and preset = "can_2007"')
    file = checked(_File, content, "")
    start = None
    if file.start is not None:
        table = checked(StartTable, file.start, "[start]")
        start = made("[start]", lambda: State(**table.model_dump()))
    simulation = checked(SimulationTable, file.simulation, "[simulation]")
    body = read_body(file.body)
    options = Options(**simulation.model_dump(exclude={"flat"}))
    ground = None if file.ground is None else read_ground(file.ground, folder)
    has_duration = "duration" in simulation.model_fields_set
    if ground is not None and not has_duration:
        options = replace(options, duration=ground.duration + AFTER)
    if simulation.flat is not None:
        flat = made("[simulation]", lambda: read_flat(simulation.flat, ground is not None))
        options = replace(options, flat=flat)
    return Scenario(
        body=body,
        start=start,
        law=read_law(file.law, body, options.gravity),
        options=options,
        ground=ground,
        has_duration=has_duration,
    )


def read_flat(given: object, moves: bool) -> FlatLanding:
    """What follows a flat landing: a text, a number, or a list of "smooth" and a seed."""
    return landing_given(tuple(given) if isinstance(given, list) else given, moves)


def read_ground(given: dict[str, Any], folder: Path) -> Ground:
    """The ground of a table; paths of records are relative to the folder of the file."""
    table = checked(GroundTable, given, "[ground]")
    names = [table.record] if isinstance(table.record, str) else table.record
    numbers = {name: value for name in NUMBERS if (value := getattr(table, name)) is not None}
    description = Description(
        record=[folder / name for name in names],
        pulse=table.pulse,
        numbers=numbers,
        **{
            name: getattr(table, name)
            for name in ("scale", "rotation", "headings", "units", "component", "pad")
        },
    )
    ground = made("[ground]", description.made)
    if ground is None:
        raise RimrollError("[ground] lacks 'record' or 'pulse'")
    return ground


def read_law(given: object, body: Body, gravity: float) -> Law:
    """The law of a name or of a table, with its resistances."""
    if isinstance(given, str):
        kind = laws.kind(given)
        missing = [name for name, one in quantities_of(kind).items() if one.required]
        if missing:
            table = f'a table [law] with kind = "{typed(kind.name)}" and {missing[0]}'
            raise RimrollError(f'law = "{given}" lacks {missing[0]!r}: write {table}')
        return kind()
    if not isinstance(given, dict):
        raise RimrollError(f"must be a text or a table, got {as_toml(given)}", "law")
    law = _contact({key: value for key, value in given.items() if key not in RESISTANCES})
    for name in RESISTANCES:
        if name in given:
            resistance = _resistance(name, given[name], body, gravity)
            law = made("[law]", partial(law.__add__, resistance))
    return law


def _contact(table: dict[str, Any]) -> Law:
    """The law of a table by its kind or its surface."""
    if "kind" in table and "surface" in table:
        raise RimrollError("[law] has both a kind and a surface: give one")
    key = "surface" if "surface" in table else "kind"
    choices = ", ".join(map(typed, laws.LAWS))
    if key not in table:
        raise RimrollError(f"[law] lacks 'kind': one of {choices}; or a surface")
    name = table[key]
    if not isinstance(name, str):
        raise RimrollError(f"[law] {key} must be a text, got {as_toml(name)}")
    rest = {other: value for other, value in table.items() if other != key}
    where = f'[law] of {key} "{name}"'
    if key == "surface":
        surface = made("[law]", lambda: choose("surface", name, surfaces.SURFACES))
        sticking = checked(_numbers_of(Coulomb, "friction"), rest, where, *RESISTANCES)
        return made("[law]", lambda: surface(**sticking.model_dump(exclude_unset=True)))
    kind = made("[law]", lambda: laws.kind(name))
    numbers = checked(_numbers_of(kind), rest, where, *RESISTANCES)
    given = numbers.model_dump(exclude_unset=True)
    return made("[law]", lambda: laws.by_name(name, given))


def _numbers_of(kind: type[Law], *but: str) -> type[Table]:
    """A table with the numbers of a law, without some; the law says which are missing."""
    numbers = {name: one for name, one in quantities_of(kind).items() if name not in but}
    return create_model("law", __base__=Table, **fields_of(numbers, dict.fromkeys(numbers)))


def _resistance(name: str, given: object, body: Body, gravity: float) -> Resistance:
    where, kind = f"[law.{name}]", RESISTANCES[name]
    if not isinstance(given, dict):
        raise RimrollError(f"[law] {name} must be a table, got {as_toml(given)}")
    fields = {key: (Any, ... if one.required else None) for key, one in quantities_of(kind).items()}
    table = checked(create_model(name, __base__=Table, **fields), given, where)  # type: ignore[call-overload]
    numbers = {key: readable(getattr(table, key)) for key in table.model_fields_set}
    if not numbers:
        raise RimrollError(f"{where} lacks {' or '.join(map(repr, fields))}")
    return made(where, lambda: resistance(kind, numbers, body, gravity))


def read_body(table: dict[str, Any]) -> Body:
    if "preset" in table:
        name = table["preset"]
        if not isinstance(name, str):
            raise RimrollError(f"[body] preset must be a text, got {as_toml(name)}")
        function = made("[body]", lambda: choose("preset", name, presets()))
        rest = {key: value for key, value in table.items() if key != "preset"}
        arguments = checked(arguments_of(function), rest, f'[body] with preset "{name}"')
        return made("[body]", lambda: function(**arguments.model_dump()))
    if "solids" in table:
        composed = checked(_Composed, table, "[body] with solids")
        parts = [_solid(part, f"[[body.solids]] {i}") for i, part in enumerate(composed.solids, 1)]
        return made("[body]", lambda: Body.from_solids(composed.radius, parts))
    if not table:
        raise RimrollError("[body] is empty: give preset, solids or the five numbers of a body")
    numbers = checked(arguments_of(Body), table, "[body]", "preset", "solids")
    return made("[body]", lambda: Body(**numbers.model_dump()))


def _solid(table: dict[str, Any], where: str) -> solids.Solid:
    kind = table.get("kind")
    if not isinstance(kind, str):
        raise RimrollError(f"{where} needs a kind: one of {', '.join(SOLIDS)}")
    function = made(where, lambda: choose("kind", kind, SOLIDS))
    rest = {key: value for key, value in table.items() if key != "kind"}
    arguments = checked(arguments_of(function), rest, f'{where} of kind "{kind}"')
    return made(where, lambda: function(**arguments.model_dump()))


def made(where: str, make: Callable[[], T]) -> T:
    """The result of ``make``; its error names the place in the file."""
    try:
        return make()
    except RimrollError as error:
        raise error.inside(where) from None


def checked(model: type[TableT], table: dict[str, Any], where: str, *other_keys: str) -> TableT:
    """The table as a model; its first error is a ``RimrollError``."""
    try:
        return model.model_validate(table)
    except ValidationError as error:
        # A misspelt key is also a missing key; the misspelling is the better message.
        problems = sorted(error.errors(), key=lambda found: found["type"] != "extra_forbidden")
    known = [*model.model_fields, *other_keys]
    raise _problem(problems[0], known).inside(where)


def _problem(found: ErrorDetails, known: list[str]) -> RimrollError:
    """An error of pydantic, in our words where possible."""
    key, value = ".".join(str(part) for part in found["loc"]), found["input"]
    match found["type"]:
        case "extra_forbidden":
            return RimrollError(f"has an unknown key {key!r}{nearest(key, known)}")
        case "missing":
            return RimrollError(f"lacks {key!r}")
        case "value_error" if isinstance(error := found["ctx"]["error"], RimrollError):
            return error  # of a quantity, which names the field
        case "dict_type" | "list_type" | "string_type" | "int_type" as kind:
            bound = f"a {_KINDS[kind]}"
            return RimrollError(f"must be {bound}, got {as_toml(value)}", key, value, bound)
        case _:
            return RimrollError(f"is {as_toml(value)}: {found['msg'].lower()}", key, value)


_KINDS = {
    "dict_type": "table",
    "list_type": "list of tables",
    "string_type": "text",
    "int_type": "whole number",
}
