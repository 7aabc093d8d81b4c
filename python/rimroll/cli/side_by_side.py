"""The figure of ``rimroll compare``: one flick on several tables, side by side."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.ticker import MaxNLocator

from rimroll.cli.outcomes import Outcome
from rimroll.errors import RimrollError
from rimroll.figures import style
from rimroll.motion import Array, Moments, Motion
from rimroll.motion.figure import TIME_UNITS, near_collision_window
from rimroll.theory.closed_forms import needed_friction

DASHES: tuple[Any, ...] = ("-", (0, (5, 1.5)), (0, (1, 1)), (0, (5, 1, 1, 1)), (0, (2.5, 1)), "-.")

ROCKINGS = 4  # the largest number that is drawn: more could not be read

OFFERED = "#808080"  # of a line that stands for the lines of all tables

MAX_TABLES = len(style.SERIES)
"""The largest number of tables in one figure; more would be indistinguishable."""


@dataclass(frozen=True)
class Curve:
    """The drawing of one outcome: the whole motion, and its near-collision magnified."""

    name: str
    look: dict[str, Any]
    motion: Motion
    friction: float | None
    whole: Moments
    close: Moments | None
    """At times evenly spaced about the smallest tilt; None where that is no brief event."""
    at: float
    """The time of the smallest tilt, s."""


def side_by_side(outcomes: list[Outcome]) -> Figure:
    """Tilt, yaw, slip and |T|/N over time, the near-collision magnified, the contact's path.

    Angles in degrees, slip in cm/s, paths in cm; at most four rockings. The magnified times count
    from each motion's own smallest tilt. Thin lines of the same colour are the friction that a
    table has to offer, the dashed one is μ*, which rolling through needs; a legend below says so.
    Raises ``RimrollError`` for more tables than there are colours.
    """
    if len(outcomes) > MAX_TABLES:
        raise RimrollError(f"a figure shows at most {MAX_TABLES} tables, got {len(outcomes)}")
    until = max(_until(one.motion) for one in outcomes)
    curves, half = _curves(outcomes, until)
    with style.figure_style():
        figure = style.page(152.0 + 15.0 * max(0, len(curves) - 4))
        spans: list[float | None] = [None]
        if any(curve.close for curve in curves):
            unit, second = next((u for u in TIME_UNITS if half >= u[1]), TIME_UNITS[-1])
            spans.append(second)
        widths = (1.25, 1.0, 1.05) if len(spans) == 2 else (2.25, 1.05)
        grid = figure.add_gridspec(4, len(widths), width_ratios=widths)
        places = grid[:, :-1].subgridspec(4, len(spans), width_ratios=widths[:-1])
        panels = places.subplots(squeeze=False)
        letters = iter("abcdefgh")
        for row, draw in zip(panels, (_tilt, _yaw, _slip, _ratio), strict=True):
            for ax, span in zip(row, spans, strict=True):
                draw(ax, next(letters), curves, span)
                ax.set_xlim(*((0.0, until) if span is None else (-half / span, half / span)))
                ax.xaxis.set_major_locator(MaxNLocator(5))
                ax.tick_params(labelbottom=draw is _ratio)
        panels[-1, 0].set_xlabel("time $t$ (s)")
        if len(spans) == 2:
            panels[-1, 1].set_xlabel(f"time from the smallest tilt ({unit})")
        _paths(grid[:, -1], "ijklmn" if len(spans) == 2 else "efghij", curves)
        handles = panels[0, 0].get_lines()[: len(curves)]
        figure.legend(
            handles, [_legend(c) for c in curves], loc="outside upper left", ncols=len(curves)
        )
        figure.legend(handles=_bounds(curves), loc="outside lower left", ncols=2)
        style.settle(figure)
    return figure


def _bounds(curves: list[Curve]) -> list[Line2D]:
    """Legend entries for the straight lines in the panels of |T|/N."""
    needed = needed_friction(curves[0].motion.body)
    label = f"$μ^*$ = {needed:.3g}, which rolling through the near-collision needs"
    lines = [Line2D([], [], color=style.THEORY, lw=0.6, ls="--", label=label)]
    if any(curve.friction for curve in curves):
        lines.append(Line2D([], [], color=OFFERED, lw=0.5, label="$μ$ of each table"))
    return lines


def _legend(curve: Curve) -> str:
    name = _named(curve)
    return f"{name}, $μ$ = {curve.friction:g}" if curve.friction and name == curve.name else name


def _named(curve: Curve) -> str:
    """The name of a table, or its friction if that is its name."""
    return f"$μ$ = {curve.friction:g}" if curve.name[-1:].isdigit() else curve.name


def _until(motion: Motion) -> float:
    """Until when a motion is worth drawing, s."""
    turns = motion.turns
    return turns[ROCKINGS - 1].end if len(turns) >= ROCKINGS else float(motion.t[-1]) or 1.0


def _curves(outcomes: list[Outcome], until: float) -> tuple[list[Curve], float]:
    """The drawings, and half the time span of the magnified part, s."""
    windows = [near_collision_window(one.motion) for one in outcomes]
    half = max((window.half_width for window in windows if window is not None), default=1e-3)
    curves = []
    for i, (one, window) in enumerate(zip(outcomes, windows, strict=True)):
        motion = one.motion
        close, at = None, 0.0
        if window is not None:
            at = window.t
            times = at + half * np.sinh(np.linspace(-4.0, 4.0, 801)) / np.sinh(4.0)
            close = motion.evaluate(times[(times >= 0.0) & (times <= motion.t[-1])])
        look = {"color": style.SERIES[i], "ls": DASHES[i]}
        samples = motion.samples(4).t
        whole = motion.evaluate(samples[samples <= until])
        curves.append(Curve(one.name, look, motion, one.friction, whole, close, at))
    return curves, half


def _plot(ax: Axes, curves: list[Curve], second: float | None, values: Any) -> None:
    """A quantity over the whole time, or under the lens in units of ``second``."""
    for curve in curves:
        if second is None:
            ax.plot(curve.whole.t, values(curve.whole), **curve.look)
        elif curve.close is not None:
            ax.plot((curve.close.t - curve.at) / second, values(curve.close), **curve.look)


def _tilt(ax: Axes, letter: str, curves: list[Curve], second: float | None = None) -> None:
    highest = max((curve.close.tilt.max() for curve in curves if curve.close), default=1.0)
    power = 3 * int(np.floor(np.log10(np.degrees(highest)) / 3.0 + 0.2)) if second else 0
    _plot(ax, curves, second, lambda moments: np.degrees(moments.tilt) / 10.0**power)
    unit = f"10{style.superscript(power)} °" if power else "°"
    _name(ax, letter, "tilt", second, f"$φ$ ({unit})")


def _yaw(ax: Axes, letter: str, curves: list[Curve], second: float | None = None) -> None:
    _plot(ax, curves, second, lambda moments: np.degrees(moments.yaw))
    _name(ax, letter, "yaw", second, "$ψ$ (°)")


def _slip(ax: Axes, letter: str, curves: list[Curve], second: float | None = None) -> None:
    _plot(ax, curves, second, lambda moments: 100.0 * np.hypot(*moments.slip.T))
    _name(ax, letter, "slip", second, "|$u$| (cm/s)")


def _ratio(ax: Axes, letter: str, curves: list[Curve], second: float | None = None) -> None:
    needed = needed_friction(curves[0].motion.body)
    ax.axhline(needed, color=style.THEORY, lw=0.6, ls="--")
    x, side = (0.01, "left") if second is None else (0.99, "right")
    place = ax.get_yaxis_transform()
    ax.text(x, needed, "$μ^*$", transform=place, ha=side, va="bottom", size=6.0)
    for curve in curves:
        if curve.friction:
            ax.axhline(curve.friction, color=curve.look["color"], lw=0.5)
    _plot(ax, curves, second, _finite_ratio)
    _name(ax, letter, "friction/normal", second, "|$T$|/$N$ (1)")
    top = max([curve.friction or 0.0 for curve in curves] + [1.1 * needed])
    ax.set_ylim(-0.04 * top, 1.1 * top)


def _finite_ratio(moments: Moments) -> Array:
    ratio = moments.friction_ratio
    return np.where(np.isfinite(ratio), ratio, np.nan)


def _name(ax: Axes, letter: str, title: str, second: float | None, y: str) -> None:
    style.label(ax, letter, title if second is None else f"{title}, magnified", "", y)
    ax.ticklabel_format(axis="y", style="plain", useOffset=False)


def _paths(place: Any, letters: str, curves: list[Curve]) -> None:
    """The contact's paths seen from above, to one scale."""
    axes = place.subgridspec(len(curves), 1).subplots(squeeze=False)[:, 0]
    size = 0.0
    for ax, letter, curve in zip(axes, letters, curves, strict=False):
        points = 100.0 * curve.whole.contact_path
        points = points - 0.5 * (points.min(axis=0) + points.max(axis=0))
        size = max(size, 1.08 * float(np.abs(points).max()))
        ax.plot(*points.T, color=curve.look["color"], lw=0.8)
        ax.plot(*points[0], "o", color=style.THEORY, mfc="white", ms=3.6)
        style.label(ax, letter, f"path, {_named(curve)}", "", "$y$ (cm)")
    axes[-1].set_xlabel("$x$ (cm)")
    for ax in axes:
        ax.set(aspect="equal", xlim=(-size, size), ylim=(-size, size))
        ax.tick_params(labelbottom=ax is axes[-1])
        for axis in (ax.xaxis, ax.yaxis):
            axis.set_major_locator(MaxNLocator(4, integer=True))
