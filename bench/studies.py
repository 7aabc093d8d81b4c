"""What studies cost beside the motions that they compute.

All costs are processor times of one run on one machine, of all processes together, so other work
on the machine changes them little. Studies of turns without slip are the hardest case, since a turn
takes only microseconds. Run, with the package installed:

    .venv/bin/python bench/studies.py

It takes some minutes and prints its tables, for docs/studies-on-many-machines.md.
"""

from __future__ import annotations

import json
import resource
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from typing import Any

import numpy as np
from contest.contestants import ROOT

import rimroll as rr
from rimroll.study.size import in_bytes

ROUNDS = 3
ROWS = 1_000_000
CHUNK = 200_000
FEW = ["turn", "outcome", "direction"]
TINY = 20_000
"""Tasks that do nothing, for the cost of the scheduler."""

SPREAD = {"distribution": "uniform", "low": -0.02, "high": 0.02}


def study(rows: int, keep: str | list[str] = "all") -> rr.Study:
    """Turns of the can of 2007 without slip, from random sideways rates."""
    return rr.Study(
        body=rr.bodies.can_2007(),
        law="no_slip",
        start={"tilt": "30 deg", "tilt_rate": -0.5},
        random={"start.yaw_rate": SPREAD, "start.spin_rate": SPREAD},
        trials=rows,
        chunk=CHUNK,
        keep=keep,
        seed=1,
    )


def main() -> None:
    lines = ["| | measured |", "| --- | --: |"]
    with tempfile.TemporaryDirectory() as folder:
        stores = (Path(folder) / f"{k}.zarr" for k in range(10_000))
        study(1).run(next(stores))  # loads what a run needs
        alone = [overheads(keep, stores) for keep in ("all", FEW)]
        seconds = statistics.median(bare for bare, _ in alone[0]) / ROWS
        lines.append(f"| a turn of `rr.ensemble`, processor time | {1e6 * seconds:.1f} µs |")
        for name, found in zip(("17 columns", "3 columns"), alone, strict=True):
            more = [100.0 * (whole / bare - 1.0) for bare, whole in found]
            lines.append(f"| a study of 10⁶ turns in one process, {name} kept | {spread(more)} |")
        lines += by_processes(folder)
    print("\n".join(prices(seconds)))
    lines.append(f"| a task of the scheduler (of {TINY} that do nothing) | {scheduler()} |")
    print("\n".join(lines))


def prices(turn: float) -> list[str]:
    """What many motions cost, from the processor time of a turn (s) and of a shaken column."""
    column = rr.Study.from_file(ROOT / "examples/studies/fragility_of_a_column.toml").plan()
    some = np.linspace(0, column.rows - 100, 40).astype(int)
    begin = time.process_time()
    for first in some:
        column.compute(int(first), int(first) + 100)
    shaken = (time.process_time() - begin) / (100 * len(some))
    columns = study(ROWS).plan()
    kinds = {
        "turns without slip, 17 columns": (turn, columns.bytes / columns.rows, 0.0),
        "columns in records of 15 s, their statistics": (shaken, 0.0, float(column.bytes)),
    }
    lines = ["| core-hours and size of the store | 10⁶ | 10⁹ | 10¹² |", "| --- | --: | --: | --: |"]
    for name, (seconds, each, all_) in kinds.items():
        cells = [
            f"{seconds * rows / 3600.0:.2g} h, {in_bytes(each * rows + all_)}"
            for rows in (1e6, 1e9, 1e12)
        ]
        lines.append(f"| {name} | {' | '.join(cells)} |")
    return lines


def overheads(keep: str | list[str], stores: Any) -> list[tuple[float, float]]:
    """Processor times of the bare ensemble and of a study with the same starts, alternately."""
    found = []
    for _ in range(ROUNDS):
        begin = time.process_time()
        study(ROWS, keep).run(store := next(stores))
        whole = time.process_time() - begin
        drawn = study(ROWS, ["yaw_rate", "spin_rate"]).plan().compute(0, ROWS)
        start = rr.State(
            tilt="30 deg",
            tilt_rate=-0.5,
            yaw_rate=drawn["yaw_rate"],
            spin_rate=drawn["spin_rate"],
        )
        begin = time.process_time()
        falls = rr.ensemble(rr.bodies.can_2007(), start, rr.NoSlip())
        found.append((time.process_time() - begin, whole))
        kept = rr.Study.run(study(ROWS, keep), store)
        assert np.array_equal(kept.turn.values, falls.turn.values, equal_nan=True)
    return found


def spread(percent: list[float]) -> str:
    """A median and a range."""
    low, high = min(percent), max(percent)
    return f"**{statistics.median(percent):+.0f} %**, {low:+.0f} to {high:+.0f}"


def by_processes(folder: str) -> list[str]:
    """What processes of this machine cost, from runs of two sizes."""
    sizes = (ROWS, 4 * ROWS)
    costs = {workers: [measured(folder, workers, rows) for rows in sizes] for workers in (0, 1, 2)}
    slope = {
        workers: (large["seconds"] - small["seconds"]) / (sizes[1] - sizes[0])
        for workers, (small, large) in costs.items()
    }
    begin = costs[2][0]["seconds"] - slope[2] * ROWS
    small, large = (cost["megabytes"] for cost in costs[2])
    return [
        f"| two local workers: to start and end them | {begin:.1f} s |",
        f"| then, a turn with two workers over one in one process |"
        f" {100.0 * (slope[2] / slope[0] - 1.0):+.0f} % |",
        f"| a turn with two workers over one with one worker |"
        f" {100.0 * (slope[2] / slope[1] - 1.0):+.0f} % |",
        f"| largest process, 10⁶ and 4 × 10⁶ turns | {small:.0f} and {large:.0f} MB |",
    ]


def measured(folder: str, workers: int, rows: int) -> dict[str, float]:
    """Processor time (s) of a run and its workers, and memory (MB) of the largest."""
    run = subprocess.run(
        [sys.executable, __file__, folder, str(workers), str(rows)],
        check=True,
        capture_output=True,
        text=True,
    )
    answer: dict[str, float] = json.loads(run.stdout.splitlines()[-1])
    return answer


def measure(folder: str, workers: int, rows: int) -> None:
    """The run of :func:`measured`."""
    store = Path(folder) / f"by-{workers}-{rows}.zarr"
    study(rows).run(store, workers=workers or None)
    used = [resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)]
    seconds = sum(one.ru_utime + one.ru_stime for one in used)
    print(json.dumps({"seconds": seconds, "megabytes": used[workers > 0].ru_maxrss / 1024.0}))


def scheduler() -> str:
    """Processor time of a task, of scheduler, worker and client together."""
    import distributed

    from rimroll.study import cluster

    store = tempfile.mkdtemp()
    with distributed.Client(
        processes=False, n_workers=1, threads_per_worker=2, dashboard_address=None
    ) as client:
        plan = study(1).plan()
        study(1).run(store)
        opened = cluster.Store(store)
        cluster.task = nothing  # type: ignore[assignment]
        begin = time.process_time()
        cluster.compute(client, opened, plan, list(range(TINY)), lambda _: None, print)
        seconds = time.process_time() - begin
    return f"{1e3 * seconds / TINY:.2f} ms"


def nothing(*_: object) -> dict[str, str]:
    """Stands for the work of a task."""
    return {}


if __name__ == "__main__":
    if len(sys.argv) > 1:
        measure(sys.argv[1], int(sys.argv[2]), int(sys.argv[3]))
    else:
        main()
