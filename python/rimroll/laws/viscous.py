"""Friction of a film of oil."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from rimroll.given import Values
from rimroll.laws.law import Law
from rimroll.laws.resistances import Resistances


@dataclass(frozen=True, repr=False, eq=False)
class Viscous(Law):
    """A film of oil: T = −``coefficient`` (N s/m) times the slip, whatever the normal force.

    In the limit of a near-collision, which takes no time, it has no effect. The rim flies and lands
    as under :class:`Coulomb`, but without friction in the impulse.
    """

    coefficient: float
    restitution: float = 0.0
    name: ClassVar[str] = "viscous"

    if TYPE_CHECKING:

        def __init__(
            self,
            coefficient: Values,
            restitution: Values = 0.0,
            *,
            resistances: Resistances = (),
        ) -> None: ...
