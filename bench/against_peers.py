"""rimroll against its peers, on the same starts, at verified accuracy, in one run.

    make bench                                       install, measure, write bench/results/
    .venv/bin/python bench/against_peers.py --redraw tables and figures of the last run again

docs/performance.md says what is measured, and how.
"""

from __future__ import annotations

import argparse
import json
from contextlib import ExitStack
from pathlib import Path

from contest import figures, machine, tables
from contest.contestants import CONTESTANTS, LAWS, OF_A_MOTION, ROOT, Contestant, workers
from contest.results import Results, Row
from contest.rounds import Point, repeat, sweep
from contest.starts import every, near_collisions, sixty_turns, two_seconds
from contest.worker import Worker

RESULTS = ROOT / "bench/results"
PAGE = ROOT / "docs/performance.md"
TARGET_ERROR = 1e-9
"""Contestants are set to at most this error (rad) for the study over eps."""


def points_of_turns(contestant: Contestant) -> list[list[Point]]:
    """A sweep over the tolerances for each law."""
    starts = every(sixty_turns(), contestant.every)
    return [
        [Point(contestant, "turn", law, tol, starts) for tol in contestant.tolerances]
        for law in LAWS
    ]


def points_of_motions(contestant: Contestant) -> list[list[Point]]:
    starts = two_seconds()
    return [
        [Point(contestant, "motion", law, tol, starts) for tol in contestant.tolerances]
        for law in LAWS
    ]


def points_of_near_collisions(contestant: Contestant, turns: list[Row]) -> list[list[Point]]:
    """With the cheapest setting that computes all sixty turns to the target error, or half of them
    if no setting computes all."""
    chosen = []
    for law in LAWS:
        mine = [row for row in turns if row.key == contestant.key and row.law == law]
        good = [row for row in mine if row.worst <= TARGET_ERROR]
        good = good or [row for row in mine if row.median <= TARGET_ERROR]
        if good and contestant.every == 1:
            tolerance = min(good, key=lambda row: row.seconds).tolerance
            chosen += [
                [Point(contestant, "turn", law, tolerance, starts)]
                for starts in near_collisions().values()
            ]
    return chosen


def measured(sweeps: list[list[Point]], at_work: dict[str, Worker], rounds: int) -> list[Row]:
    points = []
    for one in sweeps:
        points += list(sweep(one, at_work[one[0].contestant.worker]))
    repeat(points, at_work, rounds)
    return [Row.of(point) for point in points]


def run(at_work: dict[str, Worker], rounds: int) -> Results:
    def here(contestants: list[Contestant]) -> list[Contestant]:
        return [one for one in contestants if one.worker in at_work]

    print("sixty turns")
    turns = measured([s for c in here(CONTESTANTS) for s in points_of_turns(c)], at_work, rounds)
    print("near-collisions")
    sweeps = [s for c in here(CONTESTANTS) for s in points_of_near_collisions(c, turns)]
    near = measured(sweeps, at_work, rounds)
    print("one motion")
    sweeps = [s for c in here(OF_A_MOTION) for s in points_of_motions(c)]
    motions = measured(sweeps, at_work, rounds)
    return Results(machine.describe(), rounds, turns, near, motions)


def write(results: Results, folder: Path) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    text = json.dumps(results.as_json(), indent=1, ensure_ascii=False)
    (folder / "results.json").write_text(text + "\n", "utf-8")
    tables.write(results, folder)
    figures.write(results, folder)
    if folder == RESULTS:
        tables.put_between(PAGE, "results", tables.summary(results))
    print(f"written to {folder}")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--rounds", type=int, default=7)
    parser.add_argument(
        "--only", nargs="*", help="workers to use; all that are installed unless given"
    )
    parser.add_argument("--output", type=Path, default=RESULTS)
    parser.add_argument("--redraw", action="store_true", help="do not measure again")
    given = parser.parse_args()
    if given.redraw:
        text = (given.output / "results.json").read_text("utf-8")
        return write(Results.from_json(json.loads(text)), given.output)
    with ExitStack() as stack:
        at_work = {
            name: stack.enter_context(Worker(command))
            for name, command in workers().items()
            if given.only is None or name in given.only
        }
        print("taking part:", ", ".join(at_work))
        write(run(at_work, given.rounds), given.output)


if __name__ == "__main__":
    main()
