"""The page's figures: errors against the step, the cost and the contact's run; paths from above."""

from __future__ import annotations

import io
import math
from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from rimroll.figures.style import SERIES, figure_style
from rimroll_score.paths import NEAR, seen_from_above, true_motion
from rimroll_score.results import EngineResult
from rimroll_score.sweep import Run

MIN_ANGLE, MIN_ENERGY = 1e-4, 1e-6
"""Errors below these are drawn there: degrees and fractions."""
MARKERS = "osD^vP*Xph"


def svg(figure: Figure) -> str:
    """A figure as an element of a page."""
    file = io.StringIO()
    figure.savefig(file, format="svg", bbox_inches="tight", metadata={"Date": None})
    text = file.getvalue()
    return text[text.index("<svg") :]


def errors(results: Sequence[EngineResult], setting: str) -> str:
    """Error of the turn and of the energy in ``rolling_near``, against step and against cost."""
    with figure_style():
        figure = Figure(figsize=(7.1, 4.9), layout="constrained")
        axes = figure.subplots(2, 2, sharey="row", sharex="col")
        for number, result in enumerate(results):
            runs = [run for run in result.of(NEAR, _nearest(result, setting)) if run.measured]
            for column, along in enumerate((_step, _cost)):
                for row, error in enumerate((_angle, _energy)):
                    _line(axes[row, column], runs, along, error, number, result.name)
        for column, name in enumerate(("step, ms", "processor time per simulated second, s")):
            axes[1, column].set_xlabel(name)
        axes[0, 0].set_ylabel("error of the turn, degrees")
        axes[1, 0].set_ylabel("error of the energy, %")
        for axis, bound in zip(axes.flat, (1.0, 1.0, 1.0, 1.0), strict=True):
            axis.axhline(bound, color="#8A8A8A", linewidth=0.8, linestyle=":")
        _name_the_lines(axes[0, 1])
        return svg(figure)


def resolution(results: Sequence[EngineResult], setting: str) -> str:
    """Error of the turn of all near-collisions against the run of the contact in a step."""
    from rimroll_score.cases import cases

    rates = {case.name: case.truth["largest_yaw_rate"] for case in cases()}
    with figure_style():
        figure = Figure(figsize=(7.1, 3.0), layout="constrained")
        for axis, way in zip(
            figure.subplots(1, 2, sharey=True), ("rolling", "sliding"), strict=True
        ):
            for number, result in enumerate(results):
                runs = [
                    run
                    for near in ("far", "near", "nearer")
                    for run in result.of(f"{way}_{near}", _nearest(result, setting))
                    if run.measured and math.isfinite(run.error)
                ]
                x = [math.degrees(rates[run.case]) * run.dt for run in runs]
                axis.plot(x, [_angle(run) for run in runs], **_look(number), linestyle="",
                          label=result.name)  # fmt: skip
            axis.set(xscale="log", yscale="log", ylim=(5e-5, 300.0), title=way)
            axis.set_xlabel("run of the contact point in a step, degrees")
            axis.axhline(1.0, color="#8A8A8A", linewidth=0.8, linestyle=":")
        figure.axes[0].set_ylabel("error of the turn, degrees")
        _name_the_lines(figure.axes[1])
        return svg(figure)


def paths(results: Sequence[EngineResult]) -> str:
    """The top of the axis seen from above in ``rolling_near``, truth and engines."""
    from rimroll_score.cases import cases

    (case,) = (case for case in cases() if case.name == NEAR)
    motion = true_motion(case).samples(per_step=8)
    true = -np.sin(motion.tilt)[:, None] * np.column_stack([np.cos(motion.yaw), np.sin(motion.yaw)])
    shown = [(one, setting) for one in results for setting in one.paths if one.name != "rimroll"]
    if not shown:
        return ""
    columns = 4
    rows = math.ceil(len(shown) / columns)
    with figure_style():
        figure = Figure(figsize=(7.1, 1.9 * rows), layout="constrained")
        grid = np.atleast_1d(figure.subplots(rows, columns, squeeze=False)).flat
        for axis, (result, setting) in zip(grid, shown, strict=False):
            found = seen_from_above(np.array(result.paths[setting]))
            axis.plot(*true.T, color="#000000", linewidth=1.6, alpha=0.35)
            axis.plot(*found.T, color=SERIES[5], linewidth=1.0)
            axis.set(xlim=(-0.62, 0.62), ylim=(-0.62, 0.62), aspect="equal")
            axis.set(xticks=[], yticks=[], title=f"{result.name}, {setting}")
        for axis in list(figure.axes)[len(shown) :]:
            axis.set_visible(False)
        return svg(figure)


def _nearest(result: EngineResult, setting: str) -> str:
    """The setting, or the engine's defaults if it has no such."""
    return setting if setting in result.settings else "defaults"


def _name_the_lines(axis: Axes) -> None:
    if axis.get_legend_handles_labels()[0]:
        axis.legend(loc="upper left", bbox_to_anchor=(1.02, 1.0))


def _line(
    axis: Axes,
    runs: Sequence[Run],
    along: Callable[[Run], float],
    error: Callable[[Run], float],
    number: int,
    name: str,
) -> None:
    # Limits first: errors that are all alike would leave none to find.
    axis.set(xscale="log", yscale="log", ylim=(5e-5, 300.0))
    points = [(along(run), error(run)) for run in runs if math.isfinite(error(run))]
    if points:
        axis.plot(*zip(*points, strict=True), **_look(number), linewidth=1.0, label=name)


def _look(number: int) -> dict[str, Any]:
    color = [*SERIES, "#000000", "#8A8A8A"][number % 8]
    return {"color": color, "marker": MARKERS[number % len(MARKERS)], "markersize": 4}


def _step(run: Run) -> float:
    return 1e3 * run.dt


def _cost(run: Run) -> float:
    return run.cost or math.nan


def _angle(run: Run) -> float:
    return max(run.error, MIN_ANGLE)


def _energy(run: Run) -> float:
    return 100.0 * max(run.energy, MIN_ENERGY)
