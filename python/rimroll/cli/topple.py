"""``rimroll topple``: one flick after another by hand, and where the body falls."""

from __future__ import annotations

import math
from collections import Counter
from dataclasses import asdict, dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import numpy as np
import typer

from rimroll.cli.contact import in_words
from rimroll.cli.falls import NUMBERS
from rimroll.cli.formats import STDOUT, Forms, check, pictures, write
from rimroll.cli.hints import release_hints
from rimroll.cli.options import (
    BodyOptions,
    FallOptions,
    JsonOption,
    LawOptions,
    ResistanceOptions,
    ThreadsOption,
    whole,
)
from rimroll.cli.release import ReleaseOptions, release_line, requested_release
from rimroll.cli.request import Request, options_of_falls, requested
from rimroll.cli.screen import angle, prose, say, show_json, table, unbroken, working
from rimroll.cli.turn import body_line
from rimroll.errors import typed
from rimroll.experiment.release import Release
from rimroll.experiment.toppling import FALLING, counted, let_go, limits
from rimroll.files.recorded import FELL, ending_in_words
from rimroll.many.falls import Falls, Interrupted

if TYPE_CHECKING:
    from matplotlib.figure import Figure


NumberOption = Annotated[
    int,
    typer.Option(
        "--number", "-n", parser=whole(), help="Number of flicks. The paper: 42.", metavar="NUMBER"
    ),
]
SeedOption = Annotated[
    int | None,
    typer.Option(
        parser=whole(),
        help="Seed of the scatter; the same seed gives the same falls. [random]",
        metavar="NUMBER",
    ),
]
FallsOption = Annotated[
    list[Path] | None,
    typer.Option(
        "--output",
        "-o",
        help="Write the falls (.csv, .nc, .json) or draw where they went (.png, .svg, .pdf);"
        " may be repeated; - writes .csv to stdout.",
        metavar="FILE",
        rich_help_panel="Output",
    ),
]


def _histogram(falls: Falls) -> Figure:
    from rimroll.experiment.histogram import falls_figure

    return falls_figure(falls, name=falls.attrs["body"])


FORMS: Forms[Falls] = {**NUMBERS, **pictures(_histogram)}


def topple(
    body: BodyOptions,
    hand: ReleaseOptions,
    motion: FallOptions,
    law: LawOptions,
    resistances: ResistanceOptions,
    number: NumberOption = 42,
    seed: SeedOption = None,
    threads: ThreadsOption = None,
    output: FallsOption = None,
    json: JsonOption = False,
) -> int:
    """Where a body falls, flicked many times by an unsteady hand.

    The paper's experiment: flicked 42 times, its can fell to left and right,
    never straight ahead. Directions count anticlockwise from the first lean.
    A scenario file gives body, law, gravity and topple tilt.
    Ctrl-C keeps the falls done so far.

    Examples:

    $ rimroll topple

    $ rimroll topple --release paper --friction 0.15 -o falls.svg -o falls.csv

    $ rimroll topple soda_can -n 1000 --surface wood --unsteadiness 2

    $ rimroll topple coin --release let-go --twist-spread 3deg/s
    """
    paths = output or []
    check(paths, FORMS, json)
    what = requested(body, None, motion, law, resistances)
    release = requested_release(hand, what)
    falls, cut_short = _fall(what, motion, release, number, seed, threads)
    for path in paths:
        write(path, falls, FORMS)
    if json:
        show_json(_answer(falls, paths))
    elif STDOUT not in paths:
        _show(what, release, falls, paths)
    if cut_short:
        return 130
    return int(bool((falls["outcome"] == "failed").all()))


def _fall(
    what: Request,
    motion: FallOptions,
    release: Release,
    number: int,
    seed: int | None,
    threads: int | None,
) -> tuple[Falls, bool]:
    """The falls, and whether Ctrl-C cut them short."""
    options = options_of_falls(motion, what.options, FALLING)
    named = {"body": what.name}
    with working(f"{what.name} falls") as bar:
        try:
            falls = let_go(
                what.body,
                what.law,
                number,
                release,
                seed,
                options,
                threads,
                lambda done, total: bar(done, total, f"{done} of {total}"),
            )
        except Interrupted as interrupted:
            falls = interrupted.falls
            named["interrupted"] = f"after {falls.size} of {number} falls"
    return replace(falls, attrs=named | falls.attrs), "interrupted" in named


@dataclass(frozen=True)
class Side:
    """The falls that went round one way: rad."""

    count: int
    mean_turn: float
    deviation: float
    direction: float

    @property
    def side(self) -> str:
        """Where they ended up, as the hand sees it that flicks the body away from itself."""
        return "left" if self.direction > math.pi else "right"


def _sides(falls: Falls, word: str) -> dict[str, Side]:
    """The falls that ended in a word, by the way in which the contact point ran round."""
    turns = falls["turn"][falls["outcome"] == word]
    both = {"anticlockwise": turns[turns > 0.0], "clockwise": turns[turns < 0.0]}
    return {way: _side(some) for way, some in both.items() if some.size}


def _side(turns: Any) -> Side:
    mean = float(turns.mean())
    deviation = float(np.std(turns, ddof=1)) if turns.size > 1 else math.nan
    return Side(turns.size, abs(mean), deviation, mean % (2.0 * math.pi))


def _answer(falls: Falls, paths: list[Path]) -> dict[str, Any]:
    _, word = counted(falls)
    sides = _sides(falls, word)
    return {
        "parameters": falls.attrs,
        "number": falls.size,
        "outcomes": _outcomes(falls),
        "outcome": word,
        "sides": {way: {**asdict(one), "side": one.side} for way, one in sides.items()},
        "turn_limit": limits(falls),
        "files": [str(path) for path in paths],
    }


def _outcomes(falls: Falls) -> dict[str, int]:
    return dict(Counter(map(str, falls["outcome"].tolist())).most_common())


def _show(what: Request, release: Release, falls: Falls, paths: list[Path]) -> None:
    prose(body_line(what.name, what.body))
    prose(f"{in_words(what.law)}; {unbroken(f'gravity {what.options.gravity:g} m/s²')}")
    prose(release_line(release))
    say()
    counts = ", ".join(
        f"{count} {ending_in_words(outcome)}" for outcome, count in _outcomes(falls).items()
    )
    counted = f"{falls.size} falls" + (f": {counts}" if counts else "")
    say(f"{counted}; seed {falls.attrs['seed']}")
    say()
    if counts:
        _show_sides(falls)
    for hint in release_hints(what.body, release.mean, what.law, what.options):
        prose(hint)
    if "interrupted" in falls.attrs:
        say(f"interrupted {falls.attrs['interrupted']}")
    part = f": a part, {falls.size} falls" if "interrupted" in falls.attrs else ""
    for path in paths:
        say(f"wrote {path}{part}")


def _show_sides(falls: Falls) -> None:
    rows = table("having turned", "count", "mean turn", "s.d.", "so at")
    several = {word: sides for word in FELL if (sides := _sides(falls, word))}
    for word, sides in several.items():
        for way, one in sides.items():
            deviation = "" if math.isnan(one.deviation) else angle(one.deviation)
            where = f"{math.degrees(one.direction):.1f}°, {one.side}"
            rows.add_row(f"{word}, {way}", str(one.count), angle(one.mean_turn), deviation, where)
    for law, limit in limits(falls).items():
        rows.add_row(f"limit, {typed(law)}", "", angle(limit), "", "")
    say(rows)
    if not several:
        say("No body came down, so there are no directions.")
    say()
