"""The paper's histogram, computed: its can flicked by a symmetric hand, and by one that twists."""

from __future__ import annotations

import math
from dataclasses import asdict, dataclass, replace
from functools import cache

import numpy as np

from rimroll.experiment.histogram import falls_figure
from rimroll.experiment.release import Release
from rimroll.experiment.toppling import FALLING, counted, let_go
from rimroll.laws import Coulomb
from rimroll.many.falls import Falls
from rimroll.paper import setting
from rimroll.paper.drawing import Drawing, Table
from rimroll.paper.setting import MEASURED

LAW = Coulomb(0.12)
"""About what a fit of the measured means and spreads gives (docs/friction-from-falls.md)."""

HANDS = {"an even hand": 0.0, "a hand that twists": -0.5}
"""Mean twist, rad/s: none, or one that gives the measured difference of left and right."""

TRIALS = 4000


@dataclass(frozen=True)
class Side:
    """The falls to one side: mean turn and standard deviation, degrees, and the fraction of all."""

    mean: float
    deviation: float
    share: float


def draw() -> Drawing:
    """Where the can falls, flicked by both hands."""
    falls = {hand: flicked(twist) for hand, twist in HANDS.items()}
    figure = falls_figure(falls, name=f"can_2007, friction {LAW.friction:g}")
    numbers: dict[str, object] = {
        hand.replace(" ", "_"): {side: asdict(one) for side, one in sides(twist).items()}
        for hand, twist in HANDS.items()
    }
    return Drawing("falls", "The histogram, computed", figure, _caption(), numbers, _table())


@cache
def flicked(twist: float) -> Falls:
    """The can, flicked as the paper may have flicked it, with a mean twist (rad/s)."""
    release = Release.named("paper", setting.CAN, setting.GRAVITY)
    release = replace(release, twist=(twist, release.twist[1]))
    options = replace(FALLING, gravity=setting.GRAVITY)
    return let_go(setting.CAN, LAW, TRIALS, release, 1, options)


def sides(twist: float) -> dict[str, Side]:
    """Falls to the left and to the right."""
    directions, _ = counted(flicked(twist))
    left = np.degrees(directions[directions > math.pi])
    right = 360.0 - np.degrees(directions[directions <= math.pi])
    return {
        side: Side(float(turns.mean()), float(turns.std(ddof=1)), len(turns) / directions.size)
        for side, turns in (("left", left), ("right", right))
    }


def _caption() -> str:
    twisting = sides(HANDS["a hand that twists"])
    return (
        f"{TRIALS} flicks of the can by each of two hands, from 20° ± 2° at 5 ± 0.35 rad/s, with "
        "sideways and twisting rates that scatter by 0.5 rad/s, on a table with dry friction "
        f"μ = {LAW.friction:g}; beside the paper’s measurements (mean ± s.d.). A symmetric hand "
        "makes two humps that are mirror images. One that on average twists the can clockwise by "
        f"{-HANDS['a hand that twists']:g} rad/s gives the measured difference, and sends only "
        f"{100.0 * twisting['left'].share:.0f} % of the falls to the left; the paper does not say "
        "how the 42 falls were split. The scatter of the hand was chosen so that the falls spread "
        "about as much as the measured ones; then μ and the twist follow from the means."
    )


def _table() -> Table:
    rows = [
        [hand, *(_shown(sides(twist)[side]) for side in ("left", "right"))]
        for hand, twist in HANDS.items()
    ]
    measured = [f"{turn:.1f} ± {deviation:.1f}" for turn, deviation in MEASURED]
    return Table(
        "Angles of turn, degrees, mean ± s.d. and fraction of all falls",
        ["", "to the left", "to the right"],
        [*rows, ["measured", *measured]],
    )


def _shown(side: Side) -> str:
    return f"{side.mean:.1f} ± {side.deviation:.1f}, {100.0 * side.share:.0f} %"
