"""The figures of a motion: the paper's nine panels, and those of a body on a table that moves."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator, SymmetricalLogLocator
from numpy.typing import ArrayLike

from rimroll.figures import style
from rimroll.laws import NoSlip, has_one_limit
from rimroll.motion.moments import footprint_of
from rimroll.theory.closed_forms import balance_tilt, needed_friction, turn_limit

if TYPE_CHECKING:
    from rimroll.ground.ground import Ground
    from rimroll.motion.moments import Array, Moments
    from rimroll.motion.trajectory import Trajectory


TIME_UNITS = (("s", 1.0), ("ms", 1e-3), ("µs", 1e-6), ("ns", 1e-9), ("ps", 1e-12), ("fs", 1e-15))

MAGNIFIED = 20.0  # the inset shows this many φ_c/ω before and after the smallest tilt
LENS = (0.34, 0.31)  # its width and height in parts of the panel
BRIEF = 0.05  # part of the motion below which the near-collision looks like a step
DECADES = 30.0  # a curve whose peak passes its usual size this many times gets a logarithmic axis

ROUNDING = 1e-9  # rad/s or N: a curve that stays below is zero


@dataclass(frozen=True)
class NearCollisionWindow:
    """A stretch of time around the smallest tilt, s, and the yaw there, rad."""

    t: float
    half_width: float
    yaw: float


def near_collision_window(motion: Trajectory) -> NearCollisionWindow | None:
    """The first near-collision, ±20 φ_c/ω; None if none is too brief to be seen without a lens."""
    for event in motion.events:
        rate = abs(float(event.state.yaw_rate))
        if event.kind != "tilt_min" or rate == 0.0:
            continue
        # ψ̇ = √(J'/K') ω/φ_c at the smallest tilt; under friction, nearly.
        ideal = motion.law if has_one_limit(motion.law) else NoSlip()
        half = MAGNIFIED * turn_limit(motion.body, ideal) / (np.pi * rate)
        resolved = half > 1e4 * np.spacing(event.t)
        if resolved and 2.0 * half < BRIEF * float(motion.t[-1]):
            return NearCollisionWindow(event.t, half, float(event.state.yaw))
    return None


def nine_panels(motion: Trajectory) -> Figure:
    """Draw tilt, yaw, spin, their rates, the forces, their ratio, and yaw rate against spin rate.

    Time runs along eight of the panels, in s; angles are in rad, forces in N. A lens in the yaw's
    panel magnifies the first near-collision if it is too brief to be seen. Dashed lines are
    theory: the limiting angle of turn of the ideal laws, the friction μ* = mHR/(A + mH²) needed to
    roll through, and spin opposite to yaw. Under friction, dotted lines are what there is of it,
    and the rim slides where the panels of the forces are shaded, flies where they are hatched.
    Source: the paper's figure ``purerollnumresults``.
    """
    moments = motion.samples(4)
    with style.figure_style():
        figure = style.page(150.0)
        panels = figure.subplots(3, 3)
        color = motion.law.color
        _draw_angles(panels[0], moments, color)
        _magnify(panels[0, 1], motion, color)
        _draw_rates(panels[1], motion, moments, color)
        _draw_forces(panels[2, 0], motion, moments, color)
        _draw_ratio(panels[2, 1], motion, moments, color)
        _draw_rate_plane(panels[2, 2], moments, color)
        for ax in panels.flat[:-1]:
            ax.set_xlim(0.0, float(motion.t[-1]) or 1.0)
        for ax in panels[2, :2]:
            shade_phases(ax, motion)
    return figure


def _draw_angles(row: Array, moments: Moments, color: str) -> None:
    for ax, letter, name, symbol, values in (
        (row[0], "a", "tilt", "φ", moments.tilt),
        (row[1], "b", "yaw", "ψ", moments.yaw),
        (row[2], "c", "spin", "θ", moments.spin),
    ):
        ax.plot(moments.t, values, color=color)
        style.label(ax, letter, name, "time $t$ (s)", f"${symbol}$ (rad)")


def _draw_rates(row: Array, motion: Trajectory, moments: Moments, color: str) -> None:
    usual = _evenly(motion)
    for ax, letter, name, symbol, column in (
        (row[0], "d", "tilt rate", "φ", "tilt_rate"),
        (row[1], "e", "yaw rate", "ψ", "yaw_rate"),
        (row[2], "f", "spin rate", "θ", "spin_rate"),
    ):
        ax.plot(moments.t, moments[column], color=color)
        style.label(ax, letter, name, "time $t$ (s)", f"d${symbol}$/d$t$ (rad/s)")
        _stretch(ax, moments[column], usual[column])


def _draw_forces(ax: Axes, motion: Trajectory, moments: Moments, color: str) -> None:
    friction = np.hypot(*moments.friction_force.T)
    ax.plot(moments.t, moments.normal_force, color=style.NORMAL_FORCE, lw=0.8, label="normal, $N$")
    ax.plot(moments.t, friction, color=color, label="friction, |$T$|")
    title = "forces on the rim" + (", sliding shaded" if len(motion.phases) > 1 else "")
    style.label(ax, "g", title, "time $t$ (s)", "force (N)")
    _stretch(ax, moments.normal_force, 0.1 * _evenly(motion).normal_force)
    _headroom(ax)
    ax.legend(loc="upper center", ncols=2, handlelength=1.4, columnspacing=1.2)


def shade_phases(ax: Axes, motion: Trajectory) -> None:
    """Colour the stretches of a motion with stick and slip in which the rim slides, or flies."""
    if len(motion.phases) < 2:
        return
    for phase in motion.phases:
        if phase.kind in ("sliding", "sliding_flat"):
            ax.axvspan(phase.start, phase.end, color=style.SLIDING, alpha=0.25, lw=0, zorder=0)
        elif phase.kind in ("flying", "flying_level"):
            ax.axvspan(phase.start, phase.end, fc="none", ec="#CCCCCC", hatch="////", lw=0)


def _draw_ratio(ax: Axes, motion: Trajectory, moments: Moments, color: str) -> None:
    needed = needed_friction(motion.body)
    ax.axhline(needed, color=style.THEORY, ls="--", lw=0.8, label=f"$μ^*$ = {needed:.4f}")
    there_is = _friction_there_is(motion)
    for symbol, friction in there_is.items():
        ax.axhline(friction, color=style.THEORY, ls=":", lw=1.0, label=f"{symbol} = {friction:g}")
    ratio = np.where(np.isfinite(moments.friction_ratio), moments.friction_ratio, np.nan)
    ax.plot(moments.t, ratio, color=color)
    style.label(ax, "h", "friction/normal", "time $t$ (s)", "|$T$|/$N$ (1)")
    usual = np.nanmax(ratio, initial=0.0)
    highest = max(needed, *there_is.values(), min(float(usual), 10.0 * needed + 1.0), 1e-3)
    lines = 1 + len(there_is) // 2
    ax.set_ylim(-0.04 * highest, (1.1 + 0.15 * lines) * highest)
    ax.legend(loc="upper right", ncols=2, columnspacing=1.2, handlelength=1.5)


def _friction_there_is(motion: Trajectory) -> dict[str, float]:
    """The parameters ``friction`` and ``static`` of a law that has the first, by their symbols."""
    friction = getattr(motion.law, "friction", None)
    static = getattr(motion.law, "static", None)
    if friction is None:
        return {}
    return {"$μ$": friction} if static in (None, friction) else {"$μ$": friction, "$μ_s$": static}


def _draw_rate_plane(ax: Axes, moments: Moments, color: str) -> None:
    power = _power(np.append(moments.spin_rate, moments.yaw_rate))
    unit = f"10{style.superscript(power)} rad/s" if power else "rad/s"
    spin_rate, yaw_rate = moments.spin_rate / 10.0**power, moments.yaw_rate / 10.0**power
    ends = np.array([spin_rate.min(), spin_rate.max()])
    ax.plot(spin_rate, yaw_rate, color=color, lw=2.4, alpha=0.5)
    ax.plot(ends, -ends, color=style.THEORY, ls="--", lw=0.8, label="d$ψ$/d$t$ = −d$θ$/d$t$")
    style.label(ax, "i", "yaw rate, spin rate", f"d$θ$/d$t$ ({unit})", f"d$ψ$/d$t$ ({unit})")
    _headroom(ax)
    ax.legend(loc="upper right")


def _power(values: Array) -> int:
    """The exponent, a multiple of 3, of the unit in which the largest value is shown."""
    peak = float(np.abs(values).max())
    return 3 * int(np.floor(np.log10(peak) / 3.0)) if peak > 0.0 else 0


def _evenly(motion: Trajectory) -> Moments:
    """The motion at even times: its usual sizes, not those of the moments when it is fast."""
    return motion.evaluate(np.linspace(0.0, float(motion.t[-1]), 201))


def _stretch(ax: Axes, values: Array, usual: Array) -> None:
    """Make the axis logarithmic beyond the usual size, if the peaks would flatten all else."""
    peak = float(np.abs(values).max())
    if peak < ROUNDING:
        ax.set_ylim(-1.0, 1.0)
        return
    size = max(float(np.median(np.abs(usual))), 1e-30 * peak)
    if peak > DECADES * size:
        linear = 10.0 ** np.ceil(np.log10(size))
        linscale = max(0.9, 0.07 * np.log10(peak / linear))
        ax.set_yscale("symlog", linthresh=linear, linscale=linscale)
        locator = SymmetricalLogLocator(ax.yaxis.get_transform())
        locator.set_params(numticks=7)
        ax.yaxis.set_major_locator(locator)
        style.decades(ax.yaxis)


def _headroom(ax: Axes) -> None:
    """Keep the top of a panel free for its legend."""
    scale = ax.yaxis.get_transform()
    low, high = scale.transform(np.array(ax.get_ylim()))
    ax.set_ylim(top=float(scale.inverted().transform(np.array([high + 0.2 * (high - low)]))[0]))


def _room(ax: Axes, motion: Trajectory) -> tuple[float, float]:
    """Where in the yaw's panel the curve leaves the most room for a lens, in parts of the panel."""
    even = _evenly(motion)
    x = even.t / float(motion.t[-1])
    low, high = ax.get_ylim()
    y = (even.yaw - low) / (high - low)
    rises = motion.yaw[-1] >= motion.yaw[0]
    corners = [(0.66, 0.19), (0.66, 0.6), (0.16, 0.6), (0.16, 0.19)]
    if not rises:
        corners[:2] = corners[1::-1]

    def covered(corner: tuple[float, float]) -> int:
        left, bottom = corner
        beside = (x > left - 0.1) & (x < left + LENS[0])
        return int(np.sum(beside & (y > bottom - 0.2) & (y < bottom + LENS[1])))

    return min(corners, key=covered)


def _magnify(ax: Axes, motion: Trajectory, color: str) -> None:
    """Put a lens on the step of the yaw where the staircase leaves room for it."""
    window = near_collision_window(motion)
    if window is None:
        return
    t = window.t + window.half_width * np.linspace(-1.0, 1.0, 401)
    unit, second = next((u for u in TIME_UNITS if window.half_width >= u[1]), TIME_UNITS[-1])
    lens = ax.inset_axes((*_room(ax, motion), *LENS))
    if has_one_limit(motion.law):
        half = 0.5 * turn_limit(motion.body, motion.law)
        for limit in (window.yaw - half, window.yaw + half):
            lens.axhline(limit, color=style.THEORY, ls="--", lw=0.7)
    yaw = motion.evaluate(np.clip(t, 0.0, motion.t[-1])).yaw
    lens.plot((t - window.t) / second, yaw, color=color)
    lens.set_xlim(*(window.half_width / second * np.array([-1.0, 1.0])))
    lens.yaxis.set_major_locator(MaxNLocator(3, integer=True))
    lens.tick_params(labelsize=6.0, pad=1.5, length=2.0)
    lens.set_xlabel(f"$t$ − {window.t:.3f} s ({unit})", fontsize=6.0, labelpad=1.0)
    lens.set_ylabel("$ψ$ (rad)", fontsize=6.0, labelpad=0.5)
    lens.spines[["top", "right"]].set_visible(True)


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


def shaken_figure(motion: Trajectory) -> Figure:
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


def _draw_tilt(ax: Axes, motion: Trajectory, moments: Moments) -> None:
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


def _highest_ratio(motion: Trajectory) -> float:
    """The top of the tilt's panel over the balance tilt, with room for the legend."""
    largest = motion.max_tilt_ratio
    if motion.overturned:
        return UPRIGHT
    return 1.3 * largest if 1e-6 < largest < 0.5 else max(1.3, 1.3 * largest)


def _draw_footprint(ax: Axes, motion: Trajectory, path: Array) -> None:
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
