"""What was measured, as JSON: all engines that were scored into the same folder."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import Any, Self

from rimroll_score.checks import Check
from rimroll_score.distribution import Distribution
from rimroll_score.measures import Measured
from rimroll_score.sweep import Run

FORMAT = 1


@dataclass
class EngineResult:
    """All measurements of an engine."""

    name: str
    version: str
    settings: Mapping[str, str]
    command: str
    """What repeats the measurement."""
    machine: Mapping[str, str]
    scored_by: str
    """Versions of rimroll and rimroll-score."""
    runs: list[Run]
    checks: list[Check] = field(default_factory=list)
    falls: list[Distribution] = field(default_factory=list)
    paths: dict[str, list[list[float]]] = field(default_factory=dict)
    """By setting: where the top of the axis is, seen from above, in ``rolling_near``."""
    warning: str = ""

    def of(self, case: str, setting: str) -> list[Run]:
        """The runs of a case with a setting."""
        return [run for run in self.runs if run.case == case and run.setting == setting]

    def departures(self, setting: str) -> list[str]:
        """What the engine did otherwise than asked with a setting, each once."""
        told = (one for run in self.runs if run.setting == setting for one in run.departures)
        return list(dict.fromkeys(told))

    @classmethod
    def from_json(cls, data: Mapping[str, Any]) -> Self:
        plain = dict(data)
        plain["runs"] = [_run(run) for run in data["runs"]]
        plain["checks"] = [Check(**check) for check in data["checks"]]
        plain["falls"] = [Distribution(**falls) for falls in data["falls"]]
        return cls(**plain)


def _run(data: Mapping[str, Any]) -> Run:
    found = data["measured"] and Measured(**data["measured"])
    return Run(**{**data, "measured": found, "departures": tuple(data["departures"])})


def load(folder: Path) -> dict[str, EngineResult]:
    """Results by engine in a folder; none if it has no file of results.

    Raises ``ValueError`` for a file of another format.
    """
    file = folder / "results.json"
    if not file.exists():
        return {}
    data = json.loads(file.read_text("utf-8"))
    if data.get("format") != FORMAT:
        raise ValueError(f"{file} is not a file of results in format {FORMAT}")
    return {name: EngineResult.from_json(one) for name, one in data["engines"].items()}


def save(folder: Path, results: Sequence[EngineResult]) -> None:
    """Write the results of all engines."""
    engines = {one.name: asdict(one) for one in results}
    data = {"format": FORMAT, "engines": engines}
    text = json.dumps(data, separators=(",", ":"), allow_nan=False)
    (folder / "results.json").write_text(text + "\n", "utf-8")
