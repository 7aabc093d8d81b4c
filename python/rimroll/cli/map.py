"""``rimroll map``: left or right, over a plane of starts."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
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
    StartOptions,
    ThreadsOption,
    ends,
    value_option,
    whole,
)
from rimroll.cli.request import Request, options_of_falls, requested
from rimroll.cli.screen import angle, prose, say, show_json, table, working
from rimroll.cli.turn import body_line
from rimroll.errors import RimrollError
from rimroll.experiment.release import Release
from rimroll.experiment.toppling import FALLING
from rimroll.files.recorded import FELL, ending_in_words
from rimroll.laws import IDEAL
from rimroll.many.ensemble import fell, outcomes
from rimroll.many.falls import Falls, Interrupted
from rimroll.many.left_or_right import map_falls, watershed_slope
from rimroll.state import State
from rimroll.theory.closed_forms import turn_limit

if TYPE_CHECKING:
    from matplotlib.figure import Figure

MAX_POINTS = 3000
"""The largest number of points in each direction of a map: nine million falls."""


@dataclass(frozen=True)
class PlaneOptions:
    """The plane of starts."""

    tilt: Annotated[
        str | None,
        value_option(
            "Tilt at the start. [that of a flick that topples the body]", "ANGLE", "Start"
        ),
    ] = None
    tilt_rate: Annotated[
        str | None,
        value_option(
            "Negative while falling toward upright. [that of the flick; with --tilt: 0]",
            "RATE",
            "Start",
        ),
    ] = None
    yaw_rates: Annotated[
        str,
        value_option("From left to right, such as -30..30deg/s.", "RANGE", "Start"),
    ] = "-1..1"
    spin_rates: Annotated[str, value_option("From bottom to top.", "RANGE", "Start")] = "-1..1"
    starts: Annotated[
        int,
        typer.Option(
            parser=whole(),
            help="Starts of the map, each way.",
            metavar="NUMBER",
            rich_help_panel="Start",
        ),
    ] = 120


MapOutputOption = Annotated[
    list[Path] | None,
    typer.Option(
        "--output",
        "-o",
        help="Write a file; may be repeated. Its suffix says what: .png, .svg or .pdf a picture,"
        " .csv, .nc or .json numbers; of a large map .nc is the smallest and quickest; - is .csv on"
        " stdout.",
        metavar="FILE",
        rich_help_panel="Output",
    ),
]


def _map(falls: Falls) -> Figure:
    from rimroll.many.map_figure import map_figure

    return map_figure(falls)


FORMS: Forms[Falls] = {**NUMBERS, **pictures(_map, dpi=300)}


def map(
    body: BodyOptions,
    plane: PlaneOptions,
    motion: FallOptions,
    law: LawOptions,
    resistances: ResistanceOptions,
    threads: ThreadsOption = None,
    output: MapOutputOption = None,
    json: JsonOption = False,
) -> int:
    """Left or right: the direction of fall over a plane of starts.

    The plane is that of yaw and spin rate. A body let go without either comes
    down flat; the smallest one decides.
    By default it is flicked so that it topples over.
    A scenario file gives body, start, law, gravity and topple tilt.

    Examples:

    $ rimroll map -o left_or_right.svg

    $ rimroll map --friction 0.15 --tilt 20deg --tilt-rate -5rad/s

    $ rimroll map soda_can --yaw-rates -0.1..0.1 --starts 50 -o near.nc
    """
    files = output or []
    check(files, FORMS, json)
    if not 2 <= plane.starts <= MAX_POINTS:
        raise RimrollError(f"--starts must be between 2 and {MAX_POINTS}, got {plane.starts}")
    yaw = rates(plane.yaw_rates, plane.starts, "--yaw-rates")
    spin = rates(plane.spin_rates, plane.starts, "--spin-rates")
    start = StartOptions(tilt=plane.tilt, tilt_rate=plane.tilt_rate)
    what = requested(body, start, motion, law, resistances)
    options = options_of_falls(motion, what.options, FALLING)
    what = replace(what, start=what.start or _flick(what), options=options)
    falls, cut_short = _follow(what, yaw, spin, threads)
    for file in files:
        write(file, falls, FORMS)
    if json:
        show_json({**summary(what, falls), "files": [str(file) for file in files]})
    elif STDOUT not in files:
        _show(what, falls, files)
    if cut_short:
        return 130
    return int(bool((falls["outcome"] == "failed").all()))


def rates(text: str, points: int, option: str) -> np.ndarray[Any, np.dtype[np.float64]]:
    """The rates of a range such as ``-30..30deg/s``, rad/s, evenly from one end to the other."""
    return np.linspace(*ends(text, "rad/s", option, "-1..1 or -30..30deg/s"), points)


def _flick(what: Request) -> State:
    release = Release.named("flick", what.body, what.options.gravity)
    return release.mean


def _follow(what: Request, yaw: Any, spin: Any, threads: int | None) -> tuple[Falls, bool]:
    """The map, and whether Ctrl-C cut it short."""
    assert what.start is not None
    with working(f"letting {what.name} fall") as bar:
        try:
            falls = map_falls(
                what.body,
                what.start,
                what.law,
                yaw,
                spin,
                what.options,
                threads,
                lambda done, total: bar(done, total, ""),
            )
        except Interrupted as interrupted:
            done = len(interrupted.falls["spin_rate"])
            if done < 2:
                raise  # a row is no map
            cut_short = f"after {done} of {len(spin)} spin rates"
            return interrupted.falls.with_attrs({"interrupted": cut_short}), True
    return falls, False


def summary(what: Request, falls: Falls) -> dict[str, Any]:
    """A map without its falls, as a dictionary."""
    directions = falls["direction"][fell(falls)]
    left, right = directions[directions > np.pi], directions[directions < np.pi]
    ideal = what.law in IDEAL
    tilt = falls.attrs["start_tilt"]
    theory = ideal and tilt < 0.5 * math.pi
    return {
        "parameters": falls.attrs,
        "yaw_rates": [float(falls["yaw_rate"][k]) for k in (0, -1)],
        "spin_rates": [float(falls["spin_rate"][k]) for k in (0, -1)],
        "outcomes": outcomes(falls),
        "left": _range(left),
        "right": _range(right),
        "nearest_to_opposite": float(np.abs(directions - np.pi).min()) if len(directions) else None,
        "watershed_slope": watershed_slope(what.body, tilt, what.law) if theory else None,
        "jump": _jump(turn_limit(what.body, what.law)) if ideal else None,
    }


def _jump(limit: float) -> float:
    """The angle between turns by as much to the left and to the right, up to half a turn."""
    return abs(math.remainder(2.0 * limit, 2.0 * math.pi))


def _range(directions: Any) -> dict[str, Any]:
    ends = [float(directions.min()), float(directions.max())] if len(directions) else None
    return {"falls": len(directions), "directions": ends}


def _show(what: Request, falls: Falls, files: list[Path]) -> None:
    found, attrs = summary(what, falls), falls.attrs
    prose(body_line(what.name, what.body))
    tilt, rate = angle(attrs["start_tilt"]), attrs["start_tilt_rate"]
    prose(f"{in_words(what.law)}; from tilt {tilt} at {rate:.4g} rad/s; {falls.size} starts:")
    for name in ("yaw_rates", "spin_rates"):
        low, high = found[name]
        say(f"{name.replace('_', ' ')} from {low:g} to {high:g} rad/s")
    say()
    rows = table("", "falls", "least direction", "largest")
    for side in ("left", "right"):
        ends = found[side]["directions"]
        rows.add_row(f"to the {side}", str(found[side]["falls"]), *([angle(e) for e in ends or ()]))
    for outcome, count in found["outcomes"].items():
        if outcome not in FELL:
            rows.add_row(ending_in_words(outcome), str(count))
    say(rows)
    say()
    assert what.start is not None
    for hint in release_hints(what.body, what.start, what.law, what.options):
        prose(hint)
    if found["nearest_to_opposite"] is not None:
        say(f"the fall nearest to straight opposite is {angle(found['nearest_to_opposite'])} off")
    if found["watershed_slope"] is not None:
        say(f"left and right part where the yaw rate is {found['watershed_slope']:.4f} spin rate;")
        say(f"there the direction jumps by {angle(found['jump'])}")
    if "interrupted" in attrs:
        say(f"interrupted {attrs['interrupted']}")
    for file in files:
        say(f"wrote {file}")
