"""Scenario files: a body, a start, a law, a ground and the options of a motion, in TOML.

Numbers are SI and radians; texts carry their unit. The folder ``examples`` of the repository has
files that explain themselves.
"""

from __future__ import annotations

import os
from pathlib import Path

from rimroll.errors import RimrollError
from rimroll.scenario.scenario import (
    AFTER,
    FILM,
    MAX_STEPS,
    RESISTANCES,
    Scenario,
    presets,
    resistance,
)

__all__ = ["AFTER", "FILM", "MAX_STEPS", "RESISTANCES", "Scenario", "load", "presets", "resistance"]


def load(path: str | os.PathLike[str]) -> Scenario:
    """Read a scenario file.

    Raises ``RimrollError``, in one line that names the file and the field, when the file cannot be
    read, is no TOML, lacks something, says something unknown or describes nothing possible.
    """
    from rimroll.scenario.tables import read, scenario  # pydantic is slow to load

    file = Path(path)
    try:
        return scenario(read(file), file.parent)
    except RimrollError as error:
        raise error.inside(f"{file}:") from None
