"""Types of the interface: ``mypy --strict`` on typical users' code."""

import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).parents[2]

ACCEPTED = """
import numpy as np
from numpy.typing import NDArray
from typing_extensions import assert_type

import rimroll as rr

can = rr.Body("70 g", 0.051, 0.069, 3.591e-4, 1.4e-4)
start = rr.State(tilt=0.5, yaw_rate="1 deg/s")
motion = rr.simulate(can, start, rr.NoSlip(), "2 s")

y: float = motion(0.5).tilt
z: float = motion("500 ms").yaw_rate
first: float = motion.events[0].state.tilt
begin: float = motion.start.tilt
assert_type(start, rr.State[float])
assert_type(motion(np.linspace(0.0, 1.0, 5)).tilt, NDArray[np.float64])
assert_type(motion([0.1, 0.2]), rr.State[NDArray[np.float64]])
assert_type(motion.state.tilt, NDArray[np.float64])

starts = rr.State(tilt=np.array([0.3, 0.4]), yaw_rate=0.1)
either: float | NDArray[np.float64] = starts.tilt


def shape_of(state: rr.State) -> tuple[int, ...]:
    return state.shape


shape_of(start), shape_of(starts), shape_of(motion(0.1))
columns: list[str] = list(motion)
ground: rr.Ground = rr.ground.sine(("0.3 g", 1.5, 0.0), period=1.2) + rr.ground.read("x.at2")
assert_type(ground([0.1, 0.2]), NDArray[np.float64])
assert_type(ground.scaled(1.5).rotated("30 deg").peak.horizontal, float)
again: rr.Motion = rr.Motion.from_xarray(motion.to_xarray())
"""

REFUSED = """
import numpy as np
import rimroll as rr

y: float = rr.State(tilt=np.array([0.3])).tilt
"""


def mypy(tmp_path, code):
    file = tmp_path / "user.py"
    file.write_text(code)
    return subprocess.run(
        [sys.executable, "-m", "mypy", "--strict", "--follow-imports=silent", str(file)],
        cwd=ROOT,
        capture_output=True,
        text=True,
        check=False,
    )


def test_scalar_states_have_float_fields_and_states_of_arrays_arrays(tmp_path):
    checked = mypy(tmp_path, ACCEPTED)
    assert checked.returncode == 0, checked.stdout + checked.stderr


def test_a_state_of_arrays_is_not_taken_for_one_of_floats(tmp_path):
    checked = mypy(tmp_path, REFUSED)
    assert checked.returncode == 1 and checked.stdout.count("error:") == 1
    assert "Incompatible types in assignment" in checked.stdout
