"""One nutation of a rolling body, and the path of its contact point, which repeats it."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from rimroll import _core
from rimroll.bodies.body import Body, one_body
from rimroll.errors import RimrollError, choose, expect
from rimroll.laws import NoSlip
from rimroll.motion import Moments, Motion, simulate
from rimroll.state import START_NUMBERS, State, single
from rimroll.theory.steady import steady_motions
from rimroll.units import Number, number

LONGEST = 2.0**14
"""How long a nutation is looked for, in units of the time √(R/g)."""

SAME = 1e-9
"""Times closer than this fraction of a nutation are the same, and angles closer than this, rad."""


@dataclass(frozen=True)
class Nutation:
    """A nutation, from one tilt maximum to the next, of a body that rolls without slip.

    The next nutation is the same, turned by the yaw advance about a centre. So the path of the
    contact point stays between two circles about that centre and fills the ring between them,
    unless the yaw advance is a fraction of 2π; then it closes. If the yaw advance is a multiple of
    2π, there is no centre: the path goes on in one direction without bound, or it closes if the
    drift is zero.
    """

    period: float
    """Time between two tilt maxima, s."""
    min_tilt: float
    """Smallest tilt, rad."""
    max_tilt: float
    """Largest tilt, rad; for a disk that passes the vertical it is above π/2."""
    yaw_advance: float
    """Change of yaw in a nutation, rad, with its sign."""
    drift: float
    """Distance between the contact points at the beginning and at the end of a nutation, m."""
    center: tuple[float, float]
    """Centre of the path, m, from the point under the centre of mass at the start. It is infinite
    if the path is unbounded, and NaN if the path closes after one nutation."""
    inner_radius: float
    """Smallest distance of the contact point from the centre, m."""
    outer_radius: float
    """Largest distance of the contact point from the centre, m."""
    cusps: int
    """Cusps of the path in a nutation. There the spin rate dθ/dt changes its sign."""
    inflections: int
    """Inflections of the path in a nutation. There the yaw rate changes its sign."""

    @property
    def is_bounded(self) -> bool:
        """Whether the path stays near its place."""
        return not math.isinf(self.outer_radius)

    @property
    def kind(self) -> str:
        """What the path looks like.

        ``petals``: it always bends to the same side and never stops. ``cusps``: it stops and goes
        back. ``inflections``: it bends to both sides. ``cusps and inflections``: both. (A steady
        motion, without nutation, draws a circle.)
        """
        seen = [name for name in ("cusps", "inflections") if getattr(self, name)]
        return " and ".join(seen) or "petals"


def nutation(body: Body, start: State, *, gravity: Number = _core.STANDARD_GRAVITY) -> Nutation:
    """The nutation of a body that rolls without slip, and what follows for its contact point.

    Parameters
    ----------
    body, start
        What rolls, and a state of its motion.
    gravity
        m/s².

    Raises
    ------
    RimrollError
        A number outside its bounds; a motion that topples, lifts off or is steady, so that the tilt
        has no two maxima.

    Notes
    -----
    The motion is symmetric in time about each tilt extremum. The velocity of the contact point is R
    dθ/dt along the tangent of the rim, which turns with the yaw rate. So the path has a cusp where
    dθ/dt passes through zero, and an inflection where the yaw rate does. See A. V. Borisov, I. S.
    Mamaev and A. A. Kilin, *Dynamics of rolling disk*, Regular and Chaotic Dynamics 8 (2003) 201,
    for the paths of a disk and the resonance at which they are unbounded.
    """
    one_body(body)
    expect("start", start, State)
    g = number("gravity", gravity, "m/s^2")
    release = single(start)
    _not_steady(body, release, g)
    motion, first, second = _between_maxima(body, release, g)
    lowest = _extrema(motion, rising=True)
    middle = float(lowest[(lowest > first) & (lowest < second)][0])
    at = motion.evaluate(np.array([first, middle, second]))
    advance = float(at.yaw[2] - at.yaw[0])
    center = _fixed_point(at.contact_path[0], at.contact_path[2], advance, SAME * body.radius)

    def along(at: Moments) -> NDArray[np.float64]:
        """The distance of the contact point from the centre, measured along the rim's tangent."""
        x, y = (at.contact_path - center).T
        return np.asarray(y * np.cos(at.yaw) - x * np.sin(at.yaw))

    cusps = _half(motion, first, middle, lambda at: at.spin_rate)
    turned = _half(motion, first, middle, along) if np.isfinite(center[0]) else np.empty(0)
    extremes = motion.evaluate(np.array([first, middle, *cusps, *turned])).contact_path
    distances = np.linalg.norm(extremes - center, axis=1)
    return Nutation(
        period=second - first,
        min_tilt=float(at.tilt[1]),
        max_tilt=float(at.tilt[0]),
        yaw_advance=advance,
        drift=float(np.linalg.norm(at.contact_path[2] - at.contact_path[0])),
        center=(float(center[0]), float(center[1])),
        inner_radius=float(distances.min()),
        outer_radius=float(distances.max()),
        cusps=2 * len(cusps),
        inflections=2 * len(_half(motion, first, middle, lambda at: at.yaw_rate)),
    )


def resonant_start(
    body: Body,
    start: State,
    quantity: str,
    between: tuple[Number, Number],
    *,
    revolutions: int = 1,
    gravity: Number = _core.STANDARD_GRAVITY,
) -> State[float]:
    """A start at a resonance: the yaw advances by whole revolutions in a nutation.

    There the contact point of a rolling body moves on by the same :attr:`Nutation.drift` in each
    nutation, in one direction without bound. The resonances are surfaces in the space of starts:
    for each number of revolutions one condition, which a single quantity of the start can meet.

    Parameters
    ----------
    body, start
        What rolls, and a start.
    quantity
        What is changed to meet the resonance: ``tilt``, ``tilt_rate``, ``yaw_rate`` or
        ``spin_rate``.
    between
        Two values of the quantity, SI units or radians. The excess of the yaw advance over that of
        the resonance must change its sign between them, and each start between them must nutate.
    revolutions
        How often the yaw goes round in a nutation, with its sign.
    gravity
        m/s².

    Raises
    ------
    RimrollError
        An unknown quantity, the same sign at both values, or a start without nutation.
    """
    from scipy.optimize import brentq

    quantities = ("tilt", "tilt_rate", "yaw_rate", "spin_rate")
    name = choose("quantity", quantity, {name: name for name in quantities})
    expect("start", start, State)
    release = single(start)
    low, high = (number("between", value, START_NUMBERS[name].unit) for value in between)

    def changed(value: float) -> State[float]:
        return replace(release, **{name: value})

    def excess(value: float) -> float:
        found = nutation(body, changed(value), gravity=gravity)
        return found.yaw_advance - 2.0 * math.pi * revolutions

    ends = excess(low), excess(high)
    if ends[0] * ends[1] > 0.0:
        advances = [(end + 2.0 * math.pi * revolutions) / (2.0 * math.pi) for end in ends]
        raise RimrollError(
            f"must enclose a resonance: the yaw advances by {advances[0]:.4g} and"
            f" {advances[1]:.4g} revolutions there, both on one side of {revolutions}",
            "between",
        )
    return changed(float(brentq(excess, low, high, xtol=1e-14, rtol=1e-14)))


def _not_steady(body: Body, start: State[float], gravity: float) -> None:
    if start.tilt_rate != 0.0:
        return
    rates = {
        "yaw_rate": start.yaw_rate,
        "axial_spin": start.spin_rate + start.yaw_rate * math.cos(start.tilt),
    }
    if steady_motions(body, NoSlip(), start.tilt, gravity=gravity, **rates):
        raise RimrollError(
            "there is no nutation: the motion is steady, and rimroll.steady_motions has its"
            " rate of small nutations"
        )


def _between_maxima(body: Body, start: State[float], gravity: float) -> tuple[Motion, float, float]:
    """A motion with two tilt maxima, and their times."""
    scale = math.sqrt(body.radius / gravity)
    duration = 16.0 * scale
    while duration <= LONGEST * scale:
        motion = simulate(body, start, NoSlip(), duration, gravity=gravity, rtol=1e-12)
        maxima = _extrema(motion, rising=False)
        if len(maxima) > 1:
            return motion, float(maxima[0]), float(maxima[1])
        if motion.status != "finished":
            raise RimrollError(f"there is no nutation: {motion.message}")
        duration *= 4.0
    raise RimrollError(
        f"there is no nutation: the tilt has no two maxima in {duration / 4.0:.3g} s"
    )


def _extrema(motion: Motion, *, rising: bool) -> NDArray[np.float64]:
    """Times of the tilt minima, where the tilt rate rises through zero, or of the maxima."""
    found = motion.crossings(lambda at: at.tilt_rate, rising=rising)
    return np.array([event.t for event in found])


def _half(
    motion: Motion, first: float, middle: float, function: Callable[[Moments], NDArray[np.float64]]
) -> NDArray[np.float64]:
    """Times at which a function changes its sign between a tilt maximum and the minimum after it.

    Functions that are even in time about an extremum do not change their sign there.
    """
    times = np.array([event.t for event in motion.crossings(function)])
    margin = SAME * (middle - first)
    return times[(times > first + margin) & (times < middle - margin)]


def _fixed_point(
    before: NDArray[np.float64], after: NDArray[np.float64], angle: float, same: float
) -> NDArray[np.float64]:
    """The point about which a rotation takes one point to another.

    It is infinite for a translation, and NaN for one by less than the distance ``same`` (m).
    """
    half = math.remainder(angle, 2.0 * math.pi) / 2.0
    if abs(half) < SAME:
        return np.full(2, np.inf if np.linalg.norm(after - before) > same else np.nan)
    across = np.array([before[1] - after[1], after[0] - before[0]])
    return 0.5 * (before + after) + across / (2.0 * math.tan(half))
