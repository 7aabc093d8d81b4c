"""How far a study is, read from the marks in its store."""

from __future__ import annotations

from dataclasses import dataclass
from statistics import fmean

from rimroll.study.claim import at_work
from rimroll.study.store import Store

SAMPLE = 1000
"""The number of marks read for the mean time of a chunk; a store may have millions."""


@dataclass(frozen=True)
class Status:
    """How far a study is.

    Attributes
    ----------
    chunks, chunks_done
        All chunks, and those that are done.
    motions, motions_done
        All rows, and those that are done.
    seconds
        Mean time of a chunk in its process (s); None before the first one is done.
    owners
        Who is at work, in words.
    """

    chunks: int
    chunks_done: int
    motions: int
    motions_done: int
    seconds: float | None
    owners: list[str]


def status_of(store: Store) -> Status:
    """How far a study is."""
    done = sorted(store.marks.done())
    step = max(1, len(done) // SAMPLE)
    marks = [store.marks.read(chunk) for chunk in done[::step]]
    seconds = [mark.seconds for mark in marks if mark is not None]
    rows = [store.blocks.rows(chunk) for chunk in done]
    return Status(
        chunks=store.blocks.number,
        chunks_done=len(done),
        motions=store.blocks.rows(store.blocks.number - 1)[1],
        motions_done=sum(last - first for first, last in rows),
        seconds=fmean(seconds) if seconds else None,
        owners=at_work(store.marks.folder),
    )
