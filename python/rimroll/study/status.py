"""How far a study is, and whether its numbers are those that were written."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Callable
from dataclasses import dataclass
from statistics import fmean

import numpy as np

from rimroll.study.chunks import StoreError, as_bytes, digest
from rimroll.study.run import at_work
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


@dataclass(frozen=True)
class Verified:
    """What was found in a store."""

    damaged: list[int]
    """Chunks with other numbers than were written."""
    missing: list[int]
    """Chunks that are not done."""
    unmerged: bool
    """Whether the statistics are not those that were merged from the chunks."""
    sha256: str | None
    """The hash of all coordinates and numbers; None unless they are complete and sound.

    It depends on neither the chunks nor on who computed them, and not on attributes.
    """


def verify(store: Store, progress: Callable[[int, int], object] = lambda *_: None) -> Verified:
    """Read every chunk, compare its hash with that of its mark, and hash the whole."""
    chunks = range(store.blocks.number)
    missing = store.pending(chunks)
    damaged = []
    whole = {name: hashlib.sha256() for name in store.arrays}
    for chunk in sorted(set(chunks) - set(missing)):
        progress(chunk, len(chunks))
        mark = store.marks.read(chunk)
        try:
            columns = store.numbers.read(chunk)
        except StoreError:
            damaged.append(chunk)
            continue
        if mark is None or digest(columns) != mark.sha256:
            damaged.append(chunk)
        if not store.merged:
            for name, values in columns.items():  # rows in order, whatever the chunks
                whole[name].update(as_bytes(values))
    if damaged or missing:
        return Verified(damaged, missing, False, None)
    if store.merged:
        try:
            merged = {name: np.asarray(array[...]) for name, array in store.arrays.items()}
        except Exception:  # codecs raise errors of many classes
            return Verified([], [], True, None)
        if digest(merged) != store.marks.merged():
            return Verified([], [], True, None)
        for name, values in merged.items():
            whole[name].update(as_bytes(values))
    numbers = {name: one.hexdigest() for name, one in whole.items()}
    return Verified([], [], False, _hash(store, numbers))


def _hash(store: Store, numbers: dict[str, str]) -> str:
    """One hash of coordinates and numbers, from the hashes of their values."""
    variables = {
        name: [
            str(one.dtype),
            list(one.metadata.dimension_names or ()),
            list(one.shape),
            numbers[name],
        ]
        for name, one in store.arrays.items()
    }
    labels = {
        name: hashlib.sha256(as_bytes(values)).hexdigest()
        for name, values in store.coordinates.items()
    }
    return hashlib.sha256(json.dumps([variables, labels], sort_keys=True).encode()).hexdigest()
