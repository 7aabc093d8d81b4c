"""``rimroll shake``: a body on a table that moves, as in an earthquake."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Annotated

import typer

from rimroll.cli.ground import GroundOptions, LeanOptions, requested_shaking
from rimroll.cli.options import (
    BodyOptions,
    JsonOption,
    LawOptions,
    MotionOptions,
    ResistanceOptions,
)
from rimroll.cli.request import is_file, requested
from rimroll.cli.simulate import EveryOption, Output, OutputOption, PointsOption
from rimroll.errors import RimrollError

RecordArgument = Annotated[
    list[Path] | None,
    typer.Argument(help="Files of the record, as with --record.", metavar="RECORD"),
]


def shake(
    body: BodyOptions,
    ground: GroundOptions,
    start: LeanOptions,
    motion: MotionOptions,
    law: LawOptions,
    resistances: ResistanceOptions,
    files: RecordArgument = None,
    output: OutputOption = None,
    points: PointsOption = None,
    every: EveryOption = None,
    json: JsonOption = False,
) -> int:
    """A body on a table that moves, as in an earthquake.

    The table moves as a record of an earthquake, or as a pulse.
    The body stands unless a start is given, and rolls without slip unless another law is given.
    A motion is followed until 10 s after the ground has come to rest, unless --duration is given.
    In files, times may repeat where the contact changes: once as before, once as after.

    Examples:

    $ rimroll shake --pulse sine --amplitude 0.9g --period 0.3s --flat housner

    $ rimroll shake examples/column.toml --scale 1.5 -o column.svg

    $ rimroll shake examples/column.toml --friction 0.3 --json
    """
    task = Output.checked(output, points, every, json)
    given, more = body.body, list(files or ())
    if given is not None and is_file(given) and not given.endswith(".toml"):
        more, body = [Path(given), *more], replace(body, body=None)
    shaking = requested_shaking(ground, more)
    what = requested(body, start, motion, law, resistances, shaking=shaking)
    if what.ground is None:
        raise RimrollError("nothing says how the ground moves: give --record, --pulse or a file")
    return task.done(what)
