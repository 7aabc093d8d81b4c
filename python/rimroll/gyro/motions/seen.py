"""What a gyroscope shows of a motion, and the derivatives of it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from rimroll.motion import Moments
from rimroll.motion.jacobian import QUANTITIES

Array = NDArray[np.float64]

SENSOR = (
    "axis_first",
    "axis_second",
    "bias_x",
    "bias_y",
    "bias_z",
    "scale_x",
    "scale_y",
    "scale_z",
)
"""Turn of the sensor about two directions across the axis (rad), bias (rad/s), sensitivity."""

_ROW = {name: row for row, name in enumerate(QUANTITIES)}


def body_rates(moments: Moments) -> Array:
    """Angular velocity along the axes of the body, (n, 3), rad/s."""
    return np.asarray(moments.body_angular_velocity)


def derivatives(moments: Moments, of_state: Array) -> Array:
    """Derivatives of the body rates, (n, 3, k), from those of the state, (n, 6, k).

    With w = ψ̇ sin φ the rates are w cos θ − φ̇ sin θ, −w sin θ − φ̇ cos θ and θ̇ + ψ̇ cos φ.
    """
    tilt, yaw_rate = moments.tilt[:, np.newaxis], moments.yaw_rate[:, np.newaxis]
    spin, falling = moments.spin[:, np.newaxis], moments.tilt_rate[:, np.newaxis]
    sin, cos = np.sin(tilt), np.cos(tilt)

    def by(name: str) -> Array:
        return np.asarray(of_state[:, _ROW[name], :])

    w = yaw_rate * sin
    of_w = by("yaw_rate") * sin + yaw_rate * cos * by("tilt")
    of_falling, of_spin = by("tilt_rate"), by("spin")
    x, y = w * np.cos(spin) - falling * np.sin(spin), -w * np.sin(spin) - falling * np.cos(spin)
    return np.stack(
        [
            of_w * np.cos(spin) - of_falling * np.sin(spin) + y * of_spin,
            -of_w * np.sin(spin) - of_falling * np.cos(spin) - x * of_spin,
            by("spin_rate") + by("yaw_rate") * cos - yaw_rate * sin * by("tilt"),
        ],
        axis=1,
    )


@dataclass(frozen=True)
class Sensing:
    """A sensor in the body: ``frame`` (3, 3) has the body's axes, as they are expected, as columns.

    The turned frame is frame · (1 + [a]×) to first order, made orthogonal; then come sensitivity
    and bias along each axis of the sensor.
    """

    frame: Array

    def turned(self, sensor: Array) -> Array:
        """The body's axes in the sensor for the numbers of :data:`SENSOR`."""
        from scipy.spatial.transform import Rotation

        turn = Rotation.from_rotvec([sensor[0], sensor[1], 0.0]).as_matrix()
        return np.asarray(self.frame @ turn)

    def shown(self, rates: Array, sensor: Array) -> Array:
        """The rates that the sensor shows, (n, 3), of rates in the body."""
        return np.asarray((rates @ self.turned(sensor).T) * (1.0 + sensor[5:8]) + sensor[2:5])

    def unturned(self, shown: Array) -> Array:
        """Rates along the axes of the body as they are expected, of rates along the sensor's."""
        return np.asarray(shown @ self.frame)

    def carried(self, of_rates: Array, sensor: Array) -> Array:
        """Derivatives (n, 3, k) of what is shown from those of the rates in the body."""
        turned = (1.0 + sensor[5:8])[:, np.newaxis] * self.turned(sensor)
        return np.asarray(np.einsum("ij,njk->nik", turned, of_rates))

    def by_sensor(self, rates: Array, sensor: Array) -> Array:
        """Derivatives (n, 3, 8) of what is shown by the numbers of :data:`SENSOR`."""
        count = len(rates)
        out = np.zeros((count, 3, len(SENSOR)))
        step = 1e-6
        for column in range(2):
            moved = np.array(sensor)
            moved[column] += step
            ahead = self.shown(rates, moved)
            moved[column] -= 2.0 * step
            out[:, :, column] = (ahead - self.shown(rates, moved)) / (2.0 * step)
        plain = rates @ self.turned(sensor).T
        for i in range(3):
            out[:, i, 2 + i] = 1.0
            out[:, i, 5 + i] = plain[:, i]
        return out
