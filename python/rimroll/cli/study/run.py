"""``rimroll study run``: compute what is not done of a study."""

from __future__ import annotations

import re
from typing import Annotated, Any

import typer

from rimroll.cli.options import whole
from rimroll.cli.screen import say
from rimroll.cli.study.options import (
    LargerOption,
    StoreOption,
    StudyArgument,
    place,
    planned,
    requested,
)
from rimroll.cli.study.progress import watching
from rimroll.errors import RimrollError
from rimroll.study.progress import status_of
from rimroll.study.runner import run as compute
from rimroll.study.size import expect_room


def _number(help: str) -> Any:
    """An option that is a number of processes or threads."""
    return typer.Option(help=help, metavar="NUMBER", parser=whole(least=1, most=10_000))


WorkersOption = Annotated[
    Any, _number("Number of processes on this machine to compute on; they share its processors.")
]

SchedulerOption = Annotated[
    str | None,
    typer.Option(help="Compute on a running Dask cluster: its address.", metavar="ADDRESS"),
]

ThreadsOption = Annotated[
    Any, _number("Threads in this process; one for each processor by default.")
]

ChunksOption = Annotated[
    str | None,
    typer.Option(
        help="Compute only these chunks, as 120:240, from the first to before the second.",
        metavar="A:B",
    ),
]

OtherVersionsOption = Annotated[
    bool,
    typer.Option(
        "--other-versions",
        help="Also continue a store, and use workers, of another build or version of rimroll, NumPy"
        " or SciPy; numbers may differ.",
    ),
]


def run(
    study: StudyArgument,
    store: StoreOption = None,
    larger: LargerOption = False,
    workers: WorkersOption = None,
    scheduler: SchedulerOption = None,
    threads: ThreadsOption = None,
    chunks: ChunksOption = None,
    other: OtherVersionsOption = False,
) -> int:
    """Compute what is not done of a study, into its store.

    Chunks that are done are kept, so run it again after Ctrl-C, a crash or a full disk.
    Jobs that compute other chunks, as of a Slurm array, share a store.

    Examples:

    $ rimroll study run falls.toml

    $ rimroll study run falls.toml --workers 4

    $ rimroll study run falls.toml --scheduler tcp://10.0.0.1:8786

    $ rimroll study run falls.toml --chunks 120:240
    """
    what = requested(study)
    folder = place(what, store)
    asked = planned(what, study)
    if not larger and not folder.exists():
        expect_room(asked, folder)
    with watching() as watcher:
        try:
            filled = compute(
                asked,
                folder,
                chunks=_range(chunks),
                workers=workers,
                scheduler=scheduler,
                threads=threads,
                other_versions=other,
                progress=watcher.progress,
                note=watcher.note,
            )
        except KeyboardInterrupt:
            watcher.note("what is done is kept: run again to continue")
            raise
    found = status_of(filled)
    say(f"{folder}: {found.motions_done:,} of {found.motions:,} motions are done")
    return 0


def _range(text: str | None) -> range | None:
    if text is None:
        return None
    found = re.fullmatch(r"\s*(\d+)\s*:\s*(\d+)\s*", text)
    if found is None:
        raise RimrollError(f"--chunks must be two whole numbers such as 120:240, got {text!r}")
    return range(int(found[1]), int(found[2]))
