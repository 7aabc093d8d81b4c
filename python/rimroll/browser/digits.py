"""Numbers of a set-up as texts that the page reads as the same numbers."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import TypeVar

T = TypeVar("T")
Pairs = Iterator[tuple[str, str]]


def shortest(value: T, shown: float, read: Callable[[float], T]) -> str:
    """The text with the fewest digits near ``shown`` that the page reads as the value."""
    for digits in range(1, 18):
        rounded = float(f"{shown:.{digits}g}")
        if read(rounded) == value:
            return plain(rounded)
    return plain(shown)


def plain(value: float) -> str:
    """All digits of a number."""
    return repr(value + 0.0).removesuffix(".0")  # 0.0 for -0.0
