"""The starts of the rows of a study: given, or those of a hand."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, fields, replace
from functools import cache, lru_cache
from typing import Annotated, Any

import numpy as np
from numpy.typing import NDArray
from pydantic import create_model

from rimroll.errors import RimrollError
from rimroll.experiment.release import PRESETS, Release
from rimroll.scenario.tables import StartTable, Table, as_toml, checked, in_unit, made
from rimroll.state import State
from rimroll.study.bodies import BodyRows
from rimroll.study.given import Block, Codes, distinct, key_in, part, with_value
from rimroll.study.targets import SPREAD, targets

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
        hand = _read_once(json.dumps(whole, sort_keys=True), body, float(gravity[row]))
        hands.append(hand)
        here = codes == code if len(rows) > 1 else slice(None)
        state, scale[here] = hand.at(block.release[here])
        for k, name in enumerate(STATE):
            numbers[k, here] = getattr(state, name)
    return StartRows(dict(zip(STATE, numbers, strict=True)), scale, hands, codes)


@cache
def _table() -> type[Table]:
    """The table [release], with a field for each mean and each spread."""
    numbers: dict[str, Any] = {
        name.partition(".")[2]: (Annotated[float | None, in_unit(str(unit))], None)
        for name, unit in targets().items()
        if name.startswith("release.") and unit is not None
    }
    return create_model("release", __base__=Table, preset=(str | None, None), **numbers)


@lru_cache(maxsize=4096)
def _read_once(table: str, body: tuple[float, ...], gravity: float) -> Release:
    from rimroll.body import Body

    read = checked(_table(), json.loads(table), "[release]").model_dump(exclude_unset=True)
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
