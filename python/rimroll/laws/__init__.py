"""The contact laws: how the rim meets the table, and the resistances to its motion.

>>> import rimroll as rr
>>> rr.Coulomb(0.3) + rr.RollingResistance(dry=1e-3)
Coulomb(friction=0.3) + RollingResistance(dry=0.001)
"""

from rimroll.laws.friction import (
    IDEAL,
    Coulomb,
    Frictionless,
    InPlace,
    NoSlip,
    Stribeck,
    Tabulated,
    Viscous,
    has_one_limit,
    ideal,
)
from rimroll.laws.law import (
    LAWS,
    Law,
    by_name,
    contact_law,
    kind,
    law_of,
    one_law,
)
from rimroll.laws.parameters import OneLaw, in_brief
from rimroll.laws.resistances import AirDrag, PivotingFriction, Resistance, RollingResistance

__all__ = [
    "IDEAL",
    "LAWS",
    "AirDrag",
    "Coulomb",
    "Frictionless",
    "InPlace",
    "Law",
    "NoSlip",
    "OneLaw",
    "PivotingFriction",
    "Resistance",
    "RollingResistance",
    "Stribeck",
    "Tabulated",
    "Viscous",
    "by_name",
    "contact_law",
    "has_one_limit",
    "ideal",
    "in_brief",
    "kind",
    "law_of",
    "one_law",
]
