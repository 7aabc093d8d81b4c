"""One run at a time for each chunk of a store.

A run locks the bytes of the file ``done/lock`` whose numbers are those of its chunks. So runs of
an array job share a store while their chunks differ, and a lock ends with the process that holds
it, however that ends. Beside the lock lies a file that says who holds it.
"""

from __future__ import annotations

import errno
import json
import os
import platform
import sys
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

from rimroll.errors import RimrollError
from rimroll.study.storage import told


@contextmanager
def claimed(folder: Path, first: int, last: int) -> Iterator[bool]:
    """Hold the chunks from ``first`` to before ``last`` while the block runs.

    Yields whether the file system knows locks; if not, nothing is held. Raises ``RimrollError``,
    which names the owner, when another process holds some of these chunks.
    """
    with told(folder.parent):
        lock = (folder / "lock").open("a+b")
    with lock as file:
        try:
            _lock(file.fileno(), first, last - first)
        except OSError as error:
            if error.errno not in TAKEN:
                yield False  # some network file systems know no locks
                return
            raise RimrollError(_refusal(folder, first, last)) from None
        note = folder / f"owner-{first}-{last}.json"
        owner = {"chunks": [first, last], "host": platform.node(), "process": os.getpid()}
        with told(folder.parent):
            note.write_text(json.dumps(owner))
        try:
            yield True
        finally:
            note.unlink(missing_ok=True)


TAKEN = (errno.EACCES, errno.EAGAIN, errno.EDEADLK)
"""What the system answers when another process holds a lock."""


def at_work(folder: Path) -> list[str]:
    """Who holds chunks, in words; owners that were killed hold none."""
    noted = list(_owners(folder))
    own = _named(os.getpid(), platform.node())
    if any(who == own for _, _, who in noted):
        # A process that closes a file gives up its locks on it: do not touch them.
        return [_at_work(*one) for one in noted]
    owners = []
    with suppress(PermissionError), (folder / "lock").open("a+b") as file:
        for one in noted:
            try:
                _lock(file.fileno(), one[0], one[1] - one[0])
            except OSError as error:
                if error.errno in TAKEN:
                    owners.append(_at_work(*one))
    return owners


def _refusal(folder: Path, first: int, last: int) -> str:
    for begin, end, who in _owners(folder):
        if begin < last and first < end:
            return (
                f"{_at_work(begin, end, who)} of {folder.parent}: wait until it ends, or choose"
                " other chunks"
            )
    return f"another process is computing these chunks of {folder.parent}: wait until it ends"


def _at_work(first: int, last: int, who: str) -> str:
    return f"{who} is computing chunks {first}:{last}"


def _named(process: int, host: str) -> str:
    return f"process {process} on {host}"


def _owners(folder: Path) -> Iterator[tuple[int, int, str]]:
    for note in folder.glob("owner-*.json"):
        try:
            owner = json.loads(note.read_text())
            first, last = owner["chunks"]
            yield first, last, _named(owner["process"], owner["host"])
        except (OSError, ValueError, KeyError, TypeError):
            continue  # just being written or removed


if sys.platform == "win32":
    import msvcrt

    def _lock(descriptor: int, first: int, count: int) -> None:
        os.lseek(descriptor, first, os.SEEK_SET)
        msvcrt.locking(descriptor, msvcrt.LK_NBLCK, count)

else:
    import fcntl

    def _lock(descriptor: int, first: int, count: int) -> None:
        fcntl.lockf(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB, count, first)
