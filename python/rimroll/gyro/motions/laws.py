"""The best motion under one law: from both sides of each turn, and at every friction."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from rimroll.errors import RimrollError
from rimroll.gyro.analysis import Analysis
from rimroll.gyro.motions.model import RELEASE, START, Model, Window, highest_friction
from rimroll.gyro.motions.search import ROUNDS, Found, at_friction, least
from rimroll.gyro.motions.windows import LEAST_SIDE, Chain, first_guess, sides

Array = NDArray[np.float64]

FRICTIONS = 14
"""Frictions from which a search begins."""
COARSE = 10.0
"""The scatter is enlarged by this factor while a search begins."""
BEST = 3
"""Coarse minima from which the search goes on."""
SHORT = 5
"""Evaluations of a coarse search."""
FARTHEST = 10.0
"""How far from a start another one that turns to the other side is sought, rad/s."""
HALVINGS = 20
"""Bisections by which the start that comes down flat is found."""


def best_of_law(
    model: Model, found: Analysis, chains: Sequence[Chain], near: Found | None = None
) -> tuple[Found, list[float]]:
    """The best minimum of a model, and for each release the excess of the turn to the other side.

    The releases are fitted one by one, and then together. ``near``: a minimum under another law, at
    whose start and sensor a search begins as well.
    """
    alone = []
    for k, (window, chain) in enumerate(zip(model.windows, chains, strict=True)):
        hint = None
        if near is not None:
            shared = near.vector[len(near.model.free) : near.model.place(0).start]
            hint = np.concatenate([shared, near.vector[near.model.place(k)]])
        alone.append(_of_release(replace(model, windows=[window]), found, chain, hint))
    excess = [one[1] for one in alone]
    if len(alone) == 1:
        return alone[0][0], excess
    return together(model, [one[0] for one in alone]), excess


def together(model: Model, alone: Sequence[Found]) -> Found:
    """The minimum of several releases near those of each."""
    shared = np.mean([one.vector[: -len(RELEASE)] for one in alone], axis=0)
    each = [one.vector[-len(RELEASE) :] for one in alone]
    return least(model, np.concatenate([shared, *each]), 30)


def _of_release(
    model: Model, found: Analysis, chain: Chain, hint: Array | None
) -> tuple[Found, float]:
    first = chain.collisions[0]
    rates = sides(found, first)[: 1 if first.side_is_sure else 2]
    tried = [_from_side(model, found, chain, rate) for rate in rates]
    minima = [one for one in tried if one is not None]
    if hint is not None:
        minima.append(
            least(model, np.concatenate([model.numbers_of_law_given(), hint]), 2 * ROUNDS)
        )
    if not minima:
        raise RimrollError(
            f"{found.record.name}: no motion under {model.law!r} begins as the one at"
            f" {first.start:.2f} s"
        )
    best = min(minima, key=lambda one: one.squares)
    other = _other_side(best)
    if other is None:
        return best, math.inf
    if other.squares < best.squares:
        best, other = other, best
    return best, other.squares - best.squares


def _turns_left(one: Found, vector: Array) -> bool:
    """Whether the first turn of the motion is to the left."""
    motion = one.model.motion(vector, 0, one.model.law_at(vector))
    return bool(motion.turns) and motion.turns[0].angle > 0.0


def _other_side(one: Found) -> Found | None:
    """The minimum on the other side of the starts that come down flat; None if there is none.

    The search begins with a yaw rate as far from the watershed as that of the minimum.
    """
    place = one.model.place(0).start + START.index("yaw_rate")
    side = _turns_left(one, one.vector)
    away = -LEAST_SIDE if side else LEAST_SIDE

    def at(yaw_rate: float) -> Array:
        vector = one.vector.copy()
        vector[place] = yaw_rate
        return vector

    here, there = float(one.vector[place]), float(one.vector[place])
    while _turns_left(one, at(there)) == side:
        there += away
        away *= 2.0
        if abs(away) > FARTHEST:
            return None
    for _ in range(HALVINGS):
        middle = 0.5 * (here + there)
        if _turns_left(one, at(middle)) == side:
            here = middle
        else:
            there = middle
    mirrored = at(2.0 * there - float(one.vector[place]))
    found = least(one.model, mirrored)
    return None if _turns_left(one, found.vector) == side else found


def _from_side(model: Model, found: Analysis, chain: Chain, yaw_rate: float) -> Found | None:
    """The best minimum from a start that turns to one side; None where no motion begins so."""
    first = chain.collisions[0]
    if "friction" not in model.free:
        try:
            start, _ = _coarse(model, first_guess(model, first, yaw_rate), first.time)
        except RimrollError:
            return None
        return least(model, start.vector, 2 * ROUNDS)
    frictions = np.linspace(0.0, highest_friction(model.body), FRICTIONS)[::-1]
    coarse: list[tuple[float, float, Array]] = []
    begun: Array | None = None
    for friction in frictions:
        fixed = at_friction(model, float(friction))
        try:
            if begun is None:
                begun = first_guess(fixed, first, yaw_rate)
            one, begun = _coarse(fixed, begun, first.time)
        except RimrollError:
            continue
        coarse.append((one.squares, float(friction), one.vector))
    if not coarse:
        return None
    coarse.sort(key=lambda one: one[0])
    place = model.free.index("friction")
    fine = [
        least(model, np.insert(vector, place, friction), SHORT)
        for _, friction, vector in coarse[:BEST]
    ]
    return least(model, min(fine, key=lambda one: one.squares).vector, 2 * ROUNDS)


def _coarse(model: Model, vector: Array, collision: float) -> tuple[Found, Array]:
    """A minimum with a larger scatter: of the fall alone, and then of all samples.

    Also the numbers that suit the fall alone.
    """
    (window,) = model.windows
    large = replace(window, scatter=COARSE * window.scatter)
    fall = window.t <= collision
    falling = Window(window.release, window.t[fall], window.rates[fall], large.scatter[fall])
    of_fall = least(replace(model, windows=[falling]), vector, SHORT)
    return least(replace(model, windows=[large]), of_fall.vector, SHORT), of_fall.vector
