"""A lognormal fragility curve, and the data to which it is fitted."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray

from rimroll.errors import RimrollError, hold
from rimroll.shaking.probit import jackknife_interval
from rimroll.units import Values, numbers

Array = NDArray[np.float64]
Interval = tuple[float, float]
Method = Literal["profile likelihood", "jackknife"]


class Counts(NamedTuple):
    """Data of a fragility curve (n,), as in :class:`rimroll.Fragility`."""

    intensity: Array
    overturned: Array
    trials: Array
    undecided: Array


@dataclass(frozen=True, eq=False, repr=False)
class LognormalCurve:
    """The numbers of a fragility curve: see :class:`rimroll.Fragility`."""

    median: float
    dispersion: float
    median_interval: Interval
    dispersion_interval: Interval
    level: float
    method: Method
    records: int | None
    log_likelihood: float
    intensity: Array
    overturned: Array
    trials: Array
    undecided: Array
    limit: float | None = None
    without: Array | None = None
    """Medians and dispersions (records, 2) of the curves without one record each, if they exist."""

    def __repr__(self) -> str:
        low, high = self.median_interval
        least, most = self.dispersion_interval
        of = "" if self.records is None else f" of {self.records} records"
        return (
            f"<Fragility: median {self.median:.4g} ({low:.4g} to {high:.4g}), dispersion"
            f" {self.dispersion:.3g} ({least:.3g} to {most:.3g}), {self.trials.sum():.0f}"
            f" trials{of}>"
        )

    def __call__(self, intensity: Values) -> Array:
        """The probability of overturning at intensities of any shape, > 0."""
        from scipy.special import ndtr

        given = numbers("intensity", intensity)
        hold("intensity", given, given > 0.0, "> 0")
        return np.asarray(ndtr(np.log(given / self.median) / self.dispersion))

    def band(self, intensity: Values) -> tuple[Array, Array]:
        """The ends of the interval of the probability at each intensity, > 0, of any shape.

        By the jackknife on Φ⁻¹ of the probability. They are 0 and 1 where the records do not bound
        it. Raises ``RimrollError`` for a curve of independent motions, which has no records.
        """
        from scipy.special import ndtr

        if self.method != "jackknife":
            raise RimrollError("band is for motions that share records: this curve has none")
        given = numbers("intensity", intensity)
        hold("intensity", given, given > 0.0, "> 0")
        if self.without is None:
            return np.zeros(given.shape), np.ones(given.shape)
        median, dispersion = self.without.T.reshape(2, -1, *[1] * given.ndim)
        z = np.log(given / self.median) / self.dispersion
        others = np.log(given / median) / dispersion
        low, high = jackknife_interval(z, others, self.level)
        return np.asarray(ndtr(low)), np.asarray(ndtr(high))
