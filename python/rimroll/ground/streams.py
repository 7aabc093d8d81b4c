"""Records of ObsPy, which is not imported."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from rimroll.errors import RimrollError
from rimroll.files.titles import expect_step
from rimroll.ground.columns import (
    RECORD,
    STRONGEST,
    axis_of_channel,
    expect_strength,
    factor_of_unit,
)
from rimroll.ground.ground import Ground
from rimroll.ground.pulses import sampled
from rimroll.units import numbers, positive

Array = NDArray[np.float64]

EAST = np.pi / 2.0


def from_obspy(stream: Iterable[Any], units: str) -> Ground:
    """The record of a stream of ObsPy, which reads miniSEED, SAC, K-NET and many other formats.

    Raises ``RimrollError`` for a unit that is no acceleration, for traces with gaps, of another
    component, or that differ in sampling, length or beginning; and for data that no record has,
    such as counts.

    Parameters
    ----------
    stream
        One to three traces of one station with equal sampling. The last letter of a channel says
        the component: E is x, N is y and Z, upward, is z; or X, Y, Z; or EW, NS and UD of K-NET,
        with 1 or 2 behind them for KiK-net. Others must be rotated first, as by
        ``stream.rotate("->ZNE", inventory=...)``. The data are multiplied by ``stats.calib``, as
        K-NET's counts need it, unless the instrument's response was removed.
    units
        The unit of the data times ``stats.calib``, which must be an acceleration: ``"m/s2"`` (as
        for K-NET), ``"g"``, ``"gal"``. Counts without such a factor must be converted first, as by
        ``stream.remove_response(output="ACC")``.
    """
    try:
        traces = list(stream)
        named = [(str(trace.stats.channel), trace) for trace in traces]
    except (TypeError, AttributeError):
        raise RimrollError(field="stream", value=stream, bound="a stream of ObsPy") from None
    if not traces:
        raise RimrollError("must have one to three traces, got none", "stream")
    factor = factor_of_unit(units, "units")
    first = traces[0]
    step = positive(f"the step of {named[0][0]}", first.stats.delta, "s")
    expect_step(f"{named[0][0]}: stats.delta", RECORD, step, is_stated=True)
    samples = np.zeros((len(first.data), 3))
    axes: dict[str, bool] = {}
    for channel, trace in named:
        found = axis_of_channel(channel) or axis_of_channel(channel[-1:])
        if found is None:
            raise RimrollError(
                f"the channel {channel!r} ends with none of E, N, Z, X, Y: rotate the stream first,"
                ' as by stream.rotate("->ZNE", inventory=...)'
            )
        axis, is_compass = found
        if axis in axes:
            raise RimrollError(
                f"stream has more than one trace along {axis}, {channel} among them: merge its"
                " traces first, and choose one station and one depth"
            )
        axes[axis] = is_compass
        _expect_same(named[0][0], first, channel, trace)
        samples[:, "xyz".index(axis)] = _accelerations(channel, trace, factor)
    heading = EAST if any(axes.values()) else None
    return Ground(sampled(step, samples).core, heading)


CONVERTED = ("remove_response", "remove_sensitivity", "simulate")
"""Methods of ObsPy after which data are no counts any more."""
FAINT = 1e-3
"""The peak below which a record looks as if it had been calibrated twice, m/s²."""


def _accelerations(channel: str, trace: Any, factor: float) -> Array:
    """The data of a trace, m/s², with the factor of its calibration."""
    data = factor * numbers(f"the data of {channel}", trace.data)
    calib = float(getattr(trace.stats, "calib", 1.0))
    history = " ".join(map(str, getattr(trace.stats, "processing", ())))
    before = float(np.nanmax(np.abs(data), initial=0.0))
    if calib == 1.0 or any(f"{method}(" in history for method in CONVERTED):
        expect_strength(channel, before)
        return data
    if not (np.isfinite(calib) and calib != 0.0):
        raise RimrollError(f"{channel}: stats.calib must be a factor, got {calib}")
    after = abs(calib) * before
    if after < FAINT < before <= STRONGEST:
        raise RimrollError(
            f"{channel}: stats.calib is {calib:.3g}, with which its peak would be {after:.2g} m/s²"
            f" instead of {before:.2g}: if it was applied already, set trace.stats.calib = 1"
        )
    expect_strength(f"{channel}, stats.calib applied", after)
    return calib * data


def _expect_same(first_name: str, first: Any, name: str, trace: Any) -> None:
    """Refuse a trace whose samples are at other times than those of the first."""
    mine, others = first.stats, trace.stats
    for what, one, other in (
        ("a step of", mine.delta, others.delta),
        ("a length of", len(first.data), len(trace.data)),
    ):
        if one != other:
            raise RimrollError(f"{name} has {what} {other}, but {first_name} has {what} {one}")
    begins: list[Any] = [getattr(stats, "starttime", None) for stats in (mine, others)]
    if None not in begins and abs(float(begins[0] - begins[1])) > 0.5 * mine.delta:
        raise RimrollError(f"{name} begins at {begins[1]}, but {first_name} at {begins[0]}")
