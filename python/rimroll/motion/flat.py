"""What follows where the whole base comes down flat at once."""

from __future__ import annotations

from typing import TYPE_CHECKING

from rimroll.errors import RimrollError
from rimroll.given import number, whole_number

if TYPE_CHECKING:
    from rimroll.ground.ground import Ground

FlatLanding = str | float | tuple[str, int]
"""See ``flat`` of :func:`rimroll.simulate`."""

KINDS = ("stop", "smooth", "smooth_left", "smooth_right", "housner")


ON_MOVING_TABLES: FlatLanding = "housner"
"""What follows on a table that moves unless it is given: a plastic collision."""


def landing_given(flat: object, moves: bool) -> FlatLanding:
    """As :func:`flat_given`; None stands for ``housner`` on a table that moves, else ``stop``."""
    if flat is None:
        return ON_MOVING_TABLES if moves else "stop"
    return flat_given(flat)


def flat_given(flat: object) -> FlatLanding:
    """A flat landing as users give it, or as a text; raises ``RimrollError`` for another value."""
    if isinstance(flat, str):
        flat = _of_text(flat)
    if isinstance(flat, str) and flat in KINDS:
        return flat
    if isinstance(flat, tuple) and len(flat) == 2 and flat[0] == "smooth":
        return ("smooth", whole_number("flat seed", flat[1]))
    if isinstance(flat, str | bool | tuple) or flat is None:
        raise RimrollError(
            field="flat",
            value=flat,
            bound=f"""one of {", ".join(KINDS)}, ("smooth", seed) or a restitution from 0 to 1""",
        )
    return number("flat", flat)


def _of_text(text: str) -> object:
    """``smooth:7`` and ``0.5`` as they are given in Python; another text with _ for -."""
    kind, colon, seed = text.partition(":")
    if colon and seed.isdecimal():
        return kind, int(seed)
    try:
        return float(text)
    except ValueError:
        return text.replace("-", "_")


def flat_as_text(flat: FlatLanding) -> str | float:
    """A flat landing as a text or a number, which :func:`flat_given` reads."""
    return ":".join(map(str, flat)) if isinstance(flat, tuple) else flat


def flat_in_core(flat: FlatLanding, gap: float) -> tuple[str, float, int, float]:
    """A flat landing as the core takes it: its kind, the restitution, the seed and the gap, m."""
    if isinstance(flat, str):
        return flat, 0.0, 0, gap
    if isinstance(flat, tuple):
        return flat[0], 0.0, flat[1], gap
    return "restitution", float(flat), 0, gap


def ground_given(ground: object) -> Ground | None:
    """A motion of the table as users give it; raises ``RimrollError`` for another value."""
    if ground is None:
        return None
    from rimroll.errors import expect
    from rimroll.ground.ground import Ground

    expect("ground", ground, Ground)
    assert isinstance(ground, Ground)
    return ground
