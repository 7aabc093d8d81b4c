"""Tables by name: the dry friction of a metal rim on them, and that of stone on stone.

Typical values, to one digit: a film of grease, dust or water changes them by a factor of two, so
measure yours. They are coefficients of sliding, and of sticking too unless ``static`` is given:
handbooks list sticking a quarter to two thirds above sliding. Whether the paper's can rolls through
its near-collision hangs on μ* = 0.356 (:func:`rimroll.needed_friction`): on wood it slips there, on
rubber not.

>>> from rimroll import surfaces
>>> surfaces.wood(static=0.5)
Coulomb(friction=0.3, static=0.5)
"""

from __future__ import annotations

from collections.abc import Callable

from rimroll.errors import choose
from rimroll.laws import Coulomb


def ice(static: float | None = None, restitution: float = 0.0) -> Coulomb:
    """Ice near its melting point: 0.03.

    Source: OpenStax, University Physics 1, Table 6.1, has 0.02 for steel on ice and 0.03 for ice on
    ice; handbooks give brass 0.02 at 0 °C and 0.15 at −80 °C.
    """
    return Coulomb(0.03, static, restitution)


def teflon(static: float | None = None, restitution: float = 0.0) -> Coulomb:
    """PTFE: 0.04, sliding and sticking.

    Source: steel on PTFE in OpenStax, University Physics 1, Table 6.1, and in most handbooks.
    """
    return Coulomb(0.04, static, restitution)


def wood(static: float | None = None, restitution: float = 0.0) -> Coulomb:
    """A dry wooden table: 0.3.

    Source: metal on wood in OpenStax, University Physics 1, Table 6.1, which has 0.5 for sticking;
    handbooks give 0.2 to 0.6 for clean dry metals on wood.
    """
    return Coulomb(0.3, static, restitution)


def steel(static: float | None = None, restitution: float = 0.0) -> Coulomb:
    """Dry mild steel under aluminium: 0.47.

    Source: aluminium on mild steel in Serway & Jewett, Physics, table of coefficients of friction,
    which has 0.61 for sticking.
    """
    return Coulomb(0.47, static, restitution)


def glass(static: float | None = None, restitution: float = 0.0) -> Coulomb:
    """Clean dry glass: 0.5.

    Source: handbooks give 0.5 to 0.7 for metal on clean glass, copper 0.53 sliding and 0.68
    sticking.
    """
    return Coulomb(0.5, static, restitution)


def stone(static: float | None = None, restitution: float = 0.0) -> Coulomb:
    """Stone on stone, dry and flat, as a column on its base: 0.65.

    Source: the basic friction angles of dry limestone, 31° to 37°, and granite, 31° to 35° (Barton
    & Choubey, Rock Mechanics 10, 1977, as tabulated by Wang, Mechanics of Asphalt, table 2.5); wet
    ones are up to 4° lower.
    """
    return Coulomb(0.65, static, restitution)


def rubber(static: float | None = None, restitution: float = 0.0) -> Coulomb:
    """A rubber mat: 0.8.

    Source: textbooks give rubber on dry solids 0.7 (OpenStax, University Physics 1, Table 6.1, on
    concrete) to 0.8 (Serway & Jewett, Physics), 1.0 for sticking.
    """
    return Coulomb(0.8, static, restitution)


SURFACES: dict[str, Callable[..., Coulomb]] = {
    "ice": ice,
    "teflon": teflon,
    "wood": wood,
    "steel": steel,
    "glass": glass,
    "stone": stone,
    "rubber": rubber,
}
"""The surfaces by name, from slippery to grippy."""


def by_name(name: str, static: float | None = None, restitution: float = 0.0) -> Coulomb:
    """The surface of that name; raises ``RimrollError`` with the nearest name if there is none."""
    return choose("surface", name, SURFACES)(static, restitution)
