"""The errors rimroll raises on purpose."""

from typing import Any


class RimrollError(ValueError):
    """A request that cannot be met; the message names the value at fault and what is allowed."""


def expect(field: str, value: object, kind: Any) -> None:
    """Raise ``RimrollError`` unless the value is of the kind, a class or a union of classes."""
    if not isinstance(value, kind):
        kinds = " or ".join(
            "None" if k is type(None) else f"rimroll.{k.__name__}"
            for k in getattr(kind, "__args__", (kind,))
        )
        name = getattr(value, "__name__", "something callable")
        given = f"{name} itself: call it" if callable(value) else repr(value)
        raise RimrollError(f"{field} must be a {kinds}, got {given}")


def number(field: str, value: object) -> float:
    """The value of a field as a float.

    Raises ``RimrollError`` naming the field when the value is not a single number.
    """
    if not isinstance(value, str | bytes | bool):
        try:
            return float(value)  # type: ignore[arg-type]
        except (TypeError, ValueError, OverflowError):
            pass
    raise RimrollError(f"{field} must be a single number, got {value!r}")


class UnitError(RimrollError):
    """A quantity whose text has no number, an unknown unit, or a unit of another kind."""
