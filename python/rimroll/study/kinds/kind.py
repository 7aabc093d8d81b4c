"""What a kind of study computes in a row."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, fields
from typing import Any, Protocol

from numpy.typing import NDArray

from rimroll.options import Options
from rimroll.study.cases import Call
from rimroll.study.plan import Progress

OPTION_NAMES = tuple(one.name for one in fields(Options) if one.name not in ("flat", "flat_gap"))
"""The keys of [simulation] that are options of the solver for all motions."""


@dataclass(frozen=True)
class Result:
    """A number or word that a kind computes for each row."""

    dtype: str
    unit: str = ""
    long_name: str | None = None
    comment: str | None = None
    flags: tuple[str, ...] = ()


class Kind(Protocol):
    """A kind of study: the results of a row, and how the rows of a call are computed."""

    @property
    def name(self) -> str:
        """The word for it in files."""

    @property
    def results(self) -> Mapping[str, Result]:
        """The results of a row, by name."""

    @property
    def options(self) -> Options:
        """How motions are followed unless the study says otherwise."""

    @property
    def chunk(self) -> int:
        """Rows of a chunk unless the study says otherwise: some seconds of processor time."""

    @property
    def tables(self) -> Mapping[str, Any]:
        """The tables that it reads besides [body], and what they are unless the study has them."""

    @property
    def settings(self) -> tuple[str, ...]:
        """The keys of [simulation] that decide its results."""

    @property
    def one_start(self) -> bool:
        """Whether a row has one start, which is kept if a hand releases the body."""

    def computed(
        self, call: Call, threads: int | None, progress: Progress
    ) -> dict[str, NDArray[Any]]:
        """The results of the rows of a call, each (n,).

        ``progress`` is called with the numbers of rows that are done and that there are.
        """
