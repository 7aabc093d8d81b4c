"""Checks a set-up before the lab opens with it."""

from __future__ import annotations

import json
import math
import re
from pathlib import Path
from typing import Any
from urllib.parse import parse_qsl

from rimroll.errors import RimrollError
from rimroll.names import nearest

_DECIMAL = re.compile(r"[+-]?(Infinity|([0-9]+\.?[0-9]*|\.[0-9]+)([eE][+-]?[0-9]+)?)")
_OTHER_BASE = re.compile(r"0([xX][0-9a-fA-F]+|[oO][0-7]+|[bB][01]+)")
"""The two make up what JavaScript's ``Number`` takes, which is less than Python's ``float``."""

_THOUSANDS = re.compile(r"[-+\N{MINUS SIGN}]?[1-9][0-9]{0,2}(,[0-9]{3})+")


def check(setup: str, page: Path) -> None:
    """Raise ``RimrollError`` for a set-up with a name or a value that the built page does not take.

    ``setup`` is ``name=value&...`` as in the page's address; what the page takes is in its
    ``setup.json``.
    """
    table = page / "setup.json"
    if not table.is_file():
        raise RimrollError("the page is older than this rimroll; in its source tree, run: make web")
    quantities = json.loads(table.read_text(encoding="utf-8"))
    for name, value in parse_qsl(setup, keep_blank_values=True):
        if name not in quantities:
            raise RimrollError(f"there is no quantity {name!r}{nearest(name, quantities)}")
        _check_value(name, value, quantities[name])


def _check_value(name: str, value: str, allowed: dict[str, Any]) -> None:
    if "choices" in allowed:
        if value not in allowed["choices"]:
            raise RimrollError(f"{name} cannot be {value!r}{nearest(value, allowed['choices'])}")
        return
    if "pattern" in allowed:
        if not re.fullmatch(allowed["pattern"], value):
            raise RimrollError(f"{name} is not one that the page has written")
        return
    low, high, unit = allowed["min"], allowed["max"], allowed["unit"]
    number = _number(value, unit)
    if number is None:
        raise RimrollError(field=name, value=value, bound="a number")
    if allowed["whole"] and not number.is_integer():
        raise RimrollError(field=name, value=value, bound="a whole number")
    inside = low < number < high if allowed["open"] else low <= number <= high
    if not inside:
        bounds = "between" if allowed["open"] else "from"
        joint = "and" if allowed["open"] else "to"
        in_unit = f" ({unit})" if unit else ""
        raise RimrollError(field=name, value=value, bound=f"{bounds} {low} {joint} {high}{in_unit}")


def _number(text: str, unit: str) -> float | None:
    """The number that the page reads, as ``read`` of web/src/setup/setup.ts; None if it refuses.

    One comma may be a decimal point, and the unit may be there or not. What may be thousands with
    commas between them, such as ``1,000``, is refused.
    """
    bare = text.strip().removesuffix(unit).strip() if unit else text.strip()
    if _THOUSANDS.fullmatch(bare):
        return None
    plain = bare.replace(",", ".", 1).replace("\N{MINUS SIGN}", "-")
    if _DECIMAL.fullmatch(plain):
        return float(plain)
    return _whole(plain) if _OTHER_BASE.fullmatch(plain) else None


def _whole(text: str) -> float:
    try:
        return float(int(text, 0))
    except OverflowError:
        return math.inf
