"""The angle of turn against friction: what lies between no slip and no friction.

The near-collision by itself comes from :func:`rimroll.turn_limit`, where ε → 0 exactly; whole
motions, from the release to the next tilt maximum or to the fall, are simulated.
"""

from __future__ import annotations

from contextlib import suppress
from dataclasses import dataclass
from functools import cache
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from scipy.optimize import brentq

from rimroll.errors import RimrollError
from rimroll.figures import style
from rimroll.laws import Coulomb, Frictionless, NoSlip
from rimroll.motion import Array, Motion, simulate
from rimroll.paper import setting
from rimroll.paper.drawing import Drawing, Table
from rimroll.paper.setting import MEASURED
from rimroll.state import State
from rimroll.theory.closed_forms import Arrival, arrival, needed_friction, passage, turn_limit

NEEDED = needed_friction(setting.CAN)
"""μ*, the smallest friction with which the can rolls through."""

FRICTIONS = np.unique(np.append(np.round(np.linspace(0.0, 0.5, 51), 3), NEEDED + 1e-12))
"""Where the curves are drawn: evenly, and where rolling begins."""

CHECKED = np.round(np.linspace(0.0, 0.5, 11), 3)
"""Frictions of the table, and of the whole motions whose near-collisions are measured."""

CLOSE, CLOSEST = 1e-5, 1e-6
"""Sideways rates ε of whole motions (rad/s): of those drawn, of those measured for their step."""

LYING = 1.5
"""The tilt at which the direction of a fall is taken, rad."""

TILTS = np.concatenate([[0.5], np.arange(2.5, 36.0, 2.5)])
RATES = -np.concatenate([np.arange(0.0, 6.0, 0.5), np.arange(6.0, 9.3, 0.2)])
"""Starts whose needed friction is drawn: degrees, below the balance point, and rad/s."""

INK = "#00705A"
"""Colour of texts about measurements: their green, dark enough to read."""


@dataclass(frozen=True)
class Start:
    """A start of the can: tilt in degrees, tilt rate in rad/s, and its style."""

    tilt: float
    tilt_rate: float
    color: str
    dashes: Any
    marker: str

    @property
    def name(self) -> str:
        """The name in a legend."""
        return f"{self.tilt:g}°, {self.tilt_rate:g} rad/s".replace("-", "−")

    @property
    def marks(self) -> dict[str, Any]:
        """The style of its points."""
        return {"marker": self.marker, "color": self.color, "mfc": "white", "ls": "none"}

    def state(self, sideways: float = 0.0) -> State:
        """The start with ψ̇ = θ̇ = ``sideways``, rad/s."""
        rates = {"yaw_rate": sideways, "spin_rate": sideways}
        return State(tilt=np.radians(self.tilt), tilt_rate=self.tilt_rate, **rates)

    def arrival(self, friction: float) -> Arrival:
        """How it comes down on the table, ε → 0."""
        return arrival(setting.CAN, self.state(), Coulomb(friction), setting.GRAVITY)


ROCKED = Start(30.0, -0.5, style.NO_SLIP, (0, (5, 1.5)), "o")
"""The paper's own start: the can rises and rocks back."""

FLICKED = Start(20.0, -4.5, style.FRICTIONLESS, (0, (5, 1, 1, 1)), "s")
"""A flick: the can falls over on the other side."""

STARTS = (ROCKED, FLICKED)


def near_collision(friction: float, start: Start | None = None) -> float:
    """Limiting turn of the near-collision, degrees; at rest on its rim if no start is given."""
    arriving = None if start is None else start.arrival(friction)
    return float(np.degrees(turn_limit(setting.CAN, Coulomb(friction), arriving)))


@cache
def motion(friction: float, start: Start, sideways: float = CLOSE) -> Motion:
    """The whole motion, with the first rise in it or until the can lies on its side."""
    return simulate(
        setting.CAN,
        start.state(sideways),
        Coulomb(friction),
        0.75,
        gravity=setting.GRAVITY,
        topple_tilt=LYING,
    )


def whole_turn(friction: float, start: Start) -> float:
    """Turn from the release to the next tilt maximum, or to the fall, degrees."""
    one = motion(friction, start)
    turned = one.turns[0].angle if one.turns else one.yaw[-1] - one.yaw[0]
    return float(np.degrees(abs(turned)))


def measured_step(one: Motion) -> float:
    """Turn of a motion's first near-collision, degrees, without the parts before and after.

    The yaw between equal tilts δ = φ_c^(2/3) falling and rising, far outside the near-collision
    and far below the whole motion. Out there nothing but the tilt acts on w = ψ̇ sin φ: w ~ 1/φ,
    and each of the two tails still turns by |w/φ̇|, except for the effect of gravity, of order δ.
    """
    low = next(event for event in one.events if event.kind == "tilt_min")
    tilt = float(np.cbrt(low.state.tilt) ** 2)

    def excess(t: float) -> float:
        return float(one.evaluate(t).tilt[0]) - tilt

    ends = (brentq(excess, 0.0, low.t, xtol=1e-16), brentq(excess, low.t, low.t + 0.05, xtol=1e-16))
    there = one.evaluate(np.array(ends))
    tails = np.abs(there.yaw_rate * np.sin(there.tilt) / there.tilt_rate)
    return float(np.degrees(abs(there.yaw[1] - there.yaw[0]) + tails.sum()))


@cache
def friction_for(turn: float, start: Start | None = None) -> float:
    """The friction with which the near-collision turns the can by an angle, degrees."""
    found = brentq(lambda friction: near_collision(friction, start) - turn, 0.0, NEEDED, xtol=1e-7)
    return float(found)


@cache
def friction_for_fall(turn: float) -> tuple[float, ...]:
    """The frictions with which the flicked can falls over at an angle from its start, degrees."""
    roots = []
    for k in np.flatnonzero(np.diff(np.sign(whole_turns(FLICKED) - turn))):
        ends = float(FRICTIONS[k]), float(FRICTIONS[k + 1])
        roots.append(float(brentq(lambda mu: whole_turn(mu, FLICKED) - turn, *ends, xtol=1e-6)))
    return tuple(roots)


def draw() -> Drawing:
    """The step, the whole turn, the friction that starts need, and spin and losses afterwards."""
    with style.figure_style():
        figure = style.page(142.0)
        (step, whole), (need, left) = figure.subplots(2, 2, height_ratios=(1.25, 1.0))
        _draw_steps(step)
        _draw_whole_turns(whole)
        _draw_needs(need)
        _draw_leftovers(left)
        style.settle(figure)
    return Drawing(
        "turn_against_friction",
        "The angle of turn against friction",
        figure,
        _caption(),
        _numbers(),
        table(),
    )


@cache
def steps(start: Start | None = None) -> Array:
    """Limiting turns of the near-collision at :data:`FRICTIONS`, degrees."""
    return np.array([near_collision(float(friction), start) for friction in FRICTIONS])


@cache
def whole_turns(start: Start) -> Array:
    """Whole turns at :data:`FRICTIONS`, degrees."""
    return np.array([whole_turn(float(friction), start) for friction in FRICTIONS])


@cache
def checks(start: Start) -> Array:
    """Near-collisions measured in whole motions at :data:`CHECKED`, degrees."""
    motions = [motion(float(friction), start, CLOSEST) for friction in CHECKED]
    return np.array([measured_step(one) for one in motions])


def _draw_steps(ax: Axes) -> None:
    _draw_frame(ax)
    ax.plot(FRICTIONS, steps(), color=style.THEORY, label="with its rim at rest")
    for start in STARTS:
        name = f"let go at {start.name}"
        ax.plot(FRICTIONS, steps(start), color=start.color, ls=start.dashes, label=name)
        ax.plot(CHECKED, checks(start), clip_on=False, zorder=4, **start.marks)
    title = "the near-collision alone, $ε$ → 0"
    style.label(ax, "a", title, "friction $μ$ (1)", "angle of turn (degrees)")
    ax.legend(loc="upper right", title="the can comes down", title_fontsize=6.8)


def _draw_whole_turns(ax: Axes) -> None:
    _draw_frame(ax)
    for start, until in zip(STARTS, ("next tilt maximum", "fall on its side"), strict=True):
        ax.plot(FRICTIONS, steps(start), color=start.color, lw=0.8, ls=":")
        name = f"{start.name}, to the {until}"
        ax.plot(FRICTIONS, whole_turns(start), color=start.color, ls=start.dashes, label=name)
    ax.plot([], [], color="#333333", lw=0.8, ls=":", label="the near-collision alone, from (a)")
    title = "from the release on"
    style.label(ax, "b", title, "friction $μ$ (1)", "angle of turn (degrees)")
    ax.legend(loc="upper right")


def _draw_frame(ax: Axes) -> None:
    """The measured turns as bands, the two closed forms, and μ*."""
    for (mean, spread), side in zip(MEASURED, ("leftward", "rightward"), strict=True):
        ax.axhspan(mean - spread, mean + spread, color=style.MEASURED, alpha=0.12, lw=0)
        ax.axhline(mean, color=style.MEASURED, lw=0.8, zorder=1)
        text = f"measured, {side}: {mean}° ± {spread}°"
        ax.text(0.497, mean + 0.25, text, ha="right", va="bottom", size=6.3, color=INK)
    for law, away, align in ((NoSlip(), -0.35, "top"), (Frictionless(), 0.35, "bottom")):
        limit = float(np.degrees(turn_limit(setting.CAN, law)))
        ax.axhline(limit, color=style.CONTRAST, lw=0.7, ls=":", zorder=0)
        text = f"{setting.LAW_NAMES[law.name]}: {limit:.2f}°"
        ax.text(0.005, limit + away, text, va=align, size=6.8, color="#555555")
    ax.axvline(NEEDED, ymax=0.77, color=style.CONTRAST, lw=0.7, ls="--", zorder=0)
    ax.text(NEEDED + 0.006, 200.6, f"$μ^*$ = {NEEDED:.4f}", size=6.8, color="#555555")
    ax.set_xlim(0.0, 0.5)
    ax.set_ylim(200.0, 229.0)


@cache
def needs() -> Array:
    """Friction that each start's tipping phase needs to roll, (rates, tilts); inf: it lifts off."""
    table = np.full((len(RATES), len(TILTS)), np.inf)
    for i, rate in enumerate(RATES):
        for k, tilt in enumerate(TILTS):
            start = State(tilt=np.radians(tilt), tilt_rate=float(rate))
            with suppress(RimrollError):
                down = arrival(setting.CAN, start, NoSlip(), setting.GRAVITY)
                table[i, k] = down.friction_ratio
    return table


def _draw_needs(ax: Axes) -> None:
    where = TILTS, -RATES, np.minimum(needs(), 100.0)
    ax.contourf(*where, [0.0, NEEDED, 200.0], colors=["#E3EEF6", "#F8E8DE"])
    lines = ax.contour(*where, [0.15, 0.2, 0.25, 0.3], colors=style.NO_SLIP, linewidths=0.8)
    ax.clabel(
        lines, fontsize=6.3, inline_spacing=2, manual=[(28, 5.2), (26, 3.7), (15, 3), (8, 2.2)]
    )
    ax.contour(*where, [NEEDED], colors=style.THEORY, linewidths=1.3)
    for start in STARTS:
        ax.plot(start.tilt, -start.tilt_rate, ms=5.0, **start.marks)
    ax.text(17.5, 8.75, "more than $μ^*$", ha="center", va="center", size=6.8)
    ax.text(1.6, 8.75, "$μ^*$", va="center", ha="left", size=6.8)
    title = "friction that rolling down needs"
    x, y = "tilt at the release (degrees)", "tilt rate, downward (rad/s)"
    style.label(ax, "c", title, x, y)
    ax.set_xlim(TILTS[0], 35.0)
    ax.set_ylim(0.0, -RATES[-1])


@cache
def leftovers(start: Start | None = None) -> tuple[Array, Array]:
    """Spin s/ω and fraction of the energy lost in the near-collision, at :data:`FRICTIONS`."""
    spins, losses = [], []
    for friction in map(float, FRICTIONS):
        arriving = Arrival() if start is None else start.arrival(friction)
        left = passage(setting.CAN, Coulomb(friction), arriving)
        spins.append(left.axial_spin / arriving.tipping_rate)
        losses.append(left.energy_lost_fraction)
    return np.array(spins), np.array(losses)


def _draw_leftovers(ax: Axes) -> None:
    for start, dashes in ((None, "-"), *((start, start.dashes) for start in STARTS)):
        color = style.THEORY if start is None else start.color
        spins, losses = leftovers(start)
        ax.plot(FRICTIONS, spins, color=color, ls=dashes)
        ax.plot(FRICTIONS, losses, color=color, ls=dashes, lw=0.6)
    ax.axvline(NEEDED, color=style.CONTRAST, lw=0.7, ls="--", zorder=0)
    ax.text(0.23, 0.225, "spin $s$/$ω$", size=6.8)
    ax.text(0.23, 0.007, "energy lost", size=6.8, ha="right")
    style.label(
        ax,
        "d",
        "what friction leaves behind",
        "friction $μ$ (1)",
        "$s$/$ω$; part of the energy (1)",
    )
    ax.set_xlim(0.0, 0.5)
    ax.set_ylim(0.0, 0.28)


def _caption() -> str:
    left, right = (mean for mean, _ in MEASURED)
    rest = [friction_for(mean) for mean in (left, right)]
    most = [friction_for(mean, ROCKED) for mean in (left, right)]
    (fall_left,), (fall_right,) = (friction_for_fall(mean) for mean in (left, right))
    return (
        "Dry friction (Coulomb) between the paper’s two limits, which it leaves open, for its can. "
        "(a) From μ* = mHR/(A+mH²) on, the near-collision turns by the no-slip angle if the rim "
        "comes down at rest, and by the frictionless one at μ = 0. Between, it depends on μ, the "
        "body and the slip on arrival, and so on the start; points are whole motions at ε = "
        f"{style.power_of_ten(CLOSEST)} rad/s. The measured means (green, ± one s.d.) lie inside: "
        f"{left}° takes μ = {rest[0]:.3f} to {most[0]:.3f}, {right}° takes {rest[1]:.3f} to "
        f"{most[1]:.3f}. Friction cannot explain the difference: no μ gives both from one start. "
        "(b) Slip leaves spin (d), so the can continues to turn as it rises; falls of the "
        f"flicked can by {left}° and {right}° take μ = {fall_left:.3f} and {fall_right:.3f}. "
        "(c) A start rolls down to the table if μ exceeds its number; from μ* on, those below the "
        "black line then turn by the no-slip angle, whatever the release."
    )


def _numbers() -> dict[str, object]:
    means = [mean for mean, _ in MEASURED]
    starts = {start.name: start for start in STARTS}
    return {
        "needed_friction": NEEDED,
        "friction": FRICTIONS,
        "near_collision_degrees": {
            "rim at rest": steps(),
            **{name: steps(start) for name, start in starts.items()},
        },
        "whole_turn_degrees": {name: whole_turns(start) for name, start in starts.items()},
        "checked_friction": CHECKED,
        "near_collision_of_whole_motions_degrees": {
            name: checks(start) for name, start in starts.items()
        },
        "measured_degrees": means,
        "friction_for_measured": {
            "rim at rest": [friction_for(mean) for mean in means],
            **{name: [friction_for(mean, one) for mean in means] for name, one in starts.items()},
            "fall": [friction_for_fall(mean) for mean in means],
        },
        "friction_that_rolling_down_needs": {
            name: arrival(setting.CAN, start.state(), NoSlip(), setting.GRAVITY).friction_ratio
            for name, start in starts.items()
        },
        "spin_left": leftovers()[0],
        "energy_lost": leftovers()[1],
    }


def table() -> Table:
    """Limiting turns and whole turns for frictions from zero to that needed for rolling."""
    rows = []
    for friction in map(float, [*CHECKED[CHECKED < NEEDED], NEEDED]):
        turns = [near_collision(friction, start) for start in (None, *STARTS)]
        turns += [whole_turn(friction, start) for start in STARTS]
        name = f"{friction:.2f}" if friction < NEEDED else f"from {NEEDED:.4f} on"
        rows.append([name, *(f"{turn:.2f}" for turn in turns)])
    rocked, flicked = (start.name for start in STARTS)
    head = ["μ", "rim at rest", rocked, flicked]
    head += [f"{rocked}, to the next tilt maximum", f"{flicked}, to the fall"]
    text = (
        "Turns in degrees: of the near-collision alone (three columns), and of whole motions from "
        f"the release on (two, at ε = {style.power_of_ten(CLOSE)} rad/s)."
    )
    return Table(text, head, rows)
