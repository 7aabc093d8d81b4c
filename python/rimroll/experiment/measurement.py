"""A body from kitchen measurements: R, H, A and C with a ruler and a stopwatch.

L = √(R² + H²) is the distance from the rim to the centre of mass, g gravity.

* H: where the body, lying on its side, balances across an edge; or the tilt at which it balances
  on its rim, tan φ* = R/H.
* A: the period T of small swings as a pendulum hung from a point of its rim. About the tangent of
  the rim there, A + mL² = mgL (T/2π)². Or the time from being let go at a tilt to the next tilt
  maximum, two planar falls about the rim.
* C: the same pendulum swinging across, about the horizontal axis perpendicular to that tangent. Or
  the time in which it rolls down a slope on its side. No limiting angle of turn depends on C.

The paper gives A/m = 5.13e-3 m² for its can, but not how this was measured.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cached_property

from uncertainties import UFloat, ufloat, umath, wrap

from rimroll import _core
from rimroll.bodies.body import Body
from rimroll.errors import RimrollError, choose
from rimroll.experiment.readings import ESTIMATE, Readings, pretty
from rimroll.units import Number

RADIUS = (("radius",), ("diameter",))
HEIGHT = (("balance_point",), ("balance_tilt",))
TRANSVERSE = (("swings", "swings_time"), ("swing_period",), ("rocking_tilt", "rocking_time"))
ACROSS = (("across_swings", "across_time"), ("across_period",))
SLOPE = (
    ("slope_length", "slope_height", "slope_time"),
    ("slope_length", "slope_angle", "slope_time"),
)
"""The ways to measure each number."""

PIVOTS = {name: name for name in ("edge", "point")}
"""Supports of the body while it swings across."""

ROUNDING = 1e-9  # relative tolerance of bounds

Reading = Number | None


@dataclass(frozen=True, eq=False)
class Measurement:
    """A measured body: numbers with standard uncertainties, SI units and radians.

    The numbers are ``uncertainties.UFloat``, with ``.nominal_value`` and ``.std_dev``. They are
    correlated: ``transverse_inertia / mass`` has the uncertainty of that ratio.
    """

    body: Body
    """The best values."""
    mass: UFloat
    radius: UFloat
    height: UFloat
    transverse_inertia: UFloat
    axial_inertia: UFloat
    readings: Mapping[str, UFloat]
    """The readings that it was computed from."""
    axial_inertia_measured: bool
    """False if C is an estimate for a hollow vessel."""

    def _repr_html_(self) -> str:
        """The view in notebooks."""
        from rimroll.experiment.readings import pretty
        from rimroll.figures.notebook import table, view

        estimated = "" if self.axial_inertia_measured else " (estimated)"
        rows = (
            ("mass", self.mass, "kg"),
            ("radius of the rim", self.radius, "m"),
            ("height of the centre of mass", self.height, "m"),
            ("transverse inertia A", self.transverse_inertia, "kg m^2"),
            (f"axial inertia C{estimated}", self.axial_inertia, "kg m^2"),
            ("turns without slip", self.turn_no_slip, "rad"),
            ("turns without friction", self.turn_frictionless, "rad"),
            ("friction needed to roll", self.needed_friction, "1"),
        )
        cells = ((name, pretty(value, unit)) for name, value, unit in rows)
        return view("Measurement", table(cells))

    @property
    def turn_no_slip(self) -> UFloat:
        """Limiting angle of turn without slip, rad: π √(1 + mR²/(A + mH²))."""
        rolling = self.transverse_inertia + self.mass * self.height**2
        return math.pi * umath.sqrt(1.0 + self.mass * self.radius**2 / rolling)

    @property
    def turn_frictionless(self) -> UFloat:
        """Limiting angle of turn without friction, rad: π √(1 + mR²/A)."""
        return math.pi * umath.sqrt(1.0 + self.mass * self.radius**2 / self.transverse_inertia)

    @property
    def needed_friction(self) -> UFloat:
        """Friction coefficient needed to roll through: μ* = mHR/(A + mH²)."""
        rolling = self.transverse_inertia + self.mass * self.height**2
        return self.mass * self.height * self.radius / rolling


def measure(
    *,
    mass: Reading = None,
    radius: Reading = None,
    diameter: Reading = None,
    length: Reading = None,
    balance_point: Reading = None,
    balance_tilt: Reading = None,
    swings: Reading = None,
    swings_time: Reading = None,
    swing_period: Reading = None,
    across_swings: Reading = None,
    across_time: Reading = None,
    across_period: Reading = None,
    across_pivot: str | None = None,
    swing_amplitude: Reading = None,
    pivot_radius: Reading = None,
    pivot_height: Reading = None,
    rocking_tilt: Reading = None,
    rocking_time: Reading = None,
    slope_length: Reading = None,
    slope_height: Reading = None,
    slope_angle: Reading = None,
    slope_time: Reading = None,
    side_radius: Reading = None,
    gravity: Reading = _core.STANDARD_GRAVITY,
) -> Measurement:
    """A body and its uncertainties from kitchen measurements.

    >>> can = measure(
    ...     mass="70 g", diameter="10.2 cm", balance_point="6.9 cm", swings=50, swings_time="38.3 s"
    ... )
    >>> print(f"{can.transverse_inertia / can.mass:.1ue} m²")
    (5.14+/-0.07)e-03 m²

    Plain numbers are in SI units and exact, as are quantities of pint.
    Numbers of ``uncertainties``, with or without a unit of pint, bring their own standard
    uncertainty. Texts carry units and, where they state it, an uncertainty, as in ``"70 ± 1 g"`` or
    ``"6.9(1) cm"``; else it is half a unit of the last digit and for times at least 0.1 s (rocking:
    1/30 s).

    Parameters
    ----------
    mass
        m. It is required, and so is one way each to measure R, H and A.
    radius, diameter
        R of the rim, or 2R.
    length
        Length of the body from its base to its top. It is only used to check that the centre of
        mass and the pivot lie within.
    balance_point, balance_tilt
        H, the distance from the base at which the body on its side balances across an edge; or the
        tilt at which it balances on its rim. A liquid filling moves while the body is tipped: empty
        it, or see :func:`rimroll.balance_tilt`.
    swings, swings_time, swing_period
        Number of swings, each there and back, and their total time; or the time of one swing. The
        body hangs from a point of the rim of its base and swings about the tangent there.
    across_swings, across_time, across_period
        Number of swings across, and their total time; or the time of one swing; for C.
    across_pivot
        Support of the swings across: an ``"edge"`` that holds the axis of rotation (the default),
        or a ``"point"``, a hook or a thread, on which the body can twist as it swings.
    swing_amplitude
        Angle to which it swung on either side; by default small.
    pivot_radius, pivot_height
        The pivot, if it is not on the rim of the base: distance from the symmetry axis, and height
        above the base, as for a mug that hangs on its lip.
    rocking_tilt, rocking_time
        Tilt of a release at rest, and the time until the next tilt maximum, for A. Losses shorten
        this time, so swings are better.
    slope_length, slope_height, slope_angle, slope_time, side_radius
        Rolling on its side from rest down a slope, for C: the distance, its height or angle, the
        time, and the radius on which the body rolls, by default R.
    gravity
        g; by default standard gravity.

    Raises
    ------
    RimrollError
        A measurement is missing, given twice, or impossible for a rigid body; the message names
        the measurement that is most likely wrong.
    """
    given = dict(locals())
    return measured(given, given.pop("across_pivot"))


def measured(
    given: Mapping[str, object], across_pivot: str | None, typed: Callable[[str], str] = str
) -> Measurement:
    """:func:`measure` of readings by name, which messages write as ``typed`` has them."""
    rest = dict(given)
    gravity = rest.pop("gravity", None)
    usual = _core.STANDARD_GRAVITY if gravity is None else gravity
    readings = Readings({**rest, "gravity": usual}, typed)  # it is listed last
    missing = readings.lacking([(("mass",),), RADIUS, HEIGHT, TRANSVERSE])
    if missing:
        raise RimrollError(f"a measurement also needs {'; '.join(missing)}")
    bench = _Bench(readings, across_pivot)
    mass, radius, height = readings["mass"], bench.radius, bench.height
    transverse, axial = bench.transverse_inertia, bench.axial_inertia()
    numbers = (mass, radius, height, transverse, axial)
    m, r, h, a, c = (number.nominal_value for number in numbers)
    return Measurement(
        Body(m, r, h, a, min(c, 2.0 * a)),  # C = 2A may be off by a rounding error
        *numbers,
        readings=readings,
        axial_inertia_measured=readings.way(ACROSS + SLOPE) is not None,
    )


class _Bench:
    """The kitchen table: how the numbers of a body follow from readings."""

    def __init__(self, readings: Readings, across_pivot: str | None) -> None:
        self.readings, self.typed = readings, readings.typed
        self.mass, self.gravity = readings["mass"], readings["gravity"]
        self.radius = 0.5 * readings["diameter"] if "diameter" in readings else readings["radius"]
        self.height = self._height()
        self._check_length()
        self.pivot = self._pivot(across_pivot)
        across = readings.get("pivot_radius", self.radius)
        below = self.height - readings.get("pivot_height", 0.0)
        self.arm = across, below, umath.sqrt(across**2 + below**2)

    def _height(self) -> UFloat:
        if "balance_point" in self.readings:
            return self.readings["balance_point"]
        tilt = self.readings["balance_tilt"]
        return self.radius * umath.cos(tilt) / umath.sin(tilt)

    def _check_length(self) -> None:
        """Raise ``RimrollError`` if the pivot or centre of mass is clearly above the body's top."""
        if "length" not in self.readings:
            return
        length, way = self.readings["length"], self.readings.way(HEIGHT)
        assert way is not None
        heights = {way[0]: self.height}
        if "pivot_height" in self.readings:
            heights["pivot_height"] = self.readings["pivot_height"]
        for name, height in heights.items():
            over = height - length
            if over.nominal_value > 2.0 * over.std_dev + ROUNDING * length.nominal_value:
                what = "the pivot" if name == "pivot_height" else "the centre of mass"
                raise RimrollError(
                    f"{self.typed(name)}: {what} would be {pretty(height.nominal_value, 'm')} above"
                    f" the base, but must be at most {pretty(length.nominal_value, 'm')}, the"
                    f" {self.typed('length')}"
                )

    def _pivot(self, across_pivot: str | None) -> str:
        swung = self.readings.way(ACROSS) is not None
        if across_pivot is not None and not swung:
            raise RimrollError(f"{self.typed('across_pivot')} needs {self.typed('across_swings')}")
        if not swung and self.readings.way(TRANSVERSE) == TRANSVERSE[2]:
            for name in ("swing_amplitude", "pivot_radius", "pivot_height"):
                if name in self.readings:
                    raise RimrollError(f"{self.typed(name)} needs {self.typed('swings')}")
        return choose(self.typed("across_pivot"), across_pivot or "edge", PIVOTS)

    @cached_property
    def transverse_inertia(self) -> UFloat:
        """A, from swings or from rocking."""
        way = self.readings.way(TRANSVERSE)
        assert way is not None
        return self._from_rocking() if way == TRANSVERSE[2] else self._from_swings(way)

    def axial_inertia(self) -> UFloat:
        """C, from swings across, from rolling, or the estimate for a hollow vessel."""
        self.readings.way(ACROSS + SLOPE)  # complains of both
        if across := self.readings.way(ACROSS):
            return self._from_swings_across(across)
        if self.readings.way(SLOPE):
            return self._from_slope()
        return self._estimate()

    def _period(self, way: tuple[str, ...]) -> UFloat:
        """The period in the limit of small swings: T times the arithmetic-geometric mean of 1 and
        cos(a/2) for the amplitude a (Gauss), 1 − a²/16 ...
        """
        period = self.readings[way[-1]]
        if len(way) == 2:
            period = period / self.readings[way[0]]
        if "swing_amplitude" not in self.readings:
            return period
        mean, other = 1.0, umath.cos(0.5 * self.readings["swing_amplitude"])
        for _ in range(5):  # each doubles the digits
            mean, other = 0.5 * (mean + other), umath.sqrt(mean * other)
        return period * mean

    def _swinging_inertia(self, period: UFloat) -> UFloat:
        """The moment of inertia about the axis of the swings, less mL²."""
        arm = self.arm[2]
        return self.mass * arm * (self.gravity * (period / (2.0 * math.pi)) ** 2 - arm)

    def _swing_period_of(self, inertia: UFloat) -> float:
        """The period, s, for a moment of inertia less mL²."""
        arm = self.arm[2]
        period = 2.0 * math.pi * umath.sqrt((inertia / (self.mass * arm) + arm) / self.gravity)
        return float(period.nominal_value)

    def _from_swings(self, way: tuple[str, ...]) -> UFloat:
        period = self._period(way)
        inertia = self._swinging_inertia(period)
        if inertia.nominal_value <= 0.0:
            least = self._swing_period_of(0.0 * inertia)
            raise RimrollError(
                f"{self.typed(way[-1])}: a swing takes {period.nominal_value:.4g} s, but hung"
                f" {pretty(self.arm[2].nominal_value, 'm')} from its centre of mass a body of any"
                f" size takes more than {least:.4g} s; a swing is there and back"
            )
        return inertia

    def _from_rocking(self) -> UFloat:
        """Two planar falls about the rim: J φ'' = −mgL sin(φ* − φ), from rest to upright."""
        tilt, time = self.readings["rocking_tilt"], self.readings["rocking_time"]
        balance = umath.atan2(self.radius, self.height)
        if tilt.nominal_value >= balance.nominal_value:
            raise RimrollError(
                f"{self.typed('rocking_tilt')} must be less than the tilt at which the body"
                f" balances, {pretty(balance.nominal_value, 'rad')}, got"
                f" {pretty(tilt.nominal_value, 'rad')}"
            )
        arm = umath.sqrt(self.radius**2 + self.height**2)
        fall = wrap(_fall_time)(balance - tilt, balance)
        inertia = self.mass * arm * (self.gravity * (0.5 * time / fall) ** 2 - arm)
        if inertia.nominal_value <= 0.0:
            least = 2.0 * fall * umath.sqrt(arm / self.gravity)
            raise RimrollError(
                f"{self.typed('rocking_time')}: {time.nominal_value:.4g} s from this tilt to the"
                f" next maximum, but a body of any size takes more than"
                f" {least.nominal_value:.4g} s; it is there and back up on the other side"
            )
        return inertia

    def _from_swings_across(self, way: tuple[str, ...]) -> UFloat:
        period, transverse = self._period(way), self.transverse_inertia
        inertia = self._swinging_inertia(period)
        p, q, arm = self.arm
        if self.pivot == "edge":  # (A q² + C p²)/L²
            least, most = transverse * q**2 / arm**2, transverse * (q**2 + 2.0 * p**2) / arm**2
        else:  # it twists, with no angular momentum about the vertical
            least, most = 0.0 * transverse, 2.0 * transverse * arm**2 / (p**2 + 2.0 * q**2)
        low, high = self._swing_period_of(least), self._swing_period_of(most)
        if not low < period.nominal_value <= high * (1.0 + ROUNDING):
            hung, other = ("an edge", "a point") if self.pivot == "edge" else ("a point", "an edge")
            raise RimrollError(
                f"{self.typed(way[-1])}: a swing across takes {period.nominal_value:.4g} s, but on"
                f" {hung} this body's takes between {low:.4g} s (C = 0) and {high:.4g} s (C = 2A);"
                f" or did it hang on {other} ({self.typed('across_pivot')})?"
            )
        if self.pivot == "edge":
            return (inertia * arm**2 - transverse * q**2) / p**2
        return inertia * transverse * p**2 / (transverse * arm**2 - inertia * q**2)

    def _from_slope(self) -> UFloat:
        """C = m r² (g sin α t²/(2 l) − 1)."""
        length, time = self.readings["slope_length"], self.readings["slope_time"]
        if "slope_angle" in self.readings:
            sine = umath.sin(self.readings["slope_angle"])
        else:
            sine = self.readings["slope_height"] / length
        if "slope_height" in self.readings and sine.nominal_value >= 1.0:
            height = pretty(self.readings["slope_height"].nominal_value, "m")
            raise RimrollError(
                f"{self.typed('slope_height')} must be less than {self.typed('slope_length')}, the"
                f" way along the slope, got {height}"
            )
        side = self.readings.get("side_radius", self.radius)
        ratio = self.gravity * sine * time**2 / (2.0 * length) - 1.0
        inertia = ratio * self.mass * side**2
        twice = 2.0 * self.transverse_inertia
        least = umath.sqrt(2.0 * length / (self.gravity * sine)).nominal_value
        begin = f"{self.typed('slope_time')}: {time.nominal_value:.4g} s down this slope, but"
        if ratio.nominal_value <= 0.0:
            raise RimrollError(f"{begin} even sliding without friction takes {least:.4g} s")
        if ratio.nominal_value > 1.0 + 2.0 * ratio.std_dev + ROUNDING:
            raise RimrollError(
                f"{begin} what rolls on its widest part, and does not slip or stop, takes at most"
                f" {math.sqrt(2.0) * least:.4g} s"
            )
        if inertia.nominal_value > twice.nominal_value * (1.0 + ROUNDING):
            most = least * umath.sqrt(1.0 + twice / (self.mass * side**2)).nominal_value
            raise RimrollError(f"{begin} a body with this A takes at most {most:.4g} s (C = 2A)")
        return inertia

    def _estimate(self) -> UFloat:
        """Between a solid side, mr²/2, and a thin wall, mr², each as likely; C ≤ 2A."""
        outermost = self.mass * self.readings.get("side_radius", self.radius) ** 2
        twice = 2.0 * self.transverse_inertia
        low, high = 0.5, min(1.0, (twice / outermost).nominal_value)
        if high <= low:
            raise RimrollError(
                f"C cannot be guessed for so flat a body, A = {pretty(0.5 * twice, 'kg m^2')}:"
                f" measure it, with {self.typed('across_swings')} or {self.typed('slope_time')};"
                f" or A is wrong: look at {self.typed(self._slowest())} again"
            )
        share = ufloat(0.5 * (low + high), (high - low) / math.sqrt(12.0), tag=ESTIMATE)
        return share * outermost

    def _slowest(self) -> str:
        way = self.readings.way(TRANSVERSE)
        assert way is not None
        return way[-1]


def _fall_time(below: float, balance: float) -> float:
    """Time of a planar fall from rest to upright in units of √(J/mgL).

    ``below`` is how far the body starts from its balance tilt, rad. With v = π − φ* + φ it is a
    pendulum near its turning point: K(m) − F(θ|m), m = cos²(below/2), sin θ = cos(φ*/2)/√m.
    """
    from scipy.special import ellipk, ellipkinc  # slow to load

    modulus = math.cos(0.5 * below) ** 2
    end = math.asin(min(1.0, math.cos(0.5 * balance) / math.cos(0.5 * below)))
    return float(ellipk(modulus) - ellipkinc(end, modulus))
