"""The chunks of a study as tasks of a Dask cluster.

A task is the number of a chunk. The worker makes the plan from the description of the study,
computes, writes and marks the chunk itself, and returns a few words; Dask carries no arrays. Since
the state is on the disk, a lost worker, scheduler or client costs the chunks at work, no more.
"""

from __future__ import annotations

import contextlib
import json
import logging
import os
import queue
import threading
import time
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from functools import lru_cache
from itertools import islice
from typing import Any

from rimroll.errors import RimrollError
from rimroll.study.chunks import StoreError
from rimroll.study.plan import Plan, plan_of, processors
from rimroll.study.store import Store
from rimroll.study.versions import difference, versions
from rimroll.study.work import Unfinished, work

PATIENCE = 5.0
"""How long (s) a scheduler may take to answer."""

ANSWERS = 60.0
"""How long (s) a worker may take to say why it has not marked its chunk."""

AHEAD = 3
"""Tasks given to the scheduler for each thread of the cluster: all at once would overload it."""

RECOUNT = 2.0
"""Time (s) between two looks at how many threads the cluster has."""

TRIES = 3
"""How often a chunk that raises an unexpected error is tried."""

MAX_FAILURES = 10
"""The number of failed chunks that ends a run: the others would probably fail, too."""

IGNORE_INTERRUPTS = """
import signal, threading
if threading.current_thread() is threading.main_thread():
    signal.signal(signal.SIGINT, signal.SIG_IGN)
"""
"""Local workers run this first: a terminal sends Ctrl-C to them, too, and the client ends them."""

Found = dict[str, str]
"""What a task returns: nothing, or ``stop`` and a reason why no other task should be tried."""


@contextmanager
def connected(
    workers: int | None, scheduler: str | None, note: Callable[[str], object]
) -> Iterator[Any]:
    """A client of a running scheduler, or of so many processes of this machine."""
    distributed = _distributed()
    # Its messages repeat what the errors here say, with tracebacks.
    logging.getLogger("distributed").setLevel(logging.CRITICAL)
    with contextlib.ExitStack() as stack:
        address: Any = scheduler
        if scheduler is None:
            assert workers is not None
            cores = processors()
            if workers > cores:
                note(f"{workers} workers share {cores} processors: more workers are no faster")
            address = stack.enter_context(
                distributed.LocalCluster(
                    n_workers=workers,
                    threads_per_worker=max(1, cores // workers),
                    dashboard_address="127.0.0.1:0",
                    silence_logs=logging.CRITICAL,
                    preload=[IGNORE_INTERRUPTS],
                )
            )
        client = stack.enter_context(_client(address))
        note(f"dashboard: {client.dashboard_link}")
        yield client


def _client(address: Any) -> Any:
    """A client of a scheduler; ``RimrollError`` if it does not answer.

    A program that listens at the address but is no scheduler would keep it waiting forever.
    """
    answered: queue.SimpleQueue[Any] = queue.SimpleQueue()

    def connect() -> None:
        try:
            answered.put(_distributed().Client(address, timeout=PATIENCE, set_as_default=False))
        except Exception as error:
            answered.put(error)

    threading.Thread(target=connect, daemon=True).start()
    try:
        client = answered.get(timeout=PATIENCE + 1.0)
    except queue.Empty:
        client = TimeoutError("what listens there is no scheduler")
    if isinstance(client, Exception):
        reason = " ".join(str(client).split())
        raise RimrollError(f"no scheduler answers at {address}: {reason}")
    return client


def compute(
    client: Any,
    store: Store,
    plan: Plan,
    pending: list[int],
    done: Callable[[int], object],
    note: Callable[[str], object],
    *,
    other_versions: bool = False,
) -> None:
    """Compute chunks on a cluster, and call ``done`` with the number of each that is done.

    Raises ``RimrollError`` if the scheduler is lost or something stops the run, and ``Unfinished``
    if chunks fail.
    """
    _same_versions(client)
    tasks = _Tasks(client, store, plan, {} if other_versions else dict(versions()), note)
    waiting = iter(pending)
    failed: dict[int, str] = {}
    try:
        while True:
            room = tasks.room()
            for chunk in islice(waiting, max(0, room)):
                tasks.give(chunk)
            if not tasks.given:
                break
            chunk, failure = tasks.next()
            if failure is None:
                done(chunk)
                continue
            failed[chunk] = failure
            note(f"chunk {chunk} failed: {failure}")
            if len(failed) >= MAX_FAILURES:
                break
    finally:
        tasks.forget()
    if failed:
        names = ", ".join(map(str, sorted(failed)))
        raise Unfinished(
            f"chunks {names} failed, the first one because {next(iter(failed.values()))}; what is"
            " done is kept: run again to try them again"
        )


class _Tasks:
    """The tasks that a scheduler has: a few for each thread, and their ends in a queue."""

    def __init__(
        self,
        client: Any,
        store: Store,
        plan: Plan,
        wanted: Mapping[str, str],
        note: Callable[[str], object],
    ) -> None:
        self.given: dict[int, Any] = {}
        self._threads, self._counted = 0, -RECOUNT
        self._note, self._waits = note, False
        self._client = client
        self._marks = store.marks
        self._ended: queue.SimpleQueue[int] = queue.SimpleQueue()
        content = json.dumps(plan.content)
        self._task = (os.fspath(store.path.resolve()), store.identity, content, wanted)
        self._name = f"rimroll-{store.identity}-{os.urandom(4).hex()}"

    def room(self) -> int:
        """How many more tasks to give to the scheduler; workers come and go."""
        self._count()
        return AHEAD * max(1, self._threads) - len(self.given)

    def _count(self) -> None:
        """Count the threads of the cluster now and then, and say if there are none."""
        now = time.monotonic()
        if now < self._counted + RECOUNT:
            return
        self._counted = now
        try:
            self._threads = sum(self._client.nthreads().values())
        except OSError:
            raise RimrollError(LOST) from None
        if self._waits != (self._threads == 0):
            self._waits = self._threads == 0
            none = "the scheduler has no workers: waiting for some"
            self._note(none if self._waits else "workers have come")

    def give(self, chunk: int) -> None:
        future = self._client.submit(
            task, *self._task, chunk, key=f"{self._name}-{chunk}", pure=False, retries=TRIES - 1
        )
        self.given[chunk] = future
        future.add_done_callback(lambda _: self._ended.put(chunk))

    def next(self) -> tuple[int, str | None]:
        """Wait for the end of a task; return its chunk, and why it failed."""
        while True:
            try:
                chunk = self._ended.get(timeout=1.0)
                break
            except queue.Empty:
                if self._client.status != "running":
                    raise RimrollError(LOST) from None
                self._count()
        future = self.given.pop(chunk)
        if future.status in ("cancelled", "lost"):
            raise RimrollError(LOST)
        if future.status == "error":
            return chunk, _reason(future.exception())
        # The mark says that it is done. To ask the worker for its answer takes longer, and one of
        # many thousands of answers may never come.
        if self._marks.file(chunk).exists():
            return chunk, None
        try:
            answer = future.result(timeout=ANSWERS)
        except TimeoutError:
            return chunk, "its worker does not answer"
        if reason := answer.get("stop"):
            raise RimrollError(reason)
        return chunk, None

    def forget(self) -> None:
        """Give back all tasks."""
        with contextlib.suppress(Exception):  # a lost scheduler has none
            self._client.cancel(list(self.given.values()))
        self.given.clear()


def task(path: str, identity: str, content: str, wanted: Mapping[str, str], chunk: int) -> Found:
    """Compute a chunk on a worker, unless it has other versions than are wanted, if any are."""
    where = f"the worker {_address()}"
    found = difference(versions(), wanted) if wanted else None
    if found:
        return {"stop": f"{where} has {found[0]}, this is {found[1]}"}
    try:
        store, plan = _opened(path, identity, content)
        work(store, plan, chunk, threads=1)
    except RimrollError as error:
        return {"stop": f"{where}: {error}"}
    return {}


@lru_cache(maxsize=2)
def _opened(path: str, identity: str, content: str) -> tuple[Store, Plan]:
    """The store of a task and its plan; ``StoreError`` if another store lies there."""
    store = Store(path)
    if store.identity != identity:
        raise StoreError(f"{path} is another store here")
    plan = plan_of(json.loads(content))
    store.expect_study(plan)  # versions are those that the client accepts
    return store, plan


def _address() -> str:
    try:
        return str(_distributed().get_worker().address)
    except ValueError:
        return "itself"


def _same_versions(client: Any) -> None:
    """Raise ``RimrollError``, which names the worker, unless versions agree across the cluster."""
    versions = client.get_versions()
    own = _packages(versions["client"])
    others = {"the scheduler": versions["scheduler"], **versions["workers"]}
    for address, found in others.items():
        for name, version in _packages(found).items():
            if version != own[name]:
                who = address if address == "the scheduler" else f"the worker {address}"
                raise RimrollError(f"{who} has {name} {version}, this is {name} {own[name]}")


def _packages(versions: Any) -> dict[str, str]:
    """The versions of what sends and receives tasks."""
    host, packages = versions["host"], versions["packages"]
    python = ".".join(str(host["python"]).split(".")[:2])
    return {"python": python, **{name: packages[name] for name in ("dask", "distributed")}}


LOST = "the scheduler was lost; what is done is kept: run again to continue"


def _reason(error: BaseException) -> str:
    if type(error).__name__ == "KilledWorker":
        return "every worker that tried it died, perhaps for want of memory"
    return f"{type(error).__name__}: {' '.join(str(error).split())}"


def _distributed() -> Any:
    try:
        import distributed
    except ImportError:
        raise RimrollError("a cluster needs dask: pip install 'rimroll[cluster]'") from None
    return distributed
