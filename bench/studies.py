"""What studies cost beside the motions that they compute.

Processor times are those of all processes together. Each cost is a ratio of runs that follow each
other, so that other work on the machine changes it little. Turns without slip are the hardest case,
since a turn takes only microseconds. Run, with the package and its extra ``cluster`` installed:

    .venv/bin/python bench/studies.py [overhead] [processes] [scheduler] [prices]

Each part prints rows of the tables in docs/studies-on-many-machines.md. Together they take about
fifteen minutes of processor time, half of them for the tasks of the scheduler.
"""

from __future__ import annotations

import json
import os
import resource
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
from contest.contestants import ROOT

import rimroll as rr
from rimroll.study.plan import in_bytes

ROUNDS = 5
ROWS = 1_000_000
FEW = ["turn", "outcome", "direction"]
TASKS = (1000, 10_000, 100_000)
"""Numbers of tasks that do nothing, for the cost of the scheduler."""

SPREAD = {"distribution": "uniform", "low": -0.02, "high": 0.02}

Cost = dict[str, float]
"""Processor time (s), time (s) and memory (MB)."""


def study(rows: int, keep: str | list[str] = "all") -> rr.Study:
    """Turns of the can of 2007 without slip, from random sideways rates, in chunks by default."""
    return rr.Study(
        body=rr.bodies.can_2007(),
        law="no_slip",
        start={"tilt": "30 deg", "tilt_rate": -0.5},
        random={"start.yaw_rate": SPREAD, "start.spin_rate": SPREAD},
        trials=rows,
        keep=keep,
        seed=1,
    )


def overhead(folder: Path) -> Iterator[str]:
    """What a study in the process takes more than the same turns in the bare ensemble."""
    stores = (folder / f"{k}.zarr" for k in range(10_000))
    study(1).run(next(stores))  # loads what a run needs
    yield "| a study of 10⁶ turns in one process, over `rr.ensemble` | processor time | time |"
    for name, keep in {"17 columns kept": "all", "3 columns kept": FEW}.items():
        found = [paired(keep, next(stores)) for _ in range(ROUNDS)]
        clocks_apart = zip(*found, strict=True)
        more = [[100.0 * (whole / bare - 1.0) for bare, whole in one] for one in clocks_apart]
        yield f"| {name}, median and range of {ROUNDS} pairs | {' | '.join(map(spread, more))} |"
    turn = statistics.median(one[0][0] for one in found) / ROWS
    yield f"a turn of rr.ensemble: {1e6 * turn:.2f} µs"
    size = sum(file.stat().st_size for file in (folder / "1.zarr").rglob("*") if file.is_file())
    yield f"17 columns of a turn: {size / ROWS:.1f} bytes on the disk"


def paired(keep: str | list[str], store: Path) -> list[tuple[float, float]]:
    """Processor time and time (s): each of the bare ensemble and of a study of its starts."""
    drawn = study(ROWS, ["yaw_rate", "spin_rate"]).plan().compute(0, ROWS)
    start = rr.State(
        tilt="30 deg", tilt_rate=-0.5, yaw_rate=drawn["yaw_rate"], spin_rate=drawn["spin_rate"]
    )
    moments = [clocks()]
    falls = rr.ensemble(rr.bodies.can_2007(), start, rr.NoSlip())
    moments.append(clocks())
    kept = study(ROWS, keep).run(store)
    moments.append(clocks())
    assert np.array_equal(kept.turn.values, falls.turn.values, equal_nan=True)
    return [(b - a, c - b) for a, b, c in zip(*moments, strict=True)]


def clocks() -> tuple[float, float]:
    """Processor time and time, s."""
    return time.process_time(), time.perf_counter()


def spread(percent: list[float]) -> str:
    """A median and a range."""
    low, high = min(percent), max(percent)
    return f"{statistics.median(percent):+.1f} %, {low:+.1f} to {high:+.1f} %"


def processes(folder: Path) -> Iterator[str]:
    """What processes of this machine cost, from runs of two sizes."""
    sizes = (ROWS, 4 * ROWS)
    costs: dict[int, list[Cost]] = {0: [], 1: [], 2: []}
    for rows in sizes:
        for workers, found in costs.items():
            found.append(measured("run", str(folder), str(workers), str(rows)))
    yield "| workers | turns | processor time | time | largest process |"
    for workers, found in costs.items():
        for rows, cost in zip(sizes, found, strict=True):
            cells = f"{cost['processor']:.1f} s | {cost['time']:.1f} s | {cost['memory']:.0f} MB"
            yield f"| {workers} | {rows:.0e} | {cells} |"
    each = {
        workers: (large["processor"] - small["processor"]) / (sizes[1] - sizes[0])
        for workers, (small, large) in costs.items()
    }
    yield f"to start and end two workers: {costs[2][0]['processor'] - each[2] * ROWS:.1f} s"
    for one in (0, 1):
        more = 100.0 * (each[2] / each[one] - 1.0)
        yield f"a turn with two workers over one with {one or 'no'} worker: {more:+.1f} %"


def scheduler(folder: Path) -> Iterator[str]:
    """What tasks that do nothing cost on two workers."""
    yield "| tasks | processor time of a task | tasks in a second | largest process |"
    for tasks in TASKS:
        cost = measured("tasks", str(folder), str(tasks))
        cells = f"{1e3 * cost['processor'] / tasks:.2f} ms | {tasks / cost['time']:.0f}"
        yield f"| {tasks} | {cells} | {cost['memory']:.0f} MB |"


def measured(*arguments: str) -> Cost:
    """What a run of :func:`run` or :func:`tasks` in a process of its own costs."""
    run = subprocess.run(
        [sys.executable, __file__, *arguments], check=True, stdout=subprocess.PIPE, text=True
    )
    answer: Cost = json.loads(run.stdout.splitlines()[-1])
    return answer


def run(folder: str, workers: str, rows: str) -> Cost:
    """A study with so many workers, or in the process if there are 0."""
    begin = time.perf_counter()
    study(int(rows)).run(Path(folder) / f"{workers}-{rows}.zarr", workers=int(workers) or None)
    return cost(time.perf_counter() - begin, 0.0)


def tasks(folder: str, number: str) -> Cost:
    """Tasks that do nothing, on two workers; the scheduler is in this process."""
    import distributed

    from rimroll.study import cluster

    plan = study(1).plan()
    store = cluster.Store.create(Path(folder) / f"tasks-{number}.zarr", plan)
    with (
        distributed.LocalCluster(
            n_workers=2, threads_per_worker=1, dashboard_address=None
        ) as processes,
        distributed.Client(processes) as client,
    ):
        cluster.task = nothing
        cluster.compute(client, store, plan, list(range(100)), lambda _: None, print)
        used, begin = cost(0.0, 0.0)["processor"], time.perf_counter()
        cluster.compute(client, store, plan, list(range(int(number))), lambda _: None, print)
        seconds = time.perf_counter() - begin
    return cost(seconds, used)


def nothing(path: str, *more: Any) -> dict[str, str]:
    """Stands for the work of a task; only makes its mark, which is not flushed."""
    Path(path, "done", f"{more[-1]}.json").touch()
    return {}


def cost(seconds: float, before: float) -> Cost:
    """The costs of this process and of its children that have ended."""
    own, of_children = (
        resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)
    )
    used = sum(one.ru_utime + one.ru_stime for one in (own, of_children))
    memory = max(own.ru_maxrss, of_children.ru_maxrss) / 1024.0
    return {"processor": used - before, "time": seconds, "memory": memory}


def prices(_: Path) -> Iterator[str]:
    """What many motions cost, in proportion to some."""
    column = rr.Study.from_file(ROOT / "examples/studies/fragility_of_a_column.toml").plan()
    kinds = {"turns without slip": (study(ROWS).plan(), 5, 100_000), "columns": (column, 40, 25)}
    yield "| core-hours | 10⁶ | 10⁹ | 10¹² | size |"
    for name, (plan, places, rows) in kinds.items():
        begin = time.process_time()
        for first in np.linspace(0, plan.rows - rows, places).astype(int).tolist():
            plan.compute(first, first + rows)
        seconds = (time.process_time() - begin) / (places * rows)
        cells = [f"{seconds * number / 3600.0:.2g}" for number in (1e6, 1e9, 1e12)]
        size = in_bytes(plan.bytes if plan.statistics else plan.bytes / plan.rows)
        each = "all" if plan.statistics else "each"
        yield f"| {name}, {1e6 * seconds:.1f} µs | {' | '.join(cells)} | {size} {each} |"


PARTS = {one.__name__: one for one in (overhead, processes, scheduler, prices)}


def main(names: list[str]) -> None:
    """Print the tables of some parts, or of all."""
    print(f"{os.cpu_count()} processors, load {os.getloadavg()[0]:.1f}")
    for name in names or PARTS:
        with tempfile.TemporaryDirectory() as folder:
            for line in PARTS[name](Path(folder)):
                print(line, flush=True)


if __name__ == "__main__":
    alone: dict[str, Any] = {"run": run, "tasks": tasks}
    if sys.argv[1:2] and sys.argv[1] in alone:
        print(json.dumps(alone[sys.argv[1]](*sys.argv[2:])))
    else:
        main(sys.argv[1:])
