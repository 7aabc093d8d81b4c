"""Studies of bodies on tables that move."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import Any

from numpy.typing import NDArray

from rimroll import _core
from rimroll.options import Options
from rimroll.shaking.many import VARIABLES, follow_shaken
from rimroll.study.cases import Call
from rimroll.study.kinds.falls import columns_of
from rimroll.study.kinds.kind import OPTION_NAMES, Result
from rimroll.study.plan import Progress
from rimroll.study.starts import STANDING

DTYPES = {"overturned": "bool", "undecided": "bool", "stands": "bool", "steps": "int64"}
"""The types of columns that are not float64."""

OPTIONS = Options(duration=1.0, rtol=1e-8)
"""The defaults of :func:`rimroll.shake_many`, whose motions each have their own duration."""

STATUS = Result("int8", long_name="status", flags=tuple(_core.STATUSES))


@dataclass(frozen=True)
class Shaken:
    """Bodies on tables that move, as :func:`rimroll.shake_many` computes them."""

    name: str = "shake"
    options: Options = OPTIONS
    tables: Mapping[str, Any] = field(
        default_factory=lambda: {
            "law": "no_slip",
            "start": STANDING,
            "release": None,
            "ground": None,
        }
    )
    settings: tuple[str, ...] = (*OPTION_NAMES, "flat", "flat_gap")
    chunk: int = 10_000
    one_start: bool = True
    results: Mapping[str, Result] = field(
        default_factory=lambda: {
            "status": STATUS,
            **{name: Result(DTYPES.get(name, "float64"), *one) for name, one in VARIABLES.items()},
        }
    )

    def computed(
        self, call: Call, threads: int | None, progress: Progress
    ) -> dict[str, NDArray[Any]]:
        """The motions of a call."""
        assert call.grounds is not None and call.scale is not None
        shaken = follow_shaken(
            call.body,
            call.starts,
            call.law,
            call.grounds,
            scale=call.scale,
            duration=call.duration,
            options=replace(call.options, flat=call.flat),
            threads=threads,
            progress=progress,
        )
        return columns_of(shaken, self.results)


SHAKE = Shaken()
