"""The oracles of exact turns, tested against the print, each other and 128-bit numbers."""

from types import SimpleNamespace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from mpmath import mp

from given.motions import sixty_starts
from given.strategies import bodies, examples
from oracles import paper_equations as paper
from oracles import rolling_disk, tabulated_turns, taylor_turns

by_law = pytest.mark.parametrize("law", taylor_turns.LAWS)
BODY = tabulated_turns.BODY
ROWS = tabulated_turns.rows()

rates = st.floats(-30.0, 30.0)


@by_law
@examples(30)
@given(bodies(), st.floats(1e-6, 1.5), rates, rates, rates)
def test_the_rates_by_taylor_s_clock_are_those_of_the_printed_equations(law, body, tilt, p, w, s):
    with mp.workdps(40):
        body = SimpleNamespace(**{name: mp.mpf(getattr(body, name)) for name in BODY})
        tilt, p, w, s = map(mp.mpf, (tilt, p, w, s))
        sin, cos = mp.sin(tilt), mp.cos(tilt)
        yaw_rate = w / sin
        rates = yaw_rate, p, s - yaw_rate * cos
        yawing, tilting, spinning = paper.angular_accelerations(body, law, tilt, *rates, 10, mp)
        printed = (
            sin * tilting,
            sin * (yawing * sin + yaw_rate * p * cos),
            sin * (spinning + yawing * cos - yaw_rate * p * sin),
        )
        law = taylor_turns.LAWS[law](body, 10)
        step = taylor_turns.Step(law, [sin, cos, p, w, s, mp.zero, mp.zero])
        size = 10 + p**2 + w**2 + s**2 + 10 / body.radius
        for name, rate in zip("pws", printed, strict=True):
            # The print, in Euler angles, loses digits by dividing by the tilt.
            assert abs(getattr(step, name)[1] - rate) < 1e-20 * size, name


@by_law
@pytest.mark.parametrize("k", [0, 17, 59])
def test_turns_by_taylor_series_are_those_known_to_twenty_digits(law, k):
    """The sixty starts' own source had the can's numbers as decimals, not as doubles."""
    with mp.workdps(taylor_turns.DIGITS):
        row, mass = sixty_starts(mp.mpf)[k], mp.mpf("0.070")
        can = SimpleNamespace(
            mass=mass,
            radius=mp.mpf("0.051"),
            height=mp.mpf("0.069"),
            transverse_inertia=mass * mp.mpf("5.13e-3"),
            axial_inertia=mass * mp.mpf("2.0e-3"),
        )
        start = {name: float(row[name]) for name in tabulated_turns.START}
        found = taylor_turns.first_turn(can, law, SimpleNamespace(**start), mp.mpf("9.8"))
        assert abs(found.turn - row[f"turn_{law}"]) < 1e-23
        assert abs(found.min_tilt / row[f"min_tilt_{law}"] - 1) < 1e-22
        assert abs(found.end_time - row[f"t_{law}"]) < 1e-23


@pytest.mark.parametrize("row", ROWS[:: len(ROWS) // 4], ids=lambda row: row.kind)
def test_the_table_of_turns_is_what_taylor_series_give(row):
    for law, tabulated in row.turns.items():
        found = taylor_turns.first_turn(row.body, law, row.start, row.gravity, row.topple_tilt)
        assert found.outcome == tabulated.outcome
        with mp.workdps(30):
            for name in tabulated_turns.NUMBERS if found.outcome != "fell_back" else ():
                assert abs(getattr(found, name) / getattr(tabulated, name) - 1) < 1e-24, name


def test_the_table_has_turns_of_all_kinds():
    kinds = [*tabulated_turns.KINDS, *tabulated_turns.TOPPLING]
    assert {row.kind for row in ROWS} == {kind.__name__ for kind in kinds}
    every = [turn for row in ROWS for turn in row.turns.values()]
    turns = [turn for turn in every if turn.outcome != "fell_back"]
    assert len(every) - len(turns) >= 10
    toppled = [
        (row, turn) for row in ROWS for turn in row.turns.values() if turn.outcome == "toppled"
    ]
    assert len(toppled) >= 30
    assert min(turn.min_tilt for _, turn in toppled) < 1e-11
    assert {row.topple_tilt is None for row, _ in toppled} == {True, False}
    balance = np.array([np.arctan2(row.body.radius, row.body.height) for row in ROWS])
    held = [
        law
        for row, tilt in zip(ROWS, balance, strict=True)
        for law, turn in row.turns.items()
        if turn.outcome == "rocked" and turn.end_tilt > tilt
    ]
    assert set(held) == set(taylor_turns.LAWS)
    assert len(turns) >= 150
    assert min(turn.min_tilt for turn in turns) < 1e-13
    assert max(turn.min_tilt for turn in turns) > 0.4
    assert min(turn.turn for turn in turns) < -6.0 and max(turn.turn for turn in turns) > 6.0
    assert any(row.body.height == 0.0 for row in ROWS)
    assert any(row.body.height > 10.0 * row.body.radius for row in ROWS)


@pytest.mark.parametrize(
    ("gyration", "thickness", "yaw_rate", "spin_rate"),
    [
        pytest.param(1.0, 1.0, 0.01, -0.02, id="ring"),
        pytest.param(0.5, 1.0, 0.5, 0.7, id="disk"),
        pytest.param(2.5, 1.2, 0.01, 0.02, id="wide"),
    ],
)
def test_a_disk_in_hypergeometric_functions_turns_as_by_taylor_series(
    gyration, thickness, yaw_rate, spin_rate
):
    disk = disk_of(gyration, thickness)
    start = SimpleNamespace(tilt=0.6, tilt_rate=0.0, yaw_rate=yaw_rate, spin_rate=spin_rate)
    found = taylor_turns.first_turn(disk, "no_slip", start, 9.8)
    turn, min_tilt = rolling_disk.turn(disk, start, 9.8)
    assert abs(turn - found.turn) < 1e-16
    assert abs(min_tilt / found.min_tilt - 1) < 1e-16


def disk_of(gyration, thickness):
    """A body without height: C = `gyration` mR2 and A = `thickness` C/2."""
    axial = gyration * 0.25
    return SimpleNamespace(
        mass=1.0,
        radius=0.5,
        height=0.0,
        transverse_inertia=0.5 * thickness * axial,
        axial_inertia=axial,
    )
