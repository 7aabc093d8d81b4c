"""Names as people type them, and suggestions for unknown names."""

from __future__ import annotations

import difflib
from collections.abc import Iterable, Mapping
from typing import TypeVar

from rimroll.errors import RimrollError

T = TypeVar("T")


def choose(what: str, name: str, choices: Mapping[str, T]) -> T:
    """The choice of that name: ``no-slip`` is found as ``no_slip``, ``noslip`` and ``No Slip`` too.

    Raises ``RimrollError`` with the nearest name and all choices.
    """
    found = {_bare(known): choice for known, choice in choices.items()}
    if _bare(name) not in found:
        raise RimrollError(f"unknown {what} {name!r}{nearest(name, choices)}")
    return found[_bare(name)]


def nearest(name: str, known: Iterable[str]) -> str:
    """The end of a message: the nearest known name, and all known names."""
    names = list(known)
    near = difflib.get_close_matches(name, names, n=1)
    choices = ", ".join(names) or "none"
    return f": did you mean {near[0]!r}? Known: {choices}" if near else f": choose from {choices}"


def typed(name: str) -> str:
    """The name of a field or law as users type it: ``no-slip``."""
    return name.replace("_", "-")


def _bare(name: str) -> str:
    return name.lower().replace("-", "").replace("_", "").replace(" ", "")
