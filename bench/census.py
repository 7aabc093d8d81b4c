"""Do both engines agree for extreme bodies and starts, and is energy conserved?

Turns are computed by quadrature and by steps from many random starts, and compared: outcomes must
be equal, turns equal to within the tolerance of the steps. Known explanations of each difference
are tested; each difference is printed with Python code that reproduces it. For one start in a
hundred the whole motion is computed, and its energy budget checked. Run:

    .venv/bin/python bench/census.py [--starts 100000] [--seed 2007]

The exit code is 1 if a difference remains unexplained.
"""

from __future__ import annotations

import argparse
import sys
from collections import Counter
from dataclasses import dataclass, field

import numpy as np
from counting.budget import surface, unbalanced
from counting.comparison import differences
from counting.draws import setting, starts

import rimroll as rr

STARTS_PER_BODY = 100
"""Starts for each body."""

MOTIONS_PER_BODY = 1
"""Whole motions for each body."""


@dataclass
class Census:
    """What was counted."""

    starts: int = 0
    motions: int = 0
    explained: Counter[str] = field(default_factory=Counter)
    unexplained: int = 0

    def take(self, rng: np.random.Generator, count: int) -> None:
        """Count one more body, from ``count`` starts."""
        drawn = setting(rng)
        some = starts(rng, drawn, count)
        for found in differences(drawn, some):
            if found.why:
                self.explained[found.why] += 1
            else:
                self.unexplained += 1
            print(f"{found.what}: {found.why or 'NOT EXPLAINED'}\n    {found.reproducer()}")
        for row in range(min(MOTIONS_PER_BODY, count)):
            problem = unbalanced(drawn, surface(rng), some, row)
            if problem:
                self.unexplained += 1
                print(problem)
        self.starts += count
        self.motions += min(MOTIONS_PER_BODY, count)

    def __str__(self) -> str:
        lines = [
            f"{self.starts} starts by both engines, {self.motions} motions with their energy",
            *(f"{count:8d}  {why}" for why, count in self.explained.most_common()),
            f"{self.unexplained:8d}  not explained",
        ]
        return "\n".join(lines)


def main() -> int:
    """Take a census; returns 1 if a difference is not explained."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--starts", type=int, default=100_000)
    parser.add_argument("--seed", type=int, default=2007)
    given = parser.parse_args()
    rng = np.random.default_rng(given.seed)
    census = Census()
    while census.starts < given.starts:
        census.take(rng, min(STARTS_PER_BODY, given.starts - census.starts))
    print(f"rimroll {rr.__version__}, seed {given.seed}\n{census}")
    return 1 if census.unexplained else 0


if __name__ == "__main__":
    sys.exit(main())
