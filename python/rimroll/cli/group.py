"""Groups of commands of which only the one that is called is loaded."""

from __future__ import annotations

from collections.abc import Mapping
from importlib import import_module
from types import ModuleType
from typing import Any, ClassVar

import typer
from typer.core import TyperGroup
from typer.main import get_command

from rimroll.cli.command import SETTINGS, Sparing, made


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
