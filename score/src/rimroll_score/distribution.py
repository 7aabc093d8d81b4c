"""Forty-two flicks: in which directions does an engine let the can fall?"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from rimroll_score.cases import Falls
from rimroll_score.euler import tilt_of, wrapped, yaw_of
from rimroll_score.samples import Samples
from rimroll_score.sweep import task
from rimroll_score.worker import Worker


@dataclass(frozen=True)
class Distribution:
    """Directions of fall, degrees from the first lean, by an engine."""

    setting: str
    dt: float
    directions: list[float | None]
    """None where the body did not fall."""
    right_sides: int
    """Falls on the true side of straight across."""
    median_error: float | None
    """The median error of the bodies that fell, degrees; None if none did."""


def distribution(worker: Worker, falls: Falls, dt: float, setting: str) -> Distribution:
    """Let the body fall from every start."""
    found: list[float | None] = []
    for state in falls.states:
        outcome = worker.run(task(falls.scene, state, falls.duration, dt, setting))
        if outcome.status in ("unsupported", "missing", "too_slow"):
            found += [None] * (len(falls.states) - len(found))
            break
        found.append(direction(outcome.samples, falls.fallen) if outcome.samples else None)
    pairs = [
        (one, true) for one, true in zip(found, falls.directions, strict=True) if one is not None
    ]
    errors = [abs(wrapped(one - true)) for one, true in pairs]
    return Distribution(
        setting=setting,
        dt=dt,
        directions=[None if one is None else math.degrees(one) for one in found],
        right_sides=sum((one > math.pi) == (true > math.pi) for one, true in pairs),
        median_error=math.degrees(float(np.median(errors))) if errors else None,
    )


def direction(samples: Samples, fallen: float) -> float | None:
    """The direction in which the body leans when it has fallen, rad in [0, 2π); None if it has not.

    It counts from the first lean, and begins after the smallest tilt.
    """
    tilt = tilt_of(samples.axis)
    low = int(np.argmin(tilt))
    beyond = np.flatnonzero(tilt[low:] >= fallen)
    if not beyond.size:
        return None
    yaw = yaw_of(samples.axis[[0, low + int(beyond[0])]])
    return float((yaw[1] - yaw[0]) % (2.0 * math.pi))
