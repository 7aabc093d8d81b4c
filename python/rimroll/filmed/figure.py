"""The figure of a fit to a film."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from rimroll.figures import style

if TYPE_CHECKING:
    from rimroll.filmed.result import TrackFit


def track_figure(fit: TrackFit) -> Figure:
    """Draw (a) the film and the fitted motion in the plane, (b) over the time."""
    with style.figure_style():
        figure = style.page(70.0)
        grid = figure.add_gridspec(1, 2, width_ratios=(1.0, 1.5))
        _draw_plane(figure.add_subplot(grid[0, 0]), fit)
        _draw_times(figure.add_subplot(grid[0, 1]), fit)
        return style.settle(figure)


def _units(fit: TrackFit) -> tuple[float, str]:
    return (1e3, "mm") if fit.track.kind == "path" else (float(np.degrees(1.0)), "degrees")


def _draw_plane(ax: Axes, fit: TrackFit) -> None:
    factor, unit = _units(fit)
    seen = factor * fit.track.plane()
    ax.plot(seen.real, seen.imag, "o", ms=2.0, mfc="white", mew=0.6, color="#D55E00", label="film")
    shown = factor * fit.shown
    if fit.track.kind == "tilt":
        shown = np.abs(shown) + 0j
    ax.plot(shown.real, shown.imag, color="#0072B2", lw=0.9, label="fitted motion")
    ax.set_aspect("equal", adjustable="datalim")
    ax.legend()
    title = "marker from above" if fit.track.kind == "path" else "tilt along its direction"
    style.label(ax, "a", title, f"x ({unit})", f"y ({unit})")


def _draw_times(ax: Axes, fit: TrackFit) -> None:
    factor, unit = _units(fit)
    seen = fit.track.plane()
    for part, marker in ((np.real, "o"), (np.imag, "s")):
        ax.plot(
            fit.track.t, factor * part(seen), marker, ms=2.0, mfc="white", mew=0.6, color="#D55E00"
        )
        shown = np.abs(fit.shown) + 0j if fit.track.kind == "tilt" else fit.shown
        ax.plot(fit.t, factor * part(shown), color="#0072B2", lw=0.9)
    style.label(ax, "b", "x (circles) and y (squares)", "time (s)", unit)
