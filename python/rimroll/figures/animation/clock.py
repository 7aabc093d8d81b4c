"""Film time and the motion's time: slower where the contact point runs."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from rimroll.errors import RimrollError
from rimroll.figures.scene import Array, Motion

PACE = (
    1.1 * np.pi
)  # rad of yaw per second of film: as fast as the eye follows the contact point easily
LONGEST = 1.5  # the runs of the contact point take at most this many times the rest of the film


@dataclass(frozen=True)
class FilmClock:
    """A monotone map between film time and the motion's time, both (n,), s."""

    film: Array
    t: Array

    @property
    def seconds(self) -> float:
        """Length of the film, s."""
        return float(self.film[-1])

    def times(self, film: Array) -> Array:
        """The motion's times at film times, s."""
        return np.interp(film, self.film, self.t)

    def slowdown(self, film: Array) -> Array:
        """Film seconds per second of the motion at film times; infinite if no time passes."""
        step = np.clip(np.searchsorted(self.film, film, side="right") - 1, 0, len(self.t) - 2)
        with np.errstate(divide="ignore"):
            return np.asarray(np.diff(self.film)[step] / np.diff(self.t)[step])


def film_clock(
    motion: Motion, *, speed: float, seconds: float | None = None, slow_collision: bool = True
) -> FilmClock:
    """Film time at the motion's own samples, which are dense where the contact point runs.

    Film time is t / ``speed``, plus time for the yaw that the film could not show at that speed.
    ``seconds`` stretches the whole film to a given length. A run that is shorter than the spacing
    of floating-point times takes one step.
    """
    for name, value in (("speed", speed), ("seconds", 1.0 if seconds is None else seconds)):
        if not 0.0 < value < np.inf:
            raise RimrollError(f"{name} is {value:g}; it must be positive and finite")
    steps = np.arange(len(motion.t))
    # Four points a step: the yaw is far from linear in time within one step of the solver.
    t = np.interp(np.linspace(0, steps[-1], 4 * steps[-1] + 1), steps, motion.t)
    t = t[np.append(True, np.diff(t) > 0.0)]
    if len(t) < 2:
        raise RimrollError("the motion has no duration: there is nothing to film")
    plain = np.diff(t) / speed
    film = plain
    if slow_collision:
        excess = np.clip(np.abs(np.diff(motion.evaluate(t).yaw)) - PACE * plain, 0.0, None)
        run = excess / PACE
        film = plain + run * min(1.0, LONGEST * plain.sum() / max(run.sum(), 1e-300))
    film = np.append(0.0, np.cumsum(film))
    if seconds is not None:
        film *= seconds / film[-1]
    return FilmClock(film, t)


def slowed(factor: float) -> str:
    """The caption of a film that is ``factor`` times slower than the motion, in two digits."""
    if not np.isfinite(factor):
        return "time stands still"
    if factor < 0.95:
        return f"sped up {1.0 / factor:.2g}×"
    if factor < 1.05:
        return "real time"
    if factor < 9.5:
        return f"slowed {factor:.2g}×"
    power = 10.0 ** (np.floor(np.log10(factor)) - 1.0)
    return f"slowed {round(factor / power) * power:,.0f}×"
