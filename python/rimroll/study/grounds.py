"""The motions of the ground of the rows of a study: records, pulses, synthetic records."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Iterator, Mapping
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


def grounds_of(table: Any, block: Block, folder: Path) -> GroundRows:
    """The grounds of a table, or of the name of a record, and of what varies of them.

    Raises ``RimrollError`` as scenario files do.
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
        grounds.append(_read_once(json.dumps(whole, sort_keys=True), str(folder)))
    scale = np.array(factors)[codes]
    for one in scales:
        scale = scale * one.array
    made("[ground]", lambda: _expect_scale(scale))
    return GroundRows(grounds, codes, scale)


def records_of(tables: Iterator[Any], folder: Path) -> dict[str, str]:
    """The SHA-256 of each record that tables name, by its name there.

    Raises ``RimrollError`` for a record that cannot be read.
    """
    found: dict[str, str] = {}
    for table in tables:
        names = _as_table(table).get("record", [])
        for name in [names] if isinstance(names, str) else names:
            try:
                found[str(name)] = hashlib.sha256((folder / name).read_bytes()).hexdigest()
            except OSError as error:
                raise RimrollError(f"cannot read {folder / name}: {error.strerror}") from None
    return dict(sorted(found.items()))


def _as_table(ground: Any) -> dict[str, Any]:
    if isinstance(ground, str | list):
        return {"record": ground}
    if not isinstance(ground, Mapping):
        raise RimrollError(f"ground must be a table or a record, got {as_toml(ground)}")
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
def _read_once(table: str, folder: str) -> Ground:
    content = json.loads(table)
    if "synthetic" not in content:
        return read_ground(content, Path(folder))
    read = checked(_Synthetic, content, "[ground]").model_dump()
    seed, turn = read.pop("synthetic"), read.pop("rotation")
    if not float(seed).is_integer():
        raise RimrollError(f"[ground] synthetic must be a seed, a whole number, got {seed:g}")
    ground = made("[ground]", lambda: synthetic(int(seed), **read))
    return ground.rotated(turn) if turn else ground
