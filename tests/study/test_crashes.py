"""A run that is killed at any place is continued by the next, to the same numbers."""

import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest

from given.ctrl_c import interrupt_when, needs_signals, running
from given.small_study import (
    CHUNKS,
    STATISTICS,
    STUDY,
    done,
    in_process,
    rimroll,
    until,
    with_tests,
    written,
)
from rimroll.errors import RimrollError
from rimroll.study.chunks import StoreError, as_store_errors
from rimroll.study.status import verify

pytestmark = needs_signals

RUN = """
import sys
from given import paused
from rimroll.cli import main
sys.exit(main(sys.argv[1:]))
"""


@pytest.fixture
def file(tmp_path):
    return written(tmp_path / "flicks.toml")


def stopped(file, place, *arguments):
    """A run that waits at a place, once it is there."""
    pause = f"wait {place} {file.parent}"
    process = running(
        "-c", RUN, "study", "run", str(file), *arguments, env=with_tests(RIMROLL_PAUSE=pause)
    )
    return process


def killed(file, place, marked):
    """Kill a run at a place, when these chunks have marks: they are written at the same time."""
    with stopped(file, place) as process:
        until((file.parent / "reached").exists, process)
        until(lambda: done(file) == marked, process)
        process.kill()
        process.wait()
    (file.parent / "reached").unlink()


@pytest.mark.slow
@pytest.mark.parametrize(
    "place, more",
    [("compute", STATISTICS), ("mark", "")],
    ids=["amid_a_chunk_of_statistics", "before_the_mark_of_columns"],
)
def test_a_run_that_was_killed_is_continued(tmp_path, place, more):
    whole = verify(in_process(written(tmp_path / "whole.toml", STUDY + more))).sha256
    file = written(tmp_path / "flicks.toml", STUDY + more)
    marked = set() if place == "mark" else {0}
    killed(file, place, marked)
    killed(file, place, marked)  # resumed twice
    assert verify(in_process(file)).sha256 == whole


def test_litter_of_killed_writers_is_swept_and_that_of_others_is_not(file):
    store = in_process(file, chunks=range(5))
    own, others = (next(iter(store.numbers.files(chunk))) for chunk in (7, 2))
    litter = own.with_suffix(".0a1b.partial")
    at_work = others.with_suffix(".0a1b.partial")
    mark = store.marks.file(7).with_suffix(".json.0a1b.partial")
    for part in (litter, at_work, mark):
        part.parent.mkdir(exist_ok=True)
        part.write_bytes(b"?")
    in_process(file, chunks=range(5, 10))
    assert not litter.exists() and not mark.exists()
    assert at_work.exists()


@pytest.mark.slow
def test_ctrl_c_ends_a_run_in_one_line(file):
    written(file, STUDY.replace("trials = 50", "trials = 50000"))
    with running("-m", "rimroll.cli", "study", "run", str(file)) as process:
        out, err = interrupt_when(lambda: done(file), process)
    assert process.returncode == 130
    assert out == ""
    assert err == "what is done is kept: run again to continue\nrimroll: interrupted\n"


@pytest.mark.slow
def test_two_runs_on_the_same_chunks_are_refused_and_others_are_not(file, tmp_path):
    whole = verify(in_process(written(tmp_path / "whole.toml"))).sha256
    with stopped(file, "mark", "--chunks", "0:8") as process:
        until((file.parent / "reached").exists, process)
        for chunks in (None, range(7, 9)):
            with pytest.raises(RimrollError, match=rf"process {process.pid} on .* chunks 0:8"):
                in_process(file, chunks=chunks)
        code, out, _ = rimroll("study", "status", file)
        assert code == 0 and f"process {process.pid}" in out
        in_process(file, chunks=range(8, CHUNKS))
        process.kill()
        process.wait()
    code, out, _ = rimroll("study", "status", file)
    assert code == 0 and "process" not in out
    assert verify(in_process(file)).sha256 == whole


@pytest.mark.slow
def test_jobs_of_an_array_that_start_at_once_fill_one_store(file, tmp_path):
    whole = verify(in_process(written(tmp_path / "whole.toml"))).sha256
    jobs = [
        subprocess.Popen(
            [sys.executable, "-m", "rimroll.cli", "study", "run", str(file), "--chunks", chunks]
        )
        for chunks in ("0:7", "7:15")
    ]
    assert [job.wait() for job in jobs] == [0, 0]
    assert verify(in_process(file)).sha256 == whole
    assert [path.name for path in file.parent.glob(".*.partial")] == []


FULL = """
import resource, signal, sys
from rimroll.cli import main
from rimroll.study.chunks import Marks
usual = Marks.add

def add(self, chunk, mark):
    usual(self, chunk, mark)
    if chunk == 4:  # no file may become longer than 10 bytes from now on
        resource.setrlimit(resource.RLIMIT_FSIZE, (10, resource.RLIM_INFINITY))

Marks.add = add
sys.exit(main(sys.argv[1:]))
"""


@pytest.mark.slow
def test_where_no_room_is_left_a_run_ends_in_one_line_and_can_be_continued(file, tmp_path):
    whole = verify(in_process(written(tmp_path / "whole.toml"))).sha256
    run = subprocess.run(
        [sys.executable, "-c", FULL, "study", "run", str(file)], capture_output=True, text=True
    )
    assert run.returncode == 2
    assert run.stderr.startswith("rimroll: no room is left on the disk of ")
    assert run.stderr.count("\n") == 1
    assert done(file) == {0, 1, 2, 3, 4}
    assert verify(in_process(file)).sha256 == whole


@pytest.mark.skipif(not os.path.exists("/dev/full"), reason="no device that is always full")
def test_a_full_disk_is_named(tmp_path):
    with pytest.raises(StoreError, match="no room is left"), as_store_errors(tmp_path):
        Path("/dev/full").write_bytes(b"x")


@pytest.mark.soak
def test_a_client_with_workers_of_its_own_is_killed(file, tmp_path):
    whole = verify(in_process(written(tmp_path / "whole.toml"))).sha256
    written(file, STUDY)
    with running("-m", "rimroll.cli", "study", "run", str(file), "--workers", "2") as process:
        until(lambda: done(file), process)
        process.send_signal(signal.SIGKILL)
        process.wait()
    assert verify(in_process(file)).sha256 == whole
