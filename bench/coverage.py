"""Do the intervals of `rimroll.fit` have their nominal coverage?

Falls are simulated with a known friction, a known scatter and bias of the hand and a reading error,
and fitted. The script counts how often the true friction and bias lie inside their intervals. Run:

    .venv/bin/python bench/coverage.py [--experiments 1000]
"""

from __future__ import annotations

import argparse
import math
from dataclasses import dataclass

import numpy as np

import rimroll as rr
from rimroll.experiment.fitting.likelihood import Likelihood
from rimroll.experiment.fitting.predicted import Predicted

READING_ERROR = math.radians(2.0)
CONFIDENCES = (0.68, 0.95)


@dataclass
class Count:
    """Numbers of experiments whose intervals contain the true value."""

    friction: int = 0
    bias: int = 0
    of: int = 0

    def __str__(self) -> str:
        def share(held: int) -> str:
            part = held / self.of
            error = math.sqrt(max(part * (1.0 - part), 0.25 / self.of) / self.of)
            return f"{100 * part:.1f} ± {100 * error:.1f} %"

        return f"friction {share(self.friction)}, bias {share(self.bias)}"


def experiment(
    predicted: Predicted, friction: float, n: int, rng: np.random.Generator
) -> tuple[float, np.ndarray]:
    """A bias (rad) and the directions read in an experiment of n falls."""
    bias = math.radians(2.0) * rng.standard_normal()
    falls = rr.topple(
        predicted.body,
        rr.Coulomb(friction),
        2 * n,
        predicted.release,
        seed=int(rng.integers(2**31)),
        gravity=predicted.gravity,
    )
    fell = falls["direction"].values[falls["outcome"].values == predicted.outcome][:n]
    return bias, fell + bias + predicted.reading_error * rng.standard_normal(len(fell))


def covered(
    predicted: Predicted,
    frictions: list[float],
    n: int,
    experiments: int,
    confidences: tuple[float, ...],
) -> list[Count]:
    """How often the truth lies in the intervals of each confidence, over all frictions."""
    rng = np.random.default_rng(n)
    counts = [Count() for _ in confidences]
    for i in range(experiments):
        friction = frictions[i % len(frictions)]
        bias, directions = experiment(predicted, friction, n, rng)
        likelihood = Likelihood(predicted, directions)
        best = likelihood.best()
        of_friction = likelihood.worse(likelihood.best(friction=friction), best)
        of_bias = likelihood.worse(likelihood.best(bias=bias), best)
        for count, confidence in zip(counts, confidences, strict=True):
            most = likelihood.most(confidence)
            count.friction += of_friction <= most
            count.bias += of_bias <= most
            count.of += 1
    return counts


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--experiments", type=int, default=1000)
    experiments = parser.parse_args().experiments
    can = rr.bodies.can_2007()
    predicted = rr.predict_falls(can, "paper", reading_error=READING_ERROR)
    for n in (12, 42, 150):
        counts = covered(predicted, [0.02, 0.08, 0.15, 0.22, 0.3], n, experiments, CONFIDENCES)
        for confidence, count in zip(CONFIDENCES, counts, strict=True):
            print(f"{n} falls, {100 * confidence:.0f} %: {count}")


if __name__ == "__main__":
    main()
