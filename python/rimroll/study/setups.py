"""Bodies, starts, laws, grounds and experiments of a block of rows."""

from __future__ import annotations

import copy
import hashlib
import inspect
import json
import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, fields, replace
from functools import cache, lru_cache
from pathlib import Path
from typing import Annotated, Any

import numpy as np
from numpy.typing import NDArray
from pydantic import Field, create_model

from rimroll.bodies.body import Bodies, Body
from rimroll.errors import RimrollError, choose, hold, nearest
from rimroll.experiment import release as releases
from rimroll.experiment.release import PRESETS, SPREAD, Release
from rimroll.ground import synthetic
from rimroll.ground.ground import MAX_FACTOR, Ground
from rimroll.laws import Law
from rimroll.scenario import RESISTANCES, presets
from rimroll.scenario.tables import (
    StartTable,
    Table,
    as_toml,
    checked,
    fields_of,
    in_three,
    in_unit,
    made,
    read_body,
    read_ground,
    read_law,
    readable,
)
from rimroll.state import State
from rimroll.study.axes import OF_FIT, unit_of
from rimroll.units import quantities_of, quantity

Codes = NDArray[np.int64]


@dataclass(frozen=True, eq=False)
class Given:
    """The value of one varying quantity in each of n rows."""

    of: str
    """The key of the tables, such as ``law.friction``."""
    values: Sequence[Any] | NDArray[np.float64]
    codes: Codes
    """The index of each row's value in ``values`` (n,)."""

    def at(self, row: int) -> Any:
        """The value of a row."""
        value = self.values[int(self.codes[row])]
        return float(value) if isinstance(value, np.floating) else value

    @property
    def array(self) -> NDArray[np.float64]:
        """The numbers of all rows (n,)."""
        return np.asarray(self.values, np.float64)[self.codes]


@dataclass(frozen=True, eq=False)
class Block:
    """Some rows of a study."""

    count: int
    given: tuple[Given, ...]
    first: int = 0
    """The number of the first row."""
    seed: int = 0
    release: NDArray[np.float64] | None = None
    """The random numbers (n, 5) of the hand that releases the body."""

    def of(self, section: str) -> list[Given]:
        """What varies of a section of the tables, whole sections first."""
        found = [one for one in self.given if one.of.partition(".")[0] == section]
        return sorted(found, key=lambda one: one.of.count("."))


def distinct(count: int, codes: Iterable[Codes]) -> tuple[Codes, Codes]:
    """A row for each combination of codes that occurs, and the index of each row's combination."""
    combined = np.zeros(count, np.int64)
    varying = [each for each in codes if (each != each[0]).any()]
    if not varying:  # as in most chunks of large studies
        return np.zeros(1, np.int64), combined
    for each in varying:
        size = int(each.max(initial=0)) + 1
        _, combined = np.unique(combined * size + each, return_inverse=True)
    _, rows, place = np.unique(combined, return_index=True, return_inverse=True)
    return rows.astype(np.int64), place.astype(np.int64)


def with_value(table: dict[str, Any], key: str, value: Any) -> dict[str, Any]:
    """A copy of a table in which a key, ``rolling_resistance.dry``, has a value."""
    made = copy.deepcopy(table)
    *path, last = key.split(".")
    inner = made
    for name in path:
        inner = inner.setdefault(name, {})
    inner[last] = value
    return made


def key_in(one: Given) -> str:
    """The key of a quantity inside its section: "" for the whole section."""
    return one.of.partition(".")[2]


def part(value: float | NDArray[np.float64], rows: Any) -> Any:
    """The numbers of some rows, out of (n,); or the one number of all rows."""
    return value[rows] if isinstance(value, np.ndarray) else value


NUMBERS = Bodies._fields

FACTORS = "factors"
"""The table of factors on the numbers of a body."""


@dataclass(frozen=True, eq=False)
class BodyRows:
    """The body of each of n rows."""

    numbers: Mapping[str, float | NDArray[np.float64]]
    """The five numbers: one for all rows, or (n,)."""
    codes: Codes
    """Equal for rows that have the same body (n,)."""

    def body(self, rows: Codes | slice = slice(None)) -> Body:
        """The bodies of some rows."""
        return Body(**{name: part(value, rows) for name, value in self.numbers.items()})

    def one(self, row: int) -> Body:
        """The body of a row."""
        return Body(**{name: float(part(value, row)) for name, value in self.numbers.items()})


def bodies_of(table: Mapping[str, Any], block: Block) -> BodyRows:
    """The bodies that a table and what varies of it give.

    A value of one of the five numbers replaces that of the body, unless its preset makes the body
    from it; then the body is made anew. Factors come last.

    Raises ``RimrollError`` as scenario files do.
    """
    given = block.of("body")
    anew = [one for one in given if _is_made_from(table, key_in(one))]
    rows, codes = distinct(block.count, [one.codes for one in anew])
    later = [one for one in given if one not in anew]
    found = [_body_made(table, anew, later, int(row)) for row in rows]
    numbers: dict[str, Any] = {
        name: getattr(found[0], name)
        if len(found) == 1
        else np.array([getattr(one, name) for one in found])[codes]
        for name in NUMBERS
    }
    for name, factor in _factors(table).items():
        numbers[name] = numbers[name] * factor
    for one in later:
        key = key_in(one)
        _, _, name = key.rpartition(".")
        numbers[name] = numbers[name] * one.array if key.startswith(FACTORS) else one.array
    _, codes = distinct(block.count, [codes, *(one.codes for one in later)])
    return BodyRows(numbers, codes)


def _is_made_from(table: Mapping[str, Any], key: str) -> bool:
    """Whether a body is made anew for each value of a key."""
    if key.startswith(FACTORS):
        return False
    if key not in NUMBERS:
        return True
    preset = table.get("preset")
    if not isinstance(preset, str):
        return False
    make = made("[body]", lambda: choose("preset", preset, presets()))
    return key in inspect.signature(make).parameters


def _body_made(table: Mapping[str, Any], anew: list[Given], later: list[Given], row: int) -> Body:
    """The body of a row, without its factors and before numbers are replaced."""
    whole = {key: value for key, value in table.items() if key != FACTORS}
    for one in anew:
        key, value = key_in(one), _with_unit(one, row)
        if key:
            whole = with_value(whole, key, value)
        else:
            whole = {"preset": value} if isinstance(value, str) else dict(value)
    if not whole.keys() & {"preset", "solids"}:
        for one in later:
            if not key_in(one).startswith(FACTORS):
                whole.setdefault(key_in(one), _with_unit(one, row))
    return read_body_once(json.dumps(whole, sort_keys=True))


def _with_unit(one: Given, row: int) -> Any:
    """A value as it may stand in a file, where large numbers need a unit."""
    value, unit = one.at(row), unit_of(one.of)
    return value if unit in (None, "1") else f"{value!r} {unit}"


@lru_cache(maxsize=4096)
def read_body_once(table: str) -> Body:
    """The body of a table in JSON."""
    return read_body(json.loads(table))


def _factors(table: Mapping[str, Any]) -> dict[str, float]:
    given = table.get(FACTORS, {})
    if not isinstance(given, Mapping):
        raise RimrollError(f"[body] factors must be a table, got {as_toml(given)}")
    for name in given:
        if name not in NUMBERS:
            raise RimrollError(
                f"[body.factors] has an unknown key {name!r}{nearest(name, NUMBERS)}"
            )
    return {
        name: made("[body.factors]", lambda n=name, v=value: quantity(readable(v), "1", n))  # type: ignore[misc]
        for name, value in given.items()
    }


@dataclass(frozen=True, eq=False)
class LawRows:
    """The law of each of n rows: some laws whose numbers may differ from row to row."""

    laws: list[Law]
    codes: Codes
    """The law of each row (n,), as a place in :attr:`laws`."""
    numbers: list[Given]
    """The numbers that differ from row to row."""

    def law(self, code: int, rows: Codes) -> Law:
        """One of the laws for some of its rows."""
        law = self.laws[code]
        for one in self.numbers:
            key, values = key_in(one), one.array[rows]
            law = made("[law]", lambda law=law, k=key, v=values: _law_with(law, k, v))  # type: ignore[misc]
        return law


def laws_of(table: Any, block: Block, bodies: BodyRows, gravity: float) -> LawRows:
    """The laws that a table, or the name of one, and what varies of it give.

    The body of the first row and ``gravity`` give the air drag of a film: the description refuses
    a film where either varies. Raises ``RimrollError`` as scenario files do.
    """
    given = block.of("law")
    anew = [one for one in given if unit_of(one.of) is None]
    numbers = [one for one in given if one not in anew]
    rows, codes = distinct(block.count, [one.codes for one in anew])
    body = tuple(bodies.one(0).__dict__.values())
    laws = []
    for row in rows:
        whole = table
        for one in anew:
            key, value = key_in(one), one.at(int(row))
            whole = with_value(_law_table(whole), key, value) if key else value
        for one in numbers:
            whole = with_value(_law_table(whole), key_in(one), one.at(int(row)))
        text = json.dumps(whole, sort_keys=True)
        laws.append(_read_law_once(text, body, gravity))
    return LawRows(laws, codes, numbers)


def _law_table(law: Any) -> dict[str, Any]:
    return {"kind": law} if isinstance(law, str) else dict(law)


@lru_cache(maxsize=4096)
def _read_law_once(table: str, body: tuple[float, ...], gravity: float) -> Law:
    from rimroll.bodies.body import Body

    return read_law(json.loads(table), Body(*body), gravity)


def _law_with(law: Law, key: str, values: Any) -> Law:
    """A law in which a number is an array."""
    table, dot, name = key.rpartition(".")
    if not dot:
        assert name in quantities_of(type(law))
        changes: Mapping[str, Any] = {name: values}
        return replace(law, **changes)
    kind = RESISTANCES[table]
    changed = tuple(
        replace(one, **{name: values}) if type(one) is kind else one for one in law.resistances
    )
    return replace(law, resistances=changed)


Array = NDArray[np.float64]

STATE = tuple(one.name for one in fields(State))
"""The names of the numbers of a start."""

STANDING = "standing"
"""The word for a start flat on the table, at rest."""


@dataclass(frozen=True, eq=False)
class StartRows:
    """The start of each of n rows."""

    numbers: Mapping[str, float | Array]
    """The fields of the state: one number for all rows, or (n,)."""
    friction_scale: Array | None = None
    """The factor on the law's friction (n,), if a hand releases the body."""
    hands: Sequence[Release] = ()
    """The hands, if any."""
    codes: Codes | None = None
    """The place of each row's hand (n,) in :attr:`hands`."""

    @property
    def stands(self) -> bool:
        """Whether all bodies stand flat on the table."""
        return isinstance(self.numbers["tilt"], float) and self.numbers["tilt"] == 0.0

    def state(self, rows: Codes) -> State:
        """The starts of some rows, each an array (n,) unless the bodies stand."""
        if self.stands:
            return State.computed(**{name: part(one, rows) for name, one in self.numbers.items()})
        shape = np.shape(rows)
        arrays = {
            name: np.broadcast_to(part(one, rows), shape) for name, one in self.numbers.items()
        }
        return State(**arrays)


def starts_of(start: Any, block: Block) -> StartRows:
    """The starts of a table, of the word ``standing``, and of what varies of them.

    Raises ``RimrollError`` as scenario files do.
    """
    if isinstance(start, str) and start != STANDING:
        raise RimrollError(f'must be a table or "{STANDING}", got {as_toml(start)}', "start")
    table = {STANDING: True} if start == STANDING else dict(start)
    stands = table.pop(STANDING, False)
    given = {key_in(one): one for one in block.of("start")}
    for name, one in given.items():
        table[name] = one.at(0)
    if not stands:
        numbers = checked(StartTable, table, "[start]", STANDING).model_dump()
    else:
        moving = [name for name in table if name not in ("yaw", "spin")]
        if moving:
            raise RimrollError(f"[start] a body that stands has no {moving[0]}: leave it out")
        numbers = checked(StartTable, {"tilt": 1.0, **table}, "[start]").model_dump()
        numbers["tilt"] = 0.0
    rows = numbers | {name: one.array for name, one in given.items()}
    if not stands:
        made("[start]", lambda: State(**rows))
    return StartRows(rows)


def releases_of(release: Any, block: Block, bodies: BodyRows, gravity: Array) -> StartRows:
    """The starts of a hand, described by a table or the name of a preset.

    ``gravity`` is that of each row (n,), m/s². Raises ``RimrollError`` for an unknown preset, and
    as ``Release`` does.
    """
    assert block.release is not None
    given = block.of("release")
    _, places = np.unique(gravity, return_inverse=True)
    rows, codes = distinct(block.count, [bodies.codes, places, *(one.codes for one in given)])
    numbers = np.empty((6, block.count))
    scale = np.empty(block.count)
    hands = []
    for code, row in enumerate(rows.tolist()):
        whole = {"preset": release} if isinstance(release, str) else dict(release)
        for one in given:
            key, value = key_in(one), one.at(row)
            if not key:
                whole = {"preset": value} if isinstance(value, str) else dict(value)
            else:
                whole = with_value(whole, key, value)
        body = tuple(vars(bodies.one(row)).values())
        hand = _read_release_once(json.dumps(whole, sort_keys=True), body, float(gravity[row]))
        hands.append(hand)
        here = codes == code if len(rows) > 1 else slice(None)
        state, scale[here] = hand.at(block.release[here])
        for k, name in enumerate(STATE):
            numbers[k, here] = getattr(state, name)
    return StartRows(dict(zip(STATE, numbers, strict=True)), scale, hands, codes)


@cache
def _release_table() -> type[Table]:
    """The table [release], with a field for each mean and each spread."""
    numbers = fields_of(releases.NUMBERS, dict.fromkeys(releases.NUMBERS))
    return create_model("release", __base__=Table, preset=(str | None, None), **numbers)


@lru_cache(maxsize=4096)
def _read_release_once(table: str, body: tuple[float, ...], gravity: float) -> Release:
    from rimroll.bodies.body import Body

    read = checked(_release_table(), json.loads(table), "[release]").model_dump(exclude_unset=True)
    preset, unsteadiness = read.pop("preset", None), read.pop("unsteadiness", 1.0)
    if preset is None:
        if "tilt" not in read:
            raise RimrollError(f"[release] lacks 'tilt', or 'preset': one of {', '.join(PRESETS)}")
        known: dict[str, Any] = {"tilt": (read["tilt"], 0.0)}
    else:
        known = vars(made("[release]", lambda: Release.named(preset, Body(*body), gravity)))
    pairs = {}
    for field in fields(Release):
        mean, spread = known.get(field.name, (1.0 if field.name == "friction_scale" else 0.0, 0.0))
        pairs[field.name] = (read.get(field.name, mean), read.get(field.name + SPREAD, spread))
    hand = made("[release]", lambda: Release(**pairs))
    return replace(hand) if unsteadiness == 1.0 else hand.with_unsteadiness(unsteadiness)


KEPT = 512
"""How many grounds of an earlier block are kept in memory."""


@dataclass(frozen=True, eq=False)
class GroundRows:
    """The ground of each of n rows, and the factor on its acceleration."""

    grounds: list[Ground]
    codes: Codes
    """The place of each row's ground (n,) in :attr:`grounds`."""
    scale: NDArray[np.float64]


class _Synthetic(Table):
    synthetic: Annotated[float, in_unit("1")]
    amplitude: Annotated[Any, in_three("m/s^2")]
    duration: Annotated[float, in_unit("s"), Field(gt=0.0)] = 20.0
    step: Annotated[float, in_unit("s")] = 0.01
    soil_period: Annotated[float, in_unit("s")] = 0.4
    soil_damping: Annotated[float, in_unit("1")] = 0.6
    rotation: Annotated[float, in_unit("rad")] = 0.0


def grounds_of(table: Any, block: Block, folder: Path, records: Mapping[str, str]) -> GroundRows:
    """The grounds of a table, or of the name of a record, and of what varies of them.

    Raises ``RimrollError`` as scenario files do, and for a record whose SHA-256 is no longer that
    in ``records``.
    """
    given = block.of("ground")
    scales = [one for one in given if key_in(one) == "scale"]
    others = [one for one in given if one not in scales]
    rows, codes = distinct(block.count, [one.codes for one in others])
    grounds, factors = [], []
    for row in rows.tolist():
        whole = _ground_table(table)
        for one in others:
            key, value = key_in(one), one.at(row)
            whole = with_value(whole, key, value) if key else whole | _ground_table(value)
        factors.append(_scale(whole.pop("scale", 1.0)))
        own = tuple((name, records[name]) for name in _names(whole))
        grounds.append(_read_ground_once(json.dumps(whole, sort_keys=True), str(folder), own))
    scale = np.array(factors)[codes]
    for one in scales:
        scale = scale * one.array
    made("[ground]", lambda: _expect_scale(scale))
    return GroundRows(grounds, codes, scale)


def records_of(tables: Iterable[Any], folder: Path) -> dict[str, str]:
    """The SHA-256 of each record that tables name, by its name there.

    Raises ``RimrollError`` for a record that cannot be read.
    """
    names = {name for table in tables for name in _names(_ground_table(table))}
    return {name: _sha256(folder / name) for name in sorted(names)}


def _names(table: Mapping[str, Any]) -> list[str]:
    names = table.get("record", [])
    return list(map(str, [names] if isinstance(names, str) else names))


def _sha256(file: Path) -> str:
    try:
        return hashlib.sha256(file.read_bytes()).hexdigest()
    except OSError as error:
        raise RimrollError(f"cannot read {file}: {error.strerror}") from None


def _ground_table(ground: Any) -> dict[str, Any]:
    if isinstance(ground, str | list):
        return {"record": ground}
    if not isinstance(ground, Mapping):
        raise RimrollError(f"must be a table or a record, got {as_toml(ground)}", "ground")
    return dict(ground)


def _expect_scale(scale: NDArray[np.float64]) -> None:
    within = (scale >= 1.0 / MAX_FACTOR) & (scale <= MAX_FACTOR)
    hold("scale", scale, within, "between 1e-6 and 1e6")


def _scale(value: Any) -> float:
    read = checked(_Scale, {"scale": value}, "[ground]").scale
    return float(read)


class _Scale(Table):
    scale: Annotated[float, in_unit("1")]


@lru_cache(maxsize=KEPT)
def _read_ground_once(table: str, folder: str, records: tuple[tuple[str, str], ...]) -> Ground:
    content = json.loads(table)
    if "synthetic" not in content:
        ground = read_ground(content, Path(folder))
        for name, sha256 in records:  # after it was read: before, it could change in between
            if _sha256(Path(folder) / name) != sha256:
                raise RimrollError(f"{Path(folder) / name} has changed since the study was planned")
        return ground
    read = checked(_Synthetic, content, "[ground]").model_dump()
    seed, turn = read.pop("synthetic"), read.pop("rotation")
    if not float(seed).is_integer():
        raise RimrollError(f"[ground] synthetic must be a seed, a whole number, got {seed:g}")
    ground = made("[ground]", lambda: synthetic(int(seed), **read))
    return ground.rotated(turn) if turn else ground


MAX_FALLS = 100_000
MIN_FALLS = 3


USUAL = {"falls": 42.0, "reading_error": math.radians(2.0), "bias": math.radians(2.0)}
"""The experiment of the paper."""

FitTable = create_model("fit", __base__=Table, **fields_of(OF_FIT, USUAL))


def experiments_of(table: Mapping[str, Any], block: Block) -> dict[str, Array]:
    """The number of falls, the error of reading and the standard deviation of the bias (rad).

    Raises ``RimrollError`` for fewer than 3 falls or more than 100 000, and for negative errors.
    """
    read = checked(FitTable, dict(table), "[fit]").model_dump()
    found = {name: np.full(block.count, value) for name, value in read.items()}
    for one in block.of("fit"):
        found[key_in(one)] = one.array
    made("[fit]", lambda: _check_experiments(found))
    return found


def _check_experiments(found: Mapping[str, Array]) -> None:
    falls = found["falls"]
    whole = (falls >= MIN_FALLS) & (falls <= MAX_FALLS) & (falls == np.floor(falls))
    hold("falls", falls, whole, f"whole, between {MIN_FALLS} and {MAX_FALLS}")
    for name in ("reading_error", "bias"):
        hold(name, found[name], found[name] >= 0.0, ">= 0", "rad")
