"""Measuring in rounds. Each round runs every contestant once, so that other work on the machine
affects all alike; ratios are taken within a round."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field

import numpy as np

from .contestants import Contestant
from .starts import Starts
from .worker import Complaint, Question, Worker

A_ROUND = 0.05
"""Minimum time for which a contestant runs in a round, s."""
TOO_LONG_FOR_ROUNDS = 0.5
"""If all starts take longer than this, s, the first round is the only one."""
A_WARMING_UP = 5.0
"""Additional time allowed for a worker's first answer, s."""
TOO_LONG = 30.0
"""If all starts take longer than this, s, a contestant's tighter tolerances are skipped."""


@dataclass
class Point:
    """One contestant at one tolerance: its errors, and its cost in each round."""

    contestant: Contestant
    task: str
    law: str
    tolerance: float
    starts: Starts
    worst: float = math.inf
    median: float = math.inf
    seconds: list[float] = field(default_factory=list)
    """Cost of a start in each round."""

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
        """The number of starts by which the cost is divided."""
        return len(self.starts.columns)

    def try_out(self, worker: Worker) -> None:
        """The first run, which also compiles; later runs have the same errors."""
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
        """Another run, long enough for its timing."""
        repeats = max(1, math.ceil(A_ROUND / (self.seconds[0] * self.count)))
        self.seconds.append(worker.ask(self.question, repeats).seconds)


def sweep(points: Iterable[Point], worker: Worker) -> Iterator[Point]:
    """Tries a contestant's tolerances, loosest first, until they take too long."""
    for point in points:
        point.try_out(worker)
        if not point.seconds:
            return
        yield point
        if point.seconds[0] * point.count > TOO_LONG:
            return


def repeat(points: list[Point], workers: dict[str, Worker], rounds: int) -> None:
    """Times all points in rounds; the trial counts only if there is nothing else."""
    fast = [p for p in points if p.seconds[0] * p.count < TOO_LONG_FOR_ROUNDS]
    for i in range(rounds):
        print(f"  round {i + 1} of {rounds}", flush=True)
        for point in fast:
            point.again(workers[point.contestant.worker])
            if i == 0:
                # The trial determined the number of repeats, but its time includes compiling.
                point.seconds = point.seconds[1:]
