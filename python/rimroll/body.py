"""What rolls: an axisymmetric rigid body on the circular rim of its base."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, fields
from typing import TYPE_CHECKING

from rimroll import _core
from rimroll.given import Number, number
from rimroll.solids import Solid
from rimroll.units import UNIT_OF

if TYPE_CHECKING:
    import xarray as xr


@dataclass(frozen=True)
class Body:
    """An axisymmetric rigid body whose base is a circle (SI units).

    Only these five numbers enter the motion; the shape above the base does not matter. They may
    carry units, as in ``"70 g"``: see :mod:`rimroll.given`.

    Parameters
    ----------
    mass
        m, kg.
    radius
        R, radius of the rim that touches the table, m.
    height
        H, height of the centre of mass above the base, m; 0 for a disk.
    transverse_inertia
        A, moment of inertia about any axis through the centre of mass perpendicular to the symmetry
        axis, kg m². Not per unit mass: the paper gives A/m.
    axial_inertia
        C, moment of inertia about the symmetry axis, kg m².

    Raises
    ------
    RimrollError
        A number that is not finite; m, R, A or C ≤ 0; H < 0; C > 2A, which no rigid body has.
    """

    mass: float
    radius: float
    height: float
    transverse_inertia: float
    axial_inertia: float

    if TYPE_CHECKING:

        def __init__(
            self,
            mass: Number,
            radius: Number,
            height: Number,
            transverse_inertia: Number,
            axial_inertia: Number,
        ) -> None: ...

    def __post_init__(self) -> None:
        for field in fields(self):
            value = number(field.name, getattr(self, field.name), UNIT_OF[field.name])
            object.__setattr__(self, field.name, value)
        _core.check_body(self)

    @classmethod
    def from_xarray(cls, dataset: xr.Dataset) -> Body:
        """The body of a dataset of a motion, of falls or of a map.

        Raises ``RimrollError`` for a dataset of something else.
        """
        from rimroll.ensemble import body_of
        from rimroll.recorded import expect_dataset

        expect_dataset(dataset)
        return body_of(dataset)

    @classmethod
    def from_solids(cls, radius: Number, solids: Sequence[Solid]) -> Body:
        """A body put together from coaxial solids, standing on a rim of the given radius (m).

        The parallel-axis theorem gives A and C; see :mod:`rimroll.solids`.

        >>> from rimroll import solids
        >>> cup = Body.from_solids(0.03, [solids.wall(0.1, 0.03, 0.09), solids.disc(0.02, 0.03)])

        Raises ``RimrollError`` for no solids, or solids that make up no valid body.
        """
        return cls(*_core.body_from_solids(number("radius", radius, "m"), list(solids)))
