"""Rocking spectra: how far bodies of one shape rock, depending on their size."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from rimroll.bodies.body import Body, one_body
from rimroll.errors import expect, hold
from rimroll.ground.ground import Ground
from rimroll.laws import Law, NoSlip
from rimroll.options import Keywords, Options, takes_options
from rimroll.shaking.many import SHAKING, follow_shaken
from rimroll.shaking.scales import with_rocking_frequency
from rimroll.state import State
from rimroll.units import Values, numbers, positive

if TYPE_CHECKING:
    from typing import Unpack

    import xarray as xr
    from matplotlib.figure import Figure

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class RockingSpectrum:
    """The largest tilts of bodies of one shape on one ground.

    Attributes
    ----------
    dataset
        What :func:`rimroll.shake_many` gives, over the dimension ``period``: 2π/p, s.
    """

    dataset: xr.Dataset

    @property
    def period(self) -> Array:
        """2π/p of the bodies, s."""
        return np.asarray(self.dataset["period"])

    @property
    def max_tilt_ratio(self) -> Array:
        """The largest tilt over the balance tilt; NaN if a body overturns or is undecided."""
        ratio = np.asarray(self.dataset["max_tilt_ratio"])
        return np.where(self.overturned | self.undecided, np.nan, ratio)

    @property
    def overturned(self) -> NDArray[np.bool_]:
        """Which of the bodies overturn."""
        return np.asarray(self.dataset["overturned"])

    @property
    def undecided(self) -> NDArray[np.bool_]:
        """For which of the bodies the motion ended before that was determined."""
        return np.asarray(self.dataset["undecided"])

    def plot(self) -> Figure:
        """The largest tilt over the balance tilt against 2π/p.

        It is shaded where bodies overturn, and grey where that is undecided.
        """
        from rimroll.shaking.figures import rocking_figure

        return rocking_figure(self.period, self.max_tilt_ratio, self.overturned, self.undecided)


@takes_options(SHAKING)
def rocking_spectrum(
    body: Body,
    ground: Ground,
    periods: Values,
    *,
    law: Law | None = None,
    start: State | None = None,
    threads: int | None = None,
    progress: Callable[[int, int], object] | None = None,
    options: Options | None = None,
    **keywords: Unpack[Keywords],
) -> RockingSpectrum:
    """The largest tilts of bodies of one shape and of many sizes on one ground.

    Parameters
    ----------
    body
        A body of the shape. Its slenderness and its ratios of inertia are kept.
    ground
        The motion of the ground.
    periods
        2π/p of the bodies (n,), s; see :func:`rimroll.rocking_frequency`. p² is inversely
        proportional to the size.
    law, start
        By default the rim does not slip and the bodies stand flat at first. An impact of the whole
        base is plastic by default, too (``flat``; Housner 1963), as in planar rocking spectra
        (Makris & Konstantinidis 2003).
    gravity, rtol, topple_tilt, max_steps, flat, flat_gap, options, threads, progress
        As for :func:`rimroll.shake_many`, whose default duration all motions have.

    Raises
    ------
    RimrollError
        Periods that are no flat array of positive numbers; and as :func:`rimroll.shake_many`.
    """
    one_body(body)
    expect("ground", ground, Ground)
    settings = SHAKING.changed(options, None, keywords)
    g = positive("gravity", settings.gravity, "m/s^2")
    period = flat_array("periods", periods, "s")
    axis = _axis("period", period, "s")
    bodies = with_rocking_frequency(body, 2.0 * math.pi / axis, g)
    shaken = follow_shaken(
        bodies,
        State.standing() if start is None else start,
        NoSlip() if law is None else law,
        ground,
        scale=1.0,
        duration=None,
        options=settings,
        threads=threads,
        progress=progress,
    )
    return RockingSpectrum(shaken.to_xarray())


def flat_array(field: str, value: object, unit: str = "1") -> Array:
    """A flat array of positive numbers; ``RimrollError`` for anything else."""
    from rimroll.errors import RimrollError

    array = numbers(field, value, unit)
    if array.ndim != 1 or not array.size:
        raise RimrollError(f"must be a flat array, got shape {array.shape}", field)
    hold(field, array, (array > 0.0) & np.isfinite(array), "> 0 and finite", unit)
    return array


def _axis(name: str, array: Array, units: str) -> xr.DataArray:
    import xarray as xr

    labels = xr.DataArray(array, dims=name, attrs={"units": units})
    return xr.DataArray(array, dims=name, coords={name: labels})
