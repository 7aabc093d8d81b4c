"""Options of a motion of the ground."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from pathlib import Path
from typing import Annotated, Any

import typer

from rimroll.cli.contact import option
from rimroll.cli.options import (
    BodyOptions,
    MotionOptions,
    StartOptions,
    Texts,
    options,
    pairs,
    value_option,
    with_helps,
)
from rimroll.cli.request import Shaking, is_file
from rimroll.errors import RimrollError, typed
from rimroll.ground.described import CHANGES, NUMBERS, PULSES, Description
from rimroll.options import KINDS, ON_MOVING_TABLES, FlatLanding, Options, flat_given
from rimroll.state import START_NUMBERS
from rimroll.units import quantities_of, quantity

_PULSES = [typed(name) for name in PULSES]
_KINDS = [typed(name) for name in KINDS]

OPTION_OF = {name: option(one.option) for name, one in (NUMBERS | CHANGES).items()}
"""The options of the numbers of a ground."""


def _given(help: str, metavar: str, choices: Sequence[str] = (), panel: str = "Ground") -> object:
    return value_option(help, metavar, panel, choices)


@options()
class RecordOptions(Texts):
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


@options({"Ground": NUMBERS | CHANGES})
class GroundOptions(RecordOptions):
    """How the table moves."""

    headings: Annotated[
        str | None,
        _given(
            "Directions of AT2 files in place of their second lines: 0,90,up or N40E,N50W.", "LIST"
        ),
    ] = None
    pulse: Annotated[str | None, _given(f"{', '.join(_PULSES)}.", "NAME", _PULSES)] = None


FLAT = (
    f"What follows where the base comes down flat: {', '.join(_KINDS)}, smooth:SEED, or a"
    " restitution."
)

FlatOption = Annotated[str | None, _given(f"{FLAT} [{ON_MOVING_TABLES}]", "HOW", _KINDS, "Table")]


@options({"Start": {"yaw": START_NUMBERS["yaw"]}})
class LeanOptions(StartOptions):
    """A start that leans in some direction."""


_DURATION = "Duration of the motion. [10 s longer than the ground]"


@options(
    {
        "Motion": with_helps(quantities_of(Options), duration=_DURATION),
        "Table": {"flat_gap": quantities_of(Options)["flat_gap"]},
    }
)
class ShakenOptions(MotionOptions):
    """Duration and accuracy of a motion on a table that moves."""


def body_and_records(body: BodyOptions, files: Sequence[Path]) -> tuple[BodyOptions, list[Path]]:
    """What rolls, and the files of records; the first word may be a record, too."""
    given = body.body
    if given is not None and is_file(given) and not given.endswith(".toml"):
        return body.with_texts(body=None), [Path(given), *files]
    return body, list(files)


def requested_shaking(given: GroundOptions, more: Sequence[Path], flat: str | None) -> Shaking:
    """The ground that options describe; ``more`` are further files of the record.

    Raises ``RimrollError`` naming the option that is at fault.
    """
    numbers = {
        name: _three(text, one.unit, _called(name))
        for name, one in NUMBERS.items()
        if (text := getattr(given, one.option)) is not None
    }
    changes = {
        name: one.read(text, _called(name))
        for name, one in CHANGES.items()
        if (text := getattr(given, one.option)) is not None
    }
    description = Description(
        record=[*(given.record or ()), *more],
        pulse=given.pulse,
        numbers=numbers,
        scale=changes.get("scale"),
        rotation=changes.get("rotation"),
        units=given.units,
        pad=given.pad,
        headings=None if given.headings is None else given.headings.split(","),
        **given.layout,
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


def _three(text: str, unit: str, name: str) -> float | list[float]:
    """One quantity, or three between commas."""
    parts = text.split(",")
    if len(parts) not in (1, 3):
        raise RimrollError(field=name, value=text, bound="one or three, x,y,z")
    values = [quantity(part, unit, name) for part in parts]
    return values[0] if len(values) == 1 else values
