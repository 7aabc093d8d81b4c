"""The ratio of the costs of two ways to follow the same starts, which alternate."""

from __future__ import annotations

import time
from collections.abc import Callable

import numpy as np

import rimroll as rr

ROUNDS = 9


def starts(count: int) -> rr.State:
    """Starts of a can at many tilts, with a little yaw and spin."""
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
    """The time of one over that of the other in each round, by a clock in seconds."""

    def seconds(follow: Callable[[], object]) -> float:
        begin = clock()
        follow()
        return clock() - begin

    one(), other()  # fills the caches
    return [seconds(one) / seconds(other) for _ in range(ROUNDS)]
