"""``rimroll reproduce``: the paper's numbers and figures, done again."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from rimroll.cli.options import JsonOption
from rimroll.cli.screen import show_json, working


def reproduce(
    output: Annotated[
        Path,
        typer.Option(
            "--output", "-o", help="The folder to write to; made if needed.", metavar="FOLDER"
        ),
    ] = Path("out/paper"),
    json: JsonOption = False,
) -> int:
    """The paper's numbers, figures and film redone as one page.

    The page stands by itself; figures and numbers.json lie beside it.

    Example:

    $ rimroll reproduce --output out/paper
    """
    with working("redoing the paper") as bar:
        from rimroll.paper import report  # brings matplotlib, which is slow to load

        page = report.reproduce(output, bar).resolve()
    if json:
        show_json({"report": str(page)})
    else:
        print(f"The report is at {page}")
    return 0
