"""The cost of dry friction in ensembles, as a multiple of that of rolling.

Starts are followed with Coulomb friction, where they slip, stick and slip again, and
without slip, alternately and on one thread. The result is the median ratio of processor times. Run,
with the package installed:

    .venv/bin/python bench/dry_friction.py
"""

from __future__ import annotations

import statistics
import time
from functools import partial

import numpy as np
from contest.contestants import ROOT
from contest.pairs import ROUNDS, ratios, starts
from contest.tables import put_between

import rimroll as rr

STARTS = 40_000
FRICTIONS = (0.1, 0.2, 0.4)
TOLERANCES = {"10⁻⁶": 1e-6, "10⁻⁹": 1e-9}


def main() -> None:
    can, start = rr.bodies.can_2007(), starts(STARTS)
    follow = partial(rr.ensemble, can, start, threads=1)
    head = [f"{ROUNDS} rounds of {STARTS:,} starts".replace(",", " "), "of them slid"]
    head += [f"at rtol {name}" for name in TOLERANCES]
    lines = [head, ["---"] + ["--:"] * (len(head) - 1)]
    for friction in FRICTIONS:
        dry = rr.Coulomb(friction)
        slid = np.mean(follow(dry).slid)
        cells = [f"Coulomb friction of {friction:g}", f"{100 * slid:.0f} %"]
        for rtol in TOLERANCES.values():
            slips, rolls = partial(follow, dry, rtol=rtol), partial(follow, rr.NoSlip(), rtol=rtol)
            found = ratios(slips, rolls, time.process_time)
            cells.append(
                f"**{statistics.median(found):.2f}**, {min(found):.2f} to {max(found):.2f}"
            )
        lines.append(cells)
        print(" | ".join(cells))
    table = "\n".join("| " + " | ".join(cells) + " |" for cells in lines)
    put_between(ROOT / "docs/performance.md", "dry friction", table)


if __name__ == "__main__":
    main()
