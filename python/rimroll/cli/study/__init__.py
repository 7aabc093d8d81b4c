"""``rimroll study``: computations that outgrow one process, described in a file."""

from __future__ import annotations

import typer

from rimroll.cli.command import group

COMMANDS = {
    "plan": "What a study varies, how much that is, and how long it takes.",
    "run": "Compute what is not done of a study, into its store.",
    "status": "How much of a study is done, and who is at work.",
    "show": "Maps, curves and histograms of a finished or partial study.",
    "verify": "Read all numbers of a store again, and print one hash of them.",
}
"""Each command, a function in the module ``commands``, and its first line of help."""

app = group("rimroll.cli.study", COMMANDS, module="commands")


@app.callback(invoke_without_command=True)
def study(context: typer.Context) -> None:
    """Many bodies, frictions, starts and records, planned in a file.

    A study file says what varies, how often each combination is tried, and what is kept.

    A first try:

    $ rimroll study plan turn_of_presets.toml

    $ rimroll study run turn_of_presets.toml --store turns.zarr
    """
    if context.invoked_subcommand is None:
        print(context.get_help())
