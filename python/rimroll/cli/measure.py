"""``rimroll measure``: a body from a ruler, scales and a stopwatch."""

from __future__ import annotations

import math
import textwrap
from pathlib import Path
from typing import Annotated, Any

import typer
from uncertainties import UFloat

from rimroll._core import __version__
from rimroll.bodies.solids import SIZES
from rimroll.cli.contact import option
from rimroll.cli.options import JsonOption, Texts, options, value_option
from rimroll.cli.screen import prose, say, show_json, table
from rimroll.errors import RimrollError, typed
from rimroll.experiment.measurement import Measurement, measured
from rimroll.experiment.readings import ESTIMATE, READINGS, UNITS, main_source, pretty
from rimroll.files.output import writing

INERTIA = {
    "mass": "mass m",
    "radius": "rim radius R",
    "height": "height of centre of mass H",
    "transverse_inertia": "transverse inertia A",
    "axial_inertia": "axial inertia C",
}
"""The numbers of a body, in words."""


@options(READINGS)
class MeasureOptions(Texts):
    """The readings."""


PivotOption = Annotated[
    str | None,
    value_option(
        "edge, or point: a hook or thread that lets it twist as it swings. [edge]",
        "PIVOT",
        "Swinging across (for C)",
    ),
]
FileOption = Annotated[
    Path | None,
    typer.Option(
        "--output",
        "-o",
        help="Write the body to a scenario file (.toml) for the other commands.",
        metavar="FILE",
        rich_help_panel="Output",
    ),
]


def measure(
    given: MeasureOptions,
    across_pivot: PivotOption = None,
    output: FileOption = None,
    json: JsonOption = False,
) -> int:
    """Your own can from a ruler, scales and a stopwatch.

    The numbers of a body are its mass, R, H, A and C.
    Needed: mass, radius or diameter, one way to balance it, one to move it (A).
    C is for whole motions: no limiting angle of turn depends on it.

    Readings may carry their uncertainty, one standard deviation: "70 ± 1 g",
    "70 +- 1 g", "6.9(1) cm". Without, it is half a unit of the last digit; for
    times at least 0.1 s, a hand's; for rocking 1/30 s, a frame of a film.

    Examples:

    $ rimroll measure --mass 70g --diameter 10.2cm --balance-point 6.9cm \\
          --swings 50 --swings-time 38.3s

    $ rimroll measure --mass 70g --radius 5.1cm --balance-tilt 36.5deg \\
          --rocking-tilt 25deg --rocking-time 0.43s -o my_can.toml
    """
    if output is not None and output.suffix.lower() != ".toml":
        raise RimrollError(f"cannot write {output}: its suffix must be .toml")
    found = measured(dict(vars(given)), across_pivot, option)
    if output is not None:
        try:
            with writing(output) as part:
                part.write_text(scenario_file(found, output), encoding="utf-8")
        except OSError as error:
            raise RimrollError(f"cannot write {output}: {error.strerror or error}") from error
    if json:
        show_json(_answer(found, output))
    else:
        _show(found, output)
    return 0


def _answer(found: Measurement, output: Path | None) -> dict[str, Any]:
    body = {name: getattr(found, name) for name in INERTIA}
    turns = {"no_slip": found.turn_no_slip, "frictionless": found.turn_frictionless}
    return {
        "rimroll_version": __version__,
        "body": {name: _both(number) for name, number in body.items()},
        "axial_inertia_measured": found.axial_inertia_measured,
        "turn_limit": {name: _both(number) for name, number in turns.items()},
        "needed_friction": _both(found.needed_friction),
        "readings": {name: _both(number) for name, number in found.readings.items()},
        "files": [str(output)] if output else [],
    }


def _both(number: UFloat) -> dict[str, float]:
    return {"value": number.nominal_value, "uncertainty": number.std_dev}


def _show(found: Measurement, output: Path | None) -> None:
    prose(f"read: {_readings(found)}", 6)
    say()
    rows = table("", "measured", "±", "mostly from")
    for name, words in INERTIA.items():
        _row(rows, words, getattr(found, name), SIZES[name].unit)
    _row(rows, "A/m", found.transverse_inertia / found.mass, "m^2")
    _row(rows, "turn limit, no-slip", found.turn_no_slip, "rad")
    _row(rows, "turn limit, frictionless", found.turn_frictionless, "rad")
    _row(rows, "needed friction", found.needed_friction, "1")
    say(rows)
    say()
    say("± is one standard deviation.")
    if not found.axial_inertia_measured:
        prose(ESTIMATED, 0)
    if output is not None:
        say(f"wrote {output}; now: rimroll turn {output}")


ESTIMATED = (
    "C is not measured but guessed, for a hollow vessel: evenly between mr²/2 (solid) and mr²"
    " (thin wall), r the radius of its widest part. No limiting angle of turn depends on it."
)


def _row(rows: Any, words: str, number: UFloat, unit: str) -> None:
    share = number.std_dev / number.nominal_value if number.nominal_value else math.inf
    by = f"{100.0 * share:.2g} %" if 0.0 < share < 1.0 else ""
    source = main_source(number)
    rows.add_row(words, pretty(number, unit), by, typed(source) if by else "")


def _readings(found: Measurement) -> str:
    """All readings with their uncertainties, in a line."""
    return ", ".join(
        f"{name.replace('_', ' ')} {pretty(number, UNITS[name])}"
        for name, number in found.readings.items()
    )


def scenario_file(found: Measurement, file: Path) -> str:
    """The text of a scenario file with the measured body, and where its numbers come from."""
    name = file.name if file.name.isprintable() else "body.toml"
    comments = [
        f"A measured body, by rimroll measure {__version__}:",
        f"    rimroll turn {name}",
        f"    rimroll simulate {name} --tilt 20deg --yaw-rate 0.005",
        "From these readings, ± one standard deviation:",
        *(f"    {key} = {pretty(read, UNITS[key])}" for key, read in found.readings.items()),
        *([] if found.axial_inertia_measured else textwrap.wrap(ESTIMATED, 88)),
        f"Limiting angles of turn: {pretty(found.turn_no_slip, 'rad')} without slip,"
        f" {pretty(found.turn_frictionless, 'rad')} without friction.",
    ]
    body = []
    for field in INERTIA:
        unit, number = SIZES[field].unit, getattr(found, field)
        guess = " (a guess)" if main_source(number) == ESTIMATE else ""
        line = f"{field} = {getattr(found.body, field)!r}"
        body.append(f"{line:44} # {unit.replace('^2', '²')}: {pretty(number, unit)}{guess}")
    return "\n".join([*(f"# {comment}" for comment in comments), "", "[body]", *body, ""])
