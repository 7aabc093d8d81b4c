"""The friction that veers imply: measured turns held against simulated ones at every friction."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from rimroll.body import Body
from rimroll.gyro.collision import Collision
from rimroll.laws import Coulomb
from rimroll.many_falls import follow
from rimroll.options import Options
from rimroll.state import State
from rimroll.theory import needed_friction

Array = NDArray[np.float64]

POINTS = 81
"""Frictions that are simulated, from 0 to a little more than what rolling through needs."""
BEYOND = 1.15
"""The largest friction that is simulated, over that which rolling needs."""


@dataclass(frozen=True)
class Predicted:
    """Sizes of the turn from one start at each friction, (n,), rad, and their standard deviations.

    The errors are those of the start as it was measured. NaN where such a fall has no turn.
    """

    frictions: Array
    turns: Array
    errors: Array


@dataclass(frozen=True)
class Friction:
    """A friction coefficient from one veer, or from several.

    Attributes
    ----------
    best
        The friction that suits best; None if none suits.
    interval
        The frictions that suit at the confidence level; the upper end is None where rolling without
        slip suits as well. None if no friction suits.
    excludes_rolling, excludes_sliding
        Whether rolling without slip, and sliding without friction, are excluded at that level.
    chi_square, count
        Misfit of the best friction, and the number of veers.
    """

    best: float | None
    interval: tuple[float, float | None] | None
    excludes_rolling: bool
    excludes_sliding: bool
    chi_square: float
    count: int


def predicted(one: Collision, body: Body, gravity: float) -> Predicted:
    """The turns that falls from the start of a collision have under dry friction."""
    frictions = np.linspace(0.0, BEYOND * float(needed_friction(body)), POINTS)
    momentum = one.yaw_rate * math.sin(one.tilt_before) ** 2
    changes = [(0.0, 0.0), (one.momentum_error, 0.0), (0.0, one.spin_error)]
    turns = []
    for of_momentum, of_spin in changes:
        yaw_rate = (momentum + of_momentum) / math.sin(one.tilt_before) ** 2
        turns.append(_turns(one, yaw_rate, of_spin, frictions, body, gravity))
    errors = np.hypot(turns[1] - turns[0], turns[2] - turns[0])
    return Predicted(frictions, turns[0], errors)


def _turns(
    one: Collision, yaw_rate: float, spin: float, frictions: Array, body: Body, gravity: float
) -> Array:
    spin_rate = one.spin_rate + one.yaw_rate * math.cos(one.tilt_before) + spin
    start = State(
        tilt=one.tilt_before,
        tilt_rate=min(one.tilt_rate, 0.0),
        yaw_rate=yaw_rate,
        spin_rate=spin_rate - yaw_rate * math.cos(one.tilt_before),
    )
    options = Options.read(3.0, gravity, 1e-8, None, 100_000)
    falls = follow(body, start, Coulomb(frictions), options, threads=1)
    return np.abs(np.asarray(falls["turn"], np.float64))


def friction_from(
    collisions: Sequence[Collision], each: Sequence[Predicted], level: float
) -> Friction:
    """The friction that suits the veers of all collisions best; ``level`` is a chi square."""
    squares = np.zeros(POINTS)
    for one, there in zip(collisions, each, strict=True):
        error = np.hypot(there.errors, one.veer_error)
        squares += ((there.turns - math.pi - one.veer) / error) ** 2
    squares = np.where(np.isnan(squares), np.inf, squares)
    count = len(collisions)
    if not np.isfinite(squares).any():
        return Friction(None, None, False, False, math.inf, count)
    frictions = each[0].frictions
    fine = np.linspace(0.0, frictions[-1], 20 * (POINTS - 1) + 1)
    of_fine = np.interp(fine, frictions, squares)
    least = float(of_fine.min())
    # Veers that scatter more than their errors say are taken to have larger errors.
    freedom = count - 1
    scale = max(1.0, least / freedom) if freedom else 1.0
    suits = of_fine - least <= level * scale
    if freedom == 0 and least > level:
        return Friction(None, None, bool(squares[-1] > level), bool(squares[0] > level), least, 1)
    inside = fine[suits]
    rolls = bool(suits[-1])
    best = float(fine[np.argmin(of_fine)])
    return Friction(
        best,
        (float(inside[0]), None if rolls else float(inside[-1])),
        not rolls,
        not bool(suits[0]),
        least,
        count,
    )
