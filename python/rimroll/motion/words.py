"""What became of a body on a moving table, in words; and a motion's view in notebooks."""

from __future__ import annotations

from html import escape

import numpy as np

from rimroll.figures.notebook import table
from rimroll.files.recorded import STATUSES
from rimroll.motion.moments import TURN_HEAD, turn_cells
from rimroll.motion.trajectory import Trajectory
from rimroll.theory.closed_forms import balance_tilt


def shaken_in_words(motion: Trajectory) -> str:
    """The ground, and what became of the body on it, in sentences with angles in degrees."""
    sentences = []
    if motion.ground is not None:
        sentences.append(f"The ground: {motion.ground.in_words()}.")
    sentences.append(_uplift_in_words(motion))
    if motion.uplift_time is not None or motion.max_tilt > 0.0:
        part = motion.max_tilt_ratio
        sentences.append(
            f"Its largest tilt was {np.degrees(motion.max_tilt):.4g}°, {part:.4g} of the balance"
            " tilt."
        )
    if motion.overturned:
        sentences.append(f"It overturned at {motion.overturning_time:.6g} s.")
    elif motion.overturned is None:
        sentences.append(f"It is undecided whether it overturns: {_why_undecided(motion)}.")
    else:
        sentences.append(f"It did not overturn. {_end_in_words(motion)}")
    return " ".join(sentences)


def _why_undecided(motion: Trajectory) -> str:
    end, ground = float(motion.t[-1]), motion.ground
    if motion.status != "finished":
        return f"the motion stopped at {end:.6g} s, where the body {STATUSES[motion.status]}"
    if ground is not None and end < ground.duration:
        return f"the motion ends at {end:.6g} s, and the ground moves until {ground.duration:.6g} s"
    tilt = np.degrees(motion.tilt[-1])
    return f"at the end, at a tilt of {tilt:.4g}°, it can still pass its balance tilt"


def _end_in_words(motion: Trajectory) -> str:
    """Where a body that has not overturned is at the end, or why that is not determined."""
    end = float(motion.t[-1])
    displacement, yaw = motion.residual_displacement, motion.residual_yaw
    if displacement is not None and yaw is not None:
        x, y = displacement
        return (
            f"At the end it stands, its footprint displaced by {np.hypot(x, y):.4g} m"
            f" (x {x:.4g}, y {y:.4g}) and the body turned by {np.degrees(yaw):.4g}°."
        )
    if motion.status == "face_down":
        return (
            f"At {end:.6g} s its base came down flat, with too little energy to overturn. What"
            " follows from simultaneous impacts is not determined, so that where it will stand is"
            " undecided."
        )
    if motion.phases[-1].kind == "sliding_flat":
        return f"At {end:.6g} s it still slides, so that where it will stand is undecided."
    tops = [event.state.tilt for event in motion.events if event.kind == "tilt_max"]
    tilt = max([*tops[-1:], float(motion.tilt[-1])])
    since = 0.0 if motion.ground is None else min(motion.ground.duration, end)
    energy = float(motion.evaluate(since).energy[0])
    lost = 100.0 * (energy - float(motion.energy[-1])) / energy
    since_words = "the start" if motion.ground is None else "the ground came to rest"
    why = "a longer motion shows where it stands"
    if not motion.law.resistances and lost < 1.0:
        why = "nothing in this law takes its energy while it rolls; a rolling resistance does"
    return (
        f"At {end:.6g} s it still rocks, up to {np.degrees(tilt):.4g}°,"
        f" {tilt / float(balance_tilt(motion.body)):.4g} of the balance tilt, so that where it will"
        f" stand and how far it turns is undecided. Since {since_words} it has lost"
        f" {lost:.2g} % of its energy; {why}."
    )


def _uplift_in_words(motion: Trajectory) -> str:
    if motion.uplift_time is not None:
        return f"The body was lifted at {motion.uplift_time:.6g} s."
    if motion.start.is_knocked:
        return "The body stood and was knocked."
    if motion.start.tilt > 0.0:
        return "The body leaned at the start."
    return "The body was never lifted."


SHOWN = 6  # turns of a motion


def motion_in_html(motion: Trajectory) -> str:
    """The ending of a motion, its first turns as a table in degrees, and what it lost."""
    rows = [(str(number), *turn_cells(turn)) for number, turn in enumerate(motion.turns[:SHOWN], 1)]
    head = f"<p><b>Motion</b>, {escape(repr(motion.law))}: {escape(motion.message)}</p>"
    ground = f"<p>{escape(shaken_in_words(motion))}</p>" if motion.ground is not None else ""
    more = len(motion.turns) - len(rows)
    turns = table(rows, ("turn", *TURN_HEAD)) if rows else "<p>no turns</p>"
    rest = f"<p>and {more} more turns</p>" if more else ""
    return f"<div>{head}{ground}{turns}{rest}{_losses(motion)}</div>"


def _losses(motion: Trajectory) -> str:
    """The energy that was lost by the end, J, by cause."""
    lost = ", ".join(
        f"{loss[-1]:.4g} J to {name}"
        for name, loss in (
            ("friction", motion.friction_loss),
            ("resistances", motion.resistance_loss),
            ("impacts", motion.impact_loss),
        )
    )
    return f"<p>lost: {lost}</p>"
