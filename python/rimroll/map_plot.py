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
from rimroll.ensemble import body_of, law_of
from rimroll.laws import IDEAL
from rimroll.sensitivity import watershed_slope

if TYPE_CHECKING:
    import xarray as xr

FELL = ("toppled", "rocked")
"""Outcomes of which the direction is one of fall, or of the largest tilt."""

NOWHERE = "#9A9A9A"
"""Colour of starts with another outcome."""

YAW, SPIN = "yaw rate at the start (rad/s)", "spin rate at the start (rad/s)"
DIRECTION = "direction of fall (degrees)"


def map_figure(falls: xr.Dataset) -> Figure:
    """A page with one map, as of :func:`rimroll.turn_map`, and its scale of colours."""
    with style.figure_style():
        figure = style.page(86.0, 110.0)
        ax = figure.subplots()
        image = draw_map(ax, falls, span(falls))
        _draw_watershed(ax, falls)
        style.label(ax, "", _title(falls), YAW, SPIN)
        scale_of_directions(figure.colorbar(image, ax=ax, pad=0.03))
        others = set(falls.outcome.values.ravel().tolist()) - set(FELL)
        if others:
            name = ", ".join(sorted(others)).replace("_", " ")
            ax.legend(handles=[Patch(color=NOWHERE, label=name)], loc="lower right", frameon=True)
        return style.settle(figure)


def directions(falls: xr.Dataset) -> NDArray[np.float64]:
    """Directions of fall, degrees; NaN where the body did not rise again."""
    fell = np.isin(falls.outcome.values, FELL)
    return np.where(fell, np.degrees(falls.direction.values), np.nan)


def span(falls: xr.Dataset) -> float:
    """How far a scale of colours has to reach on both sides of 180 degrees; 180: all round."""
    found = directions(falls)
    if np.all(np.isnan(found)):
        return 180.0
    most = float(np.nanmax(np.abs(found - 180.0)))
    return 180.0 if most > 90.0 else max(10.0 * np.ceil(most / 10.0), 10.0)


def colors(reach: float) -> Colormap:
    """Purple to the right of 180 degrees, orange to the left; closed in itself when all round."""
    name = "twilight_shifted" if reach >= 180.0 else "PuOr_r"
    return mpl.colormaps[name].with_extremes(bad=NOWHERE)


def draw_map(ax: Axes, falls: xr.Dataset, reach: float) -> ScalarMappable:
    """Colour the plane of starts by direction, 180 degrees in the middle of the scale."""
    image = ax.pcolormesh(
        falls.yaw_rate.values,
        falls.spin_rate.values,
        np.ma.masked_invalid(directions(falls)),
        cmap=colors(reach),
        norm=Normalize(180.0 - reach, 180.0 + reach),
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
    bar.outline.set_linewidth(0.6)
    bar.ax.tick_params(bottom=False, labelbottom=False)


def _title(falls: xr.Dataset) -> str:
    told: dict[str, Any] = falls.attrs
    numbers = [f"{told[name]:g}" for name in ("law_friction", "law_coefficient") if name in told]
    law = " ".join([str(told["law"]).replace("_", " "), *numbers])
    tilt, rate = np.degrees(told["start_tilt"]), told["start_tilt_rate"]
    return f"{law}, from {tilt:.4g}° at {rate:.4g} rad/s".replace("-", "−")
