"""``rimroll shake``: a body on a table that moves, as in an earthquake."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from rimroll.cli.ground import (
    FlatOption,
    GroundOptions,
    LeanOptions,
    ShakenOptions,
    body_and_records,
    requested_shaking,
)
from rimroll.cli.options import (
    BodyOptions,
    JsonOption,
    LawOptions,
    ResistanceOptions,
)
from rimroll.cli.request import requested
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
    motion: ShakenOptions,
    law: LawOptions,
    resistances: ResistanceOptions,
    flat: FlatOption = None,
    files: RecordArgument = None,
    output: OutputOption = None,
    points: PointsOption = None,
    every: EveryOption = None,
    json: JsonOption = False,
) -> int:
    """A body on a table that moves, as in an earthquake.

    The table moves as a record of an earthquake, or as a pulse. A slope of angle b is a
    rectangular pulse of g sin b with a gravity of g cos b. The body is rigid, without drums.
    The body stands unless a start is given, and rolls without slip unless another law is given.
    A --tilt-rate without a --tilt is a knock to a body that stands.
    A motion is followed until 10 s after the ground has come to rest, unless --duration is given.
    In files, times may repeat where the contact changes: once as before, once as after.
    The exit code is 3 if it is undecided whether the body overturns, as where the motion stops
    early or the ground still moves at its end; in JSON, overturned is then null. Where the body
    will stand is undecided, and null, while it still rocks.

    Examples:

    $ rimroll shake --pulse sine --amplitude 0.9g --period 0.3s --flat housner

    $ rimroll shake column.toml --scale 1.5 -o column.svg

    $ rimroll shake column.toml --friction 0.3 --json
    """
    task = Output.checked(output, points, every, json)
    body, more = body_and_records(body, files or ())
    shaking = requested_shaking(ground, more, flat)
    what = requested(body, start, motion, law, resistances, shaking=shaking)
    if what.ground is None:
        raise RimrollError(
            "nothing says how the ground moves: give --record, --pulse or a file; on a table at"
            " rest use rimroll simulate"
        )
    return task.done(what)
