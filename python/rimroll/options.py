"""How motions are followed."""

from __future__ import annotations

from dataclasses import dataclass, fields
from typing import TYPE_CHECKING

from rimroll import _core
from rimroll.given import number, optional, whole_number
from rimroll.recorded import not_recorded

if TYPE_CHECKING:
    import xarray as xr


@dataclass(frozen=True)
class Options:
    """See :func:`rimroll.simulate`, whose defaults these are."""

    duration: float = 2.0
    gravity: float = _core.STANDARD_GRAVITY
    rtol: float = 1e-10
    topple_tilt: float | None = None
    max_steps: int = 1_000_000
    flat_gap: float = 0.0

    @classmethod
    def read(
        cls,
        duration: object,
        gravity: object,
        rtol: object,
        topple_tilt: object,
        max_steps: object,
        flat_gap: object = 0.0,
    ) -> Options:
        """Options as users give them; raises ``RimrollError`` for other values."""
        return cls(
            number("duration", duration, "s"),
            number("gravity", gravity, "m/s^2"),
            number("rtol", rtol),
            optional("topple_tilt", topple_tilt, "rad"),
            whole_number("max_steps", max_steps),
            number("flat_gap", flat_gap, "m"),
        )

    @property
    def values(self) -> tuple[float, float, float, float | None, int]:
        """The options of all motions in the order of the core's arguments."""
        return self.duration, self.gravity, self.rtol, self.topple_tilt, self.max_steps


def options_of(dataset: xr.Dataset) -> Options:
    """The options of a motion or of falls.

    Raises ``RimrollError`` for a dataset without them.
    """
    given = {field.name: dataset.attrs.get(field.name) for field in fields(Options)}
    given["flat_gap"] = dataset.attrs.get("flat_gap", Options.flat_gap)
    for name, value in given.items():
        if value is None and name != "topple_tilt":
            raise not_recorded("options", name)
    return Options.read(**given)
