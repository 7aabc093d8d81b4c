"""A contestant, which runs in its own process.

It is asked on a line of its standard input

    TASK METHOD COORDINATES LAW TOLERANCE REPEATS TABLE

to go REPEATS times through the starts of a table (its first four columns: tilt, tilt rate, yaw
rate, spin rate), and answers on a line of its standard output with seconds of the processor a
start, and what it found: the turn of every start (TASK turn), or the yaw and the tilt after two
seconds of the first (motion). NaN stands for what it could not do. Starting up, reading and
compiling do not count.
"""

from __future__ import annotations

import os
import subprocess
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from types import TracebackType

import numpy as np


class Complaint(Exception):
    """A contestant failed to answer."""


@dataclass(frozen=True)
class Question:
    """One line to a worker."""

    task: str
    method: str
    coordinates: str
    law: str
    tolerance: float
    starts: Path

    def line(self, repeats: int) -> str:
        words = [self.task, self.method, self.coordinates, self.law]
        return " ".join([*words, repr(self.tolerance), str(repeats), str(self.starts)]) + "\n"


@dataclass(frozen=True)
class Answer:
    """A worker's results and their cost."""

    seconds: float
    """Processor time for each start."""
    found: np.ndarray


class Worker:
    """A running process, bound to one core."""

    def __init__(self, command: Sequence[str | Path]) -> None:
        core = max(os.sched_getaffinity(0))
        self._process = subprocess.Popen(
            [str(word) for word in command],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
            text=True,
            env={**os.environ, "RAYON_NUM_THREADS": "1", "PYTHONDONTWRITEBYTECODE": "1"},
        )
        os.sched_setaffinity(self._process.pid, {core})

    def ask(self, question: Question, repeats: int = 1) -> Answer:
        stdin, stdout = self._process.stdin, self._process.stdout
        assert stdin is not None and stdout is not None
        try:
            stdin.write(question.line(repeats))
            stdin.flush()
            line = stdout.readline()
        except BrokenPipeError as broken:
            raise Complaint("the worker is gone") from broken
        if not line or line.startswith("error"):
            raise Complaint(line.removeprefix("error").strip() or "the worker is gone")
        seconds, *found = map(float, line.split())
        return Answer(seconds, np.array(found))

    def __enter__(self) -> Worker:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self._process.kill()
        self._process.communicate()
