"""The starts that all contestants compute, and their accurate results."""

from __future__ import annotations

import io
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from .contestants import BUILT, ROOT

SIXTY = ROOT / "crates/rimroll/tests/integration/given/turns_of_the_can.csv"
STARTS = ROOT / "bench/starts"


@dataclass(frozen=True)
class Starts:
    """A table of starts on disk, its columns by name."""

    path: Path
    columns: np.ndarray

    @classmethod
    def read(cls, path: Path) -> Starts:
        rows = [line for line in path.read_text("utf-8").splitlines() if line[0] != "#"]
        table = np.genfromtxt(io.StringIO("\n".join(rows)), delimiter=",", names=True)
        return cls(path, np.atleast_1d(table))

    def truth(self, task: str, law: str) -> np.ndarray:
        if task == "turn":
            return self.columns[f"turn_{law}"]
        if task == "shaken":
            return self.columns["end_tilt"]
        return np.array([self.columns[f"{angle}_{law}"][0] for angle in ("yaw", "tilt")])

    def part(self, name: str, chosen: np.ndarray) -> Starts:
        """The chosen rows as a separate table in the build folder."""
        lines = self.path.read_text("utf-8").splitlines()
        notes = [line for line in lines if line[0] == "#"]
        head, *rows = lines[len(notes) :]
        path = BUILT / "starts" / f"{name}.csv"
        path.parent.mkdir(parents=True, exist_ok=True)
        kept = [rows[i] for i in np.flatnonzero(chosen)]
        path.write_text("\n".join([*notes, head, *kept]) + "\n", "utf-8")
        return Starts.read(path)


def sixty_turns() -> Starts:
    """Sixty starts of the can, with smallest tilts from 1e-6 to over 1e-3."""
    return Starts.read(SIXTY)


def every(starts: Starts, n: int) -> Starts:
    """Each nth of some starts."""
    if n == 1:
        return starts
    chosen = np.arange(len(starts.columns)) % n == 0
    return starts.part(f"{starts.path.stem}_every_{n}", chosen)


def near_collisions() -> dict[float, Starts]:
    """Eight starts for each yaw and spin rate eps, from far to near."""
    whole = Starts.read(STARTS / "near_collisions.csv")
    rates = whole.columns["yaw_rate"]
    return {
        float(eps): whole.part(f"eps_{eps:.0e}", rates == eps)
        for eps in sorted(set(rates), reverse=True)
    }


def two_seconds() -> Starts:
    """The motion that the paper shows."""
    return Starts.read(STARTS / "two_seconds.csv")
