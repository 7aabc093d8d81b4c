"""The contact laws: how the rim meets the table."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from rimroll import _core
from rimroll.errors import RimrollError


@dataclass(frozen=True)
class NoSlip:
    """Rolling without slip: the point of the rim that touches the table is at rest.

    Source: the paper, Eqs. ``noslip_eqs`` and appendix A.
    """

    name: ClassVar[str] = "no_slip"


@dataclass(frozen=True)
class Frictionless:
    """Sliding without friction: the table only pushes upward.

    Source: the paper, Eqs. ``nofric_eqs`` and appendix A. The centre of mass moves only vertically.
    """

    name: ClassVar[str] = "frictionless"


Law = NoSlip | Frictionless

LAWS: dict[str, Law] = {law.name: law for law in (NoSlip(), Frictionless())}
"""The laws by name, in the core's order."""

assert list(LAWS) == list(_core.LAWS)


def by_name(name: str) -> Law:
    """The law of that name; ``-`` may stand for ``_``.

    Raises ``RimrollError`` listing the names when there is none such.
    """
    law = LAWS.get(name.replace("-", "_"))
    if law is None:
        raise RimrollError(f"unknown law {name!r}: choose from {', '.join(LAWS)}")
    return law
