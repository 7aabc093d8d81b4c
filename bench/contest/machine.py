"""The machine and the versions of everything measured."""

from __future__ import annotations

import os
import platform
import subprocess
import tomllib
from pathlib import Path

from .contestants import BUILT, PEERS_VENV, ROOT

PACKAGES = ("scipy", "heyoka", "numba", "diffrax", "jax", "numpy")


def _output_of(*command: str | Path) -> str:
    try:
        run = subprocess.run([str(word) for word in command], capture_output=True, text=True)
    except OSError:
        return ""
    return run.stdout.strip() if run.returncode == 0 else ""


def _processor() -> str:
    lines = Path("/proc/cpuinfo").read_text("utf-8").splitlines()
    facts = dict(line.split(":", 1) for line in lines if ":" in line)
    named = {key.strip(): value.strip() for key, value in facts.items()}
    numbers = f"family {named.get('cpu family')}, model {named.get('model')}"
    return f"{named.get('model name', platform.processor())} ({numbers})"


def _locked(lock: Path, package: str) -> str:
    """A version from a Cargo.lock."""
    lines = lock.read_text("utf-8").splitlines()
    at = lines.index(f'name = "{package}"')
    return lines[at + 1].split('"')[1]


def versions() -> dict[str, str]:
    """Versions of the contestants and the compilers."""
    program = f"from importlib.metadata import version\nfor p in {PACKAGES!r}: print(p, version(p))"
    found = dict(line.split() for line in _output_of(PEERS_VENV, "-c", program).splitlines())
    lock = ROOT / "bench/peers-rs/Cargo.lock"
    for crate in "ode_solvers", "diffsol":
        found[crate] = _locked(lock, crate)
    header = Path("/usr/include/boost/version.hpp")
    if header.exists():
        line = next(
            ln for ln in header.read_text().splitlines() if "define BOOST_LIB_VERSION" in ln
        )
        found["Boost"] = line.split('"')[1].replace("_", ".")
    found["Python"] = platform.python_version()
    found["rustc"] = _output_of("rustc", "--version").removeprefix("rustc ").split(" ")[0]
    found["g++"] = _output_of("g++", "-dumpfullversion")
    workspace = tomllib.loads((ROOT / "Cargo.toml").read_text("utf-8"))["workspace"]
    found["rimroll"] = workspace["package"]["version"]
    return {name: version for name, version in found.items() if version}


def peak() -> dict[str, float]:
    """Measured double-precision operations per second of one core with its widest vectors, and
    how many lanes these have; empty if it cannot be measured.
    """
    numbers = _output_of(BUILT / "core-rs/release/peak").split()
    if len(numbers) != 3:
        return {}
    return {"lanes": int(numbers[0]), "separate": float(numbers[1]), "fused": float(numbers[2])}


def describe() -> dict[str, object]:
    return {
        "processor": _processor(),
        "cores": os.cpu_count(),
        "system": platform.platform(terse=True),
        "versions": versions(),
        "peak_flops": peak(),
    }
