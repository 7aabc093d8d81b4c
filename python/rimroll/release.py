"""How a hand lets go: the scatter of starts from one flick to the next."""

from __future__ import annotations

import math
from dataclasses import asdict, dataclass, fields, replace
from typing import Any, Self

import numpy as np
from numpy.typing import NDArray

from rimroll import _core
from rimroll.body import Body
from rimroll.errors import RimrollError, expect, number
from rimroll.names import choose
from rimroll.state import State
from rimroll.theory import balance_tilt, lift_off_rate

Array = NDArray[np.float64]

MOST_TRIALS = 10_000_000

SURPLUS = 1.7
"""Energy of a flick over what toppling takes: friction in the near-collision wants its part."""


@dataclass(frozen=True)
class Release:
    """The distribution of starts of a body that a hand tilts and lets go or flicks.

    Each quantity is normally distributed, given as ``(mean, spread)`` or as a mean alone; the
    spread is a standard deviation. A perfect hand has all spreads, ``sideways`` and ``twist`` zero.

    Parameters
    ----------
    tilt
        Tilt, rad; what is drawn lies inside (0, π/2).
    tilt_rate
        dφ/dt, rad/s: 0 for a body just let go, negative for one flicked upright.
    sideways
        Angular velocity about the horizontal line along which the body leans, rad/s: how far the
        flick misses the middle. ``tilt_rate`` times the tangent of the error of aim.
    twist
        Angular velocity about the vertical, rad/s.
    grip
        A factor of the law's friction, since no table is the same everywhere; not below 0.

    Raises
    ------
    RimrollError
        A tilt outside (0, π/2), a negative spread, anything that is not finite.
    """

    tilt: tuple[float, float]
    tilt_rate: tuple[float, float] = (0.0, 0.0)
    sideways: tuple[float, float] = (0.0, 0.0)
    twist: tuple[float, float] = (0.0, 0.0)
    grip: tuple[float, float] = (1.0, 0.0)

    def __post_init__(self) -> None:
        for field in fields(self):
            object.__setattr__(self, field.name, _pair(field.name, getattr(self, field.name)))
        if not 0.0 < self.tilt[0] < 0.5 * math.pi:
            raise RimrollError(f"tilt must be inside (0, pi/2), got {self.tilt[0]} rad")
        if self.grip[0] <= 0.0:
            raise RimrollError(f"grip must be > 0, got {self.grip[0]}")

    @classmethod
    def named(cls, name: str, body: Body, gravity: float = _core.STANDARD_GRAVITY) -> Release:
        """The preset of that name (see :data:`PRESETS`) for a body under gravity (m/s²).

        Raises ``RimrollError`` with the nearest name when there is none such.
        """
        expect("body", body, Body)
        return choose("release", name.replace("-", " ").replace("_", " "), PRESETS)(
            body, number("gravity", gravity)
        )

    def unsteady(self, factor: float) -> Self:
        """The same release by a hand whose ``sideways`` and ``twist`` scatter by a factor more."""
        return replace(
            self,
            sideways=(self.sideways[0], factor * self.sideways[1]),
            twist=(self.twist[0], factor * self.twist[1]),
        )

    @property
    def symmetric(self) -> bool:
        """Whether it favours neither left nor right."""
        return self.sideways[0] == 0.0 and self.twist[0] == 0.0

    def draw(self, n: int, seed: int) -> tuple[State, Array]:
        """``n`` starts, a State of arrays (n,), and the grip of each, (n,).

        Trial k is the same whatever ``n``.
        """
        return self.at(np.random.default_rng(seed).random((n, len(fields(self)))))

    def at(self, chances: Array) -> tuple[State, Array]:
        """Starts and grips by inversion of numbers (n, 5) that are even in (0, 1).

        One column a field, in their order, so that releases which differ a little give starts which
        differ a little.
        """
        from scipy.special import ndtr, ndtri

        chances = chances.T
        mean, spread = self.tilt
        low, high = ndtr((np.array([0.0, 0.5 * math.pi]) - mean) / (spread or 1.0))
        tilt = mean + spread * ndtri(low + (high - low) * chances[0])
        tilt_rate, sideways, twist, grip = (
            mean + spread * ndtri(chances[1 + k])
            for k, (mean, spread) in enumerate(
                (self.tilt_rate, self.sideways, self.twist, self.grip)
            )
        )
        start = State(tilt=tilt, tilt_rate=tilt_rate, **_sideways_rates(tilt, sideways, twist))
        return start, np.maximum(grip, 0.0)

    def parameters(self) -> dict[str, float]:
        """Means and spreads by name, in SI units and radians."""
        return {
            name: value
            for field, (mean, spread) in asdict(self).items()
            for name, value in ((f"release_{field}", mean), (f"release_{field}_spread", spread))
        }


def _sideways_rates(tilt: Array, sideways: Array, twist: Array) -> dict[str, Array]:
    """Euler rates of a rotation ``sideways`` e_x1 + ``twist`` e_z, besides the tilting.

    It is ψ̇ e_z + θ̇ e_z2 with the axis e_z2 = −sin φ e_x1 + cos φ e_z.
    """
    sin, cos = np.sin(tilt), np.cos(tilt)
    return {"yaw_rate": twist + sideways * cos / sin, "spin_rate": -sideways / sin}


def _pair(name: str, value: Any) -> tuple[float, float]:
    given = value if isinstance(value, tuple | list) else (value, 0.0)
    if len(given) != 2:
        raise RimrollError(f"{name} must be (mean, spread) or a mean, got {value!r}")
    mean, spread = number(name, given[0]), number(f"{name} spread", given[1])
    if not math.isfinite(mean):
        raise RimrollError(f"{name} must be finite, got {mean}")
    if not 0.0 <= spread < math.inf:
        raise RimrollError(f"{name} spread must be finite and >= 0, got {spread}")
    return mean, spread


def _let_go(body: Body, gravity: float) -> Release:
    tilt = 0.6 * balance_tilt(body)
    slow = 0.002 * math.sqrt(gravity / body.radius)
    return Release((tilt, 0.1 * tilt), (0.0, 5.0 * slow), (0.0, slow), (0.0, slow))


def _flick(body: Body, gravity: float) -> Release:
    """As fast as toppling takes with much to spare, unless the rim would leave the table."""
    tilt = 0.55 * balance_tilt(body)
    m, r, h = body.mass, body.radius, body.height
    rim_inertia = body.transverse_inertia + m * (r * r + h * h)
    weight = m * gravity
    over = r * math.sin(tilt) + h * math.cos(tilt)  # the centre of mass, over the table
    beside = r * math.cos(tilt) - h * math.sin(tilt)  # and beside the rim
    arriving = 2.0 * SURPLUS * weight * (math.hypot(r, h) - h) / rim_inertia
    arriving = min(arriving, (0.9 * lift_off_rate(body, gravity)) ** 2)
    starting = arriving - 2.0 * weight * (over - h) / rim_inertia
    pressing = gravity * (1.0 - m * beside * beside / rim_inertia) / over
    rate = math.sqrt(min(max(starting, 0.0), 0.6 * pressing))
    return Release((tilt, 0.1 * tilt), (-rate, 0.07 * rate), (0.0, 0.05 * rate), (0.0, 0.05 * rate))


def _paper(body: Body, gravity: float) -> Release:
    return Release(
        tilt=(math.radians(20.0), math.radians(2.0)),
        tilt_rate=(-5.0, 0.35),
        sideways=(0.0, 0.5),
        twist=(0.0, 0.5),
    )


PRESETS = {"let go": _let_go, "flick": _flick, "paper": _paper}
"""Releases by name, for a body under gravity.

let go: tilted to 0.6 of the balance tilt and let go by a steady hand.
flick: flicked over from 0.55 of the balance tilt, with energy to spare and an error of aim of 3
degrees; a body that cannot be toppled without lifting it off is flicked less.
paper: a guess at the flicks of the paper, which did not control them. From 20 degrees at 5 rad/s
its can topples without lifting off; an error of aim of 6 degrees spreads the falls by about the
4 degrees that were measured.
"""
