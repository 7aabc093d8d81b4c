"""The turn of each near-collision, by the legs before and after it."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from rimroll.body import Body
from rimroll.gyro.attitude import attitudes
from rimroll.gyro.falls import GUARD, Passage
from rimroll.gyro.filtering import Filter
from rimroll.gyro.legs import Leg, horizontal, leg_of, path_of

Array = NDArray[np.float64]

SCALE_ERROR = 0.012
"""Standard deviation of the sensitivity: data sheets have ±1 % as typical, ±3 % as the limit."""
AT_MAXIMUM = 3
"""Samples at each end of a leg that say when the tilt was largest."""


@dataclass(frozen=True)
class Sensed:
    """The samples of a passage, less their bias, and what else its legs depend on.

    ``cut_off``: whether some are beyond the sensor's range.
    """

    passage: Passage
    t: Array
    rates: Array
    noise: float
    bias_error: float
    body: Body
    taken_out: Filter | None = None
    cut_off: bool = False

    @cached_property
    def mistaken(self) -> list[Sensed]:
        """The same with one standard deviation of each error that a whole record shares.

        These are the bias along x, y and z, and the sensitivity along x, y and z.
        """
        biased = [self.rates + self.bias_error * along for along in np.eye(3)]
        scaled = [self.rates * (1.0 + SCALE_ERROR * along) for along in np.eye(3)]
        return [replace(self, rates=rates) for rates in (*biased, *scaled)]

    @cached_property
    def attitudes(self) -> Array:
        """Rotations from the body at each sample to that at the last one before the collision."""
        turned = attitudes(self.t, self.rates)
        origin = turned[self.passage.before - self.passage.start]
        return np.asarray(origin.T @ turned)

    @cached_property
    def step(self) -> float:
        """The usual time from sample to sample, s."""
        return float(np.median(np.diff(self.t)))

    def legs(self, axis: Array, later: float = 0.0) -> tuple[Leg, Leg]:
        """The fall and the rise, for an axis in the sensor, the collision ``later`` by seconds."""
        passage, path = self.passage, path_of(self.t, self.rates, axis, self.attitudes)
        collision = passage.t + later
        given = (self.body, self.noise, self.step, horizontal(axis), self.taken_out)
        before = path.part(0, passage.before - passage.start)
        after = path.part(passage.after - passage.start, passage.end - passage.start)
        return (
            leg_of(before, collision, *given),
            leg_of(after, collision, *given),
        )

    def turn(self, axis: Array, later: float = 0.0) -> float:
        """The turn from the release or the largest tilt to the next, rad, less whole turns."""
        fall, rise = self.legs(axis, later)
        begin = self._at_release(fall) if self.passage.released else heading_at_maximum(fall, 0)
        return float(np.remainder(heading_at_maximum(rise, -1) - begin, 2.0 * np.pi))

    def _at_release(self, fall: Leg) -> float:
        """The heading at the release, some samples before those of the leg."""
        yaw_rate = fall.momentum[0] / np.sin(fall.tilt[0]) ** 2
        earlier = GUARD * (self.t[1] - self.t[0])
        return float(fall.heading[0] - yaw_rate * earlier)


def heading_at_maximum(leg: Leg, end: int) -> float:
    """The heading at the largest tilt, which is near the first or the last sample of a leg."""
    part = slice(0, AT_MAXIMUM) if end == 0 else slice(-AT_MAXIMUM, None)
    t, rate, heading = leg.t[part], leg.tilt_rate[part], leg.heading[part]
    slope, value = np.polyfit(t - t[end], rate, 1)
    # Half a sample at most: beyond it, the tilt has no maximum here.
    half = 0.5 * float(np.median(np.diff(leg.t)))
    ahead = float(np.clip(-value / slope, -half, half)) if slope < 0.0 else 0.0
    turning = np.polyfit(t - t[end], heading, 1)[0]
    return float(leg.heading[end] + turning * ahead)
