"""Which engines there are: entry points of the group ``rimroll.engines``."""

from __future__ import annotations

import importlib
import importlib.util
from importlib.metadata import entry_points
from pathlib import Path
from typing import Any

GROUP = "rimroll.engines"


class NoAdapter(Exception):
    """There is no adapter of that name; the message lists those that there are."""


def engines() -> dict[str, str]:
    """Names of the engines that have an adapter, and where it is, as ``module:class``."""
    return {entry.name: entry.value for entry in sorted(entry_points(group=GROUP))}


def located(engine: str) -> str:
    """Where the adapter of an engine is.

    ``engine`` is the name of an entry point, or where an adapter is: ``module:class`` or
    ``file.py:class``.
    """
    if ":" in engine:
        return engine
    known = engines()
    if engine not in known:
        raise NoAdapter(
            f"no adapter is called {engine!r}; there are {', '.join(known) or 'none'}, and your own"
            " as module:class or file.py:class"
        )
    return known[engine]


def load(place: str) -> Any:
    """The adapter at ``module:class`` or ``file.py:class``."""
    where, _, name = place.rpartition(":")
    if not where.endswith(".py"):
        return getattr(importlib.import_module(where), name)
    spec = importlib.util.spec_from_file_location(Path(where).stem + "_adapter", where)
    if spec is None or spec.loader is None:
        raise ImportError(f"{where} cannot be loaded")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return getattr(module, name)
