"""The paper's heuristic: near a collision the lean moves like a particle in a central force."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from matplotlib.axes import Axes

from rimroll.figures import style
from rimroll.laws import Law
from rimroll.motion import Array
from rimroll.paper import setting
from rimroll.paper.drawing import Drawing
from rimroll.theory.approximations import NearCollision
from rimroll.theory.closed_forms import turn_limit

PAPER = 0.005
SIDEWAYS = {0.1: ":", PAPER: "-", 1e-4: (0, (4, 1.5))}
"""ψ̇ = θ̇ = ε at the release, rad/s, and the line each is drawn with."""

PATH = 4.0  # the path is drawn out to this many φ_c
YAW = 12.0  # and the yaw to this many φ_c/ω
LARGEST = 0.2  # rad of tilt to which the heuristic is followed


@dataclass(frozen=True)
class Comparison:
    """The heuristic and the full motion after the smallest tilt, at the times t since it.

    ``scaled`` is ωt/φ_c; tilts and yaws (counted from the smallest tilt, in the direction of the
    turn) are in rad, arrays of shape (n,).
    """

    min_tilt: float
    scaled: Array
    heuristic_tilt: Array
    heuristic_yaw: Array
    tilt: Array
    yaw: Array

    @property
    def difference(self) -> Array:
        """Full minus heuristic yaw, rad."""
        return self.yaw - self.heuristic_yaw


def compare(law: Law, sideways: float) -> Comparison:
    """Integrate the paper's lean vector from the computed smallest tilt on, beside the motion."""
    motion = setting.motion(law, sideways)
    turn = motion.turns[0]
    direction = float(np.sign(turn.yaw_rate))
    rate = abs(turn.yaw_rate) * turn.min_tilt * np.pi / turn_limit(setting.CAN, law)
    lean = NearCollision(setting.CAN, law, turn.min_tilt, rate, direction)
    t, tilt, yaw = lean.lean_vector(LARGEST / rate)
    state, start = motion(turn.t + t), motion(turn.t)
    return Comparison(
        turn.min_tilt,
        rate * t / turn.min_tilt,
        tilt,
        direction * yaw,
        np.asarray(state.tilt),
        direction * (np.asarray(state.yaw) - start.yaw),
    )


def draw() -> Drawing:
    """The lean's path, the yaw over time, and the difference."""
    with style.figure_style():
        figure = style.page(78.0)
        left, middle, right = figure.subplots(1, 3, width_ratios=(1.3, 0.9, 0.95))
        _draw_path(left)
        _draw_yaw(middle)
        _draw_difference(right)
        style.settle(figure)
    return Drawing("small_angle", "The heuristic for small tilts", figure, _caption(), _numbers())


def _both_sides(values: Array, sign: float) -> Array:
    """A quantity before and after the smallest tilt: even (sign 1) or odd (−1) in time."""
    return np.concatenate([sign * values[:0:-1], values])


def _draw_path(ax: Axes) -> None:
    ax.axvline(1.0, color=style.CONTRAST, lw=0.9, ls=":", label="free particle, 180°")
    for law in setting.LAWS:
        one, color = compare(law, PAPER), law.color
        near = one.scaled < 1.2 * PATH
        limit = turn_limit(setting.CAN, law)
        for tilt, yaw, look in (
            (one.tilt, one.yaw, {"color": color, "lw": 2.8, "alpha": 0.5}),
            (one.heuristic_tilt, one.heuristic_yaw, {"color": "k", "lw": 0.8, "ls": (0, (4, 2))}),
        ):
            radius = _both_sides(tilt[near], 1.0) / one.min_tilt
            angle = _both_sides(yaw[near], -1.0)
            ax.plot(radius * np.cos(angle), radius * np.sin(angle), **look)  # type: ignore[arg-type]
        name = f"{setting.LAW_NAMES[law.name]}, {np.degrees(limit):.2f}°"
        ax.plot([], [], color=color, lw=2.8, alpha=0.5, label=name)
    ax.plot([], [], color="k", lw=0.8, ls=(0, (4, 2)), label="heuristic")
    ax.plot(0.0, 0.0, "+", color=style.THEORY, ms=6.0)
    x, y = "$φ$ cos $ψ$/$φ_c$ (1)", "$φ$ sin $ψ$/$φ_c$ (1)"
    style.label(ax, "a", "path of the lean", x, y)
    ax.set_aspect("equal")
    ax.set_xlim(-1.2, 6.2)
    ax.set_ylim(-PATH, PATH)
    ax.legend(loc="center right")


def _draw_yaw(ax: Axes) -> None:
    for law in setting.LAWS:
        one, color = compare(law, PAPER), law.color
        near = one.scaled < YAW
        x = _both_sides(one.scaled[near], -1.0)
        ax.plot(x, _both_sides(one.yaw[near], -1.0), color=color, lw=2.8, alpha=0.5)
        heuristic = _both_sides(one.heuristic_yaw[near], -1.0)
        ax.plot(x, heuristic, color="k", lw=0.8, ls=(0, (4, 2)))
        half = 0.5 * turn_limit(setting.CAN, law)
        for limit in (-half, half):
            ax.axhline(limit, color=color, lw=0.6, ls=":", zorder=0)
    style.label(ax, "b", "yaw", "scaled time $ω$($t$ − $t_c$)/$φ_c$ (1)", "$ψ$ − $ψ_c$ (rad)")


def _draw_difference(ax: Axes) -> None:
    for law in setting.LAWS:
        for sideways, dashes in SIDEWAYS.items():
            one = compare(law, sideways)
            far = one.scaled > 0.5
            scaled, difference = one.scaled[far], one.difference[far]
            ax.semilogx(scaled, difference / one.min_tilt, color=law.color, ls=dashes)
    for sideways, dashes in SIDEWAYS.items():
        ax.plot([], [], color="k", ls=dashes, label=f"$ε$ = {style.plain(sideways)} rad/s")
    x, y = "scaled time $ω$($t$ − $t_c$)/$φ_c$ (1)", "(full − heuristic yaw)/$φ_c$ (1)"
    style.label(ax, "c", "parting", x, y)
    style.decades(ax.xaxis)
    ax.legend(loc="upper left")


def _caption() -> str:
    ends = {s: compare(setting.LAWS[0], s) for s in SIDEWAYS}
    differences = ", ".join(
        f"{one.difference[-1]:.1e} rad (ε = {style.plain(s)})" for s, one in ends.items()
    )
    return (
        "The paper’s heuristic treats the lean as a plane vector of length φ and direction ψ. "
        "Integrated from the smallest tilt (dashed), it lies on the full motion near the "
        "collision: where a free particle would pass by in a straight line, 180°, the central "
        "force bends its path to the limiting angles. The yaws differ only by φ<sub>c</sub> "
        "times a logarithm of the time (c): where the curves end, near a tilt of "
        f"{LARGEST} rad, they differ by {differences} without slip."
    ).replace("e-", "e−")


def _numbers() -> dict[str, object]:
    return {
        law.name: {
            "turn_limit": turn_limit(setting.CAN, law),
            **{
                f"sideways {sideways:g}": {
                    "min_tilt": one.min_tilt,
                    "heuristic_turn": 2.0 * one.heuristic_yaw[-1],
                    "full_turn": 2.0 * one.yaw[-1],
                    "reached_tilt": one.tilt[-1],
                }
                for sideways in SIDEWAYS
                for one in [compare(law, sideways)]
            },
        }
        for law in setting.LAWS
    }
