"""Schedulers, workers and clients of Dask, each a process of its own."""

import json
import subprocess
import sys
from contextlib import contextmanager

from given.ctrl_c import running
from given.small_study import STRICTLY, until, with_tests

BY_ITSELF = "import sys; from {} import main; sys.exit(main())"


@contextmanager
def dask(program, *arguments, environment=None):
    """A scheduler or a worker, until the block ends."""
    process = subprocess.Popen(
        [sys.executable, "-c", BY_ITSELF.format(f"distributed.cli.dask_{program}"), *arguments],
        env=with_tests(**(environment or {})),
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
    )
    try:
        yield process
    finally:
        process.kill()
        process.wait()


@contextmanager
def scheduler(folder, **environment):
    """The address of a scheduler, and its process."""
    file = folder / "scheduler.json"
    where = ["--host", "127.0.0.1", "--port", "0", "--no-dashboard", "--scheduler-file", str(file)]
    with dask("scheduler", *where, environment=environment) as process:
        until(lambda: file.exists() and file.read_text().endswith("}"), process)
        yield json.loads(file.read_text())["address"], process


@contextmanager
def worker(address, *arguments, **environment):
    """A worker of one thread."""
    more = ["--nthreads", "1", "--no-nanny", "--no-dashboard", "--memory-limit", "0"]
    with dask("worker", address, *more, *arguments, environment=environment) as process:
        yield process


@contextmanager
def pausing(address, file, place, what="wait"):
    """A worker that stops at a place of a study; its process, and the sign that it is there."""
    pause = f"{what} {place} {file.parent}"
    with worker(address, "--preload", "given.paused", RIMROLL_PAUSE=pause) as process:
        yield process, file.parent / "reached"


def client(file, address):
    """A run on a cluster, in a process of its own."""
    command = ("-m", "rimroll.cli", "study", "run", str(file), "--scheduler", address)
    return running(*STRICTLY, *command)
