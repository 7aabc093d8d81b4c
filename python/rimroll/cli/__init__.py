"""The command line: ``rimroll turn``, ``simulate``, ``topple``, ``fit`` and more.

What is loaded when: nothing here; typer for help; numpy, rich and its own module for a command;
pint, pydantic, xarray and matplotlib only by what needs them, so that short answers come quickly.
"""

from __future__ import annotations

import io
import json
import os
import sys
from collections.abc import Callable, Sequence

from rimroll.errors import RimrollError


def main(arguments: Sequence[str] | None = None, begin: Callable[[], object] = lambda: None) -> int:
    """Run a command with the given arguments, else the program's own; return its exit code.

    ``begin`` is called before the command's own work, when what it needs at first is loaded.

    The code is 0 when all went well, also if the reader of stdout stops reading early, as ``head``
    does, 1 when the solver gave up, and 3 when it is undecided whether a shaken body overturns. It
    is 2 for what cannot be done and 130 when interrupted;
    then there is one line on stderr: ``rimroll: ...`` or, with ``--json``,
    ``{"error": "..."}``.
    """
    in_json = "--json" in (sys.argv[1:] if arguments is None else arguments)
    if isinstance(sys.stdout, io.TextIOWrapper):
        sys.stdout.reconfigure(errors="replace")  # rather a ? for a ° than no answer
    try:
        from rimroll.cli.commands import run

        code = run(arguments, begin)
        sys.stdout.flush()
    except KeyboardInterrupt:
        return _complain("interrupted", 130, in_json)
    except BrokenPipeError:
        _forget_output()
        return 0
    except SystemExit as stop:
        # rich and typer turn a closed pipe into an exit of their own.
        if isinstance(stop.__context__, BrokenPipeError):
            _forget_output()
            return 0
        raise
    except RimrollError as error:
        return _complain(str(error), 2, in_json)
    except OSError as error:
        _forget_output()
        place = f"{error.filename}: " if error.filename else ""
        return _complain(f"{place}{error.strerror or error}", 2, in_json)
    except MemoryError:
        return _complain("out of memory; ask for fewer points", 2, in_json)
    return code


def _complain(message: str, code: int, in_json: bool) -> int:
    line = " ".join(message.split())
    answer = json.dumps({"error": line}, ensure_ascii=False) if in_json else f"rimroll: {line}"
    print(answer, file=sys.stderr)
    return code


def _forget_output() -> None:
    """Drop what stdout cannot take, so that Python does not report it again when it exits."""
    try:
        sys.stdout.flush()
    except OSError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
