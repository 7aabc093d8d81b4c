"""``rimroll score``: physics engines against the truth."""

from __future__ import annotations

import math
import shlex
import sys
from collections.abc import Mapping
from pathlib import Path
from typing import Annotated

import typer

from rimroll.cli.screen import say
from rimroll.errors import RimrollError
from rimroll.files.output import ensure_folder
from rimroll.units import positive, quantity
from rimroll_score import environments, registry, results
from rimroll_score.page import Bounds, in_ms, in_words
from rimroll_score.scoring import Missing, Plan, Unknown
from rimroll_score.scoring import score as scored
from rimroll_score.sweep import STEPS, Run, grade


def score(
    engine: Annotated[
        list[str] | None,
        typer.Argument(help="Engines that have an adapter, or your own as file.py:class."),
    ] = None,
    dt: Annotated[str | None, typer.Option(help="Steps, s, as in 2e-3,5e-4.")] = None,
    settings: Annotated[str | None, typer.Option(help="Settings, as in defaults,best.")] = None,
    cases: Annotated[str | None, typer.Option(help="Cases, as in rolling_near,wobble.")] = None,
    repeats: Annotated[
        int | None,
        typer.Option(help="Runs of each; the worst counts. Else 1, and 10 where two differ."),
    ] = None,
    time_limit: Annotated[str, typer.Option(help="Longest time of a run.")] = "60 s",
    python: Annotated[str | None, typer.Option(help="A Python that has the engine.")] = None,
    install: Annotated[
        bool, typer.Option("--install", help="Make an environment with the engine first.")
    ] = False,
    checks: Annotated[
        bool, typer.Option(help="Also the checks that need no truth, and 42 falls.")
    ] = True,
    max_error: Annotated[
        str | None, typer.Option(help="Largest angle error that passes, as in 1deg.")
    ] = None,
    max_energy: Annotated[
        str | None, typer.Option(help="Largest energy error that passes, as in 1%.")
    ] = None,
    output: Annotated[str, typer.Option("--output", "-o", help="A folder.")] = "scorecard",
) -> int:
    """Which physics engine gets the can right: a scorecard.

    Without an engine, lists those that have an adapter.
    The folder gets index.html, results.json and a badge.
    Engines that were scored into the same folder stay on the page.
    With --max-error or --max-energy, the exit code is 1 if any case is
    beyond that at the smallest step.

    Examples:

    $ rimroll score mujoco --install

    $ rimroll score mujoco --dt 1e-4 --cases wobble --max-error 1deg

    $ rimroll score my_adapter.py:MyEngine
    """
    if not engine:
        say("engines that have an adapter; name one or more, as in: rimroll score mujoco --install")
        for name, place in registry.engines().items():
            pinned = ", ".join(environments.PINS.get(name, []))
            say(f"  {name:<10} {pinned:<20} {place}")
        return 0
    shown = Bounds(
        math.degrees(quantity(max_error or "1 deg", "rad", "max_error")),
        quantity(max_energy or "1 %", "1", "max_energy"),
    )
    # A bound that is not given does not decide.
    asked = Bounds(
        shown.angle if max_error is not None else math.inf,
        shown.energy if max_energy is not None else math.inf,
    )
    if install and python is not None:
        raise RimrollError("give either --install, which makes a Python, or --python")
    plan = Plan(
        steps=_steps(dt),
        settings=_listed(settings),
        cases=_listed(cases),
        check_step=1e-4 if checks else None,
        repeats=None if repeats is None else _positive(repeats),
        limit=positive("time_limit", time_limit, "s"),
    )
    folder = ensure_folder(output)
    kept = _kept(folder)
    passed = True
    for name in engine:
        result = _scored(name, plan, python, install)
        kept[result.name] = result
        _write(folder, kept, result, shown)
        passed &= _passes(result, asked)
    say(f"The page is {folder / 'index.html'}.")
    return int(not passed and (max_error is not None or max_energy is not None))


def _scored(name: str, plan: Plan, python: str | None, install: bool) -> results.EngineResult:
    command = shlex.join(["rimroll", *sys.argv[1:]])
    try:
        if install:
            if environments.PINS.get(name):
                say(f"installing {name} into {environments.folder(name)}")
            python = environments.installed(name)
        result = scored(name, plan, command, python or sys.executable, _tell)
    except (registry.NoAdapter, Missing, Unknown, environments.NotInstalled) as error:
        raise RimrollError(str(error)) from None
    _tell_checks(result)
    return result


def _tell_checks(result: results.EngineResult) -> None:
    """The checks and the falls."""
    for one in result.checks:
        changed = one.note or ("no turn" if one.angle is None else f"{one.angle:.2g}°")
        say(f"check {one.name:<9} {one.setting:<9} {in_ms(one.dt):>8}  turn changes: {changed}")
    for falls in result.falls:
        fell = sum(one is not None for one in falls.directions)
        say(f"{fell} of {len(falls.directions)} flicks fell, {falls.right_sides} to the true side")


def _tell(run: Run) -> None:
    found = in_words(run) if run.measured else f"{run.status}: {run.message}"
    say(f"{run.case:<15} {run.setting:<9} {in_ms(run.dt):>8}  {found}")


def _kept(folder: Path) -> dict[str, results.EngineResult]:
    """What was scored into the folder before."""
    try:
        return results.load(folder)
    except ValueError as error:
        raise RimrollError(str(error)) from None


def _write(
    folder: Path,
    kept: Mapping[str, results.EngineResult],
    result: results.EngineResult,
    bounds: Bounds,
) -> None:
    """Write all results and the page, and the film and badge of one engine."""
    from rimroll_score import film, page  # which load matplotlib
    from rimroll_score.badge import badge

    results.save(folder, list(kept.values()))
    film.write(folder, result)
    page.write(folder, list(kept.values()), bounds)
    (folder / f"{result.name}.svg").write_text(badge(result, bounds), "utf-8")


def _passes(result: results.EngineResult, bounds: Bounds) -> bool:
    """Whether every case that the engine has is within the bounds at the smallest step."""
    groups = {(run.case, run.setting) for run in result.runs if run.status != "unsupported"}
    return all(
        grade(result.of(case, setting), bounds.angle, bounds.energy) is not None
        for case, setting in groups
    )


def _listed(names: str | None) -> tuple[str, ...]:
    return tuple(name.strip() for name in names.split(",")) if names else ()


def _steps(text: str | None) -> tuple[float, ...]:
    if text is None:
        return STEPS
    steps = tuple(quantity(one.strip(), "s", "dt") for one in text.split(","))
    for step in steps:
        if not 1e-7 <= step <= 0.1:
            raise RimrollError(f"dt must be between 1e-7 and 0.1 s, got {step:g}")
    return steps


def _positive(repeats: int) -> int:
    if repeats < 1:
        raise RimrollError(f"repeats must be at least 1, got {repeats}")
    return repeats
