"""What differs between two descriptions of a study, in words."""

from __future__ import annotations

import json
from collections.abc import Iterator
from contextlib import suppress
from typing import Any

LONGEST = 40
"""Values with more characters are shortened."""


def changes(old: Any, new: Any, key: str = "") -> Iterator[str]:
    """What differs between two trees of JSON, in which texts may hold further JSON.

    >>> list(changes({"law": {"friction": 0.2}}, {"law": {"friction": 0.3}}))
    ['law.friction was 0.2, is 0.3']
    """
    old, new = _tree(old), _tree(new)
    if isinstance(old, dict) and isinstance(new, dict):
        for name in [*old, *(name for name in new if name not in old)]:
            path = f"{key}.{name}" if key else name
            if name not in new:
                yield f"{path} was {_short(old[name])}, is not given"
            elif name not in old:
                yield f"{path} was not given, is {_short(new[name])}"
            else:
                yield from changes(old[name], new[name], path)
    elif old != new:
        yield f"{key} was {_short(old)}, is {_short(new)}"


def _tree(value: Any) -> Any:
    """A value; for a text that is a table in JSON, the table."""
    if isinstance(value, str) and value.startswith("{"):
        with suppress(ValueError):
            return json.loads(value)
    return value


def _short(value: Any) -> str:
    text = json.dumps(value, ensure_ascii=False)
    return text if len(text) <= LONGEST else f"{text[: LONGEST - 3]}..."
