"""Whole motions: simulate one, and read all its quantities."""

from rimroll.motion.moments import UNITS, Array, Event, Moments, Phase, Stats, Turn
from rimroll.motion.motion import Motion
from rimroll.motion.simulation import simulate
from rimroll.motion.validity import Validity

__all__ = [
    "UNITS",
    "Array",
    "Event",
    "Moments",
    "Motion",
    "Phase",
    "Stats",
    "Turn",
    "Validity",
    "simulate",
]
