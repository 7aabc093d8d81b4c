"""How fast motions approach the limiting angle of turn: like ε ln ε, at a cost like ln 1/ε."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from matplotlib.axes import Axes

from rimroll.figures import style
from rimroll.figures.style import superscript
from rimroll.laws import Law
from rimroll.motion import Array
from rimroll.paper import setting
from rimroll.paper.drawing import Drawing, Table
from rimroll.theory.approximations import composite
from rimroll.theory.closed_forms import error_law_coefficient, turn_limit

SIDEWAYS = np.array([float(f"1e-{power}") for power in range(1, 13)])
"""ψ̇ = θ̇ = ε at the release, rad/s."""

FITTED = 5
"""The start to which a is fitted, ε = 1e-6: above it the law is less accurate, below it rounding
matters."""


@dataclass(frozen=True)
class Approach:
    """Turn − limit (rad), smallest tilt (rad) and steps for each ε, and the law through them."""

    law: Law
    excess: Array
    min_tilt: Array
    steps: Array
    b: float
    a: float

    def predicted(self, min_tilt: Array) -> Array:
        """φ_c (b ln φ_c + a), rad."""
        return min_tilt * (self.b * np.log(min_tilt) + self.a)


def approach(law: Law) -> Approach:
    """Follow the can from ever smaller sideways pushes; b is theory, a fits one of them."""
    motions = [setting.motion(law, float(sideways)) for sideways in SIDEWAYS]
    turns = [motion.turns[1] for motion in motions]
    excess = np.array([abs(turn.angle) for turn in turns]) - turn_limit(setting.CAN, law)
    min_tilt = np.array([turn.min_tilt for turn in turns])
    steps = np.array([float(motion.stats.steps) for motion in motions])
    rate = composite(setting.CAN, setting.start(), law, setting.GRAVITY).tipping_rate
    b = error_law_coefficient(setting.CAN, law, rate, setting.GRAVITY)
    a = float(excess[FITTED] / min_tilt[FITTED] - b * np.log(min_tilt[FITTED]))
    return Approach(law, excess, min_tilt, steps, b, a)


def draw() -> Drawing:
    """Turn − limit against ε, the straight line of the law, and the cost."""
    approaches = [approach(law) for law in setting.LAWS]
    with style.figure_style():
        figure = style.page(74.0)
        left, middle, right = figure.subplots(1, 3, width_ratios=(1.15, 1.15, 0.8))
        _draw_errors(left, approaches)
        _draw_slopes(middle, approaches)
        _draw_cost(right, approaches)
        style.settle(figure)
    return Drawing(
        "convergence",
        "The approach to the limit",
        figure,
        _caption(approaches),
        {one.law.name: _numbers(one) for one in approaches},
        _table(approaches),
    )


def _draw_errors(ax: Axes, approaches: list[Approach]) -> None:
    for one in approaches:
        name, scale = setting.LAW_NAMES[one.law.name], one.min_tilt[-1] / SIDEWAYS[-1]
        ax.loglog(SIDEWAYS, one.excess, ls="none", label=name, **style.look(one.law))
        fine = np.geomspace(SIDEWAYS[-1], SIDEWAYS[0], 60)
        ax.loglog(fine, one.predicted(scale * fine), color=style.THEORY, lw=0.8, zorder=1)
    ax.plot([], [], color=style.THEORY, lw=0.8, label="$φ_c (b\\,\\ln φ_c + a)$")
    style.label(ax, "a", "turn − limit", "sideways push $ε$ (rad/s)", "turn − limit (rad)")
    ax.set_xticks(10.0 ** np.arange(-12, 0, 3))
    ax.set_yticks(10.0 ** np.arange(-12, 0, 3))
    style.decades(ax.xaxis, ax.yaxis)
    ax.legend(loc="upper left")


def _draw_slopes(ax: Axes, approaches: list[Approach]) -> None:
    for one in approaches:
        x = np.log(one.min_tilt)
        ax.plot(x, one.excess / one.min_tilt, ls="none", **style.look(one.law))
        ax.plot(x, one.b * x + one.a, color=style.THEORY, lw=0.8, zorder=1)
        power = np.log(one.excess[1] / one.excess[0]) / np.log(one.min_tilt[1] / one.min_tilt[0])
        guess = one.excess[0] * (one.min_tilt / one.min_tilt[0]) ** power / one.min_tilt
        ax.plot(x, guess, color=style.CONTRAST, ls=":", lw=1.2, zorder=0)
    ax.plot([], [], color=style.THEORY, lw=0.8, label="$b\\,\\ln φ_c + a$")
    ax.plot([], [], color=style.CONTRAST, ls=":", lw=1.2, label="power laws through ε = 0.1, 0.01")
    style.label(ax, "b", "no power law", "ln $φ_c$ (1)", "(turn − limit)/$φ_c$ (1)")
    ax.set_ylim(0.0, 1.15 * max(float((one.excess / one.min_tilt).max()) for one in approaches))
    ax.legend(loc="lower left")


def _draw_cost(ax: Axes, approaches: list[Approach]) -> None:
    for one in approaches:
        ax.semilogx(SIDEWAYS, one.steps, lw=0.7, **style.look(one.law))
    style.label(ax, "c", "cost", "sideways push $ε$ (rad/s)", "steps of the solver in 2 s (1)")
    ax.set_xticks(10.0 ** np.arange(-12, 0, 3))
    style.decades(ax.xaxis)
    ax.set_ylim(0.0, None)


def _caption(approaches: list[Approach]) -> str:
    first, last = SIDEWAYS[0], SIDEWAYS[-1]
    laws = " and ".join(
        f"{one.b:.4f} ({setting.LAW_NAMES[one.law.name]})".replace("-", "−") for one in approaches
    )
    nearest = max(float(abs(one.excess[-1])) for one in approaches)
    steps = " or ".join(f"{_steps_per_decade(one):.0f}" for one in approaches)
    smallest, fitted = (style.power_of_ten(float(value)) for value in (last, SIDEWAYS[FITTED]))
    return (
        f"Turn from tilt maximum to tilt maximum minus its limit, for the paper’s start with "
        f"ψ̇ = θ̇ = ε from {first:g} to {smallest} rad/s, where {nearest:.1e} rad is left. "
        "The paper states the limit; the law of approach is φ<sub>c</sub>(b ln φ<sub>c</sub> + a), "
        f"its slope b = {laws} in closed form and only a fitted, to the one point ε = {fitted}. "
        "No power of ε does it (b, dotted). "
        f"A tenfold smaller ε costs {steps} more steps for every ε (c)."
    ).replace("e-", "e−")


def _steps_per_decade(one: Approach) -> float:
    return float(np.polyfit(-np.log10(SIDEWAYS), one.steps, 1)[0])


def _numbers(one: Approach) -> dict[str, object]:
    return {
        "sideways": SIDEWAYS,
        "turn_minus_limit": one.excess,
        "min_tilt": one.min_tilt,
        "steps": one.steps,
        "b": one.b,
        "a_fitted": one.a,
        "b_fitted": float(np.polyfit(np.log(one.min_tilt), one.excess / one.min_tilt, 1)[0]),
        "steps_per_decade": _steps_per_decade(one),
        "law_minus_turn": one.predicted(one.min_tilt) - one.excess,
    }


def _table(approaches: list[Approach]) -> Table:
    head = ["ε (rad/s)"]
    for one in approaches:
        name = setting.LAW_NAMES[one.law.name]
        head += [f"φc, {name} (rad)", "turn − limit (rad)", "by the law (rad)", "steps"]
    rows = []
    for k, sideways in enumerate(SIDEWAYS):
        row = [f"10{superscript(round(np.log10(sideways)))}"]
        for one in approaches:
            law = one.predicted(one.min_tilt)[k]
            row += [f"{one.min_tilt[k]:.4e}", f"{one.excess[k]:.5e}", f"{law:.5e}"]
            row.append(f"{one.steps[k]:.0f}")
        rows.append([cell.replace("-", "−") for cell in row])
    return Table("The can’s turn and the law of its approach to the limit.", head, rows)
