"""The errors rimroll raises on purpose."""


class RimrollError(ValueError):
    """A request that cannot be met; the message names the value at fault and what is allowed."""


def number(field: str, value: object) -> float:
    """The value of a field as a float.

    Raises ``RimrollError`` naming the field when the value is not a single number.
    """
    if not isinstance(value, str | bytes | bool):
        try:
            return float(value)  # type: ignore[arg-type]
        except (TypeError, ValueError):
            pass
    raise RimrollError(f"{field} must be a single number, got {value!r}")


class UnitError(RimrollError):
    """A quantity whose text has no number, an unknown unit, or a unit of another kind."""
