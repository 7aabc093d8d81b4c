"""Ranges of quantities as they are typed: ``-30..30deg/s``."""

from __future__ import annotations

from rimroll.errors import RimrollError
from rimroll.units import quantity


def ends(text: str, unit: str, option: str, examples: str) -> tuple[float, float]:
    """The ends of a range in an SI unit; a unit behind the second goes for both.

    Raises ``RimrollError`` naming the option, with examples, for what is no range that rises.
    """
    first, dots, last = text.partition("..")
    if not dots:
        raise RimrollError(field=option, value=text, bound=f"a range such as {examples}")
    if first.strip()[-1:].isdigit():
        first += last.strip().lstrip("+-−0123456789.eE")
    elif last.strip()[-1:].isdigit():
        raise RimrollError(f"must have its unit behind the second number, got {text!r}", option)
    low, high = quantity(first, unit, option), quantity(last, unit, option)
    if not low < high:
        raise RimrollError(f"must rise, got {text!r}", option)
    return low, high
