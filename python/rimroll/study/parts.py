"""What chunks contribute to statistics: a file of NumPy for each, ``done/<chunk>.npz``."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from rimroll.output import durably
from rimroll.study.storage import StoreError, as_store_errors, digest

if TYPE_CHECKING:
    from rimroll.study.plan import Columns


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
