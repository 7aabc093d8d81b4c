"""Is the motion of any body on any moving table what it must be?

Random bodies on random tables, standing and tilted, under all laws, resistances and landings. For
each motion: no number that is not finite, an energy budget that closes, losses that only grow, a
table that pushes, friction within its cone; the same motion of the mirror image, in another heading
and size, and in a lift; ever the same motion as a resistance vanishes; derivatives as central
differences have them; and ``rr.shake_many`` as ``rr.simulate``. A difference is explained if
neighbours, which differ by 1e-10, are as far apart. Run:

    .venv/bin/python bench/shaken_census.py [--number 1000] [--seed SEED] [--only K]

Each break that is not explained is printed with the number to repeat it; then the exit code is 1.
"""

from __future__ import annotations

import argparse
import secrets
import sys
from collections import Counter

import numpy as np
from counting.claims import findings
from counting.shaken import draw

import rimroll as rr


def main() -> int:
    """Take a census; returns 1 if a break is not explained."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--number", type=int, default=1000, help="of motions")
    parser.add_argument("--seed", type=int, default=secrets.randbelow(10**6))
    parser.add_argument("--only", type=int, help="the number of one motion")
    given = parser.parse_args()
    tried, explained, unexplained = Counter[str](), Counter[str](), Counter[str]()
    numbers = range(given.number) if given.only is None else [given.only]
    for number in numbers:
        shaken = draw(given.seed, number)
        if given.only is not None:
            print(shaken)
        for found in findings(shaken, np.random.default_rng([given.seed, number, 1])):
            tried[found.claim] += 1
            explained[found.claim] += bool(found.what and found.why)
            if found.what and not found.why:
                unexplained[found.claim] += 1
                repeat = f"--seed {given.seed} --only {number}"
                print(f"{repeat}: {found.claim}: {found.what} ({shaken.law!r})", flush=True)
    print(f"rimroll {rr.__version__}, seed {given.seed}, {len(numbers)} motions")
    print(f"{'':32}    tried  explained  not explained")
    for claim, count in tried.items():
        print(f"{claim:<32} {count:8d} {explained[claim]:10d} {unexplained[claim]:14d}")
    return 1 if unexplained.total() else 0


if __name__ == "__main__":
    sys.exit(main())
