"""What a study amounts to: rows in chunks, labelled dimensions, and the columns of each chunk."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from rimroll.errors import RimrollError
from rimroll.study.blocks import Blocks

if TYPE_CHECKING:
    from rimroll.study.statistics import Statistics
    from rimroll.study.study import Study

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


@dataclass(frozen=True, eq=False)
class Plan:
    """The rows of a study, and how the columns of any of them are computed.

    Rows are numbered along the dimensions in C order: the last dimension varies fastest.
    """

    study: Study
    dims: Mapping[str, int]
    """The sizes of the dimensions of the rows, in order."""
    coords: Mapping[str, Coordinate]
    columns: Mapping[str, Variable]
    """The columns of the rows: float64, int64, int8 or bool, each over all :attr:`dims`."""
    chunk: int
    """Rows in a chunk, at most."""
    attrs: Mapping[str, Any]
    """Everything that determines the numbers, as JSON knows it."""
    statistics: Statistics | None = None
    """What is kept of the rows, if not their columns."""
    _made: dict[str, Any] = field(default_factory=dict, repr=False)

    @property
    def rows(self) -> int:
        """The number of motions."""
        return math.prod(self.dims.values())

    @property
    def blocks(self) -> Blocks:
        """How the rows are divided into chunks, each of which is a block of the dimensions."""
        return Blocks.of(tuple(self.dims.values()), self.chunk)

    @property
    def chunks(self) -> int:
        """The number of chunks."""
        return self.blocks.number

    def bounds(self, number: int) -> tuple[int, int]:
        """The first row of a chunk, and the row after its last."""
        return self.blocks.rows(number)

    def __iter__(self) -> Iterator[tuple[int, int]]:
        return map(self.bounds, range(self.chunks))

    @property
    def variables(self) -> Mapping[str, Variable]:
        """What the finished study holds: the columns, or their statistics."""
        return self.columns if self.statistics is None else self.statistics.variables

    @property
    def bytes(self) -> int:
        """The size without compression of all variables, and of the parts of statistics."""
        sizes = self.sizes
        variables = sum(
            np.dtype(one.dtype).itemsize * math.prod(sizes[dim] for dim in one.dims)
            for one in self.variables.values()
        )
        parts = 0 if self.statistics is None else self.statistics.bytes_of_parts(self.blocks)
        return variables + parts

    @property
    def sizes(self) -> Mapping[str, int]:
        """The sizes of all dimensions of the variables."""
        return self.dims if self.statistics is None else self.statistics.sizes

    def compute(
        self, first: int, last: int, *, threads: int | None = None, progress: Progress | None = None
    ) -> Columns:
        """The columns of the rows from ``first`` to before ``last``, each (last − first,).

        They depend on nothing but the study and these two numbers, and each row on its own number
        only. Where the plan has ``statistics``, reduce them by ``plan.statistics.of(first, last,
        columns)``.

        Raises ``RimrollError`` for rows that there are not, and ``Interrupted`` on Ctrl-C.
        """
        if not 0 <= first < last <= self.rows:
            text = f"must be between 0 and {self.rows}, got {first} to before {last}"
            raise RimrollError(text, "rows", (first, last))
        return self.study.computed(first, last, threads, progress)
