"""``rimroll simulate``: a whole motion, on the screen and in files."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated

import numpy as np
import typer

from rimroll import motion as motions
from rimroll.cli.contact import in_words
from rimroll.cli.files import FORMS, Record, summary
from rimroll.cli.formats import STDOUT, check, form_of, write
from rimroll.cli.hints import undecided_hints
from rimroll.cli.options import (
    BodyOptions,
    JsonOption,
    LawOptions,
    MotionOptions,
    ResistanceOptions,
    StartOptions,
    value_option,
    whole,
)
from rimroll.cli.request import Request, Shaking, requested
from rimroll.cli.screen import prose, say, show_json, working
from rimroll.cli.turn import body_line, show_turns, start_line
from rimroll.errors import RimrollError
from rimroll.files.recorded import ending_in_words
from rimroll.motion import Moments, Motion
from rimroll.motion.words import shaken_in_words
from rimroll.units import quantity

MAX_POINTS = 10_000_000

UNDECIDED = 3
"""The exit code where it is undecided whether a body on a table that moves overturns."""

SAMPLED = (".csv", ".nc", ".json")
"""The forms that hold the motion point by point."""

OutputOption = Annotated[
    list[Path] | None,
    typer.Option(
        "--output",
        "-o",
        help="Write a file; may be repeated. Its suffix says what: .csv, .nc or .json numbers,"
        " .png, .svg or .pdf nine panels, .gif, .html or .mp4 a film; - writes .csv to stdout.",
        metavar="FILE",
        rich_help_panel="Output",
    ),
]
PointsOption = Annotated[
    int | None,
    typer.Option(
        parser=whole(),
        help="Evenly spaced points in .csv, .nc and .json, instead of the solver's own steps.",
        metavar="NUMBER",
        rich_help_panel="Output",
    ),
]
EveryOption = Annotated[
    str | None,
    value_option("The same by their spacing, such as 1ms.", "TIME", "Output"),
]


def simulate(
    body: BodyOptions,
    start: StartOptions,
    motion: MotionOptions,
    law: LawOptions,
    resistances: ResistanceOptions,
    output: OutputOption = None,
    points: PointsOption = None,
    every: EveryOption = None,
    json: JsonOption = False,
) -> int:
    """A whole motion from a start: its turns, events and ending.

    Numbers, pictures and films go to files on request.
    The body rolls without slip unless another law is given.
    Without a start the body is let go at half its balance tilt, pushed aside a little.
    With --tilt 0 it stands, and --tilt-rate is a knock.
    In files, times may repeat where the contact changes: once as before, once as after.

    Examples:

    $ rimroll simulate coin -o coin.gif

    $ rimroll simulate --tilt 30deg --tilt-rate -0.5rad/s --yaw-rate 0.005

    $ rimroll simulate soda_can --tilt 20deg --yaw-rate 1deg/s -o can.png

    $ rimroll simulate --friction 0.2 --tilt 30deg --yaw-rate 0.005

    $ rimroll simulate --tilt 0 --tilt-rate 3rad/s

    $ rimroll simulate can_2007.toml -o can.csv --every 1ms
    """
    task = Output.checked(output, points, every, json)
    no_tilt = start.tilt is None
    return task.done(requested(body, start, motion, law, resistances, no_tilt, Shaking()))


@dataclass(frozen=True)
class Output:
    """The files and the answer that are asked for."""

    files: list[Path]
    points: int | None
    every: float | None
    json: bool

    @classmethod
    def checked(
        cls, output: list[Path] | None, points: int | None, every: str | None, json: bool
    ) -> Output:
        """What options ask for; raises ``RimrollError`` for what could not be written."""
        files = output or []
        check(files, FORMS, json)
        spacing = None if every is None else quantity(every, "s", "--every")
        _check_spacing(points, spacing, files)
        return cls(files, points, spacing, json)

    def done(self, what: Request) -> int:
        """Follow the motion and write and show it; returns the exit code."""
        computed = _follow(what)
        record = Record(computed, _moments(computed, self.points, self.every), what)
        for file in self.files:
            write(file, record, FORMS)
        if self.json:
            show_json({**summary(record), "files": [str(file) for file in self.files]})
        elif STDOUT not in self.files:
            _show(record, self.files)
        if computed.status == "failed":
            return 1
        is_undecided = computed.ground is not None and computed.overturned is None
        return UNDECIDED if is_undecided else 0


def _check_spacing(points: int | None, every: float | None, files: list[Path]) -> None:
    if points is not None and every is not None:
        raise RimrollError("--points and --every both space the points: give one")
    if points is not None and not 2 <= points <= MAX_POINTS:
        raise RimrollError(f"--points must be between 2 and {MAX_POINTS}, got {points}")
    if every is not None and not every > 0.0:
        raise RimrollError(f"--every must be > 0, got {every} s")
    spaced = any(form_of(file) in SAMPLED for file in files)
    if not spaced and (points is not None or every is not None):
        name = "--every" if points is None else "--points"
        raise RimrollError(f"{name} spaces the points of a file: give one with -o, as -o can.csv")


def _follow(what: Request) -> Motion:
    assert what.start is not None
    with working(f"following {what.name}") as bar:

        def progress(t: float) -> None:
            bar(int(1000 * t / what.options.duration), 1000, "")

        return motions.simulate(
            what.body,
            what.start,
            what.law,
            ground=what.ground,
            progress=progress,
            options=what.options,
        )


def _moments(motion: Motion, points: int | None, every: float | None) -> Moments:
    """The motion at its own steps, or evenly spaced."""
    last = float(motion.t[-1])
    if points is not None:
        return motion.evaluate(np.linspace(0.0, last, points))
    if every is None:
        return motion
    count = last / every
    if count >= MAX_POINTS:
        raise RimrollError(f"--every {every} s makes more than {MAX_POINTS} points in {last:.6g} s")
    return motion.evaluate(np.minimum(every * np.arange(int(count * (1.0 + 1e-12)) + 1), last))


def _show(record: Record, files: list[Path]) -> None:
    motion = record.motion
    prose(body_line(record.request.name, motion.body))
    prose(start_line(motion, record.request.nudged))
    if motion.ground is None:
        show_turns(motion)
        if motion.start.is_knocked:
            prose(shaken_in_words(motion), 0)
    else:
        _show_shaken(motion)
    if len(motion.phases) > 1:
        prose("phases: " + ", ".join(_phases(motion)))
    _show_losses(motion)
    kinds = Counter(event.kind for event in motion.events)
    if kinds:
        prose(
            "events: "
            + ", ".join(f"{count} {ending_in_words(kind)}" for kind, count in kinds.items())
        )
    for file in files:
        say(f"wrote {file}")


def _show_shaken(motion: Motion) -> None:
    say()
    prose(f"{in_words(motion.law)}: {motion.message_in_degrees}")
    prose(shaken_in_words(motion), 0)
    if motion.overturned is None:
        for hint in undecided_hints((motion.status,), motion.law, "--friction"):
            prose(hint)


def _phases(motion: Motion) -> list[str]:
    """The number and duration of the phases of each kind."""
    lines = []
    for kind in ("standing", "sliding_flat", "flying_level", "rolling", "sliding", "flying"):
        spans = [phase.end - phase.start for phase in motion.phases if phase.kind == kind]
        if spans:
            words = kind.replace("_", " ")
            lines.append(f"{len(spans)} {words} ({sum(spans):.4g} s in all)")
    return lines


def _show_losses(motion: Motion) -> None:
    """The energy at the start, the work of the ground and the losses; nothing without any.

    In J where a ground moves, as for columns, else in mJ, as for cans.
    """
    is_shaken = motion.ground is not None
    factor, unit = (1.0, "J") if is_shaken else (1e3, "mJ")
    losses = {
        "friction": motion.friction_loss[-1],
        "resistance": motion.resistance_loss[-1],
        "impacts" if is_shaken else "landing": motion.impact_loss[-1],
    }
    lost = [f"{factor * loss:.4g} {unit} to {to}" for to, loss in losses.items() if loss > 0.0]
    ends = [f"energy: {factor * motion.energy[0]:.4g} {unit} at the start"]
    if is_shaken:
        ends.append(f"{motion.ground_work[-1]:.4g} J from the ground")
        ends.append(f"{motion.energy[-1]:.4g} J at the end")
    if lost or is_shaken:
        prose(", ".join(ends) + ("; lost " + ", ".join(lost) if lost else ""))
