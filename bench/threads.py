"""The speed-up from using all processors instead of one, for both engines.

Starts are followed alternately on one thread and on as many threads as there are
processors. The result is the median ratio of their wall-clock times, which include Python's work
before and after. Other work on the machine reduces the measured speed-up. Run, with the package
installed:

    .venv/bin/python bench/threads.py
"""

from __future__ import annotations

import os
import statistics
from collections.abc import Callable
from functools import partial

from contest.contestants import ROOT
from contest.pairs import ROUNDS, ratios, starts
from contest.tables import put_between

import rimroll as rr

Follow = Callable[[rr.State, int], object]


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
        start = starts(count)
        found = ratios(partial(follow, start, 1), partial(follow, start, processors))
        result = f"**{statistics.median(found):.2f}**, {min(found):.2f} to {max(found):.2f}"
        lines.append(f"| {name} | {f'{count:,}'.replace(',', ' ')} | {result} |")
        print(lines[-1])
    put_between(ROOT / "docs/performance.md", "threads", "\n".join(lines))


if __name__ == "__main__":
    main()
