"""Bodies with corners: their class, and everyday ones.

Those made from nominal sizes are typical of their kind, not of one specimen. Others come from
:meth:`rimroll.PolygonalBody.prism`, or from measured numbers.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

from rimroll import _core
from rimroll.bodies.body import Body
from rimroll.bodies.solids import SIZES
from rimroll.units import Number, convert_fields, number, whole_number


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


@dataclass(frozen=True)
class PolygonalBody:
    """A rigid body whose base is a regular polygon (SI units): a nut, a square column, a prism.

    Its moments of inertia about all axes through the centre of mass perpendicular to the axis of
    symmetry must be equal, as they are for every body that a rotation by 2π/n, n ≥ 3, maps onto
    itself. The shape above the base does not matter. Numbers may carry units, as in ``"70 g"``.

    Parameters
    ----------
    corners
        n, the number of corners of the base, 3 to 100 000.
    mass
        m, kg.
    radius
        R, distance of the corners from the axis, m.
    height
        H, height of the centre of mass above the base, m; 0 for a plate.
    transverse_inertia, axial_inertia
        A and C, moments of inertia across and about the axis of symmetry, kg m².

    Raises
    ------
    RimrollError
        Fewer than 3 corners; numbers that are not finite; m, R, A or C ≤ 0; H < 0; C > 2A.
    """

    corners: int
    mass: float
    radius: float
    height: float
    transverse_inertia: float
    axial_inertia: float

    def __post_init__(self) -> None:
        object.__setattr__(self, "corners", whole_number("corners", self.corners))
        convert_fields(self, SIZES, number)
        _core.check_polygonal_body(self)

    @classmethod
    def prism(
        cls, mass: Number, corners: int, radius: Number, length: Number, bore: Number = 0.0
    ) -> PolygonalBody:
        """A uniform prism, with a coaxial round bore of radius ``bore`` (m) if it is not 0.

        >>> cube = PolygonalBody.prism(1.0, corners=4, radius=0.5**0.5, length=1.0)
        >>> round(6 * cube.transverse_inertia, 12), round(6 * cube.axial_inertia, 12)
        (1.0, 1.0)

        Raises ``RimrollError`` for numbers that are not positive, and a bore that is not narrower
        than the circle inside the polygon.
        """
        return cls(
            *_core.prism(
                number("mass", mass, "kg"),
                whole_number("corners", corners),
                number("radius", radius, "m"),
                number("length", length, "m"),
                number("bore", bore, "m"),
            )
        )

    @property
    def round_body(self) -> Body:
        """The body with the same numbers on a round rim through the corners."""
        return Body(
            self.mass, self.radius, self.height, self.transverse_inertia, self.axial_inertia
        )

    @property
    def housner_ratio(self) -> float:
        """The factor of the tilt rate in a plane impact from an edge to the opposite one.

        1 − 2ma²/(A + mH² + ma²), a the distance of the edges from the axis: for an even number of
        corners, without slip. A uniform rectangular block has Housner's 1 − (3/2) sin²α. Where it
        is negative, the body stays down.
        """
        return _core.housner_ratio(self)
