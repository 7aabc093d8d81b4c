"""The figure of a body on a table that moves: ground, tilt and footprint."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np
from matplotlib.figure import Figure
from numpy.typing import ArrayLike

from rimroll.figures import style
from rimroll.motion.shaken import footprint_of
from rimroll.plot import shade_phases
from rimroll.theory import balance_tilt

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from rimroll.ground.ground import Ground
    from rimroll.motion.moments import Array, Moments
    from rimroll.motion.motion import Motion

AXES = tuple(zip("xyz", style.SERIES[:3], ("-", "--", "-."), strict=True))

MARKS = {
    "uplift": ("^", "uplift"),
    "stand": ("s", "stands again"),
    "face_down": ("v", "comes down flat"),
    "lift_off": ("d", "lifts off"),
    "topple": ("X", "topples"),
}
"""The events that are marked: their markers and words."""

UPRIGHT = 1.5
"""Balance tilts up to which the panel of the tilt reaches for a body that overturns."""


def shaken_figure(motion: Motion) -> Figure:
    """Draw the acceleration of the ground, the tilt, the heading of the body and its footprint.

    Time runs along four of the panels, in s. The tilt is in degrees, and over the balance tilt on
    a second scale, which ends at 1.5 if the body overturns. Events are marked on the tilt, and the
    rim slides where its panel is shaded, flies where it is hatched. The footprint's centre moves
    on the table from the full circle at the start to the dashed one at the end.
    """
    assert motion.ground is not None
    moments = motion.samples(4)
    path = footprint_of(moments, motion.body)
    end = float(motion.t[-1]) or 1.0
    color = motion.law.color
    with style.figure_style():
        figure = style.page(120.0)
        panels = figure.subplot_mosaic(
            [["a", "d"], ["b", "d"], ["c", "e"]], width_ratios=[1.6, 1], height_ratios=[1, 1.5, 0.9]
        )
        _draw_ground(panels["a"], motion.ground, end)
        _draw_tilt(panels["b"], motion, moments)
        panels["c"].plot(moments.t, np.degrees(moments.body_yaw), color=color)
        style.label(panels["c"], "c", "heading of the body", "time $t$ (s)", "$ψ$ + $θ$ (°)")
        _draw_footprint(panels["d"], motion, path)
        for column, (axis, tone, dashes) in enumerate(AXES[:2]):
            panels["e"].plot(moments.t, path[:, column], dashes, color=tone, label=axis, lw=0.9)
        style.label(panels["e"], "e", "centre of the footprint", "time $t$ (s)", "$x$, $y$ (m)")
        panels["e"].legend(loc="best", ncols=2)
        for letter in "abce":
            panels[letter].set_xlim(0.0, end)
    return figure


def _draw_ground(ax: Axes, ground: Ground, end: float) -> None:
    lines = ground._lines
    for column, (axis, color, dashes) in enumerate(AXES):
        if lines.acceleration[:, column].any():
            t = np.concatenate([lines.t, [lines.t[-1], max(end, lines.t[-1])]])
            values = np.concatenate([lines.acceleration[:, column], [0.0, 0.0]])
            ax.plot(t, values, dashes, color=color, label=axis, lw=0.8)
    style.label(ax, "a", "acceleration of the ground", "", "$a$ (m/s²)")
    if ax.get_legend_handles_labels()[0]:
        ax.legend(loc="upper right", ncols=3)


def _draw_tilt(ax: Axes, motion: Motion, moments: Moments) -> None:
    balance = math.degrees(float(balance_tilt(motion.body)))
    top = balance * _highest_ratio(motion)
    ax.plot(moments.t, np.degrees(moments.tilt), color=motion.law.color, lw=0.9)
    ax.axhline(balance, color=style.THEORY, ls="--", lw=0.7)
    ax.set_ylim(-0.06 * top, top)
    for kind, (marker, words) in MARKS.items():
        found = [event for event in motion.events if event.kind == kind]
        if found:
            tilts = [min(math.degrees(event.state.tilt), 0.97 * top) for event in found]
            times = [event.t for event in found]
            face = "none" if kind == "uplift" else "white"
            ax.plot(
                times,
                tilts,
                marker,
                color=style.THEORY,
                mfc=face,
                label=words,
                zorder=3,
                clip_on=False,
            )
    shade_phases(ax, motion)
    slides = any(phase.kind.startswith("sliding") for phase in motion.phases)
    style.label(ax, "b", "tilt" + (", sliding shaded" if slides else ""), "", "$φ$ (°)")

    def over_balance(tilt: ArrayLike) -> ArrayLike:
        return np.asarray(tilt) / balance

    def in_degrees(ratio: ArrayLike) -> ArrayLike:
        return np.asarray(ratio) * balance

    second = ax.secondary_yaxis("right", functions=(over_balance, in_degrees))
    second.set_ylabel("over the balance tilt (1)")
    second.spines["right"].set_visible(True)
    if ax.get_legend_handles_labels()[0]:
        ax.legend(loc="upper left", ncols=3, handlelength=1.0, columnspacing=1.2)


def _highest_ratio(motion: Motion) -> float:
    """The top of the tilt's panel over the balance tilt, with room for the legend."""
    largest = motion.max_tilt_ratio
    if motion.overturned:
        return UPRIGHT
    return 1.3 * largest if 1e-6 < largest < 0.5 else max(1.3, 1.3 * largest)


def _draw_footprint(ax: Axes, motion: Motion, path: Array) -> None:
    around = np.linspace(0.0, 2.0 * np.pi, 181)
    rim = motion.body.radius * np.stack([np.cos(around), np.sin(around)], axis=-1)
    color = motion.law.color
    last = "when it overturned" if motion.overturned else "at the end"
    for place, dashes, words in ((path[0], "-", "at the start"), (path[-1], "--", last)):
        ax.plot(*(place + rim).T, dashes, color=style.CONTRAST, lw=0.8, label=words)
    ax.plot(*path.T, color=color, lw=0.9, label="path of its centre")
    ax.plot(*path[0], "o", color=color)
    ax.plot(*path[-1], "X" if motion.overturned else "s", color=color, mfc="white")
    middle = 0.5 * (path.min(axis=0) + path.max(axis=0))
    half = 1.12 * (0.5 * float(np.ptp(path, axis=0).max()) + motion.body.radius)
    ax.set_xlim(middle[0] - half, middle[0] + half)
    ax.set_ylim(middle[1] - half, middle[1] + 1.25 * half)
    ax.set_aspect("equal", adjustable="box")
    style.label(ax, "d", "footprint", "$x$ (m)", "$y$ (m)")
    ax.legend(loc="upper left", ncols=1, labelspacing=0.2)
