"""A function as a command: an option for each of its parameters, help by panels; and groups.

A group of commands loads only the command that is called.
"""

from __future__ import annotations

import functools
import inspect
import re
from collections.abc import Callable, Container, Mapping
from dataclasses import fields, is_dataclass
from importlib import import_module
from types import ModuleType
from typing import Annotated, Any, ClassVar, get_args, get_origin, get_type_hints

import typer
from typer.core import TyperCommand, TyperGroup
from typer.main import get_command

from rimroll.errors import RimrollError

EARLIER = {
    ("map", "--points"): "--starts",
    ("fragility", "--points"): "--levels",
    ("fragility", "--scales"): "--scale",
    ("score", "--limit"): "--time-limit",
}
"""Earlier spellings of options by command, which help does not show, and what they are now."""

SETTINGS = {"help_option_names": ["-h", "--help"], "max_content_width": 100}


def made(function: Callable[..., int]) -> Any:
    """The command that calls the function with what was typed.

    It first calls the ``obj`` of the context that it is run in.
    """
    # Without markup, since typer would load half of rich to show help.
    app = typer.Typer(add_completion=False, rich_markup_mode=None, context_settings=SETTINGS)
    flat = unfolded(function)
    help = re.sub(r"^\$ ", "\b\n$ ", inspect.getdoc(function) or "", flags=re.MULTILINE)
    app.command(function.__name__, cls=Command, help=help)(flat)  # lines after \b are not wrapped
    command: Any = get_command(app)
    command.texts = {name for name, hint in flat.__annotations__.items() if _is_text(hint)}
    return command


class Sparing:
    """A command that converts parameters only if they are given and are to be no texts.

    typer converts by pydantic, which takes as long to load as NumPy; most options are texts.
    """

    texts: Container[str] = ()

    def get_params(self, ctx: Any) -> list[Any]:
        parameters: list[Any] = super().get_params(ctx)  # type: ignore[misc]
        for parameter in parameters:
            if "process_value" not in vars(parameter):
                parameter.process_value = _converting(parameter, parameter.name in self.texts)
        return parameters


def _converting(parameter: Any, is_text: bool) -> Callable[[Any, Any], Any]:
    convert = parameter.process_value

    def process_value(context: Any, value: Any) -> Any:
        if parameter.required or not (value is None or (is_text and isinstance(value, str))):
            return convert(context, value)
        if value is None and (parameter.multiple or parameter.nargs == -1):
            value = ()
        return parameter.callback(context, parameter, value) if parameter.callback else value

    return process_value


class Command(Sparing, TyperCommand):
    """A command that says when it begins, and whose help has a section for each panel."""

    def parse_args(self, ctx: Any, args: list[str]) -> list[str]:
        words = (word.partition("=") for word in args)
        renamed = [
            EARLIER.get((self.name or "", name), name) + equals + value
            for name, equals, value in words
        ]
        return super().parse_args(ctx, renamed)

    def invoke(self, ctx: Any) -> Any:
        ctx.find_root().obj()
        try:
            return super().invoke(ctx)
        except RimrollError as error:
            if error.field is None or error.where:
                raise
            raise self._as_given(error, ctx) from None

    def _as_given(self, error: RimrollError, ctx: Any) -> RimrollError:
        """An error that names options as they are typed, or the scenario file that has the value.

        Names of options that were not typed stay as they are in files.
        """
        from rimroll.cli.request import is_file  # which loads numpy

        options = {one.name: one.opts[0] for one in self.params if one.param_type_name == "option"}
        typed = {name: option for name, option in options.items() if _is_on_command_line(name, ctx)}
        others = _other_names()
        in_typed = typed | {name: typed[option] for name, option in others if option in typed}
        untyped = options.keys() | {name for name, option in others if option in options}
        untyped -= in_typed.keys()
        file = ctx.params.get("scenario") or ctx.params.get("body")
        error = error.called(in_typed)
        if error.field in untyped and file is not None and is_file(str(file)):
            return error.inside(f"{file}:")
        return error

    def format_options(self, ctx: Any, formatter: Any) -> None:
        sections: dict[str, list[tuple[str, str]]] = {}
        for parameter in self.get_params(ctx):
            if (lines := parameter.get_help_record(ctx)) is not None:
                usual = "Arguments" if parameter.param_type_name == "argument" else "Options"
                panel = getattr(parameter, "rich_help_panel", None) or usual
                sections.setdefault(panel, []).append(lines)
        for panel, records in sections.items():
            with formatter.section(panel):
                formatter.write_dl(records)


def _is_on_command_line(name: str, ctx: Any) -> bool:
    return getattr(ctx.get_parameter_source(name), "name", None) == "COMMANDLINE"


def _other_names() -> list[tuple[str, str]]:
    """The names that errors of the Python interface have for options, and the options."""
    from rimroll.laws import LAWS  # which load numpy
    from rimroll.scenario import RESISTANCES
    from rimroll.units import quantities_of

    found = [("n", "number")]
    for law in LAWS.values():
        found += [(name, one.option) for name, one in quantities_of(law).items()]
    for table, kind in RESISTANCES.items():
        found += [(f"{table} {name}", one.option) for name, one in quantities_of(kind).items()]
    return found


def _is_text(hint: Any) -> bool:
    kind = get_args(hint)[0] if get_origin(hint) is Annotated else hint
    return kind in (str, str | None)


def unfolded(command: Callable[..., int]) -> Callable[..., int]:
    """A command whose dataclass parameters are taken apart into an option for each field."""
    hints = get_type_hints(command, include_extras=True)
    groups: dict[str, Any] = {name: hint for name, hint in hints.items() if is_dataclass(hint)}
    parameters = []
    for name, parameter in inspect.signature(command).parameters.items():
        single = [(name, hints[name], parameter.default)]
        for option, hint, default in _options_of(groups[name]) if name in groups else single:
            kind = inspect.Parameter.KEYWORD_ONLY
            parameters.append(inspect.Parameter(option, kind, default=default, annotation=hint))

    @functools.wraps(command)
    def flat(**given: Any) -> int:
        folded = {
            name: group(**{field.name: given.pop(field.name) for field in fields(group)})
            for name, group in groups.items()
        }
        return command(**folded, **given)

    flat.__signature__ = inspect.Signature(parameters)  # type: ignore[attr-defined]
    flat.__annotations__ = {parameter.name: parameter.annotation for parameter in parameters}
    return flat


def _options_of(group: Any) -> list[tuple[str, Any, Any]]:
    hints = get_type_hints(group, include_extras=True)
    return [(field.name, hints[field.name], field.default) for field in fields(group)]


class Commands(Sparing, TyperGroup):
    """A group that knows its commands by name until one is called."""

    package: ClassVar[str]
    """The package that has the commands."""
    module: ClassVar[str | None]
    """Its module with all of them; by default each has a module of its name."""

    def resolve_command(self, ctx: Any, args: list[str]) -> Any:
        name, command, rest = super().resolve_command(ctx, args)
        return name, command and loaded(self.package, str(command.name), self.module), rest


def group(package: str, commands: Mapping[str, str], *, module: str | None = None) -> typer.Typer:
    """A group of commands by name, each with the first line of its help.

    Each is a function of its name, in the module of that name or in one module for all.
    """
    kind = type("Commands", (Commands,), {"package": package, "module": module})
    app = typer.Typer(
        cls=kind,
        rich_markup_mode=None,
        context_settings=SETTINGS,
        add_completion=package.count(".") == 1,
    )
    for name, first_line in commands.items():
        app.command(name, help=first_line)(_named_only)
    return app


def loaded(package: str, name: str, module: str | None = None) -> Any:
    """The command of that name, or the group of commands, its module loaded."""
    home: ModuleType = import_module(f"{package}.{module or name}")
    return get_command(home.app) if hasattr(home, "app") else made(getattr(home, name))


def _named_only() -> None:
    """Stands for a command that has not been called."""
