"""What became of a body on a table that moved: overturning, uplift, largest tilt, what is left."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from rimroll.body import Body
from rimroll.motion.moments import Array, Moments

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
    """The largest tilt of the dense output, rad."""
    highest = motion.crossings(lambda at: at.tilt_rate, rising=False)
    return max(float(motion.tilt.max()), *(event.state.tilt for event in highest), 0.0)


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
        return " ".join(sentences)
    x, y = motion.residual_displacement
    turned = np.degrees(motion.residual_yaw)
    sentences.append(
        f"It did not overturn; at the end its footprint was displaced by {np.hypot(x, y):.4g} m"
        f" (x {x:.4g}, y {y:.4g}) and the body had turned by {turned:.4g}°."
    )
    return " ".join(sentences)


def _uplift_in_words(motion: Motion) -> str:
    if motion.uplift_time is not None:
        return f"The body was lifted at {motion.uplift_time:.6g} s."
    if motion.start.is_knocked:
        return "The body stood and was knocked."
    if motion.start.tilt > 0.0:
        return "The body leaned at the start."
    return "The body was never lifted."
