"""What all files of a store need: Zarr, errors in words, hashes."""

from __future__ import annotations

import errno
import hashlib
import json
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from rimroll.errors import RimrollError


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
