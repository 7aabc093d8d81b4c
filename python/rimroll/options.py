"""How motions are followed."""

from __future__ import annotations

from dataclasses import dataclass

from rimroll import _core
from rimroll.given import number, optional, whole_number


@dataclass(frozen=True)
class Options:
    """See :func:`rimroll.simulate`, whose defaults these are."""

    duration: float = 2.0
    gravity: float = _core.STANDARD_GRAVITY
    rtol: float = 1e-10
    topple_tilt: float | None = None
    max_steps: int = 1_000_000

    @classmethod
    def read(
        cls, duration: object, gravity: object, rtol: object, topple_tilt: object, max_steps: object
    ) -> Options:
        """Options as users give them; raises ``RimrollError`` for other values."""
        return cls(
            number("duration", duration, "s"),
            number("gravity", gravity, "m/s^2"),
            number("rtol", rtol),
            optional("topple_tilt", topple_tilt, "rad"),
            whole_number("max_steps", max_steps),
        )

    @property
    def values(self) -> tuple[float, float, float, float | None, int]:
        """The options in the order of the core's arguments."""
        return self.duration, self.gravity, self.rtol, self.topple_tilt, self.max_steps
