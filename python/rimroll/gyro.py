"""Gyroscopes inside a body: their records, and the turns and the friction that these show."""

from __future__ import annotations

from rimroll.sensors.gyro.analysis import Analysis
from rimroll.sensors.gyro.collision import Collision
from rimroll.sensors.gyro.files import read
from rimroll.sensors.gyro.friction import Friction
from rimroll.sensors.gyro.reading import analyze
from rimroll.sensors.gyro.record import Record
from rimroll.sensors.gyro.sensor import Sensor, phone

__all__ = ["Analysis", "Collision", "Friction", "Record", "Sensor", "analyze", "phone", "read"]
