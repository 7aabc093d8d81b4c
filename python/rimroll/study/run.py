"""Running a study: in this process, on processes of this machine, or on a running scheduler.

A run locks the bytes of the file ``done/lock`` whose numbers are those of its chunks. So runs of
an array job share a store while their chunks differ, and a lock ends with the process that holds
it, however that ends. Beside the lock lies a file that says who holds it.

Such locks belong to a process, not to a run: a process may lock the same bytes twice, and loses
all its locks of a file when it closes that file anywhere. So a process opens the lock of a store
once, and keeps its own list of the chunks that it holds.
"""

from __future__ import annotations

import errno
import json
import os
import platform
import struct
import sys
import threading
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager, nullcontext, suppress
from dataclasses import dataclass, field
from io import BufferedReader, BufferedWriter
from pathlib import Path
from typing import TYPE_CHECKING, Any

from rimroll.errors import RimrollError
from rimroll.study.chunks import as_store_errors
from rimroll.study.store import Store
from rimroll.study.work import uninterrupted, work_through

if TYPE_CHECKING:
    from rimroll.study.plan import Plan


Span = tuple[int, int]
"""The first of some chunks, and the one after the last."""

File = tuple[int, int, int]
"""The number of this process, and those of a device and of a file on it."""


@dataclass(frozen=True)
class _Owner:
    """Who holds chunks; or, as read from a note, who held them when it was written."""

    span: Span
    host: str
    process: int

    def __str__(self) -> str:
        who = f"process {self.process} on {self.host}" if self.process > 0 else "another process"
        return f"{who} is computing chunks {self.span[0]}:{self.span[1]}"


@dataclass
class _Held:
    """What this process holds of a store."""

    file: BufferedReader | BufferedWriter
    spans: list[Span] = field(default_factory=list)


_held: dict[File, _Held] = {}
_using = threading.RLock()


@contextmanager
def claimed(folder: Path, first: int, last: int) -> Iterator[bool]:
    """Hold the chunks from ``first`` to before ``last`` while the block runs.

    Yields whether the file system knows locks; if not, only runs of this process are kept from the
    chunks. Raises ``RimrollError``, which names the owner, when another run holds some of them.
    """
    span = (first, last)
    with as_store_errors(folder.parent):
        key, locked = _take(folder, span)
    note = folder / f"owner-{first}-{last}.json"
    try:
        if locked:
            with as_store_errors(folder.parent):
                _forget_killed(folder, span)
                own = {"chunks": span, "host": platform.node(), "process": os.getpid()}
                note.write_text(json.dumps(own))
        yield locked
    finally:
        if locked:
            with suppress(OSError):
                note.unlink(missing_ok=True)
        _give_back(key, span)


def at_work(folder: Path) -> list[str]:
    """Who holds chunks, in words; owners that were killed hold none."""
    return [str(one) for one in _owners(folder)]


def _take(folder: Path, span: Span) -> tuple[File, bool]:
    """Lock chunks; return the lock, and whether the file system knows locks."""
    lock = folder / "lock"
    with _using:
        if not lock.exists():
            lock.open("ab").close()
        key = _key(lock)
        held = _held[key] if key in _held else _Held(lock.open("ab"))
        if any(_overlap(span, one) for one in held.spans):
            raise RimrollError(_refusal(folder, span))
        try:
            _lock(held.file.fileno(), span)
        except OSError as error:
            if error.errno in TAKEN:
                refusal = _refusal(folder, span)
                if not held.spans:
                    held.file.close()
                raise RimrollError(refusal) from None
            locked = False  # some network file systems know no locks
        else:
            locked = True
        held.spans.append(span)
        _held[key] = held
        return key, locked


def _give_back(key: File, span: Span) -> None:
    with _using:
        held = _held[key]
        held.spans.remove(span)
        with suppress(OSError):
            _unlock(held.file.fileno(), span)
        if not held.spans:
            _held.pop(key).file.close()


TAKEN = (errno.EACCES, errno.EAGAIN, errno.EDEADLK)
"""What the system answers when another process holds a lock."""


def _forget_killed(folder: Path, span: Span) -> None:
    """Remove the notes of owners of these chunks, which are held by this process now."""
    for file, owner in _notes(folder):
        if _overlap(owner.span, span):
            file.unlink(missing_ok=True)


def _refusal(folder: Path, span: Span) -> str:
    for owner in _owners(folder):
        if _overlap(owner.span, span):
            return f"{owner} of {folder.parent}: wait until it ends, or choose other chunks"
    return f"another process is computing these chunks of {folder.parent}: wait until it ends"


def _owners(folder: Path) -> list[_Owner]:
    """Who holds chunks, in the order of the chunks."""
    notes = [owner for _, owner in _notes(folder)]
    host = platform.node()
    found = []
    with suppress(OSError), _using:
        held = _held.get(_key(folder / "lock"))
        if held is not None:
            found = [_Owner(span, host, os.getpid()) for span in held.spans]
            found += _others(held.file.fileno(), notes)
        else:
            with (folder / "lock").open("rb") as file:
                found = _others(file.fileno(), notes)
    return sorted(found, key=lambda owner: owner.span)


def _notes(folder: Path) -> Iterator[tuple[Path, _Owner]]:
    for note in folder.glob("owner-*.json"):
        try:
            owner = json.loads(note.read_text())
            first, last = owner["chunks"]
            yield note, _Owner((first, last), owner["host"], owner["process"])
        except (OSError, ValueError, KeyError, TypeError):
            continue  # just being written or removed


def _key(lock: Path) -> File:
    found = lock.stat()
    return os.getpid(), found.st_dev, found.st_ino


def _overlap(one: Span, other: Span) -> bool:
    return one[0] < other[1] and other[0] < one[1]


if sys.platform == "win32":
    import msvcrt

    def _lock(descriptor: int, span: Span) -> None:
        os.lseek(descriptor, span[0], os.SEEK_SET)
        msvcrt.locking(descriptor, msvcrt.LK_NBLCK, span[1] - span[0])

    def _unlock(descriptor: int, span: Span) -> None:
        os.lseek(descriptor, span[0], os.SEEK_SET)
        msvcrt.locking(descriptor, msvcrt.LK_UNLCK, span[1] - span[0])

    def _others(descriptor: int, notes: Iterable[_Owner]) -> list[_Owner]:
        """The owners of notes whose chunks are locked."""
        found = []
        for owner in notes:
            if owner.process == os.getpid():
                continue
            try:
                _lock(descriptor, owner.span)
            except OSError:
                found.append(owner)
            else:
                _unlock(descriptor, owner.span)
        return found

else:
    import fcntl

    # struct flock: the fields type, whence, start, length and process.
    _FLOCK = "hhqqi" if sys.platform == "linux" else "qqihh"
    _END = 2**62

    def _lock(descriptor: int, span: Span) -> None:
        fcntl.lockf(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB, span[1] - span[0], span[0])

    def _unlock(descriptor: int, span: Span) -> None:
        fcntl.lockf(descriptor, fcntl.LOCK_UN, span[1] - span[0], span[0])

    def _others(descriptor: int, notes: Iterable[_Owner]) -> list[_Owner]:
        """Who else holds locks: as noted, or the process that the system names."""
        host = platform.node()
        found = []
        for span, process in _locks(descriptor):
            inside = [
                owner
                for owner in notes
                if span[0] <= owner.span[0] and owner.span[1] <= span[1]
                # The system does not number processes of other machines.
                if owner.process == process or owner.host != host or process <= 0
            ]
            found += inside or [_Owner(span, host, process)]
        return found

    def _locks(descriptor: int) -> Iterator[tuple[Span, int]]:
        """The locks of other processes on a file: their bytes, and the number of the process."""
        unknown = [(0, _END)]
        while unknown:
            first, last = unknown.pop()
            lock = _conflict(descriptor, first, last - first)
            if lock is None:
                continue
            start, length, process = lock
            end = start + length if length else _END
            yield (start, end), process
            unknown += [(a, b) for a, b in ((first, start), (end, last)) if a < b]

    def _conflict(descriptor: int, start: int, length: int) -> tuple[int, int, int] | None:
        """A lock of another process on these bytes: start, length and process."""
        kind, whence = fcntl.F_WRLCK, os.SEEK_SET
        if sys.platform == "linux":
            asked = struct.pack(_FLOCK, kind, whence, start, length, 0)
            answer = fcntl.fcntl(descriptor, fcntl.F_GETLK, asked + bytes(4))
            kind, _, start, length, process = struct.unpack_from(_FLOCK, answer)
        else:
            asked = struct.pack(_FLOCK, start, length, 0, kind, whence)
            answer = fcntl.fcntl(descriptor, fcntl.F_GETLK, asked + bytes(8))
            start, length, process, kind, _ = struct.unpack_from(_FLOCK, answer)
        return None if kind == fcntl.F_UNLCK else (start, length, process)


Progress = Callable[[int, int], object]
"""Takes how many rows are done, and how many the chunks of the run have."""

Note = Callable[[str], object]
"""Takes a sentence that users should read."""


def run(
    plan: Plan,
    path: str | os.PathLike[str],
    *,
    chunks: range | None = None,
    workers: int | None = None,
    scheduler: str | None = None,
    client: Any = None,
    threads: int | None = None,
    other_versions: bool = False,
    progress: Progress = lambda done, total: None,
    note: Note = lambda text: None,
) -> Store:
    """Compute the chunks of a study that are not done, and return its store.

    Parameters
    ----------
    plan, path
        The study, and the folder of its store, which is made unless it is there.
    chunks
        Numbers of the chunks to compute; all by default. Runs whose chunks differ can share a
        store at the same time.
    workers
        Computes on so many processes of this machine, which share its processors.
    scheduler, client
        Computes on a running Dask cluster: its address, or a client of it. Its workers need the
        same version of rimroll, and must see the store at the same path.
    threads
        Threads in this process, by default one for each processor.
    other_versions
        Also continues a store, and computes on workers, of another build of rimroll, or with other
        versions of NumPy or SciPy. Numbers may differ; the mark of each chunk names its build.
    progress, note
        Called with how far the run is, and with sentences for the user.

    Raises
    ------
    StoreError
        A store of another study or another build, a full disk, a folder that cannot be written.
    RimrollError
        A run at work on the same chunks, a cluster that does not answer or whose versions differ.
    Unfinished
        Chunks that failed on the cluster again and again; run again to try them again.
    KeyboardInterrupt
        On Ctrl-C. What is done is kept; run again to continue.
    """
    elsewhere = sum(one is not None for one in (workers, scheduler, client))
    if elsewhere > 1:
        raise RimrollError("give either workers or a scheduler")
    if threads is not None and elsewhere:
        raise RimrollError("threads are those of this process: give no workers or scheduler")
    store = Store.create(path, plan)
    store.expect(plan, other_versions=other_versions)
    mine = _within(chunks, store.blocks.number)
    with claimed(store.marks.folder, mine.start, mine.stop) as held:
        if not held:
            note(f"{path} is on a file system without locks: run each chunk once at a time")
        pending = store.pending(mine)
        store.sweep(pending)
        done = _Rows(store, mine, pending, progress)
        if workers is None and scheduler is None and client is None:
            work_through(store, plan, pending, threads, done.add, done.within)
        elif pending:
            from rimroll.study.cluster import compute, connected

            lent = nullcontext(client) if client else connected(workers, scheduler, note)
            with lent as connection:
                compute(
                    connection, store, plan, pending, done.add, note, other_versions=other_versions
                )
        if store.finished:
            with uninterrupted():
                store.merge(plan)
    return store


class _Rows:
    """How many rows of a run are done."""

    def __init__(
        self, store: Store, chunks: Iterable[int], pending: list[int], progress: Progress
    ) -> None:
        self._blocks = store.blocks
        first, last = min(chunks), max(chunks)
        self._all = self._blocks.rows(last)[1] - self._blocks.rows(first)[0]
        self._done = self._all - sum(map(self._size, pending))
        self._progress = progress
        progress(self._done, self._all)

    def _size(self, chunk: int) -> int:
        first, last = self._blocks.rows(chunk)
        return last - first

    def within(self, done: int, rows: int) -> None:
        """Rows of the chunk at work are done."""
        self._progress(self._done + done, self._all)

    def add(self, chunk: int) -> None:
        """A chunk is done."""
        self._done += self._size(chunk)
        self._progress(self._done, self._all)


def _within(chunks: range | None, number: int) -> range:
    if chunks is None:
        return range(number)
    if not 0 <= chunks.start < chunks.stop <= number or chunks.step != 1:
        raise RimrollError(
            f"must lie between 0 and {number}, got {chunks.start}:{chunks.stop}", "chunks"
        )
    return chunks
