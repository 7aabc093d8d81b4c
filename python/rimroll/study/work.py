"""One chunk of a study: computed, written, marked. Every way to run a study calls this."""

from __future__ import annotations

import platform
import time
from collections.abc import Callable, Iterable
from concurrent.futures import Future, ThreadPoolExecutor
from dataclasses import dataclass
from typing import TYPE_CHECKING

from rimroll.errors import RimrollError
from rimroll.study.marks import Mark
from rimroll.study.storage import as_store_errors
from rimroll.study.versions import of_mark

if TYPE_CHECKING:
    from rimroll.study.plan import Columns, Plan
    from rimroll.study.store import Store


@dataclass(frozen=True)
class Computed:
    """A chunk that is computed and not yet written."""

    chunk: int
    columns: Columns
    """The columns of its rows, or its part of the statistics."""
    seconds: float
    """How long its computation took."""


def work(store: Store, plan: Plan, chunk: int, threads: int | None = None) -> Mark:
    """Compute a chunk, write its numbers, and mark it as done when they are on the disk.

    Raises what ``plan.compute`` raises, and ``StoreError`` when the disk takes no more.
    """
    return keep(store, computed(store, plan, chunk, threads))


def work_through(
    store: Store,
    plan: Plan,
    chunks: Iterable[int],
    threads: int | None,
    done: Callable[[int], object],
    progress: Callable[[int, int], object],
) -> None:
    """Do the work of some chunks, and call ``done`` with the number of each that is computed.

    While a chunk is written, which waits for the disk, the next one is computed. When an error or
    Ctrl-C ends this, what is computed is written first.
    """
    with ThreadPoolExecutor(1, "writer") as writer:
        written: Future[Mark] | None = None
        for chunk in chunks:
            found = computed(store, plan, chunk, threads, progress)
            if written is not None:
                written.result()
            written = writer.submit(keep, store, found)
            done(chunk)
        if written is not None:
            written.result()


def computed(
    store: Store,
    plan: Plan,
    chunk: int,
    threads: int | None = None,
    progress: Callable[[int, int], object] | None = None,
) -> Computed:
    """Compute a chunk; raises what ``plan.compute`` raises, with the number of the chunk."""
    begin = time.perf_counter()
    first, last = store.blocks.rows(chunk)
    try:
        columns = plan.compute(first, last, threads=threads, progress=progress)
    except RimrollError as error:
        raise error.inside(f"chunk {chunk}:") from None
    if plan.statistics is not None:
        columns = plan.statistics.of(first, last, columns)
    return Computed(chunk, columns, round(time.perf_counter() - begin, 3))


def keep(store: Store, found: Computed) -> Mark:
    """Write the numbers of a chunk, and mark it as done when they are on the disk."""
    with as_store_errors(store.path):
        sha256 = store.numbers.write(found.chunk, found.columns)
        mark = Mark(sha256, found.seconds, platform.node(), of_mark())
        store.marks.add(found.chunk, mark)
    return mark
