"""What whole commands cost, in units of importing NumPy.

Each command alternates with ``python -c "import numpy"``, each in a new process; the result is the
median ratio of their processor times (user and system). Run, with the package installed:

    .venv/bin/python bench/commands.py

With the argument ``start``, only quick commands are measured, in units of importing what they need,
and nothing is written.
"""

from __future__ import annotations

import os
import resource
import statistics
import subprocess
import sys
import tempfile
from pathlib import Path

from contest.contestants import ROOT
from contest.tables import put_between

CODE = [sys.executable, "-c"]
RIMROLL = [sys.executable, "-m", "rimroll.cli"]
NUMPY = [*CODE, "import numpy"]

FALLS = str(ROOT / "examples/falls_of_the_paper.csv")
COMMANDS = {
    '`python -c "import rimroll"`': ([*CODE, "import rimroll"], 9),
    "`rimroll --version`": ([*RIMROLL, "--version"], 9),
    "`rimroll turn`": ([*RIMROLL, "turn"], 9),
    "`rimroll topple can_2007`, 42 falls": ([*RIMROLL, "topple", "can_2007"], 9),
    "`rimroll fit examples/falls_of_the_paper.csv`": ([*RIMROLL, "fit", FALLS], 5),
    "`rimroll simulate --tilt 30deg -o can.gif`, 2 s": (
        [*RIMROLL, "simulate", "--tilt", "30deg", "--yaw-rate", "0.005", "-o", "can.gif"],
        3,
    ),
    "`rimroll simulate --tilt 30deg -o can.html`, 2 s": (
        [*RIMROLL, "simulate", "--tilt", "30deg", "--yaw-rate", "0.005", "-o", "can.html"],
        3,
    ),
    "`rimroll reproduce`": ([*RIMROLL, "reproduce", "-o", "paper"], 3),
}
"""The commands, and how many times each is run."""

TYPER = [*CODE, "import typer"]
STARTS = {
    "import rimroll, of import numpy": ([*CODE, "import rimroll"], NUMPY),
    "rr.simulate, rr.bodies, of import numpy": (
        [*CODE, "import rimroll as rr; rr.simulate; rr.bodies.can_2007()"],
        NUMPY,
    ),
    "rimroll --help, of import typer": ([*RIMROLL, "--help"], TYPER),
    "rimroll --version, of import typer": ([*RIMROLL, "--version"], TYPER),
    "rimroll turn can_2007, of import numpy, typer": (
        [*RIMROLL, "turn", "can_2007"],
        [*CODE, "import numpy, typer"],
    ),
}
"""Quick commands, and what each is compared with."""


def main() -> None:
    if sys.argv[1:] == ["start"]:
        starts()
        return
    lines = [["", "times importing NumPy: median, range"], ["---", "--:"]]
    with tempfile.TemporaryDirectory() as folder:
        run = Run(Path(folder))
        run.seconds(NUMPY)
        for name, (command, rounds) in COMMANDS.items():
            run.seconds(command)  # fills the caches
            found = [run.seconds(command) / run.seconds(NUMPY) for _ in range(rounds)]
            result = f"**{statistics.median(found):.1f}**, {min(found):.1f} to {max(found):.1f}"
            lines.append([name, result])
            print(name, result, flush=True)
    table = "\n".join("| " + " | ".join(cells) + " |" for cells in lines)
    put_between(ROOT / "docs/performance.md", "commands", table)


def starts() -> None:
    with tempfile.TemporaryDirectory() as folder:
        run = Run(Path(folder))
        for name, (command, unit) in STARTS.items():
            run.seconds(command), run.seconds(unit)
            found = [run.seconds(command) / run.seconds(unit) for _ in range(15)]
            print(f"{name}: {statistics.median(found):.2f}, {min(found):.2f} to {max(found):.2f}")


class Run:
    """Runs commands in a folder, with all bytecode cached in it."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.environment = {**os.environ, "PYTHONPYCACHEPREFIX": str(folder / "bytecode")}
        self.environment.pop("PYTHONDONTWRITEBYTECODE", None)

    def seconds(self, command: list[str]) -> float:
        """The processor time of a command (user and system), s; raises if it fails."""
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        subprocess.run(
            command,
            cwd=self.folder,
            env=self.environment,
            check=True,
            stdout=subprocess.DEVNULL,
        )
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        return after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime


if __name__ == "__main__":
    main()
