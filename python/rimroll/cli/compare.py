"""``rimroll compare``: the same flick on ice, on wood and on rubber."""

from __future__ import annotations

import math
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from rimroll._core import __version__
from rimroll.cli.asked import asked
from rimroll.cli.formats import Forms, check, pictures, write
from rimroll.cli.options import (
    BodyOptions,
    JsonOption,
    LawOptions,
    MotionOptions,
    ResistanceOptions,
    StartOptions,
)
from rimroll.cli.outcomes import IDEALS, Outcome, outcome, tables
from rimroll.cli.screen import angle, say, show_json, table, working
from rimroll.cli.turn import arrival_of, body_line, start_line
from rimroll.errors import RimrollError
from rimroll.laws import NoSlip
from rimroll.motion import Motion
from rimroll.names import typed
from rimroll.state import State
from rimroll.surfaces import SURFACES
from rimroll.theory import needed_friction
from rimroll.units import quantity

if TYPE_CHECKING:
    from matplotlib.figure import Figure

USUAL = State(tilt=math.radians(30.0), tilt_rate=-0.5, yaw_rate=0.005, spin_rate=0.005)
"""The paper's start."""


OnOption = Annotated[
    str,
    typer.Option(
        help=f"The tables: {', '.join(SURFACES)}, {', '.join(IDEALS)}, or coefficients of friction"
        " such as 0.05,0.2,0.5.",
        metavar="LIST",
        rich_help_panel="Table",
    ),
]
FigureOption = Annotated[
    list[Path] | None,
    typer.Option(
        "--output",
        "-o",
        help="Draw the motions side by side (.svg, .png or .pdf); may be repeated.",
        metavar="FILE",
        rich_help_panel="Output",
    ),
]


def compare(
    body: BodyOptions,
    start: StartOptions,
    motion: MotionOptions,
    resistances: ResistanceOptions,
    on: OnOption = "ice,wood,rubber",
    output: FigureOption = None,
    json: JsonOption = False,
) -> int:
    """How the same flick turns out on ice, on wood and on rubber.

    Unless told otherwise it is that of the paper: the can, released from 30 degrees.
    What a scenario file says of friction gives way to the tables that are compared.

    Examples:

    $ rimroll compare

    $ rimroll compare can_2007 --tilt 30deg --tilt-rate -0.5rad/s --yaw-rate 1e-5

    $ rimroll compare coin --on 0.05,0.2,no-slip -o coin.svg
    """
    files = output or []
    check(files, FORMS)
    rebound = quantity(resistances.restitution or "0", "1", "--restitution")
    laws = tables(on, rebound)
    resistances = replace(resistances, restitution=None)
    sideways = start.yaw_rate is not None or start.spin_rate is not None
    usual = replace(USUAL, yaw_rate=0.0, spin_rate=0.0) if sideways else USUAL
    what = asked(body, start, motion, LawOptions(), resistances, usual)
    outcomes = []
    with working(f"following {what.name}") as bar:
        for done, (name, law) in enumerate(laws.items()):
            bar(done, len(laws), f"on {name}")
            outcomes.append(outcome(what, name, law))
    for file in files:
        write(file, outcomes, FORMS)
    if json:
        show_json(
            {
                "rimroll_version": __version__,
                "body": what.name,
                "needed_friction": needed_friction(what.body),
                "outcomes": [one.answer() for one in outcomes],
                "files": [str(file) for file in files],
            }
        )
    else:
        say(body_line(what.name, what.body))
        say(start_line(outcomes[0].motion))
        _show(outcomes)
        for file in files:
            say(f"wrote {file}")
    return int(any(one.motion.status == "failed" for one in outcomes))


def _side_by_side(outcomes: list[Outcome]) -> Figure:
    from rimroll.cli.side_by_side import side_by_side

    return side_by_side(outcomes)


FORMS: Forms[list[Outcome]] = pictures(_side_by_side)


def _show(outcomes: list[Outcome]) -> None:
    rows = table("on", "friction", "limit", "turn", "slips", "lost", "ended")
    for one in outcomes:
        friction, turn, limit = one.friction, one.turn, one.limit.from_start
        rows.add_row(
            one.name,
            "any" if friction is None else f"{friction:g}",
            "none" if limit is None else angle(limit),
            "none" if turn is None else angle(turn.angle),
            _slips(one),
            f"{100 * max(one.lost, 0.0):.2f} %" if one.motion.status != "failed" else "",
            typed(one.motion.status),
        )
    say()
    say(rows)
    say()
    say("limit: the turn as the sideways push goes to 0, for a body that arrives as this one")
    say("turn, lost: this motion's, and of its energy, from the release to its next maximum of")
    say("            tilt, or to its end")
    say(_needs(outcomes[0].motion))
    for one in outcomes:
        if one.limit.why_not:
            say(f"on {one.name}: {one.limit.why_not}")


def _slips(one: Outcome) -> str:
    if one.slips_while_tipping:
        return "tipping"
    if one.slips:
        return "collision" if one.slips_while_tipping is False else "yes"
    return "nowhere"


def _needs(motion: Motion) -> str:
    """The friction that rolling needs."""
    passing = f"{needed_friction(motion.body):.4g} through the near-collision"
    try:
        comes = arrival_of(motion.body, motion.start, NoSlip(), motion.gravity)
    except RimrollError:
        return f"rolling needs friction {passing}"
    return f"rolling needs friction {comes.friction_ratio:.4g} while tipping, {passing}"
