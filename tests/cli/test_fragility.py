"""``rimroll fragility``: records, levels, limit states, files, errors and Ctrl-C."""

import csv
import json
import warnings
from pathlib import Path

import numpy as np
import pytest
import xarray as xr

import rimroll as rr
from given.at2 import at2
from rimroll.cli import main
from rimroll.cli.simulate import UNDECIDED
from rimroll.many import falls
from rimroll.many.falls import Interrupted
from rimroll.scenario import load
from rimroll.shaking import incremental

EXAMPLES = Path(__file__).parents[2] / "examples"
COLUMN = EXAMPLES / "column.toml"
RECORD = [EXAMPLES / f"synthetic_{name}.at2" for name in ("000", "090", "up")]
FEW = f"fragility {COLUMN} --synthetic 6 --soil-period 0.8s"
SCALES = "--scale 3,4,5"


@pytest.fixture(scope="module")
def column():
    return load(COLUMN).body


@pytest.fixture(scope="module")
def records():
    return {
        f"synthetic {seed}": rr.ground.synthetic(seed, (1.0, 1.0, 0.0), soil_period=0.8)
        for seed in range(6)
    }


@pytest.fixture
def stations(tmp_path):
    """A folder of AT2 files: three components of one station, two of another."""
    random = np.random.default_rng(3)
    for station, parts in (("A", ("000", "090", "UP")), ("B", ("140", "230"))):
        for direction in parts:
            text = at2(0.06 * random.standard_normal(400), direction=direction)
            place = tmp_path / f"QUAKE_{station}{direction}.AT2"
            place.write_text(text.replace("A Station", f"Station {station}"), "utf-8")
    return tmp_path


def test_it_is_shake_many_and_fragility(stdout_of, column, records):
    answer = json.loads(stdout_of(f"{FEW} --scale 2.2,2.6,3,3.5,4.5 --json"))
    factors = rr.axis("scale", [2.2, 2.6, 3.0, 3.5, 4.5])
    shaken = rr.shake_many(
        column, rr.State.standing(), rr.Coulomb(0.6), records, scale=factors, gravity=9.81,
        flat="housner",
    )  # fmt: skip
    peaks = np.array([record.peak.horizontal for record in records.values()])
    curve = rr.fragility(shaken, peaks[:, np.newaxis] * factors.values)
    assert answer["curve"]["median"] == pytest.approx(curve.median, rel=1e-12)
    assert answer["curve"]["dispersion_interval"] == pytest.approx(curve.dispersion_interval)
    assert answer["curve"]["median_interval"] == pytest.approx(curve.median_interval)
    assert (answer["curve"]["method"], answer["curve"]["records"]) == ("jackknife", 6)
    counts = [row["overturned"] for row in answer["levels"]]
    assert counts == shaken["overturned"].sum("ground").values.tolist()
    assert answer["records"]["synthetic 5"]["pga"] == records["synthetic 5"].peak.horizontal


def test_the_interval_rests_on_the_records_and_does_not_narrow_with_the_points(stdout_of):
    study = f"fragility {COLUMN} --synthetic 12 --soil-period 0.8s --intensities 0.25g..0.6g"
    widths = {}
    for points in (10, 40):
        curve = json.loads(stdout_of(f"{study} --levels {points} --json"))["curve"]
        assert (curve["method"], curve["records"]) == ("jackknife", 12)
        low, high = curve["median_interval"]
        widths[points] = np.log(high / low)
    # With independent motions it would be half as wide.
    assert widths[40] > 0.8 * widths[10]
    assert "(jackknife over 12 records)" in stdout_of(f"{study} --levels 10")


def test_every_record_is_scaled_to_the_levels(stdout_of, tmp_path, records):
    file = tmp_path / "all.nc"
    stdout_of(f"{FEW} --intensities 0.3g..0.5g --levels 3 -o {file}")
    with xr.open_dataset(file) as stored:
        np.testing.assert_allclose(stored["pga"], rr.STANDARD_GRAVITY * np.array([0.3, 0.4, 0.5]))
        assert stored["overturned"].dims == ("ground", "pga")
        one = stored.sel(ground="synthetic 2").isel(pga=1)
        peak = records["synthetic 2"].scaled(float(one["scale"])).peak.horizontal
        assert peak == pytest.approx(float(one["pga"]))


def test_levels_may_be_of_the_velocity(stdout_of):
    answer = json.loads(stdout_of(f"{FEW} --measure pgv --intensities 30cm/s,60cm/s --json"))
    assert [row["pgv"] for row in answer["levels"]] == [0.3, 0.6]
    assert answer["unit"] == "m/s"


def test_the_usual_levels_go_from_the_first_uplift_to_where_most_overturn(stdout_of):
    answer = json.loads(stdout_of(f"{FEW} --json"))
    levels = answer["levels"]
    assert len(levels) == 10 and levels[0]["pga"] == pytest.approx(9.81 * 0.25)
    assert levels[0]["overturned"] == 0 and levels[-1]["overturned"] >= 5
    assert levels[0]["pga"] < answer["curve"]["median"] < levels[-1]["pga"]


def test_a_limit_counts_tilts_in_place_of_overturning(stdout_of, column, records):
    answer = json.loads(stdout_of(f"{FEW} {SCALES} --limit 50% --json"))
    shaken = rr.shake_many(
        column, rr.State.standing(), rr.Coulomb(0.6), records, gravity=9.81, flat="housner",
        scale=rr.axis("scale", [3.0, 4.0, 5.0]),
    )  # fmt: skip
    far = (shaken["max_tilt_ratio"] >= 0.5).sum("ground").values.tolist()
    assert [row["failed"] for row in answer["levels"]] == far
    assert sum(far) > sum(row["overturned"] for row in answer["levels"])
    assert answer["limit"] == 0.5


def test_several_limit_states_are_those_of_one_each(stdout_of):
    several = json.loads(stdout_of(f"{FEW} {SCALES} --limit 0.25,50%,overturning --json"))
    states = several["limit_states"]
    assert [state["limit"] for state in states] == [0.25, 0.5, None]
    for state, limit in zip(states, ("--limit 0.25", "--limit 0.5", ""), strict=True):
        one = json.loads(stdout_of(f"{FEW} {SCALES} {limit} --json"))
        assert one["limit_states"] == [state]
        assert state["curve"] == one["curve"] and state["levels"] == one["levels"]
    text = stdout_of(f"{FEW} {SCALES} --limit 0.25,overturning")
    assert "reached 0.25" in text and "the probability of overturning" in text


@pytest.mark.parametrize(
    ("options", "measure"),
    [
        ("--measure pga --horizontal rotd50", lambda one, p: one.intensity("pga", "rotd50")),
        ("--measure pgv --horizontal geomean", lambda one, p: one.intensity("pgv", "geomean")),
        ("--measure sa --period 1s --horizontal rotd50",
         lambda one, p: one.intensity("sa", "rotd50", period=1.0)),
        ("--measure pga-ratio", lambda one, p: one.peak.horizontal / (9.81 * 0.25)),
        ("--measure pgv-ratio", lambda one, p: p * one.peak_velocity.horizontal / (9.81 * 0.25)),
    ],
)  # fmt: skip
def test_the_median_is_in_the_measure_that_is_asked_for(
    stdout_of, column, records, options, measure
):
    factors = np.array([2.5, 3.0, 3.5, 4.0, 4.5, 5.0, 6.0])
    p = rr.rocking_frequency(column, 9.81)
    answer = json.loads(stdout_of(f"{FEW} --scales 2.5,3,3.5,4,4.5,5,6 {options} --json"))
    each = np.array([measure(one, p) for one in records.values()])
    shaken = rr.shake_many(
        column, rr.State.standing(), rr.Coulomb(0.6), records, gravity=9.81,
        scale=rr.axis("scale", factors),
    )  # fmt: skip
    curve = rr.fragility(shaken, each[:, np.newaxis] * factors)
    assert answer["curve"]["median"] == pytest.approx(curve.median, rel=1e-9)
    name = answer["measure"]
    assert answer["records"]["synthetic 3"][name] == pytest.approx(each[3])


def test_files_of_one_station_are_one_record(stdout_of, stations):
    files = " ".join(map(str, sorted(stations.glob("*.AT2"))))
    answer = json.loads(stdout_of(f"fragility {COLUMN} {files} {SCALES} --json"))
    assert list(answer["records"]) == ["QUAKE_A", "QUAKE_B"]
    same = json.loads(stdout_of(f"fragility {COLUMN} --record {files} {SCALES} --json"))
    assert same == answer
    text = stdout_of(f"fragility {COLUMN} {files} {SCALES}")
    assert "2 records: 1 of x, y and z, 1 of x and y" in text


def test_commas_join_the_files_of_a_record(stdout_of, stations):
    x, y = (stations / f"QUAKE_{name}.AT2" for name in ("A000", "B140"))
    other = y.with_name("turned.AT2")
    other.write_text(y.read_text("utf-8").replace("140", "90"), "utf-8")
    answer = json.loads(stdout_of(f"fragility {COLUMN} --record {x},{other} {SCALES} --json"))
    (record,) = answer["records"].values()
    assert record["pga"] == rr.ground.read(x, other).peak.horizontal


def test_the_ground_of_a_file_is_a_record(stdout_of):
    answer = json.loads(stdout_of(f"fragility {COLUMN} --scale 1,1.4 --json"))
    assert answer["records"]["column"]["pga"] == load(COLUMN).ground.peak.horizontal
    assert answer["curve"] is None and answer["why_no_curve"]
    assert "no curve of overturning:" in stdout_of(f"fragility {COLUMN} --scale 1,1.4")


def test_files_hold_all_motions_and_the_curve(stdout_of, tmp_path):
    paths = [tmp_path / f"f.{suffix}" for suffix in ("csv", "nc", "json", "svg")]
    outputs = " ".join(f"-o {path}" for path in paths)
    text = stdout_of(f"{FEW} {SCALES} {outputs}")
    assert all(f"wrote {path}" in text for path in paths)
    lines = paths[0].read_text("utf-8").splitlines()
    rows = list(csv.DictReader(line for line in lines if not line.startswith("#")))
    assert len(rows) == 18 and rows[0]["ground"] == "synthetic 0"
    assert any(line.startswith("# fragility_median = ") for line in lines)
    whole = json.loads(paths[2].read_text("utf-8"))
    with xr.open_dataset(paths[1]) as stored:
        assert stored.attrs["fragility_median"] == whole["curve"]["median"]
        assert stored["overturned"].values.tolist() == whole["columns"]["overturned"]
    assert [
        row["overturned[]"] if "overturned[]" in row else row["overturned"] for row in rows
    ] == [str(int(fell)) for line in whole["columns"]["overturned"] for fell in line]
    assert b"<svg" in paths[3].read_bytes()


def test_motions_that_are_undecided_are_told_with_what_to_do(stdout_of):
    text = stdout_of("fragility coin --synthetic 2 --scale 140,170", UNDECIDED)
    assert "undecided and left out" in text and "--friction 0.3" in text
    flat = stdout_of(f"fragility {COLUMN} {RECORD[0]} --scale 1,2,3 --flat stop", UNDECIDED)
    assert "3 of 3 motions are undecided and left out (3 " in flat
    assert "--flat housner" in flat


def test_ctrl_c_keeps_the_records_that_are_done(capsys, monkeypatch, tmp_path):
    follow = incremental.follow_shaken

    def interrupted(*arguments, **options):
        done = follow(*arguments, **options)
        columns = {name: one.values.ravel()[:14] for name, one in done.columns.items()}
        rows = {name: falls.Column(values) for name, values in columns.items()}
        raise Interrupted(falls.Falls(rows, {"trial": falls.Column(np.arange(14))}, done.attrs))

    monkeypatch.setattr(incremental, "follow_shaken", interrupted)
    file = tmp_path / "part.csv"
    assert main(f"{FEW} {SCALES} -o {file}".split()) == 130
    text = " ".join(capsys.readouterr().out.split())
    assert "4 records" in text and "interrupted after 4 of 6 records" in text
    rows = [line for line in file.read_text("utf-8").splitlines() if not line.startswith("#")]
    assert len(rows) == 1 + 4 * 3


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ("fragility", "nothing says how the ground moves"),
        (f"{FEW} --scale 0..2", "--scale must be between 1e-6 and 1e6, got 0"),
        (f"{FEW} --scale 1,2 --levels 3", "--levels is for a range"),
        (f"{FEW} --scales 1,2 --points 3", "--levels is for a range"),
        (f"{FEW} --scale 1,2 --intensities 1..2", "give one"),
        (f"{FEW} --intensities 2..1", "--intensities must rise"),
        (f"{FEW} --intensities -1g..1g", "--intensities must be > 0"),
        (f"{FEW} --intensities 0.2g,0.2g", "has a number twice"),
        (f"{FEW} --intensities 0.2kg..1", "--intensities"),
        (f"{FEW} --measure pgd", "unknown measure 'pgd'"),
        (f"{FEW} --measure sa", "--measure sa needs --period"),
        (f"{FEW} --period 1s", "--period is that of the oscillator of --measure sa"),
        (f"{FEW} --horizontal mean", "unknown horizontal 'mean'"),
        (f"{FEW} --limit 0.5,0.5", "--limit has a limit state twice"),
        (f"fragility {COLUMN} {RECORD[0]} --horizontal geomean", "has no PGA, geometric mean"),
        (f"{FEW} --limit 1.5", "--limit must be above 0 and at most 1, or overturning, got 1.5"),
        (f"{FEW} --levels 1", "must be between 2 and"),
        (f"{FEW} --record {RECORD[0]}", "give one"),
        (f"{FEW} -o f.gif", "suffix must be one of"),
        (f"fragility {COLUMN} --soil-period 1s", "--soil-period needs --synthetic"),
        (f"fragility {COLUMN} --units g", "--units needs --record"),
        (f"fragility {COLUMN} {RECORD[0]} {RECORD[0]}", "is given twice"),
        (f"fragility {COLUMN} {RECORD[2]}", "has no PGA"),
        (f"fragility {COLUMN} {RECORD[2]} --measure pgv", "has no PGV"),
        (f"fragility {COLUMN} nosuch.at2", "cannot read nosuch.at2"),
        ("fragility disk --radius 1m --synthetic 2", "give --intensities or --scale"),
    ],
)
def test_errors_are_one_line_that_names_the_option(error_of, arguments, message):
    error = error_of(arguments)
    assert len(error.splitlines()) == 1 and message in error


def test_no_warning_reaches_the_user(stdout_of):
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        stdout_of("fragility coin --synthetic 2 --scale 140,170", UNDECIDED)
