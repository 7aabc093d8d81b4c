"""``rimroll turn``: the angle of turn in the limit, and of a real motion beside it."""

from __future__ import annotations

import math
from dataclasses import asdict, replace
from typing import Any

from rimroll._core import __version__
from rimroll.body import Body
from rimroll.cli.asked import Asked, asked
from rimroll.cli.options import BodyOptions, JsonOption, LawOption, MotionOptions, StartOptions
from rimroll.cli.screen import angle, say, show_json, table, working
from rimroll.laws import IDEAL, Law
from rimroll.motion import Motion, simulate
from rimroll.theory import balance_tilt, lift_off_rate, needed_friction, turn_limit

SHOWN = 4  # turns of a motion


def turn(
    body: BodyOptions,
    start: StartOptions,
    motion: MotionOptions,
    law: LawOption = None,
    json: JsonOption = False,
) -> int:
    """By what angle a body turns in a near-collision.

    The limiting angle is that of motions ever closer to a face-down collision.
    With a start, the angles of the real motion from there stand beside it.

    Examples:

    $ rimroll turn soda_can --fill 50%

    $ rimroll turn cylinder --radius 3cm --length 10cm --law no-slip

    $ rimroll turn --tilt 30deg --tilt-rate -0.5rad/s --yaw-rate 0.005
    """
    what = asked(body, start, motion, law)
    chosen = [what.law] if law is not None else list(IDEAL)
    motions = {
        law.name: _motion(replace(what, law=law)) for law in chosen if what.start is not None
    }
    if json:
        show_json(_answer(what, chosen, motions))
    else:
        _show_limits(what, chosen)
        for computed in motions.values():
            show_turns(computed)
    return int(any(computed.status == "failed" for computed in motions.values()))


def _motion(what: Asked) -> Motion:
    assert what.start is not None
    with working(f"following the motion ({typed(what.law)})"):
        return simulate(what.body, what.start, what.law, **asdict(what.options))


def _answer(what: Asked, chosen: list[Law], motions: dict[str, Motion]) -> dict[str, Any]:
    body = what.body
    return {
        "rimroll_version": __version__,
        "body": {"name": what.name, **asdict(body)},
        "turn_limit": {law.name: turn_limit(body, law) for law in chosen},
        "needed_friction": needed_friction(body),
        "balance_tilt": balance_tilt(body),
        "lift_off_rate": lift_off_rate(body, what.options.gravity),
        "gravity": what.options.gravity,
        "motions": {name: _turns(motion) for name, motion in motions.items()},
    }


def _turns(motion: Motion) -> dict[str, Any]:
    limit = turn_limit(motion.body, motion.law)
    return {
        "parameters": motion.parameters(),
        "status": motion.status,
        "message": motion.message,
        "turns": [
            {**asdict(turn), "beyond_limit": abs(turn.angle) - limit} for turn in motion.turns
        ],
    }


def body_line(name: str, body: Body) -> str:
    """A body in one line."""
    return (
        f"{name}: m = {body.mass:.4g} kg, R = {body.radius:.4g} m, H = {body.height:.4g} m, "
        f"A = {body.transverse_inertia:.4g} kg m², C = {body.axial_inertia:.4g} kg m²"
    )


def typed(law: Law) -> str:
    """A law as it is typed: ``no-slip``."""
    return law.name.replace("_", "-")


def _show_limits(what: Asked, chosen: list[Law]) -> None:
    body = what.body
    limits = table("law", "limiting angle of turn", "beyond 180°")
    for law in chosen:
        limit = turn_limit(body, law)
        limits.add_row(typed(law), angle(limit), angle(limit - math.pi))
    say(body_line(what.name, body))
    say()
    say(limits)
    say()
    say(f"friction needed to roll through   {needed_friction(body):.4g}")
    say(f"balance tilt                      {angle(balance_tilt(body))}")
    rate = lift_off_rate(body, what.options.gravity)
    faster = "arriving faster, it would need a pull from the table to roll on"
    known = f"{rate:.4g} rad/s ({faster})" if math.isfinite(rate) else "none: it never lifts off"
    say(f"lift-off rate                     {known}")


def show_turns(motion: Motion) -> None:
    """How a motion ended, and its first turns beside their limit."""
    limit = turn_limit(motion.body, motion.law)
    say()
    say(f"{typed(motion.law)}: {motion.message}")
    if not motion.turns:
        return
    turns = table("turn", "angle", "beyond the limit", "smallest tilt", "at t")
    for i, turn in enumerate(motion.turns[:SHOWN], 1):
        beyond = abs(turn.angle) - limit
        turns.add_row(
            str(i), angle(turn.angle), angle(beyond), angle(turn.min_tilt), f"{turn.t:.6f} s"
        )
    say(turns)
    if len(motion.turns) > SHOWN:
        say(f"and {len(motion.turns) - SHOWN} more, which --json lists")
