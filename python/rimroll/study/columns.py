"""The rows of a study: how they are divided into chunks, and what labels their numbers.

The rows are laid out on labelled dimensions in C order. A chunk is one block of this grid and, at
the same time, a range of consecutive rows: it takes whole as many of the last dimensions as fit, a
part of the dimension before them, and one place on each dimension before that. So a chunk of rows
is one chunk of a Zarr array, and no two writers ever share one.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray


@dataclass(frozen=True)
class Blocks:
    """A grid of this shape, divided into blocks; those at the end of a dimension may be smaller."""

    shape: tuple[int, ...]
    block: tuple[int, ...]

    @classmethod
    def of(cls, shape: Sequence[int], rows: int) -> Blocks:
        """The largest blocks of at most this many rows, as equal as they can be.

        >>> Blocks.of((1000, 20, 7), 100).block
        (1, 10, 7)
        """
        block = [1] * len(shape)
        room = max(1, rows)
        for i, size in reversed(list(enumerate(shape))):
            parts = math.ceil(size / room)
            block[i] = math.ceil(size / max(1, parts))
            if parts > 1:
                break
            room //= max(1, size)
        return cls(tuple(shape), tuple(block))

    @property
    def counts(self) -> tuple[int, ...]:
        """How many blocks there are along each dimension."""
        return tuple(math.ceil(n / b) for n, b in zip(self.shape, self.block, strict=True))

    @property
    def number(self) -> int:
        """How many blocks there are."""
        return math.prod(self.counts)

    def index(self, chunk: int) -> tuple[int, ...]:
        """Where a chunk lies among the blocks."""
        return tuple(map(int, np.unravel_index(chunk, self.counts))) if self.shape else ()

    def place(self, chunk: int) -> tuple[slice, ...]:
        """The part of the grid that a chunk fills."""
        return tuple(
            slice(i * b, min((i + 1) * b, n))
            for i, b, n in zip(self.index(chunk), self.block, self.shape, strict=True)
        )

    def rows(self, chunk: int) -> tuple[int, int]:
        """The rows of a chunk: its first, and the one after its last."""
        place = self.place(chunk)
        first = 0
        for part, size in zip(place, self.shape, strict=True):
            first = first * size + part.start
        return first, first + math.prod(part.stop - part.start for part in place)


TRIAL = "trial"
"""The dimension of the trials."""

Columns = dict[str, NDArray[Any]]
"""Arrays by the name of their variable."""

Progress = Callable[[int, int], object]
"""Takes how many rows are done, and how many there are."""


@dataclass(frozen=True)
class Variable:
    """A variable of the result, as xarray and netCDF describe it."""

    dtype: str
    """The name of a NumPy type: ``float64``, ``int64``, ``int8`` or ``bool``."""
    dims: tuple[str, ...]
    unit: str = ""
    """SI unit, "" for pure numbers."""
    long_name: str | None = None
    comment: str | None = None
    flags: tuple[str, ...] = ()
    """The words that the numbers 0, 1, 2, ... stand for, if they stand for words."""

    @property
    def attrs(self) -> dict[str, Any]:
        """Unit and meaning by the names of the climate and forecast conventions."""
        named: dict[str, Any] = {
            "units": self.unit,
            "long_name": self.long_name,
            "comment": self.comment,
        }
        if self.flags:
            del named["units"]
            named |= {
                "flag_values": list(range(len(self.flags))),
                "flag_meanings": " ".join(self.flags),
            }
        return {name: value for name, value in named.items() if value is not None}


@dataclass(frozen=True)
class Coordinate:
    """The values that label a dimension; or several coordinates that share one, if zipped."""

    values: NDArray[Any]
    """Numbers in SI units, or words."""
    dims: tuple[str, ...]
    unit: str = ""
    long_name: str | None = None

    @property
    def attrs(self) -> dict[str, str]:
        """Unit and meaning; words have no unit."""
        named = {"units": self.unit, "long_name": self.long_name}
        if self.values.dtype.kind == "U":
            del named["units"]
        return {name: value for name, value in named.items() if value is not None}
