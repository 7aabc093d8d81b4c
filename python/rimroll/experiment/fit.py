"""The friction of a table, the bias of a hand, and the laws that directions of fall exclude."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field, replace
from html import escape
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rimroll import _core
from rimroll.bodies.body import Body, one_body
from rimroll.errors import RimrollError, callback, expect
from rimroll.experiment.likelihood import (
    MAX_BIAS,
    MAX_LOGIT,
    MIN_OF_A_SIDE,
    Estimate,
    Interval,
    Likelihood,
    Point,
    estimate,
)
from rimroll.experiment.predicted import (
    ANGLES,
    READING_ERROR,
    STRAY,
    TURN,
    Predicted,
    predict_falls,
)
from rimroll.experiment.release import Release
from rimroll.laws import Coulomb
from rimroll.many.left_or_right import around, middle_of
from rimroll.units import Number, Values, number, without_unit

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure


Array = NDArray[np.float64]

MUCH_BETTER = 3.0
"""Gain of log likelihood that counts as evidence for another shape: odds of twenty to one."""

NARROWEST = 1e12
"""The largest concentration of one hump: all of its directions are the same."""

SIMPLER = 2.0
"""Gain of log likelihood that justifies two more parameters (Akaike)."""


@dataclass(frozen=True)
class Verdict:
    """Whether the data exclude a hypothesis.

    ``chance`` is that of data as far from it, or farther, if it is true; None where the verdict is
    not a test.
    """

    hypothesis: str
    excluded: bool
    chance: float | None
    sentence: str


def of_hypothesis(
    likelihood: Likelihood, name: str, point: Point, best: Point, confidence: float
) -> Verdict:
    """The verdict by the loss of likelihood under the hypothesis."""
    chance = likelihood.chance(likelihood.worse(point, best))
    excluded = chance < 1.0 - confidence
    word = "excluded" if excluded else "possible"
    return Verdict(name, excluded, chance, f"{name}: {word} ({in_words(chance)})")


def of_shape(likelihood: Likelihood, best: Point, confidence: float) -> Verdict:
    """Whether two humps, at any directions, describe the data.

    By Cramér and von Mises' test of the fitted distribution, which errs on the side of letting it
    pass since it was fitted; and against one hump, a von Mises distribution.
    """
    from scipy import stats

    name = "two humps as friction makes them"
    data = likelihood.directions
    grid = np.linspace(0.0, TURN, ANGLES + 1)
    density = likelihood.density(grid, best)
    steps = 0.5 * (density[1:] + density[:-1]) * (TURN / ANGLES)
    total = np.concatenate([[0.0], np.cumsum(steps)])
    chance = float(stats.cramervonmises(np.interp(data, grid, total / total[-1]), "uniform").pvalue)
    concentration, middle, _ = stats.vonmises.fit(data, fscale=1.0)
    density = stats.vonmises.pdf(data, min(concentration, NARROWEST), middle)
    one_hump = (1.0 - STRAY) * density + STRAY / TURN
    gain = float(np.log(one_hump).sum()) - best.log_likelihood
    about = f"one hump about {math.degrees(middle) % 360.0:.0f} degrees describes the falls"
    if gain > MUCH_BETTER:
        better = f"excluded; {about} better (log likelihood {gain:.1f} higher)"
        return Verdict(name, True, None, f"{name}: {better}")
    excluded = chance < 1.0 - confidence
    if excluded:
        sentence = f"{name}: excluded, the falls have another shape ({in_words(chance)})"
    elif gain > -SIMPLER and likelihood.has_both_sides:
        sentence = f"{name}: describe the falls, but {about} as well; take the friction with care"
    else:
        sentence = f"{name}: the falls have that shape ({in_words(chance)})"
    return Verdict(name, excluded, chance, sentence)


def in_words(chance: float) -> str:
    """A probability as ``p = 0.03``, with its significant digits only."""
    if chance < 1e-4:
        return "p < 0.0001"
    return "p > 0.99" if chance > 0.99 else f"p = {chance:.2g}"


MIN_FALLS = 8
"""The smallest number of falls for a fit."""

MIN_SIMULATED, MAX_SIMULATED = 1024, 16384
"""Bounds of the number of falls simulated at each friction, several times those measured."""


@dataclass(frozen=True, eq=False)
class Fit:
    """The result of a fit: what directions of fall say about the table and the hand.

    Attributes
    ----------
    friction
        The coefficient of dry friction, an :class:`Estimate`.
    bias
        The angle by which all directions are turned anticlockwise, rad.
    bias_interval
        The interval of biases that are not excluded, rad; None if the bias was given.
    unsteadiness
        Fitted factor on the spreads of the release's ``sideways`` and ``twist``.
    left_share
        The probability of a fall to the left.
    left, right
        The estimate from the falls to one side alone, without a bias; None if there are too few.
    at_other_tilt_rates
        Pairs (tilt rate in rad/s, friction) for a mean tilt rate that is off by its error; empty
        if that error is 0.
    verdicts
        The verdicts on all hypotheses, including ``shape``.
    shape
        The verdict on whether the data have the shape that friction gives.
    at_bounds
        The parameters, ``bias`` or ``unsteadiness``, whose best value is at an end of the range
        that is tried, with that end, ``lowest`` or ``highest``. A better value may lie beyond.
    warnings
        Doubts and assumptions, in sentences.
    confidence
        Confidence level of the intervals and verdicts.
    directions, predicted
        The data (n,), rad, and the predictions that they were compared with.
    """

    friction: Estimate
    bias: float
    bias_interval: Interval | None
    unsteadiness: float
    left_share: float
    left: Estimate | None
    right: Estimate | None
    at_other_tilt_rates: tuple[tuple[float, float], ...]
    verdicts: tuple[Verdict, ...]
    shape: Verdict
    at_bounds: dict[str, str]
    warnings: tuple[str, ...]
    confidence: float
    directions: Array = field(repr=False)
    predicted: Predicted = field(repr=False)
    best: Point = field(repr=False)

    @property
    def supported(self) -> bool:
        """Whether the falls have the shape that friction gives; if not, the fit means nothing."""
        return not self.shape.excluded

    @property
    def strays(self) -> NDArray[np.bool_]:
        """Which of the directions (n,) are far from both humps: probably writing errors."""
        return Likelihood(self.predicted, self.directions).strays(self.best)

    def density(self, angles: ArrayLike) -> Array:
        """The fitted density of a direction, per rad, at angles (rad)."""
        return Likelihood(self.predicted, self.directions).density(
            np.asarray(angles, np.float64), self.best
        )

    def _repr_html_(self) -> str:
        """The view in notebooks."""
        from rimroll.figures.notebook import degrees, sentences, table, view

        rows = [("friction", str(self.friction))]
        sides = {"left": self.left, "right": self.right}
        for name, side in sides.items():
            if side is not None:
                rows.append((f"from falls to the {name}", str(side)))
        bias = degrees(self.bias, 1)
        if self.bias_interval is not None:
            low, high = self.bias_interval
            bias += f" ({degrees(low, 1)} to {degrees(high, 1)})"
        rows += [("bias", bias), ("unsteadiness", f"{self.unsteadiness:.2f}")]
        doubts = f"<p>{escape(' '.join(self.warnings))}</p>" if self.warnings else ""
        verdicts = sentences(verdict.sentence for verdict in self.verdicts)
        return view(f"Fit to {len(self.directions)} falls", table(rows), verdicts, doubts)

    def plot(self) -> Figure:
        """The predicted histogram over the measured one, and how well each friction fits."""

        return fit_figure(self)

    def to_dict(self) -> dict[str, Any]:
        """Numbers and sentences, in SI units and radians."""
        return {
            "falls": len(self.directions),
            "strays": self.directions[self.strays].tolist(),
            "confidence": self.confidence,
            "supported": self.supported,
            "at_bounds": self.at_bounds,
            "friction": self.friction.friction,
            "friction_intervals": self.friction.intervals,
            "holding_friction": self.friction.holding_friction,
            "bias": self.bias,
            "bias_interval": self.bias_interval,
            "unsteadiness": self.unsteadiness,
            "left_share": self.left_share,
            **{
                f"{name}_alone": side and {"friction": side.friction, "intervals": side.intervals}
                for name, side in (("left", self.left), ("right", self.right))
            },
            "at_other_tilt_rates": self.at_other_tilt_rates,
            "warnings": self.warnings,
            "verdicts": [vars(verdict) for verdict in self.verdicts],
        }


def fit(
    body: Body,
    directions: Values,
    release: Release | str = "flick",
    *,
    gravity: Number = _core.STANDARD_GRAVITY,
    reading_error: Number = READING_ERROR,
    tilt_rate_error: Number | None = None,
    bias: Number | None = None,
    outcome: str | None = None,
    confidence: float = 0.95,
    predicted: Predicted | None = None,
    threads: int | None = None,
    progress: Callable[[int, int], object] | None = None,
) -> Fit:
    """Estimate the friction of a table from directions in which a body fell.

    Falls are simulated at many frictions with the scatter of the release and hands of different
    unsteadiness. The estimate maximises the likelihood of the directions (see
    :mod:`rimroll.experiment.likelihood`).

    With fewer than 3 falls to one side, bias and friction cannot be distinguished, and the bias is
    assumed to be 0.

    Raises ``RimrollError`` for too few falls and numbers outside their bounds.

    Parameters
    ----------
    body
        What was flicked.
    directions
        Directions of fall (n,), rad, counted anticlockwise from the direction of the first lean; at
        least 8. :func:`rimroll.read_directions` reads them from a file.
    release, gravity
        The release, see :func:`rimroll.topple`, and gravity, m/s². Tilt and tilt rate matter,
        since a rim may slide before the base arrives.
    reading_error
        Standard deviation of reading a direction, rad.
    tilt_rate_error
        Uncertainty of the mean tilt rate of the release, rad/s: the friction is also estimated for
        flicks that much slower and faster. By default a tenth of the rate; 0 leaves this out.
    bias
        Rotation of all directions, rad; by default fitted.
    outcome
        The outcome that counts as a fall, see :func:`rimroll.predict_falls`.
    confidence
        Confidence level of intervals and verdicts.
    predicted
        A result of :func:`rimroll.predict_falls` to use again; its release, gravity and reading
        error then apply.
    threads, progress
        As for :func:`rimroll.predict_falls`.
    """
    one_body(body)
    data = _checked(directions)
    expect("predicted", predicted, Predicted | None)
    callback("progress", progress)
    confidence = number("confidence", confidence)
    if not 0.5 <= confidence <= 0.9999:
        raise RimrollError(field="confidence", value=confidence, bound="between 0.5 and 0.9999")
    if bias is not None:
        bias = number("bias", bias, "rad")
        if not abs(bias) <= TURN:
            raise RimrollError(field="bias", value=bias, bound="between -2 pi and 2 pi", unit="rad")
    others: list[Predicted] = []
    if predicted is None:
        releases = _releases(body, release, gravity, tilt_rate_error)
        tables = _predictions(
            releases,
            progress,
            len(data),
            body=body,
            gravity=gravity,
            reading_error=reading_error,
            outcome=outcome,
            threads=threads,
        )
        predicted, *others = tables
    elif predicted.body != body:
        raise RimrollError("predicted was computed for another body")
    lefts, rights = data[data > math.pi], data[data <= math.pi]
    likelihood = Likelihood(predicted, data)
    assumed = bias is None and not likelihood.has_both_sides
    if assumed:
        bias = 0.0
    fixed = {} if bias is None else {"bias": bias}
    friction, best = estimate(likelihood, confidence, fixed)
    at_bounds = _at_bounds(likelihood, best, fixed)
    shape = of_shape(likelihood, best, confidence)
    return Fit(
        friction=friction,
        bias=best.bias,
        bias_interval=_bias_interval(likelihood, best, confidence) if bias is None else None,
        unsteadiness=best.unsteadiness,
        left_share=best.left_share,
        left=_alone(predicted, lefts, confidence, +1.0),
        right=_alone(predicted, rights, confidence, -1.0),
        at_other_tilt_rates=tuple(
            (other.release.tilt_rate[0], Likelihood(other, data).best(**fixed).friction)
            for other in others
        ),
        at_bounds=at_bounds,
        warnings=tuple(_warnings(likelihood, best, at_bounds, assumed)),
        verdicts=(*_hypotheses(likelihood, best, confidence, fixed), shape),
        shape=shape,
        confidence=confidence,
        directions=data,
        predicted=predicted,
        best=best,
    )


def _releases(
    body: Body, release: Release | str, gravity: Number, error: Number | None
) -> list[Release | str]:
    """The release, and two copies with its tilt rate off by its error, up and down."""
    named = Release.named(release, body, gravity) if isinstance(release, str) else release
    if not isinstance(named, Release):
        return [release]  # for the prediction to refuse
    rate, spread = named.tilt_rate
    if error is None:
        error = 0.1 * abs(rate)
    error = number("tilt_rate_error", error, "rad/s")
    if not 0.0 <= error < math.inf:
        raise RimrollError(
            field="tilt_rate_error", value=error, bound="finite and >= 0", unit="rad/s"
        )
    offs = (error, -error) if error > 0.0 else ()
    return [named, *(replace(named, tilt_rate=(rate + off, spread)) for off in offs)]


def _predictions(
    releases: list[Release | str],
    progress: Callable[[int, int], object] | None,
    count: int,
    **options: Any,
) -> list[Predicted]:
    """Predictions, with fewer falls for all but the first release."""
    whole = min(max(MIN_SIMULATED, 4 * count), MAX_SIMULATED)
    sizes = [whole, *(whole // 4 for _ in releases[1:])]
    done = 0

    def report(part: int, parts: int) -> None:
        if progress is not None:
            progress(done + part * falls, parts * sum(sizes))

    tables = []
    for release, falls in zip(releases, sizes, strict=True):
        table = predict_falls(release=release, falls=falls, progress=report, **options)
        done += falls * len(table.frictions)
        tables.append(table)
    return tables


def _at_bounds(likelihood: Likelihood, best: Point, fixed: dict[str, float]) -> dict[str, str]:
    """The parameters at an end of the range that is tried, and which end."""
    hands = likelihood.predicted.unsteadiness
    found = {}
    if "bias" not in fixed and abs(best.bias) > 0.99 * MAX_BIAS:
        found["bias"] = "highest" if best.bias > 0.0 else "lowest"
    if len(hands) > 1 and best.unsteadiness > 0.99 * hands[-1]:
        found["unsteadiness"] = "highest"
    if len(hands) > 1 and best.unsteadiness < 1.01 * hands[0]:
        found["unsteadiness"] = "lowest"
    return found


def _warnings(
    likelihood: Likelihood, best: Point, at_bounds: dict[str, str], assumed: bool
) -> Iterator[str]:
    """Warnings about parameters at the ends of their ranges, and about stray readings."""
    if assumed:
        yield "too few falls to one side to distinguish a bias from friction: no bias was assumed"
    if "bias" in at_bounds:
        yield (
            f"the bias is at the end of what is tried, {math.degrees(best.bias):.0f} degrees: are "
            f"the angles counted anticlockwise from the direction of the first lean, of this body?"
        )
    if at_bounds.get("unsteadiness") == "highest":
        yield (
            "the falls scatter more than the unsteadiest hand that is tried: is it the right body "
            "and release, or is the error of reading larger?"
        )
    if at_bounds.get("unsteadiness") == "lowest":
        yield (
            "the falls scatter less than the steadiest hand that is tried: is the error of reading "
            "smaller, or are some of the angles copies of others?"
        )
    strays = np.degrees(likelihood.directions[likelihood.strays(best)])
    if strays.size:
        angles = ", ".join(f"{angle:.0f}" for angle in strays[:5])
        more = " and more" if strays.size > 5 else ""
        yield f"far from both humps, and taken for writing errors: {angles}{more} degrees"


def _alone(
    predicted: Predicted, directions: Array, confidence: float, side: float
) -> Estimate | None:
    """The estimate from the falls to one side (+1: left), without a bias."""
    if len(directions) < MIN_OF_A_SIDE:
        return None
    likelihood = Likelihood(predicted, directions)
    return estimate(likelihood, confidence, {"bias": 0.0, "logit": side * MAX_LOGIT})[0]


def _bias_interval(likelihood: Likelihood, best: Point, confidence: float) -> Interval:
    from scipy.optimize import brentq

    limit = likelihood.most(confidence)

    def beyond(bias: float) -> float:
        return likelihood.beyond(likelihood.best(best, bias=bias), best, limit)

    def end(sign: float) -> float:
        step, inside = math.radians(1.0), best.bias
        while abs(inside) < MAX_BIAS:
            outside = min(max(best.bias + sign * step, -MAX_BIAS), MAX_BIAS)
            if beyond(outside) > 0.0:
                return float(brentq(beyond, inside, outside, xtol=1e-5))
            inside, step = outside, 2.0 * step
        return inside

    return end(-1.0), end(1.0)


def _hypotheses(
    likelihood: Likelihood, best: Point, confidence: float, fixed: dict[str, float]
) -> list[Verdict]:
    low, high = likelihood.predicted.frictions[[0, -1]].tolist()
    found = [
        of_hypothesis(
            likelihood, name, likelihood.best(best, **fixed, friction=friction), best, confidence
        )
        for name, friction in (("rolling without slip", high), ("sliding without friction", low))
    ]
    if "bias" not in fixed:
        name = "one friction for both sides, without a bias"
        unbiased = likelihood.best(best, bias=0.0)
        found.append(of_hypothesis(likelihood, name, unbiased, best, confidence))
    return found


def _checked(directions: Values) -> Array:
    bare = without_unit("directions", directions, "rad")
    try:
        data = np.asarray(bare)
    except ValueError:
        raise RimrollError(
            "must be a flat array of angles, got a ragged one", "directions"
        ) from None
    if data.ndim != 1 or (data.size and data.dtype.kind not in "iuf"):
        raise RimrollError(
            f"must be a flat array of angles, got shape {data.shape} of {data.dtype}", "directions"
        )
    if len(data) < MIN_FALLS:
        raise RimrollError(
            f"a fit needs at least {MIN_FALLS} falls, got {len(data)}: from fewer, friction and "
            f"scatter cannot be told apart"
        )
    bad = data[~(np.abs(data) <= 2.0 * TURN)]
    if bad.size:
        degrees = ": degrees are turned into them by numpy.radians"
        raise RimrollError(
            field="directions",
            value=bad[0],
            bound="radians between -4 pi and 4 pi",
            hint=degrees if np.isfinite(bad[0]) else "",
        )
    return np.asarray(np.mod(data.astype(np.float64), TURN))


FITTED = Coulomb.color
MAX_SHOWN = 16.0
"""Larger deviances all mean impossible."""


def fit_figure(fit: Fit) -> Figure:
    """Draw (a) directions of fall, counted and predicted, (b) the deviance of each friction.

    No slip and no friction are drawn for the hand and the bias that were found.
    """
    from rimroll.figures import style

    with style.figure_style():
        figure = style.page(62.0)
        falls, friction = figure.subplots(1, 2, width_ratios=(1.5, 1.0))
        _draw_falls(falls, fit)
        _draw_friction(friction, fit)
        return style.settle(figure)


def _draw_falls(ax: Axes, fit: Fit) -> None:
    from matplotlib.ticker import MaxNLocator

    from rimroll.figures import style
    from rimroll.figures.style import directions_in_degrees

    likelihood = Likelihood(fit.predicted, fit.directions)
    middle = middle_of(np.degrees(fit.directions))
    data = around(middle, np.degrees(fit.directions))
    reach = 10.0 * math.ceil(min(max(float(np.abs(data - middle).max()) + 12.0, 50.0), 180.0) / 10)
    width = 2.0 if len(data) >= 30 else 4.0
    bins = np.arange(middle - reach, middle + reach + width, width)
    ax.hist(data, bins.tolist(), color=style.CONTRAST, alpha=0.45, label="measured")
    angles = np.linspace(middle - reach, middle + reach, 600)
    expected = math.radians(width) * len(data)
    low, high = fit.predicted.frictions[[0, -1]].tolist()
    shown = (
        (replace(fit.best, friction=high), style.NO_SLIP, (0, (5, 2)), "no slip"),
        (replace(fit.best, friction=low), style.FRICTIONLESS, (0, (1, 1.2)), "no friction"),
        (fit.best, FITTED, "-", f"friction {fit.friction.friction:.3f}"),
    )
    for point, color, dashes, name in shown:
        curve = expected * likelihood.density(np.radians(angles), point)
        thick = 1.8 if point is fit.best else 1.0
        ax.plot(angles, curve, color=color, ls=dashes, lw=thick, label=name)
    ax.axvline(middle, color=style.THEORY, lw=0.5, ls=(0, (1, 3)))
    # Falls to the left of the hand are on the left. Angles grow to the left, except for falls back.
    ax.set_xlim(*((angles[-1], angles[0]) if middle else (angles[0], angles[-1])))
    directions_in_degrees(ax.xaxis, reach)
    ax.margins(y=0.12)
    ax.yaxis.set_major_locator(MaxNLocator(6, integer=True))
    for x, side in ((0.01, "left"), (0.99, "right")):
        ax.text(x, 0.98, f"to the {side}", transform=ax.transAxes, ha=side, va="top", fontsize=6.5)
    ax.legend(loc="upper center", ncols=4, bbox_to_anchor=(0.5, -0.2), columnspacing=1.2)
    what = "fall" if fit.predicted.outcome == "toppled" else "largest tilt"
    style.label(
        ax,
        "a",
        f"{len(data)} falls",
        f"direction of {what} (degrees)",
        f"falls (per {width:g}°)",
    )


def _draw_friction(ax: Axes, fit: Fit) -> None:
    from rimroll.figures import style

    one, most = fit.friction, fit.friction.holding_friction
    for low, high in one.intervals:
        ax.axvspan(low, high, color=FITTED, alpha=0.18, lw=0)
    _curve(ax, one, FITTED, "-", "all falls")
    for side, dashes, name in (
        (fit.left, (0, (4, 2)), "left"),
        (fit.right, (0, (1, 1.2)), "right"),
    ):
        if side is not None:
            _curve(ax, side, style.THEORY, dashes, f"{name} alone, no bias")
    ax.axhline(one.limit, color=style.THEORY, lw=0.5)
    ax.annotate(
        f"excluded at {100.0 * fit.confidence:g} % above",
        (most, one.limit),
        xytext=(-2, 2),
        textcoords="offset points",
        ha="right",
        fontsize=6.5,
    )
    ax.set_xlim(0.0, most)
    ax.set_ylim(0.0, MAX_SHOWN)
    ax.legend(loc="upper center", ncols=3, bbox_to_anchor=(0.5, -0.2), columnspacing=1.0)
    title = f"friction {one.friction:.3f}"
    if len(one.intervals) == 1:
        title += f": {one.in_words}"
    style.label(ax, "b", title, "coefficient of friction", "how badly it suits (deviance)")


def _curve(ax: Axes, estimate: Estimate, color: str, dashes: Any, name: str) -> None:
    from scipy.interpolate import PchipInterpolator

    fine = np.linspace(estimate.frictions[0], estimate.frictions[-1], 400)
    fine = np.union1d(fine, estimate.frictions)
    deviance = PchipInterpolator(estimate.frictions, estimate.deviance)(fine)
    thick = 1.8 if dashes == "-" else 1.0
    ax.plot(fine, deviance, color=color, ls=dashes, lw=thick, label=name)
