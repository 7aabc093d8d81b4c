"""Wobbling in place: the law of free-standing columns in many studies of earthquakes."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from rimroll.laws.law import Law


@dataclass(frozen=True, repr=False, eq=False)
class InPlace(Law):
    """Wobbling in place: the rim rolls without slip on the circle on which the body stood, θ = −ψ.

    The table exerts a twisting moment, too, as large as it takes, so that the body does not roll
    away. The spin rate of a start must be 0 or minus the yaw rate; the motion has the latter. On a
    table at rest the angular momentum of the yaw is conserved. The limiting turn is that without
    slip. A motion ends where the table would have to pull the rim down.

    Source: M. F. Vassiliou et al., Earthquake Eng. Struct. Dyn. 46 (2017) 2261.
    """

    name: ClassVar[str] = "in_place"
    color: ClassVar[str] = "#332288"
    marker: ClassVar[str] = "X"
    can_stick: ClassVar[bool] = True
