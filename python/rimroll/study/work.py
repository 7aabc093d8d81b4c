"""One chunk of a study: computed, written, marked. Every way to run a study calls this."""

from __future__ import annotations

import platform
import signal
import threading
import time
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import Future, ThreadPoolExecutor
from contextlib import contextmanager
from dataclasses import dataclass
from typing import TYPE_CHECKING

from rimroll.errors import RimrollError
from rimroll.study.chunks import Mark, as_store_errors
from rimroll.study.versions import of_mark

if TYPE_CHECKING:
    from rimroll.study.columns import Columns
    from rimroll.study.plan import Plan
    from rimroll.study.store import Store


@contextmanager
def uninterrupted() -> Iterator[None]:
    """Let Ctrl-C take effect after the block.

    Zarr writes on threads of its own. Interrupted at once, it would leave tasks behind, of which
    Python complains at its end. Only the main thread receives signals, so in others nothing
    changes.
    """
    handler = signal.getsignal(signal.SIGINT)
    if threading.current_thread() is not threading.main_thread() or not callable(handler):
        yield
        return
    received = []
    signal.signal(signal.SIGINT, lambda *signal_and_frame: received.append(signal_and_frame))
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, handler)
        if received:
            handler(*received[0])


class Unfinished(RimrollError):
    """Chunks that could not be computed; all others are done."""


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
