"""Motions fitted to what a sensor saw, by least squares: what gyroscopes and films share.

A model says what its sensor shows of a motion under a law and how far that is from a record; here
are the numbers of a law that may change, the minimum near a guess, and the interval of a number by
profile likelihood.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from statistics import NormalDist
from typing import Any, Generic, Protocol, TypeVar

import numpy as np
from numpy.typing import NDArray

from rimroll.bodies.body import Body
from rimroll.errors import RimrollError
from rimroll.laws import Law
from rimroll.theory.closed_forms import needed_friction
from rimroll.units import quantities_of

Array = NDArray[np.float64]

BODY = ("radius", "height", "transverse_inertia", "axial_inertia")
"""The numbers of the body, whose relative deviations are fitted; its mass does not matter alone."""
START = ("tilt", "tilt_rate", "yaw_rate", "spin_rate")
"""The numbers of a start that are fitted with exact derivatives."""
RTOL = 1e-8
"""Tolerance of the motions: far below what any sensor resolves."""
MOST_STEPS = 50_000
UNREACHED = 1e3
"""What a motion that has ended, or cannot be computed, differs by, in standard deviations."""
OF_DISKS = 1.0
"""The largest friction that is tried for a body without height."""
BEYOND = 1.15
"""The largest friction that is simulated, over that which rolling needs."""

FIXED = frozenset(("restitution", "air_exponent", "exponent"))
"""Numbers that are not fitted unless they are named."""


def fitted_names(law: Law, fit: Sequence[str] | None) -> list[str]:
    """The numbers that are fitted: those named, or all positive ones but exponents and restitution.

    Raises ``RimrollError`` for a name that the law does not have as a single number.
    """
    single = [name for name, value in law.numbers.items() if isinstance(value, float)]
    if fit is None:
        return [name for name in single if law.numbers[name] != 0.0 and name not in FIXED]
    for name in fit:
        if name not in single:
            have = ", ".join(single) or "no numbers"
            raise RimrollError(f"{law!r} has no number {name!r} to fit; it has {have}")
    return list(dict.fromkeys(fit))


def with_numbers(law: Law, numbers: Mapping[str, float]) -> Law:
    """The law with some of its numbers changed, by the names in ``law.numbers``."""
    own = {name: numbers[name] for name in quantities_of(type(law)) if name in numbers}
    others = []
    for one in law.resistances:
        names = zip(one.core_names(), quantities_of(type(one)), strict=True)
        changed: Any = {name: numbers[core] for core, name in names if core in numbers}
        others.append(replace(one, **changed))
    return replace(law, **own, resistances=tuple(others))


def highest_friction(body: Body) -> float:
    """The largest friction that is tried: a little more than what rolling through needs."""
    return BEYOND * float(needed_friction(body)) or OF_DISKS


def chi_square(confidence: float) -> float:
    """The chi square of one degree of freedom that is exceeded with the rest of the probability."""
    return NormalDist().inv_cdf(0.5 + 0.5 * confidence) ** 2


@dataclass(frozen=True)
class Estimate:
    """A fitted number: ``error`` is its standard deviation, by the covariance.

    ``interval`` is at the confidence level; ``method`` says how it was found, ``"profile"`` or
    ``"covariance"``. An end that the record does not limit is None.
    """

    value: float
    error: float
    interval: tuple[float | None, float | None]
    method: str


class Model(Protocol):
    """Motions beside a record: a frozen dataclass."""

    @property
    def law(self) -> Law:
        """The law of contact."""

    @property
    def free(self) -> tuple[str, ...]:
        """The numbers of the law that are fitted, which come first in a vector of numbers."""

    def residuals(self, vector: Array) -> Array:
        """What is left over its error, and of what is expected over its error."""

    def jacobian(self, vector: Array) -> Array:
        """Derivatives of the residuals by the numbers."""

    def bounds(self) -> tuple[Array, Array]:
        """The lowest and the highest numbers that are tried."""


AnyModel = TypeVar("AnyModel", bound=Model)


ROUNDS = 12
"""Most evaluations of a search."""
PRECISION = 1e-5
"""Relative change of the sum of squares at which a search ends."""


@dataclass(frozen=True)
class Minimum(Generic[AnyModel]):
    """A minimum: the model, its numbers, the sum of squares (with priors), and the derivatives."""

    model: AnyModel
    vector: Array
    squares: float
    jacobian: Array

    @property
    def covariance(self) -> Array:
        """The covariance of the numbers, if the scatter is right."""
        return np.asarray(np.linalg.pinv(self.jacobian.T @ self.jacobian, hermitian=True))


def least(model: AnyModel, vector: Array, rounds: int = ROUNDS) -> Minimum[AnyModel]:
    """The minimum near a vector, by SciPy's trust region."""
    from scipy.optimize import least_squares

    low, high = model.bounds()
    inside = 1e-9 * np.minimum(high - low, 1.0)
    found = least_squares(
        model.residuals, np.clip(vector, low + inside, high - inside), model.jacobian,
        bounds=(low, high), x_scale="jac", ftol=PRECISION, xtol=1e-10, gtol=1e-10,
        max_nfev=rounds,
    )  # fmt: skip
    return Minimum(model, found.x, 2.0 * float(found.cost), found.jac)


def at_friction(model: AnyModel, friction: float) -> AnyModel:
    """The model with its friction fixed."""
    law = with_numbers(model.law, {"friction": friction})
    changed: Any = model  # a dataclass
    fixed: AnyModel = replace(
        changed, law=law, free=tuple(n for n in model.free if n != "friction")
    )
    return fixed


def inflation(normal: Array, numbers: int) -> float:
    """The factor of :func:`inflation_of`, from normalised residuals (n, k) of a fit."""
    square = float(np.mean(normal**2))
    together = 1.0
    for lag in range(1, max(len(normal) // 4, 1)):
        correlation = float(np.mean(normal[lag:] * normal[:-lag])) / max(square, 1e-300)
        if correlation <= 2.0 / math.sqrt(normal.size):
            break
        together += 2.0 * correlation
    freedom = max(normal.size - numbers, 1)
    return max(1.0, square * normal.size / freedom) * together


MOST_TRIES = 30
"""Steps to either side of the minimum."""
MOST_HALVINGS = 8
"""How often a step that went too far is halved."""
FAR = 4.0
"""A rise that is larger than so many of those asked for is too far."""
LEAST_STEP = 1e-7
"""The smallest step, over the largest friction."""


def friction_interval(
    best: Minimum[AnyModel], rise: float, highest: float, rounds: int = ROUNDS
) -> tuple[float, float | None, Minimum[AnyModel]]:
    """The frictions at which the sum of squares is at most ``rise`` larger than at its minimum.

    From the minimum one goes to either side in growing steps, fits all other numbers again at each,
    and finds the end by interpolation of the root of the rise. The lower end is 0 and the upper one
    None where the rise is not reached. Also returns the lowest minimum that was met. Each fit makes
    at most so many ``rounds``.
    """
    place = best.model.free.index("friction")
    error = math.sqrt(float(best.covariance[place, place]) * rise)
    if not LEAST_STEP * highest < error:  # where the rim does not slip, friction changes nothing
        flat = np.abs(best.jacobian[:, place]).max() == 0.0
        error = (0.1 if flat else LEAST_STEP) * highest
    least_squares = best
    ends: list[float | None] = []
    for sign in (-1.0, 1.0):
        end, lower = _end(best, place, sign, rise, error, highest, rounds)
        ends.append(end)
        if lower.squares < least_squares.squares:
            least_squares = lower
    return ends[0] or 0.0, ends[1], least_squares


def _end(
    best: Minimum[AnyModel],
    place: int,
    sign: float,
    rise: float,
    error: float,
    highest: float,
    rounds: int,
) -> tuple[float | None, Minimum[AnyModel]]:
    center = float(best.vector[place])
    limit = highest if sign > 0.0 else 0.0
    step = min(error, 0.1 * highest)
    vector = np.delete(best.vector, place)
    before, height, refined = center, 0.0, 0
    lowest = best
    for _ in range(MOST_TRIES):
        at = before + sign * step
        at = min(at, limit) if sign > 0.0 else max(at, limit)
        one = least(at_friction(best.model, at), vector, rounds)
        now = one.squares - best.squares
        if one.squares < lowest.squares - 1e-3:
            lowest = _freed(best, one, place, at, rounds)
        if now > FAR * rise and refined < MOST_HALVINGS:  # too far: back half of the way
            step, refined = 0.5 * abs(at - before), refined + 1
            continue
        if now >= rise:
            # The square root of the rise is nearly straight.
            low, high = math.sqrt(height), math.sqrt(now)
            part = (math.sqrt(rise) - low) / max(high - low, 1e-12)
            return before + part * (at - before), lowest
        if at == limit:
            return None, lowest
        before, height, vector = at, max(now, 0.0), one.vector
        step *= 1.0 if now > 0.1 * rise else 1.6
    return None, lowest


def _freed(
    best: Minimum[AnyModel], fixed: Minimum[AnyModel], place: int, friction: float, rounds: int
) -> Minimum[AnyModel]:
    """The minimum from a point of the profile, with the friction free."""
    return least(best.model, np.insert(fixed.vector, place, friction), rounds)
