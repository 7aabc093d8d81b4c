"""What a scenario file holds, and the words for it."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from rimroll import bodies
from rimroll.bodies.body import Body
from rimroll.errors import RimrollError
from rimroll.laws import (
    AirDrag,
    Law,
    PivotingFriction,
    Resistance,
    RollingResistance,
)
from rimroll.options import Options
from rimroll.state import State
from rimroll.units import quantity

if TYPE_CHECKING:
    from rimroll.ground.ground import Ground

AFTER = 10.0
"""How long a motion is followed after the end of the ground unless its duration is given, s."""

MAX_STEPS = 2_000_000_000
"""The upper bound of max_steps: the largest number that the files of a motion can hold."""


@dataclass(frozen=True)
class Scenario:
    """The content of a scenario file. ``start`` is None if it only describes a body."""

    body: Body
    start: State | None
    law: Law
    options: Options
    ground: Ground | None = None
    has_duration: bool = False
    """Whether the file gives the duration, which else is 10 s longer than that of a ground."""


def presets() -> dict[str, Callable[..., Body]]:
    """All presets by name: those without parameters, and those that need a size."""
    return {**bodies.PRESETS, "disk": bodies.disk, "cylinder": bodies.cylinder}


RESISTANCES: dict[str, type[Resistance]] = {
    "rolling_resistance": RollingResistance,
    "pivoting_friction": PivotingFriction,
    "air_drag": AirDrag,
}
"""The resistances that can be added to a law, by the name of their table."""

FILM = "film"
"""The word for the air drag of Moffatt's viscous film under the body."""


def resistance(
    kind: type[Resistance],
    given: Mapping[str, Any],
    body: Body,
    gravity: float,
    called: Callable[[str], str] = str,
) -> Resistance:
    """A resistance from its numbers as a file or options give them.

    ``called`` says what errors call a number. Raises ``RimrollError`` naming the number that is at
    fault.
    """
    if given.get("coefficient") == FILM:
        if "exponent" in given:
            raise RimrollError(f"a film has its own exponent, 4: leave out {called('exponent')}")
        return AirDrag.film(body.radius, gravity=gravity)
    numbers: dict[str, float] = {}
    for name in sorted(given, reverse=True):  # the unit of a coefficient depends on the exponent
        numbers[name] = quantity(given[name], kind.unit_of(name, numbers), called(name))
    return kind(**numbers)
