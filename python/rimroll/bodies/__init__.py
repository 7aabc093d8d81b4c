"""Everyday bodies.

Each says where its numbers come from. Those made from nominal sizes are typical of their kind, not
of one specimen: weigh and measure yours, or compose it with :mod:`rimroll.bodies.solids`.
"""

from __future__ import annotations

from collections.abc import Callable

from rimroll import _core
from rimroll.bodies.body import Body
from rimroll.bodies.solids import filling
from rimroll.errors import RimrollError, choose
from rimroll.units import Number, number, positive

WATER = 1000.0
"""The density of water, kg/m³."""


def can_2007() -> Body:
    """The can of Srinivasan & Ruina: m = 70 g, R = 5.1 cm, H = 6.9 cm, A/m = 5.13e-3 m².

    Source: the paper's section "Quantitative comparisons". C/m = 2.0e-3 m² and not the 8e-3 of its
    simulation figure, which no can inside its own rim can have (C/m ≤ R² = 2.6e-3 m²); a wall with
    two disks of that size has 1.3e-3 to 2.2e-3. No limiting angle depends on C.
    """
    return _preset("can_2007")


def soda_can(fill: Number = 0.0) -> Body:
    """A 330 ml aluminium drinks can, filled to a part between 0 (empty) and 1.

    Derived from nominal sizes: body 66 mm across, 115 mm high, wall 0.10 mm; base 0.30 mm at 5 mm
    over a rim 48 mm across; lid 0.25 mm, 52 mm across; aluminium 2700 kg/m³: 10.6 g empty. The
    drink is water, 97 mm deep when full. In motions it is frozen; see
    :func:`rimroll.balance_tilt` for the balance of the liquid.
    """
    part = _part(fill)
    return _filled(_preset("soda_can", part), 0.033, 0.097 * part, 0.005, 0.110)


def beer_bottle(fill: Number = 0.0) -> Body:
    """A 330 ml long-neck glass bottle, its body filled to a part between 0 (empty) and 1.

    Derived from nominal sizes: body 61 mm across and 130 mm high, wall 2.2 mm; shoulder and neck as
    a wall 100 mm long, 30 mm across, 2.8 mm thick; base 6 mm on a rim 52 mm across; glass
    2500 kg/m³: 0.23 kg empty. The beer is water. In motions it is frozen; see
    :func:`rimroll.balance_tilt` for the balance of the liquid, which stays below the shoulder.
    """
    part = _part(fill)
    return _filled(_preset("beer_bottle", part), 0.0283, 0.124 * part, 0.006, 0.124)


def coin() -> Body:
    """A 1 euro coin as a uniform cylinder: 7.5 g, 23.25 mm across, 2.33 mm thick.

    Source: European Central Bank, technical specifications of the euro coins.
    """
    return _preset("coin")


def battery() -> Body:
    """An AA cell as a uniform cylinder: 23 g, 14.5 mm across, 50.5 mm long.

    Source: the largest size that IEC 60086-2 allows for LR6; the mass is typical of alkaline cells.
    """
    return _preset("battery")


def ring(radius: Number = 0.3) -> Body:
    """A thin ring of mass 1 kg, such as the rim of a bicycle wheel: H = 0, C = mR², A = C/2."""
    return _preset("ring", number("radius", radius, "m"))


def disk(radius: Number) -> Body:
    """A uniform thin disk of mass 1 kg: H = 0, C = mR²/2, A = C/2. No turn depends on its mass."""
    return _preset("disk", number("radius", radius, "m"))


def euler_disk() -> Body:
    """Euler's disk, the toy: a steel cylinder 75 mm across and 12.7 mm thick, 0.44 kg.

    Derived from these sizes and 7850 kg/m³; it stands on the rim of one face, H = 6.35 mm. For the
    paper's ideal disk, H = 0, use :func:`disk`.
    """
    return _preset("euler_disk")


def cylinder(
    radius: Number, length: Number, mass: Number | None = None, density: Number | None = None
) -> Body:
    """A uniform solid cylinder (m): H = L/2, A = m(R²/4 + L²/12), C = mR²/2.

    Its mass (kg) or its density (kg/m³), not both, may be given, else it has the density of water.
    Granite, limestone and marble have some 2700 kg/m³.
    """
    radius, length = number("radius", radius, "m"), number("length", length, "m")
    body = _preset("cylinder", radius, length)
    if mass is None and density is None:
        return body
    if mass is not None and density is not None:
        raise RimrollError("mass and density both say how heavy the cylinder is: give one")
    if density is not None:
        factor = positive("density", density, "kg/m^3") / WATER
    else:
        factor = positive("mass", mass, "kg") / body.mass
    numbers = (factor * body.mass, radius, body.height)
    return Body(*numbers, factor * body.transverse_inertia, factor * body.axial_inertia)


def _preset(name: str, *sizes: float) -> Body:
    """The body of the core's preset of that name."""
    return Body(*_core.preset(name, sizes))


def _filled(body: Body, radius: float, depth: float, base: float, length: float) -> Body:
    """A body that contains this depth of water in a round vessel (m)."""
    return body.with_filling(filling(1000.0, radius, depth, base, length)) if depth else body


def _part(fill: Number) -> float:
    """A part that is filled, with a hint for users who meant percent."""
    part = number("fill", fill)
    if 2.0 <= part <= 100.0:
        percent = f'for percent write {part / 100.0:g} or "{part:g} %"'
        raise RimrollError(field="fill", value=part, bound="between 0 and 1", hint=f": {percent}")
    return part


PRESETS: dict[str, Callable[[], Body]] = {
    "can_2007": can_2007,
    "soda_can": soda_can,
    "beer_bottle": beer_bottle,
    "coin": coin,
    "battery": battery,
    "ring": ring,
    "euler_disk": euler_disk,
}
"""The bodies without parameters, by name."""


def by_name(name: str) -> Body:
    """The preset of that name; ``-`` may stand for ``_``.

    Raises ``RimrollError`` with the nearest name, and listing all, when there is none such.
    """
    return choose("body", name, PRESETS)()
