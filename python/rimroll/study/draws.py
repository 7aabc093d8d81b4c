"""Random numbers of a study: those of a row depend on the seed and the number of the row only."""

from __future__ import annotations

import hashlib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from rimroll.errors import RimrollError, nearest
from rimroll.experiment.release import MIN_CHANCE, Release, normal_quantiles

Array = NDArray[np.float64]

SAMPLINGS = ("independent", "common", "sobol", "latin_hypercube")
"""How trials are drawn.

independent: each row has its own random numbers.
common: trial k has the same random numbers at every place of the axes, so that differences between
places are those of the places.
sobol, latin_hypercube: trials fill the space of the random quantities evenly (``scipy.stats.qmc``);
trial k is the same at every place.
"""

MAX_POINTS = {"latin_hypercube": 1 << 20, "sobol": 1 << 30}
"""The largest numbers of trials: a Latin hypercube must be made as a whole, and Sobol points have
30 bits."""

WORDS = 4
"""Random numbers that Philox makes at each count."""


def stream(seed: int, name: str, first: int, last: int) -> Array:
    """Numbers ``first`` to before ``last`` of a sequence that is uniform in (0, 1).

    Each name has its own sequence. Philox computes any part of it (Salmon et al. 2011).
    """
    digest = hashlib.sha256(f"{seed} {name}".encode()).digest()
    key = np.frombuffer(digest[:16], "<u8").astype(np.uint64)
    philox = np.random.Philox(key=key)
    philox.advance(first // WORDS)
    skipped = first % WORDS
    raw = philox.random_raw(last - first + skipped)[skipped:]
    return np.asarray(np.maximum((raw >> np.uint64(11)) * 2.0**-53, MIN_CHANCE))


@dataclass(frozen=True)
class Sampling:
    """The random numbers, uniform in (0, 1), of the rows of a study."""

    method: str
    seed: int
    trials: int
    names: tuple[str, ...]
    """The random quantities, in the order of the dimensions of a Sobol sequence."""
    release: bool
    """Whether a hand releases the body: five further numbers for each row."""

    def __post_init__(self) -> None:
        if self.method not in SAMPLINGS:
            raise RimrollError(f"unknown sampling {self.method!r}{nearest(self.method, SAMPLINGS)}")
        most = MAX_POINTS.get(self.method, self.trials)
        if self.trials > most:
            raise RimrollError(
                field="trials",
                value=self.trials,
                bound=f"at most {most} with sampling {self.method!r}",
            )

    def chances(self, first: int, last: int) -> tuple[dict[str, Array], Array | None]:
        """Numbers by random quantity, each (n,), and those of the release (n, 5), of some rows.

        Those of the release are the numbers of ``Release.draw(rows, seed)``, or at each place of
        the axes those of ``Release.draw(trials, seed)`` if the sampling is common.
        """
        if self.method == "independent":
            return self._part(first, last)
        trial = np.arange(first, last) % self.trials
        low, high = int(trial.min()), int(trial.max()) + 1
        given, hand = self._part(low, high) if self.method == "common" else self._even(low, high)
        place = trial - low
        return {name: one[place] for name, one in given.items()}, (
            None if hand is None else hand[place]
        )

    def _part(self, first: int, last: int) -> tuple[dict[str, Array], Array | None]:
        given = {name: stream(self.seed, name, first, last) for name in self.names}
        return given, Release.chances(first, last, self.seed) if self.release else None

    def _even(self, first: int, last: int) -> tuple[dict[str, Array], Array | None]:
        """Points of a design that fills space evenly, from trial ``first`` to before ``last``."""
        from scipy.stats import qmc

        count = len(self.names) + (5 if self.release else 0)
        if not count:
            return {}, None
        if self.method == "sobol":
            engine: Any = qmc.Sobol(count, seed=np.random.default_rng(self.seed))
            if first:
                engine.fast_forward(first)
            # Not a power of two at a time: the design is whole when all its parts are.
            points = engine.random(1) if last - first == 1 else _quietly(engine, last - first)
        else:
            points = _hypercube(count, self.seed, self.trials)[first:last]
        points = np.clip(points, MIN_CHANCE, 1.0 - 2.0**-53)
        given = {name: points[:, k] for k, name in enumerate(self.names)}
        return given, points[:, len(self.names) :] if self.release else None


@lru_cache(maxsize=1)
def _hypercube(dimensions: int, seed: int, trials: int) -> Array:
    """A Latin hypercube (trials, dimensions), made once for all chunks."""
    from scipy.stats import qmc

    engine = qmc.LatinHypercube(dimensions, seed=np.random.default_rng(seed))
    return np.asarray(engine.random(trials))


def _quietly(engine: Any, count: int) -> Array:
    import warnings

    with warnings.catch_warnings():
        warnings.simplefilter("ignore", UserWarning)
        return np.asarray(engine.random(count))


@dataclass(frozen=True)
class Random:
    """A random quantity: a distribution of ``scipy.stats``, by the chances that lie below."""

    name: str
    of: str
    unit: str
    distribution: str
    numbers: Mapping[str, float]

    def values(self, chances: Array) -> Array:
        """The quantiles, in the SI unit of the quantity, of chances (n,)."""
        return np.asarray(_quantiles(self.distribution, self.numbers, chances))


def _quantiles(distribution: str, numbers: Mapping[str, float], chances: Array) -> Array:
    match distribution:
        case "uniform":
            low, high = numbers["low"], numbers["high"]
            return low + (high - low) * chances
        case "normal":
            return numbers["mean"] + numbers["spread"] * normal_quantiles(chances)
        case "lognormal":
            # exp of NumPy: the same on a machine whatever the length of the array.
            return numbers["median"] * np.exp(numbers["dispersion"] * normal_quantiles(chances))
        case _:
            import scipy.stats

            return np.asarray(getattr(scipy.stats, distribution).ppf(chances, **numbers))


OWN: Mapping[str, Sequence[str]] = {
    "uniform": ("low", "high"),
    "normal": ("mean", "spread"),
    "lognormal": ("median", "dispersion"),
}
"""The distributions with numbers of our own, and these: others take the arguments of SciPy."""
