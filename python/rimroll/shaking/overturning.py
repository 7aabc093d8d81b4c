"""The least motion of the ground that overturns a body."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from rimroll.bodies.body import Body, one_body
from rimroll.errors import RimrollError, expect
from rimroll.ground.ground import Ground
from rimroll.laws import Law, NoSlip
from rimroll.many.falls import Falls
from rimroll.options import Keywords, Options, takes_options
from rimroll.shaking.lognormal import reached
from rimroll.shaking.many import SHAKING, follow_shaken
from rimroll.shaking.rocking import flat_array
from rimroll.shaking.scales import rocking_frequency, tangent
from rimroll.state import State
from rimroll.units import Number, Values, number, positive

if TYPE_CHECKING:
    from typing import Unpack

    import xarray as xr
    from matplotlib.figure import Figure

Array = NDArray[np.float64]
Flags = NDArray[np.bool_]

MAX_HALVINGS = 60


@takes_options(SHAKING)
def overturning_scale(
    body: Body,
    start: State,
    law: Law,
    grounds: Ground | Sequence[Ground],
    scales: Values,
    *,
    precision: Number = 1e-4,
    threads: int | None = None,
    options: Options | None = None,
    **keywords: Unpack[Keywords],
) -> xr.Dataset:
    """The least factor on each ground that overturns a body.

    A stronger motion need not overturn a body that a weaker one does: the factors that do can form
    several intervals. So some factors are tried in increasing order, and the interval before the
    first that overturns is halved. A narrow interval between two of these ``scales`` is missed.

    Parameters
    ----------
    body, start, law
        What rocks, how it starts, and how its rim meets the table: single numbers.
    grounds
        One motion of the ground, or a list of them.
    scales
        The factors that are tried (n,), in increasing order.
    precision
        The relative width of the interval in which the factor is then known.
    gravity, rtol, topple_tilt, max_steps, flat, flat_gap, options, threads
        As for :func:`rimroll.shake_many`, whose default duration all motions have; by default an
        impact of the whole base is plastic.

    Returns
    -------
    xarray.Dataset
        For each ``ground``: ``scale``, a factor that overturns, NaN where none does; and ``below``,
        a smaller one, within the precision, that does not. Over ``ground`` and ``tried``:
        ``overturned``, which of the ``scales`` overturn; and ``undecided``, for which of them the
        motion ended before that was determined, as where the rim leaves the table under a law
        without flight. A factor that is undecided is neither: where there are such factors between
        ``below`` and ``scale``, these may be further apart than the precision. ``below`` is 0
        where no smaller factor is known not to overturn.

    Raises
    ------
    RimrollError
        Scales that are not positive and increasing; a precision outside 1e-12 to 0.5; and as
        :func:`rimroll.shake_many`.
    """
    import xarray as xr

    one_body(body)
    each = [grounds] if isinstance(grounds, Ground) else list(grounds)
    tried = flat_array("scales", scales)
    if np.any(np.diff(tried) <= 0.0):
        raise RimrollError("must increase", "scales")
    width = number("precision", precision)
    if not 1e-12 <= width <= 0.5:
        raise RimrollError(field="precision", value=width, bound="between 1e-12 and 0.5")
    settings = SHAKING.changed(options, None, keywords)

    def follow(chosen: list[Ground], factors: Array) -> Falls:
        return follow_shaken(
            body,
            start,
            law,
            chosen,
            scale=factors,
            duration=None,
            options=settings,
            threads=threads,
        )

    def overturns(chosen: list[Ground], factors: Array) -> tuple[Flags, Flags]:
        return reached(follow(chosen, factors), None)

    repeated = [ground for ground in each for _ in tried]
    flags = overturns(repeated, np.tile(tried, len(each)))
    found, undecided = (one.reshape(len(each), len(tried)) for one in flags)
    below, scale = _halved(each, tried, found, undecided, overturns, width)
    return xr.Dataset(
        {
            "scale": ("ground", scale, {"long_name": "least factor that overturns"}),
            "below": ("ground", below, {"long_name": "factor that does not overturn"}),
            "overturned": (("ground", "tried"), found),
            "undecided": (("ground", "tried"), undecided),
        },
        coords={"ground": np.arange(len(each)), "tried": tried},
    )


def _halved(
    grounds: list[Ground],
    tried: Array,
    found: Flags,
    undecided: Flags,
    overturns: Callable[[list[Ground], Array], tuple[Flags, Flags]],
    width: float,
) -> tuple[Array, Array]:
    """The interval of each ground at whose upper end a body overturns."""
    any_overturns = found.any(axis=1)
    first = np.where(any_overturns, found.argmax(axis=1), len(tried))
    above = np.where(any_overturns, tried[np.minimum(first, len(tried) - 1)], np.nan)
    stood = ~undecided & (np.arange(len(tried)) < first[:, np.newaxis])
    below = np.where(stood, tried, 0.0).max(axis=1)
    is_open = any_overturns & (below > 0.0)
    for _ in range(MAX_HALVINGS):
        # What overturns at the least factor that was tried is not searched further below.
        open_ = np.flatnonzero(is_open & (above - below > width * above))
        if not open_.size:
            break
        middle = 0.5 * (below[open_] + above[open_])
        fell, unknown = overturns([grounds[place] for place in open_], middle)
        above[open_] = np.where(fell, middle, above[open_])
        below[open_] = np.where(fell | unknown, below[open_], middle)
        is_open[open_] = ~unknown
    return below, above


@dataclass(frozen=True, eq=False)
class OverturningSpectrum:
    """The least amplitudes of a pulse that overturn a body.

    Attributes
    ----------
    frequency_ratio
        ω_p/p of the pulses (n,): their angular frequency over the body's rocking frequency.
    amplitude_ratio
        The least a_p/(g tan α) that overturns (n,), with tan α = R/H; NaN where none that was tried
        does. An amplitude below 1 lifts no body that stands flat.
    tried
        The amplitudes a_p/(g tan α) that were tried before the interval was halved (k,).
    overturned, undecided
        Which of them overturn, and for which the motion ended before that was determined, (n, k).
    """

    frequency_ratio: Array
    amplitude_ratio: Array
    tried: Array
    overturned: Flags
    undecided: Flags

    def to_xarray(self) -> xr.Dataset:
        """The spectrum as a dataset over ``frequency_ratio`` and ``tried``."""
        import xarray as xr

        return xr.Dataset(
            {
                "amplitude_ratio": ("frequency_ratio", self.amplitude_ratio),
                "overturned": (("frequency_ratio", "tried"), self.overturned),
                "undecided": (("frequency_ratio", "tried"), self.undecided),
            },
            coords={"frequency_ratio": self.frequency_ratio, "tried": self.tried},
        )

    def plot(self) -> Figure:
        """The least amplitude against the frequency, over the amplitudes that were tried."""
        from rimroll.shaking.figures import overturning_figure

        return overturning_figure(
            self.frequency_ratio, self.tried, self.overturned, self.undecided, self.amplitude_ratio
        )


@takes_options(SHAKING)
def overturning_spectrum(
    body: Body,
    pulse: Callable[[float, float], Ground],
    frequency_ratios: Values,
    amplitude_ratios: Values | None = None,
    *,
    law: Law | None = None,
    start: State | None = None,
    precision: Number = 1e-4,
    threads: int | None = None,
    options: Options | None = None,
    **keywords: Unpack[Keywords],
) -> OverturningSpectrum:
    """The least amplitude of a pulse that overturns a body, for many frequencies.

    Parameters
    ----------
    body
        The body; it must have height.
    pulse
        A function of the amplitude (m/s²) and the period (s) that gives the ground, such as
        ``rr.ground.sine`` or ``lambda a, T: rr.ground.rectangular(a, T / 2)``. The acceleration
        must be proportional to the amplitude.
    frequency_ratios
        ω_p/p (n,): 2π over the period, over the body's :func:`rimroll.rocking_frequency`.
    amplitude_ratios
        The a_p/(g tan α) that are tried (k,), in increasing order; by default 60 from 1 to 30. The
        overturning region need not be connected: the result is the least amplitude, and a region
        that is narrower than the step between two of these may be missed.
    law, start, precision, gravity, rtol, topple_tilt, max_steps, flat, flat_gap, options, threads
        As for :func:`rimroll.overturning_scale`. By default the rim does not slip, the body stands
        flat at first, and an impact of the whole base is plastic.

    Raises
    ------
    RimrollError
        A disk; frequencies or amplitudes that are no flat arrays of positive numbers; and as
        :func:`rimroll.overturning_scale`.
    """
    one_body(body)
    if not body.height > 0.0:
        raise RimrollError("must have height: a disk has no balance tilt", "body")
    settings = SHAKING.changed(options, None, keywords)
    g = positive("gravity", settings.gravity, "m/s^2")
    ratios = flat_array("frequency_ratios", frequency_ratios)
    default = np.geomspace(1.0, 30.0, 60)
    tried = flat_array(
        "amplitude_ratios", default if amplitude_ratios is None else amplitude_ratios
    )
    unit = g * tangent(body)
    periods = 2.0 * math.pi / (ratios * rocking_frequency(body, g))
    grounds: list[Any] = [pulse(1.0, period) for period in periods.tolist()]
    for ground in grounds:
        expect("the result of pulse", ground, Ground)
    found = overturning_scale(
        body,
        State.standing() if start is None else start,
        NoSlip() if law is None else law,
        grounds,
        unit * tried,
        precision=precision,
        threads=threads,
        options=settings,
    )
    return OverturningSpectrum(
        ratios,
        np.asarray(found["scale"]) / unit,
        tried,
        np.asarray(found["overturned"]),
        np.asarray(found["undecided"]),
    )
