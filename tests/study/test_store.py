"""The store of a study: what it holds, whom it refuses, and what becomes of damage."""

import json
import os
import re
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
import xarray as xr

import rimroll as rr
from given.small_study import (
    CHUNKS,
    STATISTICS,
    STRICTLY,
    STUDY,
    as_json,
    done,
    hash_in,
    in_process,
    written,
)
from rimroll.cli import main
from rimroll.study.chunks import StoreError
from rimroll.study.plan import Plan
from rimroll.study.status import verify
from rimroll.study.store import Store


@pytest.fixture
def file(tmp_path):
    return written(tmp_path / "flicks.toml")


def test_the_store_holds_the_columns_of_the_plan(file):
    plan = rr.Study.from_file(file).plan()
    columns = plan.compute(0, plan.rows)
    found = rr.Study.from_file(file).run(file.with_suffix(".zarr"))
    assert dict(found.sizes) == dict(plan.dims)
    assert set(found.data_vars) == set(plan.columns)
    for name, column in columns.items():
        assert found[name].dtype == column.dtype
        assert np.array_equal(found[name].values.ravel(), column, equal_nan=column.dtype == float)
    assert found.friction.values.tolist() == [0.05, 0.1, 0.4]
    assert found.turn.attrs["units"] == "rad"
    names = found.outcome.attrs["flag_meanings"].split()
    assert (
        names[found.outcome.attrs["flag_values"].index(0)]
        == rr.Study.from_file(file).plan().columns["outcome"].flags[0]
    )
    assert json.loads(found.attrs["study"])["law"] == {"kind": "coulomb"}
    assert found.attrs["rimroll_version"] == rr.__version__


@pytest.mark.parametrize("more", ["", STATISTICS], ids=["columns", "statistics"])
def test_equal_studies_have_equal_hashes_whatever_the_chunks_and_threads(tmp_path, more):
    hashes = set()
    for chunk, threads in ((10, None), (7, 1), (1000, 2)):
        text = STUDY.replace("chunk = 10", f"chunk = {chunk}") + more
        path = written(tmp_path / f"{chunk}.toml", text)
        hashes.add(verify(in_process(path, threads=threads)).sha256)
    assert len(hashes) == 1 and None not in hashes
    other = written(tmp_path / "other.toml", STUDY.replace("seed = 7", "seed = 8") + more)
    assert verify(in_process(other)).sha256 not in hashes


def test_xarray_opens_a_store_without_rimroll(file):
    store = in_process(file)
    program = f"""
import sys
sys.modules["rimroll"] = None  # makes any import of it fail
import xarray as xr
found = xr.open_zarr({str(store.path)!r}, consolidated=False)
print(found.sizes["trial"], float(found.turn.sel(friction=0.1)[3]), found.turn.units)
"""
    run = subprocess.run(
        [sys.executable, *STRICTLY, "-c", program], capture_output=True, text=True, check=True
    )
    turn = float(store.open().turn.values[1, 3])
    assert run.stdout == f"50 {turn} rad\n"


def test_a_store_is_opened_without_reading_its_numbers(file):
    store = in_process(file)
    for chunk in range(CHUNKS):
        for numbers in store.numbers.files(chunk):
            numbers.write_bytes(b"?")
    found = store.open()
    assert found.turn.shape == (3, 50)


def test_what_is_not_done_is_missing_in_the_dataset(file):
    store = in_process(file, chunks=range(1, 2))
    found = store.open()
    assert np.isnan(found.turn.values[0, :10]).all()
    assert (found.outcome.values[0, :10] == -1).all()
    assert (found.slid.values[0, :10] == -1).all()
    assert (found.outcome.values[0, 10:20] >= 0).all()


def test_a_study_is_resumed_where_it_was_stopped(file, tmp_path, monkeypatch):
    whole = verify(in_process(written(tmp_path / "whole.toml"))).sha256
    in_process(file, chunks=range(3, 8))
    assert done(file) == set(range(3, 8))
    assert verify(Store(file.with_suffix(".zarr"))).missing == [0, 1, 2, *range(8, CHUNKS)]
    in_process(file, chunks=range(5, 9))
    computed = []
    usual = Plan.compute

    def noting(self, first, *more, **options):
        computed.append(first)
        return usual(self, first, *more, **options)

    monkeypatch.setattr(Plan, "compute", noting)
    assert verify(in_process(file)).sha256 == whole
    assert computed == [10 * chunk for chunk in (0, 1, 2, *range(9, CHUNKS))]
    in_process(file)
    assert len(computed) == 9


def test_the_chunks_of_a_store_stay_when_those_of_the_study_change(file, tmp_path):
    whole = verify(in_process(written(tmp_path / "whole.toml"))).sha256
    in_process(file, chunks=range(3))
    written(file, STUDY.replace("chunk = 10", "chunk = 25"))
    store = in_process(file)
    assert store.blocks.number == CHUNKS
    assert verify(store).sha256 == whole


def test_a_changed_study_is_refused_with_what_differs(file):
    in_process(file, chunks=range(1))
    written(file, STUDY.replace("0.4]", "0.5]").replace("seed = 7", "seed = 8"))
    with pytest.raises(StoreError) as refused:
        in_process(file)
    assert "store of another study" in str(refused.value)
    assert "study.axes.friction.values was [0.05, 0.1, 0.4], is [0.05, 0.1, 0.5]" in str(
        refused.value
    )
    assert "study.seed was 7, is 8" in str(refused.value)


@pytest.mark.parametrize("other", ["zarr", "files", "file"])
def test_what_another_program_made_is_left_alone(file, other, capsys):
    place = file.with_suffix(".zarr")
    if other == "zarr":
        xr.Dataset({"x": ("n", [1.0])}).to_zarr(place, consolidated=False)
    elif other == "files":
        place.mkdir()
        (place / "thesis.tex").write_text("x")
    else:
        place.write_text("x")
    before = sorted(place.rglob("*"))
    assert main(["study", "run", str(file)]) == 2
    assert "is no store of a study" in capsys.readouterr().err
    assert main(["study", "verify", str(file)]) == 2
    assert sorted(place.rglob("*")) == before


def test_a_store_of_a_later_form_is_refused(file):
    store = in_process(file, chunks=range(1))
    meta = store.path / "zarr.json"
    meta.write_text(meta.read_text().replace('"version": 1', '"version": 2'))
    with pytest.raises(StoreError, match="form 2, this rimroll knows form 1"):
        in_process(file)


@pytest.mark.skipif(os.name == "nt" or os.geteuid() == 0, reason="every folder can be written to")
def test_a_folder_without_permission_is_named(file, capsys):
    file.parent.chmod(0o500)
    try:
        assert main(["study", "run", str(file)]) == 2
    finally:
        file.parent.chmod(0o700)
    assert "permission denied" in capsys.readouterr().err


@pytest.mark.parametrize("more", ["", STATISTICS], ids=["columns", "statistics"])
def test_damaged_chunks_are_found_and_computed_again(file, capsys, more):
    written(file, STUDY + more)
    store = in_process(file)
    command = ["study", "verify", str(file)]
    assert main(command) == 0
    whole = hash_in(capsys.readouterr().out)
    changed, cut, lost = (next(iter(store.numbers.files(chunk))) for chunk in (2, 5, 9))
    content = bytearray(changed.read_bytes())
    # In a part, some bytes mean nothing: damage a number of its first array.
    place = content.index(b" \n") + 2 if changed.suffix == ".npz" else len(content) // 2
    content[place] ^= 1
    changed.write_bytes(content)
    cut.write_bytes(cut.read_bytes()[:10])
    lost.unlink()
    assert main(command) == 1
    shown = capsys.readouterr().out
    assert "damaged chunks: 2, 5, 9; --repair" in shown and "sha256" not in shown
    assert main([*command, "--repair", "--json"]) == 1
    found = as_json(capsys.readouterr().out)
    assert found["damaged"] == [2, 5, 9] and found["sha256"] is None
    assert done(file) == set(range(CHUNKS)) - {2, 5, 9}
    assert main(["study", "run", str(file)]) == 0
    capsys.readouterr()
    assert main(command) == 0
    assert hash_in(capsys.readouterr().out) == whole


def test_damaged_statistics_are_found_and_merged_again(file, capsys):
    written(file, STUDY + STATISTICS)
    store = in_process(file)
    whole = verify(store).sha256
    store.arrays["outcome_count"][0, 0] += 1
    found = verify(store)
    assert found.unmerged and found.sha256 is None and found.damaged == []
    assert main(["study", "verify", str(file), "--repair"]) == 1
    assert "damaged statistics; run computes them again" in capsys.readouterr().out
    assert verify(in_process(file)).sha256 == whole


def test_statistics_are_written_again_if_a_run_was_killed_while_it_wrote_them(file, capsys):
    written(file, STUDY + STATISTICS)
    store = in_process(file)
    whole = verify(store).sha256
    shown = ["study", "show", str(file), "--json"]
    assert main(shown) == 0
    quantities = as_json(capsys.readouterr().out)["quantities"]
    store.marks.remove_merged()
    store.arrays["outcome_count"][...] = -1
    assert main(["study", "verify", str(file)]) == 1
    assert "the statistics are not written: run writes them" in capsys.readouterr().out
    assert main(["study", "status", str(file)]) == 0
    assert "the statistics are not written: run writes them" in capsys.readouterr().out
    assert main(shown) == 0
    assert as_json(capsys.readouterr().out)["quantities"] == quantities
    assert verify(in_process(file)).sha256 == whole


def test_merged_statistics_that_cannot_be_read_are_damage(file):
    written(file, STUDY + STATISTICS)
    store = in_process(file)
    whole = verify(store).sha256
    (content,) = (path for path in (store.path / "turn_mean" / "c").rglob("*") if path.is_file())
    content.write_bytes(content.read_bytes()[:10])
    found = verify(Store(store.path))
    assert found.unmerged and found.sha256 is None
    store.marks.remove_merged()
    assert verify(in_process(file)).sha256 == whole


def test_statistics_of_all_rows_have_no_dimensions(file):
    written(
        file,
        STUDY + STATISTICS.replace("[statistics]", '[statistics]\nover = ["friction", "trial"]'),
    )
    store = in_process(file)
    found = store.open()
    assert found.turn_mean.dims == () and int(found.number) == 150
    assert verify(store).sha256


@pytest.mark.parametrize("command", ["show", "status", "verify"])
def test_the_store_of_a_changed_study_is_not_shown(file, command, capsys):
    in_process(file)
    written(file, STUDY.replace("0.4]", "0.5]"))
    assert main(["study", command, str(file)]) == 2
    assert "is the store of another study: study.axes.friction" in capsys.readouterr().err
    assert main(["study", command, str(file.with_suffix(".zarr"))]) == 0


@pytest.mark.parametrize(
    "attribute, named",
    [("numpy_version", "numpy 1.0, here is numpy "), ("rimroll_build", "rimroll build 1.0, here ")],
)
def test_a_store_of_other_versions_is_shown_but_not_continued_unless_told(
    file, capsys, attribute, named
):
    store = in_process(file, chunks=range(1))
    meta = store.path / "zarr.json"
    meta.write_text(re.sub(rf'"{attribute}": "[^"]*"', f'"{attribute}": "1.0"', meta.read_text()))
    assert main(["study", "run", str(file)]) == 2
    assert f"was made with {named}" in capsys.readouterr().err
    assert done(file) == {0}
    assert main(["study", "status", str(file)]) == 0
    assert main(["study", "run", str(file), "--chunks", "0:2", "--other-versions"]) == 0
    assert done(file) == {0, 1}


def test_rows_that_are_not_done_are_neither_true_nor_false(file, capsys):
    written(file, STUDY.replace('["turn", "outcome", "slid", "steps"]', '["slid"]'))
    store = in_process(file, chunks=range(2))
    assert store.open().done.values.sum() == 20
    assert main(["study", "show", str(file), "--json"]) == 0
    assert as_json(capsys.readouterr().out)["quantities"]["slid"]["values"] == 20
    assert "done" not in in_process(file).open().coords


def test_what_is_left_of_stores_that_were_never_made_is_swept(file):
    left = file.parent / ".flicks.zarr.0a1b2c3d.partial"
    other = file.parent / ".other.zarr.0a1b2c3d.partial"
    for folder in (left, other):
        folder.mkdir()
        (folder / "zarr.json").write_text("{")
    in_process(file, chunks=range(1))
    assert not left.exists() and other.exists()


@pytest.mark.skipif(not os.path.exists("/proc/self/fd"), reason="files have no names here")
@pytest.mark.parametrize("more", ["", STATISTICS], ids=["columns", "statistics"])
def test_folders_are_flushed_before_a_mark_counts_on_them(file, more, monkeypatch):
    written(file, STUDY + more)
    settled = {}  # what was in a folder when it was flushed
    usual = os.fsync

    def noting(descriptor):
        usual(descriptor)
        place = Path(os.readlink(f"/proc/self/fd/{descriptor}"))
        if place.is_dir():
            final = re.sub(r"/\.(flicks\.zarr)\.[0-9a-f]{8}\.partial", r"/\1", str(place))
            settled.setdefault(Path(final), set()).update(os.listdir(place))

    monkeypatch.setattr(os, "fsync", noting)
    store = in_process(file)
    assert "flicks.zarr" in settled[file.parent]
    ends = [store.path / "zarr.json", store.marks.file(3), *store.numbers.files(3)]
    ends += [path for path in (store.path / "turn_mean").rglob("*") if more and path.is_file()]
    for path in ends:
        for inner in (path, *path.relative_to(store.path).parents[:-1]):
            place = store.path / inner
            assert place.name in settled[place.parent], place


def test_a_damaged_mark_is_damage(file):
    store = in_process(file)
    store.marks.file(4).write_text("{")
    assert verify(store).damaged == [4]


def test_status_says_what_is_done(file, capsys):
    in_process(file, chunks=range(4))
    assert main(["study", "status", str(file), "--json"]) == 0
    found = as_json(capsys.readouterr().out)
    assert (found["chunks"], found["chunks_done"]) == (CHUNKS, 4)
    assert (found["motions"], found["motions_done"]) == (150, 40)
    assert found["seconds"] > 0.0 and found["owners"] == []
    assert main(["study", "status", str(file.with_suffix(".zarr"))]) == 0
    assert "4 of 15 chunks are done" in capsys.readouterr().out


@pytest.mark.parametrize(
    "arguments, complaint",
    [
        (["--chunks", "10:20"], "chunks must lie between 0 and 15, got 10:20"),
        (["--chunks", "5:5"], "chunks must lie between 0 and 15, got 5:5"),
        (["--chunks", "all"], "--chunks must be two whole numbers such as 120:240, got 'all'"),
        (["--workers", "0"], "must be between 1 and 10000, got 0"),
        (["--workers", "2", "--scheduler", "tcp://127.0.0.1:9"], "either workers or a scheduler"),
        (["--workers", "2", "--threads", "1"], "threads are those of this process"),
        (["--scheduler", "nonsense"], "no scheduler answers at nonsense"),
    ],
)
def test_requests_that_cannot_be_met_are_refused(file, capsys, arguments, complaint):
    assert main(["study", "run", str(file), *arguments]) == 2
    assert complaint in capsys.readouterr().err


def test_a_store_that_there_is_not_is_named(file, capsys):
    assert main(["study", "status", str(file)]) == 2
    assert "there is no store" in capsys.readouterr().err


def test_zarr_is_asked_for_where_it_is_missing(file, capsys, monkeypatch):
    monkeypatch.setitem(sys.modules, "zarr", None)
    assert main(["study", "run", str(file)]) == 2
    assert "pip install 'rimroll[cluster]'" in capsys.readouterr().err


def test_dask_is_asked_for_where_it_is_missing(file, capsys, monkeypatch):
    monkeypatch.setitem(sys.modules, "distributed", None)
    assert main(["study", "run", str(file), "--workers", "2"]) == 2
    assert "pip install 'rimroll[cluster]'" in capsys.readouterr().err
