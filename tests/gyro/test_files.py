"""Records from files: every form that is read, what is said of it, and what is refused."""

import io
import zipfile

import numpy as np
import pytest

import rimroll as rr
from rimroll.errors import UnitError

T = np.arange(40) * 0.01
RATES = np.stack([np.sin(9 * T), 0.5 * np.cos(7 * T), 0.1 + T], axis=-1)
PHYPHOX = ["Time (s)", *(f"Gyroscope {axis} (rad/s)" for axis in "xyz"), "Absolute (rad/s)"]


def table(titles, columns, separator=",", decimal=".", quoted=True):
    """The text of a table."""
    rows = zip(*columns, strict=True)
    cells = [[f"{value:.9g}".replace(".", decimal) for value in row] for row in rows]
    head = [f'"{title}"' if quoted else title for title in titles]
    return "\n".join(separator.join(row) for row in [head, *cells]) + "\n"


def columns(factor=1.0, time=1.0):
    return [T * time, *(RATES.T * factor), np.linalg.norm(RATES, axis=1) * factor]


def read(text, **options):
    return rr.gyro.read(io.BytesIO(text.encode()), **options)


@pytest.mark.parametrize(
    ("separator", "decimal"), [(",", "."), (";", "."), ("\t", "."), (";", ","), ("\t", ",")]
)
def test_phyphox_in_each_form_that_it_exports(separator, decimal):
    record = read(table(PHYPHOX, columns(), separator, decimal))
    assert record.t == pytest.approx(T, abs=1e-9)
    assert record.rates == pytest.approx(RATES, abs=1e-8)
    assert not record.simulated
    assert "Gyroscope x (rad/s)" in record.source
    assert "100 Hz" in record.source


def test_phyphox_in_a_zip_with_its_meta_folder(tmp_path):
    file = tmp_path / "Gyroscope.zip"
    with zipfile.ZipFile(file, "w") as archive:
        archive.writestr("Raw Data.csv", table(PHYPHOX, columns()))
        archive.writestr("meta/device.csv", '"property","value"\n"deviceModel","x"\n')
        archive.writestr("meta/time.csv", '"event","experiment time"\n"START",0\n')
    assert rr.gyro.read(file).rates == pytest.approx(RATES, abs=1e-8)


def test_a_zip_with_several_tables_takes_that_of_the_gyroscope_or_asks(tmp_path):
    both, neither = tmp_path / "both.zip", tmp_path / "neither.zip"
    with zipfile.ZipFile(both, "w") as archive:
        archive.writestr("Accelerometer.csv", table(["Time (s)", "x (m/s^2)"], columns()[:2]))
        archive.writestr("Gyroscope.csv", table(PHYPHOX, columns()))
    assert len(rr.gyro.read(both)) == len(T)
    with zipfile.ZipFile(neither, "w") as archive:
        archive.writestr("a.csv", "x")
        archive.writestr("b.csv", "x")
    with pytest.raises(rr.RimrollError, match=r"holds a\.csv, b\.csv"):
        rr.gyro.read(neither)


@pytest.mark.parametrize(
    ("titles", "factor", "time"),
    [
        (["Time (s)", *(f"Angular Velocity {a} (deg/s)" for a in "XYZ")], 180 / np.pi, 1.0),
        (["Data Set 1:Time(s)", *(f"Data Set 1:Gyro {a}(rad/s)" for a in "XYZ")], 1.0, 1.0),
        (["Time [ms]", *(f"{a}-axis angular rate [°/s]" for a in "xyz")], 180 / np.pi, 1e3),
        (["t (s)", "gx (dps)", "gy (dps)", "gz (dps)"], 180 / np.pi, 1.0),
        (["seconds_elapsed", "x (rad/s)", "y (rad/s)", "z (rad/s)"], 1.0, 1.0),
    ],
)
def test_titles_and_units_of_other_programs(titles, factor, time):
    record = read(table(titles, columns(factor, time)[:4], quoted=False))
    assert record.t == pytest.approx(T, abs=1e-8)
    assert record.rates == pytest.approx(RATES, abs=1e-7)


@pytest.mark.parametrize(("unit", "factor"), [("ms", 1e3), ("us", 1e6), ("ns", 1e9)])
def test_times_that_no_gyroscope_has_are_refused_with_their_likely_unit(unit, factor):
    titles = ["Time", *PHYPHOX[1:4]]
    text = table(titles, columns(time=factor)[:4])
    with pytest.raises(rr.RimrollError, match=f"they look like {unit}.*--time-unit {unit}"):
        read(text)
    assert read(text, time_unit=unit).t == pytest.approx(T)
    for title in (f"time_{unit}", f"timestamp [{unit}]", f"t ({unit})"):
        assert read(text.replace("Time", title, 1)).t == pytest.approx(T)
    with pytest.raises(rr.RimrollError, match="is none of a record of a gyroscope"):
        read(text.replace("Time", "Time (s)", 1))


def test_of_several_columns_of_times_the_one_with_a_unit_is_taken():
    elapsed, *axes = columns()[:4]
    stamps = 1_700_000_000_000_000_000 + 1e9 * elapsed
    logger = table(["time", "seconds_elapsed", "z", "y", "x"], [stamps, elapsed, *axes[::-1]])
    found = read(logger, units="rad/s")
    assert found.t == pytest.approx(T) and found.rates == pytest.approx(RATES, abs=1e-8)
    titles = ["accelerometerTimestamp_sinceReboot(s)", "motionTimestamp_sinceReboot(s)"]
    rates = [f"motionRotationRate{axis}(rad/s)" for axis in "XYZ"]
    log = table([*titles, *rates, "motionUserAccelerationX(G)"], [elapsed + 1, *columns()[:4], T])
    dated = "\n".join(
        f"{'loggingTime(txt)' if i == 0 else '2021-01-01 10:00:00.0 +0100'},{line}"
        for i, line in enumerate(log.splitlines())
    )
    for text in (log, dated):
        assert read(text).t == pytest.approx(T) and "motionTimestamp" in read(text).source
    with pytest.raises(rr.RimrollError, match="several columns of times"):
        read(table(["a time (s)", "b time (s)", *PHYPHOX[1:4]], [elapsed, 2 * elapsed, *axes]))


@pytest.mark.parametrize("count", [2, 3, 5])
@pytest.mark.parametrize("cut", [0, 1])
def test_samples_in_packets_get_times_between_them(count, cut):
    stamps = T[count - 1 :: count].repeat(count)
    n = len(stamps) - cut
    found = read(table(PHYPHOX[:4], [stamps[cut:], *RATES[cut : n + cut].T]))
    assert found.t == pytest.approx(T[cut : n + cut], abs=1e-9)
    assert found.rates == pytest.approx(RATES[cut : n + cut], abs=1e-8)
    assert "packets of" in found.notes[0] and "100 Hz" in found.notes[0]


def test_packets_that_do_not_come_evenly_are_refused():
    stamps = np.cumsum([0.02, 0.09, 0.03, 0.12, 0.02, 0.1, 0.03, 0.08]).repeat(5)
    with pytest.raises(rr.RimrollError, match="packets of 5 that share a time"):
        read(table(PHYPHOX[:4], [stamps, *RATES.T]))


def test_a_part_is_read_without_the_times_that_go_back_elsewhere():
    t = np.concatenate([T[:5], T[4:] - 0.02])
    text = table(PHYPHOX[:4], [t, *np.vstack([RATES[:5], RATES[4:]]).T])
    with pytest.raises(rr.RimrollError, match=r"line 7: the time goes back.*--between"):
        read(text)
    assert read(text, between=(0.1, "0.4 s")).t == pytest.approx(T[10:38])


@pytest.mark.parametrize(
    "titles",
    [
        ["Time (s)", "Latitude (°)", "Longitude (°)", "Horizontal Accuracy (m)"],
        ["t (s)", "x", "Accuracy", "Bearing accuracy (°)"],
    ],
)
def test_a_record_of_places_is_not_said_to_hold_accelerations(titles):
    with pytest.raises(rr.RimrollError, match="no columns for the x, y and z of a gyroscope"):
        read(table(titles, columns()[:4]))


@pytest.mark.parametrize(
    ("before", "separator", "decimal", "end"),
    [
        ("sep=;\n", ";", ",", ""),
        ("\ufeffsep=,\n", ",", ".", "\x1a"),
        ("Device;x;y\n\n", ";", ",", "\r\n\x1a"),
    ],
)
@pytest.mark.parametrize("encoding", ["utf-8", "utf-16"])
def test_separators_marks_and_encodings(before, separator, decimal, end, encoding):
    text = before + table(PHYPHOX, columns(), separator, decimal).replace("\n", "\r\n") + end
    record = rr.gyro.read(io.BytesIO(text.encode(encoding)))
    assert record.rates == pytest.approx(RATES, abs=1e-8)


def test_lines_above_the_titles_are_passed_over():
    text = "Device: sensor\nDate: today\n" + table(PHYPHOX, columns())
    assert read(text).rates == pytest.approx(RATES, abs=1e-8)


def test_columns_that_the_user_names_or_counts():
    titles = ["stamp", "a", "b", "c", "d"]
    text = table(titles, columns(180 / np.pi))
    names = {"t": "stamp", "x": "a", "y": "b", "z": "c"}
    for given in (names, {"t": 1, "x": 2, "y": 3, "z": 4}):
        record = read(text, units="deg/s", columns=given)
        assert record.rates == pytest.approx(RATES, abs=1e-7)
    with pytest.raises(rr.RimrollError, match="has no column"):
        read(text, columns={"t": "nothing"})
    with pytest.raises(UnitError, match="name no unit"):
        read(text, columns=names)


def test_units_that_contradict_the_titles_are_refused():
    with pytest.raises(UnitError, match="rad/s, but units is"):
        read(table(PHYPHOX, columns()), units="deg/s")
    titles = [*PHYPHOX[:3], "Gyroscope z (deg/s)"]
    with pytest.raises(UnitError, match="different units"):
        read(table(titles, columns()[:4]))


def test_gaps_repeated_uneven_and_drifting_times_are_told():
    t = np.concatenate([T[:20], T[19:30], T[30:] + 0.3])
    rates = np.concatenate([RATES[:20], RATES[19:30], RATES[30:]])
    record = read(table(PHYPHOX[:4], [t, *rates.T]))
    assert len(record) == len(T)
    assert "repeat the time of the one before were left out: 1" in record.notes[0]
    assert "Gaps in the times: 1, the longest 310 ms at 0.29 s" in record.notes[1]
    drifting = np.cumsum(0.01 * np.linspace(1.0, 1.1, 40))
    notes = read(table(PHYPHOX[:4], [drifting, *RATES.T])).notes
    assert any("drifts by -6" in note for note in notes)


def test_rates_that_are_cut_off_are_told():
    flat = np.clip(10 * RATES, -4.363, 4.363)
    notes = read(table(PHYPHOX[:4], [T, *flat.T])).notes
    assert any("cut off at the sensor's range, 4.36 rad/s (250 degrees/s)" in n for n in notes)


def test_a_file_that_was_cut_in_its_last_line_is_read_without_it():
    text = table(PHYPHOX, columns())
    record = read(text[: text.rstrip().rfind(",") - 12])
    assert len(record) == len(T) - 1
    assert "The last line is not complete" in record.notes[0]


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("", "is empty"),
        (table(["Time (s)", *(f"Acceleration {a} (m/s^2)" for a in "xyz")], columns()[:4]),
         "holds accelerations; the turn needs the gyroscope"),
        (table(PHYPHOX, columns()).replace("0.05,", "oops,", 1), 'line 7: "oops" is no number'),
        (table(PHYPHOX[1:], columns()[1:]), "no column of times"),
        (table([*PHYPHOX[:2], "a", "b"], columns()[:4]), "no columns for the x, y and z"),
        (table(PHYPHOX, [c[:5] for c in columns()]), "at least 20 samples, it has 5"),
        (table(PHYPHOX, [T[::-1], *columns()[1:]]), "the time goes back"),
        ("\n".join(",".join(["1.5"] * 4) for _ in range(30)), "the first line must name"),
        (table([*PHYPHOX[:4], *(t.replace("Gyro", "Run 2: Gyro") for t in PHYPHOX[1:4])],
               [*columns()[:4], *columns()[1:4]]), "several runs"),
    ],
)  # fmt: skip
def test_what_is_no_such_record_is_refused_with_a_sentence(text, message):
    with pytest.raises(rr.RimrollError, match=message):
        read(text)


def test_files_too_large_and_of_excel_are_refused(tmp_path):
    large = tmp_path / "large.csv"
    large.write_bytes(b"1,2,3,4\n" * 3_000_000)
    with pytest.raises(rr.RimrollError, match="larger than 20 MB: a record of some minutes"):
        rr.gyro.read(large)
    sheet = tmp_path / "x.xls"
    sheet.write_bytes(b"\xd0\xcf\x11\xe0" + bytes(100))
    with pytest.raises(rr.RimrollError, match="Excel file: export it as CSV"):
        rr.gyro.read(sheet)
