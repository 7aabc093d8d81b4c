"""The theory that the paper rejects, computed: collisions with an imperfection of the rim."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from numpy.typing import NDArray

from rimroll.figures import style
from rimroll.laws import Frictionless, Law, NoSlip
from rimroll.motion import Array
from rimroll.paper import setting
from rimroll.paper.drawing import Drawing, Table
from rimroll.paper.setting import MEASURED
from rimroll.theory.closed_forms import lift_off_rate
from rimroll.theory.imperfection import ImperfectRim, imperfect_rim

TRIALS = 42
"""Falls in the paper's histogram."""

NEAR = 20.0
"""No fall is within this distance of 180°, degrees, by the measured means and s.d."""

PLACES = np.arange(0.025, 360.0, 0.05)
"""β, degrees: evenly round the rim, which stands for uniformly at random."""

BINS = np.arange(120.0, 241.0, 5.0)

DASHES = {"no_slip": "-", "frictionless": (0, (5, 1.2))}

Chosen = NDArray[np.bool_]

ANYWHERE: Chosen = PLACES > 0.0


@dataclass(frozen=True)
class Spread:
    """The distribution of falls: distance from 180° (mean and s.d., degrees), and the fraction near
    it."""

    mean: float
    deviation: float
    near: float

    @property
    def chance_of_none_near(self) -> float:
        """The chance that none of as many falls as were measured is near 180°."""
        return float((1.0 - self.near) ** TRIALS)


def draw() -> Drawing:
    """Direction of fall and energy loss against the imperfection's place, and all directions."""
    with style.figure_style():
        figure = style.page(78.0)
        left, middle, right = figure.subplots(1, 3, width_ratios=(1.25, 0.8, 1.1))
        _draw_directions(left)
        _draw_falls(middle, left)
        _draw_losses(right)
        style.settle(figure)
    return Drawing(
        "imperfection",
        "What an imperfect rim would do instead",
        figure,
        _caption(),
        {law.name: _numbers(law) for law in setting.LAWS},
        _table(),
    )


@cache
def falls(law: Law) -> tuple[ImperfectRim, ...]:
    """The can on an imperfection at each of the places; computed once."""
    return tuple(imperfect_rim(setting.CAN, angle, law) for angle in np.radians(PLACES))


def directions(law: Law) -> Array:
    """Where the can falls, degrees from where it leaned."""
    turns: Array = np.array([fall.turn for fall in falls(law)], dtype=float)
    return turns * (180.0 / np.pi)


def first_directions(law: Law) -> Array:
    """Where the first collision alone lets the can lean, degrees."""
    leans: Array = np.array([fall.collisions[0].lean_azimuth for fall in falls(law)], dtype=float)
    return leans * (180.0 / np.pi)


def kept(law: Law) -> Array:
    """The fraction of the energy that is left."""
    return np.array([fall.energy_kept_fraction for fall in falls(law)])


def spread(law: Law, chosen: Chosen) -> Spread:
    """The falls from imperfections at the places chosen."""
    off = np.abs(directions(law)[chosen] - 180.0)
    return Spread(float(off.mean()), float(off.std()), float(np.mean(off < NEAR)))


def lossless_flick(law: Law) -> float:
    """The rate of tipping on arrival, rad/s, whose energy J'ω²/2 lifts the can over its rim."""
    can = setting.CAN
    inertia = can.transverse_inertia + can.mass * can.radius**2
    if law == NoSlip():
        inertia += can.mass * can.height**2
    lift = np.hypot(can.radius, can.height) - can.height
    return float(np.sqrt(2.0 * can.mass * setting.GRAVITY * lift / inertia))


def fastest_flick(law: Law) -> float:
    """The rate of tipping on arrival, rad/s, above which the rim leaves the table before."""
    if law == NoSlip():
        return float(lift_off_rate(setting.CAN, setting.GRAVITY))
    return float(np.sqrt(setting.GRAVITY / setting.CAN.height))


def topples(law: Law) -> Chosen:
    """The places of imperfections after which some flick has enough energy to topple the can."""
    return lossless_flick(law) / np.sqrt(kept(law)) < fastest_flick(law)


def _draw_directions(ax: Axes) -> None:
    _draw_measured_bands(ax)
    for law in setting.LAWS:
        color = law.color
        ax.plot(PLACES, first_directions(law), color=color, lw=0.7, ls=":")
        name = setting.LAW_NAMES[law.name]
        ax.plot(PLACES, directions(law), color=color, ls=DASHES[law.name], label=name)
    x, y = "place of the imperfection $β$ (degrees)", "direction of fall (degrees)"
    style.label(ax, "a", "where the can falls", x, y)
    ax.set_xlim(0.0, 360.0)
    ax.set_xticks(np.arange(0.0, 361.0, 90.0))
    ax.set_ylim(BINS[0], BINS[-1])
    ax.plot([], [], color=style.CONTRAST, lw=0.7, ls=":", label="first collision only")
    ax.legend(loc="upper right", bbox_to_anchor=(1.0, 1.02))


def _draw_measured_bands(ax: Axes) -> None:
    ax.axhline(180.0, color=style.CONTRAST, lw=0.6, ls=":", zorder=0)
    for (mean, deviation), side in zip(MEASURED, (1.0, -1.0), strict=True):
        center = 180.0 + side * (mean - 180.0)
        low, high = center - deviation, center + deviation
        ax.axhspan(low, high, color=style.MEASURED, alpha=0.25, lw=0.0, zorder=0)


def _draw_falls(ax: Axes, directions_ax: Axes) -> None:
    ax.sharey(directions_ax)
    ax.tick_params(labelleft=False)
    angle = np.linspace(BINS[0], BINS[-1], 601)
    bell = np.zeros_like(angle)
    for (mean, deviation), side in zip(MEASURED, (1.0, -1.0), strict=True):
        off = (angle - 180.0 - side * (mean - 180.0)) / deviation
        bell += 0.5 * np.exp(-0.5 * off**2) / (deviation * np.sqrt(2.0 * np.pi))
    share = 100.0 * (BINS[1] - BINS[0])
    ax.fill_betweenx(angle, share * bell, color=style.MEASURED, alpha=0.25, lw=0.0)
    ax.plot(share * bell, angle, color=style.MEASURED, lw=0.9)
    for law in setting.LAWS:
        count, _ = np.histogram(directions(law), BINS)
        look: dict[str, Any] = {"color": law.color, "ls": DASHES[law.name]}
        ax.stairs(100.0 * count / PLACES.size, BINS, orientation="horizontal", lw=1.1, **look)
    style.label(ax, "b", "imperfection anywhere", "falls (% per 5°)", "")
    ax.set_xlim(0.0, 32.0)
    ax.text(31.0, 222.5, "measured", color=style.MEASURED, ha="right", size=6.8)


def _draw_losses(ax: Axes) -> None:
    for law in setting.LAWS:
        color = law.color
        first = np.array([fall.collisions[0].energy_kept_fraction for fall in falls(law)])
        ax.plot(PLACES, 100.0 * (1.0 - first), color=color, lw=0.7, ls=":")
        ax.plot(PLACES, 100.0 * (1.0 - kept(law)), color=color, ls=DASHES[law.name])
    x = "place of the imperfection $β$ (degrees)"
    style.label(ax, "c", "energy lost", x, "lost in collisions (%)")
    ax.set_xlim(0.0, 360.0)
    ax.set_xticks(np.arange(0.0, 361.0, 90.0))
    ax.set_ylim(0.0, 100.0)


def _caption() -> str:
    rolling, sliding = (_Extremes.of(law) for law in setting.LAWS)
    anywhere = spread(Frictionless(), ANYWHERE)
    left, right = (mean - 180.0 for mean, _ in MEASURED)
    lifts = fastest_flick(Frictionless()) / lossless_flick(Frictionless())
    return (
        "The paper’s can falling exactly face down on a rim with one small imperfection, in "
        "plastic collisions, followed until it rises again (dotted: until the first collision, "
        "where the paper’s sketch of this theory ends: at most "
        f"{_farthest(first_directions(Frictionless())):.1f}° off 180°). Wherever the imperfection "
        f"is, the can falls at most {rolling.off:.1f}° (no slip) or {sliding.off:.1f}° (no "
        f"friction) off 180°, less than the measured means, {left:.1f}° and {right:.1f}° (green: "
        f"one s.d.). With an imperfection anywhere it falls within {NEAR:.0f}° of 180° always (no "
        f"slip) or in {100.0 * anywhere.near:.0f} % of the trials (no friction); that none of "
        f"{TRIALS} would has, even without friction, a chance of "
        f"{style.plain(anywhere.chance_of_none_near)}. At least "
        f"{rolling.lost:.0f} % or {sliding.lost:.0f} % of the energy is lost: to topple, the can "
        f"must arrive {rolling.slowest:.2f} to {rolling.fastest:.2f} times as fast as one that "
        f"rolls round, or {sliding.slowest:.2f} to {sliding.fastest:.2f} times, where from "
        f"{lifts:.2f} times on it lifts off first. The paper’s other candidate, the whole base "
        "slapping the table at once, cannot be computed: rigid-body mechanics does not say where "
        "its impulse acts."
    )


def _farthest(directions: Array) -> float:
    return float(np.abs(directions - 180.0).max())


@dataclass(frozen=True)
class _Extremes:
    """Over all places: farthest off 180° (degrees), least loss (%), toppling flicks (1)."""

    off: float
    lost: float
    slowest: float
    fastest: float

    @classmethod
    def of(cls, law: Law) -> _Extremes:
        left = kept(law)
        return cls(
            off=_farthest(directions(law)),
            lost=float(100.0 * (1.0 - left.max())),
            slowest=float(1.0 / np.sqrt(left.max())),
            fastest=float(1.0 / np.sqrt(left.min())),
        )


def _numbers(law: Law) -> dict[str, object]:
    off = np.abs(directions(law) - 180.0)
    lost = 1.0 - kept(law)
    flick = lossless_flick(law) / np.sqrt(kept(law))
    anywhere = spread(law, ANYWHERE)
    return {
        "largest_deviation": np.radians(off.max()),
        "largest_deviation_at": np.radians(PLACES[off.argmax()]),
        "largest_deviation_after_first_collision": np.radians(_farthest(first_directions(law))),
        "part_near_180": anywhere.near,
        "chance_of_none_near_180": anywhere.chance_of_none_near,
        "energy_lost_least_mean_most": [lost.min(), lost.mean(), lost.max()],
        "toppling_flick_lossless": lossless_flick(law),
        "toppling_flick_least_most": [flick.min(), flick.max()],
        "flick_that_lifts_off": fastest_flick(law),
        "part_that_can_topple": np.mean(topples(law)),
        "largest_deviation_that_can_topple": np.radians(off[topples(law)].max()),
    }


def _table() -> Table:
    opposite = np.abs(PLACES - 180.0) < 90.0
    rows = [
        [name, setting.LAW_NAMES[law.name], *_cells(spread(law, chosen))]
        for name, places in (
            ("anywhere on the rim", (ANYWHERE, ANYWHERE)),
            ("anywhere on the half opposite to A", (opposite, opposite)),
            ("anywhere, and the can topples", tuple(topples(law) for law in setting.LAWS)),
        )
        for law, chosen in zip(setting.LAWS, places, strict=True)
    ]
    means = " and ".join(f"{mean - 180.0:.1f} ± {deviation}" for mean, deviation in MEASURED)
    head = [
        "imperfection",
        "",
        "off 180° (degrees)",
        "within 20° of it (%)",
        "chance of none in 42",
    ]
    caption = (
        "Falls to either side of 180°, mean ± s.d., from imperfections at random places. The can "
        "topples when some flick that does not lift it off beforehand leaves it the energy."
    )
    return Table(caption, head, [["measured", "", means, "", ""], *rows])


def _cells(falls: Spread) -> list[str]:
    chance = falls.chance_of_none_near
    return [
        f"{falls.mean:.1f} ± {falls.deviation:.1f}",
        f"{100.0 * falls.near:.0f}",
        style.plain(chance) if chance > 0.0 else "0",
    ]
