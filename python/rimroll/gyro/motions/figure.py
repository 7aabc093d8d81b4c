"""A fitted motion as a figure: the rates of the record and of the motion, and what is left."""

from __future__ import annotations

from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from rimroll.figures import style

if TYPE_CHECKING:
    from rimroll.gyro.motions.result import MotionFit

COLORS = ("#0072B2", "#D55E00", "#009E73")
"""The colours of the sensor's x, y and z."""
MARKERS = ("o", "s", "^")


def fit_figure(fit: MotionFit) -> Figure:
    """Draw (a) the rates along the sensor's axes with the fitted motion, (b) the residuals."""
    with style.figure_style():
        figure = style.page(100.0)
        grid = figure.add_gridspec(2, 1, height_ratios=(1.6, 1.0))
        above = figure.add_subplot(grid[0, 0])
        below = figure.add_subplot(grid[1, 0], sharex=above)
        _draw_rates(above, fit)
        _draw_residuals(below, fit)
        return style.settle(figure)


def _draw_rates(ax: Axes, fit: MotionFit) -> None:
    measured = fit.shown + fit.residuals
    for i, (color, marker) in enumerate(zip(COLORS, MARKERS, strict=True)):
        ax.plot(
            fit.t, measured[:, i], marker, ms=2.0, color=color, mfc="white", mew=0.6,
            label=f"sensor's {'xyz'[i]}",
        )  # fmt: skip
    for part in _parts(fit):
        for i, color in enumerate(COLORS):
            ax.plot(fit.t[part], fit.shown[part, i], color=color, lw=0.9)
    ax.legend(loc="upper left", ncols=3)
    kind = "simulated record" if fit.analysis.record.simulated else "record"
    style.label(ax, "a", f"{kind} (marks) and fitted motion (lines)", "", "rate (rad/s)")


def _draw_residuals(ax: Axes, fit: MotionFit) -> None:
    degrees = np.degrees(fit.residuals)
    for i, (color, marker) in enumerate(zip(COLORS, MARKERS, strict=True)):
        ax.plot(fit.t, degrees[:, i], marker, ms=2.0, color=color, mfc="white", mew=0.6)
    for sign in (-1.0, 1.0):
        expected = sign * np.degrees(fit.scatter[:, 0])
        for part in _parts(fit):
            ax.plot(fit.t[part], expected[part], color=style.CONTRAST, lw=0.7)
    ax.axhline(0.0, color=style.THEORY, lw=0.5)
    title = "record less motion; grey: what the sensor's errors explain"
    style.label(ax, "b", title, "time (s)", "residual (degrees/s)")


def _parts(fit: MotionFit) -> list[slice]:
    """Samples between collisions and between releases."""
    steps = np.diff(fit.t)
    edges = [0, *(np.flatnonzero(steps > 2.5 * np.median(steps)) + 1), len(fit.t)]
    return [slice(int(a), int(b)) for a, b in pairwise(edges)]
