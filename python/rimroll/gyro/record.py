"""What a gyroscope recorded: angular velocities at times, and what was noticed about them."""

from __future__ import annotations

import os
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from rimroll.errors import RimrollError, hold
from rimroll.given import Values, numbers

Array = NDArray[np.float64]

MIN_SAMPLES = 20
"""Samples that a record must have."""


@dataclass(frozen=True, eq=False, repr=False)
class Record:
    """The record of a gyroscope.

    Raises ``RimrollError`` for fewer than 20 samples, for shapes that do not fit, and for times
    that do not increase.

    Parameters
    ----------
    t
        Times of the samples, (n,), s, increasing; not necessarily even.
    rates
        Angular velocity along the sensor's axes x, y and z, (n, 3), rad/s.
    name
        What messages and figures call it.
    source
        How the file was understood, in one line.
    notes
        What is unusual about it, a sentence each: gaps, repeated times, saturation.
    simulated
        Whether it was computed instead of measured.
    """

    t: Array
    rates: Array
    name: str = "the record"
    source: str = ""
    notes: tuple[str, ...] = ()
    simulated: bool = False

    def __post_init__(self) -> None:
        t, rates = numbers("t", self.t, "s"), numbers("rates", self.rates, "rad/s")
        if t.ndim != 1 or rates.shape != (len(t), 3):
            raise RimrollError(
                f"must have the shape (n,) and rates (n, 3), got {t.shape} and {rates.shape}", "t"
            )
        if len(t) < MIN_SAMPLES:
            raise RimrollError(
                f"{self.name} must have at least {MIN_SAMPLES} samples, it has {len(t)}"
            )
        hold("t", t, np.isfinite(t), "finite", "s")
        hold("rates", rates, np.isfinite(rates), "finite", "rad/s")
        hold("t", t, np.diff(t, prepend=-np.inf) > 0.0, "greater than the time before", "s")
        object.__setattr__(self, "t", t)
        object.__setattr__(self, "rates", rates)

    def __len__(self) -> int:
        return len(self.t)

    def __repr__(self) -> str:
        kind = "simulated record" if self.simulated else "record"
        return (
            f"<Gyroscope {kind} of {len(self)} samples in {self.t[-1] - self.t[0]:.4g} s,"
            f" {self.sampling_rate:.4g} Hz>"
        )

    @property
    def step(self) -> float:
        """The usual time from sample to sample, s: the median."""
        return float(np.median(np.diff(self.t)))

    @property
    def sampling_rate(self) -> float:
        """Samples a second: the inverse of :attr:`step`."""
        return 1.0 / self.step

    def between(self, start: Values, end: Values) -> Record:
        """The samples from ``start`` to ``end``, s.

        Raises ``RimrollError`` if they are fewer than 20.
        """
        inside = (self.t >= float(numbers("start", start, "s"))) & (
            self.t <= float(numbers("end", end, "s"))
        )
        return Record(
            self.t[inside], self.rates[inside], self.name, self.source, self.notes, self.simulated
        )

    def save(self, path: str | os.PathLike[str]) -> Path:
        """Write it as the CSV file that phyphox exports, with commas and decimal points.

        A record that was simulated says so in a comment in the first line, which
        :func:`rimroll.gyro.read` understands.
        """
        from rimroll.gyro.phyphox import write

        return write(path, self)
