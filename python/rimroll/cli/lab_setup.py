"""Checks a set-up before the lab opens with it."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any
from urllib.parse import parse_qsl

from rimroll.errors import RimrollError
from rimroll.names import nearest


def check(setup: str, page: Path) -> None:
    """Raise ``RimrollError`` for a set-up with a name or a value that the built page does not take.

    ``setup`` is ``name=value&...`` as in the page's address; what the page takes is in its
    ``setup.json``.
    """
    table = page / "setup.json"
    if not table.is_file():
        raise RimrollError(
            "--setup: the page is older than this rimroll; in its source tree, run: make web"
        )
    quantities = json.loads(table.read_text(encoding="utf-8"))
    for name, value in parse_qsl(setup, keep_blank_values=True):
        if name not in quantities:
            raise RimrollError(f"--setup: there is no quantity {name!r}{nearest(name, quantities)}")
        _check_value(name, value, quantities[name])


def _check_value(name: str, value: str, allowed: dict[str, Any]) -> None:
    if "choices" in allowed:
        if value not in allowed["choices"]:
            raise RimrollError(
                f"--setup: {name} cannot be {value!r}{nearest(value, allowed['choices'])}"
            )
        return
    least, most, unit = allowed["least"], allowed["most"], allowed["unit"]
    number = _number(value, unit)
    if number is None:
        raise RimrollError(f"--setup: {name} must be a number, got {value!r}")
    if allowed["whole"] and not number.is_integer():
        raise RimrollError(f"--setup: {name} must be a whole number, got {value!r}")
    inside = least < number < most if allowed["open"] else least <= number <= most
    if not inside:
        bounds = "between" if allowed["open"] else "from"
        joint = "and" if allowed["open"] else "to"
        in_unit = f" ({unit})" if unit else ""
        raise RimrollError(
            f"--setup: {name} must be {bounds} {least} {joint} {most}{in_unit}, got {value!r}"
        )


def _number(text: str, unit: str) -> float | None:
    """As the page reads it: with a comma for somebody's decimal point, and with the unit or not."""
    bare = text.strip().removesuffix(unit).strip() if unit else text.strip()
    try:
        return float(bare.replace(",", ".").replace("\N{MINUS SIGN}", "-"))
    except ValueError:
        return None
