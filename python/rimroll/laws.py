"""The contact laws: how the rim meets the table, and the resistances to its motion.

>>> import rimroll as rr
>>> rr.Coulomb(0.3) + rr.RollingResistance(dry=1e-3)
Coulomb(friction=0.3) + RollingResistance(dry=0.001)
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import MISSING, dataclass, field, fields, replace
from typing import TYPE_CHECKING, Any, ClassVar, NamedTuple, Self

import numpy as np

from rimroll import _core
from rimroll.errors import RimrollError, expect, hold
from rimroll.given import Number, Values, number, values
from rimroll.given import numbers as array
from rimroll.grid import Grid, is_array, key, same
from rimroll.names import choose, typed
from rimroll.sampled_curve import sampled
from rimroll.units import LAW_UNIT_OF, air_unit

if TYPE_CHECKING:
    import xarray as xr

TABLES = ("speeds", "frictions")
"""The parameters of a law that are lists of numbers."""


class _Numbered:
    """A dataclass whose numbers, or arrays of numbers, are checked when it is made."""

    def _read(self) -> None:
        for item in fields(self):  # type: ignore[arg-type]
            value = getattr(self, item.name)
            left_out = value is None and item.default is None
            if item.name != "resistances" and not left_out:
                read = listed if item.name in TABLES else values
                unit = self._unit_of(item.name)
                object.__setattr__(self, item.name, read(item.name, value, unit))

    def _unit_of(self, name: str) -> str:
        return LAW_UNIT_OF[name]

    def __repr__(self) -> str:
        given = ", ".join(
            f"{item.name}={_brief(getattr(self, item.name))}"
            for item in fields(self)  # type: ignore[arg-type]
            if item.repr and not same(getattr(self, item.name), item.default)
        )
        return f"{type(self).__name__}({given})"

    def __eq__(self, other: object) -> bool:
        if type(other) is not type(self):
            return NotImplemented
        return all(
            same(getattr(self, item.name), getattr(other, item.name))
            for item in fields(self)  # type: ignore[arg-type]
        )

    def __hash__(self) -> int:
        numbers = (key(getattr(self, item.name)) for item in fields(self))  # type: ignore[arg-type]
        return hash((type(self), *numbers))


def listed(field: str, values: object, unit: str = "1") -> tuple[float, ...]:
    """The values of a field as a tuple of floats in an SI unit.

    Raises ``RimrollError`` naming the field unless they are a flat list of numbers.
    """
    flat = array(field, values, unit)
    if flat.ndim != 1:
        raise RimrollError(f"{field} must be a flat list of numbers, got {values!r}")
    return tuple(flat.tolist())


def _brief(value: object) -> str:
    """The text of a number, or of a list of numbers, without the middle of a long one."""
    if not isinstance(value, tuple) or len(value) <= 8:
        return repr(value)
    return f"({value[0]!r}, {value[1]!r}, ..., {value[-1]!r}: {len(value)} numbers)"


class OneLaw(NamedTuple):
    """The name of a law and its numbers, as the core reads them."""

    name: str
    numbers: dict[str, float]


def varied_numbers(numbers: Mapping[str, Any]) -> dict[str, Any]:
    """The numbers of a law that are arrays."""
    return {name: value for name, value in numbers.items() if is_array(value)}


def fixed_numbers(numbers: Mapping[str, Any]) -> dict[str, float]:
    """The numbers of a law that are single numbers."""
    return {name: value for name, value in numbers.items() if not is_array(value)}


def only_fixed(law: Law) -> OneLaw:
    """A law without the numbers that are arrays."""
    return OneLaw(law.name, fixed_numbers(law.numbers))


def _check(name: str, numbers: Mapping[str, Any]) -> None:
    varied, fixed = varied_numbers(numbers), OneLaw(name, fixed_numbers(numbers))
    if not varied:
        _core.check_surface(fixed)
        return
    grid = Grid.over(varied)
    columns = {name: grid.flat(value) for name, value in varied.items()}
    bad = _core.first_bad_surface(fixed, columns)
    if bad is not None:
        row, message = bad
        raise RimrollError(grid.placed(message, numbers, row))


@dataclass(frozen=True, repr=False, eq=False)
class RollingResistance(_Numbered):
    """Resistance to the motion of the contact point along the rim, at speed R |dθ/dt|.

    The resisting force is ``dry`` times the normal force plus ``viscous`` (N s/m) times the speed.
    It is also called contour friction. The closer a near-collision, the faster the contact point
    runs and the more energy is lost, without bound. The sign function of ``dry`` is smoothed where
    the base turns slower than 0.001 √(g/R). Source: R. I. Leine, Arch. Appl. Mech. 79 (2009).

    A resistance can stop the contact point in a near-collision: see the notes of
    :func:`rimroll.simulate`.
    """

    dry: float = 0.0
    viscous: float = 0.0

    if TYPE_CHECKING:

        def __init__(self, dry: Values = 0.0, viscous: Values = 0.0) -> None: ...

    def __post_init__(self) -> None:
        self._read()
        _check("no_slip", self._numbers())

    def _numbers(self) -> dict[str, float]:
        return {"rolling_dry": self.dry, "rolling_viscous": self.viscous}


@dataclass(frozen=True, repr=False, eq=False)
class PivotingFriction(_Numbered):
    """Resistance to turning about the vertical: a moment ``length`` (m) times the normal force."""

    length: float

    if TYPE_CHECKING:

        def __init__(self, length: Values) -> None: ...

    def __post_init__(self) -> None:
        self._read()
        _check("no_slip", self._numbers())

    def _numbers(self) -> dict[str, float]:
        return {"pivoting_length": self.length}


@dataclass(frozen=True, repr=False, eq=False)
class AirDrag(_Numbered):
    """Dissipation of the wobble in the air under the base: ``coefficient`` |dψ/dt|^``exponent``, W.

    ``coefficient`` in W (s/rad)^exponent; ``exponent`` from 1.5 to 8: 4 for a viscous film
    (Moffatt, Nature 404, 2000), 5/2 for boundary layers (Bildsten, Phys. Rev. E 66, 2002).

    For exponents below 2 the moment has an infinite slope at dψ/dt = 0. There |dψ/dt| is replaced
    by √((dψ/dt)² + ω₀²) with ω₀ = 0.002 ``rtol`` (√(g/R) + axial spin rate), which changes the drag
    on larger rates by less than a change of dψ/dt by ω₀ would. A dψ/dt below ω₀ decays
    exponentially instead of stopping after a finite time: choose ``rtol`` so that ω₀ is well below
    the yaw rate of the start.
    """

    coefficient: float
    exponent: float = 4.0

    if TYPE_CHECKING:

        def __init__(self, coefficient: Values, exponent: Values = 4.0) -> None: ...

    def __post_init__(self) -> None:
        self._read()
        _check("no_slip", self._numbers())

    def _unit_of(self, name: str) -> str:
        if name == "coefficient":
            # Several exponents have no common unit.
            return "1" if np.ndim(self.exponent) else air_unit(number("exponent", self.exponent))
        return super()._unit_of(name)

    @classmethod
    def film(
        cls,
        radius: Number,
        viscosity: Number = 1.82e-5,
        gravity: Number = _core.STANDARD_GRAVITY,
    ) -> AirDrag:
        """Moffatt's viscous film under a nearly flat uniform disk: π μ R⁴/(16 g) and exponent 4.

        His π μ R³ Ω²/(4 α) with Ω² α = 4 g/R. ``radius`` in m, ``viscosity`` in Pa s (air:
        1.82e-5), ``gravity`` in m/s², all > 0.
        """
        radius = _positive("radius", radius, "m")
        viscosity = _positive("viscosity", viscosity, "Pa s")
        gravity = _positive("gravity", gravity, "m/s^2")
        return cls(math.pi * viscosity * radius**4 / (16.0 * gravity), 4.0)

    def _numbers(self) -> dict[str, float]:
        return {"air_coefficient": self.coefficient, "air_exponent": self.exponent}


def _positive(name: str, value: Number, unit: str) -> float:
    read = number(name, value, unit)
    if not 0.0 < read < math.inf:
        raise RimrollError(f"{name} must be > 0 and finite, got {read} {unit}")
    return read


Resistance = RollingResistance | PivotingFriction | AirDrag

Resistances = Resistance | tuple[Resistance, ...]


@dataclass(frozen=True, repr=False, eq=False)
class Law(_Numbered):
    """How the rim meets the table; add resistances with ``+``.

    The numbers of laws and resistances may be arrays, for many laws at once. They broadcast as in
    NumPy, data arrays of xarray by the names of their dimensions. :func:`rimroll.ensemble` and
    :func:`rimroll.turn_limit` take many laws; a single motion takes one.
    """

    name: ClassVar[str]
    """The name of the law on the command line and in scenario files."""

    resistances: tuple[Resistance, ...] = field(default=(), kw_only=True, repr=False)

    def __post_init__(self) -> None:
        _expect_known(type(self))
        self._read()
        given = self.resistances
        items = (given,) if isinstance(given, Resistance) else tuple(given)
        kinds = [type(item).__name__ for item in items]
        for item, kind in zip(items, kinds, strict=True):
            expect("what is added to a law", item, Resistance)
            if kinds.count(kind) > 1:
                raise RimrollError(f"a law takes one {kind}, got two")
        in_order = tuple(sorted(items, key=lambda item: type(item).__name__, reverse=True))
        object.__setattr__(self, "resistances", in_order)
        _check(self.name, self.numbers)

    @classmethod
    def from_xarray(cls, dataset: xr.Dataset) -> Law:
        """The law of a dataset of a motion, of falls or of a map, with its resistances.

        Raises ``RimrollError`` for a dataset of something else.
        """
        from rimroll.many_falls import law_of
        from rimroll.recorded import expect_dataset

        expect_dataset(dataset)
        return law_of(dataset)

    def __add__(self, other: Resistance) -> Self:
        expect("what is added to a law", other, Resistance)
        return replace(self, resistances=(*self.resistances, other))

    def __radd__(self, other: Resistance) -> Self:
        return self + other

    def __repr__(self) -> str:
        return " + ".join([super().__repr__(), *map(repr, self.resistances)])

    @property
    def numbers(self) -> dict[str, float | tuple[float, ...]]:
        """The law's numbers and those of its resistances, by name, in SI units.

        Tables are tuples of numbers.
        """
        own = {
            item.name: value
            for item in fields(self)
            if item.name != "resistances" and (value := getattr(self, item.name)) is not None
        }
        for resistance in self.resistances:
            own |= resistance._numbers()
        return own

    @property
    def shape(self) -> tuple[int, ...]:
        """The shape that the numbers broadcast to; () for one law."""
        return Grid.over(varied_numbers(self.numbers)).shape


@dataclass(frozen=True, repr=False, eq=False)
class NoSlip(Law):
    """Rolling without slip: the point of the rim that touches the table is at rest.

    Source: the paper, Eqs. ``noslip_eqs`` and appendix A. A motion ends where the table would have
    to pull the rim down.
    """

    name: ClassVar[str] = "no_slip"


@dataclass(frozen=True, repr=False, eq=False)
class Frictionless(Law):
    """Sliding without friction: the table only pushes upward.

    Source: the paper, Eqs. ``nofric_eqs`` and appendix A. The centre of mass moves only vertically.
    A motion ends where the table would have to pull the rim down.
    """

    name: ClassVar[str] = "frictionless"


@dataclass(frozen=True, repr=False, eq=False)
class Coulomb(Law):
    """Dry friction, with exact phases of rolling, sliding and flight.

    The rim rolls while |T| ≤ ``static`` · N. Then it slips with |T| = ``friction`` · N against the
    slip, and rolls again when the slip stops and friction can hold it. ``static`` is by default
    ``friction``, and must not be smaller. The rim leaves the table where the normal force reaches
    zero. It lands with the energetic coefficient of ``restitution``, 0 to 1, and with ``friction``
    in the impulse, whether it slips or sticks.
    """

    friction: float
    static: float | None = None
    restitution: float = 0.0
    name: ClassVar[str] = "coulomb"

    if TYPE_CHECKING:

        def __init__(
            self,
            friction: Values,
            static: Values | None = None,
            restitution: Values = 0.0,
            *,
            resistances: Resistances = (),
        ) -> None: ...


@dataclass(frozen=True, repr=False, eq=False)
class Viscous(Law):
    """A film of oil: T = −``coefficient`` (N s/m) times the slip, whatever the normal force.

    In the limit of a near-collision, which takes no time, it has no effect. The rim flies and lands
    as under :class:`Coulomb`, but without friction in the impulse.
    """

    coefficient: float
    restitution: float = 0.0
    name: ClassVar[str] = "viscous"

    if TYPE_CHECKING:

        def __init__(
            self,
            coefficient: Values,
            restitution: Values = 0.0,
            *,
            resistances: Resistances = (),
        ) -> None: ...


@dataclass(frozen=True, repr=False, eq=False)
class Stribeck(Law):
    """Regularised dry friction: T = −μ(u) N u/√(u² + creep_speed²).

    μ(u) = friction + (static − friction) exp(−(u/stribeck_speed)²). Without ``static`` it is
    the regularised Coulomb friction of most physics engines: the rim creeps where it should stick.
    Speeds are in m/s. Source of the curve: Armstrong-Hélouvry, Dupont & Canudas de Wit,
    Automatica 30 (1994).
    """

    friction: float
    static: float | None = None
    stribeck_speed: float = 0.01
    creep_speed: float = 1e-3
    restitution: float = 0.0
    name: ClassVar[str] = "stribeck"

    if TYPE_CHECKING:

        def __init__(
            self,
            friction: Values,
            static: Values | None = None,
            stribeck_speed: Values = 0.01,
            creep_speed: Values = 1e-3,
            restitution: Values = 0.0,
            *,
            resistances: Resistances = (),
        ) -> None: ...


@dataclass(frozen=True, repr=False, eq=False)
class Tabulated(Law):
    """Dry friction whose coefficient is a curve μ(u) of the slip speed u: T = −μ(u) N u/|u|.

    The curve goes through the points (``speeds`` in m/s, ``frictions``). Between them it is the
    monotone piecewise cubic of Fritsch & Butland (SIAM J. Sci. Stat. Comput. 5, 1984; SciPy's
    ``PchipInterpolator``), which has a continuous slope and overshoots no point; below the first
    speed and beyond the last it is constant. A curve may fall and rise.

    Everything else is as under :class:`Coulomb`: exact phases of rolling, sliding and flight,
    without regularisation. The rim rolls while |T| ≤ ``static`` · N; ``static`` is by default the
    friction at the lowest speed, and must not be smaller. In a landing, the coefficient is that of
    the slip speed with which the rim comes down, throughout the impulse.

    >>> import rimroll as rr
    >>> law = rr.Tabulated(speeds=[0.0, 0.05, 0.2], frictions=[0.3, 0.22, 0.2], static=0.35)
    >>> law.friction_at(0.05)
    0.22

    Raises ``RimrollError`` for fewer than two points, speeds that do not rise from 0 or more,
    frictions outside 0 to 1e6.
    """

    speeds: Sequence[float]
    frictions: Sequence[float]
    static: float | None = None
    restitution: float = 0.0
    name: ClassVar[str] = "tabulated"

    def friction_at(self, speeds: Values) -> Any:
        """μ at slip speeds (m/s, >= 0): a number, or an array of their shape."""
        given = array("speeds", speeds, "m/s")
        hold("speeds", given, given >= 0.0, ">= 0", "m/s")
        values = _core.friction_at(self, np.ascontiguousarray(given).ravel())
        return values.reshape(given.shape) if given.ndim else float(values[0])

    @classmethod
    def from_function(
        cls,
        mu: Callable[[float], float],
        speeds: Values,
        *,
        tolerance: Number = 1e-6,
        static: Number | None = None,
        restitution: Number = 0.0,
    ) -> Tabulated:
        """A table of the function μ(u), which is called with one slip speed (m/s) at a time.

        Parameters
        ----------
        mu
            The coefficient of friction: a continuous function.
        speeds
            The initial speeds, m/s, at least two: from the lowest to the one beyond which the
            friction is taken as constant.
        tolerance
            Largest difference between the curve and ``mu``. Intervals are halved where the
            difference is larger at a quarter, half or three quarters of the interval, or at one of
            64 places between each two of ``speeds``. A feature of ``mu`` that is narrower than 1/46
            of the interval between two ``speeds`` can be missed: give speeds around it.
        static, restitution
            As for :class:`Tabulated`.

        >>> import math
        >>> import rimroll as rr
        >>> fading = rr.Tabulated.from_function(
        ...     lambda u: 0.2 + 0.1 * math.exp(-u / 0.05), speeds=[0.0, 1.0]
        ... )
        >>> round(fading.friction_at(0.05), 5)
        0.23679

        Raises ``RimrollError`` if ``mu`` returns anything but a number from 0 to 1e6, is not
        continuous, or needs more than ten thousand points.
        """
        if not callable(mu):
            raise RimrollError(f"mu must be a function of the slip speed, got {mu!r}")
        tolerance = number("tolerance", tolerance)
        if not tolerance > 0.0:
            raise RimrollError(f"tolerance must be > 0, got {tolerance:g}")
        begin = listed("speeds", speeds, "m/s")
        # Raises errors about the speeds before the function is called.
        cls(begin, [0.0] * len(begin))
        points = sampled(mu, begin, lambda u, mus: cls(u, mus).friction_at, tolerance)
        sticking = None if static is None else number("static", static)
        return cls(*points, sticking, number("restitution", restitution))


LAWS: dict[str, type[Law]] = {
    law.name: law for law in (NoSlip, Frictionless, Coulomb, Viscous, Stribeck, Tabulated)
}
"""The laws by name, in the core's order."""

assert list(LAWS) == list(_core.LAWS)


def one_law(law: Any) -> Law:
    """The law itself, if it is a single law of the core; else ``RimrollError``."""
    contact_law(law)
    if law.shape:
        raise RimrollError(
            f"law must be a single law, got numbers of shape {law.shape}: rimroll.ensemble takes"
            " many"
        )
    assert isinstance(law, Law)
    return law


def contact_law(law: object) -> Law:
    """The law, if it is a law of the core; else ``RimrollError``."""
    expect("law", law, Law)
    assert isinstance(law, Law)
    _expect_known(type(law))
    return law


def _expect_known(kind: type[Law]) -> None:
    """Raise ``RimrollError`` for a user's class: the core knows laws by name only."""
    if kind not in LAWS.values():
        known = ", ".join(known.__name__ for known in LAWS.values())
        raise RimrollError(
            f"law must be one of rimroll's own, {known}, got the class {kind.__name__}: laws are"
            " compiled; for a friction of your own over the slip speed use rimroll.Tabulated"
        )


IDEAL: tuple[Law, ...] = (NoSlip(), Frictionless())
"""The paper's two laws, for which there are closed forms."""


def in_brief(value: float | tuple[float, ...]) -> str:
    """A number of a law as text, or the range of the numbers of a table."""
    if isinstance(value, tuple):
        return f"{min(value):g} to {max(value):g}"
    return f"{value:g}"


def ideal(law: object) -> Law:
    """The law, if it is one of the two with closed forms; else ``RimrollError``."""
    law = contact_law(law)
    if type(law) not in (NoSlip, Frictionless):
        raise RimrollError(f"law must be NoSlip or Frictionless for a closed form, got {law!r}")
    return law


def kind(name: str) -> type[Law]:
    """The class of law of that name, typed like ``no-slip`` or ``no_slip``.

    Raises ``RimrollError`` with the nearest name if there is none.
    """
    return choose("law", name, {typed(known): law for known, law in LAWS.items()})


def numbers_of(law: type[Law]) -> dict[str, bool]:
    """The numbers of a law by name, and whether each is required."""
    return {
        item.name: item.default is MISSING for item in fields(law) if item.name != "resistances"
    }


def by_name(name: str, numbers: Mapping[str, float | tuple[float, ...]] | None = None) -> Law:
    """The law of that name with these numbers; ``-`` may stand for ``_``.

    Raises ``RimrollError`` with the nearest name if there is none, or with the name of a number
    that is missing or does not belong to the law.
    """
    numbers = numbers or {}
    law = kind(name)
    takes = numbers_of(law)
    for given in numbers:
        if given not in takes:
            choices = ", ".join(takes) or "no numbers"
            raise RimrollError(f"{typed(law.name)} takes {choices}, got {given}")
    for number_name, needed in takes.items():
        if needed and number_name not in numbers:
            raise RimrollError(f"{typed(law.name)} needs {number_name}")
    return law(**numbers)  # type: ignore[arg-type]
