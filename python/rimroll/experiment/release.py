"""How a hand releases a body: the scatter of starts from one flick to the next."""

from __future__ import annotations

import math
from dataclasses import asdict, dataclass, fields, replace
from statistics import NormalDist
from typing import Any, Self

import numpy as np
from numpy.typing import NDArray

from rimroll import _core
from rimroll.bodies.body import Body, one_body
from rimroll.errors import RimrollError, choose
from rimroll.state import State
from rimroll.theory.closed_forms import balance_tilt
from rimroll.units import (
    Number,
    Quantity,
    in_degrees_hint,
    number,
    positive,
    random_seed,
    table_of,
    whole_number,
)

Array = NDArray[np.float64]

MAX_TRIALS = 10_000_000

SURPLUS = 1.7
"""Ratio of a flick's energy to that needed to topple, since friction takes some of it."""

SPREAD = "_spread"
"""The end of the name of a standard deviation."""

NUMBERS = table_of(
    tilt=Quantity("rad", "Mean tilt.", hint="tilt"),
    tilt_spread=Quantity("rad", "Standard deviation, like all spreads."),
    tilt_rate=Quantity("rad/s", "Mean tilt rate; negative: flicked upright."),
    tilt_rate_spread=Quantity("rad/s", "Its spread."),
    sideways=Quantity(
        "rad/s", "Rate about the line of lean: the error of aim times the tilt rate."
    ),
    sideways_spread=Quantity("rad/s", "Its spread."),
    twist=Quantity("rad/s", "Rate about the vertical."),
    twist_spread=Quantity("rad/s", "Its spread."),
    friction_scale=Quantity(),
    friction_scale_spread=Quantity(
        "1", "Spread of the friction, relative to it: 0.1 or 10%.", metavar="PART"
    ),
    unsteadiness=Quantity("1", "Multiply the spreads of sideways and twist.", metavar="FACTOR"),
)
"""The means and spreads of a release, and a factor on two spreads."""

MIN_CHANCE = 2.0**-54
"""Replaces a random number 0, which has no quantile."""


def normal_quantiles(chances: Array) -> Array:
    """The numbers below which a standard normal number lies with chances inside (0, 1)."""
    numbers = map(NormalDist().inv_cdf, chances.ravel().tolist())
    return np.fromiter(numbers, np.float64, chances.size).reshape(chances.shape)


def _chance_below(x: float) -> float:
    """The chance of a standard normal number below x; exact also where it is tiny."""
    return 0.5 * math.erfc(-x / math.sqrt(2.0))


@dataclass(frozen=True)
class Release:
    """The distribution of starts of a body that a hand tilts and releases or flicks.

    Each quantity is normally distributed, given as ``(mean, spread)`` or as a mean alone; the
    spread is a standard deviation. For a perfect hand all spreads, ``sideways`` and ``twist`` are
    zero.

    Parameters
    ----------
    tilt
        Tilt, rad; its distribution is truncated to (0, π/2).
    tilt_rate
        dφ/dt, rad/s: 0 for a body released at rest, negative for one flicked upright.
    sideways
        Angular velocity about the horizontal line along which the body leans, rad/s: ``tilt_rate``
        times the tangent of the error of aim.
    twist
        Angular velocity about the vertical, rad/s.
    friction_scale
        A factor on the law's friction, since no table is the same everywhere; not below 0.

    Raises
    ------
    RimrollError
        A tilt outside (0, π/2), a negative spread, anything that is not finite.
    """

    tilt: tuple[float, float]
    tilt_rate: tuple[float, float] = (0.0, 0.0)
    sideways: tuple[float, float] = (0.0, 0.0)
    twist: tuple[float, float] = (0.0, 0.0)
    friction_scale: tuple[float, float] = (1.0, 0.0)

    def __post_init__(self) -> None:
        for field in fields(self):
            object.__setattr__(self, field.name, _pair(field.name, getattr(self, field.name)))
        if not 0.0 < self.tilt[0] < 0.5 * math.pi:
            degrees = in_degrees_hint(self.tilt[0]) if self.tilt[0] > math.pi else ""
            raise RimrollError(
                field="tilt",
                value=self.tilt[0],
                bound="inside (0, pi/2)",
                unit="rad",
                hint=degrees,
            )
        if self.friction_scale[0] <= 0.0:
            raise RimrollError(field="friction_scale", value=self.friction_scale[0], bound="> 0")

    @classmethod
    def named(cls, name: str, body: Body, gravity: Number = _core.STANDARD_GRAVITY) -> Release:
        """The preset of that name (see :data:`PRESETS`) for a body under gravity (m/s²).

        Raises ``RimrollError`` with the nearest name when there is none such.
        """
        one_body(body)
        gravity = positive("gravity", gravity, "m/s^2")
        return choose("release", name, PRESETS)(body, gravity)

    def with_unsteadiness(self, factor: float) -> Self:
        """A copy with the spreads of ``sideways`` and ``twist`` multiplied by a factor."""
        return replace(
            self,
            sideways=(self.sideways[0], factor * self.sideways[1]),
            twist=(self.twist[0], factor * self.twist[1]),
        )

    @property
    def mean(self) -> State[float]:
        """The start from the mean tilt at the mean tilt rate, without sideways rates."""
        return State(tilt=self.tilt[0], tilt_rate=self.tilt_rate[0])

    @property
    def symmetric(self) -> bool:
        """Whether left and right are equally likely."""
        return self.sideways[0] == 0.0 and self.twist[0] == 0.0

    def draw(self, n: int, seed: int) -> tuple[State, Array]:
        """``n`` starts, a State of arrays (n,), and the friction scale of each, (n,).

        Trial k is the same whatever ``n``. Raises ``RimrollError`` unless ``n`` is a whole number
        from 1 to :data:`MAX_TRIALS` and ``seed`` one from 0 to below 2⁶³.
        """
        count = whole_number("n", n)
        if count > MAX_TRIALS:
            raise RimrollError(field="n", value=count, bound=f"at most {MAX_TRIALS}")
        return self.at(self.chances(0, count, random_seed(seed)))

    @classmethod
    def chances(cls, first: int, last: int, seed: int) -> Array:
        """The random numbers (n, 5) of the trials from ``first`` to before ``last``.

        Each trial has its own five, uniform in (0, 1).
        """
        count = len(fields(cls))
        bits = np.random.PCG64(seed)
        bits.advance(count * first)
        numbers = np.random.Generator(bits).random((last - first, count))
        return np.maximum(numbers, MIN_CHANCE)

    def at(self, chances: Array) -> tuple[State, Array]:
        """Starts and friction scales from numbers (n, 5) that are uniform in (0, 1), by inversion.

        There is one column for each field, in their order, so that similar releases give similar
        starts.
        """
        chances = chances.T
        mean, spread = self.tilt
        low, high = (_chance_below((end - mean) / (spread or 1.0)) for end in (0.0, 0.5 * math.pi))
        tilt = mean + spread * normal_quantiles(low + (high - low) * chances[0])
        tilt_rate, sideways, twist, friction_scale = (
            mean + spread * normal_quantiles(chances[1 + k])
            for k, (mean, spread) in enumerate(
                (self.tilt_rate, self.sideways, self.twist, self.friction_scale)
            )
        )
        start = State(tilt=tilt, tilt_rate=tilt_rate, **_sideways_rates(tilt, sideways, twist))
        return start, np.maximum(friction_scale, 0.0)

    def parameters(self) -> dict[str, float]:
        """Means and spreads by name, in SI units and radians."""
        return {
            name: value
            for field, (mean, spread) in asdict(self).items()
            for name, value in ((f"release_{field}", mean), (f"release_{field}_spread", spread))
        }


def _sideways_rates(tilt: Any, sideways: Any, twist: Any) -> dict[str, Any]:
    """Yaw and spin rate of the rotation ``sideways`` e_x1 + ``twist`` e_z.

    The rotation is ψ̇ e_z + θ̇ e_z2 with the axis e_z2 = −sin φ e_x1 + cos φ e_z.
    """
    sin, cos = np.sin(tilt), np.cos(tilt)
    return {"yaw_rate": twist + sideways * cos / sin, "spin_rate": -sideways / sin}


def _pair(name: str, value: Any) -> tuple[float, float]:
    given = value if isinstance(value, tuple | list) else (value, 0.0)
    if len(given) != 2:
        raise RimrollError(field=name, value=value, bound="(mean, spread) or a mean")
    unit = NUMBERS[name].unit
    mean, spread = number(name, given[0], unit), number(f"{name}_spread", given[1], unit)
    if not math.isfinite(mean):
        raise RimrollError(field=name, value=mean, bound="finite")
    if not 0.0 <= spread < math.inf:
        raise RimrollError(field=f"{name}_spread", value=spread, bound="finite and >= 0")
    return mean, spread


def _let_go(body: Body, gravity: float) -> Release:
    tilt = 0.5 * balance_tilt(body)
    slow = 0.002 * math.sqrt(gravity / body.radius)
    return Release((tilt, 0.05 * tilt), (0.0, 5.0 * slow), (0.0, slow), (0.0, slow))


def _flick(body: Body, gravity: float) -> Release:
    """A flick with more energy than toppling needs, unless the rim would then leave the table."""
    tilt = 0.5 * balance_tilt(body)
    weight = body.mass * gravity
    over = body.radius * math.sin(tilt) + body.height * math.cos(tilt)
    barrier = math.hypot(body.radius, body.height) - body.height
    wanted = SURPLUS * barrier - (over - body.height)
    squared = 2.0 * weight * wanted / _rim_inertia(body)
    allowed = 0.75 * _fastest_squared(body, 1.2 * tilt, gravity)
    slowest = 0.05 * math.sqrt(gravity / body.radius)
    rate = max(math.sqrt(max(min(squared, allowed), 0.0)), slowest)
    return Release((tilt, 0.1 * tilt), (-rate, 0.07 * rate), (0.0, 0.05 * rate), (0.0, 0.05 * rate))


def nudged(body: Body, gravity: float, tilt: float | None = None) -> State:
    """A start from which a body rocks: released at half its balance tilt with a small side push.

    It is the mean of the release ``let_go`` with a push of one standard deviation; ``tilt`` (rad)
    replaces its tilt.
    """
    release = Release.named("let_go", body, gravity)
    start = State(tilt=release.tilt[0] if tilt is None else tilt)
    assert isinstance(start.tilt, float)
    rates = _sideways_rates(np.float64(start.tilt), release.sideways[1], 0.0)
    return replace(start, **rates)


def _rim_inertia(body: Body) -> float:
    """A + m(R² + H²), about a tangent of the rim."""
    return body.transverse_inertia + body.mass * (body.radius**2 + body.height**2)


def _fastest_squared(body: Body, tilt: float, gravity: float) -> float:
    """The largest (dφ/dt)² with which a rolling rim stays on the table from a tilt down to 0.

    Negative if the rim leaves the table even when released at rest, like a disk at a large tilt.
    """
    m, r, h = body.mass, body.radius, body.height
    tilts = np.linspace(0.0, tilt, 101)
    sin, cos = np.sin(tilts), np.cos(tilts)
    over, beside = r * sin + h * cos, r * cos - h * sin  # the centre of mass, and the rim
    inertia = _rim_inertia(body)
    gained = 2.0 * m * gravity * (over[-1] - over) / inertia
    pressing = gravity * (1.0 - m * beside**2 / inertia)  # N/m, without the term −over (dφ/dt)²
    with np.errstate(divide="ignore"):  # a disk's centre of mass comes down to the table
        return float(np.min(pressing / over - gained))


def _paper(body: Body, gravity: float) -> Release:
    return Release(
        tilt=(math.radians(20.0), math.radians(2.0)),
        tilt_rate=(-5.0, 0.35),
        sideways=(0.0, 0.5),
        twist=(0.0, 0.5),
    )


PRESETS = {"let_go": _let_go, "flick": _flick, "paper": _paper}
"""Releases by name, for a body under gravity.

let_go: tilted to half the balance tilt and released by a steady hand; the body rocks.
flick: flicked over from half the balance tilt, with more energy than it needs and an error of aim
of 3 degrees. A low, wide body that would then leave the table before it topples is flicked less
hard, and rocks. On a table without friction a tall, thin body may rock, too.
paper: an estimate of the flicks of the paper, which did not control them. From 20 degrees at
5 rad/s its can topples without lifting off; an error of aim of 6 degrees spreads the falls by
about 4 degrees, as measured.
"""
