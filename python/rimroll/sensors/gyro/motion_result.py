"""What the fit of a whole motion found, and its figure."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from rimroll.laws import Law
from rimroll.sensors.fits import Estimate
from rimroll.sensors.gyro.analysis import Analysis
from rimroll.state import State

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure


Array = NDArray[np.float64]


@dataclass(frozen=True)
class LawVerdict:
    """How well a law describes the record.

    ``excess``: its sum of squares less that of the best law, over what the scatter of the residuals
    makes of one (see :attr:`MotionFit.inflation`); ``excluded``: whether this exceeds the chi
    square of one degree of freedom at the confidence level.
    """

    law: Law
    excess: float
    excluded: bool


@dataclass(frozen=True, eq=False, repr=False)
class MotionFit:
    """A motion that was fitted to a record: see :func:`rimroll.fit_motion`.

    Attributes
    ----------
    analysis
        What was read from the record first.
    law
        The law with the numbers that suit best.
    starts, releases
        The state at each release, and its time in the record, s.
    numbers
        The fitted numbers of the law, of the sensor and of each start, by name (``_1``, ``_2``, …
        where there are several releases); ``delay`` is the clock offset: how much later than
        expected the motion begins.
    fitted_of_law
        The names of the law's numbers among them.
    followed
        How many near-collisions after each release were fitted.
    residuals, scatter
        What is left of the rates, (n, 3), and their standard deviations (n, 1), rad/s; at times
        ``t``.
    inflation
        The factor by which the squares of residuals exceed what the sensor explains, times the
        number of residuals that hang together. The variances and the verdicts contain it.
    sides_are_sure
        For each release, whether a turn to the other side is excluded.
    verdicts
        The fitted law and the two ideal ones, compared.
    friction_is_told
        Whether the record limits the friction at all.
    notes
        What to know about it, a sentence each.
    """

    analysis: Analysis
    law: Law
    starts: Sequence[State]
    releases: list[float]
    numbers: dict[str, Estimate]
    fitted_of_law: tuple[str, ...]
    followed: list[int]
    t: Array
    shown: Array
    residuals: Array
    scatter: Array
    inflation: float
    sides_are_sure: list[bool]
    verdicts: list[LawVerdict]
    friction_is_told: bool
    notes: list[str]

    def __repr__(self) -> str:
        left = math.degrees(self.residual)
        return f"<Motion fit: {self.law!r}, residual {left:.2f} degrees/s>"

    @property
    def residual(self) -> float:
        """Root mean square of the residuals, rad/s."""
        return float(np.sqrt(np.mean(self.residuals**2)))

    @property
    def friction(self) -> Estimate | None:
        """The friction; None where the law has none or the record does not tell."""
        return self.numbers.get("friction") if self.friction_is_told else None

    def plot(self) -> Figure:
        """The rates of the record and of the fitted motion, and what is left."""

        return fit_figure(self)

    def to_dict(self) -> dict[str, Any]:
        """Everything that was fitted, as plain numbers in SI units and radians."""
        return {
            "law": repr(self.law),
            "numbers": {
                name: {
                    "value": one.value,
                    "error": one.error,
                    "interval": list(one.interval),
                    "method": one.method,
                }
                for name, one in self.numbers.items()
            },
            "friction_is_told": self.friction_is_told,
            "releases": self.releases,
            "followed": self.followed,
            "sides_are_sure": self.sides_are_sure,
            "residual": self.residual,
            "inflation": self.inflation,
            "verdicts": [
                {"law": repr(one.law), "excess": one.excess, "excluded": one.excluded}
                for one in self.verdicts
            ],
            "notes": self.notes,
        }


COLORS = ("#0072B2", "#D55E00", "#009E73")
"""The colours of the sensor's x, y and z."""
MARKERS = ("o", "s", "^")


def fit_figure(fit: MotionFit) -> Figure:
    """Draw (a) the rates along the sensor's axes with the fitted motion, (b) the residuals."""
    from rimroll.figures import style

    with style.figure_style():
        figure = style.page(100.0)
        grid = figure.add_gridspec(2, 1, height_ratios=(1.6, 1.0))
        above = figure.add_subplot(grid[0, 0])
        below = figure.add_subplot(grid[1, 0], sharex=above)
        _draw_rates(above, fit)
        _draw_residuals(below, fit)
        return style.settle(figure)


def _draw_rates(ax: Axes, fit: MotionFit) -> None:
    from rimroll.figures import style

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
    from rimroll.figures import style

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
