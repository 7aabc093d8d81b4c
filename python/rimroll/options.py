"""How motions are followed."""

from __future__ import annotations

from dataclasses import dataclass

from rimroll import _core


@dataclass(frozen=True)
class Options:
    """See :func:`rimroll.simulate`, whose defaults these are."""

    duration: float = 2.0
    gravity: float = _core.STANDARD_GRAVITY
    rtol: float = 1e-10
    topple_tilt: float | None = None
    max_steps: int = 1_000_000

    @property
    def values(self) -> tuple[float, float, float, float | None, int]:
        """The same as the core takes them."""
        return self.duration, self.gravity, self.rtol, self.topple_tilt, self.max_steps
