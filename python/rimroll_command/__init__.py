"""The script ``rimroll``: the command line, with a clean end on Ctrl-C from its first moment on.

Until a command begins its work, modules are loaded for a good part of a second in which Ctrl-C
would print a traceback. It is a package of its own because everything inside ``rimroll`` first
loads ``rimroll`` itself.
"""

from __future__ import annotations

import os
import signal


def main() -> int:
    """Run the command line with the program's arguments; return its exit code."""
    usual = signal.getsignal(signal.SIGINT)
    if usual is signal.default_int_handler:  # not where a shell has it ignored
        signal.signal(signal.SIGINT, _end)
    from rimroll.cli import main as run

    return run(begin=lambda: signal.signal(signal.SIGINT, usual))


def _end(signal_number: int, frame: object) -> None:
    """Ends the program at once: an exception would be caught by what is being loaded."""
    os.write(2, b"rimroll: interrupted\n")
    os._exit(130)
