"""The list of laws that the core computes, and the two with closed forms."""

from __future__ import annotations

from rimroll import _core
from rimroll.errors import RimrollError
from rimroll.laws.coulomb import Coulomb
from rimroll.laws.ideal import Frictionless, NoSlip
from rimroll.laws.in_place import InPlace
from rimroll.laws.law import LAWS, Law, contact_law
from rimroll.laws.stribeck import Stribeck
from rimroll.laws.tabulated import Tabulated
from rimroll.laws.viscous import Viscous

LAWS |= {
    law.name: law for law in (NoSlip, Frictionless, InPlace, Coulomb, Viscous, Stribeck, Tabulated)
}

assert list(LAWS) == list(_core.LAWS)

IDEAL: tuple[Law, ...] = (NoSlip(), Frictionless())
"""The paper's two laws, for which there are closed forms."""


def has_one_limit(law: Law) -> bool:
    """Whether the limiting turn is a closed form that holds for every arrival without spin."""
    return isinstance(law, NoSlip | Frictionless | InPlace)


def ideal(law: object) -> Law:
    """The law, if it is one of the two with closed forms; else ``RimrollError``."""
    law = contact_law(law)
    if type(law) not in map(type, IDEAL):
        raise RimrollError(field="law", value=law, bound="NoSlip or Frictionless for a closed form")
    return law
