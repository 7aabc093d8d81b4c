"""The options that commands share."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass, fields, make_dataclass
from decimal import Decimal, InvalidOperation
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from rimroll import laws
from rimroll.errors import RimrollError, typed
from rimroll.laws import Parameter, surfaces
from rimroll.laws.parameters import RESTITUTION
from rimroll.scenario import MAX_STEPS, presets


def whole(least: int | None = None, most: int | None = None) -> Callable[[str], int]:
    """A parser of whole numbers, also as 1e3, with error messages."""

    def read(text: str | int) -> int:
        try:
            number = Decimal(str(text).strip())
        except InvalidOperation:
            number = Decimal("NaN")
        if not number.is_finite() or number.adjusted() > 30 or number != number.to_integral():
            raise typer.BadParameter(f"must be a whole number such as 42, got {str(text)!r}")
        if (least is not None and number < least) or (most is not None and number > most):
            raise typer.BadParameter(f"must be between {least} and {most}, got {text}")
        return int(number)

    return read


def value_option(help: str, metavar: str, panel: str, choices: Iterable[str] = ()) -> Any:
    """An option with a value in a panel of the help."""
    return typer.Option(
        help=help, metavar=metavar, rich_help_panel=panel, autocompletion=completing(choices)
    )


def completing(choices: Iterable[str]) -> Callable[[str], list[str]] | None:
    """The completion of a word for a shell; None without choices."""
    known = list(choices)

    def those_that_begin(incomplete: str) -> list[str]:
        return [name for name in known if name.startswith(incomplete)]

    return those_that_begin if known else None


@dataclass(frozen=True)
class BodyOptions:
    """What rolls: a preset with its arguments, a file, or five numbers."""

    body: Annotated[
        str | None,
        typer.Argument(
            help="A name from rimroll bodies, or a scenario file (.toml) with body, start, law and"
            " more, whose values options replace; the paper's can, can_2007, unless given.",
            metavar="BODY",
            show_default=False,
            autocompletion=completing(presets()),
        ),
    ] = None
    scenario: Annotated[
        Path | None,
        # Earlier than a file as BODY.
        typer.Option(hidden=True),
    ] = None
    fill: Annotated[
        str | None, value_option("How full soda_can or beer_bottle is: 0.5 or 50%.", "PART", "Body")
    ] = None
    radius: Annotated[
        str | None,
        value_option(
            "Radius of the rim: of ring, disk, cylinder, or your own body.", "LENGTH", "Body"
        ),
    ] = None
    length: Annotated[str | None, value_option("Length of cylinder.", "LENGTH", "Body")] = None
    mass: Annotated[
        str | None, value_option("Mass of cylinder, or of your own body.", "MASS", "Body")
    ] = None
    density: Annotated[
        str | None,
        value_option("Density of cylinder: 2700kg/m3 is stone. [that of water]", "DENSITY", "Body"),
    ] = None
    height: Annotated[
        str | None, value_option("Height of its centre of mass above the base.", "LENGTH", "Body")
    ] = None
    transverse_inertia: Annotated[
        str | None,
        value_option(
            "A, about an axis through the centre of mass across the body.", "INERTIA", "Body"
        ),
    ] = None
    axial_inertia: Annotated[
        str | None, value_option("C, about the symmetry axis.", "INERTIA", "Body")
    ] = None


@dataclass(frozen=True)
class StartOptions:
    """From where and how fast."""

    tilt: Annotated[
        str | None, value_option("Tilt at the start; 0 is upright, base flat.", "ANGLE", "Start")
    ] = None
    tilt_rate: Annotated[
        str | None, value_option("Negative while falling toward upright. [0]", "RATE", "Start")
    ] = None
    yaw_rate: Annotated[
        str | None, value_option("How fast the contact point goes round. [0]", "RATE", "Start")
    ] = None
    spin_rate: Annotated[
        str | None, value_option("About the symmetry axis. [0]", "RATE", "Start")
    ] = None


@dataclass(frozen=True)
class MotionOptions:
    """Duration and accuracy of the motion."""

    duration: Annotated[
        str | None, value_option("Duration of the motion. [2 s]", "TIME", "Motion")
    ] = None
    gravity: Annotated[
        str | None, value_option("The paper used 9.8. [9.80665 m/s^2]", "ACCELERATION", "Motion")
    ] = None
    topple_tilt: Annotated[
        str | None,
        value_option("Tilt that counts as toppled. [90 deg; a disk: none]", "ANGLE", "Motion"),
    ] = None
    rtol: Annotated[
        float | None, value_option("Intended relative error. [1e-10]", "NUMBER", "Motion")
    ] = None
    max_steps: Annotated[
        int | None,
        typer.Option(
            help="Largest number of solver steps. [1000000]",
            metavar="NUMBER",
            parser=whole(1, MAX_STEPS),
            rich_help_panel="Motion",
        ),
    ] = None


_LAWS = [typed(name) for name in laws.LAWS]


@dataclass(frozen=True)
class _LawOptions:
    """How the rim meets the table."""

    law: Annotated[
        str | None,
        value_option(
            f"{', '.join(_LAWS)}. [no-slip; with --friction: coulomb]",
            "LAW",
            "Table",
            _LAWS,
        ),
    ] = None
    surface: Annotated[
        str | None,
        value_option(
            "Dry friction, typical values: metal on"
            f" {', '.join(name for name in surfaces.SURFACES if name != 'stone')}; stone on stone.",
            "NAME",
            "Table",
            surfaces.SURFACES,
        ),
    ] = None


@dataclass(frozen=True)
class ResistanceOptions:
    """Restitution of landings, and resistances besides friction."""

    restitution: Annotated[
        str | None,
        value_option(RESTITUTION.help, "NUMBER", "Table"),
    ] = None
    rolling_resistance: Annotated[
        str | None,
        value_option("Resisting force over normal force, against rolling.", "NUMBER", "Table"),
    ] = None
    rolling_viscous: Annotated[
        str | None,
        value_option("Resisting force over rolling speed, in N s/m.", "NUMBER", "Table"),
    ] = None
    pivoting_friction: Annotated[
        str | None,
        value_option(
            "Resisting moment over normal force, against turning about the vertical.",
            "LENGTH",
            "Table",
        ),
    ] = None
    air_drag: Annotated[
        str | None,
        value_option(
            "Power over (yaw rate)^exponent, in W (s/rad)^exponent, or film: a film of"
            " air under the base.",
            "NUMBER",
            "Table",
        ),
    ] = None
    air_exponent: Annotated[
        str | None, value_option("1.5 to 8; a viscous film has 4. [4]", "NUMBER", "Table")
    ] = None


PARAMETERS: dict[str, Parameter] = {
    parameter.option: parameter
    for law in laws.LAWS.values()
    for parameter in laws.parameters_of(law).values()
    if not parameter.is_list
}
"""The numbers of all laws by the options that give them."""

_METAVARS = {"m/s": "SPEED"}

if TYPE_CHECKING:
    LawOptions = _LawOptions
else:
    LawOptions = make_dataclass(
        "LawOptions",
        [
            (
                name,
                Annotated[
                    str | None,
                    value_option(parameter.help, _METAVARS.get(parameter.unit, "NUMBER"), "Table"),
                ],
                None,
            )
            for name, parameter in PARAMETERS.items()
            if name not in {field.name for field in fields(ResistanceOptions)}
        ],
        bases=(_LawOptions,),
        frozen=True,
    )


ThreadsOption = Annotated[
    int | None,
    typer.Option(
        parser=whole(),
        help="Number of threads; it does not affect the results. [one for each processor]",
        metavar="NUMBER",
    ),
]

JsonOption = Annotated[
    bool,
    typer.Option("--json", help="Answer in JSON, in SI units and radians; errors too, on stderr."),
]


def pairs(option: str, text: str, example: str) -> dict[str, str]:
    """The names and values of an option such as ``t=1,x=2``."""
    parts = [part.partition("=") for part in text.split(",")]
    if not all(equals for _, equals, _ in parts):
        raise RimrollError(field=option, value=text, bound=f"as in {example}")
    return {name.strip(): value.strip() for name, _, value in parts}
