"""Ctrl-C, in the test's own process and in processes that a test starts.

A signal goes to a process only after the process itself has shown that it is ready: a test that
waited for time to pass would fail on a busy machine. A shell starts background processes with
Ctrl-C ignored, which their children inherit; this is undone here.
"""

import os
import signal
import subprocess
import sys
import threading
import time
from contextlib import contextmanager
from pathlib import Path

import pytest

PATIENCE = 300.0
"""A process that takes longer (s) is killed, so that no test waits forever."""

needs_signals = pytest.mark.skipif(
    sys.platform == "win32", reason="Ctrl-C is no signal for another process there"
)


@contextmanager
def heard():
    """Makes Ctrl-C raise KeyboardInterrupt here and in processes started inside the block."""
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, before)


@contextmanager
def running(*arguments, **options):
    """Python with these arguments, and with pipes for what it writes; it ends with the block."""
    with heard():
        process = subprocess.Popen(
            [sys.executable, *arguments],
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
            **options,
        )
    patience = threading.Timer(PATIENCE, process.kill)
    patience.start()
    with process:
        try:
            yield process
        finally:
            patience.cancel()
            process.kill()


def interrupt(process):
    """Sends Ctrl-C to a process; returns what else it writes, to stdout and to stderr."""
    process.send_signal(signal.SIGINT)
    return process.communicate()


def interrupt_when(sign, process):
    """Interrupt a process as soon as `sign()`, which it must bring about, is true."""
    while not sign():
        assert process.poll() is None, f"it ended by itself: {process.communicate()}"
        time.sleep(0.01)
    return interrupt(process)


def processor_time_after_ctrl_c(code):
    """How much processor time (s) a program still takes after Ctrl-C.

    The program calls `ready` of ``with ctrl_c.timed() as ready``, once or repeatedly.
    """
    path = [str(Path(__file__).parents[1]), *filter(None, [os.environ.get("PYTHONPATH")])]
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(path)}
    with running("-c", code, env=environment) as process:
        sign = process.stdout.readline()
        assert sign == "ready\n", process.communicate()
        out, err = interrupt(process)
    assert err == ""
    return float(out)


@contextmanager
def timed():
    """In a program of `processor_time_after_ctrl_c`: gives `ready`, and prints the time.

    A thread notes when the signal arrives, since Python itself handles it only when the main thread
    runs Python code.
    """
    reading, writing = os.pipe()
    os.set_blocking(writing, False)
    signal.set_wakeup_fd(writing)
    arrivals = []

    def note_arrival():
        os.read(reading, 1)
        arrivals.append(time.process_time())

    noting = threading.Thread(target=note_arrival, daemon=True)
    noting.start()
    calls = []

    def ready():
        if not calls:
            calls.append("ready")
            print("ready", flush=True)

    try:
        yield ready
    except KeyboardInterrupt:
        over = time.process_time()
        noting.join()
        print(max(0.0, over - arrivals[0]))
