"""The picture of a map: axes, line, colour scale and legend."""

from __future__ import annotations

import itertools

import numpy as np
import pytest
from matplotlib.text import Text

import rimroll as rr
from rimroll.figures import style
from rimroll.many.left_or_right import LINE_HALVINGS, side_line
from rimroll.many.map_figure import beyond, map_figure, span
from rimroll.paper import setting
from rimroll.paper.figures.sensitivity import FLICK

CAN, GRAVITY = setting.CAN, setting.GRAVITY
RATES = np.linspace(-1.0, 1.0, 20)


def mapped(yaw=RATES, spin=RATES, law=None, start=FLICK, body=CAN):
    return rr.turn_map(body, start, law or rr.NoSlip(), yaw, spin, gravity=GRAVITY)


def named(figure):
    """The names in the legend."""
    legend = figure.axes[0].get_legend()
    return [text.get_text() for text in legend.texts] if legend else []


ZOOMS = {
    "as it is": (RATES, RATES, "(rad/s)", "(rad/s)"),
    "a billionfold": (1e-9 * RATES, 1e-9 * RATES, "(10⁻⁹ rad/s)", "(10⁻⁹ rad/s)"),
    "beside the middle": (
        0.05 + 5e-8 * RATES,
        -1.0 + 0.01 * RATES,
        "− 0.05 rad/s (10⁻⁸ rad/s)",
        "+ 1 rad/s (10⁻² rad/s)",
    ),
    "fast": (1e5 * RATES, RATES, "(10⁵ rad/s)", "(rad/s)"),
}


@pytest.mark.parametrize("zoom", ZOOMS)
def test_an_axis_says_in_its_label_what_its_ticks_count(zoom):
    yaw, spin, x, y = ZOOMS[zoom]
    with style.figure_style():
        figure = map_figure(mapped(yaw, spin))
        figure.draw_without_rendering()
        ax = figure.axes[0]
        assert ax.get_xlabel() == f"yaw rate at the start {x}"
        assert ax.get_ylabel() == f"spin rate at the start {y}"
        for axis in (ax.xaxis, ax.yaxis):
            assert axis.get_offset_text().get_text() == ""
            assert all(len(label.get_text()) <= 5 for label in axis.get_ticklabels())
        boxes = [
            text.get_window_extent()
            for text in figure.findobj(Text)
            if text.get_text().strip() and text.get_visible()
        ]
    for a, b in itertools.combinations(boxes, 2):
        assert a.x1 <= b.x0 or b.x1 <= a.x0 or a.y1 <= b.y0 or b.y1 <= a.y0


def test_ticks_times_their_power_and_the_offset_are_the_rates():
    ax = map_figure(mapped(0.05 + 5e-8 * RATES)).axes[0]
    labels = [float(label.get_text().replace("−", "-")) for label in ax.get_xticklabels()]
    assert len(labels) > 3
    assert 0.05 + 1e-8 * np.array(labels) == pytest.approx(ax.get_xticks(), rel=1e-14, abs=0.0)


def test_under_friction_that_holds_the_rim_the_line_is_that_of_rolling():
    yaw, spin = side_line(mapped(law=rr.Coulomb(0.3)), -1.0, 1.0)
    slope = rr.watershed_slope(CAN, FLICK.tilt, rr.NoSlip())
    cell = RATES[1] - RATES[0]
    assert np.array_equal(spin, RATES)
    assert yaw == pytest.approx(slope * spin, abs=cell / 2**LINE_HALVINGS)


@pytest.mark.parametrize(
    "law", [rr.Coulomb(0.05), rr.Viscous(0.5), rr.NoSlip() + rr.RollingResistance(1e-4)], ids=repr
)
def test_the_line_found_by_trial_parts_falls_to_the_right_from_falls_to_the_left(law):
    few = RATES[::4]
    falls = mapped(spin=few, law=law)
    yaw, spin = side_line(falls, -1.0, 1.0)
    assert np.array_equal(spin, few)
    left = falls.direction.values > np.pi
    assert np.array_equal(left, falls.yaw_rate.values > yaw[:, None])
    found = rr.watershed(CAN, FLICK, law, few, gravity=GRAVITY, rtol=1e-6)
    assert yaw == pytest.approx(found, abs=(RATES[1] - RATES[0]) / 2**LINE_HALVINGS)
    assert named(map_figure(falls)) == ["comes down flat"]


LINELESS = {
    "beside it": lambda: mapped(yaw=0.5 + 0.1 * RATES),
    "beside it, with friction": lambda: mapped(yaw=0.5 + 0.1 * RATES[::9], law=rr.Coulomb(0.2)),
    "falling back": lambda: mapped(start=rr.State(tilt=0.8, tilt_rate=0.5)),
    "on the other face": lambda: mapped(
        body=rr.bodies.disk(0.03), start=rr.State(tilt=1.7, tilt_rate=0.2)
    ),
}


@pytest.mark.parametrize("name", LINELESS)
def test_a_map_on_which_the_side_does_not_change_is_drawn_without_a_line(name):
    assert "comes down flat" not in named(map_figure(LINELESS[name]()))


def test_the_legend_names_an_outcome_where_it_can_be_seen_and_not_under_the_line():
    odd = np.linspace(-1.0, 1.0, 101)
    falls = mapped(odd, odd)
    assert falls.outcome.values[50, 50] == "face_down"
    assert named(map_figure(falls)) == ["comes down flat"]
    wide = mapped(8.0 * RATES, 8.0 * RATES)
    assert "lifted_off" in wide.outcome.values
    assert named(map_figure(wide)) == ["comes down flat", "lifted off"]


def test_a_scale_of_colours_is_not_drawn_out_for_a_few_falls_and_says_so():
    falls = mapped()
    whole = span(falls)
    assert whole == 50.0 and beyond(falls, whole) == (0.0, 0.0)
    assert map_figure(falls).axes[1].get_ylabel() == "direction of fall (degrees)"
    falls.direction.values[10, 3:5] = np.radians([300.0, 310.0])
    assert span(falls) <= whole
    farther = np.abs(np.degrees(falls.direction.values) - 180.0) > span(falls)
    assert 2 <= farther.sum() <= 4  # one in a hundred at most
    assert sum(beyond(falls, span(falls))) == pytest.approx(farther.mean())
    label = map_figure(falls).axes[1].get_ylabel()
    assert label.endswith(f"\n{100.0 * farther.mean():.2g} % of the falls lie beyond")
    falls.direction.values[:3] = np.radians(300.0)  # these are not a few
    assert span(falls) == 180.0
