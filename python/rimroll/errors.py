"""The errors that rimroll raises."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray


class RimrollError(ValueError):
    """An invalid request; the message names the value and what is allowed."""


def expect(field: str, value: object, kind: Any) -> None:
    """Raise ``RimrollError`` unless the value is of the kind, a class or a union of classes."""
    if not isinstance(value, kind):
        kinds = " or ".join(
            "None" if k is type(None) else f"{k.__module__.split('.')[0]}.{k.__name__}"
            for k in getattr(kind, "__args__", (kind,))
        )
        name = getattr(value, "__name__", "something callable")
        given = f"{name} itself: call it" if callable(value) else repr(value)
        raise RimrollError(f"{field} must be a {kinds}, got {given}")


def hold(
    field: str,
    values: NDArray[np.float64],
    holds: NDArray[np.bool_],
    bound: str,
    unit: str = "",
    hint: Callable[[float], str] | None = None,
) -> None:
    """Raise ``RimrollError`` unless the bound holds for a number, or for each element of an array.

    The message names the first invalid element, as in ``tilt[1] must be finite, got nan``. It ends
    with the ``hint`` for that element.
    """
    if not holds.all():
        import numpy as np  # not before: whoever only reports errors needs none

        index = tuple(np.argwhere(~holds)[0])
        got = f"{values[index]} {unit}".removesuffix(" 1").rstrip()
        advice = hint(float(values[index])) if hint else ""
        raise RimrollError(f"{element(field, index)} must be {bound}, got {got}{advice}")


def element(field: str, index: Iterable[int]) -> str:
    """How messages name an element of an array, ``tilt[1]``, and a single number, ``tilt``."""
    place = ", ".join(map(str, index))
    return f"{field}[{place}]" if place else field


def callback(field: str, value: object) -> None:
    """Raise ``RimrollError`` unless the value is None or can be called."""
    if value is not None and not callable(value):
        raise RimrollError(f"{field} must be None or something to call, got {value!r}")


class NoNearCollision(RimrollError):
    """A start whose motion has no near-collision to describe.

    Attributes
    ----------
    in_degrees
        The message with angles in degrees instead of radians.
    status
        How the motion ends that comes in place of one, as ``Motion.status``; None where the start
        is refused for another reason.
    """

    def __init__(self, message: str, in_degrees: str, status: str | None) -> None:
        super().__init__(message, in_degrees, status)
        self.in_degrees = in_degrees
        self.status = status

    def __str__(self) -> str:
        return str(self.args[0])


class UnitError(RimrollError):
    """A quantity whose text has no number, an unknown unit, or a unit of another kind."""
