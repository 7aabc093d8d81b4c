"""An engine in a process of its own, which may hang or crash without harm."""

from __future__ import annotations

import contextlib
import json
import os
import queue
import re
import subprocess
import sys
import tempfile
import threading
from collections.abc import Mapping
from dataclasses import asdict, dataclass, field
from pathlib import Path
from types import TracebackType
from typing import Any, Self

from rimroll_score.protocol import Scene, State
from rimroll_score.samples import Samples

START_LIMIT = 120.0
"""Seconds that an engine may take to load."""

CLOSED = ("DISPLAY", "WAYLAND_DISPLAY")
"""Variables without which no window opens."""


@dataclass(frozen=True)
class Task:
    """A motion that an engine is to compute: steps of ``dt`` (s), a sample after ``every``."""

    scene: Scene
    state: State
    dt: float
    every: int
    samples: int
    setting: str
    changes: Mapping[str, Any] = field(default_factory=dict)
    """Options of the adapter's ``best`` settings that have other values."""

    def in_json(self) -> dict[str, Any]:
        state = {name: value.tolist() for name, value in vars(self.state).items()}
        plain = {"dt": self.dt, "every": self.every, "samples": self.samples}
        return {
            **plain, "task": "run", "setting": self.setting, "changes": dict(self.changes),
            "scene": asdict(self.scene), "state": state,
        }  # fmt: skip


@dataclass(frozen=True)
class Outcome:
    """What became of a task.

    ``status`` is ``ok``, ``missing`` (the engine is not installed), ``unsupported``, ``raised``,
    ``invalid`` (samples that are no motion), ``too_slow`` or ``crashed``.
    """

    status: str
    message: str = ""
    samples: Samples | None = None
    cost: float | None = None
    """Processor time of the steps, s per simulated second."""
    departures: tuple[str, ...] = ()


class Worker:
    """Runs the adapter at a place (``module:class``), by a Python that has the engine.

    The process is started when it is needed, and again after it was ended for taking longer than
    ``limit`` seconds or died.
    """

    def __init__(self, place: str, python: str = sys.executable, limit: float = 60.0) -> None:
        self.place, self.python, self.limit = place, python, limit
        self._process: subprocess.Popen[str] | None = None
        self._lines: queue.Queue[str | None] = queue.Queue()
        self._folder = tempfile.TemporaryDirectory(prefix="rimroll-score-")
        self._said = Path(self._folder.name) / "said"

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self._end()
        self._folder.cleanup()

    def describe(self) -> dict[str, Any]:
        """The engine's version, ``settings``, ``best`` options and ``choices``.

        Or a ``status`` and a ``message``.
        """
        return self._ask({"task": "describe"}, START_LIMIT)

    def run(self, task: Task) -> Outcome:
        """Let the engine compute a motion."""
        if self._process is None and (described := self.describe())["status"] != "ok":
            return Outcome(described["status"], described["message"])
        file = Path(self._folder.name) / "samples.npz"
        answer = self._ask({**task.in_json(), "save": str(file)}, self.limit)
        if answer["status"] != "ok":
            return Outcome(answer["status"], answer["message"])
        departures = tuple(answer["departures"])
        return Outcome("ok", "", Samples.load(file), answer["cost"], departures)

    def _ask(self, question: dict[str, Any], limit: float) -> dict[str, Any]:
        if self._process is None:
            self._start()
        assert self._process is not None and self._process.stdin is not None
        try:
            self._process.stdin.write(json.dumps(question) + "\n")
            self._process.stdin.flush()
            line = self._lines.get(timeout=limit)
        except queue.Empty:
            self._end()
            message = f"no answer within {limit:g} s"
            return {"status": "too_slow", "message": message}
        except OSError:
            line = None
        if line is None:
            code = self._process.wait()
            said = self._last_words()
            self._end()
            return {"status": "crashed", "message": f"its process ended with code {code}{said}"}
        answer: dict[str, Any] = json.loads(line)
        return answer

    def _start(self) -> None:
        environment = {name: value for name, value in os.environ.items() if name not in CLOSED}
        environment |= {"OMP_NUM_THREADS": "1", "PYTHONUNBUFFERED": "1"}
        child = Path(__file__).with_name("child.py")
        with open(self._said, "w", encoding="utf-8") as said:
            self._process = subprocess.Popen(
                [self.python, "-P", str(child), self.place],
                stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=said,
                text=True, encoding="utf-8", env=environment,
            )  # fmt: skip
        self._lines = queue.Queue()
        threading.Thread(target=_forward, args=(self._process, self._lines), daemon=True).start()

    def _end(self) -> None:
        if self._process is not None:
            self._process.kill()
            self._process.wait()
            for pipe in (self._process.stdin, self._process.stdout):
                if pipe is not None:
                    with contextlib.suppress(OSError):  # what a dead process did not read
                        pipe.close()
        self._process = None

    def _last_words(self) -> str:
        lines = self._said.read_text("utf-8", errors="replace").strip().splitlines()
        # Python writes notes below the line that names an exception.
        named = [line for line in lines if re.match(r"[\w.]*(Error|Exception)\b", line)]
        return f": {(named or lines)[-1].strip()}" if lines else ""


def _forward(process: subprocess.Popen[str], lines: queue.Queue[str | None]) -> None:
    assert process.stdout is not None
    try:
        for line in process.stdout:
            lines.put(line)
    except ValueError:  # closed meanwhile
        pass
    lines.put(None)
