"""Answers the requests of `contest/worker.py` on standard input for one Python peer.

python worker.py heyoka_peer
"""

import importlib
import sys
import time

import numpy as np
from column import record_beside


def read_starts(path):
    """The first four columns (tilt, tilt rate, yaw rate, spin rate) of a table of starts."""
    with open(path, encoding="utf-8") as file:
        rows = [line for line in file if not line.startswith("#")][1:]
    return np.array([[float(cell) for cell in row.split(",")[:4]] for row in rows])


def answer(peer, line):
    task, method, coordinates, law, tolerance, repeats, path = line.split()
    starts, times = read_starts(path), int(repeats)
    if task == "shaken":
        compute = peer.prepare_shaken(method, float(tolerance), starts[:, 0], record_beside(path))
        return timed(compute, times, len(starts))
    many, again = starts, times
    if task == "turn" and getattr(peer, "ALL_AT_ONCE", False):
        many, again = np.tile(starts, (times, 1)), 1
    prepare = {"turn": peer.prepare, "motion": getattr(peer, "prepare_motion", None)}[task]
    compute = prepare(method, coordinates, law, float(tolerance), many)
    begun = time.process_time()
    for _ in range(again):
        found = compute()
    seconds = (time.process_time() - begun) / (times * len(starts))
    if task == "turn":
        found = found[: len(starts)]
    return " ".join(f"{number!r}" for number in [seconds, *map(float, found)])


def timed(compute, times, count):
    """The answer of a computation that is repeated."""
    begun = time.process_time()
    for _ in range(times):
        found = compute()
    seconds = (time.process_time() - begun) / (times * count)
    return " ".join(f"{number!r}" for number in [seconds, *map(float, found)])


def main():
    peer = importlib.import_module(sys.argv[1])
    for line in sys.stdin:
        try:
            print(answer(peer, line), flush=True)
        except Exception as complaint:
            print("error", repr(complaint).replace("\n", " "), flush=True)


if __name__ == "__main__":
    main()
