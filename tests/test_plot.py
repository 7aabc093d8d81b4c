"""The nine-panel figure of any motion, and the style it is drawn in."""

from __future__ import annotations

import io

import matplotlib as mpl
import numpy as np
import pytest

import rimroll as rr
from rimroll import plot, style
from rimroll.paper import setting

CAN = setting.CAN


def wobble(tilt):
    """The can circling at a constant tilt."""
    yaw_rate = rr.steady_wobble_rate(CAN, tilt)
    spin_rate = yaw_rate * (CAN.height / CAN.radius * np.sin(tilt) - np.cos(tilt))
    return rr.State(tilt=tilt, yaw_rate=yaw_rate, spin_rate=spin_rate)


MOTIONS = {
    "the paper's": lambda: setting.motion(rr.NoSlip()),
    "without friction": lambda: setting.motion(rr.Frictionless()),
    "the other way": lambda: setting.motion(rr.NoSlip(), -0.005),
    "very near a collision": lambda: setting.motion(rr.NoSlip(), 1e-12),
    "toppling": lambda: rr.simulate(
        CAN, rr.State(tilt=0.35, tilt_rate=-4.5, yaw_rate=-0.02, spin_rate=-0.02), rr.NoSlip()
    ),
    "a disk rolling": lambda: rr.simulate(
        rr.bodies.disk(0.1), rr.State(tilt=1.0, yaw_rate=5.0), rr.NoSlip()
    ),
    "a steady wobble": lambda: rr.simulate(CAN, wobble(0.3), rr.NoSlip()),
    "falling face down": lambda: rr.simulate(CAN, rr.State(tilt=0.5), rr.NoSlip()),
    "over at once": lambda: rr.simulate(CAN, rr.State(tilt=1.5, tilt_rate=9.0), rr.Frictionless()),
}


def panels_and_lenses(figure):
    panels = figure.axes
    return panels, [lens for ax in panels for lens in ax.child_axes]


@pytest.mark.parametrize("name", MOTIONS)
def test_every_motion_has_its_nine_panels_with_units(name):
    figure = plot.nine_panels(MOTIONS[name]())
    panels, lenses = panels_and_lenses(figure)
    assert len(panels) == 9
    for ax in [*panels, *lenses]:
        assert ax.get_xlabel().endswith(")"), ax.get_title(loc="left")
        assert ax.get_ylabel().endswith(")"), ax.get_title(loc="left")
    figure.set_layout_engine("none")  # to lay it out takes longer than to draw it
    with style.figure_style():
        figure.draw_without_rendering()


@pytest.mark.parametrize(
    ("name", "lens"),
    [
        ("the paper's", True),
        ("without friction", True),
        ("the other way", True),
        ("toppling", True),
        ("very near a collision", False),  # briefer than floating-point times can show
        ("a disk rolling", False),  # its yaw is no step
        ("a steady wobble", False),
        ("falling face down", False),
    ],
)
def test_a_lens_is_there_when_the_near_collision_looks_like_a_step(name, lens):
    motion = MOTIONS[name]()
    assert (plot.near_collision_window(motion) is not None) == lens
    assert len(panels_and_lenses(plot.nine_panels(motion))[1]) == lens


@pytest.mark.parametrize("law", setting.LAWS)
def test_the_lens_spans_twenty_collision_times_around_the_first_turn(law):
    pasted = rr.pasted(CAN, setting.start(), law, setting.GRAVITY)
    window = plot.near_collision_window(setting.motion(law))
    assert window.t == pytest.approx(pasted.time, rel=1e-6)
    brief = pasted.min_tilt / pasted.tipping_rate
    assert window.half_width == pytest.approx(20.0 * brief, rel=2e-3)


def test_the_yaw_inside_the_lens_stays_between_the_two_halves_of_the_limit():
    motion = setting.motion(rr.NoSlip())
    (lens,) = panels_and_lenses(plot.nine_panels(motion))[1]
    low, high, curve = (np.asarray(line.get_ydata()) for line in lens.lines)
    assert high[0] - low[0] == pytest.approx(rr.turn_limit(CAN, rr.NoSlip()), rel=1e-12)
    assert low[0] < curve.min() and curve.max() < high[0]
    assert np.ptp(curve) > 0.95 * (high[0] - low[0])
    assert "µs" in lens.get_xlabel()


def test_the_dashed_line_of_the_friction_panel_is_the_closed_form():
    ax = plot.nine_panels(setting.motion(rr.NoSlip())).axes[7]
    needed = (
        CAN.mass * CAN.height * CAN.radius / (CAN.transverse_inertia + CAN.mass * CAN.height**2)
    )
    assert ax.lines[0].get_ydata()[0] == pytest.approx(needed, rel=1e-14)
    assert needed * 0.995 < ax.lines[1].get_ydata().max() < needed


def test_rates_and_forces_of_a_near_collision_are_drawn_on_stretched_axes_and_gentle_ones_are_not():
    violent = plot.nine_panels(MOTIONS["the paper's"]()).axes
    gentle = plot.nine_panels(MOTIONS["a steady wobble"]()).axes
    assert [ax.get_yscale() for ax in violent[4:7]] == ["symlog"] * 3
    assert [ax.get_yscale() for ax in gentle] == ["linear"] * 9


def test_plot_of_a_motion_is_the_nine_panels():
    figure = setting.motion(rr.NoSlip()).plot()
    titles = [ax.get_title(loc="left") for ax in figure.axes]
    assert titles[0] == "(a) tilt" and titles[-1] == "(i) yaw rate, spin rate"


def test_the_same_figure_is_the_same_file_and_the_settings_come_back():
    before = dict(mpl.rcParams)
    files = []
    for _ in range(2):
        figure = plot.nine_panels(MOTIONS["falling face down"]())
        file = io.BytesIO()
        with style.figure_style():
            figure.savefig(file, format="svg", metadata={"Date": None})
        files.append(file.getvalue())
    assert files[0] == files[1]
    assert dict(mpl.rcParams) == before


@pytest.mark.parametrize(
    ("value", "text"),
    [(0.0, "0"), (1.0, "1"), (10.0, "10"), (1e-3, "10⁻³"), (-1e12, "−10¹²"), (-20.0, "−20")],
)
def test_powers_of_ten_are_written_high(value, text):
    assert style.power_of_ten(value) == text


@pytest.mark.parametrize(
    ("value", "text"), [(0.005, "0.005"), (1e-4, "10⁻⁴"), (5e-5, "5×10⁻⁵"), (0.1, "0.1")]
)
def test_small_numbers_are_written_plainly(value, text):
    assert style.plain(value) == text


def test_the_laws_differ_in_marker_as_well_as_in_colour():
    rolling, sliding = (style.look(law) for law in setting.LAWS)
    assert rolling["color"] != sliding["color"] and rolling["marker"] != sliding["marker"]
