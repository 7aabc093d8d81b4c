"""Files as the app phyphox exports them from its experiment "Gyroscope (rotation rate)"."""

from __future__ import annotations

import os
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from rimroll.output import writing

if TYPE_CHECKING:
    from rimroll.gyro.record import Record

TITLES = (
    "Time (s)",
    "Gyroscope x (rad/s)",
    "Gyroscope y (rad/s)",
    "Gyroscope z (rad/s)",
    "Absolute (rad/s)",
)

SIMULATED = "# simulated by rimroll, not measured"
"""The first line of a file that holds a simulated record."""


def write(path: str | os.PathLike[str], record: Record) -> Path:
    """Write the record as such a file, with commas and decimal points."""
    with writing(path) as part:
        part.write_text(text_of_record(record), encoding="utf-8")
    return Path(path)


def text_of_record(record: Record) -> str:
    """The file as a text; times to a microsecond, rates to six digits."""
    absolute = np.linalg.norm(record.rates, axis=1)
    lines = [",".join(f'"{title}"' for title in TITLES)]
    for t, (x, y, z), size in zip(record.t, record.rates, absolute, strict=True):
        lines.append(f"{t:.6f},{x:.6g},{y:.6g},{z:.6g},{size:.6g}")
    return "\n".join([*([SIMULATED] if record.simulated else []), *lines, ""])
