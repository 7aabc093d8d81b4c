"""The contact laws: rolling, sliding and what lies between."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from rimroll import _core
from rimroll._core import MAX_FRICTION
from rimroll.errors import RimrollError, hold
from rimroll.laws.law import LAWS, Law, contact_law
from rimroll.laws.parameters import FRICTION, RESTITUTION, STATIC, listed
from rimroll.laws.resistances import Resistances
from rimroll.units import Number, Quantity, Values, number
from rimroll.units import numbers as array


@dataclass(frozen=True, repr=False, eq=False)
class NoSlip(Law):
    """Rolling without slip: the point of the rim that touches the table is at rest.

    Source: the paper, Eqs. ``noslip_eqs`` and appendix A. A motion ends where the table would have
    to pull the rim down.
    """

    name: ClassVar[str] = "no_slip"
    color: ClassVar[str] = "#0072B2"
    marker: ClassVar[str] = "o"
    can_stick: ClassVar[bool] = True


@dataclass(frozen=True, repr=False, eq=False)
class Frictionless(Law):
    """Sliding without friction: the table only pushes upward.

    Source: the paper, Eqs. ``nofric_eqs`` and appendix A. The centre of mass moves only vertically.
    A motion ends where the table would have to pull the rim down.
    """

    name: ClassVar[str] = "frictionless"
    color: ClassVar[str] = "#D55E00"
    marker: ClassVar[str] = "s"


@dataclass(frozen=True, repr=False, eq=False)
class InPlace(Law):
    """Wobbling in place: the rim rolls without slip on the circle on which the body stood, θ = −ψ.

    The table exerts a twisting moment, too, as large as it takes, so that the body does not roll
    away. The spin rate of a start must be 0 or minus the yaw rate; the motion has the latter. On a
    table at rest the angular momentum of the yaw is conserved. The limiting turn is that without
    slip. A motion ends where the table would have to pull the rim down.

    Source: M. F. Vassiliou et al., Earthquake Eng. Struct. Dyn. 46 (2017) 2261.
    """

    name: ClassVar[str] = "in_place"
    color: ClassVar[str] = "#332288"
    marker: ClassVar[str] = "X"
    can_stick: ClassVar[bool] = True


@dataclass(frozen=True, repr=False, eq=False)
class Coulomb(Law):
    """Dry friction, with exact phases of rolling, sliding and flight.

    The rim rolls while |T| ≤ ``static`` · N. Then it slips with |T| = ``friction`` · N against the
    slip, and rolls again when the slip stops and friction can hold it. ``static`` is by default
    ``friction``, and must not be smaller. The rim leaves the table where the normal force reaches
    zero. It lands with the energetic coefficient of ``restitution``, 0 to 1, and with ``friction``
    in the impulse, whether it slips or sticks.
    """

    name: ClassVar[str] = "coulomb"
    color: ClassVar[str] = "#CC79A7"
    marker: ClassVar[str] = "D"
    can_stick: ClassVar[bool] = True

    friction: float = FRICTION.field()
    static: float | None = STATIC.field(None)
    restitution: float = RESTITUTION.field(0.0)

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
class Stribeck(Law):
    """Regularised dry friction: T = −μ(u) N u/√(u² + creep_speed²).

    μ(u) = friction + (static − friction) exp(−(u/stribeck_speed)²). Without ``static`` it is
    the regularised Coulomb friction of most physics engines: the rim creeps where it should stick.
    Speeds are in m/s. Source of the curve: Armstrong-Hélouvry, Dupont & Canudas de Wit,
    Automatica 30 (1994).
    """

    name: ClassVar[str] = "stribeck"
    color: ClassVar[str] = "#009E73"
    marker: ClassVar[str] = "^"

    friction: float = FRICTION.field()
    static: float | None = STATIC.field(None)
    stribeck_speed: float = Quantity(
        "m/s", help="For stribeck: slip speed at which static friction fades. [1 cm/s]"
    ).field(0.01)
    creep_speed: float = Quantity(
        "m/s", help="For stribeck: slip speed up to which the rim creeps. [1 mm/s]"
    ).field(1e-3)
    restitution: float = RESTITUTION.field(0.0)

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
class Viscous(Law):
    """A film of oil: T = −``coefficient`` (N s/m) times the slip, for any normal force.

    In the limit of a near-collision, which takes no time, it has no effect. The rim flies and lands
    as under :class:`Coulomb`, but without friction in the impulse.
    """

    name: ClassVar[str] = "viscous"
    color: ClassVar[str] = "#E69F00"
    marker: ClassVar[str] = "v"

    coefficient: float = Quantity(
        "N s/m",
        'For viscous: friction over slip speed, such as "0.5 N s/m".',
        option="viscous_coefficient",
    ).field()
    restitution: float = RESTITUTION.field(0.0)

    if TYPE_CHECKING:

        def __init__(
            self,
            coefficient: Values,
            restitution: Values = 0.0,
            *,
            resistances: Resistances = (),
        ) -> None: ...


Array = NDArray[np.float64]
Curve = Callable[[Array], Array]

MAX_POINTS = 10_000
"""The largest number of points; a function that needs more raises an error."""

CLOSEST = 1e-9
"""How close two points may be, relative to the range of speeds."""

GOLDEN = 0.5 * (np.sqrt(5.0) - 1.0)
PLACES = np.sort(np.arange(1, 65) * GOLDEN % 1.0)
"""Divisions of each interval between given speeds at which the curve is always compared.

Multiples of the golden ratio are spread almost evenly, and have no common measure with a periodic
function, whose every quarter of an interval may look alike. Neighbours are 1/46 apart at most.
"""


def sampled(
    mu: Callable[[float], float],
    speeds: Sequence[float],
    curve_through: Callable[[Sequence[float], Sequence[float]], Curve],
    tolerance: float,
) -> tuple[list[float], list[float]]:
    """Speeds and frictions of points, such that the curve is within ``tolerance`` of ``mu``.

    They begin with ``speeds``. The middle is added of each interval in which the curve is farther
    from ``mu`` at a quarter, half or three quarters of it, or at one of 64 places between each two
    of ``speeds``. Raises ``RimrollError`` where ``mu`` gives no friction, is not continuous, or
    needs more than :data:`MAX_POINTS`.
    """
    known = {speed: _friction(mu, speed) for speed in speeds}
    begin = np.array(speeds)
    places = (begin[:-1, None] + np.diff(begin)[:, None] * PLACES).ravel()
    at_places = _frictions(mu, places)
    while True:
        points = np.array(sorted(known))
        frictions = [known[speed] for speed in points.tolist()]
        curve = curve_through(points.tolist(), frictions)
        middles = points[:-1] + 0.5 * np.diff(points)
        bad = _off_at_quarters(mu, points, curve, tolerance)
        missed = places[np.abs(curve(places) - at_places) > tolerance]
        bad[np.searchsorted(points, missed, side="right") - 1] = True
        new = dict(zip(middles[bad].tolist(), _frictions(mu, middles[bad]).tolist(), strict=True))
        if not new:
            return points.tolist(), frictions
        closest = np.min(np.diff(sorted({*known, *new})))
        span = points[-1] - points[0]
        if len(known) + len(new) > MAX_POINTS or closest < CLOSEST * span:
            raise RimrollError(
                f"mu cannot be followed to {tolerance:g} near {min(new):g} m/s with {len(known)}"
                " points: it must be continuous"
            )
        known |= new


def _friction(mu: Callable[[float], float], speed: float) -> float:
    value = number(f"mu({speed:g})", mu(speed))
    if not 0.0 <= value <= MAX_FRICTION:
        raise RimrollError(f"mu({speed:g}) must be between 0 and {MAX_FRICTION:g}, got {value:g}")
    return value


def _frictions(mu: Callable[[float], float], speeds: Array) -> Array:
    found = np.array([_friction(mu, speed) for speed in speeds.ravel().tolist()], np.float64)
    return found.reshape(speeds.shape)


def _off_at_quarters(
    mu: Callable[[float], float], points: Array, curve: Curve, tolerance: float
) -> NDArray[np.bool_]:
    """The intervals in which the curve is too far from mu at one of their quarters."""
    looks = points[:-1] + np.array([[0.25], [0.5], [0.75]]) * np.diff(points)
    bad: NDArray[np.bool_] = np.abs(curve(looks) - _frictions(mu, looks)).max(axis=0) > tolerance
    return bad


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

    name: ClassVar[str] = "tabulated"
    color: ClassVar[str] = "#882255"
    marker: ClassVar[str] = "P"
    can_stick: ClassVar[bool] = True

    speeds: Sequence[float] = Quantity("m/s", is_list=True).field()
    frictions: Sequence[float] = Quantity(is_list=True).field()
    static: float | None = STATIC.field(None)
    restitution: float = RESTITUTION.field(0.0)

    if TYPE_CHECKING:

        def __init__(
            self,
            speeds: Values,
            frictions: Values,
            static: Values | None = None,
            restitution: Values = 0.0,
            *,
            resistances: Resistances = (),
        ) -> None: ...

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

        Raises ``RimrollError`` if ``mu`` returns anything but a number from 0 to 1e6, is not
        continuous, or needs more than ten thousand points.

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

        Examples
        --------
        >>> import math
        >>> import rimroll as rr
        >>> fading = rr.Tabulated.from_function(
        ...     lambda u: 0.2 + 0.1 * math.exp(-u / 0.05), speeds=[0.0, 1.0]
        ... )
        >>> round(fading.friction_at(0.05), 5)
        0.23679
        """
        if not callable(mu):
            raise RimrollError(field="mu", value=mu, bound="a function of the slip speed")
        tolerance = number("tolerance", tolerance)
        if not tolerance > 0.0:
            raise RimrollError(field="tolerance", value=tolerance, bound="> 0")
        begin = listed("speeds", speeds, "m/s")
        # Raises errors about the speeds before the function is called.
        cls(begin, [0.0] * len(begin))
        points = sampled(mu, begin, lambda u, mus: cls(u, mus).friction_at, tolerance)
        sticking = None if static is None else number("static", static)
        return cls(*points, sticking, number("restitution", restitution))


LAWS |= {
    law.name: law for law in (NoSlip, Frictionless, InPlace, Coulomb, Viscous, Stribeck, Tabulated)
}

assert list(LAWS) == list(_core.LAWS)

IDEAL: tuple[Law, ...] = (NoSlip(), Frictionless())
"""The paper's two laws, for which there are closed forms."""


def has_one_limit(law: Law) -> bool:
    """Whether the limiting turn is a closed form that holds for every arrival without spin."""
    return isinstance(law, NoSlip | Frictionless | InPlace)


def ideal(law: object) -> Law:
    """The law, if it is one of the two with closed forms; else ``RimrollError``."""
    law = contact_law(law)
    if type(law) not in map(type, IDEAL):
        raise RimrollError(field="law", value=law, bound="NoSlip or Frictionless for a closed form")
    return law
