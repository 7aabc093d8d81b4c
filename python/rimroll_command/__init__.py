"""The script ``rimroll``: the command line, with a clean end on Ctrl-C from its first moment on.

It is a package of its own because everything inside ``rimroll`` first loads ``rimroll`` itself, and
with it NumPy, for a good part of a second in which Ctrl-C would print a traceback.
"""

from __future__ import annotations

import os
import signal
from importlib import import_module


def main() -> int:
    """Load the command line and run it with the program's arguments; return its exit code."""
    usual = signal.getsignal(signal.SIGINT)
    if usual is signal.default_int_handler:  # not where a shell has it ignored
        signal.signal(signal.SIGINT, _end)
    import_module("rimroll.cli.commands")
    from rimroll.cli import main as run

    signal.signal(signal.SIGINT, usual)
    return run()


def _end(signal_number: int, frame: object) -> None:
    """Ends the program at once: an exception would be caught by what is being loaded."""
    os.write(2, b"rimroll: interrupted\n")
    os._exit(130)
