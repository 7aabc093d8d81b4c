"""A motion of the ground as the set-up of the lab's floor, which has one pulse."""

from __future__ import annotations

import math

from rimroll.browser.digits import Pairs, plain, shortest
from rimroll.errors import RimrollError
from rimroll.ground.ground import Ground
from rimroll.ground.pulses import CALM
from rimroll.options import FlatLanding
from rimroll.state import State

FLAT = ("stop", "smooth_left", "smooth_right", "housner")
"""What the lab has for a base that comes down flat."""


def floor_of(ground: Ground, flat: FlatLanding, start: State[float] | None) -> Pairs:
    """The set-up of the floor.

    Raises ``RimrollError`` for a ground that is not one pulse, and for a ``flat`` that the lab does
    not have.
    """
    if flat not in FLAT:
        raise RimrollError(
            f"flat cannot be shown in the lab, which has {', '.join(FLAT)}, got {flat!r}"
        )
    pulses = ground.core.pulses()
    if ground.core.samples() is not None or len(pulses) != 1:
        raise _missing(ground)
    ((kind, (x, y, z), period, duration, center),) = pulses
    if kind == "ricker" and (center, duration) != (CALM * period, CALM * period + CALM * period):
        raise _missing(ground)
    yield "floor", "pulse"
    yield "pulse", "rectangular" if kind == "constant" else kind
    yield "shake", plain(math.hypot(x, y))
    yield "direction", plain(math.degrees(math.atan2(y, x)))
    yield "vertical", plain(z)
    yield "period", plain(duration if kind == "constant" else period)
    if kind in ("sine", "cosine"):
        yield "cycles", shortest(duration, duration / period, lambda shown: shown * period)
    yield "flat", str(flat)
    if start is not None and start.tilt == 0.0:
        yield "start", "standing"


def _missing(ground: Ground) -> RimrollError:
    return RimrollError(
        "ground cannot be shown in the lab, which has one pulse with the same times in x, y and z,"
        f" and no records, got {ground!r}: a film shows any ground (motion.film)"
    )
