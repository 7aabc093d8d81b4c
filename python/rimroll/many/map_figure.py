"""The picture of a map of falls: the direction of fall as colour over yaw rate and spin rate."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import matplotlib as mpl
import numpy as np
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.cm import ScalarMappable
from matplotlib.colorbar import Colorbar
from matplotlib.colors import Colormap, Normalize
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from numpy.typing import NDArray

from rimroll.figures import style
from rimroll.figures.style import powers_into_label
from rimroll.files.recorded import FELL, ending_in_words
from rimroll.many.ensemble import fell, outcomes
from rimroll.many.falls import Falls
from rimroll.many.left_or_right import around, middle_of, side_line

if TYPE_CHECKING:
    import xarray as xr


NOWHERE = "#9A9A9A"
"""Colour of starts with another outcome."""

Array = NDArray[np.float64]
Line = tuple[Array, Array]

LINE_WIDTH = 1.0
"""Width of the line at which the side changes, points."""

FEW = 0.01
"""Fraction of outlying falls below which the colour scale leaves them out."""

SPOT = 1.0
"""Smallest visible area, square points."""

YAW, SPIN = "yaw rate at the start (rad/s)", "spin rate at the start (rad/s)"
DIRECTION = "direction of fall (degrees)"


def map_figure(falls: Falls | xr.Dataset) -> Figure:
    """A page with one map from :func:`rimroll.turn_map` and its colour scale."""
    falls = Falls.of(falls)
    with style.figure_style():
        figure = style.page(86.0, 110.0)
        ax = figure.subplots()
        middle = middle_of_map(falls)
        reach = span(falls, middle)
        image = draw_map(ax, falls, reach, middle)
        line = _draw_line(ax, falls)
        style.label(ax, "", _title(falls), YAW, SPIN)
        below, above = beyond(falls, reach, middle)
        ends = {(False, False): "neither", (True, False): "min", (False, True): "max"}
        extend = ends.get((below > 0.0, above > 0.0), "both")
        scale_of_directions(figure.colorbar(image, ax=ax, pad=0.03, extend=extend), below + above)
        style.settle(figure)
        powers_into_label(ax.xaxis)
        powers_into_label(ax.yaxis)
        _draw_legend(ax, falls, line)
        return figure


def directions(falls: Falls | xr.Dataset, middle: float = 180.0) -> Array:
    """Directions of fall, degrees, round a middle; NaN where the body did not rise again."""
    return np.where(fell(falls), around(middle, np.degrees(falls["direction"])), np.nan)


def middle_of_map(falls: Falls | xr.Dataset) -> float:
    """The direction about which a map's falls lie, 180 or, for disks that come back, 0."""
    found = directions(falls)
    found = found[~np.isnan(found)]
    return middle_of(found) if found.size else 180.0


def span(falls: Falls | xr.Dataset, middle: float = 180.0) -> float:
    """How far a scale of colours has to reach on both sides of its middle; 180: all round.

    To the farthest fall, but not for the sake of a few that are twice as far as the others.
    """
    away = _away(falls, middle)
    if not away.size:
        return 180.0
    ends = np.quantile(away, [1.0, 1.0 - FEW], method="higher")
    most, usual = np.maximum(10.0 * np.ceil(ends / 10.0), 10.0)
    reach = float(usual if most >= 2.0 * usual else most)
    return 180.0 if reach > 90.0 else reach


def beyond(falls: Falls | xr.Dataset, reach: float, middle: float = 180.0) -> tuple[float, float]:
    """The shares of a map's falls that lie below a scale of colours, and above it."""
    found = directions(falls, middle)
    found = found[~np.isnan(found)]
    if not found.size:
        return 0.0, 0.0
    return float(np.mean(found < middle - reach)), float(np.mean(found > middle + reach))


def _away(falls: Falls | xr.Dataset, middle: float) -> Array:
    """How far each fall's direction is from another, degrees."""
    found = directions(falls, middle)
    return np.abs(found[~np.isnan(found)] - middle)


def colors(reach: float, middle: float = 180.0) -> Colormap:
    """Purple to the right of the hand, orange to its left; closed in itself when all round."""
    name = "twilight_shifted" if reach >= 180.0 else "PuOr_r" if middle else "PuOr"
    return mpl.colormaps[name].with_extremes(bad=NOWHERE)


def draw_map(ax: Axes, falls: Falls, reach: float, middle: float = 180.0) -> ScalarMappable:
    """Colour the plane of starts by direction, the scale as far to both sides of its middle."""
    image = ax.pcolormesh(
        falls["yaw_rate"],
        falls["spin_rate"],
        np.ma.masked_invalid(directions(falls, middle)),
        cmap=colors(reach, middle),
        norm=Normalize(middle - reach, middle + reach),
        shading="nearest",
        rasterized=True,
    )
    ax.spines[["top", "right"]].set_visible(True)
    return image


def _draw_line(ax: Axes, falls: Falls) -> Line:
    """The line on which the side changes and the body comes down flat, if it is on the map."""
    xlim, ylim = ax.get_xlim(), ax.get_ylim()
    yaw, spin = side_line(falls, *ylim)
    if not yaw.size or yaw.max() < xlim[0] or yaw.min() > xlim[1]:
        return np.empty(0), np.empty(0)
    ax.plot(yaw, spin, color=style.THEORY, lw=LINE_WIDTH)
    ax.set(xlim=xlim, ylim=ylim)
    return yaw, spin


def _draw_legend(ax: Axes, falls: Falls, line: Line) -> None:
    """Name the line, and other outcomes than falls where they can be seen."""
    handles: list[Artist] = []
    if line[0].size:
        handles.append(Line2D([], [], color=style.THEORY, lw=LINE_WIDTH, label="comes down flat"))
    others = set(outcomes(falls)) - set(FELL)
    if seen := sorted(name for name in others if _seen(ax, falls, name, line)):
        handles.append(Patch(color=NOWHERE, label=", ".join(map(ending_in_words, seen))))
    if handles:
        ax.legend(handles=handles, loc="lower right", frameon=True)


def _seen(ax: Axes, falls: Falls, outcome: str, line: Line) -> bool:
    """Whether the starts of an outcome, without those that the line covers, make a spot."""
    rows, columns = np.nonzero(falls["outcome"] == outcome)
    x, y = _on_paper(ax, falls["yaw_rate"][columns], falls["spin_rate"][rows])
    shown = x.size
    if line[0].size > 1:
        line_x, line_y = _on_paper(ax, *line)
        lean = (line_x[-1] - line_x[0]) / (line_y[-1] - line_y[0])
        off = np.abs(x - np.interp(y, line_y, line_x)) / np.hypot(1.0, lean)
        shown = np.count_nonzero(off > 0.5 * LINE_WIDTH)
    width, height = np.ptp(_on_paper(ax, np.array(ax.get_xlim()), np.array(ax.get_ylim())), axis=1)
    return bool(shown * width * height >= SPOT * falls.size)


def _on_paper(ax: Axes, yaw: Array, spin: Array) -> Array:
    """Where starts lie in a drawn picture, points, shape (2, n)."""
    pixels = ax.transData.transform(np.column_stack([yaw, spin]))
    return np.asarray(72.0 / ax.figure.dpi * pixels.T)


def scale_of_directions(bar: Colorbar, beyond: float = 0.0) -> None:
    """Name the scale of colours, and the share of falls that lie beyond its ends."""
    note = f"\n{100.0 * beyond:.2g} % of the falls lie beyond" if beyond else ""
    bar.set_label(DIRECTION + note)
    bar.ax.yaxis.set_major_formatter(lambda value, _: f"{value % 360.0:g}")
    bar.outline.set_linewidth(0.6)
    bar.ax.tick_params(bottom=False, labelbottom=False)


def _title(falls: Falls) -> str:
    attrs: dict[str, Any] = falls.attrs
    numbers = [f"{attrs[name]:g}" for name in ("law_friction", "law_coefficient") if name in attrs]
    law = " ".join([str(attrs["law"]).replace("_", " "), *numbers])
    tilt, rate = np.degrees(attrs["start_tilt"]), attrs["start_tilt_rate"]
    return f"{law}, from {tilt:.4g}° at {rate:.4g} rad/s".replace("-", "−")
