"""Where the fit of a motion begins, and the best motion under one law."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from rimroll.errors import RimrollError
from rimroll.laws import Frictionless, NoSlip
from rimroll.many.left_or_right import watershed_slope
from rimroll.sensors.fits import ROUNDS, START, Minimum, at_friction, highest_friction, least
from rimroll.sensors.gyro.analysis import Analysis
from rimroll.sensors.gyro.collision import Collision
from rimroll.sensors.gyro.motion_model import RELEASE, SHARED, Model, Window
from rimroll.sensors.gyro.peaks import GUARD

Array = NDArray[np.float64]

SENSITIVITY = 1e-3
"""Error of a rate over the rate: the digital output and the axes are not ideal."""
TIMING = 1e-4
"""Error of the time of a sample, s."""
FADING = 0.5
"""The time after a collision that is not fitted if a filter was taken out, over the period of its
cut-off frequency: twice its decay time."""
LEAST_SIDE = 1e-3
"""The least difference in yaw rate between starts that turn to either side, rad/s."""


@dataclass(frozen=True)
class Chain:
    """The near-collisions after one release, each following from the one before."""

    collisions: list[Collision]


def chains_of(found: Analysis) -> list[Chain]:
    """The near-collisions by release; those whose release was not seen only if no other was."""
    chains: list[list[Collision]] = []
    for one in found.collisions:
        last = chains[-1][-1] if chains else None
        if not one.released and last is not None and one.start == last.end:
            chains[-1].append(one)
        else:
            chains.append([one])
    released = [one for one in chains if one[0].released]
    return [Chain(one) for one in (released or chains)]


def window_of(found: Analysis, chain: Chain, count: int) -> Window:
    """The samples from the release to the largest tilt after ``count`` near-collisions."""
    some = chain.collisions[:count]
    record = found.record
    t, step = record.t, record.step
    used = (t >= some[0].start) & (t <= some[-1].end)
    for one in some:
        used &= (t <= one.last_before) | (t >= one.first_after + _fading(found))
    rates = record.rates - found.rests.bias_at(t)
    slopes = np.linalg.norm(np.gradient(rates, t, axis=0), axis=1)[used]
    sizes = np.linalg.norm(rates[used], axis=1)
    scatter = np.sqrt(found.rests.noise**2 + (SENSITIVITY * sizes) ** 2 + (TIMING * slopes) ** 2)[
        :, np.newaxis
    ]
    release = some[0].start - (GUARD + 0.5) * step
    return Window(release, t[used], rates[used], scatter)


def _fading(found: Analysis) -> float:
    """How long after a collision a filter that was taken out leaves a rest of the jump, s."""
    return 0.0 if found.filter_cutoff is None else FADING / found.filter_cutoff


def sides(found: Analysis, one: Collision) -> tuple[float, float]:
    """Yaw rates from which the body turns to either side, the likelier one first, rad/s.

    They lie as far on either side of the starts that come down flat as the measured one.
    """
    body, tilt = found.body, one.tilt_before
    slopes = []
    for law in (NoSlip(), Frictionless()):
        try:
            slopes.append(watershed_slope(body, tilt, law))
        except RimrollError:
            continue
    middle = float(np.mean(slopes)) * one.spin_rate if slopes else 0.0
    unsure = one.momentum_error / math.sin(tilt) ** 2
    away = max(abs(one.yaw_rate - middle), unsure, LEAST_SIDE)
    sign = 1.0 if one.turn >= 0.0 else -1.0
    return middle + sign * away, middle - sign * away


def first_guess(model: Model, one: Collision, yaw_rate: float) -> Array:
    """The numbers of a model with one window, as the collision was read.

    ``RimrollError`` if the motion from there ends before the first sample.
    """
    spin = one.spin_rate + (one.yaw_rate - yaw_rate) * math.cos(one.tilt_before)
    law = model.numbers_of_law_given()
    vector = np.concatenate(
        [law, np.zeros(len(SHARED)), [one.tilt_before, one.tilt_rate, yaw_rate, spin, 0.0, 0.0]]
    )
    window = model.windows[0]
    rates = model.shown(vector, 0)
    fall = (window.t <= one.time) & np.isfinite(rates).all(axis=1)
    if not fall.any():
        raise RimrollError("the motion ends before the first sample")
    shown = model.sensing.unturned(rates[fall])
    seen = model.sensing.unturned(window.rates[fall])
    # Rates across the axis turn by minus the azimuth.
    across = np.sum((seen[:, 0] + 1j * seen[:, 1]) * (shown[:, 0] - 1j * shown[:, 1]))
    vector[-2] = -float(np.angle(across))
    return vector


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
    model: Model, found: Analysis, chains: Sequence[Chain], near: Minimum[Model] | None = None
) -> tuple[Minimum[Model], list[float]]:
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


def together(model: Model, alone: Sequence[Minimum[Model]]) -> Minimum[Model]:
    """The minimum of several releases near those of each."""
    shared = np.mean([one.vector[: -len(RELEASE)] for one in alone], axis=0)
    each = [one.vector[-len(RELEASE) :] for one in alone]
    return least(model, np.concatenate([shared, *each]), 30)


def _of_release(
    model: Model, found: Analysis, chain: Chain, hint: Array | None
) -> tuple[Minimum[Model], float]:
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


def _turns_left(one: Minimum[Model], vector: Array) -> bool:
    """Whether the first turn of the motion is to the left."""
    motion = one.model.motion(vector, 0, one.model.law_at(vector))
    return bool(motion.turns) and motion.turns[0].angle > 0.0


def _other_side(one: Minimum[Model]) -> Minimum[Model] | None:
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


def _from_side(
    model: Model, found: Analysis, chain: Chain, yaw_rate: float
) -> Minimum[Model] | None:
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


def _coarse(model: Model, vector: Array, collision: float) -> tuple[Minimum[Model], Array]:
    """A minimum with a larger scatter: of the fall alone, and then of all samples.

    Also the numbers that suit the fall alone.
    """
    (window,) = model.windows
    large = replace(window, scatter=COARSE * window.scatter)
    fall = window.t <= collision
    falling = Window(window.release, window.t[fall], window.rates[fall], large.scatter[fall])
    of_fall = least(replace(model, windows=[falling]), vector, SHORT)
    return least(replace(model, windows=[large]), of_fall.vector, SHORT), of_fall.vector
