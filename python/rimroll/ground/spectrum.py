"""Response spectra."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from rimroll.errors import RimrollError, hold
from rimroll.ground.lines import MAX_POINTS, Lines, along, combined
from rimroll.units import Number, Values, number, numbers

if TYPE_CHECKING:
    import xarray as xr

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]

PER_PERIOD = 16
"""Points in each period of an oscillator."""

ROUNDING = 1e-6
"""The part of a step by which rounding may move a time."""


def response_spectrum(lines: Lines, periods: Values, damping: Number) -> xr.Dataset:
    """What :meth:`rimroll.ground.ground.Ground.response_spectrum` gives."""
    import xarray as xr

    period = numbers("periods", periods, "s")
    if period.ndim != 1 or not period.size:
        raise RimrollError(f"must be a flat array, got shape {period.shape}", "periods")
    hold("periods", period, (period > 0.0) & np.isfinite(period), "> 0 and finite", "s")
    ratio = _damping_ratio(damping)
    largest = np.array([_highest(*oscillation(lines, one, ratio)) for one in period.tolist()])
    omega = (2.0 * math.pi / period)[:, np.newaxis]
    dims = ("period", "component")
    return xr.Dataset(
        {
            "displacement": (dims, largest, {"units": "m"}),
            "pseudo_velocity": (dims, omega * largest, {"units": "m/s"}),
            "pseudo_acceleration": (dims, omega**2 * largest, {"units": "m/s^2"}),
        },
        coords={"period": ("period", period, {"units": "s"}), "component": list("xyz")},
        attrs={"damping": ratio},
    )


def _damping_ratio(damping: Number) -> float:
    ratio = number("damping", damping)
    if not 0.0 <= ratio < 1.0:
        raise RimrollError(field="damping", value=ratio, bound="between 0 and below 1")
    return ratio


def spectral_acceleration(lines: Lines, period: float, damping: Number, how: str) -> float:
    """The horizontal pseudo-acceleration of one oscillator, m/s², by one of ``HORIZONTAL``."""
    u, moved = oscillation(lines, period, _damping_ratio(damping))

    def largest(directions: Array) -> Array:
        return _highest(along(u.T, directions), along(moved.T, directions))

    return (2.0 * math.pi / period) ** 2 * combined(largest, how)


def oscillation(lines: Lines, period: float, damping: float) -> tuple[Array, Array]:
    """The displacements of an oscillator along x, y and z, and their slopes per step, (3, n), m.

    u″ + 2ζωu′ + ω²u = −a is solved by u = Im q/ω′ with q′ = s q − a, s = −ζω + iω′ and
    ω′ = ω √(1 − ζ²). Over a line of the acceleration the integral of this is exact.
    """
    from scipy.signal import lfilter

    omega = 2.0 * math.pi / period
    s = complex(-damping * omega, omega * math.sqrt(1.0 - damping**2))
    end = float(lines.t[-1])
    step = lines.scale / math.ceil(lines.scale * PER_PERIOD / period)
    shaken, free = end / step, period / step
    if not shaken + free + len(lines.t) <= MAX_POINTS:
        raise RimrollError(
            f"a period of {period:g} s needs more than {MAX_POINTS} points: it must be longer"
        )
    forces = np.zeros((3, math.ceil(shaken - ROUNDING) + math.ceil(free)), np.complex128)
    during = _forces(lines, s, step, math.ceil(shaken - ROUNDING))
    forces[:, : during.shape[1]] = during
    q = lfilter([1.0], [1.0, -np.exp(s * step)], forces)
    return q.imag / s.imag, step * (s * q).imag / s.imag


def _forces(lines: Lines, s: complex, step: float, count: int) -> Complex:
    """What the ground adds to q in each of the first steps, (3, count)."""
    begins = np.arange(count) * step
    t = np.union1d(begins, lines.t)
    a = np.stack([np.interp(t, lines.t, values) for values in lines.acceleration.T])
    length = np.diff(t)
    # The integrals of e^(s (length − t)), and of it times t/length.
    grown = np.expm1(s * length)
    constant, rising = grown / s, (grown - s * length) / (s * s * length)
    of_line: Complex = rising * (a[:, :-1] - a[:, 1:]) - constant * a[:, :-1]
    ends = np.append(begins[1:], count * step)
    first = np.searchsorted(t, begins)
    cell = np.repeat(np.arange(count), np.diff(np.append(first, len(t) - 1)))
    return np.add.reduceat(of_line * np.exp(s * (ends[cell] - t[1:])), first, axis=1)


def _highest(u: Array, moved: Array) -> Array:
    """The largest magnitude of curves (k, n), which begin at 0, between their points, too.

    ``moved`` is their slope per step. Between two points the curve is Hermite's cubic, with the
    extremum at the root of a quadratic.
    """
    u, moved = (np.pad(values, ((0, 0), (1, 0))) for values in (u, moved))
    turns = moved[:, :-1] * moved[:, 1:] < 0.0
    u0, u1, m0, m1 = u[:, :-1][turns], u[:, 1:][turns], moved[:, :-1][turns], moved[:, 1:][turns]
    square, cube = 3.0 * (u1 - u0) - 2.0 * m0 - m1, 2.0 * (u0 - u1) + m0 + m1
    root = np.copysign(np.sqrt(square**2 - 3.0 * cube * m0), m0)
    x = -m0 / (square - root)
    between = np.zeros(turns.shape)
    between[turns] = u0 + x * (m0 + x * (square + x * cube))
    highest: Array = np.maximum(np.abs(u).max(axis=1), np.abs(between).max(axis=1))
    return highest
