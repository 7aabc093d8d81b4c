"""Best settings are searched for: ``python -m rimroll_score.search ENGINE ... -o FOLDER``.

Each option of an adapter's best settings is set to each of its choices, one at a time, and some
cases are run at two steps. The *misfit* of a choice is the mean, over these runs, of the decimal
logarithm of the larger of angle error / 1 degree and energy error / 1 %; each logarithm counts as
at most 2, as does a run without a turn, and as at least -2.
"""

from __future__ import annotations

import argparse
import json
import math
from collections.abc import Iterator, Mapping
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

from rimroll_score import environments
from rimroll_score.cases import cases
from rimroll_score.page import Bounds
from rimroll_score.registry import located
from rimroll_score.sweep import run
from rimroll_score.worker import Worker

PROBES = ("rolling_far", "rolling_near", "sliding_far", "friction", "wobble", "circle", "flight")
PROBE_STEPS = (5e-4, 1e-4)
LIMIT = 2.0
FILE = "search.json"


@dataclass(frozen=True)
class Tried:
    """Best settings with one option changed.

    For the best settings themselves ``option`` is empty and ``value`` holds all options.
    """

    engine: str
    version: str
    option: str
    value: Any
    misfit: float
    passed: int
    """Runs within 1 degree and 1 % of energy."""
    runs: int


def search(engine: str, worker: Worker) -> Iterator[Tried]:
    """The best settings, and then each change of one option."""
    described = worker.describe()
    best, version = described["best"], described["version"]
    yield Tried(engine, version, "", best, *misfit(worker, {}))
    for option, values in described["choices"].items():
        for value in values:
            if value != best[option]:
                yield Tried(engine, version, option, value, *misfit(worker, {option: value}))


def misfit(worker: Worker, changes: Mapping[str, Any]) -> tuple[float, int, int]:
    """The misfit of best settings with changes, and how many of how many runs passed."""
    by_name, bounds = {case.name: case for case in cases()}, Bounds()
    found = []
    for name in PROBES:
        for dt in PROBE_STEPS:
            one = run(worker, by_name[name], dt, "best", changes=changes)
            if one.status == "unsupported":
                continue
            worst = max(one.error / bounds.angle, one.energy / bounds.energy)
            found.append(min(max(math.log10(max(worst, 1e-300)), -LIMIT), LIMIT))
    return round(sum(found) / len(found), 3), sum(value <= 0.0 for value in found), len(found)


def load(folder: Path) -> list[Tried]:
    """What was tried, as stored in a folder."""
    file = folder / FILE
    data = json.loads(file.read_text("utf-8")) if file.exists() else []
    return [Tried(**one) for one in data]


def main() -> None:
    """Search for the engines named, and put what was tried among that of others."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("engine", nargs="+")
    parser.add_argument("-o", "--output", type=Path, default=Path("scorecard"))
    options = parser.parse_args()
    options.output.mkdir(parents=True, exist_ok=True)
    for engine in options.engine:
        kept = [one for one in load(options.output) if one.engine != engine]
        with Worker(located(engine), environments.installed(engine)) as worker:
            for tried in search(engine, worker):
                print(engine, tried.option, tried.value, tried.misfit, tried.passed, flush=True)
                kept.append(tried)
        kept.sort(key=lambda one: one.engine)
        lines = ",\n".join(json.dumps(asdict(one)) for one in kept)
        (options.output / FILE).write_text(f"[\n{lines}\n]\n", "utf-8")


if __name__ == "__main__":
    main()
