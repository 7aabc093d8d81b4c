"""The friction that rolling needs: constant through the near-collision, and in closed form."""

from __future__ import annotations

from functools import cache

import numpy as np
from matplotlib.axes import Axes

from rimroll.figures import style
from rimroll.laws import NoSlip
from rimroll.motion import Array, Motion, Turn
from rimroll.paper import setting
from rimroll.paper.drawing import Drawing
from rimroll.theory.closed_forms import needed_friction, turn_limit

SHOWN = (0.05, 0.005, 5e-4, 5e-5, 5e-6)
"""Sideways rates ε (rad/s) whose near-collisions are drawn; the second is the paper's."""

DASHES = ((0, (1, 1)), (0, (5, 1.5)), (0, (5, 1, 1, 1)), (0, (2.5, 1)), "-")

NEARER = np.array([float(f"5e-{power}") for power in range(1, 10)])
"""Sideways rates along which the ratio at the smallest tilt tends to μ*, rad/s."""


def draw() -> Drawing:
    """|T|/N through the collision, over the rocking, and its difference from μ*."""
    with style.figure_style():
        figure = style.page(74.0)
        left, middle, right = figure.subplots(1, 3, width_ratios=(1.25, 1.0, 0.9))
        _draw_collision(left)
        _draw_rocking(middle)
        _draw_difference(right)
        style.settle(figure)
    return Drawing("friction", "The friction that rolling needs", figure, _caption(), _numbers())


def collision_time(turn: Turn) -> float:
    """φ_c/ω, s, from the yaw rate ψ̇ = √(J/K) ω/φ_c at the smallest tilt."""
    limit: float = turn_limit(setting.CAN, NoSlip())
    return limit / (np.pi * abs(turn.yaw_rate))


def ratio_at_smallest_tilt(motion: Motion) -> float:
    """|T|/N at the first near-collision."""
    return float(motion.evaluate(motion.turns[0].t).friction_ratio[0])


def _draw_collision(ax: Axes) -> None:
    scaled = np.linspace(-15.0, 15.0, 301)
    _draw_needed(ax)
    for sideways, color, dashes in zip(SHOWN, style.SERIES, DASHES, strict=False):
        motion = setting.motion(NoSlip(), sideways)
        turn = motion.turns[0]
        ratio = motion.evaluate(turn.t + collision_time(turn) * scaled).friction_ratio
        ax.plot(scaled, ratio, color=color, ls=dashes, label=style.plain(sideways))
    title = "through the collision"
    style.label(ax, "a", title, "scaled time $ω$($t$ − $t_c$)/$φ_c$ (1)", "|$T$|/$N$ (1)")
    ax.set_ylim(0.2, 0.41)
    ax.set_yticks(np.arange(0.2, 0.41, 0.05))
    ax.legend(
        loc="upper center", ncols=3, columnspacing=1.2, title="$ε$ (rad/s)", title_fontsize=6.8
    )


def _draw_needed(ax: Axes) -> None:
    ax.axhline(needed_friction(setting.CAN), color=style.THEORY, lw=0.8, ls="--", zorder=0)


def _draw_rocking(ax: Axes) -> None:
    _draw_needed(ax)
    moments = setting.motion(NoSlip(), SHOWN[1]).samples(4)
    ax.plot(moments.t, moments.friction_ratio, color=style.SERIES[1])
    needed = needed_friction(setting.CAN)
    text = f"$μ^*$ = $mHR$/($A$+$mH$²) = {needed:.4f}"
    ax.text(0.5, 0.963, text, transform=ax.transAxes, ha="center", va="top", size=6.8)
    style.label(ax, "b", f"rocking, $ε$ = {SHOWN[1]} rad/s", "time $t$ (s)", "|$T$|/$N$ (1)")
    ax.set_xlim(0.0, 1.2)
    ax.set_ylim(0.0, 0.41)


def _draw_difference(ax: Axes) -> None:
    min_tilt, difference = _differences()
    ax.loglog(min_tilt, difference, "o", color=style.NO_SLIP)
    law = min_tilt * np.polyval(_difference_law(), np.log(min_tilt))
    ax.loglog(
        min_tilt, law, color=style.THEORY, lw=0.8, zorder=0, label="$φ_c (c_1\\,\\ln φ_c + c_0)$"
    )
    y = "1 − |$T$|/($μ^*N$) at $t_c$ (1)"
    style.label(ax, "c", "nearness to $μ^*$", "smallest tilt $φ_c$ (rad)", y)
    style.decades(ax.xaxis, ax.yaxis)
    ax.legend(loc="upper left")


def _difference_law() -> Array:
    """c₁ and c₀ of 1 − |T|/(μ*N) = φ_c (c₁ ln φ_c + c₀), fitted to the smaller tilts."""
    min_tilt, difference = (values[2:7] for values in _differences())
    return np.polyfit(np.log(min_tilt), difference / min_tilt, 1)


@cache
def _differences() -> tuple[Array, Array]:
    motions = [setting.motion(NoSlip(), float(sideways)) for sideways in NEARER]
    ratios = np.array([ratio_at_smallest_tilt(motion) for motion in motions])
    min_tilts = np.array([motion.turns[0].min_tilt for motion in motions])
    return min_tilts, 1.0 - ratios / needed_friction(setting.CAN)


def _caption() -> str:
    min_tilt, difference = _differences()
    peak = setting.motion(NoSlip()).normal_force.max()
    return (
        "Friction over normal force for the rolling can. The paper shows that the ratio stays "
        f"finite although the forces do not (N reaches {peak:.0f} N at ε = 0.005 rad/s); it gives "
        "no formula. The ratio tends to μ* = mHR/(A+mH²) = "
        f"{needed_friction(setting.CAN):.5f} and keeps that value throughout the near-collision, "
        "for longer (in units of φ<sub>c</sub>/ω) if ε is smaller. At the smallest tilt the "
        "difference falls like φ<sub>c</sub> ln φ<sub>c</sub> (two constants fitted), to "
        f"{difference[-1]:.0e} of μ* at φ<sub>c</sub> = {min_tilt[-1]:.0e} rad."
    ).replace("e-", "e−")


def _numbers() -> dict[str, object]:
    min_tilt, difference = _differences()
    return {
        "needed_friction": needed_friction(setting.CAN),
        "sideways": NEARER,
        "min_tilt": min_tilt,
        "relative_difference": difference,
        "difference_law": _difference_law(),
        "peak_ratio": [
            float(setting.motion(NoSlip(), sideways).friction_ratio.max()) for sideways in SHOWN
        ],
    }
