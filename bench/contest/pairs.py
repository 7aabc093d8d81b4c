"""The same starts followed in two ways by turns, and the ratio of what that costs."""

from __future__ import annotations

import time
from collections.abc import Callable

import numpy as np

import rimroll as rr

ROUNDS = 9


def starts(count: int) -> rr.State:
    """Cans let go at all kinds of tilts, with a little yaw and spin."""
    random = np.random.default_rng(2007)
    return rr.State(
        tilt=random.uniform(0.3, 0.6, count),
        tilt_rate=-random.uniform(0.0, 0.5, count),
        yaw_rate=10.0 ** random.uniform(-5.0, -1.0, count),
        spin_rate=10.0 ** random.uniform(-5.0, -1.0, count),
    )


def ratios(
    one: Callable[[], object],
    other: Callable[[], object],
    clock: Callable[[], float] = time.perf_counter,
) -> list[float]:
    """The one's time over the other's, round by round, by a clock that tells seconds."""

    def seconds(follow: Callable[[], object]) -> float:
        begin = clock()
        follow()
        return clock() - begin

    one(), other()  # what is made once is made
    return [seconds(one) / seconds(other) for _ in range(ROUNDS)]
