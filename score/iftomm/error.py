"""The error of a result file of the rocking can: ``python error.py RESULT.txt``.

It needs NumPy alone, and the reference beside it.
"""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

REFERENCE = Path(__file__).with_name("reference.txt")
RADIUS = 0.051
"""m"""
COLUMNS = 8
"""Time (s), centre of mass x, y, z (m), axis x, y, z, energy (J)."""
LARGEST_ERROR, LARGEST_ENERGY = 1e-2, 1e-2
"""Beyond these a result is not acceptable; the second is a fraction of the initial energy."""


class BadResult(ValueError):
    """A file is no result of this problem; the message says why."""


def read(file: Path) -> Array:
    """The rows of a result file. Lines that begin with # are left out."""
    try:
        rows = np.loadtxt(file, ndmin=2)
    except ValueError as error:
        raise BadResult(f"{file} is no table of numbers: {error}") from None
    if rows.shape[1:] != (COLUMNS,):
        raise BadResult(f"{file} has {rows.shape[1]} columns; it must have {COLUMNS}")
    if not np.isfinite(rows).all():
        raise BadResult(f"{file} has numbers that are not finite")
    return rows


def errors(result: Array, reference: Array) -> tuple[float, float]:
    """The error of the motion, and the largest change of the energy as a fraction of the initial.

    The first is the root of the mean over all times of |r - r'|²/R² + |k - k'|², where r is the
    place of the centre of mass and k the axis.
    """
    if result.shape != reference.shape or np.abs(result[:, 0] - reference[:, 0]).max() > 1e-9:
        last = reference[-1, 0]
        raise BadResult(f"the times must be {len(reference)}, evenly spaced from 0 to {last:g} s")
    off = result - reference
    squares = (off[:, 1:4] ** 2).sum(axis=1) / RADIUS**2 + (off[:, 4:7] ** 2).sum(axis=1)
    energy = result[:, 7]
    return float(np.sqrt(squares.mean())), float(np.abs(energy / energy[0] - 1.0).max())


def main(name: str) -> int:
    """Tell the error of a file; 1 if it is not acceptable, 2 if it is no result."""
    try:
        error, energy = errors(read(Path(name)), read(REFERENCE))
    except (BadResult, OSError) as problem:
        print(problem, file=sys.stderr)
        return 2
    print(f"error {error:.3g}, change of energy {energy:.3g}")
    return int(error > LARGEST_ERROR or energy > LARGEST_ENERGY)


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    sys.exit(main(sys.argv[1]))
