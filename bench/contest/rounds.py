"""Measuring in rounds: each asks every contestant once, so that what the machine does meanwhile
falls on all alike, and ratios are of one round."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field

import numpy as np

from .contestants import Contestant
from .starts import Starts
from .worker import Complaint, Question, Worker

A_ROUND = 0.05
"""Seconds that a contestant works in a round, at least."""
TOO_LONG_FOR_ROUNDS = 0.5
"""Seconds for all starts from which on the first round is the only one."""
A_WARMING_UP = 5.0
"""Seconds that the first answer of a worker may take on top."""
TOO_LONG = 30.0
"""Seconds for all starts after which a contestant is spared the tighter tolerances."""


@dataclass
class Point:
    """One contestant at one tolerance: how well it did, and in each round at what cost."""

    contestant: Contestant
    task: str
    law: str
    tolerance: float
    starts: Starts
    worst: float = math.inf
    median: float = math.inf
    seconds: list[float] = field(default_factory=list)
    """A start, round by round."""

    @property
    def cost(self) -> float:
        return float(np.median(self.seconds)) if self.seconds else math.inf

    @property
    def question(self) -> Question:
        who = self.contestant
        return Question(
            self.task, who.method, who.coordinates, self.law, self.tolerance, self.starts.path
        )

    @property
    def count(self) -> int:
        """Starts that the cost is divided by."""
        return len(self.starts.columns)

    def try_out(self, worker: Worker) -> None:
        """The first time, which also compiles; its errors are those of every other."""
        try:
            answer = worker.ask(self.question)
            if answer.seconds * self.count < TOO_LONG_FOR_ROUNDS + A_WARMING_UP:
                answer = worker.ask(self.question)
        except Complaint as complaint:
            who = f"{self.contestant.label}, {self.law}, {self.tolerance:g}"
            print(f"  {who}: {complaint}", flush=True)
            return
        errors = np.abs(answer.found - self.starts.truth(self.task, self.law))
        errors[np.isnan(errors)] = math.inf
        self.worst, self.median = float(np.max(errors)), float(np.median(errors))
        self.seconds = [answer.seconds]

    def again(self, worker: Worker) -> None:
        """Once more, long enough to be timed well."""
        repeats = max(1, math.ceil(A_ROUND / (self.seconds[0] * self.count)))
        self.seconds.append(worker.ask(self.question, repeats).seconds)


def sweep(points: Iterable[Point], worker: Worker) -> Iterator[Point]:
    """Tries a contestant out at its tolerances, loosest first, as far as it gets in good time."""
    for point in points:
        point.try_out(worker)
        if not point.seconds:
            return
        yield point
        if point.seconds[0] * point.count > TOO_LONG:
            return


def repeat(points: list[Point], workers: dict[str, Worker], rounds: int) -> None:
    """Times all points in rounds; the trial counts only where it is all there is."""
    fast = [p for p in points if p.seconds[0] * p.count < TOO_LONG_FOR_ROUNDS]
    for i in range(rounds):
        print(f"  round {i + 1} of {rounds}", flush=True)
        for point in fast:
            point.again(workers[point.contestant.worker])
            if i == 0:
                # The trial told how often to repeat, but compiled as well.
                point.seconds = point.seconds[1:]
