"""Points that fill a cube evenly: Sobol's sequence in five dimensions, scrambled.

Direction numbers by Joe and Kuo (SIAM J. Sci. Comput. 30, 2008), scrambled by random lower
triangular matrices and a random shift (Matoušek, J. Complexity 14, 1998). The points are those of
``scipy.stats.qmc.Sobol(5, seed=2007)``, whose import takes longer than a fit.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

DIMENSIONS = 5
SEED = 2007
BITS = 30
"""Each number has this many binary digits, which allows for up to 2³⁰ points."""

_STARTS = ((1, 0, (1,)), (2, 1, (1, 3)), (3, 1, (1, 3, 1)), (3, 2, (1, 1, 1)))
"""Degree and coefficients of the primitive polynomial, and first direction numbers, of all
dimensions but the first."""

Words = NDArray[np.uint32]


def points(count: int) -> NDArray[np.float64]:
    """The first ``count`` points (count, 5), inside the unit cube."""
    rng = np.random.default_rng(SEED)
    weights = np.uint32(1) << np.arange(BITS, dtype=np.uint32)
    shift = rng.integers(2, size=(DIMENSIONS, BITS), dtype=np.uint32) @ weights
    matrices = np.tril(rng.integers(2, size=(DIMENSIONS, BITS, BITS), dtype=np.uint32))
    matrices[:, np.arange(BITS), np.arange(BITS)] = 1
    directions = np.array([_scrambled(_directions(d), matrices[d]) for d in range(DIMENSIONS)])
    index = np.arange(count, dtype=np.uint32)
    gray = index ^ (index >> np.uint32(1))
    found = np.repeat(shift[None, :].astype(np.uint32), count, axis=0)
    for bit in range(BITS):
        odd = (gray >> np.uint32(bit) & np.uint32(1)).astype(bool)
        found[odd] ^= directions[:, bit]
    return np.asarray(found * 2.0**-BITS)


def _directions(dimension: int) -> Words:
    """Direction numbers (BITS,) of one dimension, as words of ``BITS`` bits."""
    if dimension == 0:
        numbers = [1] * BITS
    else:
        degree, coefficients, first = _STARTS[dimension - 1]
        numbers = list(first)
        for _ in range(BITS - degree):
            new = numbers[-degree] ^ numbers[-degree] << degree
            for k in range(1, degree):
                new ^= (coefficients >> (degree - 1 - k) & 1) * numbers[-k] << k
            numbers.append(new)
    return np.array([m << (BITS - 1 - j) for j, m in enumerate(numbers)], dtype=np.uint32)


def _scrambled(directions: Words, matrix: Words) -> Words:
    """Direction numbers whose binary digits, the highest first, a matrix has multiplied."""
    places = np.arange(BITS - 1, -1, -1, dtype=np.uint32)
    digits = directions[:, None] >> places & np.uint32(1)
    return np.asarray((digits @ matrix.T % 2 << places).sum(axis=1, dtype=np.uint32))
