"""How many times as fast all processors are as one, for both engines.

The same starts are followed on one thread and on as many as there are processors, by turns; told is
the median of the ratios of their times, as clocks on the wall have them, with what Python does
before and after. Other work on the machine counts against the threads. Run, with the package
installed:

    .venv/bin/python bench/threads.py
"""

from __future__ import annotations

import os
import statistics
import time
from collections.abc import Callable

import numpy as np
from contest.contestants import ROOT
from contest.tables import put_between

import rimroll as rr

ROUNDS = 9

Follow = Callable[[rr.State, int], object]


def starts(count: int) -> rr.State:
    """Cans let go at all kinds of tilts, with a little yaw and spin."""
    random = np.random.default_rng(2007)
    return rr.State(
        tilt=random.uniform(0.3, 0.6, count),
        tilt_rate=-random.uniform(0.0, 0.5, count),
        yaw_rate=10.0 ** random.uniform(-5.0, -1.0, count),
        spin_rate=10.0 ** random.uniform(-5.0, -1.0, count),
    )


def seconds(follow: Follow, start: rr.State, threads: int) -> float:
    begin = time.perf_counter()
    follow(start, threads)
    return time.perf_counter() - begin


def ratios(follow: Follow, start: rr.State, threads: int) -> list[float]:
    """One thread's time over that of so many, round by round."""
    follow(start, threads)  # what is made once is made
    return [seconds(follow, start, 1) / seconds(follow, start, threads) for _ in range(ROUNDS)]


def main() -> None:
    can, processors = rr.bodies.can_2007(), os.cpu_count() or 1

    def exact(law: rr.Law) -> Follow:
        return lambda start, threads: rr.exact_turn(can, start, law, threads=threads)

    def stepped(law: rr.Law) -> Follow:
        return lambda start, threads: rr.ensemble(can, start, law, threads=threads)

    engines = {
        "`rr.exact_turn`, without slip": (exact(rr.NoSlip()), 1_000_000),
        "`rr.exact_turn`, without friction": (exact(rr.Frictionless()), 1_000_000),
        "`rr.ensemble`, without slip": (stepped(rr.NoSlip()), 100_000),
        "`rr.ensemble`, Coulomb friction of 0.2": (stepped(rr.Coulomb(0.2)), 40_000),
    }
    lines = [f"| {ROUNDS} rounds | starts | {processors} threads over one: median, range |"]
    lines.append("| --- | --: | --: |")
    for name, (follow, count) in engines.items():
        found = ratios(follow, starts(count), processors)
        told = f"**{statistics.median(found):.2f}**, {min(found):.2f} to {max(found):.2f}"
        lines.append(f"| {name} | {f'{count:,}'.replace(',', ' ')} | {told} |")
        print(lines[-1])
    put_between(ROOT / "docs/performance.md", "threads", "\n".join(lines))


if __name__ == "__main__":
    main()
