"""The description of a study: its tables, checked."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Annotated, Any

import numpy as np
from numpy.typing import NDArray
from pydantic import Field

from rimroll.errors import RimrollError, nearest
from rimroll.scenario import FILM
from rimroll.scenario.tables import SimulationTable, Table, as_toml, checked, made, readable
from rimroll.study.axes import Axis, Described, targets, unit_of
from rimroll.study.columns import TRIAL
from rimroll.study.draws import OWN, Random, Sampling
from rimroll.study.kinds import KINDS, Kind
from rimroll.study.setups import STATE, Block, Given, records_of
from rimroll.units import quantity, random_seed

CASE = "case"
"""The dimension of axes that are zipped."""

NAME = re.compile(r"[A-Za-z_]\w*", re.ASCII)
"""What axes, dimensions and random quantities are called: xarray makes attributes of these."""

HAND = (*(f"start_{name}" for name in STATE), "friction_scale")
"""The columns of what a hand gives to a row."""

COMBINATIONS = ("product", "zip")

MAX_ROWS = 10_000_000_000
"""The largest number of rows, unless the study says otherwise."""


class _Study(Table):
    kind: str = "ensemble"
    title: str | None = None
    seed: int = 0
    trials: Annotated[int, Field(gt=0, le=10**12)] = 1
    combine: str = "product"
    sampling: str = "independent"
    keep: Any = "all"
    chunk: Annotated[int | None, Field(gt=0)] = None
    most_rows: Annotated[int, Field(gt=0)] = MAX_ROWS
    store: str | None = None
    body: dict[str, Any]
    law: Any = None
    start: Any = None
    release: Any = None
    ground: Any = None
    fit: dict[str, Any] | None = None
    simulation: dict[str, Any] = Field(default_factory=dict)
    axes: dict[str, Any] = Field(default_factory=dict)
    random: dict[str, Any] = Field(default_factory=dict)
    statistics: dict[str, Any] | None = None


@dataclass(frozen=True, eq=False)
class Description:
    """What a study consists of."""

    kind: Kind
    tables: Mapping[str, Any]
    """The tables body, law, start, release, ground and simulation; None for those not used."""
    axes: tuple[Axis, ...]
    randoms: tuple[Random, ...]
    sampling: Sampling
    dims: Mapping[str, int]
    """The sizes of the dimensions, in order."""
    keep: Any
    statistics: Mapping[str, Any] | None
    chunk: int
    title: str | None
    store: str | None
    folder: Path
    records: Mapping[str, str] = field(default_factory=dict)
    """The SHA-256 of each record when the study was planned, by its name in the study."""

    def with_records(self) -> Description:
        """A copy with the records as they are now. Raises ``RimrollError`` for a missing record."""
        tables = [] if self.tables["ground"] is None else [self.tables["ground"]]
        for axis in self.axes:
            if axis.of in ("ground", "ground.record"):
                tables += axis.values
        return replace(self, records=records_of(tables, self.folder))

    @property
    def rows(self) -> int:
        """The number of rows."""
        rows = 1
        for size in self.dims.values():
            rows *= size
        return rows

    def block(self, first: int, last: int) -> Block:
        """What varies in the rows from ``first`` to before ``last``."""
        rows = np.arange(first, last)
        index: dict[str, NDArray[np.int64]] = {}
        stride = self.rows
        for dim, size in self.dims.items():
            stride //= size
            index[dim] = rows // stride % size
        chances, hand = self.sampling.chances(first, last)
        own = np.arange(last - first)
        return Block(
            last - first,
            (
                *(Given(axis.of, axis.values, index[axis.along]) for axis in self.axes),
                *(Given(one.of, one.values(chances[one.name]), own) for one in self.randoms),
            ),
            first,
            self.sampling.seed,
            hand,
        )

    @property
    def first(self) -> Block:
        """A row with the first value of each axis and the middle of each distribution."""
        return self._tried(1, {})

    def along(self, axis: Axis) -> Block:
        """A row for each value of an axis; everything else that varies has its first value."""
        return self._tried(axis.size, {axis.of: axis.values})

    def drawn(self, random: Random, chances: NDArray[np.float64]) -> Block:
        """A row for each chance of a random quantity; everything else has its first value."""
        return self._tried(len(chances), {random.of: random.values(chances)})

    @property
    def draws(self) -> int:
        """How often each random quantity is drawn."""
        return self.rows if self.sampling.method == "independent" else self.sampling.trials

    def _tried(self, count: int, values: Mapping[str, Any]) -> Block:
        own, first = np.arange(count), np.zeros(count, np.int64)
        # The middle of each distribution, which is more certainly possible than its tails.
        half = np.full(1, 0.5)
        whole = {one.of: one.values for one in self.axes}
        whole |= {one.of: one.values(half) for one in self.randoms}
        given = [
            Given(of, values.get(of, one), own if of in values else first)
            for of, one in whole.items()
        ]
        return Block(count, tuple(given), release=np.full((count, 5), 0.5))


def described(content: dict[str, Any], folder: Path) -> Description:
    """The description that the content of a file in that folder gives.

    Raises ``RimrollError`` for unknown and missing keys, and for values outside their bounds.
    """
    if "body" not in content and content.keys() <= _Study.model_fields.keys():
        what = "has no table [body]" if content else "is empty"
        raise RimrollError(f'{what}: write what rolls, such as [body] and preset = "can_2007"')
    read = checked(_Study, content, "")
    if read.kind not in KINDS:
        raise RimrollError(f"unknown kind {read.kind!r}{nearest(read.kind, KINDS)}")
    kind = KINDS[read.kind]
    axes = tuple(
        made(f"[axes.{name}]", lambda n=name, t=table: _axis(n, t))  # type: ignore[misc]
        for name, table in read.axes.items()
    )
    axes = _combined(axes, read.combine)
    randoms = tuple(
        made(f"[random.{name}]", lambda n=name, t=table: _random(n, t))  # type: ignore[misc]
        for name, table in read.random.items()
    )
    varied = [*(axis.of for axis in axes), *(one.of for one in randoms)]
    tables = _tables(read, kind, varied)
    _expect_settings(kind, [*read.simulation, *_varied_in("simulation", varied)])
    _expect_one_film(tables["law"], axes, varied)
    has_hand = tables["release"] is not None and kind.one_start
    _expect_different(axes, randoms, kind, HAND if has_hand else ())
    names = tuple(one.name for one in randoms)
    sampling = Sampling(
        read.sampling, random_seed(read.seed), read.trials, names, tables["release"] is not None
    )
    if read.trials > 1 and not names and tables["release"] is None:
        raise RimrollError(
            field="trials",
            value=read.trials,
            bound="1 where nothing is random",
            hint=": give [random] or [release]",
        )
    dims = _dims(axes, read.trials, read.most_rows)
    return Description(
        kind,
        tables,
        axes,
        randoms,
        sampling,
        dims,
        read.keep,
        read.statistics,
        read.chunk or kind.chunk,
        read.title,
        read.store,
        folder,
    )


def _axis(name: str, table: object) -> Axis:
    if isinstance(table, list):
        table = {"values": table}
    if not isinstance(table, dict):
        raise RimrollError(f"must be a table or a list, got {as_toml(table)}")
    _, _, last = name.rpartition(".")
    if _is_key(name):
        table = {"of": name} | table
    read = checked(Described, table, "")
    for one in (last, read.along or last):
        _expect_name(one)
    return read.axis(last)


def _is_key(name: str) -> bool:
    """Whether the name of an axis says by itself what varies."""
    return "." in name or name in targets()


def _random(name: str, table: object) -> Random:
    if not isinstance(table, dict):
        raise RimrollError(f"must be a table, got {as_toml(table)}")
    _, _, last = name.rpartition(".")
    _expect_name(last)
    rest = ({"of": name} if _is_key(name) else {}) | table
    for key in ("of", "distribution"):
        if not isinstance(rest.get(key), str):
            raise RimrollError(f"lacks {key!r}, a text")
    of, distribution = rest.pop("of"), rest.pop("distribution")
    unit = unit_of(of)
    if unit is None:
        raise RimrollError(f"{of} is no number, so it has no distribution")
    numbers = _numbers(distribution, rest, unit)
    random = Random(last, of, unit, distribution, numbers)
    ends = random.values(np.array([2.0**-54, 0.5, 1.0 - 2.0**-53]))
    if not np.isfinite(ends[1]) or np.isnan(ends).any():
        raise RimrollError(f"{distribution} has no quantiles for {as_toml(rest)}")
    return random


def _numbers(distribution: str, given: Mapping[str, Any], unit: str) -> dict[str, float]:
    """The numbers of a distribution; those with the unit of the quantity in SI units."""
    if distribution in OWN:
        names = OWN[distribution]
        for name in given:
            if name not in names:
                raise RimrollError(f"has an unknown key {name!r}{nearest(name, names)}")
        for name in names:
            if name not in given:
                raise RimrollError(f"lacks {name!r}: {distribution} has {' and '.join(names)}")
        numbers = {
            name: quantity(readable(value), "1" if name == "dispersion" else unit, name)
            for name, value in given.items()
        }
        _expect_possible(distribution, numbers)
        return numbers
    import scipy.stats

    known = sorted(
        name
        for name, one in vars(scipy.stats).items()
        if isinstance(one, scipy.stats.rv_continuous)
    )
    if distribution not in known:
        raise RimrollError(
            f"unknown distribution {distribution!r}{nearest(distribution, OWN)}; or a continuous"
            " one of scipy.stats"
        )
    shapes = getattr(scipy.stats, distribution).shapes
    names = [*(shapes.split(", ") if shapes else []), "loc", "scale"]
    for name in given:
        if name not in names:
            raise RimrollError(f"has an unknown key {name!r}{nearest(name, names)}")
    for name in names[:-2]:
        if name not in given:
            raise RimrollError(f"lacks {name!r}: {distribution} has {', '.join(names)}")
    return {
        name: quantity(readable(value), unit if name in ("loc", "scale") else "1", name)
        for name, value in given.items()
    }


def _expect_possible(distribution: str, numbers: Mapping[str, float]) -> None:
    for name in ("spread", "dispersion"):
        if numbers.get(name, 0.0) < 0.0:
            raise RimrollError(field=name, value=numbers[name], bound=">= 0")
    if distribution == "lognormal" and not numbers["median"] > 0.0:
        raise RimrollError(field="median", value=numbers["median"], bound="> 0")
    if distribution == "uniform" and not numbers["low"] < numbers["high"]:
        raise RimrollError(
            field="high", value=numbers["high"], bound=f"above low, {numbers['low']:g}"
        )


def _combined(axes: tuple[Axis, ...], combine: str) -> tuple[Axis, ...]:
    """The axes along their dimensions."""
    if combine not in COMBINATIONS:
        raise RimrollError(f"unknown combine {combine!r}{nearest(combine, COMBINATIONS)}")
    if combine == "product":
        return axes
    return tuple(replace(axis, along=CASE) for axis in axes)


def _dims(axes: tuple[Axis, ...], trials: int, most: int) -> dict[str, int]:
    dims: dict[str, int] = {}
    named: dict[str, str] = {}
    for axis in axes:
        other = named.setdefault(axis.along, axis.name)
        if dims.setdefault(axis.along, axis.size) != axis.size:
            raise RimrollError(
                f"axes along {axis.along!r} must be of one length: {other} has {dims[axis.along]}"
                f" values, {axis.name} has {axis.size}"
            )
    if trials > 1 or not dims:
        dims[TRIAL] = trials
    rows = 1
    for size in dims.values():
        rows *= size
    if rows > most:
        sizes = " x ".join(f"{size} {dim}" for dim, size in dims.items())
        raise RimrollError(
            f"{sizes} are {rows} rows, more than most_rows = {most}: take fewer, or raise most_rows"
        )
    return dims


def _varied_in(section: str, varied: list[str]) -> list[str]:
    """The keys of a table that vary."""
    return [key for one in varied for table, _, key in [one.partition(".")] if table == section]


def _expect_settings(kind: Kind, given: list[str]) -> None:
    for name in given:
        if name in SimulationTable.model_fields and name not in kind.settings:
            known = ", ".join(kind.settings)
            raise RimrollError(
                f"[simulation] {name} has no effect on kind {kind.name!r}, which has {known}:"
                " leave it out"
            )


def _expect_one_film(law: Any, axes: tuple[Axis, ...], varied: list[str]) -> None:
    """A film's drag is that of one body under one gravity."""
    laws = [law, *(value for axis in axes if axis.of == "law" for value in axis.values)]
    drags = [one.get("air_drag") for one in laws if isinstance(one, dict)]
    if any(isinstance(one, dict) and one.get("coefficient") == FILM for one in drags):
        for of in varied:
            if of.partition(".")[0] == "body" or of == "simulation.gravity":
                raise RimrollError(
                    f'[law.air_drag] coefficient "{FILM}" needs a single body and gravity:'
                    f" {of} varies"
                )


def _expect_name(name: str) -> None:
    if not NAME.fullmatch(name):
        raise RimrollError(
            f"the name {name!r} must consist of letters, digits and _, and begin with no digit"
        )


def _expect_different(
    axes: tuple[Axis, ...], randoms: tuple[Random, ...], kind: Kind, kept: Iterable[str]
) -> None:
    names: dict[str, str] = {
        TRIAL: "the trials",
        "done": "a folder of the store",
        **dict.fromkeys(kind.results, "a result"),
        **dict.fromkeys(kept, "a column"),
    }
    varied: dict[str, str] = {}
    given = [(axis.name, axis.of, "an axis") for axis in axes]
    given += [(one.name, one.of, "a random quantity") for one in randoms]
    for name, of, what in given:
        if name in names:
            raise RimrollError(f"{name!r} is the name of {names[name]}: take another")
        if of in varied:
            raise RimrollError(f"{of} is varied twice, by {varied[of]} and {name}")
        names[name], varied[of] = what, name
    elsewhere = {axis.name for axis in axes if axis.along != axis.name}
    for axis in axes:
        if axis.along in elsewhere:
            raise RimrollError(
                f"{axis.along!r} is the name of an axis along another dimension: take another"
            )
        if axis.along != axis.name and names.get(axis.along, "an axis") != "an axis":
            raise RimrollError(f"{axis.along!r} is the name of {names[axis.along]}: take another")


def _tables(read: _Study, kind: Kind, varied: list[str]) -> dict[str, Any]:
    """The tables that the kind uses, with what it takes for those that are not given."""
    sections = {one.partition(".")[0] for one in varied}
    found: dict[str, Any] = {"body": read.body, "simulation": read.simulation}
    for name in ("law", "start", "release", "ground", "fit"):
        given = getattr(read, name)
        if name not in kind.tables:
            if given is not None or name in sections:
                takes = ", ".join(kind.tables)
                raise RimrollError(f"[{name}] does not go with kind {kind.name!r}: it has {takes}")
            found[name] = None
        else:
            found[name] = given
    if found["start"] is not None and found["release"] is not None:
        raise RimrollError("has both [start] and [release]: give one")
    for name in kind.tables:
        if found[name] is None and name in sections:
            found[name] = {}
    taken = found["start"] is not None or found["release"] is not None
    for name, default in kind.tables.items():
        if found[name] is None and not (taken and name in ("start", "release")):
            found[name] = default
    if found["law"] == {}:
        found["law"] = {"kind": kind.tables["law"]} if "law.kind" not in varied else {}
    if found["start"] is None and found["release"] is None:
        raise RimrollError("has no [start] and no [release]: say how the body is released")
    if "ground" in kind.tables and found["ground"] is None:
        raise RimrollError("has no table [ground]: say how the table moves")
    return found
