"""Studies of fits: simulated experiments whose friction is known, fitted as a user would."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from rimroll.body import Body
from rimroll.errors import RimrollError
from rimroll.experiment.fitting.likelihood import Likelihood
from rimroll.experiment.fitting.predicted import Predicted, predict_falls
from rimroll.experiment.normal import quantiles
from rimroll.experiment.release import Release
from rimroll.experiment.toppling import FALLING
from rimroll.laws import Coulomb
from rimroll.many_falls import follow
from rimroll.options import Options
from rimroll.study.cases import Call
from rimroll.study.draws import stream
from rimroll.study.kinds.kind import Result
from rimroll.study.plan import Progress

SURPLUS = 2
"""Releases for each fall that is wanted, since some bodies do not topple."""

RESULTS = {
    "friction": Result("float64", "", "fitted friction"),
    "bias": Result("float64", "rad", "fitted bias of the directions"),
    "unsteadiness": Result("float64", "", "fitted unsteadiness of the hand"),
    "friction_chance": Result(
        "float64",
        "",
        "p-value of the true friction",
        "an interval of confidence c holds the true friction if this is 1 − c or more; uniform in"
        " (0, 1) if coverage is exact",
    ),
    "bias_chance": Result(
        "float64",
        "",
        "p-value of the true bias",
        "as friction_chance, for the bias",
    ),
    "falls": Result("int64", "", "falls that were fitted"),
}


@dataclass(frozen=True)
class Fitted:
    """Experiments of some falls each, with a bias and errors of reading, and their fits."""

    name: str = "fit"
    options: Options = FALLING
    tables: Mapping[str, Any] = field(
        default_factory=lambda: {"law": "coulomb", "release": "paper", "fit": {}}
    )
    settings: tuple[str, ...] = ("gravity",)
    chunk: int = 50
    one_start: bool = False
    results: Mapping[str, Result] = field(
        default_factory=lambda: {f"fitted_{name}": one for name, one in RESULTS.items()}
    )

    def computed(
        self, call: Call, threads: int | None, progress: Progress
    ) -> dict[str, NDArray[Any]]:
        """The fits of a call; NaN where there are too few falls to fit."""
        if type(call.law) is not Coulomb or call.law.resistances:
            raise RimrollError(f"[law] fits are of coulomb friction, got {call.law!r}")
        count = len(call.rows)
        found = {
            name: np.full(count, np.nan if one.dtype == "float64" else 0, one.dtype)
            for name, one in self.results.items()
        }
        frictions = np.broadcast_to(call.law.friction, count)
        for k in range(count):
            fitted = _fitted(call, k, float(frictions[k]), threads)
            for name, value in fitted.items():
                found[f"fitted_{name}"][k] = value
            progress(k + 1, count)
        return found


def _fitted(call: Call, k: int, friction: float, threads: int | None) -> dict[str, float]:
    """The fit of one experiment."""
    assert call.hands is not None and call.fit is not None
    body = Body(
        *(float(np.broadcast_to(one, len(call.rows))[k]) for one in vars(call.body).values())
    )
    wanted, error = int(call.fit["falls"][k]), float(call.fit["reading_error"][k])
    predicted = _predicted(body, call.hands[k], call.options.gravity, error)
    row = int(call.numbers[k])
    bias = float(call.fit["bias"][k] * quantiles(stream(call.seed, "bias", row, row + 1))[0])
    released = SURPLUS * wanted
    chances = stream(call.seed, f"falls {row}", 0, 5 * released).reshape(released, 5)
    starts, scales = call.hands[k].at(chances)
    falls = follow(
        body, starts, Coulomb(friction), call.options, friction_scale=scales, threads=threads
    )
    fell = falls["direction"][falls["outcome"] == predicted.outcome][:wanted]
    if len(fell) < 3:
        return {"falls": len(fell)}
    readings = quantiles(stream(call.seed, f"readings {row}", 0, wanted))[: len(fell)]
    likelihood = Likelihood(predicted, fell + bias + error * readings)
    best = likelihood.best()
    return {
        "friction": best.friction,
        "bias": best.bias,
        "unsteadiness": best.unsteadiness,
        "friction_chance": _chance(likelihood, best, friction=friction),
        "bias_chance": _chance(likelihood, best, bias=bias),
        "falls": len(fell),
    }


def _chance(likelihood: Likelihood, best: Any, **true: float) -> float:
    return likelihood.chance(likelihood.worse(likelihood.best(**true), best))


@lru_cache(maxsize=16)
def _predicted(body: Body, release: Release, gravity: float, reading_error: float) -> Predicted:
    return predict_falls(body, release, gravity=gravity, reading_error=reading_error)


FIT = Fitted()
