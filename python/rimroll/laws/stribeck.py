"""Regularised dry friction."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from rimroll.given import Values
from rimroll.laws.law import Law
from rimroll.laws.parameters import Parameter
from rimroll.laws.resistances import Resistances
from rimroll.laws.shared import FRICTION, RESTITUTION, STATIC


@dataclass(frozen=True, repr=False, eq=False)
class Stribeck(Law):
    """Regularised dry friction: T = −μ(u) N u/√(u² + creep_speed²).

    μ(u) = friction + (static − friction) exp(−(u/stribeck_speed)²). Without ``static`` it is
    the regularised Coulomb friction of most physics engines: the rim creeps where it should stick.
    Speeds are in m/s. Source of the curve: Armstrong-Hélouvry, Dupont & Canudas de Wit,
    Automatica 30 (1994).
    """

    name: ClassVar[str] = "stribeck"
    color: ClassVar[str] = "#009E73"
    marker: ClassVar[str] = "^"

    friction: float = FRICTION.field()
    static: float | None = STATIC.field(None)
    stribeck_speed: float = Parameter(
        "m/s", help="For stribeck: slip speed at which static friction fades. [1 cm/s]"
    ).field(0.01)
    creep_speed: float = Parameter(
        "m/s", help="For stribeck: slip speed up to which the rim creeps. [1 mm/s]"
    ).field(1e-3)
    restitution: float = RESTITUTION.field(0.0)

    if TYPE_CHECKING:

        def __init__(
            self,
            friction: Values,
            static: Values | None = None,
            stribeck_speed: Values = 0.01,
            creep_speed: Values = 1e-3,
            restitution: Values = 0.0,
            *,
            resistances: Resistances = (),
        ) -> None: ...
