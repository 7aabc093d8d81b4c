"""Whether directions of fall exclude a hypothesis, in a sentence."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from rimroll.experiment.fitting.likelihood import Likelihood, Point
from rimroll.experiment.fitting.predicted import ANGLES, STRAY, TURN
from rimroll.experiment.fitting.shape import Hump, chance_of_uniform

Array = NDArray[np.float64]

MUCH_BETTER = 3.0
"""Gain of log likelihood that counts as evidence for another shape: odds of twenty to one."""

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
    name = "two humps as friction makes them"
    data = likelihood.directions
    grid = np.linspace(0.0, TURN, ANGLES + 1)
    density = likelihood.density(grid, best)
    steps = 0.5 * (density[1:] + density[:-1]) * (TURN / ANGLES)
    total = np.concatenate([[0.0], np.cumsum(steps)])
    chance = chance_of_uniform(np.interp(data, grid, total / total[-1]))
    hump = Hump.of(data)
    one_hump = (1.0 - STRAY) * hump.density(data) + STRAY / TURN
    gain = float(np.log(one_hump).sum()) - best.log_likelihood
    about = f"one hump about {math.degrees(hump.middle) % 360.0:.0f} degrees describes the falls"
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
