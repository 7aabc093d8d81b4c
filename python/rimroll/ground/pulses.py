"""Pulses of the ground in closed form.

An amplitude is a number, along x alone, or three (x, y, z). Other arguments are one number for all
components, or three.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from rimroll import _core
from rimroll.errors import RimrollError, hold
from rimroll.given import Values, numbers
from rimroll.ground.ground import Ground

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
