"""Scoring an engine: all cases, checks and falls."""

from __future__ import annotations

import sys
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from importlib.metadata import PackageNotFoundError, version

from rimroll_score import cases as known
from rimroll_score.checks import check
from rimroll_score.distribution import distribution
from rimroll_score.environments import advice
from rimroll_score.machine import machine
from rimroll_score.paths import NEAR, STEP, path_of
from rimroll_score.registry import located
from rimroll_score.results import EngineResult
from rimroll_score.sweep import STEPS, Run, run, sweep, task
from rimroll_score.worker import Worker

PROBE = 5e-4
"""Step at which an engine is run twice to see whether it is deterministic, s."""
REPEATS = 10
"""Runs of each case by an engine that is not."""


class Missing(Exception):
    """The engine cannot be loaded; the message says how to get it."""


class Unknown(Exception):
    """A case or a setting that there is not; the message lists those that there are."""


@dataclass(frozen=True)
class Plan:
    """What to score an engine on. Empty ``cases`` and ``settings`` mean all."""

    steps: Sequence[float] = STEPS
    settings: Sequence[str] = ()
    cases: Sequence[str] = ()
    check_step: float | None = 1e-4
    """Step of the checks and the falls, s; None leaves them out."""
    repeats: int | None = None
    """Runs of each case; None means one, and ten where two runs differ."""
    limit: float = 60.0
    """Longest time of a run, s."""


def score(
    engine: str,
    plan: Plan,
    command: str,
    python: str = sys.executable,
    told: Callable[[Run], object] = lambda run: None,
) -> EngineResult:
    """Score an engine, by a Python that has it.

    Raises ``NoAdapter``, ``Missing`` and ``Unknown``.
    """
    with Worker(located(engine), python, plan.limit) as worker:
        described = worker.describe()
        if described["status"] != "ok":
            remedy = f"; {advice(engine)}" if described["status"] == "missing" else ""
            raise Missing(f"{engine} cannot be loaded: {described['message']}{remedy}")
        if not described["settings"]:
            raise Missing(f"{engine} has no settings: its class is to name at least one")
        settings = _chosen("setting", plan.settings, list(described["settings"]))
        by_name = {case.name: case for case in known.cases()}
        chosen = [by_name[name] for name in _chosen("case", plan.cases, list(by_name))]
        result = EngineResult(
            name=engine.rpartition(":")[2],
            version=described["version"],
            settings={name: described["settings"][name] for name in settings},
            command=command,
            machine=machine(),
            scored_by=f"rimroll {_version('rimroll')}, rimroll-score {_version('rimroll-score')}",
            warning=described.get("warning", ""),
        )
        near = by_name[NEAR]
        for setting in settings:
            repeats = plan.repeats or _repeats(worker, near, setting)
            result.runs += sweep(worker, chosen, plan.steps, [setting], repeats, told)
        for setting in settings if near in chosen else ():
            outcome = worker.run(task(near.scene, near.state, near.duration, STEP, setting))
            if outcome.samples is not None:
                result.paths[setting] = path_of(outcome.samples)
            if plan.check_step is not None:
                result.checks += check(worker, near, plan.check_step, setting)
        if plan.check_step is not None and not plan.cases:
            falls = known.falls()
            result.falls += [
                distribution(worker, falls, plan.check_step, setting) for setting in settings
            ]
    return result


def _repeats(worker: Worker, case: known.Case, setting: str) -> int:
    """How often to run cases: once, or ten times if a run in a new process differs."""
    with Worker(worker.place, worker.python, worker.limit) as other:
        one, two = (run(process, case, PROBE, setting) for process in (worker, other))
    return 1 if one.measured == two.measured else REPEATS


def _chosen(what: str, names: Sequence[str], known_names: Sequence[str]) -> Sequence[str]:
    """The names, or all; ``Unknown`` if one is not known."""
    for name in names:
        if name not in known_names:
            raise Unknown(f"no {what} is called {name!r}; there are {', '.join(known_names)}")
    return names or known_names


def _version(package: str) -> str:
    try:
        return version(package)
    except PackageNotFoundError:  # run from its sources
        return "of the sources"
