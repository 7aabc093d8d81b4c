"""Left or right: the discontinuity of the paper's summary, as maps of the direction of fall."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from typing import Any

import numpy as np
from matplotlib.axes import Axes

from rimroll.figures import style
from rimroll.figures.style import superscript
from rimroll.laws import Coulomb, Frictionless, Law, NoSlip
from rimroll.many.ensemble import OPTIONS, follow
from rimroll.many.falls import Column, Falls
from rimroll.many.left_or_right import map_falls, watershed, watershed_slope
from rimroll.many.map_figure import SPIN, YAW, directions, draw_map, scale_of_directions
from rimroll.motion import Array
from rimroll.paper import setting
from rimroll.paper.drawing import Drawing, Table
from rimroll.paper.setting import MEASURED
from rimroll.state import State
from rimroll.theory.closed_forms import turn_limit

FRICTION = 0.15
"""With this friction the flicked can's near-collision turns by about the measured 213.0 degrees."""

LAWS: tuple[Law, ...] = (NoSlip(), Coulomb(FRICTION), Frictionless())

FLICK = State(tilt=np.radians(20.0), tilt_rate=-5.0)
"""The can falls over on the other side, as in the paper's experiment, and does not lift off."""

MAX_RATE = 1.0
"""Yaw and spin rates of the maps reach this far, rad/s."""

CELLS = 150
"""Starts of a map in each direction; even, so that no start comes down flat."""

REACH = 60.0
"""Range of the colour scale on both sides of 180 degrees."""

YAW_RATES = np.geomspace(1e-9, MAX_RATE, 73)
"""Range of the cut through the maps, to either side, rad/s."""

ZOOM = 1e-9
"""Yaw rates smaller than this are drawn at one place in the cut, rad/s."""

BIN = 2.0
"""Width of the histogram's bins, degrees."""

AIMS = np.array([-3.0, -2.0, -1.0, 1.0, 2.0, 3.0])
"""Errors of aim that are marked, degrees."""


def name(law: Law) -> str:
    """The name of a law in the figure."""
    return (
        f"dry friction, $μ$ = {FRICTION}"
        if isinstance(law, Coulomb)
        else setting.LAW_NAMES[law.name]
    )


@cache
def falls(law: Law) -> Falls:
    """The map of a law: spin rates above 0 are computed, the others are their mirror images."""
    rates = (np.arange(CELLS) + 0.5) * 2.0 * MAX_RATE / CELLS - MAX_RATE
    options = replace(OPTIONS, gravity=setting.GRAVITY, rtol=1e-5)
    half = map_falls(setting.CAN, FLICK, law, rates, rates[CELLS // 2 :], options)

    def whole(name: str) -> Column:
        values = half[name]
        mirrored = 2.0 * np.pi - values if name == "direction" else values
        return Column(np.concatenate([mirrored[::-1, ::-1], values]))

    columns = {name: whole(name) for name in ("direction", "min_tilt", "outcome")}
    axes = {"spin_rate": Column(rates), "yaw_rate": half.axes["yaw_rate"]}
    return Falls(columns, axes, half.attrs)


@cache
def cut(law: Law) -> tuple[Array, Array]:
    """Directions (degrees) and smallest tilts (rad) at :data:`YAW_RATES`, without spin."""
    starts = State(
        tilt=FLICK.tilt,
        tilt_rate=FLICK.tilt_rate,
        yaw_rate=np.concatenate([-YAW_RATES[::-1], YAW_RATES]),
    )
    options = replace(OPTIONS, gravity=setting.GRAVITY)
    along = follow(setting.CAN, starts, law, options)
    return np.degrees(along["direction"]), along["min_tilt"]


@cache
def line(law: Law) -> tuple[Array, Array]:
    """The watershed of a law, yaw rates and spin rates: theory for the ideal laws, else found."""
    spin_rates = np.linspace(-MAX_RATE, MAX_RATE, 9)
    if isinstance(law, Coulomb):
        gravity = setting.GRAVITY
        return watershed(setting.CAN, FLICK, law, spin_rates, gravity=gravity), spin_rates
    return watershed_slope(setting.CAN, FLICK.tilt, law) * spin_rates, spin_rates


@cache
def jump(law: Law) -> tuple[float, float]:
    """Directions to which falls to the right and to the left tend, degrees.

    Closed forms for the ideal laws; under friction the can turns further as it rises, and the
    directions are those at the smallest rates of the cut.
    """
    if isinstance(law, Coulomb):
        right, left = cut(law)[0][len(YAW_RATES) - 1 : len(YAW_RATES) + 1]
        return float(right), float(left)
    turn = float(np.degrees(turn_limit(setting.CAN, law)))
    return 360.0 - turn, turn


def draw() -> Drawing:
    """The maps of three laws, a cut through them, and how many starts fall in which direction."""
    with style.figure_style():
        figure = style.page(122.0)
        upper, lower = figure.subfigures(2, 1, height_ratios=(1.0, 0.95))  # type: ignore[misc]
        maps = upper.subplots(1, 3, sharey=True)
        for ax, law, letter in zip(maps, LAWS, "abc", strict=True):
            image = draw_map(ax, falls(law), REACH)
            _draw_contours(ax, law)
            _draw_line(ax, law)
            style.label(ax, letter, name(law), YAW, SPIN if letter == "a" else "")
        _draw_sides(maps[0])
        _draw_aims(maps[1])
        beside = maps[2].inset_axes((1.07, 0.0, 0.055, 1.0))
        scale_of_directions(upper.colorbar(image, cax=beside))
        through, shares = lower.subplots(1, 2, sharey=True, width_ratios=(1.9, 1.0))
        _draw_cut(through)
        _draw_shares(shares)
        style.settle(figure)
    return Drawing("sensitivity", "Left or right", figure, _caption(), _numbers(), table())


def _draw_contours(ax: Axes, law: Law) -> None:
    """Lines of equal direction, on either side of 180 degrees by itself."""
    plane, found = falls(law), directions(falls(law))
    for side in (found < 180.0, found > 180.0):
        ax.contour(
            plane["yaw_rate"],
            plane["spin_rate"],
            np.where(side, found, np.nan),
            np.arange(130.0, 235.0, 5.0),
            colors="white",
            linewidths=0.4,
            alpha=0.7,
        )


def _draw_line(ax: Axes, law: Law) -> None:
    ax.plot(*line(law), color=style.THEORY, lw=1.0)
    ax.plot(0.0, 0.0, "o", color=style.THEORY, mfc="white", ms=3.6)
    ax.set_aspect("equal")
    ax.set(xlim=(-MAX_RATE, MAX_RATE), ylim=(-MAX_RATE, MAX_RATE))
    for axis in (ax.xaxis, ax.yaxis):
        axis.set_ticks([-1.0, -0.5, 0.0, 0.5, 1.0], ["−1", "−0.5", "0", "0.5", "1"])


def _draw_sides(ax: Axes) -> None:
    for x, side in ((-0.55, "right"), (0.58, "left")):
        ax.text(x, 0.0, f"falls to\nthe {side}", ha="center", va="center")
    ax.annotate(
        "comes down\nflat",
        (0.02, -0.03),
        (0.42, -0.6),
        ha="center",
        va="center",
        size=6.3,
        arrowprops={"arrowstyle": "-", "lw": 0.5, "shrinkB": 2.0},
    )


def _draw_aims(ax: Axes) -> None:
    """Flicks with an error of aim: the flick's angular velocity, rotated about the vertical."""
    sideways = FLICK.tilt_rate * np.tan(np.radians(AIMS))
    yaw_rates, spin_rates = sideways / np.tan(FLICK.tilt), -sideways / np.sin(FLICK.tilt)
    ax.plot(yaw_rates, spin_rates, ls="none", marker="+", color="white", ms=5.0, mew=1.0)
    for aim, x, y in zip(AIMS, yaw_rates, spin_rates, strict=True):
        ax.annotate(
            f"{abs(aim):g}°",
            (x, y),
            (5.0, 4.5),
            textcoords="offset points",
            ha="center",
            va="center",
            size=6.3,
            color="white",
        )
    ax.text(-0.60, 0.18, "aim off by", ha="center", va="center", size=6.3, color="white")


def _draw_cut(ax: Axes) -> None:
    middle = len(YAW_RATES)
    for law, place in zip(LAWS, (-0.55, 0.0, 0.55), strict=True):
        found, color = cut(law)[0], law.color
        ax.plot(-YAW_RATES[::-1], found[:middle], color=color)
        ax.plot(YAW_RATES, found[middle:], color=color)
        right, left = jump(law)
        ax.text(1e-6, left + 1.2, name(law), color=color, va="bottom", size=6.8)
        arrow = {"arrowstyle": "<->", "color": color, "lw": 0.8, "shrinkA": 0.0, "shrinkB": 0.0}
        ax.annotate("", (place * ZOOM, left), (place * ZOOM, right), arrowprops=arrow)
        ax.text(
            (place + 0.12) * ZOOM,
            180.0,
            f"{left - right:.2f}°",
            color=color,
            rotation=90.0,
            size=6.3,
            va="center",
            ha="left",
            bbox={"fc": "white", "lw": 0.0, "pad": 0.6},
        )
    ax.axhline(180.0, color=style.CONTRAST, lw=0.7, zorder=0)
    ax.text(-0.7, 181.2, "straight opposite", color="#555555", size=6.8, va="bottom")
    ax.set_xscale("symlog", linthresh=ZOOM, linscale=1.5)
    ticks = np.array([1e-6, 1e-3, 1.0])
    ax.set_xticks([*-ticks[::-1], 0.0, *ticks])
    style.decades(ax.xaxis)
    ax.set_xlim(-MAX_RATE, MAX_RATE)
    ax.set_ylim(180.0 - REACH, 180.0 + REACH)
    title = "through the maps at spin rate 0: the same jump at every zoom"
    style.label(ax, "d", title, YAW, "direction of fall (degrees)")


def _draw_shares(ax: Axes) -> None:
    """How many starts of the maps fall in each direction, and the directions of the experiment."""
    edges = np.arange(180.0 - REACH, 180.0 + REACH + BIN, BIN)
    for law in LAWS:
        found = directions(falls(law)).ravel()
        share = 100.0 * np.histogram(found, edges)[0] / found.size
        share[share == 0.0] = np.nan  # no line along the axis
        color = law.color
        ax.stairs(share, edges, orientation="horizontal", color=color, lw=1.0)
        ax.stairs(share, edges, orientation="horizontal", color=color, fill=True, alpha=0.12)
    for (mean, spread), way, side in zip(MEASURED, (1.0, -1.0), ("left", "right"), strict=True):
        direction = 180.0 + way * (mean - 180.0)
        bar: dict[str, Any] = {
            "color": style.MEASURED,
            "marker": "o",
            "ms": 3.4,
            "lw": 0.9,
            "capsize": 1.8,
        }
        ax.errorbar(14.4, direction, spread, **bar)
        text = f"measured,\n{side}ward"
        ax.text(15.0, direction, text, color="#00705A", size=6.3, va="center")
    ax.axhline(180.0, color=style.CONTRAST, lw=0.7, zorder=0)
    ax.set_xlim(0.0, 18.5)
    ax.set_xticks([0.0, 5.0, 10.0])
    style.label(ax, "e", "all starts of the maps", f"starts per {BIN:g}° (%)", "")


def _caption() -> str:
    jumps = {law.name: np.subtract(*jump(law)[::-1]) for law in LAWS}
    slopes = [watershed_slope(setting.CAN, FLICK.tilt, law) for law in setting.LAWS]
    nearest = min(gap(law) for law in LAWS)
    followed = sum(int(np.isfinite(directions(falls(law))).sum()) for law in LAWS)
    smallest = np.degrees(cut(LAWS[0])[1][_at(1e-3)])
    return (
        "“Discontinuous dependence on initial conditions”, the paper says in its summary. "
        "(a–c) Direction in which its can falls, flicked from 20° at 5 rad/s, over the plane of "
        "yaw and spin rates that the flick adds; white lines every 5°. Across the black line it "
        f"jumps, by {jumps['no_slip']:.2f}° (no slip) or {jumps['frictionless']:.2f}° "
        "(frictionless), twice what the limiting turn exceeds 180° by. On it the can comes down "
        "flat. It is straight whatever the tilt rate: yaw rate "
        f"{slopes[0]:.4f} (a) and {slopes[1]:.4f} (c) of the spin rate by linear theory; in (b) "
        "it is found by trial. Crosses: flicks whose aim is off. "
        f"(d) Zooming in a billionfold changes nothing; 10{superscript(-3)} rad/s brings the base "
        f"within {smallest:.4f}° of the table. (e) So falls are left or right, and none of these "
        f"{followed} is within {nearest:.0f}° of opposite."
    )


def gap(law: Law) -> float:
    """The smallest distance of a fall of the map from 180 degrees, degrees."""
    return float(np.nanmin(np.abs(directions(falls(law)) - 180.0)))


def _at(yaw_rate: float) -> int:
    """The place of a yaw rate above 0 in the cut, rad/s."""
    return len(YAW_RATES) + int(np.argmin(np.abs(YAW_RATES / yaw_rate - 1.0)))


def _numbers() -> dict[str, object]:
    return {
        "start_tilt": FLICK.tilt,
        "start_tilt_rate": FLICK.tilt_rate,
        "friction": FRICTION,
        "yaw_rate": YAW_RATES,
        **{law.name: _numbers_of(law) for law in LAWS},
    }


def _numbers_of(law: Law) -> dict[str, object]:
    found, min_tilt = cut(law)
    yaw_rates, spin_rates = line(law)
    right, left = jump(law)
    return {
        "watershed_yaw_rate": yaw_rates,
        "watershed_spin_rate": spin_rates,
        "limits_degrees": [right, left],
        "jump_degrees": left - right,
        "direction_degrees": found[len(YAW_RATES) :],
        "min_tilt": min_tilt[len(YAW_RATES) :],
        "nearest_to_opposite_degrees": gap(law),
    }


def table() -> Table:
    """Falls to the left that approach the jump, without spin."""
    head = ["yaw rate (rad/s)"]
    for law in LAWS:
        plain = name(law).replace("$", "")
        head += [f"direction, {plain} (degrees)", "smallest tilt (degrees)"]
    rows = []
    for power in (0, -1, -2, -3, -6, -9):
        row = [style.power_of_ten(10.0**power)]
        for law in LAWS:
            found, min_tilt = (column[_at(10.0**power)] for column in cut(law))
            row += [f"{found:.5f}", f"{np.degrees(min_tilt):.3e}".replace("-", "−")]
        rows.append(row)
    limits = [cell for law in LAWS for cell in (f"{jump(law)[1]:.5f}", "0")]
    text = (
        "Falls to the left at spin rate 0, ever nearer to the jump; to the right: 360° less these."
    )
    return Table(text, head, [*rows, ["→ 0", *limits]])
