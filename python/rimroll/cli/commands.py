"""The list of commands: a name and a line for each, until one is called."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Annotated, Any

import typer
from typer.main import get_command

from rimroll._core import __version__
from rimroll.cli.command import group
from rimroll.errors import RimrollError

COMMANDS = {
    "turn": "The angle by which a body turns in a near-collision.",
    "simulate": "A whole motion from a start: its turns, events and ending.",
    "shake": "A body on a table that moves, as in an earthquake.",
    "fragility": "How likely a shaking is to overturn a body: a fragility curve.",
    "compare": "How the same flick turns out on ice, on wood and on rubber.",
    "bodies": "The bodies that have a name, their numbers and sources.",
    "topple": "Where a body falls, flicked many times by an unsteady hand.",
    "map": "Left or right: the direction of fall over a plane of starts.",
    "measure": "Your own can from a ruler, scales and a stopwatch.",
    "protractor": "A sheet to print and to read directions of fall on.",
    "fit": "The friction of a table from directions of fall.",
    "gyro": "Turns and friction from the record of a gyroscope in the body.",
    "film": "Friction from the filmed track of a marker, or of the lean.",
    "study": "Many bodies, frictions, starts and records, planned in a file.",
    "lab": "Tip the can in a browser, on a page that computes itself.",
    "score": "Which physics engine gets the can right: a scorecard.",
    "reproduce": "The paper's numbers, figures and film redone as one page.",
}
"""Each command, the function of that name in the module of that name, and its first line of help.

Those that newcomers need come first. The line stands here, too, so that the list of commands is
shown before any of them is loaded.
"""


app = group("rimroll.cli", COMMANDS)


@app.callback(invoke_without_command=True)
def rimroll(
    context: typer.Context,
    version: Annotated[bool, typer.Option("--version", help="Show the version and exit.")] = False,
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


# typer keeps the base class of the errors in what was typed to itself.
_UsageError: Any = typer.BadParameter.__bases__[0]


def run(arguments: Sequence[str] | None, begin: Callable[[], object]) -> int:
    """Run a command, calling ``begin`` when all that it needs at first is loaded.

    Returns its exit code. What was typed wrongly is a ``RimrollError``.
    """
    try:
        command = get_command(app)
        code = command.main(arguments, prog_name="rimroll", standalone_mode=False, obj=begin)
    except _UsageError as error:
        raise RimrollError(_one_line(error)) from None
    except typer.Abort:
        raise KeyboardInterrupt from None
    if code == 130:  # the exit code that typer gives for Ctrl-C
        raise KeyboardInterrupt
    return code or 0


def _one_line(error: Exception) -> str:
    """The complaint of typer, and where to look for help."""
    context = getattr(error, "ctx", None)
    command = context.command_path if context else "rimroll"
    message = str(getattr(error, "format_message", error.__str__)()).strip().rstrip(".")
    return f"{message} (see {command} --help)"
