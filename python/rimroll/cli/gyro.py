"""``rimroll gyro``: turns and friction from the record of a gyroscope in the body."""

from __future__ import annotations

import math
import sys
from pathlib import Path
from typing import Annotated, Any

import typer

from rimroll.cli.fit import BodyByOption, ConfidenceOption, GravityOption, OutputOption
from rimroll.cli.fitted import fitted, show_fit
from rimroll.cli.formats import Forms, check, pictures, write, write_json
from rimroll.cli.options import (
    JsonOption,
    MotionOptions,
    pairs,
)
from rimroll.cli.request import requested
from rimroll.cli.screen import Bar, prose, say, show_json, table
from rimroll.cli.turn import body_line
from rimroll.errors import RimrollError
from rimroll.sensors.gyro.analysis import Analysis
from rimroll.sensors.gyro.collision import Collision
from rimroll.sensors.gyro.files import read
from rimroll.sensors.gyro.friction import Friction
from rimroll.sensors.gyro.reading import analyze
from rimroll.units import quantity

RecordArgument = Annotated[
    Path,
    typer.Argument(
        help="The record: a CSV file of phyphox or its zip, of PocketLab or Vernier, or any table"
        " with titles. - reads standard input.",
        metavar="FILE",
    ),
]
AxisOption = Annotated[
    str,
    typer.Option(
        help="The sensor's axis that points along the body: x, y, z or auto.", metavar="AXIS"
    ),
]
UnitsOption = Annotated[
    str | None,
    typer.Option(
        help="The unit of the rates where titles have none: rad/s or deg/s.", metavar="UNIT"
    ),
]
ColumnsOption = Annotated[
    str | None,
    typer.Option(
        help="The columns, by title or number from 1, as in t=1,x=gx,y=gy,z=gz. [found by title]",
        metavar="COLUMNS",
    ),
]
TimeUnitOption = Annotated[
    str | None,
    typer.Option(
        help="The unit of the times where their title has none: ms, us or ns. [s]", metavar="UNIT"
    ),
]
BetweenOption = Annotated[
    str | None,
    typer.Option(
        help='Read only the part between two times, such as one of several releases, as in "12 s,20'
        ' s". [the whole record]',
        metavar="TIMES",
    ),
]
FitOption = Annotated[
    bool,
    typer.Option(
        "--fit", help="Fit the whole motion, too: start, friction, sensor. Takes some seconds."
    ),
]
ResistanceOption = Annotated[
    bool,
    typer.Option(
        "--resistance", help="Fit the whole motion with a dry rolling resistance: implies --fit."
    ),
]
BodyErrorOption = Annotated[
    str | None,
    typer.Option(
        help="With --fit or --resistance: standard deviation of the body's lengths and moments of"
        " inertia. [1%]",
        metavar="PART",
    ),
]

BODY_ERROR = "1%"
"""The standard deviation of the body's numbers unless ``--body-error`` gives it."""


def gyro(
    record: RecordArgument,
    body: BodyByOption,
    axis: AxisOption = "auto",
    units: UnitsOption = None,
    columns: ColumnsOption = None,
    time_unit: TimeUnitOption = None,
    between: BetweenOption = None,
    gravity: GravityOption = None,
    confidence: ConfidenceOption = "95%",
    fit: FitOption = False,
    resistance: ResistanceOption = False,
    body_error: BodyErrorOption = None,
    output: OutputOption = None,
    json: JsonOption = False,
) -> int:
    """Turns and friction from the record of a gyroscope in the body.

    A phone or a classroom sensor in the can records its angular velocity.
    At each near-collision the direction of this jumps by the turn less 180 degrees: the veer.
    Give the body with the sensor inside.

    Examples:

    $ rimroll gyro rock.csv --body my_can.toml

    $ rimroll gyro rock.zip --body my_can.toml --axis y -o star.svg

    $ rimroll gyro rock.csv --body my_can.toml --fit
    """
    if body_error is not None and not (fit or resistance):
        raise RimrollError("--body-error needs --fit or --resistance: nothing else uses it")
    files = output or []
    check(files, FORMS)
    what = requested(body, motion=MotionOptions(gravity=gravity))
    taken = read(
        sys.stdin.buffer if str(record) == "-" else record,
        units=units,
        columns=None if columns is None else pairs("--columns", columns, "t=1,x=gx,y=gy,z=gz"),
        time_unit=time_unit,
        between=None if between is None else _times(between),
    )
    found = analyze(
        taken,
        what.body,
        axis=axis,
        gravity=what.options.gravity,
        confidence=quantity(confidence, "1", "--confidence"),
    )
    fitting = None
    if fit or resistance:
        given = BODY_ERROR if body_error is None else body_error
        deviation = quantity(given, "1", "--body-error")
        fitting = fitted(found, resistance, deviation)
    answer = {"body": what.name, **found.to_dict()}
    if fitting is not None:
        answer["fit"] = fitting.to_dict()
    for file in files:
        write(file, (found, answer), FORMS)
    if json:
        show_json(answer)
        return 0
    prose(body_line(what.name, what.body))
    say()
    prose(f"read {taken.source}")
    _show(found)
    if fitting is not None:
        show_fit(fitting)
    for file in files:
        say(f"wrote {file}")
    return 0


def _times(text: str) -> tuple[float, float]:
    times = text.split(",")
    if len(times) != 2:
        raise RimrollError(f'--between must be two times, as in "12 s,20 s", got {text}')
    start, end = (quantity(one.strip(), "s", "--between") for one in times)
    if not start < end:
        raise RimrollError(f"--between must be an earlier and a later time, got {text}")
    return start, end


def _numbers(part: Path, found: tuple[Analysis, dict[str, Any]], bar: Bar) -> None:
    write_json(part, found[1])


FORMS: Forms[tuple[Analysis, dict[str, Any]]] = {
    **pictures(lambda found: found[0].plot()),
    ".json": _numbers,
}

MAX_SHOWN = 12
"""Near-collisions in the table."""


def _show(found: Analysis) -> None:
    if found.record.simulated:
        prose("This record was simulated, not measured.")
    prose(_sensor_line(found))
    say()
    rows = table("near-collision", "tilts", "spin", "energy", "veer", "friction")
    shown = zip(found.collisions[:MAX_SHOWN], found.frictions, strict=False)
    for i, (one, friction) in enumerate(shown, 1):
        rows.add_row(
            f"{i} at {one.time:.3f} s",
            f"{math.degrees(one.tilt_before):.1f}°, {math.degrees(one.tilt_after):.1f}°",
            f"{one.spin_after:.2f}",
            _energy(one),
            f"{math.degrees(one.veer):.1f} ± {math.degrees(one.veer_error):.1f}°",
            "any" if found.friction is None else _interval(friction),
        )
    say(rows)
    if (more := len(found.collisions) - MAX_SHOWN) > 0:
        say(f"and {more} more")
    say()
    prose(
        "tilts: the largest before and after; spin: what is left just after, rad/s;"
        " energy: the part of it that is left; veer: the turn beyond 180°"
    )
    prose(
        "The errors hold for a round body: what a phone that is not round adds is not in them, nor"
        " in what is excluded."
    )
    say()
    limits = [f"{math.degrees(limit) - 180.0:.2f}°" for limit in found.limits]
    prose(f"limits of the veer: {limits[0]} rolling without slip, {limits[1]} without friction")
    if found.friction is not None:
        for sentence in verdicts(found.friction, found.confidence):
            prose(sentence)
    for note in found.notes:
        prose(f"Note: {note}")


def _energy(one: Collision) -> str:
    if one.energy_kept is None:
        return "unknown"
    error = "" if one.energy_kept_error is None else f" ± {100.0 * one.energy_kept_error:.0f}"
    return f"{100.0 * one.energy_kept:.0f}{error} %"


def _sensor_line(found: Analysis) -> str:
    import numpy as np

    rests = found.rests
    resting = sum(end - start for start, end in rests.spans)
    bias = np.degrees(rests.bias.mean(axis=0)) if rests.spans else np.zeros(3)
    name = "xyz"[int(np.argmax(np.abs(found.axis.direction)))]
    askew = math.degrees(math.acos(min(1.0, float(np.abs(found.axis.direction).max()))))
    return (
        f"rests for {resting:.1f} s: bias {bias[0]:.2f}, {bias[1]:.2f}, {bias[2]:.2f} degrees/s,"
        f" noise {math.degrees(rests.noise):.3f} degrees/s; the body's axis is the sensor's {name},"
        f" {askew:.1f}° ± {math.degrees(found.axis.error):.1f}° askew"
    )


def _interval(one: Friction | None) -> str:
    if one is None:
        return "rim may slide"
    if one.best is None or one.interval is None:
        return "none suits"
    low, high = one.interval
    return f"{low:.3f} or more" if high is None else f"{low:.3f} to {high:.3f}"


def verdicts(one: Friction, confidence: float) -> list[str]:
    """What the record says of friction, in sentences."""
    level = f"{100.0 * confidence:g} %"
    if one.best is None:
        return [
            "No dry friction gives such a veer from such a start: check the body, and whether the"
            " sensor is fixed in it."
        ]
    said = [f"friction {one.best:.3f}, {level}: {_interval(one)}"]
    said.append(f"rolling without slip: {'excluded' if one.excludes_rolling else 'possible'}")
    said.append(f"sliding without friction: {'excluded' if one.excludes_sliding else 'possible'}")
    return said
