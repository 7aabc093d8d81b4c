"""The paper's schematic of a fall (``fallsequence``), drawn from a motion that was computed."""

from __future__ import annotations

from functools import cache

import numpy as np

from rimroll.figures import style
from rimroll.figures.scene.pose import turn_span
from rimroll.figures.sequence import falling_figure
from rimroll.laws import Frictionless, Law, NoSlip
from rimroll.motion import Motion, simulate
from rimroll.paper import setting
from rimroll.paper.drawing import Drawing
from rimroll.paper.setting import MEASURED
from rimroll.state import State
from rimroll.theory.closed_forms import turn_limit

FLICKED = State(tilt=np.radians(20.0), tilt_rate=-4.5, yaw_rate=0.02, spin_rate=0.02)
"""The can tipped by 20° and flicked upright, hard enough to fall over on the other side."""


@cache
def flick(law: Law) -> Motion:
    """The flicked can, until it lies on its side."""
    return simulate(setting.CAN, FLICKED, law, 2.0, gravity=setting.GRAVITY)


def draw() -> Drawing:
    """Six instants of the fall without slip, from the side and from above."""
    motion = flick(NoSlip())
    with style.figure_style():
        figure = falling_figure(motion)
    turns = {law.name: abs(turn_span(flick(law)).angle) for law in setting.LAWS}
    rolled, slid = (float(np.degrees(turns[law.name])) for law in (NoSlip(), Frictionless()))
    near = next(event for event in motion.events if event.kind == "tilt_min")
    lean, nearest = (float(np.degrees(tilt)) for tilt in (FLICKED.tilt, near.state.tilt))
    caption = (
        f"The can of the paper, tipped by {lean:.0f}°, flicked upright at "
        f"{-float(FLICKED.tilt_rate)} rad/s and followed until it lies on its side, "
        f"{motion.t[-1]:.2f} s later; from the side (top) and from above (bottom), as in the "
        "paper’s schematic. It stands on A, nearly slaps the table (within "
        f"{nearest:.3f}°), rolls round to B in no time, and falls {rolled:.1f}° from A, not "
        f"opposite. On a table without friction it would fall {slid:.1f}° from A; the paper’s "
        f"experiment found {MEASURED[0][0]}° and {MEASURED[1][0]}°."
    )
    numbers: dict[str, object] = {
        "turn": turns,
        "turn_limit": {law.name: turn_limit(setting.CAN, law) for law in setting.LAWS},
        "status": {law.name: flick(law).status for law in setting.LAWS},
        "toppled_at": {law.name: float(flick(law).t[-1]) for law in setting.LAWS},
        "peak_friction_ratio": float(motion.friction_ratio.max()),
    }
    return Drawing("falling", "A fall, step by step", figure, caption, numbers)
