"""Who takes part: rimroll, and the solvers that a researcher would reach for."""

from __future__ import annotations

import os
from dataclasses import dataclass, field
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
BUILT = ROOT / "out/bench"
PEERS_PY = ROOT / "bench/peers-py"
PEERS_VENV = BUILT / "venv/bin/python"
VENV = ROOT / ".venv/bin/python"

LAWS = {"no_slip": "without slip", "frictionless": "without friction"}
COORDINATES = {"regular": "ours", "printed": "printed"}
"""Coordinates of the equations of motion, and their names in the tables."""


def workers() -> dict[str, list[Path | str]]:
    """The commands of all workers that are installed."""
    commands: dict[str, list[Path | str]] = {
        "rimroll": [VENV, PEERS_PY / "worker.py", "rimroll_itself"],
        "core": [BUILT / "core-rs/release/core-rs"],
        "rust": [BUILT / "peers-rs/release/peers-rs"],
        "boost": [BUILT / "boost_odeint"],
    }
    for peer in "heyoka", "numba", "diffrax", "scipy":
        commands[peer] = [PEERS_VENV, PEERS_PY / "worker.py", f"{peer}_peer"]
    return {name: command for name, command in commands.items() if os.access(command[0], os.X_OK)}


def tolerances(loosest: int, tightest: int, a_decade: int = 1) -> tuple[float, ...]:
    """Tolerances from 10^-loosest to 10^-tightest."""
    steps = range(a_decade * loosest, a_decade * tightest + 1)
    return tuple(float(f"{10.0 ** (-step / a_decade):.2g}") for step in steps)


@dataclass(frozen=True)
class Contestant:
    """A method of a worker, in one kind of coordinates."""

    name: str
    method: str
    worker: str
    coordinates: str = "regular"
    tolerances: tuple[float, ...] = field(default=tolerances(3, 13, 2))
    every: int = 1
    """It computes every n-th start; n > 1 for very slow methods."""

    @property
    def is_ours(self) -> bool:
        return self.worker in ("rimroll", "core")

    @property
    def key(self) -> str:
        return f"{self.method}/{self.coordinates}"

    @property
    def label(self) -> str:
        return self.name if self.is_ours else f"{self.name}, {COORDINATES[self.coordinates]}"


def _in_both(
    name: str, method: str, worker: str, *, a_decade: int = 2, every: int = 1
) -> list[Contestant]:
    """With rimroll's coordinates, and with the printed equations, for which rounding limits the
    accuracy sooner."""
    return [
        Contestant(name, method, worker, "regular", tolerances(3, 13, a_decade), every),
        Contestant(name, method, worker, "printed", tolerances(3, 10), every),
    ]


CONTESTANTS = [
    Contestant("rimroll: quadrature", "rimroll_quadrature", "rimroll", tolerances=(1e-12,)),
    Contestant("rimroll: ensemble", "rimroll_ensemble", "rimroll"),
    Contestant("rimroll in Rust, quadrature", "core_quadrature", "core", tolerances=(1e-12,)),
    Contestant("rimroll in Rust, ensemble", "core_ensemble", "core"),
    *_in_both("heyoka, 8 lanes", "heyoka_8_lanes", "heyoka"),
    *_in_both("heyoka, 4 lanes", "heyoka_4_lanes", "heyoka"),
    *_in_both("heyoka, one by one", "heyoka", "heyoka"),
    *_in_both("Boost.odeint, rkf78", "boost_rkf78", "boost"),
    *_in_both("Boost.odeint, Bulirsch-Stoer", "boost_bulirsch_stoer", "boost"),
    *_in_both("Boost.odeint, dopri5", "boost_dopri5", "boost"),
    *_in_both("ode_solvers, DOP853", "ode_solvers_dop853", "rust"),
    *_in_both("diffsol, tsit45", "diffsol_tsit45", "rust"),
    *_in_both("numba, DOP853", "numba_dop853", "numba"),
    *_in_both("diffrax, Dopri8", "diffrax_dopri8", "diffrax", a_decade=1),
    *_in_both("SciPy, DOP853", "scipy_dop853", "scipy", a_decade=1, every=5),
    *_in_both("SciPy, LSODA", "scipy_lsoda", "scipy", a_decade=1, every=5),
    Contestant("SciPy, Radau", "scipy_radau", "scipy", "printed", (1e-4, 1e-6, 1e-8), every=10),
]

OF_A_MOTION = [
    Contestant("rimroll, from Python", "rimroll_simulate", "rimroll"),
    Contestant("rimroll, from Rust", "core_motion", "core"),
    Contestant("Boost.odeint, rkf78", "boost_rkf78", "boost"),
    Contestant("heyoka", "heyoka", "heyoka"),
]
