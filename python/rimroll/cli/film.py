"""``rimroll film``: the friction from a filmed track of the body."""

from __future__ import annotations

import math
import sys
from pathlib import Path
from typing import Annotated, Any

import typer

from rimroll.cli.fit import BodyByOption, ConfidenceOption, GravityOption, OutputOption
from rimroll.cli.fitted import first_law, numbers_table
from rimroll.cli.formats import Forms, check, pictures, write, write_json
from rimroll.cli.gyro import BODY_ERROR
from rimroll.cli.options import (
    JsonOption,
    MotionOptions,
    pairs,
)
from rimroll.cli.request import requested
from rimroll.cli.screen import Bar, prose, say, show_json, working
from rimroll.cli.turn import body_line
from rimroll.errors import RimrollError
from rimroll.sensors.filmed.track import Track, read
from rimroll.sensors.filmed.track_fit import fit_track
from rimroll.sensors.filmed.track_result import TrackFit
from rimroll.units import quantity

TrackArgument = Annotated[
    Path,
    typer.Argument(
        help="The track: what Tracker exports, or any table with the columns t, x and y, or t and"
        " tilt, with or without heading. - reads standard input.",
        metavar="FILE",
    ),
]
MarkerOption = Annotated[
    str | None,
    typer.Option(
        help="Of a path: the marker's distance from the axis and its height above the base, as in"
        ' "0 mm,12 cm".',
        metavar="LENGTHS",
    ),
]
ErrorOption = Annotated[
    str | None,
    typer.Option(
        help="Standard deviation of a position or an angle. [1 mm or 1 deg]", metavar="ERROR"
    ),
]
NameOption = Annotated[
    str | None,
    typer.Option(
        help="The name of the mass in Tracker, where the file has several.", metavar="NAME"
    ),
]
UnitsOption = Annotated[
    str | None,
    typer.Option(
        help="Units of columns whose titles have none, as in x=cm,y=cm. [s and m]", metavar="UNITS"
    ),
]
ColumnsOption = Annotated[
    str | None,
    typer.Option(
        help="The columns, by title or number from 1, as in t=1,x=2,y=3. [found by title]",
        metavar="COLUMNS",
    ),
]
ResistanceOption = Annotated[
    bool, typer.Option("--resistance", help="Fit a dry rolling resistance, too.")
]
BodyErrorOption = Annotated[
    str,
    typer.Option(
        help="Standard deviation of the body's lengths and moments of inertia.", metavar="PART"
    ),
]


def film(
    track: TrackArgument,
    body: BodyByOption,
    marker: MarkerOption = None,
    error: ErrorOption = None,
    name: NameOption = None,
    units: UnitsOption = None,
    columns: ColumnsOption = None,
    gravity: GravityOption = None,
    confidence: ConfidenceOption = "95%",
    resistance: ResistanceOption = False,
    body_error: BodyErrorOption = BODY_ERROR,
    output: OutputOption = None,
    json: JsonOption = False,
) -> int:
    """Friction from the filmed track of a marker, or of the lean.

    A camera straight above films a dot on the lid, while a hand holds the body and lets it go.
    The motion is fitted up to the largest tilt after the first near-collision.

    Examples:

    $ rimroll film dot.txt --body can_2007 --marker "0 mm,12 cm"

    $ rimroll film lean.csv --body my_can.toml --error 2deg -o film.svg
    """
    files = output or []
    check(files, FORMS)
    what = requested(body, motion=MotionOptions(gravity=gravity))
    taken = read(
        sys.stdin.buffer if str(track) == "-" else track,
        mass=name,
        units=None if units is None else pairs("--units", units, "x=cm,y=cm"),
        columns=None if columns is None else _columns(columns),
    )
    unit = "m" if taken.kind == "path" else "rad"
    point, sigma = _marker(taken, marker), None
    if error is not None:
        sigma = quantity(error, unit, "--error")
    with working("fitting") as bar:
        found = fit_track(
            taken,
            what.body,
            first_law(what.body, resistance),
            marker=point,
            error=sigma,
            gravity=what.options.gravity,
            confidence=quantity(confidence, "1", "--confidence"),
            body_error=quantity(body_error, "1", "--body-error"),
            progress=lambda done, total: bar(done, total, ""),
        )
    answer = {"body": what.name, **found.to_dict()}
    for file in files:
        write(file, (found, answer), FORMS)
    if json:
        show_json(answer)
        return 0
    prose(body_line(what.name, what.body))
    say()
    prose(f"read {taken.source}")
    say()
    _show(found)
    for file in files:
        say(f"wrote {file}")
    return 0


def _marker(track: Track, text: str | None) -> tuple[float, float] | None:
    if text is None:
        if track.kind == "path":
            raise RimrollError(
                "a path needs --marker: the marker's distance from the axis and its height above"
                ' the base, as in "0 mm,12 cm"'
            )
        return None
    if track.kind != "path":
        raise RimrollError(f"--marker needs a path; the track shows the {track.kind}")
    lengths = text.split(",")
    if len(lengths) != 2:
        raise RimrollError(f'--marker must be two lengths, as in "0 mm,12 cm", got {text}')
    beside, height = (quantity(one.strip(), "m", "--marker") for one in lengths)
    return beside, height


def _columns(text: str) -> dict[str, str | int]:
    named = pairs("--columns", text, "t=1,x=2,y=3")
    return {name: int(place) if place.isdecimal() else place for name, place in named.items()}


def _show(fit: TrackFit) -> None:
    path = fit.track.kind == "path"
    left = f"{1e3 * fit.residual:.2f} mm" if path else f"{math.degrees(fit.residual):.2f} degrees"
    prose(
        f"fit up to the first largest tilt, at {fit.t[-1]:.3f} s: {len(fit.t)} of"
        f" {len(fit.track.t)} samples, residual {left}"
    )
    shown = ("friction", "rolling_dry", "tilt", "tilt_rate", "yaw_rate", "spin_rate", "release")
    of_film = ("camera", "scale") if path else ()
    say(numbers_table(fit.numbers, [one for one in (*shown, *of_film) if one in fit.numbers]))
    for note in fit.notes:
        prose(f"Note: {note}")


def _numbers(part: Path, found: tuple[TrackFit, dict[str, Any]], bar: Bar) -> None:
    write_json(part, found[1])


FORMS: Forms[tuple[TrackFit, dict[str, Any]]] = {
    **pictures(lambda found: found[0].plot()),
    ".json": _numbers,
}
