"""An environment for each engine, with pinned versions: ``rimroll score ENGINE --install``."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

PINS = {
    "dart": ["dartpy==6.20.0"],
    "drake": ["drake==1.51.1"],
    "exudyn": ["exudyn==1.13.6"],
    "mujoco": ["mujoco==4.0.0"],
    "newton": ["newton==1.8.0", "mujoco==3.17.0", "mujoco-warp==3.17.0"],
    "pybullet": ["pybullet==3.2.7"],
    "rapier": ["rapier3d==0.36.1"],
    "rimroll": [],
}
"""What to install for each engine that has an adapter here; NumPy comes with it."""


class NotInstalled(Exception):
    """An environment could not be made; the message is the end of what pip said."""


def folder(engine: str) -> Path:
    """Where the environment of an engine is: in the user's cache, or in ``RIMROLL_ENGINES``."""
    cache = os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache"
    return Path(os.environ.get("RIMROLL_ENGINES") or Path(cache) / "rimroll/engines") / engine


def installed(engine: str) -> str:
    """The Python of an environment with the engine, which is made if it is not there yet.

    Raises ``NotInstalled`` if pip fails.
    """
    if not PINS.get(engine):
        return sys.executable
    place = folder(engine)
    python = place / ("Scripts/python.exe" if os.name == "nt" else "bin/python")
    wanted = "\n".join(["numpy", *PINS[engine]])
    complete = place / "installed.txt"
    if complete.exists() and complete.read_text("utf-8") == wanted:
        return str(python)
    _call([sys.executable, "-m", "venv", "--clear", str(place)])
    _call([str(python), "-m", "pip", "install", "--quiet", *wanted.split("\n")])
    complete.write_text(wanted, "utf-8")
    return str(python)


def advice(engine: str) -> str:
    """How to get an engine."""
    pins = PINS.get(engine)
    by_hand = f"pip install {' '.join(pins)}" if pins else "install it beside rimroll-score"
    return f"add --install, or {by_hand}" if pins else by_hand


def _call(command: list[str]) -> None:
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode:
        lines = (done.stderr or done.stdout).strip().splitlines() or ["no message"]
        # pip shows the place of a mistake below the line that says what is wrong.
        errors = [line for line in lines if line.startswith("ERROR")]
        raise NotInstalled((errors or lines)[-1])
