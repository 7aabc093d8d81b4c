"""Rests in a record, in which a gyroscope shows its bias and its noise."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view
from numpy.typing import NDArray

from rimroll.gyro.record import Record

Array = NDArray[np.float64]

WINDOW = 0.3
"""The shortest rest, s."""
QUIET = 0.05
"""The largest standard deviation of a rate at rest, rad/s."""
LARGEST_BIAS = 0.6
"""The largest mean rate at rest, rad/s: data sheets of cheap sensors have up to 20 degrees/s."""
UNKNOWN_BIAS = 0.0175
"""Uncertainty of a bias where nothing rests, rad/s: the 1 degree/s that data sheets give."""


@dataclass(frozen=True)
class Rests:
    """Where nothing moves, and what the sensor shows there.

    ``spans`` are start and end of each rest, s. ``bias`` (k, 3) is the mean rate in each, rad/s,
    ``noise`` the standard deviation of a sample, rad/s, ``bias_error`` that of the bias.
    """

    spans: list[tuple[float, float]]
    bias: Array
    noise: float
    bias_error: float

    def bias_at(self, t: Array) -> Array:
        """The bias at times, (n, 3): on straight lines between rests, constant beyond them."""
        if not self.spans:
            return np.zeros((len(t), 3))
        centers = [0.5 * (start + end) for start, end in self.spans]
        return np.stack([np.interp(t, centers, self.bias[:, i]) for i in range(3)], axis=-1)

    @property
    def drift(self) -> float:
        """How far the bias moves between the first rest and the last, rad/s."""
        return float(np.linalg.norm(self.bias[-1] - self.bias[0])) if self.spans else 0.0


def rests_of(record: Record) -> Rests:
    """The rests of a record: the quietest parts of it, of at least 0.3 s."""
    width = max(round(WINDOW / record.step), 8)
    if width >= len(record):
        return Rests([], np.zeros((0, 3)), _roughness(record.rates), UNKNOWN_BIAS)
    step = smallest_step(record.rates)
    windows = sliding_window_view(record.rates, width, axis=0)
    means, spreads = windows.mean(axis=-1), windows.std(axis=-1, ddof=1).max(axis=1)
    possible = (spreads < QUIET) & (np.abs(means).max(axis=1) < LARGEST_BIAS)
    if not possible.any():
        return Rests([], np.zeros((0, 3)), _roughness(record.rates), UNKNOWN_BIAS)
    quietest = np.flatnonzero(possible)[np.argmin(spreads[possible])]
    limit = max(2.0 * float(spreads[quietest]), step)
    # A slow steady motion is as quiet as a rest, but its mean is not that of the quietest part.
    near = np.abs(means - means[quietest]).max(axis=1) < max(limit, 0.01)
    inside = np.zeros(len(record), bool)
    for i in np.flatnonzero(possible & near & (spreads <= limit)):
        inside[i : i + width] = True
    edges = np.flatnonzero(np.diff(np.concatenate(([0], inside.astype(int), [0]))))
    parts = [record.rates[a:b] for a, b in zip(edges[::2], edges[1::2], strict=True)]
    spans = [
        (float(record.t[a]), float(record.t[b - 1]))
        for a, b in zip(edges[::2], edges[1::2], strict=True)
    ]
    bias = np.array([part.mean(axis=0) for part in parts])
    count = sum(len(part) for part in parts)
    left = np.concatenate([part - part.mean(axis=0) for part in parts])
    # A digital output may be constant at rest; its noise is then that of rounding.
    middle = 1.4826 * float(np.median(np.abs(left)))
    noise = max(middle, step / math.sqrt(12.0))
    return Rests(spans, bias, noise, noise / math.sqrt(min(count, 50)))


def _roughness(rates: Array) -> float:
    """Noise of a sample from third differences, which smooth motions leave small."""
    third = np.diff(rates, 3, axis=0) / np.sqrt(20.0)
    return float(np.median(np.abs(third)) / 0.6745) + smallest_step(rates) / math.sqrt(12.0)


def smallest_step(rates: Array) -> float:
    """The smallest difference between two rates that occur along one axis: the resolution."""
    steps = [np.diff(np.unique(rates[:, i])) for i in range(3)]
    return float(min((step.min() for step in steps if len(step)), default=0.0))
