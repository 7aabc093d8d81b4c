"""The scales of rocking: the balance tilt, the rocking frequency, and bodies of another size."""

from __future__ import annotations

import math
from dataclasses import fields
from typing import Any

import numpy as np

from rimroll import _core
from rimroll.bodies.body import Bodies, Body, one_body
from rimroll.errors import hold
from rimroll.many.grid import Grid
from rimroll.units import Number, Values, positive, values


def tilt_of_balance(bodies: Bodies | Body) -> Any:
    """The tilt of unstable equilibrium on the rim, atan(R/H), rad, of bodies of any shape."""
    return np.arctan2(bodies.radius, bodies.height)


def rocking_frequency_of(bodies: Bodies, gravity: float) -> Any:
    """The rocking frequency of each body, rad/s."""
    square = bodies.radius**2 + bodies.height**2
    inertia = bodies.transverse_inertia + bodies.mass * square
    return np.sqrt(bodies.mass * gravity * np.sqrt(square) / inertia)


def rocking_frequency(body: Body, gravity: Number = _core.STANDARD_GRAVITY) -> Any:
    """The rocking frequency p of a body on its rim, rad/s: p² = m g √(R² + H²)/J.

    J = A + m (R² + H²) is the moment of inertia about a point of the rim. A body that rocks has no
    natural frequency; p is the rate at which a body near its balance tilt falls, and the scale of
    the times of rocking (Housner 1963). ``gravity`` is in m/s².

    A single number, or an array or a data array where the body has arrays.

    >>> import rimroll as rr
    >>> column = rr.Body(1000, 0.5, 2.0, 1395.8333333333333, 125.0)
    >>> round(rr.rocking_frequency(column, gravity=9.81), 4)
    1.8926

    Raises ``RimrollError`` unless gravity is positive.
    """
    g = positive("gravity", gravity, "m/s^2")
    grid = Grid.over({field.name: getattr(body, field.name) for field in fields(body)})
    each = np.broadcast_to(rocking_frequency_of(Bodies.of(body, grid), g), grid.size)
    return grid.laid_out(each)


def with_rocking_frequency(body: Body, frequencies: Values, gravity: float) -> Body:
    """Bodies of the same shape and mass whose size gives them these rocking frequencies (rad/s).

    p² is inversely proportional to the length.
    """
    one_body(body)
    wanted = values("frequencies", frequencies, "rad/s")
    array = np.asarray(wanted)
    hold("frequencies", array, (array > 0.0) & np.isfinite(array), "> 0 and finite", "rad/s")
    length = (rocking_frequency(body, gravity) / wanted) ** 2
    ones = length / length
    return Body(
        body.mass * ones,
        body.radius * length,
        body.height * length,
        body.transverse_inertia * length**2,
        body.axial_inertia * length**2,
    )


def tangent(body: Body) -> float:
    """R/H, the tangent of the balance tilt; infinite for a disk."""
    return body.radius / body.height if body.height else math.inf
