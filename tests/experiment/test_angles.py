"""Angles from files as people write them; ambiguous files are refused."""

import io
import os
import re

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

import rimroll as rr
from given.strategies import examples
from rimroll.cli.falls import NUMBERS
from rimroll.cli.formats import write
from rimroll.experiment.directions import read_falls
from rimroll.many.falls import Falls

FALLS = np.array([213.5, 147.25, 210.0, 142.0])
"""Directions of fall of the paper's can, degrees."""

LEANS = np.array([10.0, 350.0, 5.5, 0.0])


@pytest.fixture
def written(tmp_path):
    """Writes a text, or bytes, to a file."""

    def write(content, name="falls.csv"):
        file = tmp_path / name
        data = content if isinstance(content, bytes) else content.encode()
        file.write_bytes(data)
        return file

    return write


def degrees(file, **how):
    return np.degrees(rr.read_directions(file, **how))


def same_directions(found, wanted):
    """Whether angles (degrees) are equal up to whole turns and rounding."""
    off = np.mod(np.asarray(found) - np.asarray(wanted) + 180.0, 360.0) - 180.0
    return len(found) == len(wanted) and np.all(np.abs(off) < 1e-9)


COLUMN = "\n".join(map(str, FALLS)) + "\n"


@pytest.mark.parametrize(
    "content",
    [
        COLUMN,
        COLUMN.rstrip(),
        COLUMN.replace("\n", "\r\n"),
        "\ufeff" + COLUMN,
        "# measured on a Sunday; table of oak, 2 m\n\n" + COLUMN.replace("\n", "\n\n  \n"),
        "direction\n" + COLUMN,
        '"direction"\n' + COLUMN,
        "direction of fall (degrees)\n" + COLUMN,
        "\ufeffDirection[deg]\n# a comment\n" + COLUMN,
        "213.5 deg\n147.25°\n210 °\n142deg\n",
        "213.5 deg\n147.25\n+210\n142e0\n",
        "-146.5\n-212.75\n−150 deg\n502\n",
        "n;direction;hand\n" + "".join(f"{i};{fall};left\n" for i, fall in enumerate(FALLS)),
        "n\tdirection[deg]\n" + "".join(f"{i}\t{fall}\n" for i, fall in enumerate(FALLS)),
        "trial,direction of fall\n" + "".join(f"{i},{fall}\n" for i, fall in enumerate(FALLS)),
    ],
)
def test_a_column_of_degrees_is_read_however_it_is_laid_out(written, content):
    assert same_directions(degrees(written(content)), FALLS)


@pytest.mark.parametrize(
    ("content", "blank"),
    [
        ("\n\n" + COLUMN + "\n \n", None),  # before the first row and after the last
        ("# oak\ndirection\n\n" + COLUMN, None),
        (COLUMN.replace("147.25\n", "147.25\n\n"), "line 3 is blank"),
        ("direction\n\n213.5\n  \n# mine\n\n147.25\n", "lines 4, 6 are blank"),
        ("n;direction\n1;213.5\n;;\n2;147.25\n", "line 3 is blank"),
        ("213.5\n\n" * 30, "lines 2, 4, 6, 8, 10, 12, 14, 16, 18, 20 and 19 more are blank"),
    ],
)
def test_blank_lines_among_the_angles_are_reported_since_a_fall_may_be_missing(
    written, content, blank
):
    none = dict.fromkeys(("outcome", "column", "lean_column"))
    read = read_falls(written(content), radians=False, clockwise=False, **none)
    count = content.count("213.5") + content.count("147.25") + content.count("210.0")
    count += content.count("142.0")
    assert len(read.directions) == count
    assert read.source.endswith(f"{count} rows" if blank is None else f"{count} rows; {blank}")


@pytest.mark.parametrize("separator", [",", ", ", ";", "; ", "\t", " ", "   "])
@pytest.mark.parametrize("names", [None, ("lean", "fall")])
def test_of_two_columns_the_first_is_where_it_leaned_at_first(written, separator, names):
    lines = [f"{lean}{separator}{lean + fall}" for lean, fall in zip(LEANS, FALLS, strict=True)]
    head = [separator.join(names)] if names else []
    assert same_directions(degrees(written("\n".join(head + lines))), FALLS)


def test_two_columns_named_directions_are_the_lean_and_the_fall(written):
    file = written("direction of first lean,direction of fall\n10,223.5\n350,137.25\n")
    assert same_directions(degrees(file), FALLS[:2])


def test_the_column_named_direction_is_taken_whatever_else_is_there(written):
    file = written("direction[deg],direction[rad]\n213.5,0\n147.25,0\n")
    assert same_directions(degrees(file), FALLS[:2])


@pytest.mark.parametrize(
    "name", ["direction[rad]", "direction (rad)", "direction_rad", "Direction in radians"]
)
def test_a_name_may_say_that_its_column_is_in_radians(written, name):
    column = "\n".join(map(repr, np.radians(FALLS).tolist()))
    assert same_directions(degrees(written(f"{name}\n{column}\n")), FALLS)


def test_plain_numbers_are_in_radians_where_the_caller_says_so_and_named_units_stay(written):
    column = "\n".join(map(repr, np.radians(FALLS).tolist()))
    assert same_directions(degrees(written(column), radians=True), FALLS)
    named = degrees(written(f"direction[deg]\n{COLUMN}"), radians=True)
    assert same_directions(named, FALLS)
    assert same_directions(degrees(written("213.5deg\n147.25deg\n"), radians=True), FALLS[:2])


def test_clockwise_angles_are_turned_round(written):
    assert same_directions(degrees(written(COLUMN), clockwise=True), -FALLS)
    pairs = "\n".join(f"{lean},{lean + fall}" for lean, fall in zip(LEANS, FALLS, strict=True))
    assert same_directions(degrees(written(pairs), clockwise=True), -FALLS)


def test_what_topple_wrote_is_read_back_without_the_falls_that_do_not_count(tmp_path):
    can = rr.bodies.can_2007()
    # Some of these gentle flicks do not topple.
    release = rr.Release((0.35, 0.03), (-4.0, 0.4), (0.0, 0.5), (0.0, 0.5))
    file, falls = tmp_path / "falls.csv", rr.topple(can, rr.Coulomb(0.2), 60, release, seed=7)
    toppled = falls["outcome"].values == "toppled"
    assert 30 < toppled.sum() < 60
    write(file, Falls.of(falls), NUMBERS)
    assert rr.read_directions(file) == pytest.approx(falls["direction"].values[toppled], abs=1e-12)


angle = st.floats(-720.0, 720.0)


@examples(60)
@given(st.lists(angle, min_size=1, max_size=40), st.sampled_from([",", ";", "\t", " "]), st.data())
def test_any_list_of_angles_reads_back(tmp_path_factory, falls, separator, data):
    assume(len(falls) <= 3 or max(map(abs, falls)) > 6.3)
    file = tmp_path_factory.mktemp("any") / "falls.txt"
    file.write_text("".join(f"{fall!r}\n" for fall in falls))
    found = rr.read_directions(file)
    assert np.all((found >= 0.0) & (found <= 2.0 * np.pi))
    assert same_directions(np.degrees(found), falls)
    leans = data.draw(st.lists(angle, min_size=len(falls), max_size=len(falls)))
    pairs = list(zip(leans, falls, strict=True))
    assume(len(falls) <= 3 or np.ptp(leans) > len(falls))
    file.write_text("".join(f"{lean!r}{separator}{fall!r}\n" for lean, fall in pairs))
    assert same_directions(degrees(file), np.array(falls) - leans)


@pytest.mark.parametrize(
    ("content", "message"),
    [
        ("", "falls.csv is empty"),
        (" \n\n\t\n", "falls.csv is empty"),
        ("# only\n# comments\n", "falls.csv holds nothing but comments"),
        ("direction[deg]\n", "falls.csv holds no angles"),
        ("direction,outcome\nnan,fell_back\nnan,hovered\n", "falls.csv holds no angles"),
        ("213\nabout 140\n", r'line 2: an angle must read as 213 or 213 deg, got "about 140"'),
        ("213\n\n# x\n14O\n", r'line 4: an angle must .*got "14O"'),
        ("213 kg\n", r'line 1: an angle must .*"kg" does not measure an angle'),
        (
            "Direction,hand\n213,left\n,left\n210,left\n,right\n",
            'lines 3, 5: an angle is missing in column 1 "Direction"; to leave a line out,'
            " begin it with #",
        ),
        ("NA,223\n", r'line 1: an angle must .*got "NA"'),
        (
            "10,223\n350,\n",
            "line 2: an angle is missing in column 2; to leave a line out, begin it with #",
        ),
        ("nan\n213\n", r"line 1: an angle must be a number between .*got nan"),
        ("213\ninf\n", r"line 2: an angle must be a number between .*got inf"),
        ("213\n-inf\n", r"line 2: an angle must be a number between .*got -inf"),
        ("1000\n", r"line 1: an angle must be .* -720 and 720 degrees, got 1000 \(deg\)"),
        ("1000 deg\n", r"line 1: an angle must be .* -720 and 720 degrees, got 1000 deg"),
        ("10,223\n11\n", "line 2: 1 columns where line 1 has 2"),
        ("10 223\n11\n", "line 2: 1 columns where line 1 has 2"),
        ("213\n10 223\n", "line 2: 2 columns where line 1 has 1"),
        ("1,2,3\n", "needs one column .*it has 3 columns without names"),
        ("hand;table;fall\n1;2;3\n", "needs one column .*it has hand, table, fall"),
        ("213\n1\x0047\n", "is no text file"),
        (b"\x89PNG\r\n\x1a\n\xff\xfe", "is no text file"),
        (COLUMN.encode("utf-16-le"), "is no text file"),  # without a byte order mark
        ('10,"' + 200_000 * "x", "does not read as a table"),
    ],
    ids=lambda value: repr(value[:20]),
)
def test_what_is_no_table_of_angles_is_refused_by_file_and_line(written, content, message):
    with pytest.raises(rr.RimrollError, match=message) as refused:
        rr.read_directions(written(content))
    assert "falls.csv" in str(refused.value)
    assert len(str(refused.value)) < 400 + len(str(written("")))


def test_a_line_without_an_angle_is_left_out_where_it_begins_with_a_hash(written):
    assert same_directions(degrees(written("lean;fall\n10;223\n#350;\n20;160\n")), [213, 140])


def test_a_column_is_found_by_its_name_with_or_without_its_unit(written):
    file = written("Nr;Richtung [°];Kipprichtung (rad)\n1;213;3\n2;147;4\n")
    for name in ("Richtung [°]", "Richtung", "richtung", " RICHTUNG ", 2):
        assert same_directions(degrees(file, column=name), [213, 147])
    assert same_directions(degrees(file, column="Kipprichtung"), np.degrees([3, 4]))
    both = written("fall [deg];fall [rad]\n213;3\n147;4\n")
    assert same_directions(degrees(both, column="fall [rad]"), np.degrees([3, 4]))
    with pytest.raises(rr.RimrollError, match=r"or of fall \[deg\], fall \[rad\] in .*got 'fall'"):
        rr.read_directions(both, column="fall")


def test_columns_are_named_as_in_the_file(written):
    with pytest.raises(rr.RimrollError, match="it has Nr, Hand, Tisch"):
        rr.read_directions(written("Nr;Hand;Tisch\n1;2;3\n"))


def test_a_file_that_cannot_be_read_is_refused(tmp_path, written):
    with pytest.raises(rr.RimrollError, match=r"cannot read .*no\.csv: No such file"):
        rr.read_directions(tmp_path / "no.csv")
    with pytest.raises(rr.RimrollError, match=r"cannot read .*: Is a directory"):
        rr.read_directions(tmp_path)
    with pytest.raises(rr.RimrollError, match="cannot read"):
        rr.read_directions("falls\0.csv")
    with pytest.raises(rr.RimrollError, match=r"falls\.csv is larger than 20 MB"):
        rr.read_directions(written(b"213\n" * 5_000_001))


@pytest.mark.skipif(not os.path.exists("/dev/zero"), reason="needs a file without an end")
def test_a_file_without_an_end_is_refused():
    with pytest.raises(rr.RimrollError, match="/dev/zero is larger than 20 MB"):
        rr.read_directions("/dev/zero")


@pytest.mark.parametrize("separator", ["\n", ";0\n"])
def test_radians_without_a_unit_are_refused(written, separator):
    column = separator.join(map(repr, np.radians(FALLS).tolist())) + separator
    with pytest.raises(rr.RimrollError, match=r"no angle is above 3\.73 degrees.*look like rad"):
        rr.read_directions(written(column))
    # An explicit unit counts.
    assert same_directions(degrees(written("direction[deg]\n1\n2\n3\n4\n5\n")), [1, 2, 3, 4, 5])


@pytest.mark.parametrize(
    "content",
    [
        "213,5\n147,2\n210,0\n",
        "213,5\n",
        "+213,5\n-147,2\n",
        "213,5 deg\n147,2 deg\n",
    ],
)
def test_a_few_commas_that_may_be_decimal_or_separate_columns_are_refused(written, content):
    with pytest.raises(rr.RimrollError, match="may be one number or two; write decimals with a po"):
        rr.read_directions(written(content))


@pytest.mark.parametrize(
    "content",
    [
        "direction\n213,5\n147,25\n",
        "direction\n213,500\n147,250\n",
        '"213,5"\n"147,25"\n',
        "213,5;\n147,25;\n",
        "213,50\n147,25\n210,07\n",  # no whole number is written 07
        "213,500\n147,250\n210,070\n",
        "213,5\n147,25\n210\n",  # one cell in a line shows that there is one column
        "210\n213,5\n",
        '"Nr","Winkel"\n1,"213,5"\n2,"147,25"\n',
        "213,5\n147,25\n210,0\n142,0\n" * 2,  # leans so far apart lead to falls above 100
        "213,5 deg\n147,25 deg\n210,0 deg\n142,0 deg\n" * 2,
    ],
)
def test_commas_that_cannot_separate_columns_are_decimal(written, content):
    expected = [float(number.replace(",", ".")) for number in re.findall(r"\d{3},?\d*", content)]
    assert same_directions(degrees(written(content)), expected)


@pytest.mark.parametrize(
    ("first", "second"),
    [
        (np.resize([230, 228, 233], 30), np.resize([83, 17], 30)),  # leans close together
        (np.arange(1, 31), np.resize([20, 27], 30)),
        (np.arange(1, 91), np.resize([20, 27], 90)),
    ],
    ids=["leans", "count", "long count"],
)
def test_columns_of_small_whole_numbers_are_not_taken_for_decimals(written, first, second):
    file = written("".join(f"{a},{b}\n" for a, b in zip(first, second, strict=True)))
    with pytest.raises(rr.RimrollError, match="may be one number or two"):
        rr.read_directions(file)
    assert same_directions(degrees(file, column=2), second)
    assert same_directions(degrees(file, column=2, lean_column=1), second - first)


@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig", "utf-16", "cp1252"])
def test_the_encodings_of_spreadsheets_are_read(written, encoding):
    content = "Nr;Winkel (°);Größe\r\n1;213,5;gut\r\n2;147,25;\r\n;;\r\n"
    assert same_directions(degrees(written(content.encode(encoding))), [213.5, 147.25])


@pytest.mark.parametrize(
    "content", ['"213.5"\n"147.25"\n', "213.5;;\n147.25;;\n;;\n", "213.5\n;\n147.25"]
)
def test_quotes_and_empty_cells_at_the_end_do_not_matter(written, content):
    assert same_directions(degrees(written(content)), [213.5, 147.25])


@pytest.mark.parametrize(
    "content", ["0;213,5\n10;157,25\n", "Nr;Winkel (deg);Bemerkung\n1;213,5;gut\n2;147,25;\n"]
)
def test_between_semicolons_commas_are_decimal(written, content):
    assert same_directions(degrees(written(content)), [213.5, 147.25])


@pytest.mark.parametrize("content", ["10,223\n350,137\n", "213,0\n147,10.5\n", "lean,fall\n9,8\n"])
def test_whole_degrees_in_columns_are_still_columns(written, content):
    lean, fall = np.loadtxt(
        content.replace("lean,fall\n", "").splitlines(), delimiter=",", ndmin=2
    ).T
    assert same_directions(degrees(written(content)), fall - lean)


@pytest.mark.parametrize("first", [0, 1])
def test_a_column_that_counts_the_falls_is_not_taken_for_a_lean(written, first):
    rows = "".join(f"{i},{fall}\n" for i, fall in enumerate(FALLS, first))
    with pytest.raises(rr.RimrollError, match="its first column counts the falls"):
        rr.read_directions(written(rows))


@pytest.mark.parametrize("names", ["no,read", '"","x"', "left,right", "group,number"])
def test_two_columns_of_other_names_are_refused_until_they_are_chosen(written, names):
    rows = "".join(f"{i},{fall}\n" for i, fall in enumerate(FALLS, 190))
    file = written(f"{names}\n{rows}")
    with pytest.raises(rr.RimrollError, match=r"it has .*\. Say which to read by its name or num"):
        rr.read_directions(file)
    assert same_directions(degrees(file, column=2), FALLS)
    assert same_directions(degrees(file, column=2, lean_column=1), FALLS - np.arange(190, 194))


def test_a_column_of_groups_is_not_taken_for_a_lean(written):
    rows = "".join(f"{1 + i % 2},{fall}\n" for i, fall in enumerate(FALLS))
    with pytest.raises(rr.RimrollError, match="small whole numbers that repeat"):
        rr.read_directions(written(rows))
    assert same_directions(degrees(written(rows), column=2), FALLS)
    # A hand that always leans the can to where the protractor says 0.
    zeros = "".join(f"0,{fall}\n" for fall in FALLS)
    assert same_directions(degrees(written(zeros)), FALLS)


@pytest.mark.parametrize("order", ["lean,fall", "fall,lean"])
def test_named_columns_are_found_in_any_order_and_among_others(written, order):
    first, second = order.split(",")
    columns = {"lean": LEANS, "fall": LEANS + FALLS}
    rows = [
        f"{i},{a},{b},x"
        for i, (a, b) in enumerate(zip(columns[first], columns[second], strict=True))
    ]
    file = written("\n".join([f"n,{order},remark", *rows]))
    assert same_directions(degrees(file), FALLS)
    assert same_directions(degrees(file, column="fall", lean_column="lean"), FALLS)


def test_a_lean_beside_a_direction_is_taken_from_it(written):
    rows = "".join(f"{lean},{lean + fall}\n" for lean, fall in zip(LEANS, FALLS, strict=True))
    assert same_directions(degrees(written("lean,direction\n" + rows)), FALLS)


@pytest.mark.parametrize(
    ("how", "message"),
    [
        ({"column": "angel"}, "column must be a number from 1 to 2, or of n, angle in .*'angel'"),
        ({"column": 3}, "column must be a number from 1 to 2"),
        ({"column": 0}, "column must be a number from 1 to 2"),
        ({"column": 2, "lean_column": "first"}, "lean_column must be a number from 1 to 2"),
        ({"lean_column": 1}, "column must be given with lean_column"),
        ({"column": 2, "lean_column": "angle"}, "column and lean_column must differ"),
    ],
)
def test_a_column_that_is_not_there_is_refused(written, how, message):
    with pytest.raises(rr.RimrollError, match=message):
        rr.read_directions(written("n,angle\n1,213\n2,147\n"), **how)


def test_a_stream_is_read_like_a_file():
    assert same_directions(degrees(io.BytesIO(COLUMN.encode())), FALLS)


@pytest.mark.parametrize(
    ("content", "source"),
    [
        (COLUMN, "the only column; degrees, anticlockwise; 4 rows"),
        ("direction[rad]\n3\n", 'column 1 "direction[rad]"; radians, anticlockwise; 1 rows'),
        (
            "n,lean,fall\n1,10,223\n",
            'column 3 "fall" less column 2 "lean", the first lean; degrees, anticlockwise; 1 rows',
        ),
        (
            "outcome,direction\nrocked,213\nhovered,nan\n",
            'column 2 "direction"; degrees, anticlockwise; 1 rows with the outcome rocked',
        ),
    ],
)
def test_the_source_names_what_was_read(written, content, source):
    none = dict.fromkeys(("outcome", "column", "lean_column"))
    read = read_falls(written(content), radians=False, clockwise=False, **none)
    assert read.source == source


# Substitutes for data of which only means and spreads were published


@examples(30)
@given(
    st.tuples(st.floats(3.3, 4.5), st.floats(0.0, 0.2), st.integers(2, 60)),
    st.tuples(st.floats(3.3, 4.5), st.floats(0.0, 0.2), st.integers(2, 60)),
)
def test_stand_ins_have_the_means_and_spreads_of_the_summary(left, right):
    directions = rr.directions_from_summary(left=left, right=right)
    assert len(directions) == left[2] + right[2]
    turns = directions[: left[2]], 2.0 * np.pi - directions[left[2] :]
    for turn, (mean, spread, _) in zip(turns, (left, right), strict=True):
        off = np.mod(turn - mean + np.pi, 2.0 * np.pi) - np.pi
        assert off.mean() == pytest.approx(0.0, abs=1e-12)
        assert off.std(ddof=1) == pytest.approx(spread, rel=1e-9, abs=1e-12)


@pytest.mark.parametrize(
    ("left", "message"),
    [
        ((3.7, 0.07, 1), "left needs at least 2 falls, got 1"),
        ((3.7, 0.07, 2.5), "left count must be a whole number"),
        ((3.7, -0.07, 21), r"left must be a mean and a spread >= 0, got \(3.7, -0.07\)"),
        ((np.nan, 0.07, 21), r"left must be a mean and a spread >= 0, got \(nan, 0.07\)"),
        ((3.7, np.inf, 21), r"left must be a mean and a spread >= 0, got \(3.7, inf\)"),
        (("3.7 m", 0.07, 21), "left mean must be an angle"),
        ((3.7, 0.07), "left must be a mean, a spread and a count"),
        (3.7, "left must be a mean, a spread and a count, got 3.7"),
    ],
)
def test_a_summary_needs_a_mean_a_spread_and_a_count(left, message):
    with pytest.raises(rr.RimrollError, match=message):
        rr.directions_from_summary(left=left, right=(3.8, 0.08, 21))
