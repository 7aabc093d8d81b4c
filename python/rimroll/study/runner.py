"""Running a study: in this process, on processes of this machine, or on a running scheduler."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable
from contextlib import nullcontext
from typing import TYPE_CHECKING, Any

from rimroll.errors import RimrollError
from rimroll.study.claim import claimed
from rimroll.study.store import Store
from rimroll.study.uninterrupted import uninterrupted
from rimroll.study.work import work_through

if TYPE_CHECKING:
    from rimroll.study.plan import Plan

Progress = Callable[[int, int], object]
"""Takes how many rows are done, and how many the chunks of the run have."""

Note = Callable[[str], object]
"""Takes a sentence that users should read."""


class Unfinished(RimrollError):
    """Chunks that could not be computed; all others are done."""


def run(
    plan: Plan,
    path: str | os.PathLike[str],
    *,
    chunks: range | None = None,
    workers: int | None = None,
    scheduler: str | None = None,
    client: Any = None,
    threads: int | None = None,
    other_versions: bool = False,
    progress: Progress = lambda done, total: None,
    note: Note = lambda text: None,
) -> Store:
    """Compute the chunks of a study that are not done, and return its store.

    Parameters
    ----------
    plan, path
        The study, and the folder of its store, which is made unless it is there.
    chunks
        Numbers of the chunks to compute; all by default. Runs whose chunks differ can share a
        store at the same time.
    workers
        Computes on so many processes of this machine, which share its processors.
    scheduler, client
        Computes on a running Dask cluster: its address, or a client of it. Its workers need the
        same version of rimroll, and must see the store at the same path.
    threads
        Threads in this process, by default one for each processor.
    other_versions
        Also continues a store, and computes on workers, of another build of rimroll, or with other
        versions of NumPy or SciPy. Numbers may differ; the mark of each chunk names its build.
    progress, note
        Called with how far the run is, and with sentences for the user.

    Raises
    ------
    StoreError
        A store of another study or another build, a full disk, a folder that cannot be written.
    RimrollError
        A run at work on the same chunks, a cluster that does not answer or whose versions differ.
    Unfinished
        Chunks that failed on the cluster again and again; run again to try them again.
    KeyboardInterrupt
        On Ctrl-C. What is done is kept; run again to continue.
    """
    elsewhere = sum(one is not None for one in (workers, scheduler, client))
    if elsewhere > 1:
        raise RimrollError("give either workers or a scheduler")
    if threads is not None and elsewhere:
        raise RimrollError("threads are those of this process: give no workers or scheduler")
    store = Store.create(path, plan)
    store.expect(plan, other_versions=other_versions)
    mine = _within(chunks, store.blocks.number)
    with claimed(store.marks.folder, mine.start, mine.stop) as held:
        if not held:
            note(f"{path} is on a file system without locks: run each chunk once at a time")
        pending = store.pending(mine)
        store.sweep(pending)
        done = _Rows(store, mine, pending, progress)
        if workers is None and scheduler is None and client is None:
            work_through(store, plan, pending, threads, done.add, done.within)
        elif pending:
            from rimroll.study.cluster import compute, connected

            lent = nullcontext(client) if client else connected(workers, scheduler, note)
            with lent as connection:
                compute(
                    connection, store, plan, pending, done.add, note, other_versions=other_versions
                )
        if store.finished:
            with uninterrupted():
                store.merge(plan)
    return store


class _Rows:
    """How many rows of a run are done."""

    def __init__(
        self, store: Store, chunks: Iterable[int], pending: list[int], progress: Progress
    ) -> None:
        self._blocks = store.blocks
        first, last = min(chunks), max(chunks)
        self._all = self._blocks.rows(last)[1] - self._blocks.rows(first)[0]
        self._done = self._all - sum(map(self._size, pending))
        self._progress = progress
        progress(self._done, self._all)

    def _size(self, chunk: int) -> int:
        first, last = self._blocks.rows(chunk)
        return last - first

    def within(self, done: int, rows: int) -> None:
        """Rows of the chunk at work are done."""
        self._progress(self._done + done, self._all)

    def add(self, chunk: int) -> None:
        """A chunk is done."""
        self._done += self._size(chunk)
        self._progress(self._done, self._all)


def _within(chunks: range | None, number: int) -> range:
    if chunks is None:
        return range(number)
    if not 0 <= chunks.start < chunks.stop <= number or chunks.step != 1:
        raise RimrollError(
            f"must lie between 0 and {number}, got {chunks.start}:{chunks.stop}", "chunks"
        )
    return chunks
