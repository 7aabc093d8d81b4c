"""Which chunks of a store are done: one small file for each, ``done/<chunk>.json``.

A mark is written after all numbers of its chunk. A file of numbers says nothing, since a writer may
have been killed before it wrote the others.
"""

from __future__ import annotations

import json
import os
from dataclasses import asdict, dataclass
from pathlib import Path

from rimroll.output import durably

MERGED = "merged.json"
"""The mark of statistics that were merged from all chunks."""


@dataclass(frozen=True)
class Mark:
    """What is known of a chunk that is done."""

    sha256: str
    """The hash of its numbers."""
    seconds: float
    """How long its computation took."""
    host: str
    rimroll: str
    """The version and the build that computed it."""


class Marks:
    """The marks in a folder."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder

    def done(self) -> set[int]:
        """The chunks that have a mark."""
        with os.scandir(self.folder) as files:
            names = (file.name.partition(".") for file in files)
            return {int(stem) for stem, _, end in names if end == "json" and stem.isdecimal()}

    def add(self, chunk: int, mark: Mark) -> None:
        """Mark a chunk as done, when its numbers are on the disk."""
        with durably(self.file(chunk)) as part:
            part.write(json.dumps(asdict(mark)).encode())

    def read(self, chunk: int) -> Mark | None:
        """The mark of a chunk; None if there is none that can be read."""
        try:
            return Mark(**json.loads(self.file(chunk).read_bytes()))
        except (OSError, ValueError, TypeError):
            return None

    def remove(self, chunk: int) -> None:
        """Forget that a chunk is done, and what was merged of it."""
        self.file(chunk).unlink(missing_ok=True)
        self.remove_merged()

    def add_merged(self, sha256: str) -> None:
        """Mark the statistics of all chunks as merged, with their hash."""
        with durably(self.folder / MERGED) as part:
            part.write(json.dumps({"sha256": sha256}).encode())

    def merged(self) -> str | None:
        """The hash of the merged statistics; None if they are not merged."""
        try:
            return str(json.loads((self.folder / MERGED).read_bytes())["sha256"])
        except (OSError, ValueError, KeyError, TypeError):
            return None

    def remove_merged(self) -> None:
        """Forget that the statistics are merged."""
        (self.folder / MERGED).unlink(missing_ok=True)

    def file(self, chunk: int) -> Path:
        """The mark of a chunk."""
        return self.folder / f"{chunk}.json"
