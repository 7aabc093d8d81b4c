"""The columns of the rows of a study, in Zarr arrays over its dimensions."""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from rimroll.output import flush
from rimroll.study.storage import StoreError, as_store_errors, digest

if TYPE_CHECKING:
    from rimroll.study.plan import Columns
    from rimroll.study.store import Store


class RowsOnDisk:
    """Columns of chunks, each flat in its rows."""

    def __init__(self, path: Path, store: Store) -> None:
        self._path = path
        self._store = store
        self._flushed: set[Path] = set()

    def write(self, chunk: int, columns: Mapping[str, NDArray[Any]]) -> str:
        """Write the columns of a chunk to the disk; return their hash."""
        place = self._store.blocks.place(chunk)
        shape = tuple(part.stop - part.start for part in place)
        arrays = self._store.arrays
        # Contiguous once, for both the disk and the hash.
        written = {
            name: np.ascontiguousarray(columns[name], one.dtype) for name, one in arrays.items()
        }
        with as_store_errors(self._path):
            for name, array in arrays.items():
                array[place or ...] = written[name].reshape(shape)
            # At the same time, since a disk writes many files at once nearly as fast as one.
            with ThreadPoolExecutor(len(arrays)) as pool:
                list(pool.map(self._flush, self.files(chunk)))
        return digest(written)

    def read(self, chunk: int) -> Columns:
        """The columns of a chunk, with fill values where files are missing.

        Raises ``StoreError`` for files that cannot be read.
        """
        place = self._store.blocks.place(chunk) or ...
        try:
            return {name: np.ravel(one[place]) for name, one in self._store.arrays.items()}
        except Exception as error:  # codecs raise errors of many classes
            raise StoreError(f"chunk {chunk} of {self._path} cannot be read: {error}") from None

    def files(self, chunk: int) -> Iterator[Path]:
        """The files of a chunk, one for each column."""
        index = map(str, self._store.blocks.index(chunk))
        key = os.path.join("c", *index)
        return (self._path / name / key for name in self._store.arrays)

    def _flush(self, file: Path) -> None:
        """Wait until a file is on the disk, with the folders that were made for it."""
        flush(file)
        folder = file.parent
        flush(folder)
        while folder != self._path and folder not in self._flushed:
            self._flushed.add(folder)
            folder = folder.parent
            flush(folder)
