"""Random good files are read back to the numbers that were written; damaged ones never silently."""

import io

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import rimroll as rr
from given.at2 import HEADERS, STYLES, at2
from given.strategies import examples

G = rr.STANDARD_GRAVITY
UNITS = {"g": G, "m/s2": 1.0, "cm/s2": 0.01, "gal": 0.01, "m/s^2": 1.0, "cm/s/s": 0.01}
SECONDS = {"s": 1.0, "sec": 1.0, "ms": 1e-3, "us": 1e-6}


@st.composite
def tables(draw):
    """The bytes of a file, what must be given to read it, and its step and samples."""
    count, step = draw(st.integers(3, 30)), draw(st.sampled_from([0.001, 0.005, 0.01, 0.02]))
    values = np.array(draw(st.lists(st.integers(-90_000, 90_000), min_size=count, max_size=count)))
    values = values / 1e5
    unit, second = draw(st.sampled_from(sorted(UNITS))), draw(st.sampled_from(sorted(SECONDS)))
    mark, decimal = draw(
        st.sampled_from([(",", "."), (";", "."), (";", ","), ("\t", "."), ("\t", ","), ("  ", ".")])
    )
    bracket = draw(st.sampled_from(["{} ({})", "{} [{}]", "{}({})"]))
    beside = draw(st.booleans())
    cells = {
        bracket.format(draw(st.sampled_from(["t", "Time", "time"])), second): np.arange(count)
        * (step / SECONDS[second]),
        bracket.format(draw(st.sampled_from(["ax", "Acc X", "Acceleration x"])), unit): values,
    }
    if beside:
        cells |= {bracket.format("Velocity", "m/s"): values, bracket.format("Disp", "cm"): values}
    given_words = {}
    titles = [mark.join(cells)]
    if draw(st.booleans()):
        titles = (
            [] if draw(st.booleans()) else ["a" + mark + "b" + (mark + "c" + mark + "d") * beside]
        )
        given_words = {"columns": {"t": 1, "x": 2}, "units": unit, "time_unit": second}
    above = draw(
        st.sampled_from([[], ["Station: nowhere"], ["# a comment", ""], ["Made by hand", ""]])
    )
    if mark in ";," and draw(st.booleans()):
        above = [f"sep={mark}"]
    rows = [
        mark.join(f"{value:.9g}".replace(".", decimal) for value in row)
        for row in zip(*cells.values(), strict=True)
    ]
    end = draw(st.sampled_from(["\n", "\r\n"]))
    text = end.join([*above, *titles, *rows, ""]) + draw(st.sampled_from(["", "\x1a"]))
    encoding = draw(st.sampled_from(["utf-8", "utf-8-sig", "utf-16"]))
    return text.encode(encoding), given_words, step, values * UNITS[unit]


@given(tables())
@examples(400)
def test_random_tables_are_read_back(file):
    content, words, step, samples = file
    found_step, found = rr.ground.read(io.BytesIO(content), **words).core.samples()
    assert found_step == pytest.approx(step, rel=1e-9)
    np.testing.assert_allclose(found[:, 0], samples, rtol=1e-8, atol=1e-9)
    assert not found[:, 1:].any()


@given(
    tables() | st.builds(
        lambda samples, header, style: (
            at2(samples, header=header, style=style).encode(), {}, 0.02, np.array(samples) * G
        ),
        st.lists(st.floats(-9.0, 9.0), min_size=6, max_size=40),
        st.sampled_from(HEADERS),
        st.sampled_from(sorted(STYLES)),
    ),
    st.floats(0.0, 1.0),
    st.sampled_from(["cut", "drop line", "letters", "nan", "nul", "swap"]),
)  # fmt: skip
@examples(400)
def test_a_damaged_file_is_refused_or_read_as_it_stands(file, place, damage):
    """No traceback; and no line of numbers is lost without a word."""
    content, words, _, samples = file
    at = int(place * (len(content) - 1))
    lines = content.split(b"\n")
    line = int(place * (len(lines) - 1))
    damaged = {
        "cut": content[:at],
        "drop line": b"\n".join(lines[:line] + lines[line + 1 :]),
        "letters": content[:at] + b"spike" + content[at:],
        "nan": content[:at] + b" nan " + content[at:],
        "nul": content[:at] + b"\x00\x07" + content[at:],
        "swap": b"\n".join([*lines[:line], *reversed(lines[line : line + 2]), *lines[line + 2 :]]),
    }[damage]
    try:
        _, found = rr.ground.read(io.BytesIO(damaged), **words).core.samples()
    except rr.RimrollError as error:
        assert "\n" not in str(error)
        return
    assert np.isfinite(found).all()
    # Only a whole line at an end may be missing, or a title's or comment's letters be others.
    assert len(found) >= len(samples) - 1 or damage == "cut"
