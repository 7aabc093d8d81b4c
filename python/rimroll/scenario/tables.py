"""The tables of a scenario file, and what is wrong with them when something is."""

from __future__ import annotations

import difflib
import inspect
import tomllib
from collections.abc import Callable, Mapping
from functools import cache
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

from rimroll import laws, solids
from rimroll.body import Body
from rimroll.errors import RimrollError
from rimroll.laws import NoSlip
from rimroll.scenario import MOST_STEPS, UNIT_OF, Options, Scenario, presets
from rimroll.state import State
from rimroll.units import quantity, tilt_angle

SOLIDS: dict[str, Callable[..., solids.Solid]] = {
    "cylinder": solids.cylinder,
    "hollow_cylinder": solids.hollow_cylinder,
    "disc": solids.disc,
    "ring": solids.ring,
    "wall": solids.wall,
    "filling": solids.filling,
    "solid": solids.Solid,
}
"""What [[body.solids]] may be; "solid" is a part given by its four numbers."""


def _in(unit: str) -> BeforeValidator:
    """Reads a field of a table as a quantity in an SI unit."""

    def read(value: object, info: ValidationInfo) -> float:
        return quantity(value, unit, info.field_name or "the value")

    return BeforeValidator(read)


def _tilt(value: object, info: ValidationInfo) -> float:
    return tilt_angle(value, info.field_name or "the tilt")


Angle = Annotated[float, _in("rad")]
Tilt = Annotated[float, BeforeValidator(_tilt)]
AngularRate = Annotated[float, _in("rad/s")]


class _Table(BaseModel):
    """A table of the file: nothing unknown, nothing converted behind one's back."""

    model_config = ConfigDict(extra="forbid", strict=True, frozen=True)


T = TypeVar("T")
TableT = TypeVar("TableT", bound=_Table)


class _File(_Table):
    body: dict[str, Any]
    start: dict[str, Any] | None = None
    law: str = NoSlip.name
    simulation: dict[str, Any] = {}


class _Start(_Table):
    tilt: Tilt
    tilt_rate: AngularRate = 0.0
    yaw: Angle = 0.0
    yaw_rate: AngularRate = 0.0
    spin: Angle = 0.0
    spin_rate: AngularRate = 0.0


class _Simulation(_Table):
    duration: Annotated[float, _in("s")] = Options.duration
    gravity: Annotated[float, _in("m/s^2")] = Options.gravity
    rtol: Annotated[float, _in("1")] = Options.rtol
    topple_tilt: Tilt | None = None
    max_steps: Annotated[int, Field(gt=0, le=MOST_STEPS)] = Options.max_steps


class _Numbers(_Table):
    mass: Annotated[float, _in("kg")]
    radius: Annotated[float, _in("m")]
    height: Annotated[float, _in("m")]
    transverse_inertia: Annotated[float, _in("kg m^2")]
    axial_inertia: Annotated[float, _in("kg m^2")]


class _Composed(_Table):
    radius: Annotated[float, _in("m")]
    solids: list[dict[str, Any]]


@cache
def _arguments_of(function: Callable[..., object]) -> type[_Table]:
    """A table with a field for each argument of a function that describes a body or a solid."""
    fields: dict[str, Any] = {
        name: (
            Annotated[float, _in(UNIT_OF[name])],
            ... if parameter.default is parameter.empty else parameter.default,
        )
        for name, parameter in inspect.signature(function).parameters.items()
    }
    return create_model(function.__name__, __base__=_Table, **fields)


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


def scenario(content: dict[str, Any]) -> Scenario:
    """What the content of a scenario file describes."""
    file = _checked(_File, content, "")
    start = None
    if file.start is not None:
        table = _checked(_Start, file.start, "[start]")
        start = _made("[start]", lambda: State(**table.model_dump()))
    simulation = _checked(_Simulation, file.simulation, "[simulation]")
    return Scenario(
        body=_body(file.body),
        start=start,
        law=laws.by_name(file.law),
        options=Options(**simulation.model_dump()),
    )


def _body(table: dict[str, Any]) -> Body:
    if "preset" in table:
        name = table["preset"]
        if not isinstance(name, str):
            raise RimrollError(f"[body] preset must be a text, got {name!r}")
        function = _made("[body]", lambda: _choice("preset", name.replace("-", "_"), presets()))
        rest = {key: value for key, value in table.items() if key != "preset"}
        arguments = _checked(_arguments_of(function), rest, f'[body] with preset "{name}"')
        return _made("[body]", lambda: function(**arguments.model_dump()))
    if "solids" in table:
        composed = _checked(_Composed, table, "[body] with solids")
        parts = [_solid(part, f"[[body.solids]] {i}") for i, part in enumerate(composed.solids, 1)]
        return _made("[body]", lambda: Body.from_solids(composed.radius, parts))
    if not table:
        raise RimrollError("[body] is empty: give preset, solids or the five numbers of a body")
    numbers = _checked(_Numbers, table, "[body]", "preset", "solids")
    return _made("[body]", lambda: Body(**numbers.model_dump()))


def _solid(table: dict[str, Any], where: str) -> solids.Solid:
    kind = table.get("kind")
    if not isinstance(kind, str):
        raise RimrollError(f"{where} needs a kind: one of {', '.join(SOLIDS)}")
    function = _made(where, lambda: _choice("kind", kind, SOLIDS))
    rest = {key: value for key, value in table.items() if key != "kind"}
    arguments = _checked(_arguments_of(function), rest, f'{where} of kind "{kind}"')
    return _made(where, lambda: function(**arguments.model_dump()))


def _choice(what: str, name: str, choices: Mapping[str, T]) -> T:
    if name not in choices:
        raise RimrollError(f"{what} {name!r} is unknown{_nearest(name, choices)}")
    return choices[name]


def _made(where: str, make: Callable[[], T]) -> T:
    """What ``make`` makes; its complaint, if any, says where in the file."""
    try:
        return make()
    except RimrollError as error:
        raise RimrollError(f"{where} {error}") from None


def _checked(model: type[TableT], table: dict[str, Any], where: str, *other_keys: str) -> TableT:
    """The table as a model; the first thing wrong with it is a ``RimrollError``."""
    try:
        return model.model_validate(table)
    except ValidationError as error:
        # A misspelt key is also a missing one; what was typed says more than what was not.
        problems = sorted(error.errors(), key=lambda found: found["type"] != "extra_forbidden")
    known = [*model.model_fields, *other_keys]
    raise RimrollError(f"{where} {_problem(problems[0], known)}".strip())


def _problem(found: ErrorDetails, known: list[str]) -> str:
    """What pydantic found wrong, in our words where it is ours to say."""
    key = ".".join(str(part) for part in found["loc"])
    match found["type"]:
        case "extra_forbidden":
            return f"has an unknown key {key!r}{_nearest(key, known)}"
        case "missing":
            return f"lacks {key!r}"
        case "value_error":  # a quantity's own refusal, which names the field
            return str(found.get("ctx", {}).get("error", found["msg"]))
        case "dict_type" | "list_type" | "string_type" | "int_type" as kind:
            return f"{key} must be a {_KINDS[kind]}, got {found['input']!r}"
        case _:
            return f"{key} is {found['input']!r}: {found['msg'].lower()}"


_KINDS = {
    "dict_type": "table",
    "list_type": "list of tables",
    "string_type": "text",
    "int_type": "whole number",
}


def _nearest(name: str, known: Mapping[str, object] | list[str]) -> str:
    """A suggestion, and all that would be known."""
    near = difflib.get_close_matches(name, list(known), n=1)
    choices = ", ".join(known) or "none"
    return f": did you mean {near[0]!r}? Known: {choices}" if near else f": choose from {choices}"
