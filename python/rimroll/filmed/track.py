"""What a film shows of a body: the path of a marker from above, or angles."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from rimroll.errors import RimrollError

Array = NDArray[np.float64]

MIN_SAMPLES = 12
"""Samples that a track must have."""
KINDS = ("path", "lean", "tilt")


@dataclass(frozen=True, eq=False, repr=False)
class Track:
    """The path of a marker seen from above, or the lean of a body, at times.

    Raises ``RimrollError`` for fewer than 12 samples, for times that do not increase, and for
    numbers that are not finite.

    Attributes
    ----------
    t
        Times, s, (n,), increasing.
    values
        (n, 2) for ``"path"``, x and y in m; (n, 2) for ``"lean"``, tilt and direction of lean in
        rad; (n, 1) for ``"tilt"``, the tilt in rad.
    kind
        ``"path"``, ``"lean"`` or ``"tilt"``.
    name, source, notes
        What messages call it, how the file was understood, and what is unusual.
    """

    t: Array
    values: Array
    kind: str = "path"
    name: str = "a track"
    source: str = ""
    notes: tuple[str, ...] = ()

    def __post_init__(self) -> None:
        if self.kind not in KINDS:
            raise RimrollError(field="kind", value=self.kind, bound='"path", "lean" or "tilt"')
        t, values = np.asarray(self.t, float), np.asarray(self.values, float)
        width = 1 if self.kind == "tilt" else 2
        if t.ndim != 1 or values.shape != (len(t), width):
            raise RimrollError(
                f"{self.name}: times must be (n,) and values (n, {width}),"
                f" got {t.shape} and {values.shape}"
            )
        if len(t) < MIN_SAMPLES:
            raise RimrollError(
                f"{self.name} must have at least {MIN_SAMPLES} samples, it has {len(t)}"
            )
        if not (np.isfinite(t).all() and np.isfinite(values).all()):
            raise RimrollError(f"{self.name} has numbers that are not finite")
        if not (np.diff(t) > 0.0).all():
            raise RimrollError(f"{self.name}: the times must increase: keep one run")
        object.__setattr__(self, "t", t)
        object.__setattr__(self, "values", values)

    def __repr__(self) -> str:
        return f"<Track: {self.kind}, {len(self.t)} samples over {self.t[-1] - self.t[0]:.2f} s>"

    def plane(self) -> NDArray[np.complex128]:
        """The track in a plane: x + i y in m, or the tilt, in rad, along the direction of lean."""
        if self.kind == "path":
            return np.asarray(self.values[:, 0] + 1j * self.values[:, 1])
        if self.kind == "lean":
            return np.asarray(self.values[:, 0] * np.exp(1j * self.values[:, 1]))
        return np.asarray(self.values[:, 0] + 0j)
