"""Records of ObsPy, which is not imported."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np

from rimroll.errors import RimrollError
from rimroll.given import numbers, positive
from rimroll.ground.ground import Ground
from rimroll.ground.names import factor_of_unit
from rimroll.ground.records import sampled

AXIS_OF = {"E": "x", "N": "y", "Z": "z", "X": "x", "Y": "y"}
"""The axis of each last letter of a channel."""

EAST = np.pi / 2.0


def from_obspy(stream: Iterable[Any], units: str) -> Ground:
    """The record of a stream of ObsPy, which reads miniSEED, SAC, K-NET and many other formats.

    Raises ``RimrollError`` for a unit that is no acceleration, for traces with gaps, of another
    component, or that differ in sampling, length or beginning.

    Parameters
    ----------
    stream
        One to three traces of one station with equal sampling. The last letter of a channel says
        the component: E is x, N is y and Z, upward, is z; or X, Y, Z. Others must be rotated first,
        as by ``stream.rotate("->ZNE", inventory=...)``.
    units
        The unit of the data, which must be an acceleration: ``"m/s2"``, ``"g"``, ``"gal"``. Counts
        must be converted first, as by ``stream.remove_response(output="ACC")``.
    """
    try:
        traces = list(stream)
        named = [(str(trace.stats.channel), trace) for trace in traces]
    except (TypeError, AttributeError):
        raise RimrollError(f"stream must be a stream of ObsPy, got {stream!r}") from None
    if not traces:
        raise RimrollError("stream must have one to three traces, got none")
    factor = factor_of_unit(units, "units")
    first = traces[0]
    step = positive(f"the step of {named[0][0]}", first.stats.delta, "s")
    samples = np.zeros((len(first.data), 3))
    letters: list[str] = []
    for channel, trace in named:
        data = numbers(f"the data of {channel}", trace.data)
        letter = channel[-1:].upper()
        if letter not in AXIS_OF:
            raise RimrollError(
                f"the channel {channel!r} ends with none of E, N, Z, X, Y: rotate the stream first,"
                ' as by stream.rotate("->ZNE", inventory=...)'
            )
        if AXIS_OF[letter] in (AXIS_OF[other] for other in letters):
            raise RimrollError(
                f"stream has more than one trace along {AXIS_OF[letter]}: merge its traces first,"
                " and choose one station"
            )
        letters.append(letter)
        _expect_same(named[0][0], first, channel, trace)
        samples[:, "xyz".index(AXIS_OF[letter])] = factor * data
    heading = EAST if {"E", "N"} & set(letters) else None
    return Ground(sampled(step, samples).core, heading)


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
