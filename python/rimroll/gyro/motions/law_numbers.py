"""The numbers of a law that a fit may change, and the law with other ones."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

from rimroll.errors import RimrollError
from rimroll.laws import Law
from rimroll.laws.parameters import parameters_of

FIXED = frozenset(("restitution", "air_exponent", "exponent"))
"""Numbers that are not fitted unless they are named."""


def fitted_names(law: Law, fit: Sequence[str] | None) -> list[str]:
    """The numbers that are fitted: those named, or all positive ones but exponents and restitution.

    Raises ``RimrollError`` for a name that the law does not have as a single number.
    """
    single = [name for name, value in law.numbers.items() if isinstance(value, float)]
    if fit is None:
        return [name for name in single if law.numbers[name] != 0.0 and name not in FIXED]
    for name in fit:
        if name not in single:
            have = ", ".join(single) or "no numbers"
            raise RimrollError(f"{law!r} has no number {name!r} to fit; it has {have}")
    return list(dict.fromkeys(fit))


def with_numbers(law: Law, numbers: Mapping[str, float]) -> Law:
    """The law with some of its numbers changed, by the names in ``law.numbers``."""
    own = {name: numbers[name] for name in parameters_of(type(law)) if name in numbers}
    others = []
    for one in law.resistances:
        names = zip(one.core_names(), parameters_of(type(one)), strict=True)
        changed: Any = {name: numbers[core] for core, name in names if core in numbers}
        others.append(replace(one, **changed))
    return replace(law, **own, resistances=tuple(others))
