"""Many falls by quadrature, in the columns of an ensemble."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import asdict

import numpy as np
from numpy.typing import NDArray

from rimroll.body import Body
from rimroll.exact import NUMBERS, OUTCOMES, turns_in_parts
from rimroll.falls import Column, Falls, Interrupted
from rimroll.falls import rows as in_rows
from rimroll.given import Number, number, optional
from rimroll.laws import Law
from rimroll.many_falls import described
from rimroll.recorded import parameters
from rimroll.rows import Rows
from rimroll.state import State

Array = NDArray[np.float64]


def exact_falls(
    body: Body,
    starts: State,
    law: Law,
    *,
    gravity: Number,
    topple_tilt: Number | None,
    threads: int | None,
    progress: Callable[[int, int], object] | None,
) -> Falls:
    """The first turn from each of the starts (n,), as rows of an ensemble.

    Raises ``Interrupted`` on Ctrl-C; it carries the falls done so far.
    """
    gravity = number("gravity", gravity, "m/s^2")
    topple_tilt = optional("topple_tilt", topple_tilt, "rad")
    (total,) = starts.shape
    rows = Rows.of(body, starts)
    codes, table = np.empty(total, np.uint8), np.empty((len(NUMBERS), total))
    done = 0

    def so_far() -> Falls:
        options = {"gravity": gravity, "topple_tilt": topple_tilt}
        columns = _columns(codes[:done], table[:, :done])
        return in_rows(columns, parameters(law.name, options, law=law.numbers, body=asdict(body)))

    try:
        for outcomes, columns, _ in turns_in_parts(rows, law, gravity, topple_tilt, threads):
            last = done + len(outcomes)
            codes[done:last], table[:, done:last] = outcomes, columns
            done = last
            if progress is not None:
                progress(done, total)
    except KeyboardInterrupt:
        raise Interrupted(so_far()) from None
    return so_far()


def _columns(codes: NDArray[np.uint8], table: Array) -> dict[str, Column]:
    numbers = dict(zip(NUMBERS, table, strict=True))
    with np.errstate(invalid="ignore"):  # a NaN stays one
        numbers["direction"] = np.mod(numbers["yaw_change"], 2.0 * np.pi)
    return {"outcome": Column(OUTCOMES[codes]), **described(numbers)}
