"""What the fit of a motion to a film found, and its figure."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from rimroll.laws import Law
from rimroll.motion import Motion
from rimroll.sensors.filmed.track import Track
from rimroll.sensors.fits import Estimate

if TYPE_CHECKING:
    from matplotlib.axes import Axes
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


def track_figure(fit: TrackFit) -> Figure:
    """Draw (a) the film and the fitted motion in the plane, (b) over the time."""
    from rimroll.figures import style

    with style.figure_style():
        figure = style.page(70.0)
        grid = figure.add_gridspec(1, 2, width_ratios=(1.0, 1.5))
        _draw_plane(figure.add_subplot(grid[0, 0]), fit)
        _draw_times(figure.add_subplot(grid[0, 1]), fit)
        return style.settle(figure)


def _units(fit: TrackFit) -> tuple[float, str]:
    return (1e3, "mm") if fit.track.kind == "path" else (float(np.degrees(1.0)), "degrees")


def _draw_plane(ax: Axes, fit: TrackFit) -> None:
    from rimroll.figures import style

    factor, unit = _units(fit)
    seen = factor * fit.track.plane()
    ax.plot(seen.real, seen.imag, "o", ms=2.0, mfc="white", mew=0.6, color="#D55E00", label="film")
    shown = factor * fit.shown
    if fit.track.kind == "tilt":
        shown = np.abs(shown) + 0j
    ax.plot(shown.real, shown.imag, color="#0072B2", lw=0.9, label="fitted motion")
    ax.set_aspect("equal", adjustable="datalim")
    ax.legend()
    title = "marker from above" if fit.track.kind == "path" else "tilt along its direction"
    style.label(ax, "a", title, f"x ({unit})", f"y ({unit})")


def _draw_times(ax: Axes, fit: TrackFit) -> None:
    from rimroll.figures import style

    factor, unit = _units(fit)
    seen = fit.track.plane()
    for part, marker in ((np.real, "o"), (np.imag, "s")):
        ax.plot(
            fit.track.t, factor * part(seen), marker, ms=2.0, mfc="white", mew=0.6, color="#D55E00"
        )
        shown = np.abs(fit.shown) + 0j if fit.track.kind == "tilt" else fit.shown
        ax.plot(fit.t, factor * part(shown), color="#0072B2", lw=0.9)
    style.label(ax, "b", "x (circles) and y (squares)", "time (s)", unit)
