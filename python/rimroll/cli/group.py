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
    """The package that has a module for each command."""

    def resolve_command(self, ctx: Any, args: list[str]) -> Any:
        name, command, rest = super().resolve_command(ctx, args)
        return name, command and loaded(self.package, str(command.name)), rest


def group(package: str, commands: Mapping[str, str]) -> typer.Typer:
    """A group of commands by name, each with the first line of its help."""
    kind = type("Commands", (Commands,), {"package": package})
    app = typer.Typer(
        cls=kind,
        rich_markup_mode=None,
        context_settings=SETTINGS,
        add_completion=package.count(".") == 1,
    )
    for name, first_line in commands.items():
        app.command(name, help=first_line)(_named_only)
    return app


def loaded(package: str, name: str) -> Any:
    """The command of that name, or the group of commands, its module loaded."""
    module: ModuleType = import_module(f"{package}.{name}")
    return get_command(module.app) if hasattr(module, "app") else made(getattr(module, name))


def _named_only() -> None:
    """Stands for a command that has not been called."""
