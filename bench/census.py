"""Do both engines say the same of wild bodies let go in wild ways, and is energy kept?

Turns are computed by quadrature and by steps from many random starts, and compared: outcomes must
be equal, turns equal to within the tolerance of the steps. Where they differ, what is known to
explain it is looked for and verified; each difference is printed with Python that reproduces it. Of
every hundredth start the whole motion is computed, and its energy added up. Run:

    .venv/bin/python bench/census.py [--starts 100000] [--seed 2007]

The exit code is 1 where a difference is left that nothing explains.
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

A_BODY = 100
"""Starts of each body."""

OF_WHICH_WHOLE = 1
"""Whole motions of each body."""


@dataclass
class Census:
    """What was counted."""

    starts: int = 0
    motions: int = 0
    explained: Counter[str] = field(default_factory=Counter)
    unexplained: int = 0

    def take(self, rng: np.random.Generator, count: int) -> None:
        """Count one more body, from so many starts."""
        drawn = setting(rng)
        some = starts(rng, drawn, count)
        for found in differences(drawn, some):
            if found.why:
                self.explained[found.why] += 1
            else:
                self.unexplained += 1
            print(f"{found.what}: {found.why or 'NOT EXPLAINED'}\n    {found.reproducer()}")
        for row in range(min(OF_WHICH_WHOLE, count)):
            said = unbalanced(drawn, surface(rng), some, row)
            if said:
                self.unexplained += 1
                print(said)
        self.starts += count
        self.motions += min(OF_WHICH_WHOLE, count)

    def __str__(self) -> str:
        lines = [
            f"{self.starts} starts by both engines, {self.motions} motions with their energy",
            *(f"{count:8d}  {why}" for why, count in self.explained.most_common()),
            f"{self.unexplained:8d}  not explained",
        ]
        return "\n".join(lines)


def main() -> int:
    """Take a census; 1 where a difference is not explained."""
    asked = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    asked.add_argument("--starts", type=int, default=100_000)
    asked.add_argument("--seed", type=int, default=2007)
    given = asked.parse_args()
    rng = np.random.default_rng(given.seed)
    census = Census()
    while census.starts < given.starts:
        census.take(rng, min(A_BODY, given.starts - census.starts))
    print(f"rimroll {rr.__version__}, seed {given.seed}\n{census}")
    return 1 if census.unexplained else 0


if __name__ == "__main__":
    sys.exit(main())
