"""Everyday bodies with corners.

Those made from nominal sizes are typical of their kind, not of one specimen. Others come from
:meth:`rimroll.PolygonalBody.prism`, or from measured numbers.
"""

from __future__ import annotations

import math

from rimroll.given import Number, number
from rimroll.polygon.body import PolygonalBody


def hexagonal_nut() -> PolygonalBody:
    """An M24 hexagonal nut of steel, without the thread.

    Nominal sizes of ISO 4032: 36 mm across the flats, 21.5 mm thick; the bore is as wide as the
    thread, 24 mm; steel 7850 kg/m³: 0.11 kg.
    """
    across, thickness, bore = 0.036, 0.0215, 0.012
    area = 0.5 * math.sqrt(3.0) * across**2 - math.pi * bore**2
    return PolygonalBody.prism(
        7850.0 * area * thickness, 6, across / math.sqrt(3.0), thickness, bore
    )


def square_column(width: Number, length: Number) -> PolygonalBody:
    """A uniform square column with the density of water. No motion depends on its mass."""
    side, tall = number("width", width, "m"), number("length", length, "m")
    return PolygonalBody.prism(1000.0 * side**2 * tall, 4, side / math.sqrt(2.0), tall)


def cut_glass() -> PolygonalBody:
    """A tumbler of cut glass on a base with eight corners.

    Nominal sizes: a solid prism of glass (2500 kg/m³), 80 mm over the corners and 90 mm high, with
    a round hollow 64 mm wide down to 12 mm over the base.
    """
    radius, length, bore, base = 0.040, 0.090, 0.032, 0.012
    area = 8.0 * math.sin(math.pi / 4.0) / 2.0 * radius**2
    hole = math.pi * bore**2
    wall = PolygonalBody.prism(
        2500.0 * (area - hole) * (length - base), 8, radius, length - base, bore
    )
    foot = PolygonalBody.prism(2500.0 * area * base, 8, radius, base)
    mass = wall.mass + foot.mass
    height = (wall.mass * (base + wall.height) + foot.mass * foot.height) / mass
    transverse = (
        wall.transverse_inertia
        + wall.mass * (base + wall.height - height) ** 2
        + foot.transverse_inertia
        + foot.mass * (foot.height - height) ** 2
    )
    axial = wall.axial_inertia + foot.axial_inertia
    return PolygonalBody(8, mass, radius, height, transverse, axial)
