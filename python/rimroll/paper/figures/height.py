"""The angle of turn against height: from disks, past the can, to tall columns."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from matplotlib.axes import Axes

from rimroll import bodies
from rimroll.bodies import solids
from rimroll.bodies.body import Body
from rimroll.figures import style
from rimroll.laws import Frictionless, NoSlip
from rimroll.motion import Array
from rimroll.paper import setting
from rimroll.paper.drawing import Drawing, Table
from rimroll.theory.closed_forms import disk_turn_limit, turn_limit

HEIGHTS = np.concatenate([[1e-9], np.linspace(0.02, 1.0, 50), np.linspace(1.05, 4.2, 64)])
"""H/R at which the curves are drawn."""


@dataclass(frozen=True)
class Thing:
    """A body with a name, and the place of its label (H/R, degrees) with its alignment there."""

    name: str
    body: Body
    at: tuple[float, float]
    align: str = "left"


def things() -> tuple[Thing, ...]:
    """The marked bodies, in order of height."""
    return (
        Thing("disk", bodies.disk(1.0), (0.08, 417.0)),
        Thing("coin (1 euro)", bodies.coin(), (0.40, 413.0)),
        Thing("Euler’s disk", bodies.euler_disk(), (0.62, 393.0)),
        Thing("ring", bodies.ring(), (0.10, 292.0)),
        Thing("paper’s can", setting.CAN, (1.05, 190.0), "right"),
        Thing("soda can, empty", bodies.soda_can(), (1.90, 171.0), "center"),
        Thing("soda can, full", bodies.soda_can(1.0), (2.36, 239.0)),
        Thing("beer bottle, empty", bodies.beer_bottle(), (3.05, 171.0), "center"),
        Thing("AA battery", bodies.battery(), (3.56, 214.0)),
    )


def draw() -> Drawing:
    """Turn against H/R for both laws, with real bodies and the measured turns."""
    with style.figure_style():
        figure = style.page(112.0)
        ax = figure.subplots()
        _draw_limits(ax)
        _draw_curves(ax)
        _draw_things(ax)
        _draw_measured(ax)
        _magnify(ax)
        style.label(
            ax, "", "", "height of the centre of mass, $H$/$R$ (1)", "angle of turn (degrees)"
        )
        ax.set_xlim(-0.08, 4.2)
        ax.set_ylim(160.0, 425.0)
        ax.legend(loc="upper right", bbox_to_anchor=(1.0, 0.905), ncols=2)
        style.settle(figure)
    return Drawing(
        "height",
        "The angle of turn of things tall and flat",
        figure,
        _caption(),
        {thing.name: _numbers(thing) for thing in things()},
        _table(),
    )


def solid_cylinder(height: float) -> Body:
    """A uniform cylinder of radius 1 m whose centre of mass is at ``height``, m."""
    return bodies.cylinder(1.0, 2.0 * height)


def open_shell(height: float) -> Body:
    """A thin wall of radius 1 m, open at both ends, whose centre of mass is at ``height``, m."""
    return Body.from_solids(1.0, [solids.wall(1.0, 1.0, 2.0 * height)])


def _draw_curves(ax: Axes) -> None:
    for law in setting.LAWS:
        color, name = law.color, setting.LAW_NAMES[law.name]
        for kind, make, dashes in (
            ("solid cylinder", solid_cylinder, "-"),
            ("open shell", open_shell, (0, (4, 2))),
        ):
            turns = np.degrees([turn_limit(make(height), law) for height in HEIGHTS])
            ax.plot(HEIGHTS, turns, color=color, ls=dashes, label=f"{kind}, {name}")


def _draw_limits(ax: Axes) -> None:
    disk = float(np.degrees(disk_turn_limit(0.5**0.5)))
    for limit, name, above in (
        (180.0, "tall: 180°", -9.0),
        (disk, f"disk: π√5 = {disk:.2f}°", 3.0),
    ):
        ax.axhline(limit, color=style.CONTRAST, lw=0.6, ls=":", zorder=0)
        ax.annotate(
            name,
            (1.0, limit),
            (-1.0, above),
            xycoords=("axes fraction", "data"),
            textcoords="offset points",
            ha="right",
            color="#555555",
            size=6.8,
        )


def _draw_things(ax: Axes) -> None:
    for thing in things():
        x = thing.body.height / thing.body.radius
        turns = [float(np.degrees(turn_limit(thing.body, law))) for law in setting.LAWS]
        ax.plot([x, x], turns, color="#333333", lw=0.7, zorder=3)
        for law, turn in zip(setting.LAWS, turns, strict=True):
            ax.plot(x, turn, ls="none", zorder=4, **style.look(law))
        near = min(turns, key=lambda turn: abs(turn - thing.at[1]))
        ax.annotate(
            thing.name,
            (x, near),
            thing.at,
            ha=thing.align,
            va="center",
            size=6.8,
            arrowprops={"arrowstyle": "-", "lw": 0.5, "color": "#777777", "shrinkB": 3.0},
        )


def _draw_measured(ax: Axes) -> None:
    x = setting.CAN.height / setting.CAN.radius
    for place, (mean, deviation), mark in zip(
        (x - 0.06, x + 0.06), setting.MEASURED, "<>", strict=True
    ):
        look: dict[str, Any] = {
            "color": style.MEASURED,
            "marker": mark,
            "ms": 4.0,
            "lw": 0.9,
            "ls": "none",
        }
        ax.errorbar(place, mean, deviation, capsize=1.8, zorder=5, **look)


def _magnify(ax: Axes) -> None:
    """Magnify the can, with the experiment beside the two laws."""
    lens = ax.inset_axes((0.60, 0.36, 0.39, 0.37), xlim=(0.92, 1.8), ylim=(197.0, 227.0))
    x = setting.CAN.height / setting.CAN.radius
    rolling, sliding = _turns(setting.CAN)
    lens.plot([x, x], [rolling, sliding], color="#333333", lw=0.7)
    for law, turn, away, align in zip(
        setting.LAWS, (rolling, sliding), (0.04, -0.04), ("left", "right"), strict=True
    ):
        lens.plot(x, turn, ls="none", **style.look(law))
        text = f"{setting.LAW_NAMES[law.name]} {turn:.2f}°"
        lens.text(x + away, turn, text, ha=align, va="center", size=6.8)
    _draw_measured(lens)
    for (mean, spread), side, name, align in (
        (setting.MEASURED[0], -0.1, "measured, leftward", "right"),
        (setting.MEASURED[1], 0.1, "measured, rightward", "left"),
    ):
        text = f"{name}\n{mean:.1f}° ± {spread}°"
        lens.text(x + side, mean, text, ha=align, va="center", size=6.8, color=style.MEASURED)
    lens.set_title("the paper’s can", fontsize=6.8)
    lens.set_xlabel("$H$/$R$ (1)", fontsize=6.8)
    lens.set_ylabel("angle of turn (degrees)", fontsize=6.8)
    lens.spines[["top", "right"]].set_visible(True)


def _turns(body: Body) -> Array:
    return np.degrees([turn_limit(body, law) for law in setting.LAWS])


def _caption() -> str:
    rolling, sliding = _turns(setting.CAN)
    bottle = _turns(bodies.beer_bottle())
    disk, ring = (np.degrees(disk_turn_limit(ratio)) for ratio in (0.5**0.5, 1.0))
    (left, spread), (right, wider) = setting.MEASURED
    return (
        "Limiting angle of turn against the height of the centre of mass, rolling without slip "
        "(blue) and sliding without friction (vermilion): solid cylinders (full lines, H = L/2), "
        "thin shells without ends (dashed), and everyday bodies (dots and squares, joined). "
        f"As the paper says, both laws agree for disks ({disk:.2f}° solid, {ring:.2f}° for a ring) "
        f"and tend to 180° for tall bodies (a beer bottle: {bottle[0]:.1f}° to {bottle[1]:.1f}°). "
        f"The paper’s measured turns of the can, {left}° ± {spread}° and {right}° ± {wider}° "
        f"(bars: one s.d.), lie between its {rolling:.2f}° and {sliding:.2f}°."
    )


def _numbers(thing: Thing) -> dict[str, object]:
    return {
        "height_over_radius": thing.body.height / thing.body.radius,
        "turn_no_slip": turn_limit(thing.body, NoSlip()),
        "turn_frictionless": turn_limit(thing.body, Frictionless()),
    }


def _table() -> Table:
    rows = [
        [thing.name, f"{thing.body.height / thing.body.radius:.3f}"]
        + [f"{turn:.2f}" for turn in _turns(thing.body)]
        for thing in things()
    ]
    head = ["", "H/R", "no slip (degrees)", "frictionless (degrees)"]
    return Table("Limiting angles of turn.", head, rows)
