"""A small study in a file, its hash, and programs that compute it."""

import json
import os
import re
import subprocess
import sys
import time
from pathlib import Path

from given.ctrl_c import PATIENCE

STUDY = """
kind = "topple"
trials = 50
seed = 7
chunk = 10
keep = ["turn", "outcome", "slid", "steps"]
body = { preset = "can_2007" }
law = { kind = "coulomb" }
release = "paper"
axes = { friction = { of = "law.friction", values = [0.05, 0.1, 0.4] } }
"""
"""150 flicks in 15 chunks."""

STRICTLY = ("-W", "error", "-W", "ignore:During parsing environment variable:ImportWarning")
"""Python's options for warnings as errors, as pytest has them: see ``pyproject.toml``."""

CHUNKS = 15

STATISTICS = """
[statistics]
count = ["outcome"]
mean = ["turn"]
"""


def written(path, text=STUDY):
    """The file of a study; its results are to lie beside it, in ``STUDY.zarr``."""
    path.write_text(text, "utf-8")
    return path


def rimroll(*arguments, **options):
    """A command in a process of its own, where warnings are errors: code, stdout and stderr."""
    run = subprocess.run(
        [sys.executable, *STRICTLY, "-m", "rimroll.cli", *map(str, arguments)],
        capture_output=True,
        text=True,
        timeout=PATIENCE,
        **options,
    )
    return run.returncode, run.stdout, run.stderr


def in_process(file, **options):
    """Compute what is not done of a study in this process; return its store."""
    from rimroll.study.run import run
    from rimroll.study.study import Study

    return run(Study.from_file(file).plan(), file.with_suffix(".zarr"), **options)


def done(file):
    """The chunks of a study that are done."""
    from rimroll.study.chunks import Marks

    folder = file.with_suffix(".zarr") / "done"
    return Marks(folder).done() if folder.is_dir() else set()


def until(sign, *processes):
    """Wait until `sign()` is true, which one of the processes must bring about; return it."""
    end = time.monotonic() + PATIENCE
    while not (found := sign()):
        for process in processes:
            assert process.poll() is None, f"it ended by itself: {process.communicate()}"
        assert time.monotonic() < end, "it never happened"
        time.sleep(0.02)
    return found


def with_tests(**more):
    """The environment of a process that can import what is in this folder."""
    path = [str(Path(__file__).parents[1]), *filter(None, [os.environ.get("PYTHONPATH")])]
    return {**os.environ, "PYTHONPATH": os.pathsep.join(path), **more}


def hash_in(output):
    """The hash that ``rimroll study verify`` printed."""
    return re.search(r"^sha256 ([0-9a-f]{64})$", output, re.M)[1]


def as_json(output):
    """What a command printed with ``--json``."""
    return json.loads(output)
