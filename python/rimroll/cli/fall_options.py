"""Options of commands that follow many falls."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Annotated

import typer

from rimroll.cli.options import MotionOptions, whole
from rimroll.experiment.toppling import FALLING
from rimroll.options import Options
from rimroll.scenario import MAX_STEPS


@dataclass(frozen=True)
class FallOptions(MotionOptions):
    """Duration and accuracy of each of many falls."""

    duration: Annotated[
        str | None,
        typer.Option(
            help="Longest duration of a fall. [10 s]", metavar="TIME", rich_help_panel="Motion"
        ),
    ] = None
    rtol: Annotated[
        float | None,
        typer.Option(
            help="Intended relative error. [1e-6]", metavar="NUMBER", rich_help_panel="Motion"
        ),
    ] = None
    max_steps: Annotated[
        int | None,
        typer.Option(
            help="Largest number of solver steps of a fall. [100000]",
            metavar="NUMBER",
            parser=whole(1, MAX_STEPS),
            rich_help_panel="Motion",
        ),
    ] = None


def options_of_falls(given: FallOptions, read: Options) -> Options:
    """The options of many falls, with the defaults of :func:`rimroll.topple`.

    ``read`` holds the given values. From a scenario file, whose accuracy is that of a
    single motion, only gravity and topple tilt are used.
    """
    own = ("duration", "rtol", "max_steps")
    names = ("gravity", "topple_tilt", *(name for name in own if getattr(given, name) is not None))
    return replace(FALLING, **{name: getattr(read, name) for name in names})
