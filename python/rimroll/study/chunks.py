"""What is kept of a chunk beside its rows: a mark when it is complete, and its part of statistics.

A mark is written after all numbers of its chunk. A file of numbers says nothing, since a writer may
have been killed before it wrote the others.
"""

from __future__ import annotations

import errno
import hashlib
import json
import os
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from rimroll.errors import RimrollError
from rimroll.files.output import durably

if TYPE_CHECKING:
    from rimroll.study.columns import Columns


class StoreError(RimrollError):
    """A store that cannot be made, opened, read or written."""


NO_ROOM = (errno.ENOSPC, errno.EDQUOT, errno.EFBIG)
"""What the system answers when a disk, or the share of a user, is full."""


@contextmanager
def as_store_errors(path: Path) -> Iterator[None]:
    """Errors of the operating system as ``StoreError``, which says what can be done."""
    try:
        yield
    except OSError as error:
        if error.errno in NO_ROOM:
            raise StoreError(
                f"no room is left on the disk of {path}: make room and run again; what is done is"
                " kept"
            ) from error
        if isinstance(error, PermissionError):
            raise StoreError(f"cannot use {error.filename or path}: permission denied") from error
        raise StoreError(f"{error.filename or path}: {error.strerror or error}") from error


def zarr() -> Any:
    """The package zarr, which is slow to load; ``RimrollError`` if it is not installed."""
    try:
        import zarr as package
    except ImportError:
        raise RimrollError(
            "the store of a study needs zarr: pip install 'rimroll[cluster]'"
        ) from None
    return package


def digest(columns: Mapping[str, NDArray[Any]]) -> str:
    """The hash of arrays by name."""
    hashed = hashlib.sha256()
    for name in sorted(columns):
        values = np.asarray(columns[name])
        hashed.update(f"{name} {values.dtype.kind}{values.dtype.itemsize}\n".encode())
        hashed.update(as_bytes(values))
    return hashed.hexdigest()


def as_bytes(values: NDArray[Any]) -> bytes | memoryview:
    """The bytes of an array in C order, the lowest of each number first; words as JSON."""
    if values.dtype.kind in ("T", "O", "U"):
        return json.dumps(values.tolist(), ensure_ascii=False).encode()
    ordered = np.ascontiguousarray(values, values.dtype.newbyteorder("<"))
    return ordered.reshape(-1).view(np.uint8).data


MERGED = "merged.json"
"""The mark of statistics that were merged from all chunks."""


@dataclass(frozen=True)
class Mark:
    """What is known of a chunk that is done."""

    sha256: str
    """The hash of its numbers."""
    seconds: float
    """How long its computation took."""
    host: str
    rimroll: str
    """The version and the build that computed it."""


class Marks:
    """The marks in a folder."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder

    def done(self) -> set[int]:
        """The chunks that have a mark."""
        with os.scandir(self.folder) as files:
            names = (file.name.partition(".") for file in files)
            return {int(stem) for stem, _, end in names if end == "json" and stem.isdecimal()}

    def add(self, chunk: int, mark: Mark) -> None:
        """Mark a chunk as done, when its numbers are on the disk."""
        with durably(self.file(chunk)) as part:
            part.write(json.dumps(asdict(mark)).encode())

    def read(self, chunk: int) -> Mark | None:
        """The mark of a chunk; None if there is none that can be read."""
        try:
            return Mark(**json.loads(self.file(chunk).read_bytes()))
        except (OSError, ValueError, TypeError):
            return None

    def remove(self, chunk: int) -> None:
        """Forget that a chunk is done, and what was merged of it."""
        self.file(chunk).unlink(missing_ok=True)
        self.remove_merged()

    def add_merged(self, sha256: str) -> None:
        """Mark the statistics of all chunks as merged, with their hash."""
        with durably(self.folder / MERGED) as part:
            part.write(json.dumps({"sha256": sha256}).encode())

    def merged(self) -> str | None:
        """The hash of the merged statistics; None if they are not merged."""
        try:
            return str(json.loads((self.folder / MERGED).read_bytes())["sha256"])
        except (OSError, ValueError, KeyError, TypeError):
            return None

    def remove_merged(self) -> None:
        """Forget that the statistics are merged."""
        (self.folder / MERGED).unlink(missing_ok=True)

    def file(self, chunk: int) -> Path:
        """The mark of a chunk."""
        return self.folder / f"{chunk}.json"


class Parts:
    """The parts in a folder."""

    def __init__(self, folder: Path) -> None:
        self._folder = folder

    def write(self, chunk: int, columns: Mapping[str, NDArray[Any]]) -> str:
        """Write the part of a chunk to the disk; return its hash."""
        with as_store_errors(self._folder), durably(self._file(chunk)) as file:
            np.savez(file, **columns)  # type: ignore[arg-type]
        return digest(columns)

    def read(self, chunk: int) -> Columns:
        """The part of a chunk; raises ``StoreError`` if it cannot be read."""
        try:
            with self._file(chunk).open("rb") as file, np.load(file) as part:
                return dict(part)
        except Exception as error:  # also of zip and of headers
            raise StoreError(f"{self._file(chunk)} cannot be read: {error}") from None

    def files(self, chunk: int) -> Iterator[Path]:
        """The file of a chunk."""
        yield self._file(chunk)

    def _file(self, chunk: int) -> Path:
        return self._folder / f"{chunk}.npz"
