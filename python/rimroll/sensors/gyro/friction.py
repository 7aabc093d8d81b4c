"""The friction that veers imply: measured turns held against simulated ones at every friction."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from rimroll.bodies.body import Body
from rimroll.laws import Coulomb
from rimroll.many.ensemble import follow
from rimroll.options import Options
from rimroll.sensors.fits import BEYOND
from rimroll.sensors.gyro.collision import Collision
from rimroll.state import State
from rimroll.theory.closed_forms import needed_friction

Array = NDArray[np.float64]

POINTS = 41
"""Frictions that are simulated, from 0 to a little more than what rolling through needs."""
FINER = 50
"""Into how many parts each step between them is divided: turns are straight lines there."""


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
    options = Options(3.0, gravity=gravity, rtol=1e-8, max_steps=100_000)
    falls = follow(body, start, Coulomb(frictions), options, threads=1)
    return np.abs(np.asarray(falls["turn"], np.float64))


def friction_from(
    collisions: Sequence[Collision], each: Sequence[Predicted], level: float
) -> Friction:
    """The friction that suits the veers of all collisions best; ``level`` is a chi square."""
    frictions = each[0].frictions
    fine = np.linspace(0.0, frictions[-1], FINER * (len(frictions) - 1) + 1)
    squares = _squares(collisions, each, fine)
    count = len(collisions)
    if not np.isfinite(squares).any():
        return Friction(None, None, False, False, math.inf, count)
    at, least = int(np.argmin(squares)), float(squares.min())
    # Veers that scatter more than their errors say are taken to have larger errors.
    freedom = count - 1
    scale = max(1.0, least / freedom) if freedom else 1.0
    above = squares - least - level * scale
    suits = above <= 0.0
    if freedom == 0 and least > level:
        return Friction(None, None, bool(squares[-1] > level), bool(squares[0] > level), least, 1)
    inside = np.flatnonzero(suits)
    rolls = bool(suits[-1])
    low = _crossing(fine, above, int(inside[0]), -1)
    high = None if rolls else _crossing(fine, above, int(inside[-1]), 1)
    return Friction(
        _lowest(fine, squares, at), (low, high), not rolls, not bool(suits[0]), least, count
    )


def _crossing(fine: Array, above: Array, last: int, side: int) -> float:
    """Where chi square passes its threshold, beside the last friction that suits."""
    beyond = last + side
    if not 0 <= beyond < len(fine) or not np.isfinite(above[beyond]):
        return float(fine[last])
    part = -above[last] / (above[beyond] - above[last])
    return float(fine[last] + part * (fine[beyond] - fine[last]))


def _lowest(fine: Array, squares: Array, at: int) -> float:
    """The friction of the least chi square, by a parabola over three."""
    if not 0 < at < len(fine) - 1:
        return float(fine[at])
    before, here, after = squares[at - 1 : at + 2]
    bend = before - 2.0 * here + after
    if not (np.isfinite(bend) and bend > 0.0):
        return float(fine[at])
    return float(fine[at] + 0.5 * (before - after) / bend * (fine[1] - fine[0]))


def _squares(collisions: Sequence[Collision], each: Sequence[Predicted], fine: Array) -> Array:
    """Chi square of the veers at frictions, (n,); infinite where one has no turn.

    Veers of a record share the errors of its axis, bias and sensitivity, which also change the
    start from which a turn is predicted: the covariance contains both.
    """

    def between(name: str) -> Array:
        return np.stack([np.interp(fine, one.frictions, getattr(one, name)) for one in each])

    turns, by_momentum, by_spin = map(between, ("turns", "by_momentum", "by_spin"))
    apart = turns - math.pi - np.array([[one.veer] for one in collisions])
    # How the turn predicted less that measured changes with turn, momentum and spin: (3, veers, n).
    slopes = np.stack([-np.ones_like(turns), by_momentum, by_spin])
    own = np.stack([one.own_errors for one in collisions])
    shared = np.stack([one.shared_errors for one in collisions])
    known = np.isfinite(apart).all(axis=0) & np.isfinite(slopes).all(axis=(0, 1))
    apart, slopes = apart[:, known].T, slopes[:, :, known]
    together = np.einsum("vsi,ivn->nvs", shared, slopes)
    alone = np.einsum("vi,ivn->nv", own**2, slopes**2)
    covariance = together @ together.transpose(0, 2, 1) + alone[:, :, np.newaxis] * np.eye(len(own))
    squares = np.full(len(fine), np.inf)
    solved = np.linalg.solve(covariance, apart[:, :, np.newaxis])[:, :, 0]
    squares[known] = np.sum(apart * solved, axis=1)
    return squares
