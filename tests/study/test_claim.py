"""Locks on the chunks of a store: of this process, of others, and of those that were killed."""

import json
import os
import subprocess
import sys
from contextlib import contextmanager

import pytest

from given.ctrl_c import needs_signals
from given.small_study import with_tests
from rimroll.errors import RimrollError
from rimroll.study.run import at_work, claimed

HOLD = """
import sys
from pathlib import Path
from rimroll.study.run import claimed
folder, *spans = sys.argv[1:]
from contextlib import ExitStack
with ExitStack() as stack:
    for span in spans:
        stack.enter_context(claimed(Path(folder), *map(int, span.split(":"))))
    print("held", flush=True)
    sys.stdin.read()
"""


@contextmanager
def holding(folder, *spans):
    """A process that holds chunks until the block ends, or until it is killed."""
    process = subprocess.Popen(
        [sys.executable, "-c", HOLD, str(folder), *spans],
        env=with_tests(),
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        text=True,
    )
    try:
        assert process.stdout.readline() == "held\n"
        yield process
    finally:
        process.communicate()


def owners(folder):
    """The processes at work, and their chunks."""
    return [(int(one.split()[1]), one.split()[-1]) for one in at_work(folder)]


def test_a_process_holds_chunks_once(tmp_path):
    with claimed(tmp_path, 0, 4) as held:
        assert held
        with (
            pytest.raises(RimrollError, match=rf"process {os.getpid()} on .* chunks 0:4 of"),
            claimed(tmp_path, 3, 6),
        ):
            pass
        with claimed(tmp_path, 4, 6):
            assert owners(tmp_path) == [(os.getpid(), "0:4"), (os.getpid(), "4:6")]
        assert owners(tmp_path) == [(os.getpid(), "0:4")]
    assert owners(tmp_path) == []
    with claimed(tmp_path, 3, 6):
        pass


def test_locks_of_a_process_outlive_a_look_at_them_and_other_runs_of_it(tmp_path):
    look = (
        "import sys; from pathlib import Path; from rimroll.study.run import at_work;"
        "print(*at_work(Path(sys.argv[1])), sep='\\n')"
    )
    with claimed(tmp_path, 0, 4):
        at_work(tmp_path)
        with claimed(tmp_path, 6, 8):
            pass
        seen = subprocess.run(
            [sys.executable, "-c", look, str(tmp_path)], capture_output=True, text=True, check=True
        ).stdout
    assert [line.split()[1] for line in seen.splitlines()] == [str(os.getpid())]
    assert seen.strip().endswith("chunks 0:4")


def test_others_that_hold_chunks_are_named_and_left_alone(tmp_path):
    with holding(tmp_path, "2:4", "4:7", "9:12") as process:
        for _ in range(2):
            spans = [(process.pid, span) for span in ("2:4", "4:7", "9:12")]
            assert owners(tmp_path) == spans
        with (
            pytest.raises(RimrollError, match=rf"process {process.pid} on .* chunks 4:7 of"),
            claimed(tmp_path, 5, 9),
        ):
            pass
        with claimed(tmp_path, 7, 9):
            assert (os.getpid(), "7:9") in owners(tmp_path)
            assert len(owners(tmp_path)) == 4


@needs_signals
def test_owners_that_were_killed_are_not_at_work(tmp_path):
    with holding(tmp_path, "0:15") as killed:
        killed.kill()
    assert (tmp_path / "owner-0-15.json").exists()
    assert at_work(tmp_path) == []
    with holding(tmp_path, "0:4") as process:
        assert owners(tmp_path) == [(process.pid, "0:4")]
        assert not (tmp_path / "owner-0-15.json").exists()
    assert at_work(tmp_path) == []


def test_a_note_of_a_dead_process_does_not_name_the_living(tmp_path):
    with holding(tmp_path, "0:4") as process:
        note = tmp_path / "owner-1-3.json"
        found = json.loads((tmp_path / "owner-0-4.json").read_text())
        note.write_text(json.dumps({**found, "chunks": [1, 3], "process": process.pid + 1}))
        assert owners(tmp_path) == [(process.pid, "0:4")]


@pytest.mark.skipif(os.name == "nt" or os.geteuid() == 0, reason="every folder can be written to")
def test_who_may_only_read_sees_who_is_at_work(tmp_path):
    with holding(tmp_path, "0:4") as process:
        tmp_path.chmod(0o500)
        try:
            assert owners(tmp_path) == [(process.pid, "0:4")]
        finally:
            tmp_path.chmod(0o700)
