"""``rimroll fit``: the friction of a table from directions of fall."""

from __future__ import annotations

import math
import sys
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Any

import numpy as np
import typer
from rich.table import Table

from rimroll._core import __version__
from rimroll.cli.formats import Forms, check, pictures, write, write_json
from rimroll.cli.hints import release_hints
from rimroll.cli.options import (
    BodyOptions,
    JsonOption,
    MotionOptions,
    ThreadsOption,
)
from rimroll.cli.release import ReleaseOptions, release_line, requested_release
from rimroll.cli.request import requested
from rimroll.cli.screen import Bar, prose, say, show_json, table, unbroken, working
from rimroll.cli.turn import body_line
from rimroll.errors import RimrollError
from rimroll.experiment.directions import read_falls
from rimroll.experiment.fit import Fit
from rimroll.experiment.fit import fit as fit_directions
from rimroll.experiment.likelihood import Estimate
from rimroll.experiment.release import Release
from rimroll.laws import NoSlip
from rimroll.options import Options
from rimroll.units import quantities_of, quantity

Answer = dict[str, Any]

GRAVITY = quantities_of(Options)["gravity"]


@dataclass(frozen=True)
class BodyByOption(BodyOptions):
    """The body as an option, since the argument is the file of angles."""

    body: Annotated[
        str | None,
        typer.Option(
            help="A name from rimroll bodies, or a scenario file (.toml); the paper's can,"
            " can_2007, unless given.",
            metavar="BODY",
            rich_help_panel="Body",
            show_default=False,
        ),
    ] = None


AnglesArgument = Annotated[
    Path,
    typer.Argument(
        help="Directions of fall in degrees, counted anticlockwise from the direction of the first"
        " lean: one column; or two, the first lean and the fall; or what topple wrote (.csv)."
        " - reads standard input.",
        metavar="FILE",
    ),
]
RateErrorOption = Annotated[
    str | None,
    typer.Option(
        help="Uncertainty of the mean tilt rate: the friction is also estimated for flicks that"
        " much slower and faster. [a tenth of it]",
        metavar="RATE",
    ),
]
OutcomeOption = Annotated[
    str | None,
    typer.Option(
        help="The outcome that counts as a fall: toppled or rocked. [what such a flick does]",
        metavar="WORD",
    ),
]
ColumnOption = Annotated[
    str | None,
    typer.Option(
        help="The column of the direction of fall, by name or by number from 1. [found by name]",
        metavar="COLUMN",
    ),
]
LeanColumnOption = Annotated[
    str | None,
    typer.Option(help="The column of the direction of the first lean.", metavar="COLUMN"),
]
BiasOption = Annotated[
    str | None, typer.Option(help="Take the bias as known. [fitted]", metavar="ANGLE")
]
ErrorOption = Annotated[
    str, typer.Option(help="Standard deviation of reading a direction.", metavar="ANGLE")
]
ConfidenceOption = Annotated[
    str, typer.Option(help="Confidence level of the intervals and verdicts.", metavar="PART")
]
GravityOption = Annotated[
    str | None,
    typer.Option(help=GRAVITY.help, metavar=GRAVITY.metavar),
]
OutputOption = Annotated[
    list[Path] | None,
    typer.Option(
        "--output",
        "-o",
        help="Write the figure (.png, .svg, .pdf) or the numbers (.json); may be repeated.",
        metavar="FILE",
        rich_help_panel="Output",
    ),
]


def fit(
    angles: AnglesArgument,
    body: BodyByOption,
    hand: ReleaseOptions,
    gravity: GravityOption = None,
    tilt_rate_error: RateErrorOption = None,
    bias: BiasOption = None,
    outcome: OutcomeOption = None,
    reading_error: ErrorOption = "2deg",
    confidence: ConfidenceOption = "95%",
    column: ColumnOption = None,
    lean_column: LeanColumnOption = None,
    radians: Annotated[bool, typer.Option("--radians", help="Angles are in radians.")] = False,
    clockwise: Annotated[
        bool, typer.Option("--clockwise", help="Angles grow clockwise, as on a compass.")
    ] = False,
    threads: ThreadsOption = None,
    output: OutputOption = None,
    json: JsonOption = False,
) -> int:
    """The friction of a table from directions of fall.

    Falls simulated at every friction are held against the measured ones.
    Give the release roughly as it was: from what tilt, how fast.
    How unsteady the hand was is found from the falls.

    Examples:

    $ rimroll fit angles.csv

    $ rimroll fit angles.csv --body my_can.toml --tilt 20deg -o fit.svg

    $ rimroll fit falls_of_the_paper.csv --release paper --gravity 9.8
    """
    files = output or []
    check(files, FORMS)
    read = read_falls(
        sys.stdin.buffer if str(angles) == "-" else angles,
        radians=radians,
        clockwise=clockwise,
        outcome=outcome,
        column=column,
        lean_column=lean_column,
    )
    what = requested(body, motion=MotionOptions(gravity=gravity))
    release = requested_release(hand, what)
    if release.tilt_rate[0] > 0.0:
        rate = f"{release.tilt_rate[0]:g} rad/s"
        raise RimrollError(f"--tilt-rate must be negative, toward upright, got {rate}")
    with working("falls at each friction") as bar:
        found = fit_directions(
            what.body,
            read.directions,
            release,
            gravity=what.options.gravity,
            reading_error=_reading_error(reading_error),
            tilt_rate_error=_rate_error(tilt_rate_error),
            bias=None if bias is None else quantity(bias, "rad", "--bias"),
            outcome=outcome,
            confidence=quantity(confidence, "1", "--confidence"),
            threads=threads,
            progress=lambda done, total: bar(done, total, ""),
        )
    answer = {
        "body": what.name,
        "file": str(angles),
        "read": read.source,
        **found.to_dict(),
        "gravity": what.options.gravity,
        "reading_error": found.predicted.reading_error,
        **release.parameters(),
        "rimroll_version": __version__,
    }
    for file in files:
        write(file, (found, answer), FORMS)
    if json:
        show_json(answer)
    else:
        prose(body_line(what.name, what.body))
        prose(release_line(release))
        for hint in release_hints(what.body, release.mean, NoSlip(), what.options):
            prose(hint)
        say()
        prose(f"read {read.source}")
        _show(found, release)
        for file in files:
            say(f"wrote {file}")
    return 0


def _reading_error(text: str) -> float:
    error = quantity(text, "rad", "--reading-error")
    if text.strip()[-1:].isdigit() and error > 0.5:
        raise RimrollError(
            f"--reading-error: {text} is read as radians; for degrees write {text}deg"
        )
    return error


def _rate_error(text: str | None) -> float | None:
    return None if text is None else quantity(text, "rad/s", "--tilt-rate-error")


def _numbers(part: Path, found: tuple[Fit, Answer], bar: Bar) -> None:
    write_json(part, found[1])


FORMS: Forms[tuple[Fit, Answer]] = {
    **pictures(lambda found: found[0].plot()),
    ".json": _numbers,
}


def _show(found: Fit, release: Release) -> None:
    prose(_falls_line(found))
    say()
    # A number is worth what the verdicts leave of it, so these come first.
    for verdict in reversed(found.verdicts):
        prose(verdict.sentence)
    if not found.supported:
        prose("The falls lack the shape that friction gives: the numbers below mean nothing.")
    say()
    rows = table("", "best", f"{100.0 * found.confidence:g} %")
    _add_estimate(rows, "friction" if found.supported else "friction, unsupported", found.friction)
    for rate, friction in found.at_other_tilt_rates:
        faster = abs(rate) > abs(release.tilt_rate[0])
        rows.add_row(
            f"  if flicked {'faster' if faster else 'slower'}, {rate:.3g} rad/s",
            f"{friction:.3f}",
            "",
        )
    if found.bias_interval is None:
        rows.add_row("bias, fixed", _degrees(found.bias), "")
    else:
        low, high = map(_degrees, found.bias_interval)
        end = _bound_in_words(found, "bias")
        rows.add_row("bias, anticlockwise", _degrees(found.bias), end or f"{low} to {high}")
    rows.add_row(
        "spread of the hand, of that assumed",
        f"{found.unsteadiness:.2f}",
        _bound_in_words(found, "unsteadiness"),
    )
    for side, one in (("left", found.left), ("right", found.right)):
        if one is not None and found.bias_interval is not None:
            _add_estimate(rows, f"friction, {side} alone, no bias", one)
    say(rows)
    say()
    if found.friction.open_above:
        most = found.friction.holding_friction
        prose(f"From friction {most:.3g} on the rim holds, and more changes next to nothing.")
    for note in (*_shares(found), *found.warnings):
        prose(f"Note: {note}")


def _bound_in_words(found: Fit, parameter: str) -> str:
    end = found.at_bounds.get(parameter)
    return f"the {end} tried" if end else ""


def _add_estimate(rows: Table, name: str, one: Estimate) -> None:
    """An interval a line: there may be several."""
    for i, interval in enumerate(one.intervals):
        best = f"{one.friction:.3f}" if i == 0 else ""
        joined = (
            one.interval_in_words(*interval) if i == 0 else f"or {one.interval_in_words(*interval)}"
        )
        rows.add_row(name if i == 0 else "", best, joined)


def _shares(found: Fit) -> Iterator[str]:
    """Where an interval lies among frictions at which few such flicks end as those that count."""
    table = found.predicted
    for low, high in found.friction.intervals:
        share = float(np.interp(0.5 * (low + high), table.frictions, table.share))
        if share < 0.5:
            between = found.friction.interval_in_words(low, high)
            yield (
                f"at friction {between} only {100.0 * share:.0f} % of such flicks end "
                f"{table.outcome}; if nearly all of yours did, look elsewhere, or at the tilt rate"
            )


def _falls_line(found: Fit) -> str:
    """The number and direction of falls to each side, without writing errors."""
    parts = []
    # Without two humps there is nothing that a reading could be far from.
    left_out = found.strays if found.supported else np.zeros(len(found.directions), bool)
    for side, there in (
        ("left", found.directions > math.pi),
        ("right", found.directions <= math.pi),
    ):
        some = np.degrees(found.directions[there & ~left_out])
        if some.size:
            spread = f" ± {some.std(ddof=1):.1f}°" if some.size > 1 else ""
            parts.append(f"{some.size} to the {side} at {some.mean():.1f}°{spread}")
    if count := int(left_out.sum()):
        mistakes = "writing errors" if count > 1 else "a writing error"
        parts.append(unbroken(f"{count} left out as {mistakes}"))
    return f"{len(found.directions)} falls: " + ", ".join(parts)


def _estimate(one: Estimate) -> tuple[str, str]:
    return f"{one.friction:.3f}", one.in_words


def _degrees(angle: float) -> str:
    return f"{round(math.degrees(angle), 1) + 0.0:.1f}°"  # no minus before nothing
