"""Every case at every step and setting of an engine: the runs and their measures."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

from rimroll_score.cases import Case
from rimroll_score.measures import Measured, measured
from rimroll_score.protocol import Scene, State
from rimroll_score.worker import Outcome, Task, Worker

STEPS = (2e-3, 1e-3, 5e-4, 2e-4, 1e-4, 5e-5, 2e-5)
"""Steps that are tried, s."""

MAX_SAMPLES = 2000
"""Samples of a motion; between them several steps are taken."""


@dataclass(frozen=True)
class Run:
    """A case that an engine ran at a step (s)."""

    case: str
    setting: str
    dt: float
    status: str
    message: str
    cost: float | None
    """Processor time, s per simulated second."""
    measured: Measured | None
    departures: tuple[str, ...]
    repeats: int = 1
    differ: bool = False
    """Whether repeats of the same run differed."""

    @property
    def error(self) -> float:
        """The absolute angle error, degrees; infinite where there is none."""
        error = self.measured.angle_error if self.measured else None
        return math.inf if error is None else abs(error)

    @property
    def error_or_nan(self) -> float:
        """The signed angle error, degrees; NaN where there is none."""
        error = self.measured.angle_error if self.measured else None
        return math.nan if error is None else error

    @property
    def energy_or_nan(self) -> float:
        """The signed energy error; NaN where there is none."""
        return self.measured.energy_error if self.measured else math.nan

    @property
    def energy(self) -> float:
        """The absolute energy error; infinite where there is none."""
        return abs(self.measured.energy_error) if self.measured else math.inf


def task(scene: Scene, state: State, duration: float, dt: float, setting: str) -> Task:
    """A motion with a bounded number of samples, whose last is at the end or just after it."""
    steps = math.ceil(duration / dt - 1e-9)
    least = max(1, math.ceil(steps / MAX_SAMPLES))
    every = next((k for k in range(least, 2 * least + 1) if steps % k == 0), least)
    return Task(scene, state, dt, every, math.ceil(steps / every), setting)


def run(
    worker: Worker,
    case: Case,
    dt: float,
    setting: str,
    repeats: int = 1,
    changes: Mapping[str, Any] | None = None,
) -> Run:
    """Run a case, several times if asked to; the worst of the repeats counts.

    ``changes`` are options of the best settings that have other values.
    """
    asked = task(case.scene, case.state, case.duration, dt, setting)
    if changes:
        asked = replace(asked, changes=changes)
    outcomes = [worker.run(asked) for _ in range(repeats)]
    runs = [_run(case, dt, setting, outcome) for outcome in outcomes]
    worst = max(runs, key=lambda one: (one.error, one.energy))
    differ = any(one.measured != runs[0].measured for one in runs)
    return replace(worst, repeats=repeats, differ=differ)


def _run(case: Case, dt: float, setting: str, outcome: Outcome) -> Run:
    found = measured(case, outcome.samples) if outcome.samples else None
    return Run(
        case.name, setting, dt, outcome.status, outcome.message, outcome.cost, found,
        outcome.departures,
    )  # fmt: skip


def sweep(
    worker: Worker,
    cases: Sequence[Case],
    steps: Iterable[float],
    settings: Sequence[str],
    repeats: int = 1,
    told: Callable[[Run], object] = lambda run: None,
) -> list[Run]:
    """Run every case with every setting, from the largest step to the smallest.

    A case is left once the engine does not have the scene or a step took too long; the finer steps
    get the same status without a run.
    """
    runs: list[Run] = []
    for setting in settings:
        for case in cases:
            for dt in sorted(steps, reverse=True):
                last = runs[-1] if runs else None
                if last and (last.case, last.setting) == (case.name, setting) and _ends(last):
                    runs.append(replace(last, dt=dt))
                    continue
                runs.append(run(worker, case, dt, setting, repeats))
                told(runs[-1])
    return runs


def _ends(run: Run) -> bool:
    return run.status in ("unsupported", "too_slow", "missing")


def grade(runs: Iterable[Run], max_error: float = 1.0, max_energy: float = 0.01) -> float | None:
    """The largest step from which on all smaller ones are within both bounds; None if none is.

    ``runs`` are those of one case and setting; bounds are in degrees and fractions.
    """
    largest = None
    for one in sorted(runs, key=lambda run: run.dt):
        if one.error > max_error or one.energy > max_energy:
            break
        largest = one.dt
    return largest
