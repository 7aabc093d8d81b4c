"""The outcomes of one flick on several tables."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import asdict, dataclass, replace
from typing import Any

from rimroll.cli.request import Request
from rimroll.cli.turn import Limit, limit_of
from rimroll.errors import RimrollError, choose, typed
from rimroll.laws import (
    IDEAL,
    Coulomb,
    Frictionless,
    InPlace,
    Law,
    NoSlip,
    Tabulated,
    in_brief,
    surfaces,
)
from rimroll.motion import Motion, Turn, simulate
from rimroll.units import quantity

IDEALS: dict[str, Law] = {typed(law.name): law for law in IDEAL}
"""The laws that need no number: a table, too."""

USUAL = "ice,wood,rubber"
"""The tables that are compared unless others are given."""

FILE = "file"
"""The name of the table of a scenario file."""

_NUMBER = re.compile(r"[+-]?(\.?\d|nan|inf)", re.IGNORECASE)


@dataclass(frozen=True)
class Outcome:
    """A table by its name, the limit on it as the body arrives there, and the motion on it."""

    name: str
    limit: Limit
    motion: Motion

    @property
    def friction(self) -> float | None:
        """The coefficient of friction; None where no single number bounds it."""
        law = self.motion.law
        if isinstance(law, Coulomb):
            return law.friction
        return 0.0 if isinstance(law, Frictionless) else None

    @property
    def friction_in_words(self) -> str:
        """The coefficient of friction, ``any`` where nothing bounds it."""
        if self.friction is not None:
            return f"{self.friction:g}"
        law = self.motion.law
        if isinstance(law, Tabulated):
            return in_brief(tuple(law.frictions))
        return "any" if isinstance(law, NoSlip | InPlace) else typed(law.name)

    @property
    def turn(self) -> Turn | None:
        """The first turn, from the release."""
        return self.motion.turns[0] if self.motion.turns else None

    @property
    def slips_while_tipping(self) -> bool | None:
        """Whether the rim slips before the near-collision; None where there is none."""
        arrival, law = self.limit.arrival, self.motion.law
        if arrival is None:
            return None
        if isinstance(law, Frictionless):
            return True
        holds = _static_friction(law)
        breaks = holds is not None and arrival.friction_ratio > holds * (1.0 - 1e-9)
        return breaks or arrival.slip != 0.0

    @property
    def slips(self) -> bool:
        """Whether the rim slips anywhere up to the first tilt maximum."""
        phases = self.motion.phases
        return any(phase.kind == "sliding" and phase.start < self._until for phase in phases)

    @property
    def lost(self) -> float:
        """The part of :attr:`energy_available` that is lost up to the first tilt maximum."""
        lost = self.motion.energy[0] - self.motion.evaluate(self._until).energy[0]
        return float(lost / self.energy_available)

    @property
    def energy_available(self) -> float:
        """The energy at the start, counted from the lowest potential energy of the motion, J.

        This is the energy of standing upright, or less if the body comes down lower; no loss
        exceeds it.
        """
        t = self.motion.t
        passed = self.motion.potential_energy[t <= self._until]
        end = self.motion.evaluate(self._until).potential_energy[0]
        return float(self.motion.energy[0] - min(end, passed.min(initial=0.0)))

    @property
    def _until(self) -> float:
        """The time of the first tilt maximum, or of the end, s."""
        return self.turn.end if self.turn else float(self.motion.t[-1])

    def answer(self) -> dict[str, Any]:
        """The outcome as plain numbers, SI units and radians."""
        limit = self.limit
        return {
            "table": self.name,
            "friction": self.friction,
            "parameters": self.motion.parameters(),
            "turn_limit": limit.from_start,
            "why_no_limit": limit.why_not or None,
            "arrival": None if limit.arrival is None else asdict(limit.arrival),
            "slips_while_tipping": self.slips_while_tipping,
            "slips": self.slips,
            "turn": None if self.turn is None else asdict(self.turn),
            "energy_at_start": float(self.motion.energy[0]),
            "energy_available": self.energy_available,
            "energy_lost_fraction": self.lost,
            "status": self.motion.status,
            "message": self.motion.message,
            "t": float(self.motion.t[-1]),
        }


def _static_friction(law: Law) -> float | None:
    """The coefficient of friction of a rim that sticks; None where no coefficient bounds it."""
    match law:
        case Coulomb(friction=sliding, static=static):
            return float(sliding if static is None else static)
        case Tabulated(frictions=frictions, static=static):
            return float(frictions[0] if static is None else static)
        case _:
            return None


def tables(text: str | None, restitution: float, of_file: Law | None = None) -> dict[str, Law]:
    """The tables of a list such as ``ice,wood,0.5,no-slip``, by name.

    ``of_file`` is the law of a scenario file, which the list calls ``file``. Without a list they
    are :data:`USUAL` and that of the file.

    Raises ``RimrollError`` for what is neither a surface nor a coefficient of friction.
    """
    if text is None:
        usual = tables(USUAL, restitution)
        if of_file is None or of_file in usual.values():
            return usual
        return {**usual, FILE: of_file}
    found: dict[str, Law] = {}
    for item in text.split(","):
        name = item.strip()
        if name == FILE and of_file is None:
            raise RimrollError(f"--on {FILE} is the law of a scenario file: name one (.toml)")
        law = of_file if name == FILE and of_file else _table(name, restitution)
        if law in found.values():
            raise RimrollError(f"--on has {name!r} twice")
        found[name] = law
    return found


def _table(name: str, restitution: float) -> Law:
    if not name:
        raise RimrollError("--on must be a list such as ice,wood,0.5, got a gap in it")
    if _NUMBER.match(name):
        return Coulomb(quantity(name, "1", "--on"), restitution=restitution)
    known: dict[str, Callable[[], Law]] = {
        **{other: lambda law=law: law for other, law in IDEALS.items()},  # type: ignore[misc]
        **{
            other: lambda make=make: make(restitution=restitution)  # type: ignore[misc]
            for other, make in surfaces.SURFACES.items()
        },
    }
    return choose("surface", name, known)()


def outcome(what: Request, name: str, law: Law) -> Outcome:
    """The outcome of a flick on a table."""
    assert what.start is not None
    law = replace(law, resistances=what.law.resistances)
    motion = simulate(what.body, what.start, law, options=what.options)
    return Outcome(name, limit_of(what, law), motion)
