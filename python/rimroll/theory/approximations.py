"""The paper's approximations: the near-collision alone, and matched to a pendulum."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from rimroll import _core
from rimroll.bodies.body import Body, one_body
from rimroll.errors import expect, hold
from rimroll.laws import Law, ideal
from rimroll.state import State, single, times
from rimroll.units import Number, Values, number

Array = NDArray[np.float64]


class NearCollision:
    """The motion close to the smallest tilt, where gravity no longer matters.

    φ² = φ_c² + ω² t² and ψ = ±√(J'/K') arctan(ω t/φ_c), with t (s) and ψ counted from the smallest
    tilt. Source: the paper, Eqs. ``phiandt`` and ``psidotandphi``.

    Parameters
    ----------
    body, law
        What rocks, and how its rim meets the table.
    min_tilt
        φ_c > 0, rad.
    tipping_rate
        ω > 0, rad/s: |dφ/dt| before and after.
    direction
        1 or −1: the sign of the turn.
    """

    def __init__(
        self, body: Body, law: Law, min_tilt: Number, tipping_rate: Number, direction: float = 1.0
    ) -> None:
        one_body(body)
        min_tilt = number("min_tilt", min_tilt, "rad")
        tipping_rate = number("tipping_rate", tipping_rate, "rad/s")
        direction = number("direction", direction)
        self._core = _core.CoreNearCollision(
            body, ideal(law).name, min_tilt, tipping_rate, direction
        )
        self.min_tilt = min_tilt
        self.tipping_rate = tipping_rate

    def tilt(self, t: Values) -> Array:
        """φ(t), rad, shape (n,)."""
        return self._core.tilt(np.atleast_1d(times(t)))

    def yaw(self, t: Values) -> Array:
        """ψ(t), rad, shape (n,)."""
        return self._core.yaw(np.atleast_1d(times(t)))

    def yaw_rate(self, t: Values) -> Array:
        """dψ/dt, rad/s, shape (n,)."""
        return self._core.yaw_rate(np.atleast_1d(times(t)))

    def lean_vector(self, until: Number) -> tuple[Array, Array, Array]:
        """The paper's heuristic: the lean as a plane vector q, integrated from the smallest tilt.

        q'' = −(1 − K'/J') (q × q')² q/|q|⁴, a central force. Returns the arrays t (s, up to
        ``until``), φ = |q| and ψ, the angle of q (rad), at the solver's steps.
        """
        t, tilt, yaw = self._core.lean_vector(number("until", until, "s"))
        return t, tilt, yaw


class Composite:
    """The composite approximation: a pendulum matched to a near-collision.

    φ ≈ φ_pendulum(|t − t_c|) + √(φ_c² + ω²(t − t_c)²) − ω|t − t_c| and
    ψ ≈ ψ₀ ± √(J'/K') [π/2 + arctan(ω(t − t_c)/φ_c)], with errors of the order φ_c² ln φ_c in φ and
    φ_c ln φ_c in ψ. It covers one rocking, |t − t_c| ≤ ``half_width``. Make it with
    :func:`composite`.
    """

    min_tilt_time: float
    """t_c, the time of the smallest tilt, s after the release."""
    half_width: float
    """The time that the pendulum takes to fall, s."""
    min_tilt: float
    """φ_c, the smallest tilt, rad."""
    tipping_rate: float
    """ω = |dφ/dt| just outside the near-collision, rad/s."""

    def __init__(self, core: _core.CoreComposite) -> None:
        self._core = core
        self.min_tilt_time, self.half_width, self.min_tilt, self.tipping_rate, _ = core.numbers

    def tilt(self, t: Values) -> Array:
        """φ at the times t (s), rad, shape (n,)."""
        return self._core.tilt(self._inside(t))

    def yaw(self, t: Values) -> Array:
        """ψ at the times t (s), rad, shape (n,)."""
        return self._core.yaw(self._inside(t))

    def _inside(self, t: Values) -> Array:
        given = times(t)
        middle = self.min_tilt_time
        first, last = middle - self.half_width, middle + self.half_width
        bound = f"inside the rocking that is approximated, {first:.6g} to {last:.6g} s"
        # Rounding may put the end itself slightly outside.
        near = np.abs(given - middle) <= self.half_width * (1 + 1e-9)
        hold("t", given, near, bound, "s")
        return np.atleast_1d(given)


def composite(
    body: Body, start: State, law: Law, gravity: Number = _core.STANDARD_GRAVITY
) -> Composite:
    """The composite approximation of tipping and near-collision for a body released at ``start``.

    Source: the paper's "pasting-together of two qualitatively distinct motions", described there in
    words. Everything follows from the start alone: the plane pendulum gives t_c and ω; and l =
    dψ/dt sin²φ, which is linear in the sideways rates, gives φ_c = |l| √(K'/J')/ω.

    Raises ``RimrollError`` for a start that never comes down or comes down flat.
    """
    one_body(body)
    expect("start", start, State)
    gravity = number("gravity", gravity, "m/s^2")
    return Composite(_core.CoreComposite(body, single(start), ideal(law).name, gravity))


pasted = composite
"""The paper's name for :func:`composite`."""
