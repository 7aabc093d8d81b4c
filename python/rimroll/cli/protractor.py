"""``rimroll protractor``: a sheet to print and read the direction of fall on."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from rimroll._core import __version__
from rimroll.cli.formats import Forms, check, pictures, write
from rimroll.cli.options import (
    BodyOptions,
    JsonOption,
)
from rimroll.cli.request import requested
from rimroll.cli.screen import say, show_json

if TYPE_CHECKING:
    from matplotlib.figure import Figure

FORMS: Forms[Figure] = pictures(lambda sheet: sheet, dpi=300)


def protractor(
    body: BodyOptions,
    output: Annotated[
        Path,
        typer.Option(
            "--output", "-o", help="The sheet: .pdf to print, .svg or .png.", metavar="FILE"
        ),
    ] = Path("protractor.pdf"),
    paper: Annotated[str, typer.Option(help="a4 or letter.", metavar="NAME")] = "a4",
    json: JsonOption = False,
) -> int:
    """A sheet to print and to read directions of fall on.

    The rim at true size, degrees all round, and between which limits theory has it
    fall. Print it at actual size; a bar on it shows whether the printer did.

    Examples:

    $ rimroll protractor

    $ rimroll protractor soda_can --paper letter -o soda_can.pdf

    $ rimroll protractor my_cup.toml
    """
    check([output], FORMS)
    what = requested(body)
    from rimroll.experiment import protractor as sheets  # brings matplotlib, which is slow to load

    write(output, sheets.sheet(what.body, _title(what.name), paper), FORMS)
    rolling, sliding = sheets.falls(what.body)
    if json:
        show_json(
            {
                "rimroll_version": __version__,
                "body": what.name,
                "paper": paper,
                "falls": {"no_slip": rolling, "frictionless": sliding},
                "files": [str(output)],
            }
        )
    else:
        say(f"{what.name}: falls are expected between {rolling:.1f} (rolling) and {sliding:.1f}")
        say(f"(sliding), or between {360.0 - sliding:.1f} and {360.0 - rolling:.1f}")
        say(f"wrote {output}; print it at actual size (100 %)")
    return 0


def _title(name: str) -> str:
    """A body's name; that of a file without its folder and suffix."""
    return Path(name).stem if name.endswith(".toml") else name
