"""Rocking spectra: how far bodies of one shape rock, depending on their size."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from rimroll import _core
from rimroll.body import Body, one_body
from rimroll.errors import expect, hold
from rimroll.given import Number, Values, numbers, positive
from rimroll.ground.ground import Ground
from rimroll.laws import Law, NoSlip
from rimroll.motion.flat import ON_MOVING_TABLES, FlatLanding
from rimroll.options import Options
from rimroll.shaking.many import follow_shaken
from rimroll.shaking.scales import with_rocking_frequency
from rimroll.state import State

if TYPE_CHECKING:
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

        return rocking_figure(self)


def rocking_spectrum(
    body: Body,
    ground: Ground,
    periods: Values,
    *,
    law: Law | None = None,
    start: State | None = None,
    flat: FlatLanding = ON_MOVING_TABLES,
    flat_gap: Number = 0.0,
    gravity: Number = _core.STANDARD_GRAVITY,
    rtol: float = 1e-8,
    threads: int | None = None,
    progress: Callable[[int, int], object] | None = None,
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
    law, start, flat
        By default the rim does not slip, the bodies stand flat at first, and an impact of the whole
        base is plastic (Housner 1963), as in planar rocking spectra (Makris & Konstantinidis 2003).
    flat_gap, gravity, rtol, threads, progress
        As for :func:`rimroll.shake_many`.

    Raises
    ------
    RimrollError
        Periods that are no flat array of positive numbers; and as :func:`rimroll.shake_many`.
    """
    one_body(body)
    expect("ground", ground, Ground)
    g = positive("gravity", gravity, "m/s^2")
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
        options=Options.read(1.0, g, rtol, None, 1_000_000, flat_gap),
        flat=flat,
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
