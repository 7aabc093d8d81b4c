"""What rolls: an axisymmetric rigid body on the circular rim of its base."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, fields, replace
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from rimroll import _core
from rimroll.bodies.solids import SIZES, Filling, Solid
from rimroll.errors import RimrollError, element, expect
from rimroll.files.recorded import expect_dataset, recorded
from rimroll.many.falls import Falls
from rimroll.many.grid import Grid, key, same
from rimroll.units import Number, Values, convert_fields, number

if TYPE_CHECKING:
    import xarray as xr

    from rimroll.files.recorded import Record


@dataclass(frozen=True, eq=False)
class Body:
    """An axisymmetric rigid body whose base is a circle (SI units).

    Only these five numbers enter the motion; the shape above the base does not matter. They may
    carry units, as in ``"70 g"``: see :mod:`rimroll.units`.

    Arrays stand for many bodies: fields broadcast against one another, as in NumPy, and data arrays
    of xarray by the names of their dimensions. :func:`rimroll.ensemble`, :func:`rimroll.exact_turn`
    and the closed forms take many bodies; a single motion takes one.

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
        A number that is not finite; m, R, A or C ≤ 0; H < 0; C > 2A, which no rigid body has;
        arrays that are empty or do not broadcast. For an array the message names the element,
        ``height[3]``.
    """

    mass: float
    radius: float
    height: float
    transverse_inertia: float
    axial_inertia: float

    if TYPE_CHECKING:
        # The fields have the types of a single body, the usual case.
        def __init__(
            self,
            mass: Values,
            radius: Values,
            height: Values,
            transverse_inertia: Values,
            axial_inertia: Values,
        ) -> None: ...

    def __post_init__(self) -> None:
        convert_fields(self, SIZES)
        if any(map(np.ndim, vars(self).values())):
            _check_each(self)
        else:
            _core.check_body(self)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Body):
            return NotImplemented
        mine, others = vars(self), vars(other)
        return all(same(mine[field.name], others[field.name]) for field in fields(self))

    def __hash__(self) -> int:
        return hash(tuple(key(getattr(self, field.name)) for field in fields(self)))

    def _repr_html_(self) -> str | None:
        """The view in notebooks: the five numbers and what follows; None for many bodies."""
        if self.shape:
            return None
        from rimroll.figures.notebook import degrees, table, view
        from rimroll.laws import Frictionless, NoSlip

        rows = [
            ("mass", f"{1e3 * self.mass:.6g} g"),
            ("radius of the rim", f"{1e2 * self.radius:.6g} cm"),
            ("height of the centre of mass", f"{1e2 * self.height:.6g} cm"),
            ("transverse inertia A", f"{self.transverse_inertia:.6g} kg m²"),
            ("axial inertia C", f"{self.axial_inertia:.6g} kg m²"),
            ("balances at", degrees(_core.balance_tilt(self))),
        ]
        if self.filling is not None:
            rows.append(("with its filling liquid", degrees(liquid_balance(self))))
        at_rest = (1.0, 0.0, 0.0, math.nan)  # the rim on arrival
        for words, law in ("without slip", NoSlip()), ("without friction", Frictionless()):
            rows.append((f"turns {words}", degrees(_core.turn_limit(self, law, at_rest))))
        rows.append(("friction needed to roll", f"{_core.needed_friction(self):.3f}"))
        return view("Body", table(rows))

    @property
    def shape(self) -> tuple[int, ...]:
        """The shape that the fields broadcast to; () for one body."""
        return Grid.over({field.name: getattr(self, field.name) for field in fields(self)}).shape

    @property
    def filling(self) -> Filling | None:
        """The filling of a body that was made with one, else None.

        It comes from a preset or from one :func:`rimroll.bodies.solids.filling` among solids. The
        five numbers of the body contain it as if it were frozen, and so it is in every motion. Only
        :func:`rimroll.balance_tilt` can take it as liquid.
        """
        filling: Filling | None = self.__dict__.get("_filling")
        return filling

    def with_filling(self, filling: Filling | None) -> Body:
        """The same body, which knows that its numbers contain this filling, frozen."""
        body = replace(self)
        object.__setattr__(body, "_filling", filling)
        return body

    @classmethod
    def stack(cls, bodies: Iterable[Body] | Mapping[str, Body], dim: str = "body") -> Body:
        """Several single bodies as one Body of arrays (n,).

        Bodies by name become data arrays of xarray, which name them along the dimension ``dim``.

        >>> from rimroll import bodies
        >>> Body.stack([bodies.coin(), bodies.can_2007()]).shape
        (2,)

        Raises ``RimrollError`` for no bodies, or what is not a single one.
        """
        names = list(bodies) if isinstance(bodies, Mapping) else None
        each = list(bodies.values() if isinstance(bodies, Mapping) else bodies)
        if not each:
            raise RimrollError("must be one or more, got none", "bodies")
        for place, body in enumerate(each):
            one_body(body, element("bodies", [place]))
        columns = [np.array(column) for column in zip(*map(_numbers, each), strict=True)]
        if names is None:
            return cls(*columns)
        import xarray as xr

        return cls(*(xr.DataArray(column, coords={dim: names}, dims=dim) for column in columns))

    @classmethod
    def from_xarray(cls, dataset: xr.Dataset) -> Body:
        """The body of a dataset of a motion, of falls or of a map.

        Raises ``RimrollError`` for a dataset of something else.
        """
        expect_dataset(dataset)
        return body_of(dataset)

    @classmethod
    def from_solids(cls, radius: Number, solids: Sequence[Solid]) -> Body:
        """A body composed of coaxial solids, on a rim of the given radius (m).

        The parallel-axis theorem gives A and C; see :mod:`rimroll.bodies.solids`.

        >>> from rimroll import solids
        >>> cup = Body.from_solids(0.03, [solids.wall(0.1, 0.03, 0.09), solids.disk(0.02, 0.03)])

        Raises ``RimrollError`` for no solids, or solids that make up no valid body.
        """
        body = cls(*_core.body_from_solids(number("radius", radius, "m"), list(solids)))
        fillings = [solid for solid in solids if isinstance(solid, Filling)]
        return body.with_filling(fillings[0]) if len(fillings) == 1 else body


def body_of(record: Record) -> Body:
    """The body of a motion or of falls; a Body of arrays where it differs from fall to fall.

    Raises ``RimrollError`` for a dataset of something else.
    """
    if isinstance(record, Falls) and record.body is not None:
        body: Body = record.body
        return body
    return Body(**{field.name: recorded(record, f"body_{field.name}") for field in fields(Body)})


def one_body(body: Any, field: str = "body") -> Body:
    """The body itself, if it is a single one; else ``RimrollError``."""
    expect(field, body, Body)
    assert isinstance(body, Body)
    if body.shape:
        raise RimrollError(
            f"must be a single body, got bodies of shape {body.shape}: rimroll.ensemble and"
            " rimroll.exact_turn take many",
            field,
        )
    return body


def _numbers(body: Body) -> tuple[float, ...]:
    return tuple(getattr(body, field.name) for field in fields(body))


class Bodies(NamedTuple):
    """Bodies in the form of the core: each array is (1,), for all rows, or (n,)."""

    mass: NDArray[np.float64]
    radius: NDArray[np.float64]
    height: NDArray[np.float64]
    transverse_inertia: NDArray[np.float64]
    axial_inertia: NDArray[np.float64]

    @classmethod
    def of(cls, body: Body, grid: Grid) -> Bodies:
        """The bodies of the rows of a grid."""
        return cls(*(grid.column(getattr(body, name)) for name in cls._fields))

    def part(self, rows: slice) -> Bodies:
        """The bodies of some of the rows."""
        return Bodies(*(column if len(column) == 1 else column[rows] for column in self))


def _check_each(body: Body) -> None:
    given = {field.name: getattr(body, field.name) for field in fields(body)}
    grid = Grid.over(given)
    if 0 in grid.shape:
        raise RimrollError("must be one or more, got none", "bodies")
    bad = _core.first_bad_body(Bodies.of(body, grid))
    if bad is not None:
        row, error = bad
        raise grid.placed(error, given, row)


def liquid_balance(body: Body) -> float:
    """The tilt at which a body balances on its rim while its filling has a level surface, rad.

    Raises ``RimrollError`` for a body without a filling.
    """
    from scipy.optimize import brentq

    filling = body.filling
    if filling is None:
        raise RimrollError(
            "body has no filling to be liquid: bodies.soda_can(fill), bodies.beer_bottle(fill)"
            " and Body.from_solids with one solids.filling have"
        )
    frozen = _core.balance_tilt(body)

    def overhang(tilt: float) -> float:
        """The mass times the distance by which the centre of mass is inside the rim, kg m."""
        sin, cos = math.sin(tilt), math.cos(tilt)
        across, up = _centre(filling.radius, filling.depth, filling.length, sin / cos)
        moved = across * cos - (up - 0.5 * filling.depth) * sin
        return body.mass * (body.radius * cos - body.height * sin) + filling.mass * moved

    # A level surface moves the filling outward and up, so the body balances at a smaller tilt than
    # when it is frozen. The potential energy is the least of concave functions of the tilt, one for
    # each shape of the filling, and so concave: there is one balance, and it is unstable.
    return float(brentq(overhang, 0.0, frozen, xtol=1e-16))


def _centre(radius: float, depth: float, length: float, slope: float) -> tuple[float, float]:
    """The centre of a liquid in a cylinder that leans, in the cylinder's axes, m.

    ``depth`` is the depth upright, ``length`` the distance of the lid from the floor, ``slope`` the
    tangent of the tilt. The first number counts from the axis, negative toward the low side, the
    second from the floor.
    """
    from scipy.optimize import brentq

    rise = slope * radius
    if rise < 1e-9 * depth or depth >= length:
        return -0.25 * slope * radius * radius / depth if depth < length else 0.0, 0.5 * depth
    # The surface is at the height rise (k - x/radius) over the floor. What it would cover of a
    # vessel without a lid is too much by what it would cover beyond the lid.
    lid, upright = length / rise, depth / rise

    def volume(k: float) -> float:
        return _moments(k)[0] - _moments(k - lid)[0]

    k = brentq(lambda k: volume(k) - math.pi * upright, -1.0, upright + 1.0, xtol=1e-15)
    (f, g, q), (f_lid, g_lid, q_lid) = _moments(k), _moments(k - lid)
    held = f - f_lid
    above = q_lid + lid * f_lid if f_lid else 0.0
    return radius * (g - g_lid) / held, rise * (q - above) / held


def _moments(k: float) -> tuple[float, float, float]:
    """∫ 2h, ∫ 2hx and ∫ h² dA/dx over the unit disk, with the height h = k - x where positive."""
    if k <= -1.0:
        return 0.0, 0.0, 0.0
    if k >= 1.0:
        return math.pi * k, -0.25 * math.pi, 0.5 * math.pi * (k * k + 0.25)
    y, wet = math.sqrt(1.0 - k * k), math.acos(-k)
    f = k * wet + y * (2.0 + k * k) / 3.0
    g = -(k * (5.0 - 2.0 * k * k) * y + 3.0 * wet) / 12.0
    q = k * k * (wet + k * y) + 4.0 / 3.0 * k * y**3 + 0.25 * wet - 0.25 * k * y * (1 - 2 * k * k)
    return f, g, 0.5 * q
