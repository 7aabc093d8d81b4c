"""Options that the commands of studies have in common."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from rimroll.errors import RimrollError
from rimroll.study.plan import Plan
from rimroll.study.store import Store
from rimroll.study.study import Study

StudyArgument = Annotated[Path, typer.Argument(help="The study, a TOML file.", metavar="STUDY")]

StoredArgument = Annotated[
    Path,
    typer.Argument(help="The study, a TOML file, or the folder of its results.", metavar="STUDY"),
]

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


def place(study: Study, store: Path | None) -> Path:
    """The folder of the results: as typed, or that of the study of a file."""
    folder = store or study.store
    assert folder is not None
    return folder


def planned(study: Study, path: Path) -> Plan:
    """The plan of the study of a file; raises ``RimrollError``, which names the file."""
    try:
        return study.plan()
    except RimrollError as error:
        raise error.inside(f"{path}:") from None


def stored(path: Path, store: Path | None) -> tuple[Store, Plan | None]:
    """The store of the study of a file, with its plan; or the store in a folder.

    Raises ``RimrollError`` if the store is of another study.
    """
    if store is None and path.is_dir():
        return Store(path), None
    study = requested(path)
    opened = Store(place(study, store))
    plan = planned(study, path)
    opened.expect_study(plan)
    return opened, plan
