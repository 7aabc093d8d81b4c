"""Motions for several tests: the paper's can, released as in the paper."""

import csv
import hashlib
from pathlib import Path

import numpy as np
import pytest

import rimroll as rr
import rimroll.motion

LAWS = [rr.NoSlip(), rr.Frictionless()]
by_law = pytest.mark.parametrize("law", LAWS, ids=lambda law: law.name)

PAPER_GRAVITY = 9.8  # m/s²
CAN = rr.bodies.can_2007()
DISK = rr.bodies.disk(0.05)
PAPER_START = rr.State(tilt=np.pi / 6, tilt_rate=-0.5, yaw_rate=0.005, spin_rate=0.005)


def paper_motion(law, **options):
    return rr.simulate(CAN, PAPER_START, law, **{"gravity": PAPER_GRAVITY, **options})


def sixty_starts(number=float):
    """The core's table of turns as dicts of numbers; its head says how they were computed."""
    table = (
        Path(__file__).parents[2] / "crates/rimroll/tests/integration/given/turns_of_the_can.csv"
    )
    lines = [line for line in table.read_text().splitlines() if not line.startswith("#")]
    return [{name: number(x) for name, x in row.items()} for row in csv.DictReader(lines)]


def bits(moments):
    """A fingerprint of every column, to the last bit."""
    columns = [moments[name].tobytes() for name in rimroll.motion.UNITS]
    return hashlib.sha256(b"".join(columns)).hexdigest()


def same_bits(one, other):
    return bits(one) == bits(other)
