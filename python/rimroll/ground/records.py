"""Records from arrays and from functions of time."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence

import numpy as np
from numpy.typing import NDArray

from rimroll import _core
from rimroll.errors import RimrollError
from rimroll.given import Number, Values, numbers, positive
from rimroll.ground.ground import Ground
from rimroll.ground.lines import MAX_POINTS

Array = NDArray[np.float64]


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
