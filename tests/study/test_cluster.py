"""A study on a Dask cluster: real schedulers and workers, which are killed."""

import re
import signal

import pytest

from given.ctrl_c import needs_signals
from given.dask_programs import client, pausing, scheduler, worker
from given.small_study import CHUNKS, done, in_process, rimroll, until, written
from rimroll.study.cluster import _Tasks
from rimroll.study.status import verify
from rimroll.study.study import Study
from rimroll.study.versions import build

pytestmark = [needs_signals, pytest.mark.slow]


@pytest.fixture
def file(tmp_path):
    return written(tmp_path / "flicks.toml")


@pytest.fixture(scope="module")
def whole(tmp_path_factory):
    """The hash of the study, computed in one process."""
    return verify(in_process(written(tmp_path_factory.mktemp("whole") / "flicks.toml"))).sha256


@pytest.fixture(scope="module")
def cluster(tmp_path_factory):
    """The address of a cluster with one worker that works."""
    folder = tmp_path_factory.mktemp("cluster")
    with scheduler(folder) as (address, _), worker(address):
        yield address


@pytest.mark.parametrize("place", ["compute", pytest.param("mark", marks=pytest.mark.soak)])
def test_a_worker_is_killed(file, cluster, whole, place):
    with pausing(cluster, file, place) as (process, reached), client(file, cluster) as run:
        until(reached.exists, process, run)
        process.send_signal(signal.SIGKILL)
        out, err = run.communicate()
    assert run.returncode == 0, err
    assert "150 of 150 motions are done" in out
    assert "dashboard: " in err
    assert verify(in_process(file)).sha256 == whole


def test_a_client_is_killed_while_its_worker_goes_on(file, cluster, whole):
    with pausing(cluster, file, "mark") as (process, reached):
        with client(file, cluster) as run:
            until(reached.exists, process, run)
            run.send_signal(signal.SIGKILL)
            run.wait()
        store = in_process(file)
        assert verify(store).sha256 == whole
        before = {path: path.stat().st_mtime_ns for path in store.marks.folder.glob("*.json")}
        reached.unlink()  # the worker writes the mark of a chunk that is done by now

        def written_again():
            return any(path.stat().st_mtime_ns != before[path] for path in before)

        until(written_again, process)
        assert verify(store).sha256 == whole


def test_a_scheduler_is_killed(file, whole):
    with scheduler(file.parent) as (address, process), client(file, address) as run:
        assert run.stderr.readline().startswith("dashboard: ")
        assert run.stderr.readline() == "the scheduler has no workers: waiting for some\n"
        with pausing(address, file, "mark") as (working, reached):
            until(reached.exists, working, run)
            assert run.stderr.readline() == "workers have come\n"
            process.send_signal(signal.SIGKILL)
            _, err = run.communicate()
    assert run.returncode == 2
    lost = "rimroll: the scheduler was lost; what is done is kept: run again to continue"
    assert err.splitlines()[-1] == lost
    assert verify(in_process(file)).sha256 == whole


def test_a_chunk_that_kills_its_workers_is_named(file, whole):
    environment = {"DASK_DISTRIBUTED__SCHEDULER__ALLOWED_FAILURES": "0"}
    with (
        scheduler(file.parent, **environment) as (address, _),
        pausing(address, file, "compute", "die") as (process, _),
        client(file, address) as run,
    ):
        process.wait()
        with worker(address):
            _, err = run.communicate()
    assert run.returncode == 2
    assert "every worker that tried it died, perhaps for want of memory" in err
    assert err.splitlines()[-1].startswith("rimroll: chunks ")
    assert 0 < len(done(file)) < CHUNKS
    assert verify(in_process(file)).sha256 == whole


def test_a_worker_with_another_build_of_the_same_version_is_refused_by_name(file, whole):
    code = "from rimroll.study import versions; versions.build = lambda: 'another'\n"
    with scheduler(file.parent) as (address, _), worker(address, "--preload", code):
        status, _, err = rimroll("study", "run", file, "--scheduler", address)
        assert status == 2
        refused = rf"rimroll: the worker tcp://\S+ has rimroll build another, this is .* {build()}$"
        assert re.search(refused, err, re.M)
        assert not done(file)
        store = in_process(file, scheduler=address, other_versions=True)
    assert verify(store).sha256 == whole
    assert store.marks.read(0).rimroll.endswith(" build another")


def test_a_scheduler_that_does_not_answer_is_named(file):
    status, _, err = rimroll("study", "run", file, "--scheduler", "tcp://127.0.0.1:1")
    assert status == 2
    assert err.startswith("rimroll: no scheduler answers at tcp://127.0.0.1:1: ")
    assert err.count("\n") == 1


class Silent:
    """A future whose task has ended, and whose worker never answers."""

    status = "finished"

    def result(self, timeout):
        raise TimeoutError


def test_a_chunk_with_a_mark_is_done_although_its_worker_never_answers(file):
    store = in_process(file, chunks=range(1))
    tasks = _Tasks(None, store, Study.from_file(file).plan(), {}, print)
    for chunk, failure in ((0, None), (1, "its worker does not answer")):
        tasks.given[chunk] = Silent()
        tasks._ended.put(chunk)
        assert tasks.next() == (chunk, failure)
