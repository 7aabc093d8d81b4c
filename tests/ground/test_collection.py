"""Several records from the files of a folder."""

import numpy as np
import pytest

import rimroll as rr
from given.at2 import at2
from rimroll.ground.at2 import station_of


def written(folder, name, direction, line_2="Quake-01, 1/1/2001, Station A, {}", count=200):
    samples = 0.1 * np.random.default_rng(len(name)).standard_normal(count)
    text = at2(samples, direction=direction)
    old = f"Somewhere-01, 1/1/2001, A Station, {direction}"
    path = folder / name
    path.write_text(text.replace(old, line_2.format(direction)), "utf-8")
    return path


@pytest.mark.parametrize(
    ("line", "station"),
    [
        ("Imperial Valley-02, 5/19/1940, El Centro Array #9, 180", "El Centro Array #9"),
        ("IMPERIAL VALLEY 10/15/79 2316, EL CENTRO ARRAY #6, UP", "EL CENTRO ARRAY #6"),
        ("Gazli- USSR, 5/17/1976, Karakyr, UP (CDMG STATION 12)", "Karakyr"),
        ("Somewhere, 1/1/2001, A Station, N40E", "A Station"),
        ("Somewhere, 1/1/2001, Station 090", "Station"),
        ("Somewhere, 1/1/2001, A Station", "A Station"),
        ("", ""),
    ],
)
def test_the_station_is_what_comes_before_the_direction(line, station):
    assert station_of(f"PEER\n{line}\nACCELERATION").endswith(station)


def test_files_of_one_station_are_a_record_named_by_what_they_begin_with(tmp_path):
    a = [written(tmp_path, f"RSN1_QUAKE_A{name}.AT2", name) for name in ("000", "090", "UP")]
    line_2 = "Quake-01, 1/1/2001, Station B, {}"
    b = [written(tmp_path, f"RSN2_QUAKE_B-{name}.AT2", name, line_2) for name in ("-UP", "140")]
    found = rr.ground.read_all(a[0], b[0], a[1], b[1], a[2])
    assert list(found) == ["RSN1_QUAKE_A", "RSN2_QUAKE_B"]
    assert found["RSN1_QUAKE_A"] == rr.ground.read(*a)


def test_the_name_of_a_record_keeps_the_number_of_its_station(tmp_path):
    files = [written(tmp_path, f"RSN3_LOMAP_G03{name}.AT2", name) for name in ("000", "090")]
    up = written(tmp_path, "RSN3_LOMAP_G03-UP.AT2", "UP")
    assert list(rr.ground.read_all(*files, up)) == ["RSN3_LOMAP_G03"]


def test_a_list_is_one_record_and_a_csv_file_is_one(tmp_path):
    x = written(tmp_path, "x.AT2", "000")
    y = written(tmp_path, "other.AT2", "090", "Quake-01, 1/1/2001, Station B, {}")
    table = tmp_path / "table.csv"
    table.write_text("t (s),ax (g)\n0,0\n0.1,0.2\n0.2,0\n", "utf-8")
    found = rr.ground.read_all(table, [x, y])
    assert list(found) == ["table", "x"]
    assert found["x"] == rr.ground.read(x, y)


def test_records_with_the_same_beginning_keep_the_names_of_their_first_files(tmp_path):
    one = [written(tmp_path, f"q{name}.AT2", name) for name in ("000", "090")]
    line_2 = "Quake-01, 1/1/2001, Station B, {}"
    other = [written(tmp_path, f"q{name}.AT2", name, line_2) for name in ("200", "290")]
    assert list(rr.ground.read_all(*one, *other)) == ["q000", "q200"]
    (tmp_path / "b").mkdir()
    same = written(tmp_path / "b", "q000.AT2", "000", line_2)
    assert list(rr.ground.read_all(one[0], same)) == [str(one[0]), str(same)]


def test_errors_name_the_files(tmp_path):
    x = written(tmp_path, "x.AT2", "000")
    with pytest.raises(rr.RimrollError, match=r"x\.AT2 is given twice"):
        rr.ground.read_all(x, [x])
    with pytest.raises(rr.RimrollError, match="one or more, got none"):
        rr.ground.read_all()
    again = written(tmp_path, "again.AT2", "000")
    with pytest.raises(rr.RimrollError, match="must be perpendicular"):
        rr.ground.read_all(x, again)
    third = written(tmp_path, "third.AT2", "090")
    with pytest.raises(rr.RimrollError, match="are all horizontal"):
        rr.ground.read_all(x, again, third)
