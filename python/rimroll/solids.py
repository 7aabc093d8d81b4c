"""Solids of revolution from which a :class:`rimroll.Body` is put together.

All share the symmetry axis. Heights are measured from the table when the body stands upright, in
metres; masses in kg. Each function raises ``RimrollError`` for a number outside its bound.
"""

from __future__ import annotations

from dataclasses import dataclass

from rimroll import _core


@dataclass(frozen=True)
class Solid:
    """One part of a body, with the moments about its own centre of mass (SI units).

    Make it with one of the functions of this module, or give the numbers of a part that none of
    them describes.
    """

    mass: float
    height: float
    transverse_inertia: float
    axial_inertia: float


def cylinder(mass: float, radius: float, length: float, base: float = 0.0) -> Solid:
    """A solid cylinder with its lower face at ``base``: C = mR²/2, A = C/2 + mL²/12."""
    return Solid(*_core.cylinder(mass, radius, length, base))


def hollow_cylinder(
    mass: float, inner_radius: float, outer_radius: float, length: float, base: float = 0.0
) -> Solid:
    """A cylinder with a coaxial bore: C = m(a² + b²)/2, A = C/2 + mL²/12."""
    return Solid(*_core.hollow_cylinder(mass, inner_radius, outer_radius, length, base))


def disc(mass: float, radius: float, height: float = 0.0) -> Solid:
    """A thin disc at a height: C = mR²/2, A = C/2."""
    return Solid(*_core.disc(mass, radius, height))


def ring(mass: float, radius: float, height: float = 0.0) -> Solid:
    """A thin ring at a height: C = mR², A = C/2."""
    return Solid(*_core.ring(mass, radius, height))


def wall(mass: float, radius: float, length: float, base: float = 0.0) -> Solid:
    """A thin cylindrical wall, open at both ends, from ``base`` up: C = mR², A = C/2 + mL²/12."""
    return Solid(*_core.wall(mass, radius, length, base))


def filling(density: float, radius: float, depth: float, base: float = 0.0) -> Solid:
    """A filling of a density (kg/m³), moving with the body as if frozen.

    A real liquid takes less part in the turning than this.
    """
    return Solid(*_core.filling(density, radius, depth, base))
