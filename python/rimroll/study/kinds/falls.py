"""Studies of falls: the first turn of a body, from starts or from the hand that releases it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from rimroll import _core
from rimroll.exact import NUMBERS
from rimroll.exact_falls import exact_falls
from rimroll.experiment.toppling import FALLING
from rimroll.falls import Falls
from rimroll.many_falls import OPTIONS, VARIABLES, follow
from rimroll.options import Options
from rimroll.study.cases import Call
from rimroll.study.kinds.kind import OPTION_NAMES, Result
from rimroll.study.plan import Progress

OUTCOME = Result("int8", long_name="outcome", flags=tuple(_core.OUTCOMES))

CHUNK = 250_000
"""First turns in a chunk: a second of processor time or more.

In chunks of a million, drawing, hashing and writing were measured to take three times as long."""

DTYPES = {"slid": "bool", "flew": "bool", "steps": "int64"}
"""The types of columns that are not float64."""


def described(names: tuple[str, ...]) -> dict[str, Result]:
    """The columns of falls of these names."""
    return {name: Result(DTYPES.get(name, "float64"), *VARIABLES[name]) for name in names}


@dataclass(frozen=True)
class Followed:
    """First turns, as :func:`rimroll.ensemble` computes them."""

    name: str
    options: Options
    tables: Mapping[str, Any]
    settings: tuple[str, ...] = OPTION_NAMES
    chunk: int = CHUNK
    one_start: bool = True
    results: Mapping[str, Result] = field(
        default_factory=lambda: {"outcome": OUTCOME, **described(tuple(VARIABLES))}
    )

    def computed(
        self, call: Call, threads: int | None, progress: Progress
    ) -> dict[str, NDArray[Any]]:
        """The falls of a call."""
        falls = follow(
            call.body,
            call.starts,
            call.law,
            call.options,
            friction_scale=call.friction_scale,
            threads=threads,
            progress=progress,
            words=False,
        )
        return {name: falls[name] for name in self.results}


@dataclass(frozen=True)
class ByQuadrature:
    """First turns under laws that conserve energy, as :func:`rimroll.exact_turn` computes them."""

    name: str = "exact_turn"
    options: Options = OPTIONS
    tables: Mapping[str, Any] = field(
        default_factory=lambda: {"law": "no_slip", "start": None, "release": None}
    )
    settings: tuple[str, ...] = ("gravity", "topple_tilt")
    chunk: int = 2 * CHUNK
    one_start: bool = True
    results: Mapping[str, Result] = field(
        default_factory=lambda: {
            "outcome": OUTCOME,
            **described((*(name for name in NUMBERS if name in VARIABLES), "direction")),
        }
    )

    def computed(
        self, call: Call, threads: int | None, progress: Progress
    ) -> dict[str, NDArray[Any]]:
        """The turns of a call."""
        falls = exact_falls(
            call.body,
            call.starts,
            call.law,
            gravity=call.options.gravity,
            topple_tilt=call.options.topple_tilt,
            threads=threads,
            progress=progress,
        )
        return columns_of(falls, self.results)


def columns_of(falls: Falls, results: Mapping[str, Result]) -> dict[str, NDArray[Any]]:
    """The results among the columns of falls, or of shaken bodies, with words as their places."""
    return {
        name: as_flags(falls[name], result.flags) if result.flags else falls[name]
        for name, result in results.items()
    }


def as_flags(words: NDArray[Any], known: tuple[str, ...]) -> NDArray[np.int8]:
    """Words (n,) as their places among the known ones."""
    found = np.full(len(words), -1, np.int8)
    for place, word in enumerate(known):
        found[words == word] = place
    return found


ENSEMBLE = Followed("ensemble", OPTIONS, {"law": "no_slip", "start": None, "release": None})
TOPPLE = Followed("topple", FALLING, {"law": "no_slip", "release": "flick"})
EXACT_TURN = ByQuadrature()
