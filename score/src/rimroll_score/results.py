"""What was measured, as JSON: all engines that were scored into the same folder."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass, field, fields
from pathlib import Path
from typing import Any, Self

from rimroll_score.checks import Check
from rimroll_score.distribution import Distribution
from rimroll_score.measures import Measured
from rimroll_score.sweep import Run

FORMAT = 2
DIGITS = 6
"""Significant digits of the numbers in the file."""


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
    runs: list[Run] = field(default_factory=list)
    checks: list[Check] = field(default_factory=list)
    falls: list[Distribution] = field(default_factory=list)
    paths: dict[str, list[list[float]]] = field(default_factory=dict)
    """By setting, the motion in ``rolling_near``: see :mod:`rimroll_score.paths`."""
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
        told = [tuple(one) for one in plain.pop("departures")]
        plain["runs"] = [
            _run(setting, case, dict(zip(COLUMNS, row, strict=True)), told)
            for setting, found in data["runs"].items()
            for case, rows in found.items()
            for row in rows
        ]
        plain["checks"] = [Check(**check) for check in data["checks"]]
        plain["falls"] = [Distribution(**falls) for falls in data["falls"]]
        return cls(**plain)


MEASURES = tuple(one.name for one in fields(Measured))
COLUMNS = ("dt", "status", "message", "cost", "repeats", "differ", "departures", *MEASURES)
"""The columns of a run in the file; ``departures`` is an index into the list of an engine."""


def _run(
    setting: str, case: str, row: dict[str, Any], departures: Sequence[tuple[str, ...]]
) -> Run:
    values = {name: row.pop(name) for name in MEASURES}
    found = None if values["note"] is None else Measured(**values)
    told = departures[row.pop("departures")]
    return Run(case=case, setting=setting, measured=found, departures=told, **row)


def _in_json(result: EngineResult) -> dict[str, Any]:
    """An engine's results, with runs as rows by setting and case."""
    departures = list(dict.fromkeys(run.departures for run in result.runs))
    runs: dict[str, dict[str, list[Any]]] = {}
    for run in result.runs:
        plain = vars(run) | {"departures": departures.index(run.departures)}
        plain |= vars(run.measured) if run.measured else dict.fromkeys(MEASURES)
        row = [plain[name] for name in COLUMNS]
        runs.setdefault(run.setting, {}).setdefault(run.case, []).append(row)
    named = {one.name: getattr(result, one.name) for one in fields(result)}
    lists = {name: [asdict(one) for one in named[name]] for name in ("checks", "falls")}
    return {**named, **lists, "departures": departures, "runs": runs}


def _rounded(value: Any) -> Any:
    """The value with numbers to ``DIGITS`` significant digits."""
    if isinstance(value, float):
        return float(f"{value:.{DIGITS}g}")
    if isinstance(value, Mapping):
        return {name: _rounded(one) for name, one in value.items()}
    return [_rounded(one) for one in value] if isinstance(value, list | tuple) else value


def load(folder: Path) -> dict[str, EngineResult]:
    """Results by engine in a folder; none if it has no file of results.

    Raises ``ValueError`` for a file of another format.
    """
    file = folder / "results.json"
    if not file.exists():
        return {}
    try:
        data = json.loads(file.read_text("utf-8"))
    except ValueError:
        data = None
    if not isinstance(data, dict) or data.get("format") != FORMAT:
        raise ValueError(f"{file} is not a file of results in format {FORMAT}")
    return {name: EngineResult.from_json(one) for name, one in data["engines"].items()}


def save(folder: Path, results: Sequence[EngineResult]) -> None:
    """Write the results of all engines, an engine on a line."""
    engines = {one.name: _rounded(_in_json(one)) for one in results}
    data = {"format": FORMAT, "columns": COLUMNS, "engines": engines}
    text = json.dumps(data, separators=(",", ":"), allow_nan=False)
    (folder / "results.json").write_text(text + "\n", "utf-8")
