"""Random bodies and starts, far more extreme than real ones.

Sizes and moments of inertia extend over many decades, and include disks. Tilts range from 1e-12 rad
to the topple tilt, many of them very near the balance point or the vertical; rates range from zero
to a hundred times those of falling.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

import rimroll as rr

Choice = tuple[float, Callable[[], float]]
"""Weights and values."""

IDEAL: tuple[rr.Law, ...] = (rr.NoSlip(), rr.Frictionless())


@dataclass(frozen=True)
class Setting:
    """A body under a law and a gravity (m/s²)."""

    body: rr.Body
    law: rr.Law
    gravity: float

    @property
    def falling_time(self) -> float:
        """The time scale of falling over, s."""
        body = self.body
        arm = math.hypot(body.radius, body.height)
        inertia = body.transverse_inertia + body.mass * arm**2
        return math.sqrt(inertia / (body.mass * self.gravity * arm))


def setting(rng: np.random.Generator) -> Setting:
    """A body with its law and gravity."""
    gravity = rr.STANDARD_GRAVITY if rng.random() < 0.5 else decades(rng, 1e-3, 1e3)
    return Setting(body(rng), IDEAL[int(rng.integers(len(IDEAL)))], gravity)


def decades(rng: np.random.Generator, low: float, high: float) -> float:
    """A number between two others whose logarithm is uniformly distributed."""
    return float(math.exp(rng.uniform(math.log(low), math.log(high))))


def body(rng: np.random.Generator) -> rr.Body:
    """A rigid body: C is at most 2A."""
    mass, radius = decades(rng, 1e-4, 1e3), decades(rng, 1e-3, 10.0)
    slenderness = _one_of(
        rng, (0.15, lambda: 0.0), (0.7, lambda: decades(rng, 1e-2, 10.0)), (0.15, _extreme(rng))
    )
    height = slenderness * radius
    ring = mass * radius**2
    axial = ring * _one_of(rng, (0.7, lambda: decades(rng, 0.05, 2.0)), (0.3, _extreme(rng)))
    whole = mass * (radius**2 + height**2)
    more = _one_of(
        rng,
        (0.1, lambda: 0.0),
        (0.1, lambda: 0.5 * axial * decades(rng, 1e-12, 1e-2)),
        (0.6, lambda: whole * decades(rng, 0.02, 3.0)),
        (0.2, lambda: whole * decades(rng, 1e-6, 1e2)),
    )
    return rr.Body(mass, radius, height, 0.5 * axial + more, axial)


def _extreme(rng: np.random.Generator) -> Callable[[], float]:
    return lambda: decades(rng, 1e-6, 50.0)


def _one_of(rng: np.random.Generator, *choices: Choice) -> float:
    parts = [part for part, _ in choices]
    _, draw = choices[int(rng.choice(len(choices), p=parts))]
    return draw()


def starts(rng: np.random.Generator, setting: Setting, count: int) -> rr.State:
    """States of a body, as arrays (count,)."""
    rate = math.sqrt(setting.gravity / max(setting.body.radius, setting.body.height))
    tilt = [_tilt(rng, setting.body) for _ in range(count)]
    tilt_rate = np.array([_rate(rng, rate) for _ in range(count)])
    falls = rng.random(count) < 0.5
    return rr.State(
        tilt=np.array(tilt),
        tilt_rate=np.where(falls, -np.abs(tilt_rate), tilt_rate),
        yaw_rate=np.array([_rate(rng, rate) for _ in range(count)]),
        spin_rate=np.array([_rate(rng, rate) for _ in range(count)]),
    )


def _tilt(rng: np.random.Generator, body: rr.Body) -> float:
    balance = rr.balance_tilt(body)
    top = math.pi if body.height == 0.0 else math.pi / 2
    side = float(rng.choice([-1.0, 1.0])) if body.height == 0.0 else -1.0
    tilt = _one_of(
        rng,
        (0.45, lambda: float(rng.uniform(0.02, 0.98)) * balance),
        (0.15, lambda: decades(rng, 1e-12, min(1.0, balance))),
        (0.1, lambda: balance * (1.0 + float(rng.choice([-1, 1])) * decades(rng, 1e-15, 0.1))),
        (0.1, lambda: top - decades(rng, 1e-9, 1.0)),
        (0.05, lambda: math.pi / 2 + side * decades(rng, 1e-15, 1e-2)),
        (0.15, lambda: float(rng.uniform(0.0, 1.0)) * top),
    )
    return min(max(tilt, 1e-12), top - 1e-9)


def _rate(rng: np.random.Generator, falling: float) -> float:
    sign = float(rng.choice([-1.0, 1.0]))
    return sign * _one_of(
        rng,
        (0.2, lambda: 0.0),
        (0.5, lambda: falling * decades(rng, 1e-3, 3.0)),
        (0.25, lambda: falling * decades(rng, 1e-12, 1e2)),
        (0.05, lambda: decades(rng, 1e-15, 1e4)),
    )
