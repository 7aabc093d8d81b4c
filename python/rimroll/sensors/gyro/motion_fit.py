"""A whole motion fitted to the record of a gyroscope."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from rimroll import _core
from rimroll.bodies.body import Body
from rimroll.errors import RimrollError
from rimroll.laws import Coulomb, Frictionless, Law, NoSlip, one_law
from rimroll.sensors.fits import (
    BODY,
    START,
    Estimate,
    Minimum,
    chi_square,
    fitted_names,
    friction_interval,
    highest_friction,
    least,
)
from rimroll.sensors.gyro.analysis import Analysis
from rimroll.sensors.gyro.motion_model import (
    Model,
    Prior,
    Sensing,
    inflation_of,
    normal_residual,
    part_left,
    residuals_of,
)
from rimroll.sensors.gyro.motion_result import LawVerdict, MotionFit
from rimroll.sensors.gyro.motion_search import Chain, best_of_law, chains_of, window_of
from rimroll.sensors.gyro.passages import EXPECTED, SCALE_ERROR, across
from rimroll.sensors.gyro.reading import analyze
from rimroll.sensors.gyro.record import Record
from rimroll.state import State
from rimroll.theory.closed_forms import needed_friction
from rimroll.units import Number, number, whole_number


def notes_of(
    chains: Sequence[Chain],
    followed: list[int],
    sure: list[bool],
    interval: tuple[float, float | None] | None,
    told: bool,
    inflation: float,
) -> list[str]:
    """The sentences that apply; ``told``: whether the record limits the friction."""
    notes = []
    if not chains[0].collisions[0].released:
        notes.append(
            "No release was seen, so the fit assumes that the rim rests where the tilt is largest."
        )
    later = sum(len(one.collisions) for one in chains) - sum(followed)
    if later:
        notes.append(
            "Not followed: 1 later near-collision, which depends too much on small errors of what"
            " came before, or is beyond the number asked for."
            if later == 1
            else f"Not followed: {later} later near-collisions, which depend too much on small"
            " errors of what came before, or are beyond the number asked for."
        )
    if not all(sure):
        count = sum(not one for one in sure)
        notes.append(
            f"The side of {count} of {len(sure)} turns is not sure: a turn to the other side suits"
            " about as well."
        )
    if interval is not None and not told:
        notes.append("The record cannot tell the friction: nearly every friction suits it.")
    if inflation > 4.0:
        notes.append(
            "The residuals are larger than the sensor's errors explain, or hang together from"
            f" sample to sample, so all intervals are {math.sqrt(inflation):.1f} times wider. The"
            " body may not be round or not the one given, or the sensor may not be fixed."
        )
    return notes


Array = NDArray[np.float64]

PREDICTED = 0.1
"""A motion is followed on while what was fitted predicts the next rates to this part of them."""
WORSE = 2.0
"""And while the residuals become at most so many times larger."""
LARGEST_LEFT = 0.1
"""Residual over rate (root mean squares) from which on no law is said to describe the record."""
LEAST_TOLD = 0.9
"""The part of the frictions from 0 to what rolling needs that an interval may leave possible."""


def fit_motion(
    record: Record,
    body: Body,
    law: Law | None = None,
    *,
    axis: str = "auto",
    gravity: Number = _core.STANDARD_GRAVITY,
    confidence: Number = 0.95,
    body_error: Number = 0.01,
    fit: Sequence[str] | None = None,
    most_collisions: Number = 3,
) -> MotionFit:
    """Fit a whole motion to the record of a gyroscope inside a body.

    The start, the numbers of the law, the sensor's orientation, bias and sensitivity and the moment
    of the release follow together by least squares from the rates, sample by sample. The search
    begins on both sides of the turn, and at every friction. The samples beside a near-collision,
    which a sensor smears, are left out.

    A fit begins with a release and the first near-collision. It goes on to the next one as long as
    what has been fitted predicts the rates there to 10 %, and the residuals do not double: each
    near-collision makes small errors larger.

    Parameters
    ----------
    record, body, axis, gravity
        As for :func:`rimroll.gyro.analyze`.
    law
        How the rim meets the table; its numbers are those from which the search begins. By default
        ``Coulomb``. A resistance that is added to it is fitted, too.
    confidence
        The confidence level of intervals and verdicts.
    body_error
        Standard deviation of the radius, the height and the two moments of inertia of the body,
        relative to each; 0 if they are exact.
    fit
        Which numbers of the law are fitted, as ``law.numbers`` names them. By default all that are
        not zero, but for exponents and a restitution.
    most_collisions
        How many near-collisions after each release may be fitted.

    Returns
    -------
    MotionFit

    Raises
    ------
    RimrollError
        What :func:`rimroll.gyro.analyze` refuses, and a record that no motion under the law
        describes.

    Examples
    --------
    >>> import rimroll as rr
    >>> can = rr.bodies.can_2007()
    >>> motion = rr.simulate(can, rr.State(tilt=0.5, yaw_rate=0.1), rr.Coulomb(0.2), duration=0.8)
    >>> fit = rr.fit_motion(rr.gyro.phone().record(motion), can)
    >>> low, high = fit.friction.interval
    >>> low < 0.2 < high
    True
    """
    found = analyze(record, body, axis=axis, gravity=gravity, confidence=confidence)
    return fit_analysis(found, law, body_error=body_error, fit=fit, most_collisions=most_collisions)


def fit_analysis(
    found: Analysis,
    law: Law | None = None,
    *,
    body_error: Number = 0.01,
    fit: Sequence[str] | None = None,
    most_collisions: Number = 3,
) -> MotionFit:
    """What :func:`fit_motion` finds, from a record that has been read; arguments are its own."""
    needed = float(needed_friction(found.body))
    given = Coulomb(0.5 * needed or 0.2) if law is None else one_law(law)
    free = fitted_names(given, fit)
    deviation = number("body_error", body_error)
    if not 0.0 <= deviation <= 0.2:
        raise RimrollError(field="body_error", value=deviation, bound="from 0 to 0.2")
    most = whole_number("most_collisions", most_collisions)
    chains = chains_of(found)
    first = _model(found, chains, [1] * len(chains), given, free, deviation)
    begun, excess = best_of_law(first, found, chains)
    ideal = _ideal(begun, found, chains)
    begun, excess = _from_ideal(begun, excess, ideal)
    best, followed = _followed(begun, found, chains, most)
    left = part_left(best)
    if not left <= LARGEST_LEFT:
        fault = f"leaves {100.0 * left:.0f} % of the rates"
        if math.isnan(left):
            fault = "ends before the record of it does"
        raise RimrollError(
            f"{found.record.name}: no motion under {given!r} describes it: the best one {fault}."
            " Check the body, whether the sensor is fixed in it, and the law"
        )
    return _result(best, begun, ideal, found, chains, followed, excess)


def _model(
    found: Analysis,
    chains: Sequence[Chain],
    counts: Sequence[int],
    law: Law,
    free: Sequence[str],
    body_error: float,
) -> Model:
    direction = found.axis.direction
    u, v = across(direction)
    expected = np.eye(3)[int(np.argmax(np.abs(direction)))]
    expected = expected * np.sign(expected @ direction)
    sensor = np.array([-(v @ expected), u @ expected, *([0.0] * 6)])
    errors = [EXPECTED, EXPECTED, *([found.rests.bias_error] * 3), *([SCALE_ERROR] * 3)]
    prior = Prior(
        np.concatenate([sensor, np.zeros(len(BODY))]),
        np.array([*errors, *([max(body_error, 1e-9)] * len(BODY))]),
        1.5 * found.record.step,
    )
    windows = [window_of(found, one, n) for one, n in zip(chains, counts, strict=True)]
    sensing = Sensing(np.stack([u, v, direction], axis=-1))
    return Model(found.body, law, tuple(free), found.gravity, sensing, windows, prior)


def _followed(
    best: Minimum[Model], found: Analysis, chains: Sequence[Chain], most: int
) -> tuple[Minimum[Model], list[int]]:
    """The fit extended to later near-collisions while they can be predicted."""
    counts = [1] * len(chains)
    for k, chain in enumerate(chains):
        while counts[k] < min(most, len(chain.collisions)):
            longer = window_of(found, chain, counts[k] + 1)
            windows = list(best.model.windows)
            windows[k] = longer
            model = replace(best.model, windows=windows)
            if not _is_predicted(model, best, k):
                break
            trial = least(model, best.vector)
            if not normal_residual(trial) <= WORSE * max(normal_residual(best), 1.0):
                break  # worse, or the motion ends too early
            best, counts[k] = trial, counts[k] + 1
    return best, counts


def _is_predicted(model: Model, best: Minimum[Model], k: int) -> bool:
    """Whether the numbers fitted so far predict the later part of a window."""
    window = model.windows[k]
    later = window.t > best.model.windows[k].t[-1]
    alone = np.concatenate([best.vector[: model.place(0).start], best.vector[model.place(k)]])
    only = replace(model, windows=[window])
    rows = only.jacobian(alone)[: 3 * len(window.t)].reshape(len(window.t), 3, -1)[later]
    some = [*range(model.place(0).start), *range(model.place(k).start, model.place(k).stop)]
    covariance = best.covariance[np.ix_(some, some)] * inflation_of(best)
    variance = np.einsum("nik,kl,nil->ni", rows, covariance, rows) * window.scatter[later] ** 2
    spread = math.sqrt(float(np.mean(variance)))
    return spread < PREDICTED * math.sqrt(float(np.mean(window.rates[later] ** 2)))


def _result(
    best: Minimum[Model],
    begun: Minimum[Model],
    ideal: Sequence[tuple[Law, Minimum[Model] | None, list[float]]],
    found: Analysis,
    chains: Sequence[Chain],
    followed: list[int],
    excess: list[float],
) -> MotionFit:
    level = chi_square(found.confidence)
    inflation = inflation_of(best)
    rise = level * inflation
    highest = highest_friction(found.body)
    interval: tuple[float, float | None] | None = None
    if "friction" in best.model.free:
        low, high, lower = friction_interval(best, rise, highest)
        if lower is not best:  # a lower minimum on the way
            best = lower
            low, high, _ = friction_interval(best, rise, highest)
        interval = (low, high)
    verdicts = _verdicts(begun, ideal, level)
    numbers = _estimates(best, inflation, level, interval)
    told = interval is not None and _is_told(interval, float(needed_friction(found.body)))
    residuals, scatter = residuals_of(best)
    windows = best.model.windows
    places = [best.vector[best.model.place(k)] for k in range(len(windows))]
    starts = [
        State(**dict(zip(START, map(float, one), strict=False)), spin=float(one[4]))
        for one in places
    ]
    releases = [w.release + float(one[5]) for w, one in zip(windows, places, strict=True)]
    sure = [one > level * inflation_of(begun) for one in excess]
    return MotionFit(
        found, best.model.law_at(best.vector), starts, releases, numbers,
        best.model.free, followed,
        np.concatenate([window.t for window in windows]),
        np.concatenate([window.rates for window in windows]) - residuals,
        residuals, scatter, inflation, sure, verdicts, told,
        notes_of(chains, followed, sure, interval, told, inflation),
    )  # fmt: skip


def _is_told(interval: tuple[float, float | None], needed: float) -> bool:
    """Whether an interval leaves out a tenth, at least, of the frictions that matter."""
    if needed == 0.0:
        return False
    high = needed if interval[1] is None else min(interval[1], needed)
    return high - interval[0] < LEAST_TOLD * needed


def _ideal(
    begun: Minimum[Model], found: Analysis, chains: Sequence[Chain]
) -> list[tuple[Law, Minimum[Model] | None, list[float]]]:
    """The two ideal laws over the same samples, each with resistances of its own fitted."""
    out: list[tuple[Law, Minimum[Model] | None, list[float]]] = []
    for kind in (NoSlip, Frictionless):
        law: Law = kind(resistances=begun.model.law_at(begun.vector).resistances)
        free = tuple(name for name in begun.model.free if name in law.numbers)
        try:
            model = replace(begun.model, law=law, free=free)
            one, excess = best_of_law(model, found, chains, begun)
            out.append((one.model.law_at(one.vector), one, excess))
        except RimrollError:  # no motion under this law begins so
            out.append((law, None, []))
    return out


def _from_ideal(
    begun: Minimum[Model],
    excess: list[float],
    ideal: Sequence[tuple[Law, Minimum[Model] | None, list[float]]],
) -> tuple[Minimum[Model], list[float]]:
    """A better minimum near that of an ideal law, which dry friction contains, if there is one."""
    if type(begun.model.law) is not Coulomb or "friction" not in begun.model.free:
        return begun, excess
    place = begun.model.free.index("friction")
    for (_, one, its_excess), friction in zip(
        ideal, (highest_friction(begun.model.body), 0.0), strict=True
    ):
        if one is not None and one.squares < begun.squares:
            nested = least(begun.model, np.insert(one.vector, place, friction))
            if nested.squares < begun.squares:
                begun, excess = nested, its_excess
    return begun, excess


def _verdicts(
    begun: Minimum[Model],
    ideal: Sequence[tuple[Law, Minimum[Model] | None, list[float]]],
    level: float,
) -> list[LawVerdict]:
    """The fitted law and the two ideal ones, compared over the first near-collisions."""
    inflation = inflation_of(begun)
    compared = [(begun.model.law_at(begun.vector), begun.squares)]
    compared += [(law, math.inf if one is None else one.squares) for law, one, _ in ideal]
    least_squares = min(squares for _, squares in compared)
    return [
        LawVerdict(law, excess, excess > level)
        for law, squares in compared
        for excess in [(squares - least_squares) / inflation]
    ]


def _estimates(
    best: Minimum[Model],
    inflation: float,
    level: float,
    interval: tuple[float, float | None] | None,
) -> dict[str, Estimate]:
    errors = np.sqrt(np.diag(best.covariance) * inflation)
    out = {}
    for i, name in enumerate(best.model.names):
        value, error = float(best.vector[i]), float(errors[i])
        half = math.sqrt(level) * error
        least = 0.0 if name in best.model.free else -math.inf  # numbers of laws are not negative
        interval_of = (max(value - half, least), value + half)
        out[name] = Estimate(value, error, interval_of, "covariance")
    if interval is not None:
        there = out["friction"]
        out["friction"] = Estimate(there.value, there.error, interval, "profile")
    return out
