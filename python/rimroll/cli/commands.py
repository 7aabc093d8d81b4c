"""The commands, gathered."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Annotated, Any

import typer
from typer.main import get_command

from rimroll._core import __version__
from rimroll.cli.bodies import bodies
from rimroll.cli.compare import compare
from rimroll.cli.fit import fit
from rimroll.cli.lab import lab
from rimroll.cli.map import map
from rimroll.cli.measure import measure
from rimroll.cli.options import unfolded
from rimroll.cli.protractor import protractor
from rimroll.cli.reproduce import reproduce
from rimroll.cli.simulate import simulate
from rimroll.cli.topple import topple
from rimroll.cli.turn import turn
from rimroll.errors import RimrollError

app = typer.Typer(
    rich_markup_mode="rich",
    context_settings={"help_option_names": ["-h", "--help"]},
)

COMMANDS = (
    turn,
    simulate,
    topple,
    map,
    compare,
    measure,
    protractor,
    fit,
    lab,
    reproduce,
    bodies,
)

for command in COMMANDS:
    app.command()(unfolded(command))

# typer keeps the base class of the errors in what was typed to itself.
_UsageError: Any = typer.BadParameter.__bases__[0]


@app.callback(invoke_without_command=True)
def rimroll(
    context: typer.Context,
    version: Annotated[bool, typer.Option("--version", help="Say the version and stop.")] = False,
) -> None:
    """How round things fall, rock and roll on the rim of their base.

    A can, tilted and let go, almost slaps the table and rises again, turned.

    A first try:

    $ rimroll turn soda_can

    $ rimroll compare --on ice,wood,rubber

    $ rimroll simulate --tilt 30deg --yaw-rate 0.005 -o can.gif

    Quantities carry units, as in 5.1cm; plain numbers are SI and radians.
    """
    if version:
        print(f"rimroll {__version__}")
    elif context.invoked_subcommand is None:
        print(context.get_help())


def run(arguments: Sequence[str] | None) -> int:
    """Run a command; return its exit code. What was typed wrongly is a ``RimrollError``."""
    try:
        code = get_command(app).main(arguments, prog_name="rimroll", standalone_mode=False)
    except _UsageError as error:
        raise RimrollError(_one_line(error)) from None
    except typer.Abort:
        raise KeyboardInterrupt from None
    if code == 130:  # so typer tells of Ctrl-C
        raise KeyboardInterrupt
    return code or 0


def _one_line(error: Exception) -> str:
    """The complaint of typer, and where to look for help."""
    context = getattr(error, "ctx", None)
    command = context.command_path if context else "rimroll"
    message = str(getattr(error, "format_message", error.__str__)()).strip().rstrip(".")
    return f"{message} (see {command} --help)"
