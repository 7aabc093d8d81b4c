"""Motions of the ground: pulses, records, and files of records.

The table translates with an acceleration along x, y and z (upward) and does not turn. Amplitudes
and records are accelerations in m/s² unless they say otherwise; ``"0.3 g"`` is 0.3 of the standard
gravity.

>>> import rimroll as rr
>>> ground = rr.ground.sine(amplitude=("0.3 g", 1.5, 0.0), period=(1.2, 0.8, 1.0), cycles=(1, 2, 1))
>>> ground.duration
1.6
>>> ground([0.3, 0.6]).round(3).tolist()
[[2.942, 1.061, 0.0], [0.0, -1.5, 0.0]]
"""

from rimroll.ground.files import read, read_all
from rimroll.ground.lines import Peak
from rimroll.ground.pulses import (
    cosine,
    function,
    half_sine,
    rectangular,
    ricker,
    sampled,
    sine,
    synthetic,
)
from rimroll.ground.streams import from_obspy

__all__ = [
    "Peak",
    "cosine",
    "from_obspy",
    "function",
    "half_sine",
    "read",
    "read_all",
    "rectangular",
    "ricker",
    "sampled",
    "sine",
    "synthetic",
]
