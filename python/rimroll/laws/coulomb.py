"""Dry friction."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from rimroll.given import Values
from rimroll.laws.law import Law
from rimroll.laws.resistances import Resistances
from rimroll.laws.shared import FRICTION, RESTITUTION, STATIC


@dataclass(frozen=True, repr=False, eq=False)
class Coulomb(Law):
    """Dry friction, with exact phases of rolling, sliding and flight.

    The rim rolls while |T| ≤ ``static`` · N. Then it slips with |T| = ``friction`` · N against the
    slip, and rolls again when the slip stops and friction can hold it. ``static`` is by default
    ``friction``, and must not be smaller. The rim leaves the table where the normal force reaches
    zero. It lands with the energetic coefficient of ``restitution``, 0 to 1, and with ``friction``
    in the impulse, whether it slips or sticks.
    """

    name: ClassVar[str] = "coulomb"
    color: ClassVar[str] = "#CC79A7"
    marker: ClassVar[str] = "D"
    can_stick: ClassVar[bool] = True

    friction: float = FRICTION.field()
    static: float | None = STATIC.field(None)
    restitution: float = RESTITUTION.field(0.0)

    if TYPE_CHECKING:

        def __init__(
            self,
            friction: Values,
            static: Values | None = None,
            restitution: Values = 0.0,
            *,
            resistances: Resistances = (),
        ) -> None: ...
