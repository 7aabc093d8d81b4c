"""The balance of a body whose filling is liquid, with a level surface."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from rimroll import _core
from rimroll.errors import RimrollError

if TYPE_CHECKING:
    from rimroll.body import Body


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
