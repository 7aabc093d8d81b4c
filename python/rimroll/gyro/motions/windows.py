"""Which samples of a record are fitted, and where their fit begins."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from rimroll.errors import RimrollError
from rimroll.gyro.analysis import Analysis
from rimroll.gyro.collision import Collision
from rimroll.gyro.falls import GUARD
from rimroll.gyro.motions.model import SHARED, Model, Window
from rimroll.laws import Frictionless, NoSlip
from rimroll.left_or_right import watershed_slope

Array = NDArray[np.float64]

SENSITIVITY = 1e-3
"""Error of a rate over the rate: the digital output and the axes are not ideal."""
TIMING = 1e-4
"""Error of the time of a sample, s."""
FADING = 0.5
"""The time after a collision that is not fitted if a filter was taken out, over the period of its
cut-off frequency: twice its decay time."""
LEAST_SIDE = 1e-3
"""The least difference in yaw rate between starts that turn to either side, rad/s."""


@dataclass(frozen=True)
class Chain:
    """The near-collisions after one release, each following from the one before."""

    collisions: list[Collision]


def chains_of(found: Analysis) -> list[Chain]:
    """The near-collisions by release; those whose release was not seen only if no other was."""
    chains: list[list[Collision]] = []
    for one in found.collisions:
        last = chains[-1][-1] if chains else None
        if not one.released and last is not None and one.start == last.end:
            chains[-1].append(one)
        else:
            chains.append([one])
    released = [one for one in chains if one[0].released]
    return [Chain(one) for one in (released or chains)]


def window_of(found: Analysis, chain: Chain, count: int) -> Window:
    """The samples from the release to the largest tilt after ``count`` near-collisions."""
    some = chain.collisions[:count]
    record = found.record
    t, step = record.t, record.step
    used = (t >= some[0].start) & (t <= some[-1].end)
    for one in some:
        used &= (t <= one.last_before) | (t >= one.first_after + _fading(found))
    rates = record.rates - found.rests.bias_at(t)
    slopes = np.linalg.norm(np.gradient(rates, t, axis=0), axis=1)[used]
    sizes = np.linalg.norm(rates[used], axis=1)
    scatter = np.sqrt(found.rests.noise**2 + (SENSITIVITY * sizes) ** 2 + (TIMING * slopes) ** 2)[
        :, np.newaxis
    ]
    release = some[0].start - (GUARD + 0.5) * step
    return Window(release, t[used], rates[used], scatter)


def _fading(found: Analysis) -> float:
    """How long after a collision a filter that was taken out leaves a rest of the jump, s."""
    return 0.0 if found.filter_cutoff is None else FADING / found.filter_cutoff


def sides(found: Analysis, one: Collision) -> tuple[float, float]:
    """Yaw rates from which the body turns to either side, the likelier one first, rad/s.

    They lie as far on either side of the starts that come down flat as the measured one.
    """
    body, tilt = found.body, one.tilt_before
    slopes = []
    for law in (NoSlip(), Frictionless()):
        try:
            slopes.append(watershed_slope(body, tilt, law))
        except RimrollError:
            continue
    middle = float(np.mean(slopes)) * one.spin_rate if slopes else 0.0
    unsure = one.momentum_error / math.sin(tilt) ** 2
    away = max(abs(one.yaw_rate - middle), unsure, LEAST_SIDE)
    sign = 1.0 if one.turn >= 0.0 else -1.0
    return middle + sign * away, middle - sign * away


def first_guess(model: Model, one: Collision, yaw_rate: float) -> Array:
    """The numbers of a model with one window, as the collision was read.

    ``RimrollError`` if the motion from there ends before the first sample.
    """
    spin = one.spin_rate + (one.yaw_rate - yaw_rate) * math.cos(one.tilt_before)
    law = model.numbers_of_law_given()
    vector = np.concatenate(
        [law, np.zeros(len(SHARED)), [one.tilt_before, one.tilt_rate, yaw_rate, spin, 0.0, 0.0]]
    )
    window = model.windows[0]
    rates = model.shown(vector, 0)
    fall = (window.t <= one.time) & np.isfinite(rates).all(axis=1)
    if not fall.any():
        raise RimrollError("the motion ends before the first sample")
    shown = model.sensing.unturned(rates[fall])
    seen = model.sensing.unturned(window.rates[fall])
    # Rates across the axis turn by minus the azimuth.
    across = np.sum((seen[:, 0] + 1j * seen[:, 1]) * (shown[:, 0] - 1j * shown[:, 1]))
    vector[-2] = -float(np.angle(across))
    return vector
