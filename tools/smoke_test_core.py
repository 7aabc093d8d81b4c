"""Checks the compiled core of an installed rimroll, also where there is no NumPy.

It computes the turn of the README's example, which must have the digits that the README prints.
"""

import math
import re
from pathlib import Path
from types import SimpleNamespace

from rimroll import _core

ROOT = Path(__file__).parents[1]


def turn() -> float:
    """The first turn of the README's example, in degrees."""
    names = ("mass", "radius", "height", "transverse_inertia", "axial_inertia")
    can = SimpleNamespace(**dict(zip(names, _core.preset("can_2007", ()), strict=True)))
    start = SimpleNamespace(
        tilt=math.pi / 6, tilt_rate=-0.5, yaw=0.0, yaw_rate=0.005, spin=0.0, spin_rate=0.005
    )
    law = SimpleNamespace(name="no_slip", numbers={})
    options = (2.0, _core.STANDARD_GRAVITY, 1e-10, None, 1_000_000)
    arguments = (*options, None, False, None, ("stop", 0.0, 0, 0.0))
    (angle, *_), *_ = _core.simulate(can, start, law, *arguments).turns()
    return math.degrees(angle)


if __name__ == "__main__":
    readme = (ROOT / "README.md").read_text("utf-8")
    printed = re.search(r"```\n([\d.]+) [\d.]+\n```", readme)
    assert printed, "the README prints no turn"
    assert repr(turn()) == printed[1], f"{turn()}, not {printed[1]}"
    print("passed: the core computes the turn of the README's example to the last digit")
