"""How large a study is on the disk, and how long it takes."""

from __future__ import annotations

import os
import shutil
import sys
import time
from dataclasses import dataclass
from pathlib import Path

from rimroll.errors import RimrollError
from rimroll.study.plan import Plan

PLACES = 8
"""At how many places of a study rows are tried."""

LONG_ENOUGH = 0.4
"""A try that takes this long is representative, s."""

MAX_TRIED = 1 << 17
"""The largest number of rows that are tried at once."""


@dataclass(frozen=True)
class Probe:
    """What some rows, spread over a study, took."""

    rows: int
    seconds: float

    def of(self, rows: int) -> float:
        """How long this many rows take at the same rate, s."""
        return rows * self.seconds / self.rows


def probe(plan: Plan, threads: int | None = None) -> Probe:
    """Compute rows at some places of a study, more and more, until that takes 0.4 s."""
    count = 1
    while True:
        starts = sorted({k * plan.rows // PLACES for k in range(PLACES)})
        begin = time.perf_counter()
        tried = 0
        for first in starts:
            last = min(first + count, plan.rows)
            plan.compute(first, last, threads=threads)
            tried += last - first
        seconds = time.perf_counter() - begin
        if seconds > LONG_ENOUGH or tried >= min(plan.rows, MAX_TRIED):
            return Probe(tried, seconds)
        count *= 4


def free(place: Path) -> int:
    """The free bytes of the disk that has, or will have, a place."""
    folder = place.resolve()
    while not folder.exists():
        folder = folder.parent
    return shutil.disk_usage(folder).free


def expect_room(plan: Plan, store: Path) -> None:
    """Raise ``RimrollError`` if the variables, without compression, do not fit on the disk."""
    room = free(store)
    if plan.bytes > room:
        raise RimrollError(
            f"the study takes up to {in_bytes(plan.bytes)}, and the disk of {store} has"
            f" {in_bytes(room)}: keep fewer columns, or statistics, or say --larger-than-disk"
        )


def in_bytes(size: float) -> str:
    """A size as people read it: ``1.2 GB``."""
    for unit in ("B", "kB", "MB", "GB", "TB"):
        if size < 1000.0:
            return f"{size:.0f} B" if unit == "B" else f"{size:.3g} {unit}"
        size /= 1000.0
    return f"{size:.3g} PB"


def in_time(seconds: float) -> str:
    """A duration as people read it: ``2.5 h``."""
    for unit, length in (("days", 86400.0), ("h", 3600.0), ("min", 60.0)):
        if seconds >= length:
            return f"{seconds / length:.3g} {unit}"
    return f"{seconds:.2g} s"


def processors() -> int:
    """The processors that this process may use, which may be fewer than the machine has."""
    if sys.platform == "linux":
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1
