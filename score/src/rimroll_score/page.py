"""The page: a table of engines by cases, figures, departures."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from rimroll_score import figures
from rimroll_score.cases import cases
from rimroll_score.results import EngineResult
from rimroll_score.sweep import Run, grade

CHECKS = {
    "heading": "another heading",
    "spin": "turned about its own axis",
    "mirror": "mirrored",
    "half_step": "half the step",
    "scale": "four times as large",
    "table": "half of gravity as acceleration of the table",
}


@dataclass(frozen=True)
class Cell:
    """A place of the table: what stands there, how it looks and what a pointer shows."""

    text: str
    look: str
    title: str


@dataclass(frozen=True)
class Bounds:
    """Within what an engine must stay: degrees and a fraction of the energy."""

    angle: float = 1.0
    energy: float = 0.01


def write(folder: Path, results: Sequence[EngineResult], bounds: Bounds) -> Path:
    """Write ``index.html``, which loads nothing but the films of the folder."""
    from jinja2 import Environment, FileSystemLoader, StrictUndefined

    templates = FileSystemLoader(Path(__file__).parent)
    loaded = Environment(loader=templates, autoescape=True, undefined=StrictUndefined)
    shown = sorted(results, key=lambda one: one.name)
    page = folder / "index.html"
    settings = {s for one in shown for s in one.settings} & {"defaults", "best"}
    text = loaded.get_template("page.html").render(
        bounds=bounds,
        cases=cases(),
        engines=shown,
        rows=list(rows(shown, bounds)),
        check_names=CHECKS,
        check_rows=list(check_rows(shown)),
        fall_rows=[(one, falls) for one in shown for falls in one.falls],
        figures=[
            (setting, figures.errors(shown, setting), figures.resolution(shown, setting))
            for setting in sorted(settings)
        ],
        paths=figures.paths(shown),
        films=[one for one in shown if (folder / f"{one.name}.webp").exists()],
    )
    page.write_text(text, "utf-8")
    return page


def rows(results: Sequence[EngineResult], bounds: Bounds) -> Any:
    """Engine, setting and a cell for each case."""
    for result in results:
        for setting in result.settings:
            cells = [cell(result.of(case.name, setting), bounds) for case in cases()]
            yield result, setting, cells


def cell(runs: Sequence[Run], bounds: Bounds) -> Cell:
    """The grade of an engine in a case; the pointer shows its errors at the finest step."""
    if not runs:
        return Cell("", "none", "not run")
    finest = min(runs, key=lambda run: run.dt)
    statuses = {run.status for run in runs}
    if statuses == {"unsupported"}:
        return Cell("—", "none", finest.message)
    found = grade(runs, bounds.angle, bounds.energy)
    ran = [run for run in runs if run.measured]
    if not ran:
        return Cell(finest.status.replace("_", " "), "bad", finest.message)
    best = min(ran, key=lambda run: run.dt)
    title = f"at {in_ms(best.dt)}: {in_words(best)}"
    if found is not None:
        return Cell(in_ms(found), "good", title)
    near = best.error <= 10 * bounds.angle and best.energy <= 10 * bounds.energy
    return Cell("none tried", "middle" if near else "bad", title)


def in_ms(step: float) -> str:
    """A step in milliseconds."""
    return f"{1e3 * step:g} ms"


def in_words(run: Run) -> str:
    """The errors of a run."""
    assert run.measured is not None
    error = run.measured.angle_error
    angle = run.measured.note if error is None else f"{error:+.3g}°"
    side = ", on the wrong side" if run.measured.right_side is False and error is not None else ""
    return f"{angle}{side}, energy {100 * run.measured.energy_error:+.3g} %"


def check_rows(results: Sequence[EngineResult]) -> Any:
    """Engine, setting and the change of the turn under each check."""
    for result in results:
        for setting in result.settings:
            found = {one.name: one for one in result.checks if one.setting == setting}
            if found:
                yield result, setting, [found.get(name) for name in CHECKS]
