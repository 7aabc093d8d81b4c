"""The kinds of studies, and the calls of the core in which each computes its rows."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, fields, replace
from functools import lru_cache
from pathlib import Path
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from rimroll import _core
from rimroll.bodies.body import Body
from rimroll.errors import RimrollError
from rimroll.experiment.likelihood import Likelihood
from rimroll.experiment.predicted import Predicted, predict_falls
from rimroll.experiment.release import Release, normal_quantiles
from rimroll.experiment.toppling import FALLING
from rimroll.ground.ground import Ground
from rimroll.laws import Coulomb, Law
from rimroll.many.ensemble import OPTIONS, VARIABLES, exact_falls, follow
from rimroll.many.falls import Falls
from rimroll.options import FlatLanding, Options
from rimroll.scenario.tables import SimulationTable, checked, made, read_flat
from rimroll.shaking.many import VARIABLES as OF_SHAKEN
from rimroll.shaking.many import follow_shaken
from rimroll.state import State
from rimroll.study.columns import Progress
from rimroll.study.draws import stream
from rimroll.study.setups import (
    STANDING,
    Block,
    BodyRows,
    Codes,
    GroundRows,
    LawRows,
    StartRows,
    bodies_of,
    distinct,
    experiments_of,
    grounds_of,
    key_in,
    laws_of,
    releases_of,
    starts_of,
)
from rimroll.theory.exact import NUMBERS

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Call:
    """Rows that one call of the core computes."""

    rows: Codes
    """The places of these rows in their block."""
    body: Body
    starts: State
    law: Law
    options: Options
    duration: float | None
    """The duration of the motion, s; None unless the study gives it."""
    flat: FlatLanding
    friction_scale: Array | float = 1.0
    grounds: list[Ground] | None = None
    """The ground of each row."""
    scale: Array | None = None
    numbers: Codes = field(default_factory=lambda: np.empty(0, np.int64))
    """The numbers of these rows in the study."""
    seed: int = 0
    hands: list[Release] | None = None
    """The hand of each row."""
    fit: Mapping[str, Array] | None = None
    """The experiment of each row of a study of fits."""


@dataclass(frozen=True, eq=False)
class Cases:
    """What is computed in a block of rows."""

    block: Block
    bodies: BodyRows
    laws: LawRows
    starts: StartRows
    grounds: GroundRows | None
    options: list[tuple[Options, float | None, FlatLanding]]
    option_codes: Codes
    fit: Mapping[str, Array] | None = None

    @classmethod
    def of(
        cls,
        tables: Mapping[str, Any],
        block: Block,
        defaults: Options,
        folder: Path,
        records: Mapping[str, str],
    ) -> Cases:
        """The cases of a block, from the tables of a study and the records in its folder.

        Raises ``RimrollError`` for what scenario files may not say.
        """
        options, codes = _options_of(tables["simulation"], block, defaults)
        gravity = np.array([one.gravity for one, _, _ in options])[codes]
        bodies = bodies_of(tables["body"], block)
        grounds = None
        if tables["ground"] is not None:
            grounds = grounds_of(tables["ground"], block, folder, records)
        if tables["release"] is not None:
            starts = releases_of(tables["release"], block, bodies, gravity)
        else:
            starts = starts_of(tables["start"], block)
        laws = laws_of(tables["law"], block, bodies, float(gravity[0]))
        fit = None if tables["fit"] is None else experiments_of(tables["fit"], block)
        return cls(block, bodies, laws, starts, grounds, options, codes, fit)

    def calls(self) -> Iterator[Call]:
        """The calls whose rows together are the block."""
        rows, codes = distinct(self.block.count, [self.laws.codes, self.option_codes])
        for code, row in enumerate(rows.tolist()):
            here = np.flatnonzero(codes == code)
            options, duration, flat = self.options[int(self.option_codes[row])]
            scales = self.starts.friction_scale
            call = Call(
                here,
                self.bodies.body(here),
                self.starts.state(here),
                self.laws.law(int(self.laws.codes[row]), here),
                options,
                duration,
                flat,
                1.0 if scales is None else scales[here],
                numbers=self.block.first + here,
                seed=self.block.seed,
            )
            if self.fit is not None:
                assert self.starts.codes is not None
                hands = [self.starts.hands[k] for k in self.starts.codes[here].tolist()]
                own_fit = {name: one[here] for name, one in self.fit.items()}
                call = replace(call, hands=hands, fit=own_fit)
            if self.grounds is not None:
                own = [self.grounds.grounds[k] for k in self.grounds.codes[here].tolist()]
                call = replace(call, grounds=own, scale=self.grounds.scale[here])
            yield call


def _options_of(
    table: Mapping[str, Any], block: Block, defaults: Options
) -> tuple[list[tuple[Options, float | None, FlatLanding]], Codes]:
    given = block.of("simulation")
    rows, codes = distinct(block.count, [one.codes for one in given])
    found = []
    for row in rows.tolist():
        whole = dict(table) | {key_in(one): one.at(row) for one in given}
        read = checked(SimulationTable, whole, "[simulation]")
        chosen = {name: getattr(read, name) for name in read.model_fields_set - {"flat"}}
        flat = made("[simulation]", lambda read=read: read_flat(read.flat, True))  # type: ignore[misc]
        found.append((replace(defaults, **chosen), chosen.get("duration"), flat))
    return found, codes


OPTION_NAMES = tuple(one.name for one in fields(Options) if one.name not in ("flat", "flat_gap"))
"""The keys of [simulation] that are options of the solver for all motions."""


@dataclass(frozen=True)
class Result:
    """A number or word that a kind computes for each row."""

    dtype: str
    unit: str = ""
    long_name: str | None = None
    comment: str | None = None
    flags: tuple[str, ...] = ()


class Kind(Protocol):
    """A kind of study: the results of a row, and how the rows of a call are computed."""

    @property
    def name(self) -> str:
        """The word for it in files."""

    @property
    def results(self) -> Mapping[str, Result]:
        """The results of a row, by name."""

    @property
    def options(self) -> Options:
        """How motions are followed unless the study says otherwise."""

    @property
    def chunk(self) -> int:
        """Rows of a chunk unless the study says otherwise: some seconds of processor time."""

    @property
    def tables(self) -> Mapping[str, Any]:
        """The tables that it reads besides [body], and what they are unless the study has them."""

    @property
    def settings(self) -> tuple[str, ...]:
        """The keys of [simulation] that decide its results."""

    @property
    def one_start(self) -> bool:
        """Whether a row has one start, which is kept if a hand releases the body."""

    def computed(
        self, call: Call, threads: int | None, progress: Progress
    ) -> dict[str, NDArray[Any]]:
        """The results of the rows of a call, each (n,).

        ``progress`` is called with the numbers of rows that are done and that there are.
        """


OUTCOME = Result("int8", long_name="outcome", flags=tuple(_core.OUTCOMES))

CHUNK = 250_000
"""First turns in a chunk: a second of processor time or more.

In chunks of a million, drawing, hashing and writing were measured to take three times as long."""

DTYPES = {"slid": "bool", "flew": "bool", "steps": "int64"}
"""The types of columns that are not float64."""


def described(names: tuple[str, ...]) -> dict[str, Result]:
    """The columns of falls of these names."""
    return {name: Result(DTYPES.get(name, "float64"), *VARIABLES[name]) for name in names}


@dataclass(frozen=True)
class Followed:
    """First turns, as :func:`rimroll.ensemble` computes them."""

    name: str
    options: Options
    tables: Mapping[str, Any]
    settings: tuple[str, ...] = OPTION_NAMES
    chunk: int = CHUNK
    one_start: bool = True
    results: Mapping[str, Result] = field(
        default_factory=lambda: {"outcome": OUTCOME, **described(tuple(VARIABLES))}
    )

    def computed(
        self, call: Call, threads: int | None, progress: Progress
    ) -> dict[str, NDArray[Any]]:
        """The falls of a call."""
        falls = follow(
            call.body,
            call.starts,
            call.law,
            call.options,
            friction_scale=call.friction_scale,
            threads=threads,
            progress=progress,
            words=False,
        )
        return {name: falls[name] for name in self.results}


@dataclass(frozen=True)
class ByQuadrature:
    """First turns under laws that conserve energy, as :func:`rimroll.exact_turn` computes them."""

    name: str = "exact_turn"
    options: Options = OPTIONS
    tables: Mapping[str, Any] = field(
        default_factory=lambda: {"law": "no_slip", "start": None, "release": None}
    )
    settings: tuple[str, ...] = ("gravity", "topple_tilt")
    chunk: int = 2 * CHUNK
    one_start: bool = True
    results: Mapping[str, Result] = field(
        default_factory=lambda: {
            "outcome": OUTCOME,
            **described((*(name for name in NUMBERS if name in VARIABLES), "direction")),
        }
    )

    def computed(
        self, call: Call, threads: int | None, progress: Progress
    ) -> dict[str, NDArray[Any]]:
        """The turns of a call."""
        falls = exact_falls(
            call.body,
            call.starts,
            call.law,
            gravity=call.options.gravity,
            topple_tilt=call.options.topple_tilt,
            threads=threads,
            progress=progress,
        )
        return columns_of(falls, self.results)


def columns_of(falls: Falls, results: Mapping[str, Result]) -> dict[str, NDArray[Any]]:
    """The results among the columns of falls, or of shaken bodies, with words as their places."""
    return {
        name: as_flags(falls[name], result.flags) if result.flags else falls[name]
        for name, result in results.items()
    }


def as_flags(words: NDArray[Any], known: tuple[str, ...]) -> NDArray[np.int8]:
    """Words (n,) as their places among the known ones."""
    found = np.full(len(words), -1, np.int8)
    for place, word in enumerate(known):
        found[words == word] = place
    return found


ENSEMBLE = Followed("ensemble", OPTIONS, {"law": "no_slip", "start": None, "release": None})
TOPPLE = Followed("topple", FALLING, {"law": "no_slip", "release": "flick"})
EXACT_TURN = ByQuadrature()

SHAKEN_DTYPES = {"overturned": "bool", "undecided": "bool", "stands": "bool", "steps": "int64"}
"""The types of columns that are not float64."""

SHAKING = Options(duration=1.0, rtol=1e-8)
"""The defaults of :func:`rimroll.shake_many`, whose motions each have their own duration."""

STATUS = Result("int8", long_name="status", flags=tuple(_core.STATUSES))


@dataclass(frozen=True)
class Shaken:
    """Bodies on tables that move, as :func:`rimroll.shake_many` computes them."""

    name: str = "shake"
    options: Options = SHAKING
    tables: Mapping[str, Any] = field(
        default_factory=lambda: {
            "law": "no_slip",
            "start": STANDING,
            "release": None,
            "ground": None,
        }
    )
    settings: tuple[str, ...] = (*OPTION_NAMES, "flat", "flat_gap")
    chunk: int = 10_000
    one_start: bool = True
    results: Mapping[str, Result] = field(
        default_factory=lambda: {
            "status": STATUS,
            **{
                name: Result(SHAKEN_DTYPES.get(name, "float64"), *one)
                for name, one in OF_SHAKEN.items()
            },
        }
    )

    def computed(
        self, call: Call, threads: int | None, progress: Progress
    ) -> dict[str, NDArray[Any]]:
        """The motions of a call."""
        assert call.grounds is not None and call.scale is not None
        shaken = follow_shaken(
            call.body,
            call.starts,
            call.law,
            call.grounds,
            scale=call.scale,
            duration=call.duration,
            options=replace(call.options, flat=call.flat),
            threads=threads,
            progress=progress,
        )
        return columns_of(shaken, self.results)


SHAKE = Shaken()

SURPLUS = 2
"""Releases for each fall that is wanted, since some bodies do not topple."""

FITTED = {
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
        default_factory=lambda: {f"fitted_{name}": one for name, one in FITTED.items()}
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
    bias = float(call.fit["bias"][k] * normal_quantiles(stream(call.seed, "bias", row, row + 1))[0])
    released = SURPLUS * wanted
    chances = stream(call.seed, f"falls {row}", 0, 5 * released).reshape(released, 5)
    starts, scales = call.hands[k].at(chances)
    falls = follow(
        body, starts, Coulomb(friction), call.options, friction_scale=scales, threads=threads
    )
    fell = falls["direction"][falls["outcome"] == predicted.outcome][:wanted]
    if len(fell) < 3:
        return {"falls": len(fell)}
    readings = normal_quantiles(stream(call.seed, f"readings {row}", 0, wanted))[: len(fell)]
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

KINDS: Mapping[str, Kind] = {kind.name: kind for kind in (ENSEMBLE, TOPPLE, EXACT_TURN, SHAKE, FIT)}

__all__ = ["KINDS", "Kind", "Result"]
