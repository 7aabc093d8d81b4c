"""A film in memory, which notebooks show."""

from __future__ import annotations

import base64
import os
import tempfile
from pathlib import Path
from typing import Any

from rimroll.animation.film_file import animate
from rimroll.errors import RimrollError
from rimroll.output import writing
from rimroll.scene import Motion

SMALL: dict[str, Any] = {"fps": 15.0, "size": (400, 300)}
SHORT = {"seconds": 6.0}
"""Options of a film in a notebook, whose file holds the film as text."""


class Film:
    """A film as a GIF in memory; :meth:`rimroll.Motion.film` makes it, and a notebook shows it."""

    data: bytes
    """The content of the GIF."""

    def __init__(self, data: bytes) -> None:
        self.data = data

    def save(self, path: str | os.PathLike[str]) -> Path:
        """Write the film to a .gif file and return its path.

        Raises ``RimrollError`` for another suffix, and for a place that cannot be written to.
        """
        path = Path(path)
        if path.suffix.lower() != ".gif":
            raise RimrollError(
                f"a film in memory is a .gif (asked for: {path.name}); the motion's method animate"
                " writes other kinds"
            )
        with writing(path) as part:
            part.write_bytes(self.data)
        return path

    def __repr__(self) -> str:
        return f"<Film, GIF of {len(self.data) / 1e3:.0f} kB>"

    def _repr_html_(self) -> str:
        """The view in notebooks."""
        text = base64.b64encode(self.data).decode()
        alt = "The body rocks and rolls on the rim of its base."
        return f'<img src="data:image/gif;base64,{text}" alt="{alt}">'


def film(motion: Motion, **options: Any) -> Film:
    """The film that :func:`rimroll.animation.animate` would write with these options.

    Unless they are given, it has 15 pictures a second of 400 × 300 pixels and lasts 6 s.
    """
    length = {} if options.keys() & {"seconds", "speed"} else SHORT
    with tempfile.TemporaryDirectory(prefix="rimroll-") as folder:
        path = animate(motion, Path(folder) / "film.gif", **{**SMALL, **length, **options})
        return Film(path.read_bytes())
