"""Suggestions for motions that end before they show anything."""

from __future__ import annotations

import math
from collections.abc import Container

from rimroll.bodies.body import Body
from rimroll.errors import typed
from rimroll.laws import Frictionless, InPlace, Law, NoSlip
from rimroll.motion import Motion, simulate
from rimroll.options import Options
from rimroll.state import State, single
from rimroll.theory.closed_forms import balance_tilt


def hints(motion: Motion, friction_option: str) -> list[str]:
    """Sentences that say why a motion ended early and which option changes that; often none.

    ``friction_option`` is what the command needs before a coefficient of dry friction.
    """
    found = [_past_balance(motion), _lifted_off(motion, friction_option)]
    return [hint for hint in found if hint]


def release_hints(body: Body, start: State, law: Law, options: Options) -> list[str]:
    """Hints for many falls with this mean start; none if that start comes down."""
    if single(start).tilt < balance_tilt(body):
        return []
    hint = _past_balance(simulate(body, start, law, options=options))
    return [hint] if hint else []


def _past_balance(motion: Motion) -> str:
    balance, tilt = balance_tilt(motion.body), float(motion.start.tilt)
    if motion.status != "toppled" or min(tilt, _smallest_tilt(motion)) < balance:
        return ""
    rate = float(motion.start.tilt_rate)
    frozen = " with its filling frozen," if motion.body.filling else ""
    too_slow = f" and {rate:.4g} rad/s is too slow to bring it back," if rate < 0.0 else ""
    return (
        f"the start at {math.degrees(tilt):.4g}° is past the balance tilt of this body,"
        f" {math.degrees(balance):.4g}°,{frozen}{too_slow} so it falls over;"
        f" try --tilt {_below(balance)}"
    )


def _smallest_tilt(motion: Motion) -> float:
    """The smallest tilt of a motion, rad; infinite if the tilt has no minimum."""
    minima = [event.state.tilt for event in motion.events if event.kind == "tilt_min"]
    return min(minima, default=math.inf)


def _below(balance: float) -> str:
    """Half a balance tilt as it is typed."""
    return f"{math.degrees(0.5 * balance):.2g}deg"


def _lifted_off(motion: Motion, friction_option: str) -> str:
    return _no_flight(motion.law, friction_option) if motion.status == "lifted_off" else ""


def _no_flight(law: Law, friction_option: str) -> str:
    """What to do about a law under which a motion ends where the rim leaves the table."""
    if not isinstance(law, NoSlip | InPlace | Frictionless):
        return ""
    friction = 0 if isinstance(law, Frictionless) else 0.3
    return (
        f"{typed(law.name)} ends where the rim leaves the table; with dry friction the body"
        f" slides or flies on: try {friction_option} {friction:g}"
    )


def undecided_hints(statuses: Container[str], law: Law, friction_option: str) -> list[str]:
    """How to decide shaken motions that ended in these statuses."""
    found = {
        "lifted_off": _no_flight(law, friction_option),
        "face_down": "where the base comes down flat, the motion goes on with --flat housner,"
        " smooth or a restitution",
        "finished": "a longer --duration decides a motion that ends while the ground moves or the"
        " body can still fall",
    }
    return [hint for status, hint in found.items() if status in statuses and hint]
