"""What became of a body on a table that moved: overturning, uplift, largest tilt, what is left."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from rimroll.body import Body
from rimroll.endings import STATUSES
from rimroll.motion.moments import Array, Moments
from rimroll.theory import balance_tilt

if TYPE_CHECKING:
    from rimroll.motion.motion import Motion


def footprint_of(moments: Moments, body: Body) -> Array:
    """Centre of the footprint (x, y), m, shape (n, 2): R from the contact point toward the axis.

    It is the centre of the circle on which the base would stand if the body turned upright about
    the contact point. Rocking about a point of the rim does not move it; rolling and sliding do.
    """
    heading = np.stack([np.cos(moments.yaw), np.sin(moments.yaw)], axis=-1)
    return np.asarray(moments.contact_path + body.radius * heading)


def largest_tilt(motion: Motion) -> float:
    """The largest tilt, rad: that at a maximum, an impact or an end, as the core finds it."""
    highest = [event.state.tilt for event in motion.events if event.kind in ("tilt_max", "land")]
    toppled = [event.state.tilt for event in motion.events if event.kind == "topple"]
    return max(float(motion.tilt[0]), *highest, *toppled or [float(motion.tilt[-1])])


def first_uplift(motion: Motion) -> float | None:
    """The time at which a body that stood flat first began to rock, s."""
    return next((event.t for event in motion.events if event.kind == "uplift"), None)


def shaken_in_words(motion: Motion) -> str:
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


def _why_undecided(motion: Motion) -> str:
    end, ground = float(motion.t[-1]), motion.ground
    if motion.status != "finished":
        return f"the motion stopped at {end:.6g} s, where the body {STATUSES[motion.status]}"
    if ground is not None and end < ground.duration:
        return f"the motion ends at {end:.6g} s, and the ground moves until {ground.duration:.6g} s"
    tilt = np.degrees(motion.tilt[-1])
    return f"at the end, at a tilt of {tilt:.4g}°, it can still pass its balance tilt"


def _end_in_words(motion: Motion) -> str:
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


def _uplift_in_words(motion: Motion) -> str:
    if motion.uplift_time is not None:
        return f"The body was lifted at {motion.uplift_time:.6g} s."
    if motion.start.is_knocked:
        return "The body stood and was knocked."
    if motion.start.tilt > 0.0:
        return "The body leaned at the start."
    return "The body was never lifted."
