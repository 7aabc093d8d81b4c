"""Records from files: every form of AT2 that is found, CSV, and streams of ObsPy; bad files."""

import io
import math
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import rimroll as rr
from given.at2 import HEADERS, STYLES, at2
from given.strategies import examples
from rimroll.ground.columns import direction_of

G = rr.STANDARD_GRAVITY
EXAMPLES = Path(__file__).parents[2] / "examples"
SAMPLES = np.array([0.0, 0.12, -0.25, 0.5, -0.0625, 0.03])


@pytest.fixture
def written(tmp_path):
    """Writes a text to a file."""

    def write(content, name="x.at2"):
        file = tmp_path / name
        file.write_bytes(content if isinstance(content, bytes) else content.encode())
        return file

    return write


def stream(content):
    return io.BytesIO(content.encode())


def samples_of(ground):
    return ground.core.samples()[1]


def refusal(*files, **how):
    with pytest.raises(rr.RimrollError) as refused:
        rr.ground.read(*files, **how)
    message = str(refused.value)
    assert "\n" not in message
    return message


# AT2


@given(
    samples=st.lists(st.floats(-9.0, 9.0), min_size=2, max_size=40),
    step=st.sampled_from(["0.005", ".0050", "0.0200", "1.0E-02", ".5000D-02"]),
    header=st.sampled_from(HEADERS),
    style=st.sampled_from(sorted(STYLES)),
    per_line=st.integers(1, 8),
    line_end=st.sampled_from(["\n", "\r\n"]),
)
@examples(400)
def test_every_form_of_at2_is_read_back(samples, step, header, style, per_line, line_end):
    text = at2(samples, step, header, style=style, per_line=per_line).replace("\n", line_end)
    ground = rr.ground.read(stream(text))
    read_step, found = ground.core.samples()
    assert read_step == float(step.replace("D", "E"))
    np.testing.assert_allclose(found[:, 0] / G, samples, rtol=1e-7, atol=1e-6)
    assert not found[:, 1:].any() and ground.heading == 0.0


def test_numbers_that_touch_or_have_no_letter_in_their_exponent_are_read():
    text = [*at2([0.0] * 6).splitlines()[:4], "1.234-5.678 .5D-01", " -.25-102 2.-.125,"]
    found = samples_of(rr.ground.read(stream("\n".join(text))))[:, 0] / G
    np.testing.assert_allclose(found, [1.234, -5.678, 0.05, -0.25e-102, 2.0, -0.125])


def test_a_record_is_cut_at_npts_within_its_last_line():
    padded = at2([*SAMPLES, 0.0, 0.0, 0.0, 0.0], npts=6)
    found = samples_of(rr.ground.read(stream(padded)))[:, 0]
    np.testing.assert_allclose(found, SAMPLES * G, rtol=1e-7)


def test_three_files_are_a_record_with_right_handed_axes():
    files = [EXAMPLES / f"synthetic_{name}.at2" for name in ("000", "090", "up")]
    ground = rr.ground.read(*files)
    assert ground.heading == 0.0 and ground.duration == 20.0
    assert all(file.read_text("utf-8").startswith("SYNTHETIC, NOT AN") for file in files)
    north, east, up = (samples_of(rr.ground.read(file, component="x"))[:, 0] for file in files)
    np.testing.assert_array_equal(samples_of(ground), np.stack([north, -east, up], axis=1))
    # x points east, and y, on its left, to the north.
    to_east = rr.ground.read(files[2], files[1], files[0])
    assert to_east.heading == pytest.approx(math.pi / 2)
    np.testing.assert_allclose(
        samples_of(to_east), samples_of(ground.rotated(math.pi / 2)), atol=1e-9
    )
    down = rr.ground.read(*files, headings=("0 deg", math.pi / 2, "down"))
    np.testing.assert_array_equal(samples_of(down), samples_of(ground) * [1.0, 1.0, -1.0])


def test_a_single_component_is_along_the_axis_that_is_asked_for():
    x, up = EXAMPLES / "synthetic_000.at2", EXAMPLES / "synthetic_up.at2"
    along = {
        "x": rr.ground.read(x),
        "y": rr.ground.read(x, component="y"),
        "z": rr.ground.read(up),
    }
    for axis, ground in along.items():
        moves = [peak > 0.0 for peak in ground.peak[:3]]
        assert moves == [other == axis for other in "xyz"]
    assert along["y"].heading == pytest.approx(math.pi / 2) and along["z"].heading is None
    assert rr.ground.read(up, component="x").peak.x == along["z"].peak.z


@pytest.mark.parametrize(
    ("text", "degrees"),
    [
        ("000", 0), ("47", 47), ("230", 230), ("090 ", 90), ("230 deg", 230), ("360", 0),
        ("N", 0), ("N-S", 0), ("E-W", 90), ("ew", 90), ("S", 180), ("W", 270),
        ("N40E", 40), ("N 40 E", 40), ("S69E", 111), ("S50W", 230), ("N69W", 291), ("N00E", 0),
    ],
)  # fmt: skip
def test_headings_are_read_as_files_write_them(text, degrees):
    assert math.degrees(direction_of(text)) == pytest.approx(degrees)


@pytest.mark.parametrize("text", ["UP", "VER", "vert", "UD", "V", "Z", "DWN", "Down", "DN"])
def test_vertical_directions_are_read_as_files_write_them(text):
    assert direction_of(text) == ("down" if text[0] == "D" or text[0] == "d" else "up")


@pytest.mark.parametrize("text", ["", "H1", "361", "1940", "EL CENTRO", "L", "N95"])
def test_what_is_no_direction_is_none(text):
    assert direction_of(text) is None


@pytest.mark.parametrize(
    ("line", "heading"),
    [
        ("DENALI 11/03/02, PS10, 047", 47),
        ("SAN FERNANDO 02/09/71 14:00, PACOIMA DAM, 164 (CDMG STATION 279)   ", 164),
        ("IMPERIAL VALLEY 10/15/79 2319, EL CENTRO ARRAY 6, 230                  ", 230),
        ("KOBE 01/16/95 2046 KAKOGAWA 090", 90),
        ("Helena_ Montana-01, 10/31/1935, Carroll College, S50W", 230),
        ("Somewhere, 1999, Array 6", None),
    ],
)
def test_the_heading_is_at_the_end_of_line_2(line, heading):
    lines = at2(SAMPLES).splitlines()
    lines[1] = line
    found = rr.ground.read(stream("\n".join(lines))).heading
    assert found == (None if heading is None else pytest.approx(math.radians(heading)))


@pytest.mark.parametrize(
    ("unit", "factor"),
    [("G", G), ("G.", G), ("CM/SEC/SEC", 0.01), ("CM/SEC**2", 0.01), ("M/S2", 1.0), ("GAL", 0.01)],
)
def test_the_unit_is_that_of_line_3(unit, factor):
    found = samples_of(rr.ground.read(stream(at2(SAMPLES, unit=unit))))[:, 0]
    np.testing.assert_allclose(found, SAMPLES * factor, rtol=1e-7)


def test_a_file_without_a_unit_takes_that_which_is_given():
    text = at2(SAMPLES).replace("TIME SERIES IN UNITS OF G", "")
    assert 'names no unit, as in "IN UNITS OF G": give units="g"' in refusal(stream(text))
    assert rr.ground.read(stream(text), units="g") == rr.ground.read(stream(at2(SAMPLES)))
    message = refusal(stream(at2(SAMPLES)), units="m/s2")
    assert message == 'the stream, line 3: the unit is G, but units is "m/s2"'


BAD_AT2 = {
    "cut": (at2(SAMPLES)[:-16], "line 4 says 6 samples, and 5 follow: the file was cut, or NPTS"),
    "NPTS too large": (at2(SAMPLES, npts=60), "line 4 says 60 samples, and 6 follow"),
    "NPTS too small": (
        at2([*SAMPLES] * 2, npts=6),
        "line 6: NPTS in line 4 is 6, and 10 samples have passed",
    ),
    "NPTS of nothing": (at2(SAMPLES, npts=0), "line 4: NPTS must be a whole number >= 2, got 0"),
    "NPTS of a half": (
        at2(SAMPLES, header="NPTS=5.5, DT={dt}"),
        "NPTS must be a whole number >= 2",
    ),
    "DT of nothing": (at2(SAMPLES, step="0.000"), "line 4: DT must be > 0, got 0 s"),
    "no DT": (at2(SAMPLES, header="NPTS= {npts}"), "line 4: it must name NPTS and DT, as in"),
    "no number": (at2(SAMPLES, header="NPTS, DT"), "line 4: it must name NPTS and DT, as in"),
    "only a header": ("\n".join(at2(SAMPLES).splitlines()[:4]), "6 samples, and 0 follow"),
    "half a header": ("\n".join(at2(SAMPLES).splitlines()[:3]), "it must name NPTS and DT"),
    "text": (at2(SAMPLES).replace("-2.5000000E-01", "  spike"), 'line 5: "spike" is no number'),
    "NaN": (at2(SAMPLES).replace("-2.5000000E-01", "  nan"), 'line 5: "nan" is no number'),
    "overflow": (at2(SAMPLES).replace("-2.5000000E-01", " *****"), 'line 5: "*****" is no number'),
    "touching": (
        at2(SAMPLES).replace("0.0000000E+00  1.2000000E-01", "0.0000000.1200000"),
        'line 5: "0.0000000.1200000" is no number',
    ),
    "underscore": (at2(SAMPLES).replace("-2.5000000E-01", " 1_5"), 'line 5: "1_5" is no number'),
    "velocity": (
        at2(SAMPLES, unit="CM/S").replace("ACCELERATION", "VELOCITY"),
        "line 3: it holds velocities; a ground needs accelerations",
    ),
    "unknown unit": (at2(SAMPLES, unit="ZORKS"), "line 3: it must be a unit of acceleration"),
    "unit of a speed": (at2(SAMPLES, unit="CM/S"), 'or "m/s2", got "CM/S"'),
    "empty": ("", "is empty"),
    "blank": ("\n \n", "is empty"),
}


@pytest.mark.parametrize("name", BAD_AT2)
def test_a_bad_at2_file_is_refused_with_file_and_line(name, written):
    text, says = BAD_AT2[name]
    file = written(text)
    message = refusal(file)
    assert message.startswith(str(file)) and says in message


@pytest.mark.parametrize(
    ("contents", "how", "says"),
    [
        ([at2(SAMPLES), at2(SAMPLES, "0.01", direction="090")], {}, "has a step of 0.01 s, but"),
        (
            [at2(SAMPLES), at2(SAMPLES[:-1], direction="090")],
            {},
            "0.at2 by 1 of 6 samples (0.02 s): if all begin at the same time, pad=True",
        ),
        ([at2(SAMPLES[:-2]), at2(SAMPLES, direction="090")], {}, "1.at2 by 2 of 6 samples"),
        ([at2(SAMPLES), at2(SAMPLES, direction="045")], {}, "must be perpendicular"),
        ([at2(SAMPLES), at2(SAMPLES, direction="180")], {}, "points to 0 degrees and"),
        ([at2(SAMPLES), at2(SAMPLES, direction="H2")], {}, "line 2 does not end with a direction"),
        ([at2(SAMPLES, direction="UP")] * 2, {}, "are all vertical"),
        ([at2(SAMPLES), *[at2(SAMPLES, direction="090")] * 2], {}, "are all horizontal"),
        ([at2(SAMPLES)] * 4, {}, "are all horizontal"),
        ([at2(SAMPLES), "t (s),ax (g)\n0,1\n1,2\n"], {}, "is no AT2 file; a CSV file holds all"),
        ([at2(SAMPLES)] * 2, {"headings": ["0 deg"]}, "one for each file, 2, got 1"),
        ([at2(SAMPLES)], {"headings": [230]}, 'for degrees write "230 deg"'),
        (
            [at2(SAMPLES)],
            {"headings": ["sideways"]},
            '[0] must be "up", "down" or a heading',
        ),
        ([at2(SAMPLES)], {"component": "up"}, 'component must be "x", "y" or "z", got'),
        ([at2(SAMPLES), at2(SAMPLES, direction="UP")], {"component": "z"}, "there are 2 files"),
        ([], {}, "files must be one or more, got none"),
        ([b"\x00\x01\x02"], {}, "is no text file"),
    ],
)
def test_files_that_do_not_go_together_are_refused(contents, how, says, written):
    files = [written(content, f"{i}.at2") for i, content in enumerate(contents)]
    message = refusal(*files, **how)
    assert says in message


def test_shorter_components_get_zeros_at_their_end_when_asked(written):
    texts = [at2(SAMPLES[:-2]), at2(SAMPLES, direction="090"), at2(SAMPLES[:-1], direction="UP")]
    files = [written(text, f"{i}.at2") for i, text in enumerate(texts)]
    padded, whole = rr.ground.read(*files, pad=True), rr.ground.read(files[1], component="y")
    samples = padded.core.samples()[1]
    assert samples.shape == (6, 3) and not samples[4:, 0].any() and samples[5, 2] == 0.0
    assert samples[1:4, 0].all() and samples[4, 2] != 0.0
    assert np.abs(samples[:, 1]).tolist() == np.abs(whole.core.samples()[1][:, 1]).tolist()
    refused = refusal(*files)
    assert "0.at2 is shorter than" in refused and "2.at2 is shorter than" in refused
    assert rr.ground.read(*files[1:2], pad=True) == rr.ground.read(files[1])


def test_a_file_that_is_not_there_is_refused(tmp_path):
    assert refusal(tmp_path / "none.at2").startswith("cannot read ")
    assert "none.at2: No such file" in refusal(tmp_path / "none.at2")


def test_a_file_that_is_too_large_is_refused_at_once(written):
    assert refusal(written(b"0.0 " * 5_500_000)).endswith("x.at2 is larger than 20 MB")


OPENSEES = (
    "Data for a test record, north-south\n{npts} points at equal spacing of {dt} sec, 8F10.5\n"
    "The units are (g)\nNPTS=  {npts}, DT= {dt} SEC\n",
    "Data for a test record\n{npts} points at equal spacing of {dt} sec\n"
    "Points are listed in the format of 8F10.5, i.e., 8 points across in\na row\n"
    "The units are (g)\n*** Begin data ***\nNPTS=   {npts}, DT= {dt} SEC\n",
    "Data for a test record\n{npts} points at equal spacing of {dt} sec\n\nThe units are (g)\n"
    "*** Begin data ***\n",
    "\n\nPEER STRONG MOTION DATABASE\n\nTown, 1/1/2001, Station, 000\nUNITS: G\n\n"
    "DT= {dt}\nNPTS= {npts}\n\n",
)
"""Headers of other programs, of any number of lines."""


@pytest.mark.parametrize("header", OPENSEES)
@pytest.mark.parametrize("units", [None, "g"])
@pytest.mark.parametrize("end", ["", "\x1a", "\x1a\r\n"])
def test_headers_of_any_length_and_the_mark_at_the_end_of_dos_are_read(header, units, end):
    rows = at2(SAMPLES).split("\n", 4)[4]
    text = header.format(npts=len(SAMPLES), dt=".0200") + rows + end
    step, found = rr.ground.read(stream(text), units=units).core.samples()
    assert step == 0.02
    np.testing.assert_allclose(found[:, 0], SAMPLES * G, rtol=1e-7)


@given(wrong=st.integers(2, 11).filter(lambda count: count != 7), per_line=st.integers(1, 8))
@examples(60)
def test_no_number_of_samples_but_the_right_one_is_taken(wrong, per_line):
    samples = [*SAMPLES, 0.25]
    message = refusal(stream(at2(samples, npts=wrong, per_line=per_line)))
    assert "line 4" in message and str(wrong) in message


@pytest.mark.parametrize(
    ("codes", "axes"),
    [("L T V", "xyz"), ("T V L", "yzx"), ("H1 H2 UP", "xyz"), ("X Y DOWN", "xyz"), ("LN TR", "xy")],
)
def test_axes_of_an_instrument_are_one_record(codes, axes, tmp_path):
    files = []
    for i, code in enumerate(codes.split()):
        files.append(tmp_path / f"QUAKE_TOWN--{code}.AT2")
        files[-1].write_text(at2((i + 1) * SAMPLES, direction=code))
    (found,) = rr.ground.read_all(*files).values()
    for i, axis in enumerate(axes):
        sign = -1.0 if "DOWN" in codes and axis == "z" else 1.0
        expected = sign * (i + 1) * SAMPLES * G
        np.testing.assert_allclose(samples_of(found)[:, "xyz".index(axis)], expected, rtol=1e-7)
    assert found.heading is None


def test_components_of_unknown_names_are_not_taken_for_records(tmp_path):
    files = [tmp_path / f"{code}.AT2" for code in ("S1", "S2")]
    for file in files:
        file.write_text(at2(SAMPLES, direction=file.stem))
    with pytest.raises(rr.RimrollError, match="line 2 ends with S1 and S2, no directions"):
        rr.ground.read_all(*files)


OTHERS = {
    "K-NET": "Origin Time       2001/01/01 00:00:00\nLat. 35.0\nSampling Freq(Hz) 100Hz\n1 2 3\n",
    "ESM": "EVENT_NAME: X\nEVENT_ID: 1\nSAMPLING_INTERVAL_S: 0.01\nNDATA: 2\n0.1\n0.2\n",
    "COSMOS": "Corrected acceleration   (Format v01.20 with 46 text lines) Src: 1\n0.1 0.2\n",
    "SMC": "2 CORRECTED ACCELEROGRAM\n*\n*\n 0.1 0.2\n",
    "CSMIP": "UNCORRECTED ACCELEROGRAM DATA  PROCESSED\nSTATION\n 0.1 0.2\n",
    "AFAD": "PLACE : TOWN\nSTATION ID : 1\nNUMBER OF DATA : 2\nN-S E-W U-D\n 0.1 0.2 0.3\n",
}


@pytest.mark.parametrize("name", OTHERS)
def test_other_formats_are_named_with_a_way_out(name):
    message = refusal(stream(OTHERS[name]))
    assert f"is in the format of {name}" in message
    assert "as a CSV file with the columns t (s), ax (m/s2)" in message


# CSV

TIMES = np.arange(6) * 0.02


def csv(header, *columns, separator=","):
    rows = [separator.join(f"{value:.10g}" for value in row) for row in zip(*columns, strict=True)]
    return "\n".join((header, *rows, ""))


@pytest.mark.parametrize(
    ("header", "separator"),
    [
        ("t (s),ax (m/s2),ay (m/s2),az (m/s2)", ","),
        ("Time [s];Acc X [m/s^2];Acc Y [m/s^2];Acc Z [m/s^2]", ";"),
        ("time(sec)\tx_acc (m/s/s)\ty_acc (m/s/s)\tz_acc (m/s/s)", "\t"),
        ("t,x (m/s²),y (m/s²),z (m/s²)", ","),
    ],
)
def test_columns_are_known_by_their_names_and_units(header, separator):
    columns = (TIMES, SAMPLES, 2 * SAMPLES, 3 * SAMPLES)
    ground = rr.ground.read(stream(csv(header, *columns, separator=separator)))
    step, found = ground.core.samples()
    assert step == 0.02 and ground.heading is None
    np.testing.assert_allclose(found, SAMPLES[:, np.newaxis] * [1.0, 2.0, 3.0], rtol=1e-9)


def test_units_of_columns_are_converted_and_columns_may_be_in_any_order():
    text = csv("az [g],t (ms),ax (gal)", SAMPLES, 1000 * TIMES + 7.0, SAMPLES)
    step, found = rr.ground.read(stream(text)).core.samples()
    assert step == 0.02
    np.testing.assert_allclose(found, SAMPLES[:, np.newaxis] * [0.01, 0.0, G], rtol=1e-9)


def test_a_single_column_has_any_name_and_spreadsheets_with_commas_are_read():
    for component, axis in ((None, 0), ("z", 2)):
        text = csv("t;shaking", TIMES, SAMPLES, separator=";").replace(".", ",")
        ground = rr.ground.read(stream(text), units="cm/s2", component=component)
        np.testing.assert_allclose(samples_of(ground)[:, axis], 0.01 * SAMPLES)


def test_times_that_are_rounded_are_even():
    times = np.round(np.arange(2000) / 128, 3)
    text = csv("t (s),a (g)", times, np.ones(2000))
    assert rr.ground.read(stream(text)).duration == pytest.approx(1999 / 128, abs=1e-3)


@pytest.mark.parametrize(("unit", "factor"), [("ms", 1e3), ("us", 1e6), ("ns", 1e9)])
def test_times_that_no_record_has_are_refused_with_their_likely_unit(unit, factor):
    text = csv("time,ax (g)", factor * TIMES, SAMPLES)
    message = refusal(stream(text))
    assert f"they look like {unit}" in message and f"--time-unit {unit})" in message
    right = rr.ground.read(stream(csv("t (s),ax (g)", TIMES, SAMPLES)))
    assert rr.ground.read(stream(text), time_unit=unit) == right
    for title in (f"time ({unit})", f"time_{unit}", f"Time [{unit}]"):
        assert rr.ground.read(stream(text.replace("time", title, 1))) == right
    assert "a step of 20 s is none" in refusal(stream(csv("t (s),ax (g)", 1e3 * TIMES, SAMPLES)))
    assert "are in ms, but" in refusal(stream(csv("t (ms),a (g)", TIMES, SAMPLES)), time_unit="s")


def test_what_is_beside_the_acceleration_is_passed_over():
    zeros = np.zeros(6)
    right = rr.ground.read(stream(csv("t (s),ax (g)", TIMES, SAMPLES)))
    for header in (
        "\ufeffTime [s],Acceleration [g],Velocity [m/s],Displacement [m]",
        "Time (s),ax (g),vx (cm/s),ux (cm)",
        "t (s),x_acc (g),velocity,displacement",
    ):
        assert rr.ground.read(stream(csv(header, TIMES, SAMPLES, zeros, zeros))) == right
    phone = csv("Time (s),Acc x (g),Absolute acceleration (g)", TIMES, SAMPLES, np.abs(SAMPLES))
    assert rr.ground.read(stream(phone)) == right


def test_columns_by_number_and_the_step_spare_titles():
    bare = csv("0.0,0.0", TIMES[1:], SAMPLES[1:])
    right = rr.ground.read(stream(csv("t (s),ax (g)", TIMES, SAMPLES)))
    assert "--columns t=1,x=2" in refusal(stream(bare), units="g")
    assert rr.ground.read(stream(bare), units="g", columns={"t": 1, "x": 2}) == right
    single = "Somewhere, 1999\n\n" + csv("0.0", SAMPLES[1:])
    assert rr.ground.read(stream(single), units="g", step="20 ms") == right
    up = rr.ground.read(stream(single), units="g", step=0.02, columns={"z": 1})
    np.testing.assert_allclose(samples_of(up)[:, 2], SAMPLES * G, rtol=1e-7)
    assert "step is for files without times" in refusal(
        stream(csv("t (s),a (g)", TIMES, SAMPLES)), step=0.02
    )
    assert "step is for tables" in refusal(stream(at2(SAMPLES)), step=0.02)


def test_columns_of_the_compass_have_a_heading():
    for names in ("E (g),N (g),Z (g)", "EW (g),NS (g),UD (g)", "Acc. E-W (g),N-S (g),Up (g)"):
        ground = rr.ground.read(stream(csv(f"t (s),{names}", TIMES, SAMPLES, 2 * SAMPLES, SAMPLES)))
        np.testing.assert_allclose(samples_of(ground)[:, 1], 2 * SAMPLES * G, rtol=1e-9)
        assert ground.heading == pytest.approx(math.pi / 2)


def test_accelerations_that_no_record_reaches_are_refused():
    assert "check the unit" in refusal(stream(csv("t (s),a (g)", TIMES, 300 * SAMPLES)))


LATE = np.array([0.0, 0.02, 0.04, 0.06, 0.1, 0.12])
BAD_CSV = {
    "uneven": (
        csv("t (s),a (g)", LATE, SAMPLES),
        "line 6: the time is 0.04 s after the one before",
    ),
    "backwards": (
        csv("t (s),a (g)", -TIMES, SAMPLES),
        "line 3: the time is not after",
    ),
    "no unit": (
        csv("t (s),ax", TIMES, SAMPLES),
        "line 1: the column ax has no unit: write ax (m/s2)",
    ),
    "unknown unit": (
        csv("t (s),ax (zorks)", TIMES, SAMPLES),
        'or "m/s2", got "zorks"',
    ),
    "unit of a speed": (csv("t (s),vx (m/s)", TIMES, SAMPLES), 'or "m/s2", got "m/s"'),
    "no time": (
        csv("ax (g),ay (g)", TIMES, SAMPLES),
        "has no column of times, such as t (s); it has ax",
    ),
    "no names": (csv("0,0", TIMES, SAMPLES), "the first line must name the columns"),
    "names unknown": (csv("t (s),H1 (g),H2 (g)", TIMES, SAMPLES, SAMPLES), "needs columns ax, ay"),
    "twice": (csv("t (s),ax (g),x (g)", TIMES, SAMPLES, SAMPLES), "needs columns ax, ay"),
    "text": (csv("t (s),a (g)", TIMES, SAMPLES).replace("-0.25", "x"), 'line 4: "x" is no number'),
    "gap": (csv("t (s),a (g)", TIMES, SAMPLES).replace("-0.25", ""), 'line 4: "" is no number'),
    "NaN": (
        csv("t (s),a (g)", TIMES, SAMPLES).replace("-0.25", "nan"),
        'line 4: "nan" is no number',
    ),
    "cut": (csv("t (s),a (g)", TIMES, SAMPLES)[:-6], "line 7: 1 columns where line 1 has 2"),
    "one sample": (csv("t (s),a (g)", [0.0], [1.0]), "must have at least 2 samples, it has 1"),
    "comments": ("# nothing\n", "holds nothing but comments"),
}


@pytest.mark.parametrize("name", BAD_CSV)
def test_a_bad_table_is_refused_with_file_and_line(name, written):
    text, says = BAD_CSV[name]
    file = written(text, "x.csv")
    message = refusal(file)
    assert message.startswith(str(file)) and says in message


def test_options_that_a_table_does_not_take_are_refused():
    text = csv("t (s),ax (g),ay (g)", TIMES, SAMPLES, SAMPLES)
    assert "component is for a single one" in refusal(stream(text), component="x")
    assert "headings are for AT2 files" in refusal(stream(text), headings=["0 deg"])
    assert 'is g, but units is "gal"' in refusal(stream(text), units="gal")


# ObsPy


@dataclass
class Stats:
    channel: str
    delta: float = 0.01
    starttime: float = 0.0


@dataclass
class Trace:
    stats: Stats
    data: np.ndarray = field(default_factory=lambda: np.arange(5.0))


def test_a_stream_of_obspy_is_a_record():
    traces = [
        Trace(Stats("HNZ"), np.arange(5)),
        Trace(Stats("HNN"), 2.0 * np.arange(5)),
        Trace(Stats("HNE"), np.float32(3.0) * np.arange(5)),
    ]
    ground = rr.ground.from_obspy(traces, "gal")
    np.testing.assert_allclose(samples_of(ground), 0.01 * np.outer(np.arange(5), [3.0, 2.0, 1.0]))
    assert ground.heading == pytest.approx(math.pi / 2) and ground.duration == 0.04
    assert rr.ground.from_obspy(traces[:1], "m/s2").peak.z == pytest.approx(4.0)


def counts(channel, calib=3920e-2 / 6182761, processing=()):
    """A trace of counts, with the factor of K-NET."""
    stats = Stats(channel)
    stats.calib, stats.processing = calib, list(processing)
    return Trace(stats, np.round(np.array([0.0, 0.5, -0.98, 0.1]) / calib))


def test_counts_of_k_net_are_calibrated_and_its_channels_are_known():
    for depth in ("", "1", "2"):
        traces = [counts(f"{name}{depth}") for name in ("NS", "UD", "EW")]
        ground = rr.ground.from_obspy(traces, "m/s2")
        assert ground.heading == pytest.approx(math.pi / 2)
        assert ground.peak[:3] == pytest.approx((0.98, 0.98, 0.98), rel=1e-5)
    with pytest.raises(rr.RimrollError, match="one station and one depth"):
        rr.ground.from_obspy([counts("NS1"), counts("NS2")], "m/s2")


def test_a_calibration_is_neither_forgotten_nor_applied_twice():
    done = counts("NS")
    done.data = done.data * done.stats.calib  # as by obspy.read(..., apply_calib=True)
    with pytest.raises(rr.RimrollError, match=r"set trace\.stats\.calib = 1"):
        rr.ground.from_obspy([done], "m/s2")
    done.stats.processing = ["ObsPy 1.4: remove_response(output='ACC')"]
    assert rr.ground.from_obspy([done], "m/s2").peak.y == pytest.approx(0.98, rel=1e-5)
    with pytest.raises(rr.RimrollError, match="samples are counts"):
        rr.ground.from_obspy([Trace(Stats("HNE"), np.array([0.0, 1e5, 2e4]))], "m/s2")


@pytest.mark.parametrize(
    ("traces", "units", "says"),
    [
        ([], "g", "stream must have one to three traces, got none"),
        (3, "g", "stream must be a stream of ObsPy, got 3"),
        ([np.zeros(3)], "g", "stream must be a stream of ObsPy"),
        ([Trace(Stats("HNE"))], "m", 'or "m/s2", got "m"'),
        ([Trace(Stats("HNE"))], "counts", "units must be a unit of acceleration"),
        ([Trace(Stats("HN1"))], "g", "rotate the stream first"),
        ([Trace(Stats("HNE")), Trace(Stats("BNE"))], "g", "more than one trace along x"),
        ([Trace(Stats("HNE")), Trace(Stats("HNN", 0.02))], "g", "HNN has a step of 0.02, but HNE"),
        ([Trace(Stats("HNE")), Trace(Stats("HNN"), np.ones(4))], "g", "HNN has a length of 4"),
        ([Trace(Stats("HNE")), Trace(Stats("HNN", starttime=0.1))], "g", "HNN begins at 0.1"),
        ([Trace(Stats("HNE"), np.ma.masked_less(np.arange(5.0), 2))], "g", "no masked elements"),
        ([Trace(Stats("HNE"), np.array([1.0, np.nan]))], "g", "acceleration[1] must be between"),
    ],
)
def test_what_is_no_record_of_a_stream_is_refused(traces, units, says):
    with pytest.raises(rr.RimrollError) as refused:
        rr.ground.from_obspy(traces, units)
    assert says in str(refused.value)
