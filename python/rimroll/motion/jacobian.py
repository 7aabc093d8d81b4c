"""Exact derivatives of a motion by what it was computed from."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from rimroll import _core
from rimroll.bodies.solids import SIZES
from rimroll.errors import choose
from rimroll.options import Options
from rimroll.state import START_NUMBERS
from rimroll.units import quantities_of

if TYPE_CHECKING:
    import xarray as xr

QUANTITIES = ("tilt", "tilt_rate", "yaw", "yaw_rate", "spin", "spin_rate")
"""The differentiated quantities, in the order of :attr:`Jacobian.values`."""

PARAMETERS = tuple(_core.PARAMETERS)
"""The parameters: start, body and gravity, in the order of :attr:`Jacobian.values`."""

SHAKEN_PARAMETERS = tuple(_core.SHAKEN_PARAMETERS)
"""The parameters on a table that moves: also ``ground_scale``, a factor on its acceleration."""

UNIT_OF_PARAMETER = {
    name: one.unit for name, one in (START_NUMBERS | SIZES | quantities_of(Options)).items()
} | {"ground_scale": "1"}

_INDEX_OF_QUANTITY = {name: i for i, name in enumerate(QUANTITIES)}


@dataclass(frozen=True)
class Jacobian:
    """The derivatives of a motion's state at fixed times.

    ``jacobian["yaw", "tilt_rate"]`` is the derivative of the yaw at that time by the tilt rate at
    the start, with all other parameters fixed. Its unit is the quantity's unit over the
    parameter's, in SI units and radians.
    """

    values: NDArray[np.float64]
    """Shape (6, 12) for one time, (n, 6, 12) for n; 13 in place of 12 on a table that moves."""
    t: NDArray[np.float64]
    """The time, or times (n,), s."""

    @property
    def parameters(self) -> tuple[str, ...]:
        """The parameters, in the order of :attr:`values`.

        They are the start, the body and gravity and, on a table that moves, ``ground_scale``: the
        factor s on the acceleration s a(t) of the table, at s = 1.
        """
        return SHAKEN_PARAMETERS[: self.values.shape[-1]]

    def __getitem__(self, names: tuple[str, str]) -> NDArray[np.float64] | np.float64:
        """The derivative of a quantity by a parameter: a number for one time, else shape (n,)."""
        row = choose("quantity", names[0], _INDEX_OF_QUANTITY)
        index = {name: i for i, name in enumerate(self.parameters)}
        column = choose("parameter", names[1], index)
        derivative: NDArray[np.float64] | np.float64 = self.values[..., row, column]
        return derivative

    def to_xarray(self) -> xr.Dataset:
        """The derivatives as ``derivative`` over (``t``,) ``quantity`` and ``parameter``.

        The coordinates ``quantity_units`` and ``parameter_units`` hold the units.
        """
        import xarray as xr

        over = ("t",) if self.values.ndim == 3 else ()
        return xr.Dataset(
            {"derivative": ((*over, "quantity", "parameter"), self.values)},
            coords={
                "t": (over, self.t, {"units": "s"}),
                "quantity": list(QUANTITIES),
                "parameter": list(self.parameters),
                "quantity_units": ("quantity", [UNIT_OF_PARAMETER[name] for name in QUANTITIES]),
                "parameter_units": (
                    "parameter",
                    [UNIT_OF_PARAMETER[name] for name in self.parameters],
                ),
            },
        )

    def __repr__(self) -> str:
        number = "one time" if self.values.ndim == 2 else f"{len(self.values)} times"
        return (
            f"<Jacobian at {number}, shape {self.values.shape}:"
            f" d({', '.join(QUANTITIES)}) by d({', '.join(self.parameters)})>"
        )
