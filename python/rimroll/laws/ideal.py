"""The paper's two laws."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from rimroll.laws.law import Law


@dataclass(frozen=True, repr=False, eq=False)
class NoSlip(Law):
    """Rolling without slip: the point of the rim that touches the table is at rest.

    Source: the paper, Eqs. ``noslip_eqs`` and appendix A. A motion ends where the table would have
    to pull the rim down.
    """

    name: ClassVar[str] = "no_slip"
    color: ClassVar[str] = "#0072B2"
    marker: ClassVar[str] = "o"
    can_stick: ClassVar[bool] = True


@dataclass(frozen=True, repr=False, eq=False)
class Frictionless(Law):
    """Sliding without friction: the table only pushes upward.

    Source: the paper, Eqs. ``nofric_eqs`` and appendix A. The centre of mass moves only vertically.
    A motion ends where the table would have to pull the rim down.
    """

    name: ClassVar[str] = "frictionless"
    color: ClassVar[str] = "#D55E00"
    marker: ClassVar[str] = "s"
