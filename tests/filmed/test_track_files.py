"""Filmed tracks from files: Tracker's export, and others."""

import io

import numpy as np
import pytest

import rimroll as rr

T = np.arange(20) / 100.0
X, Y = 0.1 * np.cos(9.0 * T), 0.1 * np.sin(7.0 * T)


def stream(text):
    return io.BytesIO(text.encode())


def rows(*columns, mark="\t", end=""):
    return "".join(
        mark.join(f"{value:.9E}" for value in row) + end + "\n"
        for row in zip(*columns, strict=True)
    )


@pytest.mark.parametrize("mark", ["\t", ",", ";"])
def test_an_export_of_tracker_with_one_mass(mark):
    text = f"mass_A\n{mark.join('txy')}\n{rows(T, X, Y, mark=mark)}"
    track = rr.filmed.read(stream(text))
    assert track.kind == "path"
    assert track.t == pytest.approx(T)
    assert track.values == pytest.approx(np.stack([X, Y], axis=-1))
    assert "x in m" in track.source


@pytest.mark.parametrize("end", ["", "\t"])
def test_an_export_of_tracker_with_several_masses(end):
    head = f"#multi:\n\tcm A\t\tcm B\t\t{end}\nt\tx\ty\tx\ty{end}\n"
    text = head + rows(T, X, Y, 2.0 * X, 3.0 * Y, end=end)
    with pytest.raises(rr.RimrollError, match="several masses, cm A, cm B: say which"):
        rr.filmed.read(stream(text))
    track = rr.filmed.read(stream(text), mass="cm B")
    assert track.values == pytest.approx(np.stack([2.0 * X, 3.0 * Y], axis=-1))
    with pytest.raises(rr.RimrollError, match='no mass "cm C"; it has cm A, cm B'):
        rr.filmed.read(stream(text), mass="cm C")


def test_frames_without_a_mark_are_left_out_and_told():
    lines = rows(T, X, Y).splitlines()
    lines[4] = f"{T[4]:.9E}\t\t"
    track = rr.filmed.read(stream("mass_A\nt\tx\ty\n" + "\n".join(lines)))
    assert len(track.t) == 19
    assert track.notes == ("Lines without a marked position were left out: 1.",)


def test_units_in_brackets_or_given_and_columns_by_name():
    text = "time (ms),top x (cm),top y (cm)\n" + rows(1e3 * T, 100.0 * X, 100.0 * Y, mark=",")
    track = rr.filmed.read(stream(text), columns={"x": "top x (cm)", "y": 3})
    assert track.t == pytest.approx(T)
    assert track.values == pytest.approx(np.stack([X, Y], axis=-1))
    plain = "t,x,y\n" + rows(T, 100.0 * X, 100.0 * Y, mark=",")
    given = rr.filmed.read(stream(plain), units={"x": "cm", "y": "cm"})
    assert given.values == pytest.approx(track.values)


def test_times_in_ms_without_a_unit_are_refused_with_the_way_out():
    text = "t,x,y\n" + rows(1e3 * T, X, Y, mark=",")
    with pytest.raises(
        rr.RimrollError, match=r"look like ms: .*\(on the command line --units t=ms"
    ):
        rr.filmed.read(stream(text))
    assert rr.filmed.read(stream(text), units={"t": "ms"}).t == pytest.approx(T)


def test_angles_need_a_unit():
    text = "t\ttilt\theading\n" + rows(T, np.degrees(X), np.degrees(Y))
    with pytest.raises(rr.RimrollError, match="names no unit"):
        rr.filmed.read(stream(text))
    track = rr.filmed.read(stream(text), units={"tilt": "deg", "heading": "deg"})
    assert track.kind == "lean"
    assert track.values == pytest.approx(np.stack([X, Y], axis=-1))
    bracketed = "t (s)\ttilt (°)\n" + rows(T, np.degrees(X))
    assert rr.filmed.read(stream(bracketed)).values[:, 0] == pytest.approx(X)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("", "is empty"),
        ("mass_A\nt\tvx\tvy\n" + rows(T, X, Y), "must have columns t, x and y, or t and tilt"),
        ("t\tx\ty\n0\t1\t2\n1\tone\t2\n", r"line 3: 1, one, 2 are not all numbers"),
        ("t,x,y\n0,1,2\n1,1,2\n", "at least 12 samples"),
        ("t,x,y\n" + rows(T[::-1], X, Y, mark=","), "times must increase"),
        ("t,x,y,x,y\n" + rows(T, X, Y, X, Y, mark=","), "two columns for x"),
    ],
)
def test_what_is_no_track_is_refused_with_a_sentence(text, message):
    with pytest.raises(rr.RimrollError, match=message):
        rr.filmed.read(stream(text))
