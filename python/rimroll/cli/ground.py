"""Options of a motion of the ground."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from typing import Annotated, Any

import typer

from rimroll.cli.contact import option
from rimroll.cli.options import (
    BodyOptions,
    MotionOptions,
    StartOptions,
    pairs,
    value_option,
)
from rimroll.cli.request import Shaking, is_file
from rimroll.errors import RimrollError, typed
from rimroll.ground.described import NUMBERS, PULSES, Description
from rimroll.options import KINDS, ON_MOVING_TABLES, FlatLanding, flat_given
from rimroll.units import quantity

_PULSES = [typed(name) for name in PULSES]
_KINDS = [typed(name) for name in KINDS]

OPTION_OF = {"duration": "--pulse-duration", "rotation": "--rotate"}
"""Fields of a description whose options have other names."""


def _given(help: str, metavar: str, choices: Sequence[str] = (), panel: str = "Ground") -> object:
    return value_option(help, metavar, panel, choices)


@dataclass(frozen=True)
class RecordOptions:
    """Files of records."""

    record: Annotated[
        list[Path] | None,
        _given("AT2 files, one for each component, or a CSV file; more may follow it.", "FILE"),
    ] = None
    units: Annotated[
        str | None, _given("Unit of the record where its files name none.", "UNIT")
    ] = None
    pad: Annotated[
        bool,
        typer.Option(
            "--pad",
            help="Add zeros at the end of AT2 files that are shorter than others.",
            rich_help_panel="Ground",
            show_default=False,
        ),
    ] = False
    columns: Annotated[
        str | None,
        _given(
            "The columns of a table by name or number from 1, as in t=1,x=2,y=3. [found by name]",
            "COLUMNS",
        ),
    ] = None
    step: Annotated[
        str | None, _given("Time between the samples of a table without times.", "TIME")
    ] = None
    time_unit: Annotated[
        str | None,
        _given("Unit of a table's times where their name has none: ms, us or ns. [s]", "UNIT"),
    ] = None

    @property
    def layout(self) -> dict[str, Any]:
        """What is said of the columns of a table, as arguments of readers."""
        columns = None if self.columns is None else pairs("--columns", self.columns, "t=1,x=2,y=3")
        step = None if self.step is None else quantity(self.step, "s", "--step")
        return {"columns": columns, "step": step, "time_unit": self.time_unit}


@dataclass(frozen=True)
class GroundOptions(RecordOptions):
    """How the table moves."""

    headings: Annotated[
        str | None,
        _given(
            "Directions of AT2 files in place of their second lines: 0,90,up or N40E,N50W.", "LIST"
        ),
    ] = None
    pulse: Annotated[str | None, _given(f"{', '.join(_PULSES)}.", "NAME", _PULSES)] = None
    amplitude: Annotated[
        str | None, _given("Of the pulse: along x, or x,y,z as in 0.3g,1m/s2,0.", "ACCELERATION")
    ] = None
    period: Annotated[str | None, _given("Of sine, cosine and ricker; or x,y,z.", "TIME")] = None
    cycles: Annotated[str | None, _given("Periods of sine and cosine; or x,y,z. [1]", "NUMBER")] = (
        None
    )
    pulse_duration: Annotated[
        str | None, _given("Of half-sine and rectangular; or x,y,z.", "TIME")
    ] = None
    center: Annotated[str | None, _given("Time of the peak of ricker. [two periods]", "TIME")] = (
        None
    )
    scale: Annotated[str | None, _given("Multiply all accelerations.", "FACTOR")] = None
    rotate: Annotated[
        str | None, _given("Turn the ground about the vertical, from x toward y.", "ANGLE")
    ] = None


FLAT = (
    f"What follows where the base comes down flat: {', '.join(_KINDS)}, smooth:SEED, or a"
    " restitution."
)

FlatOption = Annotated[str | None, _given(f"{FLAT} [{ON_MOVING_TABLES}]", "HOW", _KINDS, "Table")]


@dataclass(frozen=True)
class LeanOptions(StartOptions):
    """A start that leans in some direction."""

    yaw: Annotated[
        str | None,
        _given("Where the tilt lifts the base: 0 is x, 90deg y. [0]", "ANGLE", (), "Start"),
    ] = None


@dataclass(frozen=True)
class ShakenOptions(MotionOptions):
    """Duration and accuracy of a motion on a table that moves."""

    duration: Annotated[
        str | None,
        _given("Duration of the motion. [10 s longer than the ground]", "TIME", (), "Motion"),
    ] = None
    flat_gap: Annotated[
        str | None,
        _given(
            "The base comes down flat also where its far side is this far above the table. [0]",
            "LENGTH",
            (),
            "Table",
        ),
    ] = None


def body_and_records(body: BodyOptions, files: Sequence[Path]) -> tuple[BodyOptions, list[Path]]:
    """What rolls, and the files of records; the first word may be a record, too."""
    given = body.body
    if given is not None and is_file(given) and not given.endswith(".toml"):
        return replace(body, body=None), [Path(given), *files]
    return body, list(files)


def requested_shaking(options: GroundOptions, more: Sequence[Path], flat: str | None) -> Shaking:
    """The ground that options describe; ``more`` are further files of the record.

    Raises ``RimrollError`` naming the option that is at fault.
    """
    numbers = {
        name: _three(text, unit, _called(name))
        for name, unit in NUMBERS.items()
        if (text := _text_of(options, name)) is not None
    }
    description = Description(
        record=[*(options.record or ()), *more],
        pulse=options.pulse,
        numbers=numbers,
        scale=_number(options.scale, "1", "--scale"),
        rotation=_number(options.rotate, "rad", "--rotate"),
        units=options.units,
        pad=options.pad,
        headings=None if options.headings is None else options.headings.split(","),
        **options.layout,
    )
    try:
        ground = description.made(_called)
    except RimrollError as error:
        raise error.called(OPTION_OF) from None
    return Shaking(ground, given_flat(flat), partial(description.changed, called=_called))


def given_flat(text: str | None) -> FlatLanding | None:
    """What ``--flat`` says; None where it says nothing."""
    return None if text is None else flat_given(text)


def _called(name: str) -> str:
    return OPTION_OF.get(name, option(name))


def _text_of(options: GroundOptions, name: str) -> str | None:
    text: str | None = getattr(options, _called(name).removeprefix("--").replace("-", "_"))
    return text


def _number(text: str | None, unit: str, name: str) -> float | None:
    return None if text is None else quantity(text, unit, name)


def _three(text: str, unit: str, name: str) -> float | list[float]:
    """One quantity, or three between commas."""
    parts = text.split(",")
    if len(parts) not in (1, 3):
        raise RimrollError(field=name, value=text, bound="one or three, x,y,z")
    values = [quantity(part, unit, name) for part in parts]
    return values[0] if len(values) == 1 else values
