"""Densities of the direction of fall for each friction of the table and unsteadiness of the hand.

Falls are simulated once for each friction, with hands from steady to unsteady. For a hand of any
unsteadiness in between, they are weighted by the likelihood ratio of their release.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from rimroll import _core
from rimroll.bodies.body import Body, one_body
from rimroll.errors import RimrollError, callback
from rimroll.experiment.release import Release, normal_quantiles
from rimroll.experiment.toppling import FALLING
from rimroll.laws import Coulomb, NoSlip
from rimroll.many.ensemble import follow
from rimroll.state import State
from rimroll.theory.closed_forms import arrival, needed_friction
from rimroll.units import Number, number, whole_number

Array = NDArray[np.float64]

TURN = 2.0 * math.pi
ANGLES = 720
"""Points of a density round the circle, half a degree apart."""

READING_ERROR = math.radians(2.0)
"""Default standard deviation of the reading of a direction, rad."""

MIN_ERROR = math.radians(0.5)
"""The smallest error of reading, rad: below, densities would be narrower than their spacing."""

STRAY = 0.01
"""The fraction of readings that are assumed to be mistakes, with any value."""

HANDS = (0.25, 0.7, 2.0, 6.0)
"""The unsteadiness of the simulated hands, as factors on the release's scatter."""

UNSTEADY = np.geomspace(0.2, 6.0, 15)
"""The unsteadiness of the hands for which densities are stored."""

SEED = 2007
"""Seed of the points at which hands are simulated."""

MIN_FRICTIONS = 25
"""With fewer frictions, splines between them are inaccurate and intervals too narrow."""

MIN_FALLS = 20
"""The smallest number of simulated falls to one side for a density."""


@dataclass(frozen=True, eq=False)
class Predicted:
    """Densities of the direction of fall.

    Attributes
    ----------
    body, release, gravity, reading_error
        The inputs.
    frictions
        Coefficients of dry friction (f,), from 0 to one at which the rim holds; see
        :func:`nodes`.
    unsteadiness
        Factors (k,) on the scatter of the release's ``sideways`` and ``twist``.
    left, right
        Density per radian (f, k, a) of the direction of a fall to the left of the hand (above π)
        and to its right, at a = 720 angles from 0 on.
    outcome
        The outcome that counts as a fall: ``toppled`` or ``rocked``.
    share
        The fraction (f,) of the releases with that outcome.
    """

    body: Body
    release: Release
    gravity: float
    reading_error: float
    frictions: Array
    unsteadiness: Array
    left: Array
    right: Array
    outcome: str
    share: Array


def predict_falls(
    body: Body,
    release: Release | str = "flick",
    *,
    gravity: Number = _core.STANDARD_GRAVITY,
    reading_error: Number = READING_ERROR,
    frictions: int = 33,
    falls: int = 1024,
    outcome: str | None = None,
    threads: int | None = None,
    progress: Callable[[int, int], object] | None = None,
) -> Predicted:
    """Simulate falls at each friction, from 0 to more than rolling needs.

    Raises ``RimrollError`` for numbers outside their bounds and if the body neither topples nor
    rocks after such a release.

    Parameters
    ----------
    body, release, gravity
        As for :func:`rimroll.topple`.
    reading_error
        Standard deviation of reading a direction, rad.
    frictions, falls
        Number of coefficients of friction, and approximate number of falls at each, a power of two.
    outcome
        The outcome that counts as a fall, ``toppled`` or ``rocked``. By default ``toppled`` if the
        release topples the body at half of the frictions or more, else ``rocked``.
    threads, progress
        As for :func:`rimroll.ensemble`.
    """
    one_body(body)
    callback("progress", progress)
    gravity = number("gravity", gravity, "m/s^2")
    error = number("reading_error", reading_error, "rad")
    if not MIN_ERROR <= error <= 1.0:
        raise RimrollError(
            field="reading_error",
            value=math.degrees(error),
            bound=f"between {math.degrees(MIN_ERROR):g} and 57 degrees",
            unit="degrees",
        )
    count, each = whole_number("frictions", frictions), whole_number("falls", falls)
    if count < MIN_FRICTIONS:
        raise RimrollError(field="frictions", value=count, bound=f"at least {MIN_FRICTIONS}")
    if each < 128:
        raise RimrollError(field="falls", value=each, bound="at least 128")
    if isinstance(release, str):
        release = Release.named(release, body, gravity)
    if not isinstance(release, Release):
        raise RimrollError(
            field="release", value=release, bound="a rimroll.Release or the name of a preset"
        )
    grid = _enough(body, release, gravity) * nodes(count)
    draws = _Draws.of(release, each)
    options = replace(FALLING, gravity=gravity)
    gone, outcomes = [], []
    for i, friction in enumerate(grid):
        law = Coulomb(float(friction))
        found = follow(
            body, draws.starts, law, options, friction_scale=draws.friction_scale, threads=threads
        )
        anticlockwise, direction = found["turn"] > 0.0, found["direction"]
        # Signed, so that the mirror image of a fall has the opposite sign.
        gone.append(np.where(anticlockwise, direction, direction - TURN))
        outcomes.append(found["outcome"])
        if progress is not None:
            progress(i + 1, count)
    word = _checked(outcome) or _usual(outcomes)
    fell = np.array([outcome == word for outcome in outcomes])
    angles = np.where(fell, gone, np.nan)
    sides = _humps(angles, draws.weights, release.symmetric, error, word)
    usual_hand = draws.weights[np.abs(draws.unsteadiness - 1.0).argmin()]
    share = fell @ usual_hand / usual_hand.sum()
    # A disk that turns anticlockwise goes more than all the way round, and ends up on the right.
    left, right = sides if np.nanmedian(np.abs(angles)) > math.pi else sides[::-1]
    return Predicted(
        body, release, gravity, error, grid, draws.unsteadiness, left, right, word, share
    )


def _checked(outcome: object) -> str | None:
    if outcome not in (None, "toppled", "rocked"):
        raise RimrollError(field="outcome", value=outcome, bound="toppled or rocked")
    return None if outcome is None else str(outcome)


def _usual(outcomes: list[NDArray[np.str_]]) -> str:
    toppling = [np.sum(outcome == "toppled") >= MIN_FALLS for outcome in outcomes]
    return "toppled" if np.mean(toppling) >= 0.5 else "rocked"


def nodes(count: int) -> Array:
    """Numbers from 0 to 1, at first three times as close together as in the end.

    A little friction changes a turn most.
    """
    x = np.linspace(0.0, 1.0, count)
    return np.asarray(0.5 * (x + x * x))


def which_node(part: float | Array, count: int) -> float | Array:
    """The inverse: where among the nodes a number from 0 to 1 is."""
    return 0.5 * (np.sqrt(1.0 + 8.0 * np.asarray(part)) - 1.0) * (count - 1)


def _enough(body: Body, release: Release, gravity: float) -> float:
    """A coefficient at which the rim slips nowhere, as far as can be known beforehand."""
    needed = needed_friction(body)
    straight = release.mean
    try:
        tipping = arrival(body, straight, NoSlip(), gravity).friction_ratio
    except RimrollError:
        tipping = needed
    return float(1.3 * max(needed, tipping, 0.1) / release.friction_scale[0])


@dataclass(frozen=True)
class _Draws:
    """Starts by hands of all kinds, and the weight (k, n) of each for a hand of one kind."""

    starts: State
    friction_scale: Array
    unsteadiness: Array
    weights: Array

    @classmethod
    def of(cls, release: Release, count: int) -> _Draws:
        sideways, twist = release.sideways[1], release.twist[1]
        steady = sideways == 0.0 and twist == 0.0
        hands = np.array([1.0] if steady else HANDS)
        points = _even_points(round(math.log2(count / len(hands))))
        parts = [release.with_unsteadiness(float(hand)).at(points) for hand in hands]
        starts = State(
            **{
                name: np.concatenate([getattr(start, name) for start, _ in parts])
                for name in ("tilt", "tilt_rate", "yaw_rate", "spin_rate")
            }
        )
        friction_scale = np.concatenate([friction_scale for _, friction_scale in parts])
        if steady:
            return cls(starts, friction_scale, np.ones(1), np.ones((1, len(friction_scale))))
        # What was drawn, in units of the release's own scatter, where it has any.
        varied = [column for column, spread in ((2, sideways), (3, twist)) if spread > 0.0]
        drawn = np.concatenate([hand * normal_quantiles(points[:, varied]) for hand in hands])

        def density(hand: Array) -> Array:
            # Without the constant of the normal density, which cancels in the weights.
            squares = ((drawn / hand[:, None, None]) ** 2).sum(-1)
            return np.asarray(np.exp(-0.5 * squares) / hand[:, None] ** len(varied))

        weights = density(UNSTEADY) / density(hands).mean(axis=0)
        return cls(starts, friction_scale, UNSTEADY, weights)


def _even_points(power: int) -> Array:
    """2^``power`` points (n, 5) that fill a cube evenly, always the same ones."""
    from scipy.stats import qmc

    engine: Any = qmc.Sobol(5, seed=SEED)
    return np.asarray(engine.random_base2(power))


def _humps(
    gone: Array, weights: Array, symmetric: bool, error: float, word: str
) -> tuple[Array, Array]:
    """Densities (f, k, a) of falls that turned anticlockwise and clockwise.

    ``gone`` (f, n) is the angle to where a body fell, the way it turned: above 0 anticlockwise, NaN
    for what does not count. A release that favours neither side throws mirror images as often. To a
    side to which one hardly throws at any friction, readings are strays.
    """
    ways = (
        [np.abs(gone)] if symmetric else [np.where(s * gone > 0.0, gone, np.nan) for s in (1, -1)]
    )
    enough = [np.sum(~np.isnan(way), axis=1) >= MIN_FALLS for way in ways]
    if not np.any(enough):
        raise RimrollError(
            f"of {gone.shape[1]} simulated releases at each friction fewer than {MIN_FALLS} {word}"
            " to one side: a release of another kind is needed"
        )
    humps = []
    for way, there in zip(ways, enough, strict=True):
        if there.any():
            # Where too few fall so, as they do at the nearest friction where enough do.
            known = np.flatnonzero(there)
            nearest = known[np.abs(known - np.arange(len(gone))[:, None]).argmin(axis=1)]
            humps.append(np.array([_density(one, weights, error) for one in way[nearest]]))
        else:
            humps.append(np.full((len(gone), len(weights), ANGLES), 1.0 / TURN))
    # The angle at index i is the mirror image of that at −i.
    return humps[0], np.roll(humps[0][..., ::-1], 1, axis=-1) if symmetric else humps[1]


def _density(gone: Array, weights: Array, error: float) -> Array:
    """Weighted falls (n,) as densities (k, a), blurred by the error of reading."""
    there = ~np.isnan(gone)
    # Between two angles a fall counts for both, by how near it is.
    place = np.mod(gone[there], TURN) / TURN * ANGLES
    below = place.astype(int)
    part = place - below
    counts = np.zeros((len(weights), ANGLES))
    for k, weight in enumerate(weights[:, there]):
        np.add.at(counts[k], below % ANGLES, weight * (1.0 - part))
        np.add.at(counts[k], (below + 1) % ANGLES, weight * part)
    # A steady hand may be all but unable to throw there.
    counts /= np.maximum(counts.sum(axis=1, keepdims=True), np.finfo(np.float64).tiny)
    # The transform of a normal density wrapped round the circle, less the spread that counting for
    # two angles made.
    variance = error**2 - (TURN / ANGLES) ** 2 / 6.0
    blur = np.exp(-0.5 * variance * np.arange(ANGLES // 2 + 1) ** 2)
    smooth = np.fft.irfft(np.fft.rfft(counts, axis=1) * blur, ANGLES, axis=1)
    hump = np.maximum(smooth, 0.0) * (ANGLES / TURN)
    return np.asarray((1.0 - STRAY) * hump + STRAY / TURN)
