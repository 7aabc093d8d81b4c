"""Gyroscopes inside a body: their records, and the turns and the friction that these show."""

from rimroll.gyro.analysis import Analysis, analyze
from rimroll.gyro.collision import Collision
from rimroll.gyro.files import read
from rimroll.gyro.friction import Friction
from rimroll.gyro.record import Record
from rimroll.gyro.sensor import Sensor, phone

__all__ = ["Analysis", "Collision", "Friction", "Record", "Sensor", "analyze", "phone", "read"]
