"""The results of a run, as stored in bench/results/results.json."""

from __future__ import annotations

import math
import statistics
from collections.abc import Iterable
from dataclasses import asdict, dataclass, field
from typing import Any

import numpy as np

from .contestants import CONTESTANTS, Contestant
from .rounds import Point


@dataclass(frozen=True)
class Row:
    """A contestant at one tolerance and law: errors in rad, costs in seconds a start by round."""

    method: str
    coordinates: str
    law: str
    tolerance: float
    worst: float
    median: float
    eps: float | None
    every: int
    rounds: list[float]

    @classmethod
    def of(cls, point: Point) -> Row:
        who = point.contestant
        rates = set(point.starts.columns["yaw_rate"].tolist())
        return cls(
            who.method,
            who.coordinates,
            point.law,
            point.tolerance,
            point.worst,
            point.median,
            rates.pop() if len(rates) == 1 else None,
            who.every,
            [float(f"{seconds:.4g}") for seconds in point.seconds],
        )

    @property
    def key(self) -> str:
        return f"{self.method}/{self.coordinates}"

    @property
    def seconds(self) -> float:
        return statistics.median(self.rounds)

    def times_of(self, other: Row) -> float:
        """This cost over the other's: in each round where both have rounds."""
        if len(self.rounds) == len(other.rounds):
            pairs = zip(self.rounds, other.rounds, strict=True)
            return statistics.median(mine / others for mine, others in pairs)
        return self.seconds / other.seconds


@dataclass(frozen=True)
class Results:
    """One run."""

    machine: dict[str, Any]
    rounds: int
    turns: list[Row] = field(default_factory=list)
    near: list[Row] = field(default_factory=list)
    motions: list[Row] = field(default_factory=list)

    def as_json(self) -> dict[str, Any]:
        rows = {name: [_finite(asdict(r)) for r in getattr(self, name)] for name in KINDS}
        return {"machine": self.machine, "rounds": self.rounds, **rows}

    @classmethod
    def from_json(cls, read: dict[str, Any]) -> Results:
        rows = {name: [Row(**_infinite(row)) for row in read[name]] for name in KINDS}
        return cls(read["machine"], read["rounds"], **rows)


KINDS = ("turns", "near", "motions")


def _finite(row: dict[str, Any]) -> dict[str, Any]:
    """JSON has no infinity."""
    errors = {name: None if math.isinf(row[name]) else row[name] for name in ("worst", "median")}
    return row | errors


def _infinite(row: dict[str, Any]) -> dict[str, Any]:
    errors = {name: math.inf if row[name] is None else row[name] for name in ("worst", "median")}
    return row | errors


def contestants(rows: Iterable[Row], of: list[Contestant] = CONTESTANTS) -> list[Contestant]:
    """Those that have rows, in their usual order."""
    keys = {row.key for row in rows}
    return [one for one in of if one.key in keys]


def cheapest(rows: Iterable[Row], contestant: Contestant, law: str, error: float) -> Row | None:
    """A contestant's cheapest setting with which no start is worse than `error`."""
    good = [
        row for row in rows if row.key == contestant.key and row.law == law and row.worst <= error
    ]
    return min(good, key=lambda row: row.seconds, default=None)


def best_peer(rows: list[Row], law: str, error: float, of: list[Contestant]) -> Row | None:
    """The cheapest of all that are not rimroll, in any coordinates."""
    found = [cheapest(rows, one, law, error) for one in of if not one.is_ours]
    return min((row for row in found if row), key=lambda row: row.seconds, default=None)


WRONG = 0.1
"""A setting with a larger worst error (rad) has missed some turn altogether."""


def frontier(rows: Iterable[Row]) -> tuple[np.ndarray, np.ndarray]:
    """Errors and costs of the settings that no other beats in both, worst error first."""
    kept: list[Row] = []
    for row in sorted(rows, key=lambda row: (row.seconds, row.worst)):
        if row.worst < WRONG and (not kept or row.worst < kept[-1].worst):
            kept.append(row)
    return np.array([r.worst for r in kept]), np.array([r.seconds for r in kept])
