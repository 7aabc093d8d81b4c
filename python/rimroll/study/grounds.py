"""The motions of the ground of the rows of a study: records, pulses, synthetic records."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from typing import Annotated, Any

import numpy as np
from numpy.typing import NDArray
from pydantic import Field

from rimroll.errors import RimrollError, hold
from rimroll.ground import synthetic
from rimroll.ground.ground import MAX_FACTOR, Ground
from rimroll.scenario.tables import Table, as_toml, checked, in_three, in_unit, made, read_ground
from rimroll.study.given import Block, Codes, distinct, key_in, with_value

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
        whole = _as_table(table)
        for one in others:
            key, value = key_in(one), one.at(row)
            whole = with_value(whole, key, value) if key else whole | _as_table(value)
        factors.append(_scale(whole.pop("scale", 1.0)))
        own = tuple((name, records[name]) for name in _names(whole))
        grounds.append(_read_once(json.dumps(whole, sort_keys=True), str(folder), own))
    scale = np.array(factors)[codes]
    for one in scales:
        scale = scale * one.array
    made("[ground]", lambda: _expect_scale(scale))
    return GroundRows(grounds, codes, scale)


def records_of(tables: Iterable[Any], folder: Path) -> dict[str, str]:
    """The SHA-256 of each record that tables name, by its name there.

    Raises ``RimrollError`` for a record that cannot be read.
    """
    names = {name for table in tables for name in _names(_as_table(table))}
    return {name: _sha256(folder / name) for name in sorted(names)}


def _names(table: Mapping[str, Any]) -> list[str]:
    names = table.get("record", [])
    return list(map(str, [names] if isinstance(names, str) else names))


def _sha256(file: Path) -> str:
    try:
        return hashlib.sha256(file.read_bytes()).hexdigest()
    except OSError as error:
        raise RimrollError(f"cannot read {file}: {error.strerror}") from None


def _as_table(ground: Any) -> dict[str, Any]:
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
def _read_once(table: str, folder: str, records: tuple[tuple[str, str], ...]) -> Ground:
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
