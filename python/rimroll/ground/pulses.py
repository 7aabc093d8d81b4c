"""Grounds that are made: pulses in closed form, records from arrays and functions, filtered noise.

An amplitude is a number, along x alone, or three (x, y, z). Other arguments are one number for all
components, or three.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence

import numpy as np
from numpy.typing import NDArray

from rimroll import _core
from rimroll.errors import RimrollError, hold
from rimroll.ground.ground import Ground
from rimroll.ground.lines import MAX_POINTS
from rimroll.units import Number, Values, numbers, positive, random_seed

Array = NDArray[np.float64]

CALM = 2.0
"""Periods from its centre to where a Ricker wavelet is below 1e-15 of its amplitude."""

ZERO = np.zeros(3)


def sine(amplitude: Values, period: Values, cycles: Values = 1) -> Ground:
    """Sine pulses: a sin(2πt/T) for some cycles, then rest.

    Raises ``RimrollError`` for an amplitude beyond 1e9 m/s², and for a period or a number of cycles
    that is not positive; so do the other pulses.

    Parameters
    ----------
    amplitude
        a, m/s²: a number, along x alone, or three (x, y, z).
    period
        T, s: a number for all components, or three.
    cycles
        The number of periods, > 0: for all components, or three. It need not be whole.

    Examples
    --------
    >>> import rimroll as rr
    >>> rr.ground.sine(amplitude=(3.0, 1.5, 2.0), period=(1.2, 0.8, 0.5), cycles=(1, 1, 2))
    <Ground of 3 pulses: 1.2 s, peaks 3, 1.5, 2 m/s²>
    """
    periods = _positive("period", period, "s")
    return _pulses("sine", amplitude, periods, _positive("cycles", cycles) * periods, ZERO)


def cosine(amplitude: Values, period: Values, cycles: Values = 1) -> Ground:
    """Cosine pulses: a cos(2πt/T) for some cycles, then rest. The velocity is that of a sine.

    ``amplitude`` (m/s²), ``period`` (s) and ``cycles`` as for :func:`sine`.
    """
    periods = _positive("period", period, "s")
    return _pulses("cosine", amplitude, periods, _positive("cycles", cycles) * periods, ZERO)


def half_sine(amplitude: Values, duration: Values) -> Ground:
    """Half a sine: a sin(πt/d) until t = d, then rest.

    ``amplitude`` (m/s²): a number, along x alone, or three (x, y, z); ``duration`` (d, s): a number
    for all components, or three.
    """
    durations = _positive("duration", duration, "s")
    return _pulses("sine", amplitude, 2.0 * durations, durations, ZERO)


def rectangular(amplitude: Values, duration: Values) -> Ground:
    """A constant acceleration for some time, then rest.

    ``amplitude`` (m/s²): a number, along x alone, or three (x, y, z); ``duration`` (s): a number
    for all components, or three.
    """
    durations = _positive("duration", duration, "s")
    return _pulses("constant", amplitude, ZERO, durations, ZERO)


def ricker(amplitude: Values, period: Values, center: Values | None = None) -> Ground:
    """Symmetric Ricker wavelets: a (1 − 2x²) exp(−x²) with x = π (t − t₀)/T.

    The wavelet ends two periods after its centre.

    Parameters
    ----------
    amplitude
        a, m/s²: a number, along x alone, or three (x, y, z).
    period
        T, s, that of the largest Fourier amplitude: a number for all components, or three.
    center
        t₀, s, the time of the peak: a number for all components, or three. By default it is two
        periods, so that the wavelet begins with less than 1e-15 of its amplitude.
    """
    periods = _positive("period", period, "s")
    given = CALM * periods if center is None else _three("center", center, "s")
    centers = np.broadcast_to(given, (3,))
    return _pulses("ricker", amplitude, periods, centers + CALM * periods, centers)


def _three(field: str, value: object, unit: str = "1") -> Array:
    """A number for all components, or three of them."""
    given = numbers(field, value, unit)
    if given.shape not in ((), (3,)):
        raise RimrollError(field=field, value=value, bound="one number or three (x, y, z)")
    hold(field, given, np.isfinite(given), "finite", unit)
    return given


def _positive(field: str, value: object, unit: str = "1") -> Array:
    given = _three(field, value, unit)
    hold(field, given, given > 0.0, "> 0", unit)
    return np.broadcast_to(given, (3,))


def _pulses(
    kind: str, amplitude: Values, periods: Array, durations: Array, centers: Array
) -> Ground:
    """The ground of a pulse for each component; components of the same times share one."""
    given = _three("amplitude", amplitude, "m/s^2")
    amplitudes = given if given.ndim else np.array([float(given), 0.0, 0.0])
    pulses: dict[tuple[float, float, float], Array] = {}
    for place in range(3):
        times = (float(periods[place]), float(durations[place]), float(centers[place]))
        if amplitudes[place] != 0.0 or (place == 0 and not amplitudes.any()):
            pulses.setdefault(times, np.zeros(3))[place] = amplitudes[place]
    each: list[_core.Pulse] = [
        (kind, tuple(vector.tolist()), *times) for times, vector in pulses.items()
    ]
    return Ground(_core.CoreGround.from_pulses(each))


def sampled(step: Number, acceleration: Values) -> Ground:
    """A record: samples of the acceleration at equal intervals, with straight lines between them.

    Raises ``RimrollError`` for a step that is not positive, an array of another shape, and a sample
    that is not a number between -1e9 and 1e9.

    Parameters
    ----------
    step
        Time between two samples, s; the first is at t = 0.
    acceleration
        m/s², (n, 3) for x, y and z, or (n,) for x alone; n from 2 to ten million.

    Examples
    --------
    >>> import rimroll as rr
    >>> rr.ground.sampled(0.01, [0.0, 1.0, 3.0])(0.015).tolist()
    [2.0, 0.0, 0.0]
    """
    interval = positive("step", step, "s")
    given = numbers("acceleration", acceleration, "m/s^2")
    samples = given if given.ndim == 2 else along("x", given)
    if samples.shape[1:] != (3,):
        hint = f": transpose it to {given.shape[::-1]}" if given.shape[:-1] == (3,) else ""
        raise RimrollError(
            f"must have the shape (n, 3), or (n,) for x alone, got {given.shape}{hint}",
            "acceleration",
        )
    if len(samples) > MAX_POINTS:
        raise RimrollError(
            f"must have at most {MAX_POINTS} samples, got {len(samples)}", "acceleration"
        )
    return Ground(_core.CoreGround.from_samples(interval, samples))


def along(axis: str, acceleration: Array) -> Array:
    """The vectors (n, 3) of an acceleration (n,) along x, y or z; anything else as it is."""
    if acceleration.ndim != 1:
        return acceleration
    samples = np.zeros((len(acceleration), 3))
    samples[:, "xyz".index(axis)] = acceleration
    return samples


def function(
    f: Callable[[float], float | Sequence[float] | Array], duration: Number, step: Number
) -> Ground:
    """A record of your own function of time, sampled.

    Between samples it is a straight line, which differs from a smooth function by at most
    step²/8 · max|f″|: for a sine of period T by 5 (step/T)² of its amplitude. Jumps become ramps
    one step long; for pulses with jumps use :func:`rectangular` or :func:`cosine`.

    Raises ``RimrollError`` where the function returns anything else, and for more than ten million
    samples.

    Parameters
    ----------
    f
        Takes a time (s) and returns the acceleration, m/s²: a number, along x alone, or three (x,
        y, z). It is called with one time at a time.
    duration
        The time from which on the ground is at rest, s.
    step
        The largest time between two samples, s. It is shortened so that it divides the duration.

    Examples
    --------
    >>> import math
    >>> import rimroll as rr
    >>> ground = rr.ground.function(lambda t: 2.0 * math.exp(-t) * math.sin(9.0 * t), 8.0, 0.001)
    >>> round(ground.peak.x, 4)
    1.6901
    """
    if not callable(f):
        raise RimrollError(field="f", value=f, bound="a function of the time")
    end, largest = positive("duration", duration, "s"), positive("step", step, "s")
    if not end / largest <= MAX_POINTS - 1:
        raise RimrollError(f"duration/step must be below {MAX_POINTS}, got {end / largest:g}")
    count = max(1, math.ceil(end / largest * (1.0 - 1e-12)))
    interval = end / count
    values = [numbers(f"f({i * interval:g})", f(i * interval), "m/s^2") for i in range(count + 1)]
    for i, value in enumerate(values):
        if value.shape != values[0].shape or value.shape not in ((), (3,)):
            raise RimrollError(
                f"f({i * interval:g}) must be a number, or three (x, y, z), as for all times, got"
                f" an array of shape {value.shape}"
            )
        if not np.all(np.isfinite(value)):
            raise RimrollError(f"f({i * interval:g}) must be finite, got {value}")
    return sampled(interval, np.array(values))


def synthetic(
    seed: int,
    amplitude: Values = 3.0,
    *,
    duration: Number = 20.0,
    step: Number = 0.01,
    soil_period: Number = 0.4,
    soil_damping: Number = 0.6,
) -> Ground:
    """A synthetic record, which resembles an earthquake and is none.

    Gaussian white noise, independent in each component, under an envelope that rises as t² in the
    first tenth of the duration, is constant for three tenths and then decays exponentially to 5 %
    (Jennings), passes the filter of Kanai and Tajimi, a layer of soil on rock, and the high-pass
    filter of Clough and Penzien, which removes drift. Each component is scaled to its peak.

    Raises ``RimrollError`` for numbers that are not positive (an amplitude may be 0), and for fewer
    than 100 samples or more than ten million.

    Parameters
    ----------
    seed
        A whole number; the same seed gives the same record, to the last bit, on every machine.
    amplitude
        The peak, m/s²: a number, along x alone, or three (x, y, z).
    duration, step
        Length of the record and time between two samples, s.
    soil_period, soil_damping
        Natural period (s) and damping ratio of the soil; firm soil has 0.4 s and 0.6.

    Examples
    --------
    >>> import rimroll as rr
    >>> rr.ground.synthetic(1, amplitude=("0.3 g", "0.3 g", "0.2 g"))
    <Ground of 2001 samples at 0.01 s: 20 s, peaks 2.942, 2.942, 1.961 m/s²>
    """
    peaks = numbers("amplitude", amplitude, "m/s^2")
    if peaks.shape not in ((), (3,)):
        raise RimrollError(
            field="amplitude", value=amplitude, bound="one number or three (x, y, z)"
        )
    hold("amplitude", peaks, (peaks >= 0.0) & (peaks <= 1e9), "between 0 and 1e9", "m/s^2")
    end, interval = positive("duration", duration, "s"), positive("step", step, "s")
    count = round(end / interval) if end / interval < 1e9 else MAX_POINTS
    if not 100 <= count + 1 <= MAX_POINTS:
        raise RimrollError(
            f"duration/step must be between 100 and {MAX_POINTS}, got {end / interval:g}"
        )
    soil = positive("soil_period", soil_period, "s"), positive("soil_damping", soil_damping)
    wanted = peaks.tolist() if peaks.ndim else [float(peaks), 0.0, 0.0]
    return Ground(_core.CoreGround.synthetic(random_seed(seed), wanted, interval, count + 1, *soil))
