"""The distribution of the largest tilt over small random imperfections of the start."""

from __future__ import annotations

import warnings
from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import NDArray

from rimroll.bodies.body import Body, one_body
from rimroll.errors import RimrollError, expect, hold
from rimroll.ground.ground import Ground
from rimroll.laws import Law, one_law
from rimroll.options import Keywords, Options, takes_options
from rimroll.shaking.lognormal import UndecidedWarning, reached
from rimroll.shaking.many import SHAKING, follow_shaken
from rimroll.state import State, single
from rimroll.units import Number, Values, number, numbers, positive, random_seed, whole_number

if TYPE_CHECKING:
    from typing import Unpack

    import xarray as xr
    from matplotlib.figure import Figure

Array = NDArray[np.float64]


class Distance(NamedTuple):
    """The two-sample Kolmogorov–Smirnov test.

    ``statistic`` is the largest difference of two empirical distributions, ``pvalue`` the
    probability of one at least as large if both samples have the same distribution.
    """

    statistic: float
    pvalue: float


@dataclass(frozen=True, eq=False)
class Maxima:
    """Largest tilts over the balance tilt, of a test that was repeated or of its simulations.

    Single tests of rocking do not repeat, but their distributions do; so models are validated by
    the distance of the distributions (Bachmann et al. 2018).

    Attributes
    ----------
    values
        The largest tilts over the balance tilt (n,), ascending; any number for a body that
        overturned that is larger than the others, such as infinity.
    """

    values: Array

    def __post_init__(self) -> None:
        values = np.sort(numbers("values", self.values))
        if values.ndim != 1 or not values.size:
            raise RimrollError(f"must be a flat array, got shape {values.shape}", "values")
        hold("values", values, values >= 0.0, ">= 0")
        values.flags.writeable = False
        object.__setattr__(self, "values", values)

    @classmethod
    def of(cls, shaken: xr.Dataset) -> Maxima:
        """The maxima of a dataset of :func:`rimroll.shake_many`; infinite if overturned.

        Motions that are undecided are left out, with an :class:`rimroll.UndecidedWarning` that
        counts them, for they may have tilted further. Raises ``RimrollError`` if all are.
        """
        overturned, undecided = reached(shaken, None)
        if undecided.any():
            warnings.warn(
                f"{undecided.sum()} of {undecided.size} motions are left out of the distribution,"
                " because they ended before it was determined whether the body overturns",
                UndecidedWarning,
                stacklevel=2,
            )
        if undecided.all():
            raise RimrollError("all motions are undecided: they have no distribution")
        ratio = np.where(overturned, np.inf, np.asarray(shaken["max_tilt_ratio"]))
        return cls(ratio[~undecided])

    @property
    def overturned(self) -> float:
        """The fraction that overturned: that of the infinite values."""
        return float(np.isinf(self.values).mean())

    def cdf(self, ratio: Values) -> Array:
        """The fraction of the values up to ``ratio``, an array of any shape."""
        given = numbers("ratio", ratio)
        return np.asarray(np.searchsorted(self.values, given, side="right") / len(self.values))

    def distance(self, other: Maxima) -> Distance:
        """The Kolmogorov–Smirnov distance of two samples (``scipy.stats.ks_2samp``)."""
        from scipy.stats import ks_2samp

        expect("other", other, Maxima)
        found = ks_2samp(self.values, other.values)
        return Distance(float(found.statistic), float(found.pvalue))

    def plot(self, other: Maxima | None = None) -> Figure:
        """The empirical distribution, and that of another sample with the distance of the two."""
        from rimroll.shaking.figures import maxima_figure

        if other is None:
            return maxima_figure(self.values)
        apart = self.distance(other)
        title = f"distance {apart.statistic:.3g} ($p$ = {apart.pvalue:.2g})"
        return maxima_figure(self.values, other.values, title)


def imperfect_starts(
    start: State, count: int, tilt_noise: Number, yaw_noise: Number = 0.0, *, seed: int
) -> State:
    """Starts that differ from one by small random imperfections.

    The horizontal components of the lean, tilt (cos yaw, sin yaw), get normal errors, so that a
    body that stands flat leans a little to a random side. The axis of the body and its rates of
    tilt and yaw are otherwise those of ``start``.

    Parameters
    ----------
    start
        A single start, which may be :meth:`rimroll.State.standing`.
    count
        The number of starts n.
    tilt_noise
        Standard deviation of each component of the lean, rad, > 0.
    yaw_noise
        Standard deviation of the yaw (rad), as of the direction of the shaking.
    seed
        Seed of NumPy's random numbers: the same seed gives the same starts.

    Returns
    -------
    State
        Starts (n,).

    Raises
    ------
    RimrollError
        A start of arrays; noise or a count outside its bounds.
    """
    expect("start", start, State)
    one = single(start)
    many = whole_number("count", count)
    noise, turn = positive("tilt_noise", tilt_noise, "rad"), number("yaw_noise", yaw_noise, "rad")
    if not 0.0 <= turn < np.inf:
        raise RimrollError(field="yaw_noise", value=turn, bound=">= 0 and finite", unit="rad")
    random = np.random.default_rng(random_seed(seed))
    x = one.tilt * np.cos(one.yaw) + noise * random.standard_normal(many)
    y = one.tilt * np.sin(one.yaw) + noise * random.standard_normal(many)
    return State(
        tilt=np.hypot(x, y),
        tilt_rate=np.full(many, one.tilt_rate),
        yaw=np.arctan2(y, x) + turn * random.standard_normal(many),
        yaw_rate=np.full(many, one.yaw_rate),
        spin=np.full(many, one.spin),
        spin_rate=np.full(many, one.spin_rate),
    )


@takes_options(SHAKING)
def random_maxima(
    body: Body,
    start: State,
    law: Law,
    ground: Ground,
    count: int,
    *,
    tilt_noise: Number,
    yaw_noise: Number = 0.0,
    seed: int = 0,
    threads: int | None = None,
    progress: Callable[[int, int], object] | None = None,
    options: Options | None = None,
    **keywords: Unpack[Keywords],
) -> Maxima:
    """The largest tilts of one test with small random imperfections of the start.

    Raises ``RimrollError`` as these do.

    Parameters
    ----------
    body, start, law, ground
        The test: single ones.
    count, tilt_noise, yaw_noise, seed
        As for :func:`rimroll.imperfect_starts`.
    gravity, rtol, topple_tilt, max_steps, flat, flat_gap, options, threads, progress
        As for :func:`rimroll.shake_many`, whose default duration all motions have.
    """
    one_body(body)
    one_law(law)
    starts = imperfect_starts(start, count, tilt_noise, yaw_noise, seed=seed)
    shaken = follow_shaken(
        body,
        starts,
        law,
        ground,
        scale=1.0,
        duration=None,
        options=SHAKING.changed(options, None, keywords),
        threads=threads,
        progress=progress,
    )
    return Maxima.of(shaken.to_xarray())
