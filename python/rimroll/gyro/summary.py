"""An analysis as plain numbers, for JSON."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

from rimroll._core import __version__

if TYPE_CHECKING:
    from rimroll.gyro.analysis import Analysis
    from rimroll.gyro.collision import Collision
    from rimroll.gyro.friction import Friction

_DEGREES = (
    *("turn", "veer", "veer_error", "turn_alone"),
    *("tilt_before", "tilt_after", "miss"),
)
_RATES = ("rate_before", "rate_after", "spin_before", "spin_after")


def summary_of(found: Analysis) -> dict[str, Any]:
    """Everything that was read: angles in degrees, times in s, rates in rad/s."""
    return {
        "record": found.record.name,
        "simulated": found.record.simulated,
        "read": found.record.source,
        "samples": len(found.record),
        "sampling_rate": found.record.sampling_rate,
        "rests": [list(span) for span in found.rests.spans],
        "noise": found.rests.noise,
        "filter_cutoff": found.filter_cutoff,
        "bias": found.rests.bias.mean(axis=0).tolist() if found.rests.spans else None,
        "axis": found.axis.direction.tolist(),
        "axis_error": math.degrees(found.axis.error),
        "collisions": [
            {**_of_collision(one), **_of_friction(friction)}
            for one, friction in zip(found.collisions, found.frictions, strict=True)
        ],
        **_of_friction(found.friction),
        "excludes_rolling": found.friction and found.friction.excludes_rolling,
        "excludes_sliding": found.friction and found.friction.excludes_sliding,
        "veer_limits": [math.degrees(limit) - 180.0 for limit in found.limits],
        "confidence": found.confidence,
        "gravity": found.gravity,
        "notes": found.notes,
        "rimroll_version": __version__,
    }


def _of_collision(one: Collision) -> dict[str, Any]:
    return {
        "time": one.time,
        **{name: math.degrees(getattr(one, name)) for name in _DEGREES},
        **{name: getattr(one, name) for name in _RATES},
        "energy_kept": one.energy_kept,
        "energy_kept_error": one.energy_kept_error,
        "released": one.released,
        "side_is_sure": one.side_is_sure,
        "start": one.start,
        "end": one.end,
    }


def _of_friction(one: Friction | None) -> dict[str, Any]:
    if one is None:
        return {"friction": None, "friction_interval": None}
    interval = None if one.interval is None else list(one.interval)
    return {"friction": one.best, "friction_interval": interval}
