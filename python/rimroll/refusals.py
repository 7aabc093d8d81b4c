"""Which of many starts is at fault."""

from __future__ import annotations

import numpy as np

from rimroll import _core
from rimroll.body import Body
from rimroll.errors import RimrollError, element
from rimroll.state import State


def placed(
    refusal: RimrollError,
    body: Body,
    starts: State,
    rows: _core._Starts,
    gravity: float,
    topple_tilt: float | None,
) -> RimrollError:
    """A refusal that names the element of the array that it is about, ``tilt[3] must be``.

    ``rows`` are the starts as flat arrays.
    """
    field, rest = str(refusal).split(" ", 1)
    if not np.ndim(getattr(starts, field, 0.0)):
        return refusal
    first = _core.first_refused(body, rows, gravity, topple_tilt)
    if first is None:
        return refusal
    place = map(int, np.unravel_index(first, starts.shape))
    return RimrollError(f"{element(field, place)} {rest}")
