"""A motion of the ground and its figure."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from rimroll import _core
from rimroll.errors import RimrollError, choose, hold
from rimroll.ground.lines import (
    HORIZONTAL,
    Lines,
    Peak,
    along,
    bound_of_peak,
    combined,
    lines_of,
    peak_of,
    peak_of_part,
    takes_long,
)
from rimroll.units import Number, Values, number, numbers, positive

if TYPE_CHECKING:
    import xarray as xr
    from matplotlib.figure import Figure


Array = NDArray[np.float64]

MAX_FACTOR = 1e6
"""The largest factor of :meth:`Ground.scaled`; its inverse is the smallest."""


@dataclass(frozen=True, eq=False, repr=False)
class Ground:
    """The acceleration of the table along x, y and z (upward) as a function of time.

    The functions of :mod:`rimroll.ground` make it: a sum of pulses in closed form and of a record,
    whose samples are joined by straight lines. It begins at t = 0, and the acceleration is zero
    before that and after its :attr:`duration`. It cannot be changed, and can be compared and
    pickled. ``+`` adds grounds; two records must have the same times of samples.

    Attributes
    ----------
    core
        The ground as the solver takes it.
    heading
        The direction in which x points, rad clockwise from north; None if it is not known.
    """

    core: _core.CoreGround
    heading: float | None = None

    def __call__(self, t: Values) -> Array:
        """The acceleration (..., 3), m/s², at times t (s) of any shape.

        Where it jumps, this is the value after the jump. Raises ``RimrollError`` for a time that is
        not finite; so do :meth:`velocity` and :meth:`displacement`.
        """
        moments = _moments(t)
        return self.core.acceleration(moments.ravel()).reshape(*moments.shape, 3)

    def velocity(self, t: Values) -> Array:
        """The velocity (..., 3), m/s, at times t (s) of any shape.

        The table is at rest until t = 0. The integral is exact for records and pulses, without
        correction of the baseline. After :attr:`duration` the velocity is constant, and not zero
        unless the acceleration has no net impulse.

        >>> import rimroll as rr
        >>> rr.ground.half_sine(3.0, 0.5).velocity([0.25, 0.5, 9.0]).round(3).tolist()
        [[0.477, 0.0, 0.0], [0.955, 0.0, 0.0], [0.955, 0.0, 0.0]]
        """
        moments = _moments(t)
        return self.core.kinematics(moments.ravel())[0].reshape(*moments.shape, 3)

    def displacement(self, t: Values) -> Array:
        """The displacement (..., 3), m, since t = 0 at times t (s) of any shape.

        It is integrated as :meth:`velocity`. In a record whose baseline was not corrected, most of
        it is drift, which grows on after the end: see :meth:`detrended`.

        >>> import rimroll as rr
        >>> rr.ground.sine(3.0, 1.2).displacement([0.6, 1.2, 9.0]).round(3).tolist()
        [[0.344, 0.0, 0.0], [0.688, 0.0, 0.0], [0.688, 0.0, 0.0]]
        """
        moments = _moments(t)
        return self.core.kinematics(moments.ravel())[1].reshape(*moments.shape, 3)

    @property
    def duration(self) -> float:
        """The time from which on the acceleration is zero, s."""
        return self.core.duration

    def scaled(self, factor: Number) -> Ground:
        """This ground with all accelerations multiplied by a factor.

        Raises ``RimrollError`` unless the factor is between 1e-6 and 1e6.
        """
        times = positive("factor", factor)
        if not 1.0 / MAX_FACTOR <= times <= MAX_FACTOR:
            raise RimrollError(field="factor", value=times, bound="between 1e-6 and 1e6")
        return Ground(self.core.scaled(times), self.heading)

    def rotated(self, angle: Number) -> Ground:
        """This ground turned about the vertical by an angle (rad), from x toward y.

        North turns with it, so that :attr:`heading` grows by the angle.
        """
        turned = number("angle", angle, "rad")
        if not math.isfinite(turned):
            raise RimrollError(field="angle", value=turned, bound="finite")
        heading = None if self.heading is None else (self.heading + turned) % math.tau
        return Ground(self.core.rotated(turned), heading)

    def __add__(self, other: Ground) -> Ground:
        if not isinstance(other, Ground):
            return NotImplemented
        headings = {ground.heading for ground in (self, other)} - {None}
        if len(headings) > 1:
            raise RimrollError("grounds that are added must have the same heading")
        return Ground(self.core.plus(other.core), headings.pop() if headings else None)

    def detrended(self) -> Ground:
        """This record less the straight line that fits it best, a correction of its baseline.

        The line is fitted to each component by least squares (``scipy.signal.detrend``). Raises
        ``RimrollError`` for a ground with pulses, which needs no correction.
        """
        from scipy.signal import detrend

        record = self.core.samples()
        if record is None or self.core.pulses():
            raise RimrollError("only a record can be detrended, not pulses")
        step, samples = record
        return Ground(_core.CoreGround.from_samples(step, detrend(samples, axis=0)), self.heading)

    @cached_property
    def _lines(self) -> Lines:
        return lines_of(self.core)

    @cached_property
    def peak(self) -> Peak:
        """The largest accelerations, m/s²: the PGA of each component and of the horizontal motion.

        They are exact for a record and for a pulse. Sums of different pulses are searched at a
        thousand points in each period, which can miss the peak by 2e-5 of it.
        """
        return peak_of_part(self.core) or peak_of(self._lines.acceleration)

    @cached_property
    def peak_velocity(self) -> Peak:
        """The largest of the :meth:`velocity`, m/s, without correction of the baseline.

        It is the largest value at the samples of a record and at a thousand points in each period
        of a pulse, up to :attr:`duration`.
        """
        return peak_of(self._lines.velocity)

    @cached_property
    def peak_displacement(self) -> Peak:
        """The largest of the :meth:`displacement`, m, found as :attr:`peak_velocity`."""
        return peak_of(self._lines.displacement)

    def intensity(
        self,
        measure: str = "pga",
        horizontal: str = "vector",
        *,
        period: Number | None = None,
        damping: Number = 0.05,
    ) -> float:
        """A measure of the intensity of the horizontal motion, m/s² or m/s.

        Parameters
        ----------
        measure
            ``pga``, the largest acceleration; ``pgv``, the largest velocity; ``sa``, the largest
            pseudo-acceleration of a linear oscillator.
        horizontal
            How both components become one number. ``vector``: the largest magnitude of the vector,
            which is RotD100. ``rotd50``: the median over all directions of the largest component
            along a direction (Boore, Bull. Seism. Soc. Am. 100, 2010), in steps of 1°; of a record
            along one line it is 0.71 of its peak. ``geomean``: the geometric mean of the peaks
            along x and y, which depends on the direction of x; 0 if one of them is 0.
        period, damping
            Natural period (s) and damping ratio of the oscillator of ``sa``.

        Raises
        ------
        RimrollError
            An unknown word, ``sa`` without a period, a period without ``sa``, and as
            :meth:`response_spectrum`.

        Examples
        --------
        >>> import rimroll as rr
        >>> wave = rr.ground.sine((3.0, 3.0, 0.0), (0.5, 0.7, 1.0))
        >>> [round(wave.intensity("pga", how), 3) for how in ("vector", "rotd50", "geomean")]
        [4.102, 3.0, 3.0]
        """
        quantity = choose("measure", measure, {name: name for name in ("pga", "pgv", "sa")})
        how = choose("horizontal", horizontal, {name: name for name in HORIZONTAL})
        if (period is None) == (quantity == "sa"):
            needed = "measure sa needs a period" if period is None else "period is only for sa"
            raise RimrollError(f"{needed}, the natural period of its oscillator in s")
        if period is not None:
            from rimroll.ground.spectrum import spectral_acceleration

            one = positive("period", period, "s")
            return spectral_acceleration(self._lines, one, damping, how)
        peak = self.peak if quantity == "pga" else self.peak_velocity
        if how == "vector":
            return peak.horizontal
        of_lines = self._lines.acceleration if quantity == "pga" else self._lines.velocity
        return combined(lambda one: np.abs(along(of_lines, one)).max(axis=1), how)

    def response_spectrum(self, periods: Values, damping: Number = 0.05) -> xr.Dataset:
        """The largest responses of linear oscillators on this ground.

        Parameters
        ----------
        periods
            Natural periods T (n,), s.
        damping
            Damping ratio, 0 to below 1.

        Returns
        -------
        xarray.Dataset
            Over ``period`` and ``component`` (x, y, z): ``displacement``, the largest displacement
            relative to the ground, m, and with ω = 2π/T ``pseudo_velocity`` (times ω, m/s) and
            ``pseudo_acceleration`` (times ω², m/s²).

        Notes
        -----
        The equation of motion is solved exactly between the samples of a record (as by Nigam &
        Jennings, Bull. Seism. Soc. Am. 59, 1969), at 16 or more points in each period, and
        continued for one period after the ground has come to rest. Between the points, the extrema
        are those of a cubic, with a relative error below 1e-4.

        Raises
        ------
        RimrollError
            Periods that are not positive, or so short that more than ten million points are
            needed; a damping outside 0 to below 1.
        """
        from rimroll.ground.spectrum import response_spectrum

        return response_spectrum(self._lines, periods, damping)

    def plot(self) -> Figure:
        """The acceleration, velocity and displacement over time, and the pseudo-spectra at 5 %."""

        return _figure(self)

    def to_xarray(self) -> xr.Dataset:
        """The ground as a dataset over ``t`` and ``component`` (x, y, z), with units.

        ``acceleration`` has straight lines between its points, exactly for a record. ``velocity``
        and ``displacement`` are integrated from rest without correction of the baseline.
        """
        import xarray as xr

        lines = self._lines
        # An index has each time once: at a jump, the value after it.
        last = np.append(np.diff(lines.t) > 4.0 * np.spacing(lines.t[1:]), True)
        dims = ("t", "component")
        dataset = xr.Dataset(
            {
                "acceleration": (dims, lines.acceleration[last], {"units": "m/s^2"}),
                "velocity": (dims, lines.velocity[last], {"units": "m/s"}),
                "displacement": (dims, lines.displacement[last], {"units": "m"}),
            },
            coords={"t": ("t", lines.t[last], {"units": "s"}), "component": list("xyz")},
        )
        known = {} if self.heading is None else {"heading": self.heading}
        return dataset.assign_attrs(known, rimroll_version=_core.__version__)

    def _parts(self) -> tuple[Any, float, Array | None, float | None]:
        record = self.core.samples()
        step, samples = record if record is not None else (0.0, None)
        return self.core.pulses(), step, samples, self.heading

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Ground):
            return NotImplemented
        (pulses, step, samples, heading), theirs = self._parts(), other._parts()
        if (pulses, step, heading) != (theirs[0], theirs[1], theirs[3]):
            return False
        if samples is None or theirs[2] is None:
            return samples is theirs[2]
        return np.array_equal(samples, theirs[2])

    def __hash__(self) -> int:
        pulses, step, samples, heading = self._parts()
        # -0.0 equals 0.0
        data = b"" if samples is None else (samples + 0.0).tobytes()
        flat = tuple((kind, *amplitude, *times) for kind, amplitude, *times in pulses)
        return hash((flat, step, data, heading))

    def __reduce__(self) -> tuple[Any, ...]:
        return _again, self._parts()

    def __repr__(self) -> str:
        return f"<Ground of {self.in_words(': ')}>"

    def in_words(self, after_kind: str = ", ") -> str:
        """What it consists of, its duration and its peaks, or a bound that takes no search."""
        peak = peak_of_part(self.core)
        words = "peaks"
        if peak is None and takes_long(self.core):
            peak, words = bound_of_peak(self.core), "peaks at most"
        peaks = ", ".join(f"{value:.4g}" for value in (peak or self.peak)[:3])
        return f"{self._kind()}{after_kind}{self.duration:.6g} s, {words} {peaks} m/s²"

    def _kind(self) -> str:
        """What it consists of, in words."""
        count, record = len(self.core.pulses()), self.core.samples()
        words = [f"{count} pulse{'s' * (count > 1)}"] if count else []
        if record is not None:
            words.append(f"{len(record[1])} samples at {record[0]:g} s")
        return " and ".join(words)

    def _repr_html_(self) -> str:
        """The view in notebooks: the largest accelerations, velocities and displacements.

        If the search for them takes long, it is the text.
        """
        if takes_long(self.core):
            return f"<p>{self.in_words(': ')}</p>"
        rows = (
            ("acceleration", self.peak, "m/s²"),
            ("velocity", self.peak_velocity, "m/s"),
            ("displacement", self.peak_displacement, "m"),
        )
        head = "".join(f"<th>{name}</th>" for name in ("largest", *Peak._fields))
        body = "".join(
            f"<tr><td>{name}, {unit}</td>"
            + "".join(f"<td>{value:.4g}</td>" for value in peak)
            + "</tr>"
            for name, peak, unit in rows
        )
        table = f"<table><thead><tr>{head}</tr></thead><tbody>{body}</tbody></table>"
        return f"<div><p><b>Ground</b> of {self._kind()}, {self.duration:.6g} s</p>{table}</div>"


def _moments(t: Values) -> Array:
    moments = numbers("t", t, "s")
    hold("t", moments, np.isfinite(moments), "finite")
    return moments


def _again(
    pulses: list[_core.Pulse], step: float, samples: Array | None, heading: float | None
) -> Ground:
    core = _core.CoreGround.from_pulses(pulses)
    if samples is not None:
        core = core.plus(_core.CoreGround.from_samples(step, samples))
    return Ground(core, heading)


_PERIODS = np.geomspace(0.05, 5.0, 80)
"""The periods of the spectra, s."""

_MARKED = (0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0)
"""The periods that are marked."""


def _figure(ground: Ground) -> Figure:
    """Acceleration, velocity and displacement of each component over time, and pseudo-spectra."""
    from matplotlib.ticker import NullLocator

    from rimroll.figures import style

    axes = tuple(zip("xyz", style.SERIES[:3], ("-", "--", "-."), strict=True))
    lines = ground._lines
    spectrum = ground.response_spectrum(_PERIODS)["pseudo_acceleration"]
    with style.figure_style():
        figure = style.page(110.0)
        panels = figure.subplot_mosaic([["a", "d"], ["b", "d"], ["c", "d"]], width_ratios=[2, 1])
        for letter, name, symbol, values in (
            ("a", "acceleration", "$a$ (m/s²)", lines.acceleration),
            ("b", "velocity", "$v$ (m/s)", lines.velocity),
            ("c", "displacement", "$d$ (m)", lines.displacement),
        ):
            ax = panels[letter]
            for column, (axis, color, dashes) in enumerate(axes):
                if lines.acceleration[:, column].any():
                    ax.plot(lines.t, values[:, column], dashes, color=color, label=axis, lw=0.8)
            ax.set_xlim(0.0, ground.duration)
            style.label(ax, letter, name, "time $t$ (s)" if letter == "c" else "", symbol)
        ax = panels["d"]
        for column, (axis, color, dashes) in enumerate(axes):
            if lines.acceleration[:, column].any():
                ax.plot(_PERIODS, spectrum[:, column], dashes, color=color, label=axis)
        ax.set_xscale("log")
        ax.set_xlim(_PERIODS[0], _PERIODS[-1])
        ax.set_ylim(bottom=0.0)
        ax.set_xticks(_MARKED, labels=[f"{period:g}" for period in _MARKED])
        ax.xaxis.set_minor_locator(NullLocator())
        style.label(
            ax, "d", "response at 5 % damping", "period $T$ (s)", "pseudo-acceleration (m/s²)"
        )
        ax.legend()
    return figure
