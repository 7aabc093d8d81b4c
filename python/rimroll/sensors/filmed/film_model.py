"""What a film shows of motions under a law, beside a track."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from rimroll.bodies.body import Body
from rimroll.errors import RimrollError
from rimroll.laws import Law
from rimroll.motion import Moments, Motion, simulate
from rimroll.sensors.filmed.track import Track
from rimroll.sensors.fits import (
    BODY,
    MOST_STEPS,
    RTOL,
    START,
    UNREACHED,
    highest_friction,
    with_numbers,
)
from rimroll.state import State

Array = NDArray[np.float64]

PUSH = 0.5
"""Standard deviation of each rate at the release, rad/s."""
SCALE = 0.02
"""Standard deviation of the scale of a film, a ratio."""
STEP = 1e-5
"""Step by which numbers are differenced, of their size or of 1."""


@dataclass(frozen=True)
class Marker:
    """A point of the body: ``radius`` from the axis and ``height`` above the base, m."""

    radius: float
    height: float


@dataclass(frozen=True)
class FilmModel:
    """Motions of a body after one release, seen by a camera.

    The vector holds the ``free`` numbers of the law, the start, the turn of the camera about the
    vertical (rad), the moment of the release (s); for a path the origin (m), the scale and, for a
    marker beside the axis, its azimuth in the body (rad); and the deviations of the body.
    """

    body: Body
    law: Law
    free: tuple[str, ...]
    gravity: float
    track: Track
    marker: Marker
    until: float
    error: float
    body_error: float

    @property
    def names(self) -> list[str]:
        """The names of the numbers."""
        path = ["origin_x", "origin_y", "scale"] if self.track.kind == "path" else []
        beside = ["marker_azimuth"] if path and self.marker.radius > 0.0 else []
        deviations = [f"{name}_deviation" for name in BODY]
        return [*self.free, *START, "camera", "release", *path, *beside, *deviations]

    @property
    def used(self) -> NDArray[np.bool_]:
        """The samples that are fitted."""
        return np.asarray(self.track.t <= self.until)

    def numbers(self, vector: Array) -> dict[str, float]:
        """The numbers by name."""
        return dict(zip(self.names, map(float, vector), strict=True))

    def law_at(self, vector: Array) -> Law:
        """The law with the numbers of a vector."""
        numbers = self.numbers(vector)
        return with_numbers(self.law, {name: numbers[name] for name in self.free})

    def motion(self, vector: Array) -> Motion:
        """The motion after the release; ``RimrollError`` where the start is impossible."""
        numbers = self.numbers(vector)
        changed = {
            name: getattr(self.body, name) * (1.0 + numbers[f"{name}_deviation"]) for name in BODY
        }
        start = State(**{name: numbers[name] for name in START})
        duration = max(self.until - numbers["release"], 0.0) + 1e-2
        return simulate(
            replace(self.body, **changed), start, self.law_at(vector), duration,
            gravity=self.gravity, rtol=RTOL, max_steps=MOST_STEPS,
        )  # fmt: skip

    def shown(self, vector: Array) -> NDArray[np.complex128]:
        """Where the film shows the marker, m, or the lean, rad; NaN after the motion's end."""
        numbers = self.numbers(vector)
        motion = self.motion(vector)
        since = np.maximum(self.track.t[self.used] - numbers["release"], 0.0)
        end = float(motion.t[-1])
        moments = motion.evaluate(np.minimum(since, end))
        seen = plane_of(moments, motion.body, self.track.kind, self._marker(numbers))
        seen = seen * np.exp(1j * numbers["camera"])
        if self.track.kind == "path":
            origin = numbers["origin_x"] + 1j * numbers["origin_y"]
            seen = numbers["scale"] * seen + origin
        if motion.status != "at_rest":
            seen[since > end + 1e-9] = np.nan
        return np.asarray(seen)

    def _marker(self, numbers: dict[str, float]) -> tuple[complex, float]:
        azimuth = numbers.get("marker_azimuth", 0.0)
        return self.marker.radius * np.exp(1j * azimuth), self.marker.height

    def left(self, vector: Array) -> Array:
        """Film less motion, (n, 2), or (n, 1) for tilts alone, m or rad."""
        shown, seen = self.shown(vector), self.track.plane()[self.used]
        if self.track.kind == "tilt":
            return np.asarray((np.abs(shown) - seen.real)[:, np.newaxis])
        return np.stack([(shown - seen).real, (shown - seen).imag], axis=-1)

    def residuals(self, vector: Array) -> Array:
        """What is left over its error, and of what is expected over its."""
        try:
            left = np.nan_to_num(self.left(vector) / self.error, nan=UNREACHED)
        except RimrollError:
            width = 1 if self.track.kind == "tilt" else 2
            left = np.full((int(self.used.sum()), width), UNREACHED)
        return np.concatenate([left.ravel(), (vector - self._expected) / self._deviation])

    @property
    def _expected(self) -> Array:
        return np.array([1.0 if name == "scale" else 0.0 for name in self.names])

    @property
    def _deviation(self) -> Array:
        known = {
            **dict.fromkeys(("tilt_rate", "yaw_rate", "spin_rate"), PUSH),
            "scale": SCALE,
            **{f"{name}_deviation": max(self.body_error, 1e-9) for name in BODY},
        }
        if self.track.kind == "tilt":
            known["camera"] = 1.0  # no direction is seen
        return np.array([known.get(name, 1e6) for name in self.names])

    def jacobian(self, vector: Array) -> Array:
        """Derivatives of :meth:`residuals` by central differences."""
        columns = []
        low, high = self.bounds()
        for i, value in enumerate(vector):
            step = STEP * max(abs(float(value)), 0.1)
            ahead, behind = vector.copy(), vector.copy()
            ahead[i], behind[i] = min(value + step, high[i]), max(value - step, low[i])
            apart = self.residuals(ahead) - self.residuals(behind)
            columns.append(np.where(np.abs(apart) > 0.5 * UNREACHED, 0.0, apart))
            columns[-1] = columns[-1] / (ahead[i] - behind[i])
        return np.stack(columns, axis=-1)

    def bounds(self) -> tuple[Array, Array]:
        """The lowest and the highest numbers that are tried."""
        low, high = self._expected - 8.0 * self._deviation, self._expected + 8.0 * self._deviation
        for i, name in enumerate(self.names):
            if name in self.free:
                low[i] = 0.0
            if name == "friction" and name in self.free:
                high[i] = highest_friction(self.body)
            if name == "tilt":
                low[i], high[i] = 0.01, 1.55
        return low, high


def plane_of(
    moments: Moments, body: Body, kind: str, marker: tuple[complex, float]
) -> NDArray[np.complex128]:
    """A marker (distance and azimuth in the body, m; height above the base, m), or the lean."""
    tilt, yaw = moments.tilt, moments.yaw
    ahead = np.exp(1j * yaw)
    if kind != "path":  # the top leans away from the contact's side: contact at yaw + π
        return np.asarray(-tilt * ahead)
    turned = marker[0] * np.exp(1j * moments.spin)
    across = turned.real * np.cos(tilt) + 1j * turned.imag
    along = (marker[1] - body.height) * -np.sin(tilt)
    center = moments.center[:, 0] + 1j * moments.center[:, 1]
    return np.asarray(center + (across + along) * ahead)
