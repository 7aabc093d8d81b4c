"""The options that commands share."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, make_dataclass, replace
from decimal import Decimal, InvalidOperation
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Self, TypeVar

import typer

from rimroll import laws
from rimroll.bodies.solids import SIZES
from rimroll.errors import RimrollError, typed
from rimroll.laws import surfaces
from rimroll.options import Options
from rimroll.scenario import MAX_STEPS, RESISTANCES, presets
from rimroll.state import START_NUMBERS
from rimroll.units import Quantity, quantities_of, quantity


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


T = TypeVar("T")


class Texts:
    """Options by name: what was typed for each, or None."""

    if TYPE_CHECKING:

        def __init__(self, **texts: Any) -> None: ...
        def __getattr__(self, name: str) -> Any: ...

    def with_texts(self, **texts: Any) -> Self:
        """A copy in which others were typed."""
        copied: Any = self  # type checkers do not know its options
        changed: Self = replace(copied, **texts)
        return changed


def options(
    panels: Mapping[str, Mapping[str, Quantity]] | None = None, *but: str
) -> Callable[[type[T]], type[T]]:
    """Make a dataclass of a class of options, and add one for each number that has a help.

    ``panels`` are the numbers by the panel of the help, ``but`` those that are left out.
    """
    added: list[tuple[str, Any, Any]] = [
        (one.option, Annotated[str | None, value_option(one.help, one.metavar, panel)], None)
        for panel, numbers in (panels or {}).items()
        for name, one in numbers.items()
        if one.help and name not in but
    ]

    def made(kind: type[T]) -> type[T]:
        base: type[T] = dataclass(frozen=True)(kind)
        namespace = {"__doc__": kind.__doc__, "__module__": kind.__module__}
        return make_dataclass(kind.__name__, added, bases=(base,), namespace=namespace, frozen=True)

    return made


def with_helps(numbers: Mapping[str, Quantity], **helps: str) -> dict[str, Quantity]:
    """Some of the numbers, with another help."""
    return {name: replace(numbers[name], help=help) for name, help in helps.items()}


@options({"Body": SIZES})
class BodyOptions(Texts):
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


@options({"Start": START_NUMBERS}, "yaw")
class StartOptions(Texts):
    """From where and how fast."""


def steps_option(help: str) -> Any:
    """The option of the largest number of steps."""
    return typer.Option(
        help=help, metavar="NUMBER", parser=whole(1, MAX_STEPS), rich_help_panel="Motion"
    )


@options({"Motion": quantities_of(Options)}, "flat_gap")
class _MotionOptions(Texts):
    pass


@options()
class MotionOptions(_MotionOptions):
    """Duration and accuracy of the motion."""

    max_steps: Annotated[int | None, steps_option("Largest number of solver steps. [1000000]")] = (
        None
    )


_FALLS = with_helps(
    quantities_of(Options),
    duration="Longest duration of a fall. [10 s]",
    rtol="Intended relative error. [1e-6]",
)


@options({"Motion": _FALLS})
class FallOptions(MotionOptions):
    """Duration and accuracy of each of many falls."""

    max_steps: Annotated[
        int | None, steps_option("Largest number of solver steps of a fall. [100000]")
    ] = None


_LAWS = [typed(name) for name in laws.LAWS]


PARAMETERS = {
    one.option: one
    for law in laws.LAWS.values()
    for one in quantities_of(law).values()
    if not one.is_list
}
"""The numbers of all laws by the options that give them."""


@options({"Table": PARAMETERS}, "restitution")
class LawOptions(Texts):
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


_RESISTING = {
    one.option: one for kind in RESISTANCES.values() for one in quantities_of(kind).values()
}


@options({"Table": {"restitution": PARAMETERS["restitution"]} | _RESISTING})
class ResistanceOptions(Texts):
    """Restitution of landings, and resistances besides friction."""


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


def ends(text: str, unit: str, option: str, examples: str) -> tuple[float, float]:
    """The ends of a range in an SI unit; a unit behind the second goes for both.

    Raises ``RimrollError`` naming the option, with examples, for what is no range that rises.
    """
    first, dots, last = text.partition("..")
    if not dots:
        raise RimrollError(field=option, value=text, bound=f"a range such as {examples}")
    if first.strip()[-1:].isdigit():
        first += last.strip().lstrip("+-−0123456789.eE")
    elif last.strip()[-1:].isdigit():
        raise RimrollError(f"must have its unit behind the second number, got {text!r}", option)
    low, high = quantity(first, unit, option), quantity(last, unit, option)
    if not low < high:
        raise RimrollError(f"must rise, got {text!r}", option)
    return low, high
