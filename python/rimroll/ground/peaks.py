"""The largest values of a motion of the ground."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from rimroll import _core


class Peak(NamedTuple):
    """The largest magnitude of each component, and of the horizontal vector."""

    x: float
    y: float
    z: float
    horizontal: float


def peak_of_part(core: _core.CoreGround) -> Peak | None:
    """The peak acceleration of a ground of one pulse or of a record; None for other grounds."""
    pulses, record = core.pulses(), core.samples()
    if record is not None:
        return None if pulses else peak_of(record[1])
    if len(pulses) != 1:
        return None
    [(kind, _, period, duration, center)] = pulses
    end = np.nextafter(duration, 0.0)
    if kind == "ricker" and center > end:
        return None
    # A sine is largest after a quarter of its period, if it lasts as long, a cosine at its start.
    largest = {"sine": 0.25 * period, "ricker": center}.get(kind, 0.0)
    return peak_of(core.acceleration(np.array([min(largest, end)])))


def bound_of_peak(core: _core.CoreGround) -> Peak:
    """What the peak acceleration does not exceed: the sum of the peaks of its parts."""
    record = core.samples()
    peaks = [] if record is None else [peak_of(record[1])]
    peaks += [peak_of(np.array([amplitude])) for _, amplitude, *_ in core.pulses()]
    return Peak(*map(sum, zip(*peaks, strict=True)))


def peak_of(values: NDArray[np.float64]) -> Peak:
    """The peak of vectors (n, 3)."""
    horizontal = np.hypot(values[:, 0], values[:, 1]).max()
    return Peak(*map(float, (*np.abs(values).max(axis=0), horizontal)))
