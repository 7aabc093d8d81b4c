"""The contact laws: how the rim meets the table, and what wears its motion down.

>>> import rimroll as rr
>>> rr.Coulomb(0.3) + rr.RollingResistance(dry=1e-3)
Coulomb(friction=0.3) + RollingResistance(dry=0.001)
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import MISSING, dataclass, field, fields, replace
from typing import TYPE_CHECKING, ClassVar, Self

from rimroll import _core
from rimroll.errors import RimrollError, expect
from rimroll.given import Number, number
from rimroll.names import choose, typed
from rimroll.units import LAW_UNIT_OF, air_unit

if TYPE_CHECKING:
    import xarray as xr


class _Numbered:
    """Numbers that are checked when they are given."""

    def _read(self) -> None:
        for item in fields(self):  # type: ignore[arg-type]
            value = getattr(self, item.name)
            left_out = value is None and item.default is None
            if item.name != "resistances" and not left_out:
                unit = self._unit_of(item.name)
                object.__setattr__(self, item.name, number(item.name, value, unit))

    def _unit_of(self, name: str) -> str:
        return LAW_UNIT_OF[name]

    def __repr__(self) -> str:
        given = ", ".join(
            f"{item.name}={getattr(self, item.name)!r}"
            for item in fields(self)  # type: ignore[arg-type]
            if item.repr and getattr(self, item.name) != item.default
        )
        return f"{type(self).__name__}({given})"


@dataclass(frozen=True)
class _Alone:
    """A resistance by itself, for the core to check."""

    numbers: dict[str, float]
    name: str = "no_slip"


@dataclass(frozen=True, repr=False)
class RollingResistance(_Numbered):
    """What the contact point's running along the rim at R |dθ/dt| costs.

    The resisting force is ``dry`` for each newton of normal force plus ``viscous`` (N s/m) for each
    m/s. Also called contour friction. In a near-collision the contact point runs without bound: the
    closer, the more it takes. Source: R. I. Leine, Arch. Appl. Mech. 79 (2009).
    """

    dry: float = 0.0
    viscous: float = 0.0

    def __post_init__(self) -> None:
        self._read()
        _core.check_surface(_Alone(self._numbers()))

    def _numbers(self) -> dict[str, float]:
        return {"rolling_dry": self.dry, "rolling_viscous": self.viscous}


@dataclass(frozen=True, repr=False)
class PivotingFriction(_Numbered):
    """What turning about the vertical costs: a moment of ``length`` (m) times the normal force."""

    length: float

    def __post_init__(self) -> None:
        self._read()
        _core.check_surface(_Alone(self._numbers()))

    def _numbers(self) -> dict[str, float]:
        return {"pivoting_length": self.length}


@dataclass(frozen=True, repr=False)
class AirDrag(_Numbered):
    """What the wobble costs in the air under the base: ``coefficient`` |dψ/dt|^``exponent``, W.

    ``coefficient`` in W (s/rad)^exponent; ``exponent`` from 1.5 to 8: 4 for a viscous film
    (Moffatt, Nature 404, 2000), 5/2 for boundary layers (Bildsten, Phys. Rev. E 66, 2002).
    """

    coefficient: float
    exponent: float = 4.0

    def __post_init__(self) -> None:
        self._read()
        _core.check_surface(_Alone(self._numbers()))

    def _unit_of(self, name: str) -> str:
        if name == "coefficient":
            return air_unit(number("exponent", self.exponent))
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
        1.82e-5), ``gravity`` in m/s².
        """
        radius, viscosity = number("radius", radius, "m"), number("viscosity", viscosity, "Pa s")
        gravity = number("gravity", gravity, "m/s^2")
        if not gravity > 0.0:
            raise RimrollError(f"gravity must be > 0, got {gravity} m/s2")
        return cls(math.pi * viscosity * radius**4 / (16.0 * gravity), 4.0)

    def _numbers(self) -> dict[str, float]:
        return {"air_coefficient": self.coefficient, "air_exponent": self.exponent}


Resistance = RollingResistance | PivotingFriction | AirDrag


@dataclass(frozen=True, repr=False)
class Law(_Numbered):
    """How the rim meets the table; add resistances with ``+``."""

    name: ClassVar[str]
    """What a user types on the command line and in scenario files."""

    resistances: tuple[Resistance, ...] = field(default=(), kw_only=True, repr=False)

    def __post_init__(self) -> None:
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
        _core.check_surface(self)

    @classmethod
    def from_xarray(cls, dataset: xr.Dataset) -> Law:
        """The law of a dataset of a motion, of falls or of a map, with its resistances.

        Raises ``RimrollError`` for a dataset of something else.
        """
        from rimroll.ensemble import law_of
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
    def numbers(self) -> dict[str, float]:
        """The law's numbers and those of its resistances, by name, in SI units."""
        own = {
            item.name: value
            for item in fields(self)
            if item.name != "resistances" and (value := getattr(self, item.name)) is not None
        }
        for resistance in self.resistances:
            own |= resistance._numbers()
        return own


@dataclass(frozen=True, repr=False)
class NoSlip(Law):
    """Rolling without slip: the point of the rim that touches the table is at rest.

    Source: the paper, Eqs. ``noslip_eqs`` and appendix A. A motion ends where the rim would have to
    be pulled down.
    """

    name: ClassVar[str] = "no_slip"


@dataclass(frozen=True, repr=False)
class Frictionless(Law):
    """Sliding without friction: the table only pushes upward.

    Source: the paper, Eqs. ``nofric_eqs`` and appendix A. The centre of mass moves only vertically.
    A motion ends where the rim would have to be pulled down.
    """

    name: ClassVar[str] = "frictionless"


@dataclass(frozen=True, repr=False)
class Coulomb(Law):
    """Dry friction, with exact phases of rolling, sliding and flight.

    The rim rolls while |T| ≤ ``static`` · N, then slips under |T| = ``friction`` · N against the
    slip, and rolls again when the slip stops and friction can hold it. ``static`` is ``friction``
    unless given, and not below it. Where the normal force reaches zero the rim leaves the table; it
    lands with the energetic coefficient of ``restitution``, 0 to 1, and with ``friction`` in the
    impulse, whether it slips or sticks.
    """

    friction: float
    static: float | None = None
    restitution: float = 0.0
    name: ClassVar[str] = "coulomb"


@dataclass(frozen=True, repr=False)
class Viscous(Law):
    """A film of oil: T = −``coefficient`` (N s/m) times the slip, whatever the normal force.

    In the limit of a near-collision, which takes no time, it does nothing. It flies and lands like
    :class:`Coulomb`, without friction in the impulse.
    """

    coefficient: float
    restitution: float = 0.0
    name: ClassVar[str] = "viscous"


@dataclass(frozen=True, repr=False)
class Stribeck(Law):
    """Dry friction made smooth: T = −μ(u) N u/√(u² + creep_speed²).

    μ(u) = friction + (static − friction) exp(−(u/stribeck_speed)²). With ``static`` left out it is
    the regularised Coulomb friction of most physics engines: the rim creeps where it should stick.
    Speeds in m/s. Source of the curve: Armstrong-Hélouvry, Dupont & Canudas de Wit, Automatica 30
    (1994).
    """

    friction: float
    static: float | None = None
    stribeck_speed: float = 0.01
    creep_speed: float = 1e-3
    restitution: float = 0.0
    name: ClassVar[str] = "stribeck"


IDEAL: tuple[Law, ...] = (NoSlip(), Frictionless())
"""The paper's two laws, for which there are closed forms."""

LAWS: dict[str, type[Law]] = {
    law.name: law for law in (NoSlip, Frictionless, Coulomb, Viscous, Stribeck)
}
"""The laws by name, in the core's order."""

assert list(LAWS) == list(_core.LAWS)


def ideal(law: object) -> Law:
    """The law, if it is one of the two with closed forms; else ``RimrollError``."""
    expect("law", law, Law)
    assert isinstance(law, Law)
    if type(law) not in (NoSlip, Frictionless):
        raise RimrollError(f"law must be NoSlip or Frictionless for a closed form, got {law!r}")
    return law


def kind(name: str) -> type[Law]:
    """The class of law of that name, typed like ``no-slip`` or ``no_slip``.

    Raises ``RimrollError`` with the nearest name when there is none such.
    """
    return choose("law", name, {typed(known): law for known, law in LAWS.items()})


def numbers_of(law: type[Law]) -> dict[str, bool]:
    """The numbers that a law takes by name, and whether it cannot do without."""
    return {
        item.name: item.default is MISSING for item in fields(law) if item.name != "resistances"
    }


def by_name(name: str, numbers: Mapping[str, float] | None = None) -> Law:
    """The law of that name with these numbers; ``-`` may stand for ``_``.

    Raises ``RimrollError`` with the nearest name when there is none such, and naming the number
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
