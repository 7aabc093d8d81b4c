"""``rimroll turn``: the limiting angle of turn, and that of a motion."""

from __future__ import annotations

import math
from dataclasses import asdict, dataclass, replace
from typing import Any

from rich.table import Table

from rimroll._core import __version__
from rimroll.bodies.body import Body
from rimroll.cli.contact import in_words
from rimroll.cli.hints import hints
from rimroll.cli.options import (
    BodyOptions,
    JsonOption,
    LawOptions,
    MotionOptions,
    ResistanceOptions,
    StartOptions,
)
from rimroll.cli.request import Request, requested
from rimroll.cli.screen import angle, prose, say, show_json, table, unbroken, working
from rimroll.errors import NoNearCollision, RimrollError, typed
from rimroll.laws import IDEAL, Coulomb, Law, Stribeck, Viscous, has_one_limit
from rimroll.motion import Motion, simulate
from rimroll.state import State
from rimroll.theory.closed_forms import (
    Arrival,
    arrival,
    balance_tilt,
    lift_off_rate,
    needed_friction,
    turn_limit,
)

SHOWN = 4  # turns of a motion
COLUMN = 34  # where numbers stand that have a name before them


def limit_in_words(arriving: str = "") -> str:
    """What the limit under friction is, for people who compare it with a motion."""
    return (
        "limit: the turn of the near-collision alone as the sideways push goes to 0"
        f"{arriving}; slip before and after it changes the turn, too"
    )


def turn(
    body: BodyOptions,
    start: StartOptions,
    motion: MotionOptions,
    law: LawOptions,
    resistances: ResistanceOptions,
    json: JsonOption = False,
) -> int:
    """The angle by which a body turns in a near-collision.

    The limiting angle is that of motions ever closer to a face-down collision.
    With a start, the angles of the real motion from there stand beside it.
    Under friction the limit depends on how the body arrives at the table.

    Examples:

    $ rimroll turn soda_can --fill 50%

    $ rimroll turn cylinder --radius 3cm --length 10cm --law no-slip

    $ rimroll turn --tilt 30deg --tilt-rate -0.5rad/s --yaw-rate 0.005

    $ rimroll turn --friction 0.2 --tilt 30deg --yaw-rate 0.005
    """
    what = requested(body, start, motion, law, resistances)
    limits = _limits(what, named=law.law is not None)
    motions = {
        limit.law.name: _motion(replace(what, law=limit.law))
        for limit in limits
        if what.start is not None and (has_one_limit(limit.law) == has_one_limit(what.law))
    }
    if json:
        show_json(_answer(what, limits, motions))
    else:
        _show_limits(what, limits)
        for computed in motions.values():
            show_turns(computed)
    return int(any(computed.status == "failed" for computed in motions.values()))


@dataclass(frozen=True)
class Limit:
    """The limiting angle of turn under a law, arriving in one way or another.

    ``from_start`` and ``arrival`` belong to the start that was given, if there is one and it
    has a near-collision; if it has none, ``why_not`` says why, and ``ends`` is the status with
    which the motion ends that comes in place of one.
    """

    law: Law
    angle: float | None
    arrival: Arrival | None = None
    from_start: float | None = None
    why_not: str = ""
    ends: str | None = None


def limit_of(what: Request, law: Law) -> Limit:
    """The limit under a law, for the given start."""
    try:
        limit = Limit(law, turn_limit(what.body, law))
    except RimrollError as error:
        limit = Limit(law, None, why_not=_in_degrees(error))
    if what.start is None:
        return limit
    try:
        comes = arrival_of(what.body, what.start, law, what.options.gravity)
        limit = replace(limit, arrival=comes)
        return replace(limit, from_start=turn_limit(what.body, law, comes))
    except RimrollError as error:
        ends = error.status if isinstance(error, NoNearCollision) else None
        return replace(limit, why_not=_in_degrees(error), ends=ends)


def _in_degrees(error: RimrollError) -> str:
    return error.in_degrees if isinstance(error, NoNearCollision) else str(error)


def arrival_of(body: Body, start: State, law: Law, gravity: float) -> Arrival:
    """The arrival of a start; ``RimrollError`` if its sideways motion is not small."""
    most = 0.2  # of the rate of falling: above this the body wobbles rather than falls
    turning = math.hypot(
        start.yaw_rate * math.sin(start.tilt),
        start.spin_rate + start.yaw_rate * math.cos(start.tilt),
    )
    if turning > most * math.sqrt(gravity / body.radius):
        raise RimrollError(
            f"this start has no near-collision: it turns sideways at {turning:.3g} rad/s"
        )
    return arrival(body, start, law, gravity)


def _limits(what: Request, named: bool) -> list[Limit]:
    """The limits under the two ideal laws, under the law of ``--law``, or under all three."""
    ideals = [replace(law, resistances=what.law.resistances) for law in IDEAL]
    if not has_one_limit(what.law):
        laws: list[Law] = [*ideals, what.law]
    else:
        laws = [what.law] if named else ideals
    return [limit_of(what, law) for law in laws]


def _motion(what: Request) -> Motion:
    assert what.start is not None
    with working(f"following the motion ({typed(what.law.name)})"):
        return simulate(what.body, what.start, what.law, options=what.options)


def _answer(what: Request, limits: list[Limit], motions: dict[str, Motion]) -> dict[str, Any]:
    body = what.body
    of_law = {limit.law.name: limit for limit in limits}
    return {
        "rimroll_version": __version__,
        "body": {"name": what.name, **asdict(body)},
        "turn_limit": {name: limit.angle for name, limit in of_law.items()},
        "arrivals": {
            name: {"turn_limit": limit.from_start, **asdict(limit.arrival)}
            for name, limit in of_law.items()
            if limit.arrival is not None
        },
        "needed_friction": needed_friction(body),
        "balance_tilt": balance_tilt(body),
        **({"liquid_balance_tilt": balance_tilt(body, liquid=True)} if body.filling else {}),
        "lift_off_rate": lift_off_rate(body, what.options.gravity),
        "gravity": what.options.gravity,
        "motions": {name: _turns(motion, of_law[name]) for name, motion in motions.items()},
    }


def _turns(motion: Motion, limit: Limit) -> dict[str, Any]:
    turns = [asdict(turn) for turn in motion.turns]
    if has_one_limit(motion.law) and limit.angle is not None:
        turns = [{**turn, "beyond_limit": abs(turn["angle"]) - limit.angle} for turn in turns]
    return {
        "parameters": motion.parameters(),
        "status": motion.status,
        "message": motion.message,
        "turns": turns,
        "first_turn": None if motion.first_turn is None else asdict(motion.first_turn),
    }


def body_line(name: str, body: Body) -> str:
    """A body in a line of prose."""
    numbers = (
        f"m = {body.mass:.4g} kg",
        f"R = {body.radius:.4g} m",
        f"H = {body.height:.4g} m",
        f"A = {body.transverse_inertia:.4g} kg m²",
        f"C = {body.axial_inertia:.4g} kg m²",
    )
    frozen = "; its filling counts as frozen" if body.filling else ""
    return f"{name}: {', '.join(map(unbroken, numbers))}{frozen}"


def start_line(motion: Motion, nudged: bool = False) -> str:
    """A start and the gravity in a line of prose; ``nudged`` if it is the default start."""
    return start_in_words(motion.start, motion.gravity, nudged)


def start_in_words(start: State, gravity: float, nudged: bool = False) -> str:
    """The start and the gravity in words, for a command that computes no motion."""
    gravity_in_words = unbroken(f"gravity {gravity:g} m/s²")
    if start.tilt == 0.0:
        return f"standing flat; {gravity_in_words}"
    if start.is_knocked:
        return (
            f"standing, knocked to a tilt rate of {start.tilt_rate:.4g} rad/s; {gravity_in_words}"
        )
    rates = ", ".join(
        f"{name} {getattr(start, f'{name}_rate'):.4g}" for name in ("tilt", "yaw", "spin")
    )
    tilt = angle(float(start.tilt))
    tilt += " (half its balance tilt)" if nudged else ""
    return f"from tilt {tilt}, rates of {rates} rad/s; {gravity_in_words}"


def _show_limits(what: Request, limits: list[Limit]) -> None:
    body = what.body
    angles = table("law", "limiting angle of turn", "beyond 180°")
    for limit in limits:
        plain = in_words(replace(limit.law, resistances=()))
        if has_one_limit(limit.law):
            _row(angles, plain, limit.angle)
        else:
            _row(angles, plain, limit.angle)
            if limit.from_start is not None:
                _row(angles, "    arriving from this start", limit.from_start)
    prose(body_line(what.name, body))
    say()
    say(angles)
    say()
    _named("friction needed to roll through", f"{needed_friction(body):.4g}")
    filled = body.filling is not None
    _named("balance tilt, filling frozen" if filled else "balance tilt", angle(balance_tilt(body)))
    if filled:
        _named("balance tilt, filling liquid", angle(balance_tilt(body, liquid=True)))
    rate = lift_off_rate(body, what.options.gravity)
    faster = "arriving faster, it would need a pull from the table to roll on"
    known = f"{rate:.4g} rad/s ({faster})" if math.isfinite(rate) else "none: it never lifts off"
    _named("lift-off rate", known)
    for limit in limits:
        if not has_one_limit(limit.law):
            _show_arrival(what, limit)
    if what.law.resistances:
        say()
        say("The limits leave the resistances out; the motion has them.")


def _named(name: str, what: str) -> None:
    """Print a number, or a few words, with its name before it."""
    prose(unbroken(f"{name:<{COLUMN}}") + what, COLUMN)


def _row(rows: Table, law: str, limit: float | None) -> None:
    if limit is None:
        rows.add_row(law, "none", "")
    else:
        rows.add_row(law, angle(limit), angle(limit - math.pi))


def _show_arrival(what: Request, limit: Limit) -> None:
    """The arrival, and the limits that depend on it."""
    name = typed(limit.law.name)
    if limit.arrival is not None:
        _named("arrival from this start", arrival_words(limit.arrival))
    say()
    if limit.why_not:
        prose(f"{name}: {limit.why_not}")
    prose(limit_in_words())
    prose(_depends(limit.law, needed_friction(what.body)), 0)


def arrival_words(comes: Arrival) -> str:
    """The arrival in one line."""
    way = "outward" if comes.slip < 0.0 else "inward"
    slip = f"slipping {way} at {100 * abs(comes.slip):.3g} cm/s" if comes.slip else "without slip"
    return f"tipping at {comes.tipping_rate:.4g} rad/s, {slip}"


def _depends(law: Law, needed: float) -> str:
    """How a limit depends on the arrival."""
    name = typed(law.name)
    if isinstance(law, Viscous):
        sentence = (
            f"Viscous friction does nothing in the limit: it has no time to. So {name}, too, has"
        )
        sentence += " one limit for all arrivals without spin, the frictionless one."
        return sentence
    speeds = ", and with its speeds on that rate itself" if isinstance(law, Stribeck) else ""
    sentence = (
        "What depends on the arrival: no-slip and frictionless have one limit for all starts"
        f" without spin. That of {name} changes with the slip and spin of the arrival, relative to"
        f" its tipping rate{speeds}; the first line is for neither."
    )
    if isinstance(law, Coulomb):
        sentence += (
            f" Arriving so, the body rolls through if static friction is {needed:.4g} or more."
        )
    return sentence


def show_turns(motion: Motion) -> None:
    """The ending of a motion and its first turns, with their limit if it applies to each.

    A body that falls over in its first turn shows this up to there.
    """
    say()
    prose(f"{in_words(motion.law)}: {motion.message_in_degrees}")
    for hint in hints(motion, "--law coulomb --friction"):
        prose(hint)
    complete = motion.turns[:SHOWN]
    shown = complete or [turn for turn in [motion.first_turn] if turn is not None]
    if not shown:
        return
    limit = turn_limit(motion.body, motion.law) if has_one_limit(motion.law) else None
    beyond = [] if limit is None else ["beyond the limit"]
    turns = table("turn", "angle", *beyond, "smallest tilt", "at t")
    for i, turn in enumerate(shown, 1):
        excess = [] if limit is None else [angle(abs(turn.angle) - limit)]
        turns.add_row(str(i), angle(turn.angle), *excess, angle(turn.min_tilt), f"{turn.t:.6f} s")
    say(turns)
    if not complete:
        say("up to the end of the motion, in its first turn")
    if len(motion.turns) > SHOWN:
        say(f"and {len(motion.turns) - SHOWN} more, which --json lists")
