"""Suggestions for motions that end before they show anything."""

from __future__ import annotations

import math

from rimroll.laws import Frictionless, NoSlip
from rimroll.motion import Motion
from rimroll.names import typed
from rimroll.theory import balance_tilt


def hints(motion: Motion, friction_option: str) -> list[str]:
    """Sentences that say why a motion ended early and which option changes that; often none.

    ``friction_option`` is what the command needs before a coefficient of dry friction.
    """
    found = [_past_balance(motion), _lifted_off(motion, friction_option)]
    return [hint for hint in found if hint]


def _past_balance(motion: Motion) -> str:
    balance, tilt = balance_tilt(motion.body), float(motion.start.tilt)
    if motion.status != "toppled" or motion.turns or tilt < balance:
        return ""
    return (
        f"the start at {math.degrees(tilt):.4g}° is past the balance tilt of this body,"
        f" {math.degrees(balance):.4g}°, so it falls over; try --tilt {_below(balance)}"
    )


def _below(balance: float) -> str:
    """Half a balance tilt as it is typed."""
    return f"{math.degrees(0.5 * balance):.2g}deg"


def _lifted_off(motion: Motion, friction_option: str) -> str:
    if motion.status != "lifted_off" or not isinstance(motion.law, NoSlip | Frictionless):
        return ""
    friction = 0.3 if isinstance(motion.law, NoSlip) else 0
    return (
        f"{typed(motion.law.name)} ends where the rim leaves the table; with dry friction the body"
        f" slides or flies on: try {friction_option} {friction:g}"
    )
