"""What became of a body on a table that moved: overturning, uplift, largest tilt, what is left."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from rimroll.body import Body
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


def is_overturned(motion: Motion) -> bool:
    """Whether it toppled, or lifted off beyond the balance tilt under a law without flight."""
    if motion.status == "lifted_off":
        return bool(motion.tilt[-1] > balance_tilt(motion.body))
    return motion.status == "toppled"


def largest_tilt(motion: Motion) -> float:
    """The largest tilt of the dense output, rad."""
    highest = motion.crossings(lambda at: at.tilt_rate, rising=False)
    return max(float(motion.tilt.max()), *(event.state.tilt for event in highest), 0.0)


def first_uplift(motion: Motion) -> float | None:
    """The time at which a body that stood flat first began to rock, s."""
    return next((event.t for event in motion.events if event.kind == "uplift"), None)
