"""Where the body is and how it moves."""

from __future__ import annotations

import math
from dataclasses import dataclass, fields

import numpy as np
from numpy.typing import NDArray

from rimroll.errors import RimrollError, hold
from rimroll.given import Values, numbers
from rimroll.units import START_UNIT_OF

Numbers = float | NDArray[np.float64]


@dataclass(frozen=True, kw_only=True, eq=False)
class State:
    """Position and motion in the paper's Euler angles (rad, rad/s).

    Every field is a number or an array, or carries a unit as :mod:`rimroll.given` describes; arrays
    must agree in shape, and numbers stand for all.

    Parameters
    ----------
    tilt
        φ, inside (0, π): 0 is upright, the base flat on the table.
    tilt_rate
        dφ/dt; negative while falling toward upright.
    yaw
        ψ: turns with the contact point, which is at azimuth ψ + π as seen from the base's centre.
    yaw_rate
        dψ/dt.
    spin
        θ: about the symmetry axis, relative to the frame that yaws and tilts. A body that just
        falls over turns yaw and spin oppositely.
    spin_rate
        dθ/dt.

    Raises
    ------
    RimrollError
        A value that is not a finite number, a unit of another kind, a tilt outside (0, π), arrays
        that differ in shape; of an array the message names the element, ``tilt[1]``.
    """

    tilt: Numbers
    tilt_rate: Numbers = 0.0
    yaw: Numbers = 0.0
    yaw_rate: Numbers = 0.0
    spin: Numbers = 0.0
    spin_rate: Numbers = 0.0

    def __post_init__(self) -> None:
        if self._is_plain():
            return
        for field in fields(self):
            value = _finite(field.name, getattr(self, field.name))
            object.__setattr__(self, field.name, float(value) if value.ndim == 0 else value)
        shapes = {f.name: np.shape(getattr(self, f.name)) for f in fields(self)}
        if len({shape for shape in shapes.values() if shape}) > 1:
            arrays = ", ".join(f"{name} {shape}" for name, shape in shapes.items() if shape)
            raise RimrollError(f"the arrays of a State must agree in shape, got {arrays}")
        tilt = np.asarray(self.tilt)
        hold("tilt", tilt, (tilt > 0.0) & (tilt < np.pi), "inside (0, pi)", "rad")

    def _is_plain(self) -> bool:
        """Whether it is of valid floats, as most are, for which nothing more is to be done."""
        values = vars(self).values()
        plain = all(type(value) is float and math.isfinite(value) for value in values)
        return plain and 0.0 < self.tilt < math.pi  # type: ignore[return-value]

    @property
    def shape(self) -> tuple[int, ...]:
        """Shape of the arrays; () when every field is a single number."""
        return np.broadcast_shapes(*(np.shape(getattr(self, f.name)) for f in fields(self)))


def single(start: State) -> State:
    """The start itself, when it is one; raises ``RimrollError`` for a State of arrays."""
    # Its fields are floats or arrays; numpy is slow to say so.
    if not all(isinstance(value, float) for value in vars(start).values()):
        raise RimrollError(f"a motion has one start, got arrays of shape {start.shape}")
    return start


def times(t: Values) -> NDArray[np.float64]:
    """Times (s) as an array () or (n,); raises ``RimrollError`` for anything else."""
    array = numbers("t", t, "s")
    if array.ndim > 1:
        raise RimrollError(f"t must be a number or a flat array, got shape {array.shape}")
    return array


def _finite(field: str, value: object) -> NDArray[np.float64]:
    array = numbers(field, value, START_UNIT_OF[field])
    hold(field, array, np.isfinite(array), "finite")
    return array
