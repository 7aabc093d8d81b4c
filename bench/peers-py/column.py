"""A column that rolls without slip on a table which moves by a record.

In rimroll's coordinates over the time: (yaw, sin φ, cos φ, φ̇, w = ψ̇ sin φ, s). The acceleration is
linear between samples, where a step has to end. Constants are per unit of mass.
"""

from pathlib import Path

import numpy as np

R, H, A, C, G = 0.5, 2.0, 0.0625 + 16.0 / 12.0, 0.125, 9.81
K = A + H * H
J = K + R * R
D = C * K + R * R * A
STEP = 0.005
"""The time between two samples, s."""


def record_beside(path):
    """The record (n, 3), m/s², in the folder of a table of starts."""
    return np.loadtxt(Path(path).parent / "record.csv", delimiter=",")


def begin(tilt):
    """The coordinates of a column at rest."""
    return np.array([0.0, np.sin(tilt), np.cos(tilt), 0.0, 0.0, 0.0])


def rates(sin_yaw, cos_yaw, x, y, z, sin, cos, p, w, s):
    """The rates of the six coordinates under the acceleration (x, y, z) of the table."""
    along, across = x * cos_yaw + y * sin_yaw, y * cos_yaw - x * sin_yaw
    yaw_rate = w / sin
    rho, height = R * cos - H * sin, R * sin + H * cos
    return (
        yaw_rate,
        cos * p,
        -sin * p,
        cos * yaw_rate * (K / J * w - H * R / J * s)
        + w * (H * R / J * w - (C + R * R) / J * s)
        - (G + z) / J * rho
        + along / J * height,
        p * (C * (C + R * R) / D * s - C * H * R / D * w - yaw_rate * cos) + H * C / D * across,
        p * (R * R * A / D * w + C * H * R / D * s) - R * A / D * across,
    )
