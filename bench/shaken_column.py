"""The cost of a motion on a table that moves, for rimroll alone and in lanes and for its peers.

Sixty-four starts of a column are followed through a synthetic record of 40 s, sampled every 5 ms,
under which the column rocks and does not topple. The acceleration has a corner at each sample,
where every contestant ends a step. All integrate the same equations in the same coordinates over
the time; rimroll also detects all events, and keeps the place of the body and its energy accounts.
Contestants are judged by their errors, and run at many tolerances. Run, after bench/install.sh and
with the package installed:

    .venv/bin/python bench/shaken_column.py
"""

from __future__ import annotations

import argparse
import os
import statistics
from contextlib import ExitStack
from pathlib import Path

import numpy as np
from contest import machine
from contest.contestants import (
    BUILT,
    PEERS_PY,
    PEERS_VENV,
    ROOT,
    VENV,
    Contestant,
    tolerances,
    workers,
)
from contest.results import Row, cheapest
from contest.rounds import Point, repeat, sweep
from contest.starts import Starts, every
from contest.tables import cost, markdown, power, put_between
from contest.worker import Question, Worker

import rimroll as rr

SEED = 1
AMPLITUDE = (1.2, 0.9, 0.6)
"""Peaks of the record, m/s²."""
STEP, DURATION = 0.005, 40.0
TILTS = np.linspace(0.05, 0.06, 64)
ERRORS = (1e-6, 1e-7)
FRICTIONS = (0.6, 0.3, 0.2)
RTOL = 1e-9
FINE = tolerances(5, 12, 1)

ALONE = Contestant("rimroll in Rust, alone", "core_shaken", "core", tolerances=FINE)
MANY = Contestant("rimroll in Rust, in lanes", "core_shake_many", "core", tolerances=FINE)
CONTESTANTS = [
    Contestant("rimroll: simulate", "rimroll_simulate", "rimroll", tolerances=FINE),
    Contestant("rimroll: shake_many", "rimroll_shake_many", "rimroll", tolerances=FINE),
    ALONE,
    MANY,
    Contestant("Boost.odeint, dopri5", "boost_dopri5", "boost", tolerances=FINE),
    Contestant("Boost.odeint, rkf78", "boost_rkf78", "boost", tolerances=FINE),
    Contestant("numba, DOP853", "numba_dop853", "numba", tolerances=FINE),
    Contestant("SciPy, DOP853", "scipy_dop853", "scipy", tolerances=(1e-6, 1e-8, 1e-10), every=32),
]


def column_workers() -> dict[str, list[Path | str]]:
    """The commands of the workers that follow a column."""
    commands = {name: command for name, command in workers().items() if name in ("core", "boost")}
    for name, python in ("rimroll", VENV), ("numba", PEERS_VENV), ("scipy", PEERS_VENV):
        commands[name] = [python, PEERS_PY / "worker.py", f"{name}_column"]
    return {name: command for name, command in commands.items() if os.access(command[0], os.X_OK)}


def written(truth: np.ndarray | None) -> Starts:
    """The table of starts, with the tilts at the end of the record, which is written beside it."""
    folder = BUILT / "starts"
    folder.mkdir(parents=True, exist_ok=True)
    ground = rr.ground.synthetic(SEED, AMPLITUDE, duration=DURATION, step=STEP)
    samples = ground(STEP * np.arange(round(DURATION / STEP) + 1))
    # Exact at the corners, where the number of the sample decides.
    np.savetxt(folder / "record.csv", samples, fmt="%.17g", delimiter=",")
    ends = np.zeros(len(TILTS)) if truth is None else truth
    rows = [
        f"{tilt!r},0,0,0,{end!r}" for tilt, end in zip(TILTS.tolist(), ends.tolist(), strict=True)
    ]
    path = folder / "columns.csv"
    head = "tilt,tilt_rate,yaw_rate,spin_rate,end_tilt"
    path.write_text("\n".join([head, *rows]) + "\n", "utf-8")
    return Starts.read(path)


def accurate(at_work: dict[str, Worker]) -> np.ndarray:
    """The tilts at the end by the tightest tolerance of two independent programs, and their
    difference."""
    path = written(None).path
    ask = [("numba", "numba_dop853", 1e-14), ("core", "core_shaken", 1e-13)]
    found = [
        at_work[name].ask(Question("shaken", method, "regular", "no_slip", rtol, path)).found
        for name, method, rtol in ask
    ]
    print(f"the references differ by up to {np.abs(found[0] - found[1]).max():.1e} rad")
    return found[0]


def dry(at_work: dict[str, Worker], path: Path, rounds: int) -> str:
    """The cost of dry friction over that of rolling."""
    lines = []
    for friction in FRICTIONS:
        cells = [f"Coulomb friction of {friction:g}"]
        for one in ALONE, MANY:
            pairs = [
                [
                    at_work["core"].ask(
                        Question("shaken", method, "regular", "no_slip", RTOL, path)
                    )
                    for method in (f"{one.method}:{friction}", one.method)
                ]
                for _ in range(rounds)
            ]
            ratios = [slips.seconds / rolls.seconds for slips, rolls in pairs]
            cells.append(
                f"**{statistics.median(ratios):.2f}**, {min(ratios):.2f} to {max(ratios):.2f}"
            )
        lines.append(cells)
        print(" | ".join(cells))
    return markdown([f"over rolling, at rtol {power(RTOL)}", "alone", "in lanes"], lines)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument(
        "--only", nargs="*", help="workers to use; all that are installed by default"
    )
    parser.add_argument("--no-page", action="store_true", help="do not write into the page")
    given = parser.parse_args()
    with ExitStack() as stack:
        at_work = {
            name: stack.enter_context(Worker(command))
            for name, command in column_workers().items()
            if given.only is None or name in given.only
        }
        print("taking part:", ", ".join(at_work))
        starts = written(accurate(at_work))
        points: list[Point] = []
        for one in CONTESTANTS:
            if one.worker in at_work:
                mine = every(starts, one.every)
                settings = [Point(one, "shaken", "no_slip", rtol, mine) for rtol in one.tolerances]
                points += list(sweep(settings, at_work[one.worker]))
        repeat(points, at_work, given.rounds)
        rows = [Row.of(point) for point in points]
        for row in rows:
            print(
                f"{row.method:20} {row.tolerance:.0e} {1e6 * row.seconds:10.0f} µs, {row.worst:.1e}"
            )
        friction = dry(at_work, starts.path, given.rounds)
    text = "\n\n".join([table(rows), friction])
    print(text)
    if not given.no_page:
        put_between(ROOT / "docs/performance.md", "shaken column", text)


def table(rows: list[Row]) -> str:
    """The cost of each contestant at a verified error."""
    alone = {error: cheapest(rows, ALONE, "no_slip", error) for error in ERRORS}
    lines = []
    for one in CONTESTANTS:
        found = [cheapest(rows, one, "no_slip", error) for error in ERRORS]
        if any(row.method == one.method for row in rows):
            name = f"**{one.name}**" if one.is_ours else one.name
            name += f" ({64 // one.every} starts)" if one.every > 1 else ""
            ratios = [
                f"{row.times_of(best):.2f}" if row and best else "—"
                for row, best in zip(found, alone.values(), strict=True)
            ]
            pairs = zip(found, ratios, strict=True)
            lines.append([name, *(cell for row, ratio in pairs for cell in (cost(row), ratio))])
    head = ["µs a motion of 40 s, one core"]
    for error in ERRORS:
        head += [f"to {power(error)} rad", "over alone"]
    who = machine.describe()
    versions = ", ".join(f"{name} {version}" for name, version in who["versions"].items())
    note = (
        f"Measured on one core of {who['processor']}, {who['cores']} cores. Versions: {versions}."
    )
    return "\n\n".join([note, markdown(head, lines)])


if __name__ == "__main__":
    main()
