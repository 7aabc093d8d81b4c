"""Extremes of the tilt, and the turns between them."""

from dataclasses import replace

import numpy as np
import pytest

import rimroll as rr
from given.motions import CAN, DISK, PAPER_START


def test_events_come_in_order_with_tilt_minima_and_maxima_in_turns(motion):
    times = [event.t for event in motion.events]
    assert times == sorted(times)
    kinds = [event.kind for event in motion.events]
    assert kinds == ["tilt_min", "tilt_max"] * (len(kinds) // 2) + ["tilt_min"] * (len(kinds) % 2)
    assert len(kinds) >= 6


def test_at_an_extreme_the_tilt_is_at_rest_and_nowhere_beyond(motion):
    fine = motion.samples(8)
    lows, highs = (
        [event.state.tilt for event in motion.events if event.kind == kind]
        for kind in ("tilt_min", "tilt_max")
    )
    assert min(lows) <= fine.tilt.min() * (1 + 1e-12)
    assert max(highs) >= fine.tilt.max() * (1 - 1e-12)
    for event in motion.events:
        # The body's angular velocity is some rad/s all the time.
        assert abs(event.state.tilt_rate) < 1e-11


def test_a_turn_is_measured_from_rest_to_rest(motion):
    lows = [event for event in motion.events if event.kind == "tilt_min"]
    highs = [event for event in motion.events if event.kind == "tilt_max"]
    yaw, start = PAPER_START.yaw, 0.0
    assert len(motion.turns) == len(highs)
    for turn, low, high in zip(motion.turns, lows, highs, strict=False):
        assert (turn.start, turn.t, turn.end) == (start, low.t, high.t)
        assert turn.angle == high.state.yaw - yaw
        assert (turn.min_tilt, turn.yaw_rate) == (low.state.tilt, low.state.yaw_rate)
        assert turn.max_tilt == high.state.tilt
        yaw, start = high.state.yaw, high.t


def test_a_release_upward_starts_its_first_turn_at_the_top():
    start = replace(PAPER_START, tilt_rate=0.5)
    motion = rr.simulate(CAN, start, rr.NoSlip(), 1.0, gravity=9.8)
    assert [event.kind for event in motion.events][:3] == ["tilt_max", "tilt_min", "tilt_max"]
    assert motion.turns[0].start == motion.events[0].t > 0.0


def test_a_release_at_rest_is_no_event():
    start = replace(PAPER_START, tilt_rate=0.0)
    motion = rr.simulate(CAN, start, rr.NoSlip(), 1.0, gravity=9.8)
    assert motion.events[0].kind == "tilt_min" and motion.turns[0].start == 0.0


def test_a_disk_passes_its_edge_and_turns_on_its_other_face():
    start = rr.State(tilt=1.2, tilt_rate=10.0, yaw_rate=0.3, spin_rate=0.1)
    motion = rr.simulate(DISK, start, rr.Frictionless(), 0.4)
    first, over, second = motion.events
    assert [first.kind, over.kind, second.kind] == ["on_edge", "tilt_max", "on_edge"]
    assert first.state.tilt == pytest.approx(np.pi / 2, abs=1e-15)
    (turn,) = motion.turns
    assert turn.min_tilt == pytest.approx(np.pi - over.state.tilt, abs=1e-15)
    assert (turn.start, turn.t, turn.end) == (first.t, over.t, second.t)
    assert turn.max_tilt == pytest.approx(np.pi / 2, abs=1e-15)
