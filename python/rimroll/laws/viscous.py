"""Friction of a film of oil."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from rimroll.given import Values
from rimroll.laws.law import Law
from rimroll.laws.parameters import Parameter
from rimroll.laws.resistances import Resistances
from rimroll.laws.shared import RESTITUTION


@dataclass(frozen=True, repr=False, eq=False)
class Viscous(Law):
    """A film of oil: T = −``coefficient`` (N s/m) times the slip, for any normal force.

    In the limit of a near-collision, which takes no time, it has no effect. The rim flies and lands
    as under :class:`Coulomb`, but without friction in the impulse.
    """

    name: ClassVar[str] = "viscous"
    color: ClassVar[str] = "#E69F00"
    marker: ClassVar[str] = "v"

    coefficient: float = Parameter(
        "N s/m",
        "viscous_coefficient",
        'For viscous: friction over slip speed, such as "0.5 N s/m".',
    ).field()
    restitution: float = RESTITUTION.field(0.0)

    if TYPE_CHECKING:

        def __init__(
            self,
            coefficient: Values,
            restitution: Values = 0.0,
            *,
            resistances: Resistances = (),
        ) -> None: ...
