"""Sums of floats that are exact, so that they depend on neither order nor chunks.

A number is cut into six whole numbers of 32 bits, which count multiples of 2³², 1, 2⁻³², ... 2⁻¹²⁸.
Sums of these are whole numbers; what of one exceeds 32 bits is carried to the piece before it. One
more piece, of multiples of 2⁶⁴, takes what the others cannot hold, so that 2⁶³ numbers have a sum.
What of a number is below 2⁻¹²⁸ is dropped.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from rimroll.errors import RimrollError

PIECES = 7
"""The first one is for what is carried: numbers themselves have none of it."""

BITS = 32
TOP = 64
"""Numbers must be below 2 to this power."""

UNIT = TOP - (PIECES - 1) * BITS
"""The last piece counts multiples of 2 to this power."""


def sums(values: NDArray[np.float64], place: NDArray[np.int64], count: int) -> NDArray[np.int64]:
    """The sum of the finite values (n,) of each of ``count`` places, in pieces (count, 7).

    Raises ``RimrollError`` for a finite value of 2⁶⁴ or more.
    """
    found = np.zeros((count, PIECES), np.int64)
    finite = np.isfinite(values)
    values, place = values[finite], place[finite]
    rest = np.abs(values) * 2.0**-TOP
    if (rest >= 1.0).any():
        raise RimrollError(f"sums are of numbers below 2^{TOP}, got {np.abs(values).max():g}")
    signs = np.sign(values).astype(np.int64)
    for k in range(1, PIECES):
        rest = rest * 2.0**BITS
        whole = np.floor(rest)
        rest -= whole
        np.add.at(found[:, k], place, signs * whole.astype(np.int64))
    return found


def added(one: NDArray[np.int64], other: NDArray[np.int64]) -> NDArray[np.int64]:
    """The sums of two arrays of sums (n, 7), of fewer than 2³⁰ numbers or themselves added.

    All pieces but the first are between 0 and 2³², so that there is always room for more.
    """
    found = one + other
    for k in range(PIECES - 1, 0, -1):
        found[:, k - 1] += found[:, k] >> BITS  # rounded down, also below zero
        found[:, k] &= (1 << BITS) - 1
    return found


def whole(pieces: NDArray[np.int64]) -> int:
    """A sum (7,) as a multiple of 2⁻¹²⁸."""
    total = 0
    for piece in pieces.tolist():
        total = (total << BITS) + piece
    return total


def quotient(total: int, divisor: int) -> float:
    """A sum, as a multiple of 2⁻¹²⁸, over a whole number: the nearest float."""
    return total / (divisor << -UNIT)


def mean(pieces: NDArray[np.int64], number: int) -> float:
    """The mean of ``number`` values; NaN for none."""
    return quotient(whole(pieces), number) if number else math.nan


def deviation(pieces: NDArray[np.int64], squares: NDArray[np.int64], number: int) -> float:
    """The standard deviation of a sample, with divisor n − 1; NaN for fewer than two values."""
    if number < 2:
        return math.nan
    total, square = whole(pieces), whole(squares)
    spread = (number * square << -UNIT) - total * total  # n Σx² − (Σx)², in 2⁻²⁵⁶
    return math.sqrt(max(spread, 0) / (number * (number - 1) << -2 * UNIT))
