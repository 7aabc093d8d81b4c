"""Options that the commands of studies have in common."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from rimroll.errors import RimrollError
from rimroll.study.study import Study

StudyArgument = Annotated[Path, typer.Argument(help="The study, a TOML file.", metavar="STUDY")]

StoreOption = Annotated[
    Path | None,
    typer.Option(
        help="The folder with the results. [that of the file, or its name with .zarr]",
        metavar="PATH",
    ),
]

LargerOption = Annotated[
    bool,
    typer.Option("--larger-than-disk", help="Also if the results may not fit on the disk."),
]


def requested(path: Path) -> Study:
    """The study of a file; raises ``RimrollError``, which names the file."""
    if path.suffix.lower() != ".toml":
        raise RimrollError(f"a study is a .toml file, got {path}")
    return Study.from_file(path)


def place(study: Study, path: Path, store: Path | None) -> Path:
    """The folder of the results: as typed, as in the file, or named like the file."""
    return store or study.store or path.with_suffix(".zarr")
