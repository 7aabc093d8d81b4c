"""Solids of revolution, and boxes taken as such: the parts of a :class:`rimroll.Body`.

All share the symmetry axis. Heights are measured from the table when the body stands upright, in
metres; masses in kg. Each function raises ``RimrollError`` for a number outside its bound.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

from rimroll import _core
from rimroll.errors import RimrollError
from rimroll.units import Number, Quantity, convert_fields, number, table_of

SIZES = table_of(
    fill=Quantity("1", "How full soda_can or beer_bottle is: 0.5 or 50%.", metavar="PART"),
    radius=Quantity(
        "m", "Radius of the rim: of ring, disk, cylinder, or your own body.", hint="size"
    ),
    length=Quantity("m", "Length of cylinder.", hint="size"),
    mass=Quantity("kg", "Mass of cylinder, or of your own body.", hint="size"),
    density=Quantity(
        "kg/m^3", "Density of cylinder: 2700kg/m3 is stone. [that of water]", hint="size"
    ),
    height=Quantity("m", "Height of its centre of mass above the base.", hint="size"),
    transverse_inertia=Quantity(
        "kg m^2", "A, about an axis through the centre of mass across the body.", hint="size"
    ),
    axial_inertia=Quantity("kg m^2", "C, about the symmetry axis.", hint="size"),
    inner_radius=Quantity("m", hint="size"),
    outer_radius=Quantity("m", hint="size"),
    depth=Quantity("m", hint="size"),
    width=Quantity("m", hint="size"),
    thickness=Quantity("m", hint="size"),
    base=Quantity("m", hint="size"),
)
"""The numbers of bodies, and the arguments of presets and of solids, by name."""


@dataclass(frozen=True)
class Solid:
    """One part of a body: mass (kg), height of its centre of mass (m), A and C about it (kg m²).

    Make it with one of the functions of this module, or give the numbers of a part that none of
    them describes.
    """

    mass: float
    height: float
    transverse_inertia: float
    axial_inertia: float

    def __post_init__(self) -> None:
        convert_fields(self, SIZES, number)
        _core.check_solid(self)


@dataclass(frozen=True)
class Filling(Solid):
    """What fills a round vessel, from :func:`filling`: as a solid it is frozen.

    Its sizes, in m, say how it lies when it is liquid: see :func:`rimroll.balance_tilt`.
    """

    radius: float
    depth: float
    base: float
    length: float
    """From the floor of the vessel to its lid; infinite for a vessel that never overflows."""


def _made(solid: Callable[..., tuple[float, float, float, float]], **sizes: object) -> Solid:
    read = {name: number(name, size, SIZES[name].unit) for name, size in sizes.items()}
    return Solid(*solid(**read))


def cylinder(mass: Number, radius: Number, length: Number, base: Number = 0.0) -> Solid:
    """A solid cylinder with its lower face at ``base``: C = mR²/2, A = C/2 + mL²/12."""
    return _made(_core.cylinder, mass=mass, radius=radius, length=length, base=base)


def hollow_cylinder(
    mass: Number, inner_radius: Number, outer_radius: Number, length: Number, base: Number = 0.0
) -> Solid:
    """A cylinder with a coaxial bore: C = m(a² + b²)/2, A = C/2 + mL²/12."""
    return _made(
        _core.hollow_cylinder,
        mass=mass,
        inner_radius=inner_radius,
        outer_radius=outer_radius,
        length=length,
        base=base,
    )


def disk(mass: Number, radius: Number, height: Number = 0.0) -> Solid:
    """A thin disk at a height: C = mR²/2, A = C/2."""
    return _made(_core.disk, mass=mass, radius=radius, height=height)


def ring(mass: Number, radius: Number, height: Number = 0.0) -> Solid:
    """A thin ring at a height: C = mR², A = C/2."""
    return _made(_core.ring, mass=mass, radius=radius, height=height)


def wall(mass: Number, radius: Number, length: Number, base: Number = 0.0) -> Solid:
    """A thin cylindrical wall, open at both ends, from ``base`` up: C = mR², A = C/2 + mL²/12."""
    return _made(_core.wall, mass=mass, radius=radius, length=length, base=base)


def box(
    mass: Number, width: Number, thickness: Number, length: Number, base: Number = 0.0
) -> Solid:
    """A box such as a phone, upright on the axis: C = m(w² + t²)/12, A = C/2 + mL²/12.

    A box is not round: A is the mean of its two moments across, which differ by m(w² − t²)/12. A
    small box in a heavy body hardly disturbs its motion, a large one does.
    """
    given = {"width": width, "thickness": thickness}
    sides = {name: number(name, size, "m") for name, size in given.items()}
    for name, side in sides.items():
        if not 0.0 < side < math.inf:
            raise RimrollError(field=name, value=side, bound="> 0 and finite", unit="m")
    # A cylinder with the same moments, 2 r² = (w² + t²)/3.
    return cylinder(mass, math.hypot(*sides.values()) / math.sqrt(6.0), length, base)


def filling(
    density: Number,
    radius: Number,
    depth: Number,
    base: Number = 0.0,
    length: Number | None = None,
) -> Filling:
    """A filling of a density (kg/m³), moving with the body as if frozen.

    A real liquid takes less part in the turning than this, and its surface stays level: see
    :func:`rimroll.balance_tilt`. ``length`` is the distance from its floor to a lid; without it the
    vessel never overflows.
    """
    solid = _made(_core.filling, density=density, radius=radius, depth=depth, base=base)
    sizes = {"radius": radius, "depth": depth, "base": base}
    read = {name: number(name, size, "m") for name, size in sizes.items()}
    lid = math.inf if length is None else number("length", length, "m")
    if not lid >= read["depth"]:
        raise RimrollError(
            field="length", value=lid, bound=f"at least the depth, {read['depth']:g} m", unit="m"
        )
    return Filling(**vars(solid), **read, length=lid)
