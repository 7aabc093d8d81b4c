"""Bodies, starts, laws and grounds of a block of rows, in calls that the core takes."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from rimroll.body import Body
from rimroll.experiment.release import Release
from rimroll.ground.ground import Ground
from rimroll.laws import Law
from rimroll.options import FlatLanding, Options
from rimroll.scenario.tables import SimulationTable, checked, made, read_flat
from rimroll.state import State
from rimroll.study.bodies import BodyRows, bodies_of
from rimroll.study.experiments import experiments_of
from rimroll.study.given import Block, Codes, distinct, key_in
from rimroll.study.grounds import GroundRows, grounds_of
from rimroll.study.laws import LawRows, laws_of
from rimroll.study.starts import StartRows, releases_of, starts_of

if TYPE_CHECKING:
    from rimroll.study.description import Description

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
    def of(cls, description: Description, block: Block, defaults: Options) -> Cases:
        """The cases of a block; raises ``RimrollError`` for what scenario files may not say."""
        tables = description.tables
        options, codes = _options_of(tables["simulation"], block, defaults)
        gravity = np.array([one.gravity for one, _, _ in options])[codes]
        bodies = bodies_of(tables["body"], block)
        grounds = None
        if tables["ground"] is not None:
            grounds = grounds_of(tables["ground"], block, description.folder, description.records)
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
