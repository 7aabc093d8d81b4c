"""One chunk of a study: computed, written, marked. Every way to run a study calls this."""

from __future__ import annotations

import platform
import time
from collections.abc import Callable
from typing import TYPE_CHECKING

from rimroll.errors import RimrollError
from rimroll.study.marks import Mark
from rimroll.study.storage import told
from rimroll.study.uninterrupted import uninterrupted
from rimroll.study.versions import of_mark

if TYPE_CHECKING:
    from rimroll.study.plan import Plan
    from rimroll.study.store import Store


def work(
    store: Store,
    plan: Plan,
    chunk: int,
    threads: int | None = None,
    progress: Callable[[int, int], object] | None = None,
) -> Mark:
    """Compute a chunk, write its numbers, and mark it as done when they are on the disk.

    Raises what ``plan.compute`` raises, and ``StoreError`` when the disk takes no more.
    """
    begin = time.perf_counter()
    first, last = store.blocks.rows(chunk)
    try:
        columns = plan.compute(first, last, threads=threads, progress=progress)
    except RimrollError as error:
        raise RimrollError(f"chunk {chunk}: {error}") from None
    if plan.statistics is not None:
        columns = plan.statistics.of(first, last, columns)
    seconds = round(time.perf_counter() - begin, 3)
    with uninterrupted(), told(store.path):
        mark = Mark(store.numbers.write(chunk, columns), seconds, platform.node(), of_mark())
        store.marks.add(chunk, mark)
    return mark
