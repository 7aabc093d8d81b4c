"""A fit as a figure: the predicted histogram over the measured one, and how friction suits it."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator
from numpy.typing import NDArray

from rimroll.directions import around, middle_of
from rimroll.experiment.fitting.likelihood import Likelihood
from rimroll.figures import style
from rimroll.figures.style import directions_in_degrees
from rimroll.laws import Coulomb

if TYPE_CHECKING:
    from rimroll.experiment.fitting.estimate import Estimate
    from rimroll.experiment.fitting.fit import Fit

Array = NDArray[np.float64]

FITTED = Coulomb.color
MAX_SHOWN = 16.0
"""Larger deviances all mean impossible."""


def fit_figure(fit: Fit) -> Figure:
    """Draw (a) directions of fall, counted and predicted, (b) the deviance of each friction.

    No slip and no friction are drawn for the hand and the bias that were found.
    """
    with style.figure_style():
        figure = style.page(62.0)
        falls, friction = figure.subplots(1, 2, width_ratios=(1.5, 1.0))
        _draw_falls(falls, fit)
        _draw_friction(friction, fit)
        return style.settle(figure)


def _draw_falls(ax: Axes, fit: Fit) -> None:
    likelihood = Likelihood(fit.predicted, fit.directions)
    middle = middle_of(np.degrees(fit.directions))
    data = around(middle, np.degrees(fit.directions))
    reach = 10.0 * math.ceil(min(max(float(np.abs(data - middle).max()) + 12.0, 50.0), 180.0) / 10)
    width = 2.0 if len(data) >= 30 else 4.0
    bins = np.arange(middle - reach, middle + reach + width, width)
    ax.hist(data, bins.tolist(), color=style.CONTRAST, alpha=0.45, label="measured")
    angles = np.linspace(middle - reach, middle + reach, 600)
    expected = math.radians(width) * len(data)
    low, high = fit.predicted.frictions[[0, -1]].tolist()
    shown = (
        (replace(fit.best, friction=high), style.NO_SLIP, (0, (5, 2)), "no slip"),
        (replace(fit.best, friction=low), style.FRICTIONLESS, (0, (1, 1.2)), "no friction"),
        (fit.best, FITTED, "-", f"friction {fit.friction.friction:.3f}"),
    )
    for point, color, dashes, name in shown:
        curve = expected * likelihood.density(np.radians(angles), point)
        thick = 1.8 if point is fit.best else 1.0
        ax.plot(angles, curve, color=color, ls=dashes, lw=thick, label=name)
    ax.axvline(middle, color=style.THEORY, lw=0.5, ls=(0, (1, 3)))
    # Falls to the left of the hand are on the left. Angles grow to the left, except for falls back.
    ax.set_xlim(*((angles[-1], angles[0]) if middle else (angles[0], angles[-1])))
    directions_in_degrees(ax.xaxis, reach)
    ax.margins(y=0.12)
    ax.yaxis.set_major_locator(MaxNLocator(6, integer=True))
    for x, side in ((0.01, "left"), (0.99, "right")):
        ax.text(x, 0.98, f"to the {side}", transform=ax.transAxes, ha=side, va="top", fontsize=6.5)
    ax.legend(loc="upper center", ncols=4, bbox_to_anchor=(0.5, -0.2), columnspacing=1.2)
    what = "fall" if fit.predicted.outcome == "toppled" else "largest tilt"
    style.label(
        ax,
        "a",
        f"{len(data)} falls",
        f"direction of {what} (degrees)",
        f"falls (per {width:g}°)",
    )


def _draw_friction(ax: Axes, fit: Fit) -> None:
    one, most = fit.friction, fit.friction.holding_friction
    for low, high in one.intervals:
        ax.axvspan(low, high, color=FITTED, alpha=0.18, lw=0)
    _curve(ax, one, FITTED, "-", "all falls")
    for side, dashes, name in (
        (fit.left, (0, (4, 2)), "left"),
        (fit.right, (0, (1, 1.2)), "right"),
    ):
        if side is not None:
            _curve(ax, side, style.THEORY, dashes, f"{name} alone, no bias")
    ax.axhline(one.limit, color=style.THEORY, lw=0.5)
    ax.annotate(
        f"excluded at {100.0 * fit.confidence:g} % above",
        (most, one.limit),
        xytext=(-2, 2),
        textcoords="offset points",
        ha="right",
        fontsize=6.5,
    )
    ax.set_xlim(0.0, most)
    ax.set_ylim(0.0, MAX_SHOWN)
    ax.legend(loc="upper center", ncols=3, bbox_to_anchor=(0.5, -0.2), columnspacing=1.0)
    title = f"friction {one.friction:.3f}"
    if len(one.intervals) == 1:
        title += f": {one.in_words}"
    style.label(ax, "b", title, "coefficient of friction", "how badly it suits (deviance)")


def _curve(ax: Axes, estimate: Estimate, color: str, dashes: Any, name: str) -> None:
    from scipy.interpolate import PchipInterpolator

    fine = np.linspace(estimate.frictions[0], estimate.frictions[-1], 400)
    fine = np.union1d(fine, estimate.frictions)
    deviance = PchipInterpolator(estimate.frictions, estimate.deviance)(fine)
    thick = 1.8 if dashes == "-" else 1.0
    ax.plot(fine, deviance, color=color, ls=dashes, lw=thick, label=name)
