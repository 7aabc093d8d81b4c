"""A study on a cluster that loses a worker and its client is continued, and read without rimroll.

Workers stop at definite places, so nothing here depends on how fast a machine is.
"""

import json
import signal
import subprocess
import sys

import numpy as np
import pytest

from given.ctrl_c import needs_signals
from given.dask_programs import client, pausing, scheduler
from given.small_study import done, hash_in, in_process, rimroll, until, written
from rimroll.study.status import verify

# test_cluster.py guards each loss apart.
pytestmark = [needs_signals, pytest.mark.soak]

MANY = """
kind = "ensemble"
trials = 200
seed = 21
chunk = 20
keep = ["turn", "outcome", "slid"]
body = { preset = "can_2007" }
start = { tilt = "20 deg", tilt_rate = -0.4, yaw_rate = 0.01 }
law = { kind = "coulomb" }
axes = { friction = { of = "law.friction", range = [0.02, 0.5], number = 12 } }

[random.height]
of = "body.height"
distribution = "uniform"
low = "6 cm"
high = "8 cm"
"""
"""2400 turns in 120 chunks."""

CHUNKS = 120

MARKED = 5
"""The marks that the second worker writes before it stops."""

READ = """
import json, sys
import xarray as xr
store = xr.open_zarr(sys.argv[1], consolidated=False)
answer = {
    "sizes": dict(store.sizes),
    "units": store.turn.attrs["units"],
    "friction": store.friction.values.tolist(),
    "turn": store.turn.values.tolist(),
    "study": json.loads(store.attrs["study"])["seed"],
    "rimroll": [name for name in sys.modules if name.partition(".")[0] == "rimroll"],
}
print(json.dumps(answer))
"""


def places(folder):
    """Folders for the signs of two workers."""
    for name in ("first", "second"):
        (folder / name).mkdir()
        yield folder / name / "flicks.toml"


def test_a_study_that_loses_a_worker_and_its_client_ends_with_the_numbers_of_one_process(tmp_path):
    whole = in_process(written(tmp_path / "whole.toml", MANY))
    file = written(tmp_path / "turns.toml", MANY)
    first, second = places(tmp_path)

    with (
        scheduler(tmp_path) as (address, _),
        pausing(address, first, "compute") as (lost, at_work),
        client(file, address) as run,
    ):
        until(at_work.exists, lost, run)
        lost.send_signal(signal.SIGKILL)
        lost.wait()
        assert done(file) <= {0}  # the chunk of the first rows, where no worker stops
        with pausing(address, second, f"mark@{MARKED}") as (other, stopped):
            until(stopped.exists, other, run)
            run.send_signal(signal.SIGKILL)
            run.wait()
    # The second worker may have computed the first chunk again, if the client had no answer yet.
    assert len(done(file) | {0}) in (MARKED, MARKED + 1)

    code, out, err = rimroll("study", "run", file, "--workers", "2")
    assert code == 0, err
    assert "2,400 of 2,400 motions are done" in out
    assert len(done(file)) == CHUNKS

    code, out, err = rimroll("study", "verify", file)
    assert code == 0, err
    assert hash_in(out) == verify(whole).sha256

    read = subprocess.run(
        [sys.executable, "-c", READ, file.with_suffix(".zarr")],
        capture_output=True,
        text=True,
        check=True,
    )
    answer = json.loads(read.stdout)
    assert answer["rimroll"] == []
    assert answer["sizes"] == {"friction": 12, "trial": 200}
    assert answer["units"] == "rad"
    assert answer["study"] == 21
    expected = whole.open()
    np.testing.assert_array_equal(answer["friction"], expected.friction)
    np.testing.assert_array_equal(answer["turn"], expected.turn)
