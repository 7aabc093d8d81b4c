"""What the fit of a motion to a film found."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from rimroll.filmed.track import Track
from rimroll.gyro.motions.result import Estimate
from rimroll.laws import Law
from rimroll.motion import Motion

if TYPE_CHECKING:
    from matplotlib.figure import Figure

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False, repr=False)
class TrackFit:
    """A motion that was fitted to a film: see :func:`fit_track`.

    Attributes
    ----------
    track
        What it was fitted to.
    law
        The law with the numbers that suit best.
    motion
        The fitted motion; it begins at the release.
    numbers
        The fitted numbers by name: those of the law, the start, ``camera`` (the direction of yaw 0
        in the film, rad), ``release`` (s in the film), ``origin_x`` and ``origin_y`` (m),
        ``scale``, and the deviations of the body.
    t, shown
        Times of the fitted samples, and where the fitted motion shows the marker (x + i y, m), or
        the lean (tilt along its direction, rad).
    residuals
        Motion less film, (n, 2), or (n, 1) for tilts alone, m or rad.
    inflation
        The factor by which the squares of residuals exceed the stated error, times the number of
        residuals that hang together; all variances contain it.
    notes
        What to know about it, a sentence each.
    """

    track: Track
    law: Law
    motion: Motion
    numbers: dict[str, Estimate]
    t: Array
    shown: NDArray[np.complex128]
    residuals: Array
    inflation: float
    notes: list[str]

    def __repr__(self) -> str:
        unit = "m" if self.track.kind == "path" else "rad"
        return f"<Track fit: {self.law!r}, residual {self.residual:.2g} {unit}>"

    @property
    def residual(self) -> float:
        """Root mean square of the residuals, m or rad."""
        return float(np.sqrt(np.mean(self.residuals**2)))

    @property
    def friction(self) -> Estimate | None:
        """The friction; None where the law has none that is fitted."""
        return self.numbers.get("friction")

    def plot(self) -> Figure:
        """The filmed track and the fitted one."""
        from rimroll.filmed.figure import track_figure

        return track_figure(self)

    def to_dict(self) -> dict[str, Any]:
        """Everything that was fitted, as plain numbers in SI units and radians."""
        return {
            "law": repr(self.law),
            "numbers": {
                name: {
                    "value": one.value,
                    "error": one.error,
                    "interval": list(one.interval),
                    "method": one.method,
                }
                for name, one in self.numbers.items()
            },
            "residual": self.residual,
            "inflation": self.inflation,
            "notes": self.notes,
        }
