"""Resistances to the motion, besides friction, which are added to a law."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, ClassVar

import numpy as np

from rimroll import _core
from rimroll.laws.parameters import Parameters, check, only_fixed, varied_numbers
from rimroll.units import Number, Quantity, Values, air_unit, number, positive, quantities_of


class _Resistance(Parameters):
    """A resistance, whose numbers are checked by the core."""

    core_prefix: ClassVar[str]
    """Begins the core's names of the numbers: ``rolling_dry``."""

    def __post_init__(self) -> None:
        self._read()
        varied = varied_numbers(self.numbers)
        check(only_fixed("no_slip", self.numbers, varied), varied)

    @classmethod
    def core_names(cls) -> list[str]:
        """The core's names of the numbers, in the order of the arguments."""
        return [f"{cls.core_prefix}_{name}" for name in quantities_of(cls)]

    @property
    def numbers(self) -> dict[str, float]:
        """The numbers by the core's names, in SI units."""
        values = (getattr(self, name) for name in quantities_of(type(self)))
        return dict(zip(self.core_names(), values, strict=True))


@dataclass(frozen=True, repr=False, eq=False)
class RollingResistance(_Resistance):
    """Resistance to the motion of the contact point along the rim, at speed R |dθ/dt|.

    The resisting force is ``dry`` times the normal force plus ``viscous`` (N s/m) times the speed.
    It is also called contour friction. The closer a near-collision, the faster the contact point
    runs and the more energy is lost, without bound. The sign function of ``dry`` is smoothed where
    the base turns slower than 0.001 √(g/R). Source: R. I. Leine, Arch. Appl. Mech. 79 (2009).

    A resistance can stop the contact point in a near-collision: see the notes of
    :func:`rimroll.simulate`.
    """

    core_prefix: ClassVar[str] = "rolling"
    dry: float = Quantity(
        help="Resisting force over normal force, against rolling.", option="rolling_resistance"
    ).field(0.0)
    viscous: float = Quantity(
        "N s/m", "Resisting force over rolling speed, in N s/m.", option="rolling_viscous"
    ).field(0.0)

    if TYPE_CHECKING:

        def __init__(self, dry: Values = 0.0, viscous: Values = 0.0) -> None: ...


@dataclass(frozen=True, repr=False, eq=False)
class PivotingFriction(_Resistance):
    """Resistance to turning about the vertical: a moment ``length`` (m) times the normal force."""

    core_prefix: ClassVar[str] = "pivoting"
    length: float = Quantity(
        "m",
        "Resisting moment over normal force, against turning about the vertical.",
        option="pivoting_friction",
    ).field()

    if TYPE_CHECKING:

        def __init__(self, length: Values) -> None: ...


@dataclass(frozen=True, repr=False, eq=False)
class AirDrag(_Resistance):
    """Dissipation of the wobble in the air under the base: ``coefficient`` |dψ/dt|^``exponent``, W.

    ``coefficient`` in W (s/rad)^exponent; ``exponent`` from 1.5 to 8: 4 for a viscous film
    (Moffatt, Nature 404, 2000), 5/2 for boundary layers (Bildsten, Phys. Rev. E 66, 2002).

    For exponents below 2 the moment has an infinite slope at dψ/dt = 0. There |dψ/dt| is replaced
    by √((dψ/dt)² + ω₀²) with ω₀ = 0.002 ``rtol`` (√(g/R) + axial spin rate), which changes the drag
    on larger rates by less than a change of dψ/dt by ω₀ would. A dψ/dt below ω₀ decays
    exponentially instead of stopping after a finite time: choose ``rtol`` so that ω₀ is well below
    the yaw rate of the start. For ``rtol`` below 2.5e-13, ω₀ stays at its value for 2.5e-13.
    """

    core_prefix: ClassVar[str] = "air"
    coefficient: float = Quantity(
        help="Power over (yaw rate)^exponent, in W (s/rad)^exponent, or film: a film of air under"
        " the base.",
        option="air_drag",
    ).field()
    exponent: float = Quantity(
        help="1.5 to 8; a viscous film has 4. [4]", option="air_exponent"
    ).field(4.0)

    if TYPE_CHECKING:

        def __init__(self, coefficient: Values, exponent: Values = 4.0) -> None: ...

    @classmethod
    def unit_of(cls, name: str, numbers: Mapping[str, Any]) -> str:
        if name == "coefficient":
            exponent = numbers.get("exponent", cls.exponent)
            # Several exponents have no common unit.
            return "1" if np.ndim(exponent) else air_unit(number("exponent", exponent))
        return super().unit_of(name, numbers)

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
        radius = positive("radius", radius, "m")
        viscosity = positive("viscosity", viscosity, "Pa s")
        gravity = positive("gravity", gravity, "m/s^2")
        return cls(math.pi * viscosity * radius**4 / (16.0 * gravity), 4.0)


Resistance = RollingResistance | PivotingFriction | AirDrag

RESISTANCES: tuple[type[Resistance], ...] = (RollingResistance, PivotingFriction, AirDrag)

Resistances = Resistance | tuple[Resistance, ...]
