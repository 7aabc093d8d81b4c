"""Whether the numbers of a store are those that were written, and one hash of them all."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from rimroll.study.storage import StoreError, as_bytes, digest

if TYPE_CHECKING:
    from rimroll.study.store import Store


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
