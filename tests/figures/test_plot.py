"""The nine-panel figure of any motion, and its style."""

from __future__ import annotations

import io
from dataclasses import dataclass
from typing import ClassVar

import matplotlib as mpl
import numpy as np
import pytest

import rimroll as rr
from rimroll.cli.outcomes import outcome, tables
from rimroll.cli.request import Request
from rimroll.cli.side_by_side import side_by_side
from rimroll.figures import style
from rimroll.laws import LAWS
from rimroll.laws.parameters import FRICTION, RESTITUTION, STATIC
from rimroll.motion import figure as plots
from rimroll.options import Options
from rimroll.paper import setting

CAN = setting.CAN


def wobble(tilt):
    """The can circling at a constant tilt."""
    yaw_rate = rr.steady_wobble_rate(CAN, tilt)
    spin_rate = yaw_rate * (CAN.height / CAN.radius * np.sin(tilt) - np.cos(tilt))
    return rr.State(tilt=tilt, yaw_rate=yaw_rate, spin_rate=spin_rate)


def simulate(law):
    return rr.simulate(CAN, setting.start(), law, 1.0)


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
    "sticking and slipping": lambda: simulate(rr.Coulomb(0.2)),
    "sticking more than slipping": lambda: simulate(rr.Coulomb(0.3, static=0.33)),
    "an oil film": lambda: simulate(rr.Viscous(0.1)),
    "smoothed friction": lambda: simulate(rr.Stribeck(0.2)),
    "flying": lambda: rr.simulate(
        CAN,
        rr.State(tilt=0.3, tilt_rate=-12.0, yaw_rate=0.005, spin_rate=0.005),
        rr.Coulomb(0.8, restitution=0.5),
    ),
    "lifting off": lambda: rr.simulate(
        CAN, rr.State(tilt=0.3, tilt_rate=-9.5, yaw_rate=0.005, spin_rate=0.005), rr.NoSlip()
    ),
    "over at once": lambda: rr.simulate(CAN, rr.State(tilt=1.5, tilt_rate=9.0), rr.Frictionless()),
}


def panels_and_lenses(figure):
    panels = figure.axes
    return panels, [lens for ax in panels for lens in ax.child_axes]


@pytest.mark.parametrize("name", MOTIONS)
def test_every_motion_has_its_nine_panels_with_units(name):
    figure = plots.nine_panels(MOTIONS[name]())
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
        ("a disk rolling", False),  # its yaw does not look like a step
        ("a steady wobble", False),
        ("falling face down", False),
        ("sticking and slipping", True),
        ("an oil film", True),
    ],
)
def test_a_lens_is_there_when_the_near_collision_looks_like_a_step(name, lens):
    motion = MOTIONS[name]()
    assert (plots.near_collision_window(motion) is not None) == lens
    assert len(panels_and_lenses(plots.nine_panels(motion))[1]) == lens


@pytest.mark.parametrize("law", setting.LAWS)
def test_the_lens_spans_twenty_collision_times_around_the_first_turn(law):
    composite = rr.composite(CAN, setting.start(), law, setting.GRAVITY)
    window = plots.near_collision_window(setting.motion(law))
    assert window.t == pytest.approx(composite.min_tilt_time, rel=1e-6)
    brief = composite.min_tilt / composite.tipping_rate
    assert window.half_width == pytest.approx(20.0 * brief, rel=2e-3)


def test_the_yaw_inside_the_lens_stays_between_the_two_halves_of_the_limit():
    motion = setting.motion(rr.NoSlip())
    (lens,) = panels_and_lenses(plots.nine_panels(motion))[1]
    low, high, curve = (np.asarray(line.get_ydata()) for line in lens.lines)
    assert high[0] - low[0] == pytest.approx(rr.turn_limit(CAN, rr.NoSlip()), rel=1e-12, abs=0.0)
    assert low[0] < curve.min() and curve.max() < high[0]
    assert np.ptp(curve) > 0.95 * (high[0] - low[0])
    assert "µs" in lens.get_xlabel()


def test_the_dashed_line_of_the_friction_panel_is_the_closed_form():
    ax = plots.nine_panels(setting.motion(rr.NoSlip())).axes[7]
    needed = (
        CAN.mass * CAN.height * CAN.radius / (CAN.transverse_inertia + CAN.mass * CAN.height**2)
    )
    assert ax.lines[0].get_ydata()[0] == pytest.approx(needed, rel=1e-14, abs=0.0)
    assert needed * 0.995 < ax.lines[1].get_ydata().max() < needed


def test_dotted_lines_are_the_friction_that_there_is():
    for name, expected in (
        ("sticking and slipping", [0.2]),
        ("sticking more than slipping", [0.3, 0.33]),
        ("smoothed friction", [0.2]),
        ("an oil film", []),
        ("the paper's", []),
    ):
        ax = plots.nine_panels(MOTIONS[name]()).axes[7]
        dotted = [line.get_ydata()[0] for line in ax.lines if line.get_linestyle() == ":"]
        assert dotted == expected


def test_a_new_law_of_friction_has_its_dotted_line(monkeypatch):
    @dataclass(frozen=True, repr=False, eq=False)
    class Wax(rr.Law):
        name: ClassVar[str] = "coulomb"
        color: ClassVar[str] = "#117733"
        marker: ClassVar[str] = "*"

        friction: float = FRICTION.field()
        static: float | None = STATIC.field(None)
        restitution: float = RESTITUTION.field(0.0)

    monkeypatch.setitem(LAWS, "coulomb", Wax)
    motion = rr.simulate(CAN, rr.State(tilt=0.5, yaw_rate=0.1), Wax(0.3, 0.33), duration=0.1)
    ax = plots.nine_panels(motion).axes[7]
    dotted = [line.get_ydata()[0] for line in ax.lines if line.get_linestyle() == ":"]
    assert dotted == [0.3, 0.33]


def test_sliding_is_shaded_where_it_alternates_with_rolling():
    motion = MOTIONS["sticking and slipping"]()
    sliding = [phase for phase in motion.phases if phase.kind == "sliding"]
    for ax in plots.nine_panels(motion).axes[6:8]:
        assert len(ax.patches) == len(sliding)
        assert ax.patches[0].get_x() == sliding[0].start
    assert not plots.nine_panels(MOTIONS["the paper's"]()).axes[6].patches


def test_rates_and_forces_of_a_near_collision_are_drawn_on_stretched_axes_and_gentle_ones_are_not():
    violent = plots.nine_panels(MOTIONS["the paper's"]()).axes
    gentle = plots.nine_panels(MOTIONS["a steady wobble"]()).axes
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
        figure = plots.nine_panels(MOTIONS["falling face down"]())
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
    laws = (*setting.LAWS, rr.InPlace(), rr.Coulomb(0.2), rr.Viscous(1.0), rr.Stribeck(0.2))
    looks = [style.look(law) for law in laws]
    assert len({look["color"] for look in looks}) == len(laws)
    assert len({look["marker"] for look in looks}) == len(laws)


def outcomes(arguments):
    """The comparison of the command line."""
    what = Request(CAN, arguments.get("start", setting.start()), rr.NoSlip(), Options(), name="can")
    return [
        outcome(what, name, law)
        for name, law in tables(arguments.get("on", "ice,0.2"), 0.0).items()
    ]


def test_the_comparison_has_units_on_its_axes_and_a_path_for_each_table():
    figure = side_by_side(outcomes({"on": "ice,0.2,no-slip"}))
    titles = [ax.get_title(loc="left") for ax in figure.axes]
    assert len(titles) == 8 + 3
    assert [title[:3] for title in titles] == [f"({letter})" for letter in "abcdefghijk"]
    assert all(ax.get_ylabel().endswith(")") for ax in figure.axes)
    labelled = [ax.get_xlabel() for ax in figure.axes if ax.get_xlabel()]
    assert labelled == ["time $t$ (s)", "time from the smallest tilt (µs)", "$x$ (cm)"]


def test_the_comparison_says_what_its_straight_lines_are():
    figure = side_by_side(outcomes({"on": "ice,0.2,no-slip"}))
    said = [text.get_text() for legend in figure.legends for text in legend.get_texts()]
    assert "$μ^*$ = 0.356, which rolling through the near-collision needs" in said
    assert "$μ$ of each table" in said


def test_the_comparison_under_its_lens_turns_by_nearly_the_limit():
    one, other = outcomes({"on": "rubber,no-slip"})
    panels = side_by_side([one, other]).axes
    for line, outcome_shown in zip(panels[3].lines, (one, other), strict=True):
        limit = np.degrees(outcome_shown.limit.from_start)
        assert 0.9 * limit < np.ptp(line.get_ydata()) < limit


def test_the_comparison_of_what_topples_has_no_lens():
    start = rr.State(tilt=0.9, yaw_rate=0.01)
    assert len(side_by_side(outcomes({"start": start})).axes) == 4 + 2
