"""The picture of a map of falls: the direction of fall as colour over yaw rate and spin rate."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import matplotlib as mpl
import numpy as np
from matplotlib.axes import Axes
from matplotlib.cm import ScalarMappable
from matplotlib.colorbar import Colorbar
from matplotlib.colors import Colormap, Normalize
from matplotlib.figure import Figure
from matplotlib.patches import Patch
from numpy.typing import NDArray

from rimroll import style
from rimroll.directions import around, middle_of
from rimroll.ensemble import FELL, body_of, fell, law_of, outcomes
from rimroll.laws import IDEAL
from rimroll.sensitivity import watershed_slope

if TYPE_CHECKING:
    import xarray as xr

NOWHERE = "#9A9A9A"
"""Colour of starts with another outcome."""

YAW, SPIN = "yaw rate at the start (rad/s)", "spin rate at the start (rad/s)"
DIRECTION = "direction of fall (degrees)"


def map_figure(falls: xr.Dataset) -> Figure:
    """A page with one map, as of :func:`rimroll.turn_map`, and its scale of colours."""
    with style.figure_style():
        figure = style.page(86.0, 110.0)
        ax = figure.subplots()
        middle = middle_of_map(falls)
        image = draw_map(ax, falls, span(falls, middle), middle)
        _draw_watershed(ax, falls)
        style.label(ax, "", _title(falls), YAW, SPIN)
        scale_of_directions(figure.colorbar(image, ax=ax, pad=0.03))
        others = set(outcomes(falls)) - set(FELL)
        if others:
            name = ", ".join(sorted(others)).replace("_", " ")
            ax.legend(handles=[Patch(color=NOWHERE, label=name)], loc="lower right", frameon=True)
        return style.settle(figure)


def directions(falls: xr.Dataset, middle: float = 180.0) -> NDArray[np.float64]:
    """Directions of fall, degrees, round a middle; NaN where the body did not rise again."""
    return np.where(fell(falls), around(middle, np.degrees(falls.direction.values)), np.nan)


def middle_of_map(falls: xr.Dataset) -> float:
    """The direction about which a map's falls lie, 180 or, for disks that come back, 0."""
    found = directions(falls)
    found = found[~np.isnan(found)]
    return middle_of(found) if found.size else 180.0


def span(falls: xr.Dataset, middle: float = 180.0) -> float:
    """How far a scale of colours has to reach on both sides of its middle; 180: all round."""
    found = directions(falls, middle)
    if np.all(np.isnan(found)):
        return 180.0
    most = float(np.nanmax(np.abs(found - middle)))
    return 180.0 if most > 90.0 else max(10.0 * np.ceil(most / 10.0), 10.0)


def colors(reach: float, middle: float = 180.0) -> Colormap:
    """Purple to the right of the hand, orange to its left; closed in itself when all round."""
    name = "twilight_shifted" if reach >= 180.0 else "PuOr_r" if middle else "PuOr"
    return mpl.colormaps[name].with_extremes(bad=NOWHERE)


def draw_map(ax: Axes, falls: xr.Dataset, reach: float, middle: float = 180.0) -> ScalarMappable:
    """Colour the plane of starts by direction, the scale as far to both sides of its middle."""
    image = ax.pcolormesh(
        falls.yaw_rate.values,
        falls.spin_rate.values,
        np.ma.masked_invalid(directions(falls, middle)),
        cmap=colors(reach, middle),
        norm=Normalize(middle - reach, middle + reach),
        shading="nearest",
        rasterized=True,
    )
    ax.spines[["top", "right"]].set_visible(True)
    return image


def _draw_watershed(ax: Axes, falls: xr.Dataset) -> None:
    """The line on which the body comes down flat, where theory has it."""
    law = law_of(falls)
    if law in IDEAL:
        slope = watershed_slope(body_of(falls), falls.attrs["start_tilt"], law)
        within = {"x": ax.get_xlim(), "y": ax.get_ylim()}
        spin = np.array(within["y"])
        ax.plot(slope * spin, spin, color=style.THEORY, lw=1.0)
        ax.set(xlim=within["x"], ylim=within["y"])


def scale_of_directions(bar: Colorbar) -> None:
    """Name the scale of colours."""
    bar.set_label(DIRECTION)
    bar.ax.yaxis.set_major_formatter(lambda value, _: f"{value % 360.0:g}")
    bar.outline.set_linewidth(0.6)
    bar.ax.tick_params(bottom=False, labelbottom=False)


def _title(falls: xr.Dataset) -> str:
    told: dict[str, Any] = falls.attrs
    numbers = [f"{told[name]:g}" for name in ("law_friction", "law_coefficient") if name in told]
    law = " ".join([str(told["law"]).replace("_", " "), *numbers])
    tilt, rate = np.degrees(told["start_tilt"]), told["start_tilt_rate"]
    return f"{law}, from {tilt:.4g}° at {rate:.4g} rad/s".replace("-", "−")
