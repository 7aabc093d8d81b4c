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
    """Sizes of the turn from one start at each friction, (n,), rad.

    ``by_momentum`` and ``by_spin``, (n,), rad/(rad/s): their changes with the momentum about the
    vertical and with the spin at the start. NaN where such a fall has no turn.
    """

    frictions: Array
    turns: Array
    by_momentum: Array
    by_spin: Array


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

    def turns(of_momentum: float, of_spin: float) -> Array:
        more = of_momentum / math.sin(one.tilt_before) ** 2
        return _turns(one, one.yaw_rate + more, of_spin, frictions, body, gravity)

    here = turns(0.0, 0.0)
    # Differences over the errors themselves: near the side that is not sure, turns bend.
    steps = np.hypot(one.own_errors, np.linalg.norm(one.shared_errors, axis=0))[1:]
    of_momentum, of_spin = turns(float(steps[0]), 0.0), turns(0.0, float(steps[1]))
    return Predicted(frictions, here, (of_momentum - here) / steps[0], (of_spin - here) / steps[1])


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
    squares = _squares(collisions, each)
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


def _squares(collisions: Sequence[Collision], each: Sequence[Predicted]) -> Array:
    """Chi square of the veers at each friction, (n,); infinite where one has no turn.

    Veers of a record share the errors of its axis, bias and sensitivity, which also change the
    start from which a turn is predicted: the covariance contains both.
    """
    apart = np.stack(
        [there.turns - math.pi - one.veer for one, there in zip(collisions, each, strict=True)]
    )
    # How the turn predicted less that measured changes with turn, momentum and spin: (veers, 3, n).
    slopes = np.stack([[-np.ones(POINTS), one.by_momentum, one.by_spin] for one in each])
    own = np.stack([one.own_errors for one in collisions])
    shared = np.stack([one.shared_errors for one in collisions])
    squares = np.full(POINTS, np.inf)
    for k in np.flatnonzero(np.isfinite(apart).all(axis=0) & np.isfinite(slopes).all(axis=(0, 1))):
        together = np.einsum("vsi,vi->vs", shared, slopes[:, :, k])
        alone = np.sum((own * slopes[:, :, k]) ** 2, axis=1)
        covariance = together @ together.T + np.diag(alone)
        squares[k] = apart[:, k] @ np.linalg.solve(covariance, apart[:, k])
    return squares
