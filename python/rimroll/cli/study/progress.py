"""How far a run of a study is: a bar in a terminal, else a line a minute, both on stderr."""

from __future__ import annotations

import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager

from rich.console import Console

EVERY = 60.0
"""Time (s) between two lines in a log."""


class Watcher:
    """Writes notes, and how far a run is, as lines."""

    def __init__(self) -> None:
        self.done = 0
        self._begin: tuple[float, int] | None = None
        self._written = time.monotonic()

    def progress(self, done: int, total: int) -> None:
        """Show that ``done`` motions are complete."""
        self.done = done
        now = time.monotonic()
        if self._begin is None:
            self._begin = now, done
        elif now - self._written >= EVERY:
            self._written = now
            begin, before = self._begin
            rate = (done - before) / (now - begin)
            left = f", {_time(total - done, rate)} left" if rate > 0.0 else ""
            self.note(f"{done:,} of {total:,} motions, {rate:,.0f}/s{left}")

    def note(self, text: str) -> None:
        """A sentence for the user."""
        print(text, file=sys.stderr, flush=True)


class Bar(Watcher):
    """Shows how far a run is by a bar with the rate and the time left."""

    def __init__(self, console: Console) -> None:
        from rich.progress import (
            BarColumn,
            Progress,
            ProgressColumn,
            Task,
            TextColumn,
            TimeRemainingColumn,
        )
        from rich.text import Text

        class Rate(ProgressColumn):
            def render(self, task: Task) -> Text:
                return Text(f"{task.speed:,.0f}/s" if task.speed else "")

        super().__init__()
        self.bar = Progress(
            TextColumn("{task.completed:,.0f} of {task.total:,.0f} motions"),
            BarColumn(),
            Rate(),
            TimeRemainingColumn(),
            console=console,
            transient=True,
            speed_estimate_period=120.0,
        )

    def progress(self, done: int, total: int) -> None:
        self.done = done
        if not self.bar.task_ids:  # what was done before says nothing about the rate
            self.bar.add_task("", total=total, completed=done)
        self.bar.update(self.bar.task_ids[0], completed=done, total=total)

    def note(self, text: str) -> None:
        self.bar.console.print(text, markup=False, highlight=False, soft_wrap=True)


@contextmanager
def watching() -> Iterator[Watcher]:
    """Shows how far a run is until the block ends."""
    console = Console(stderr=True)
    if not console.is_terminal:
        yield Watcher()
        return
    bar = Bar(console)
    with bar.bar:
        yield bar


def _time(rows: int, rate: float) -> str:
    seconds = round(rows / rate)
    hours, minutes = seconds // 3600, seconds // 60 % 60
    return f"{hours} h {minutes} min" if hours else f"{minutes} min {seconds % 60} s"
