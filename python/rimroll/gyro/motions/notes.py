"""What to know about the fit of a motion, in sentences."""

from __future__ import annotations

import math
from collections.abc import Sequence

from rimroll.gyro.motions.windows import Chain


def notes_of(
    chains: Sequence[Chain],
    followed: list[int],
    sure: list[bool],
    interval: tuple[float, float | None] | None,
    told: bool,
    inflation: float,
) -> list[str]:
    """The sentences that apply; ``told``: whether the record limits the friction."""
    notes = []
    if not chains[0].collisions[0].released:
        notes.append(
            "No release was seen, so the fit assumes that the rim rests where the tilt is largest."
        )
    later = sum(len(one.collisions) for one in chains) - sum(followed)
    if later:
        notes.append(
            "Not followed: 1 later near-collision, which depends too much on small errors of what"
            " came before, or is beyond the number asked for."
            if later == 1
            else f"Not followed: {later} later near-collisions, which depend too much on small"
            " errors of what came before, or are beyond the number asked for."
        )
    if not all(sure):
        count = sum(not one for one in sure)
        notes.append(
            f"The side of {count} of {len(sure)} turns is not sure: a turn to the other side suits"
            " about as well."
        )
    if interval is not None and not told:
        notes.append("The record cannot tell the friction: nearly every friction suits it.")
    if inflation > 4.0:
        notes.append(
            "The residuals are larger than the sensor's errors explain, or hang together from"
            f" sample to sample, so all intervals are {math.sqrt(inflation):.1f} times wider. The"
            " body may not be round or not the one given, or the sensor may not be fixed."
        )
    return notes
