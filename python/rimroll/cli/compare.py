"""``rimroll compare``: the same flick on ice, on wood and on rubber."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from rimroll._core import __version__
from rimroll.cli.formats import Forms, check, pictures, write
from rimroll.cli.hints import hints
from rimroll.cli.options import (
    BodyOptions,
    JsonOption,
    MotionOptions,
    ResistanceOptions,
    StartOptions,
    value_option,
)
from rimroll.cli.outcomes import FILE, IDEALS, USUAL, Outcome, outcome, tables
from rimroll.cli.request import Request, requested
from rimroll.cli.screen import angle, prose, say, show_json, table, working
from rimroll.cli.turn import arrival_of, body_line, limit_in_words, start_line
from rimroll.errors import RimrollError
from rimroll.files.recorded import ending_in_words
from rimroll.laws import Law, NoSlip
from rimroll.laws.surfaces import SURFACES
from rimroll.motion import Motion
from rimroll.theory.closed_forms import needed_friction
from rimroll.units import quantities_of, quantity

if TYPE_CHECKING:
    from matplotlib.figure import Figure

OnOption = Annotated[
    str | None,
    value_option(
        f"The tables: {', '.join(SURFACES)}, {', '.join(IDEALS)}, {FILE} (the law of a"
        f" scenario file), or coefficients of friction such as 0.05,0.2,0.5. [{USUAL}, and {FILE}"
        " where there is one]",
        "LIST",
        "Table",
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
    on: OnOption = None,
    output: FigureOption = None,
    json: JsonOption = False,
) -> int:
    """How the same flick turns out on ice, on wood and on rubber.

    Without a start the body is let go at half its balance tilt, pushed aside a little.
    The law of a scenario file is compared with them.

    Examples:

    $ rimroll compare

    $ rimroll compare soda_can

    $ rimroll compare can_2007 --tilt 30deg --tilt-rate -0.5rad/s --yaw-rate 1e-5

    $ rimroll compare coin --on 0.05,0.2,no-slip -o coin.svg
    """
    files = output or []
    check(files, FORMS)
    rebound = quantity(resistances.restitution or "0", "1", "--restitution")
    others = resistances.with_texts(restitution=None)
    what = requested(body, start, motion, None, others, needs_start=True)
    laws = tables(on, rebound, _of_file(what, resistances.restitution))
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
        prose(body_line(what.name, what.body))
        prose(start_line(outcomes[0].motion, what.nudged))
        _show(outcomes)
        for file in files:
            say(f"wrote {file}")
    return int(any(one.motion.status == "failed" for one in outcomes))


def _of_file(what: Request, restitution: str | None) -> Law | None:
    """The law of a scenario file without resistances, which every table gets; None without one."""
    if not what.has_file:
        return None
    rebound = {} if restitution is None else {"restitution": quantity(restitution, "1")}
    takes = "restitution" in quantities_of(type(what.law))
    return replace(what.law, resistances=(), **(rebound if takes else {}))


def _side_by_side(outcomes: list[Outcome]) -> Figure:
    from rimroll.cli.side_by_side import side_by_side

    return side_by_side(outcomes)


FORMS: Forms[list[Outcome]] = pictures(_side_by_side)


def _show(outcomes: list[Outcome]) -> None:
    rows = table("on", "friction", "limit", "turn", "slips", "lost", "ended")
    for one in outcomes:
        turn, limit = one.turn, one.limit.from_start
        rows.add_row(
            one.name,
            one.friction_in_words,
            "none" if limit is None else angle(limit),
            "none" if turn is None else angle(abs(turn.angle)),
            _slips(one),
            f"{100 * max(one.lost, 0.0):.2f} %" if one.motion.status != "failed" else "",
            ending_in_words(one.motion.status),
        )
    say()
    say(rows)
    say()
    prose(limit_in_words(", for a body that arrives as this one"))
    prose(
        "turn, lost: of this motion, from the release to its next tilt maximum or to its end; what"
        " is lost is a part of the energy above that of standing upright or, for a body that comes"
        " down lower, above that of its lowest place"
    )
    prose("slips: first while tipping down on the table, or only in the near-collision, or nowhere")
    for way, names in _by_table(outcomes, _way_round).items():
        prose(f"turned {way} on {', '.join(names)}")
    prose(_needs(outcomes[0].motion))
    for remark, names in _by_table(outcomes, _remarks).items():
        prose(remark if len(names) == len(outcomes) else f"on {', '.join(names)}: {remark}")


def _by_table(
    outcomes: list[Outcome], remarks: Callable[[Outcome], list[str]]
) -> dict[str, list[str]]:
    """Each remark once, with the tables that it is about."""
    found: dict[str, list[str]] = {}
    for one in outcomes:
        for remark in remarks(one):
            found.setdefault(remark, []).append(one.name)
    return found


def _way_round(one: Outcome) -> list[str]:
    """In which direction the contact point went round, seen from above."""
    if one.turn is None:
        return []
    return ["anticlockwise" if one.turn.angle > 0.0 else "clockwise"]


def _remarks(one: Outcome) -> list[str]:
    """Hints; without any, the reason why there is no limit, without the numbers of each table."""
    if found := hints(one.motion, "--on"):
        return found
    if one.limit.ends is not None:
        ending = ending_in_words(one.limit.ends)
        return [f"no limit: tipping ends as {ending} and not with the base flat"]
    return [one.limit.why_not] if one.limit.why_not else []


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
