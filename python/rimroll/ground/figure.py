"""The figure of a ground: its components over time, and its spectra."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from matplotlib.figure import Figure
from matplotlib.ticker import NullLocator

from rimroll.figures import style

if TYPE_CHECKING:
    from rimroll.ground.ground import Ground

PERIODS = np.geomspace(0.05, 5.0, 80)
"""The periods of the spectra, s."""

MARKED = (0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0)
"""The periods that are marked."""

AXES = tuple(zip("xyz", style.SERIES[:3], ("-", "--", "-."), strict=True))


def ground_figure(ground: Ground) -> Figure:
    """Acceleration, velocity and displacement of each component over time, and pseudo-spectra."""
    lines = ground._lines
    spectrum = ground.response_spectrum(PERIODS)["pseudo_acceleration"]
    with style.figure_style():
        figure = style.page(110.0)
        panels = figure.subplot_mosaic([["a", "d"], ["b", "d"], ["c", "d"]], width_ratios=[2, 1])
        for letter, name, symbol, values in (
            ("a", "acceleration", "$a$ (m/s²)", lines.acceleration),
            ("b", "velocity", "$v$ (m/s)", lines.velocity),
            ("c", "displacement", "$d$ (m)", lines.displacement),
        ):
            ax = panels[letter]
            for column, (axis, color, dashes) in enumerate(AXES):
                if lines.acceleration[:, column].any():
                    ax.plot(lines.t, values[:, column], dashes, color=color, label=axis, lw=0.8)
            ax.set_xlim(0.0, ground.duration)
            style.label(ax, letter, name, "time $t$ (s)" if letter == "c" else "", symbol)
        ax = panels["d"]
        for column, (axis, color, dashes) in enumerate(AXES):
            if lines.acceleration[:, column].any():
                ax.plot(PERIODS, spectrum[:, column], dashes, color=color, label=axis)
        ax.set_xscale("log")
        ax.set_xlim(PERIODS[0], PERIODS[-1])
        ax.set_ylim(bottom=0.0)
        ax.set_xticks(MARKED, labels=[f"{period:g}" for period in MARKED])
        ax.xaxis.set_minor_locator(NullLocator())
        style.label(
            ax, "d", "response at 5 % damping", "period $T$ (s)", "pseudo-acceleration (m/s²)"
        )
        ax.legend()
    return figure
