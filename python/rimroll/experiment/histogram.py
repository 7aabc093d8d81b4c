"""The directions of many falls, as a histogram and as seen from above."""

from __future__ import annotations

import textwrap
from collections import Counter
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from matplotlib.projections.polar import PolarAxes
from matplotlib.ticker import MaxNLocator

from rimroll import bodies
from rimroll.bodies.body import Body, body_of, one_body
from rimroll.errors import RimrollError, typed
from rimroll.experiment.toppling import counted, limits
from rimroll.figures import style
from rimroll.figures.style import directions_in_degrees
from rimroll.files.recorded import ending_in_words
from rimroll.laws import LAWS, Law, in_brief, law_of
from rimroll.many.ensemble import Array
from rimroll.many.falls import Falls
from rimroll.many.left_or_right import around, away, middle_of
from rimroll.paper.setting import MEASURED

if TYPE_CHECKING:
    import xarray as xr

WIDTHS = (0.1, 0.2, 0.5, 1.0, 2.0, 3.0, 5.0, 10.0)
"""Widths of bins, degrees: each divides 180, so that no bin has falls of both sides."""

DASHES: dict[str, Any] = {"no_slip": "-", "frictionless": (0, (4, 1.5))}
"""Line styles of the ideal limits; the limit of another law is dash-dotted."""

LETTERS = 125  # in a line across the page
TITLE_PAD = 17.0  # leaves room for the rose's 180°
ROSE_WIDTH = 2.0  # of bins seen from above, degrees: narrower ones are no more than lines
INK = "#555555"  # of small print

SERIES = tuple(color for color in style.SERIES if color != style.MEASURED)
"""Colours of several data sets, distinct from the colour of measured falls."""


@dataclass(frozen=True)
class _Falls:
    """The drawn part of one dataset: directions that count, in degrees, and their outcome."""

    label: str
    data: Falls
    directions: Array
    word: str
    color: str


@dataclass(frozen=True)
class _View:
    """The range of directions that is shown, degrees, and its bins."""

    center: float
    half: float
    width: float

    @property
    def edges(self) -> Array:
        """The edges of the bins; the center is one of them."""
        count = round(self.half / self.width)
        edges: Array = self.center + self.width * np.arange(-count, count + 1.0)
        return edges

    def turned(self, degrees: Array) -> Array:
        """Directions as angles within half a turn of the center."""
        return around(self.center, degrees)

    def count(self, falls: _Falls) -> Array:
        """The number of falls in each bin."""
        counts, _ = np.histogram(self.turned(falls.directions), self.edges)
        return counts.astype(np.float64)

    def highest(self, shown: list[_Falls]) -> float:
        """The largest number of falls in a bin, but at least 1."""
        return max(1.0, *(float(self.count(one).max()) for one in shown))


def falls_figure(
    falls: Falls | xr.Dataset | Mapping[str, Falls | xr.Dataset],
    *,
    name: str | None = None,
    measured: bool | None = None,
) -> Figure:
    """Draw the directions in which a body fell, beside the limiting angles of turn.

    Directions are in degrees, anticlockwise as seen from above, from that in which the body leaned
    at first. A hand that flicks the body away from itself stands there: 180 is straight ahead, what
    is more falls to its left. :func:`rimroll.experiment.toppling.counted` says what counts.

    Parameters
    ----------
    falls
        Of :func:`rimroll.topple` or :func:`rimroll.ensemble`; or several of one body, by name.
    name
        What the body is called; the name of the preset that it is unless given.
    measured
        Whether the means and standard deviations that the paper measured are drawn, too; unless
        given, they are for its can.

    Raises
    ------
    RimrollError
        A dataset of something else, none at all, or falls of several bodies.
    """
    # A dataset is a mapping, too.
    several = isinstance(falls, Mapping) and not hasattr(falls, "attrs")
    shown = _shown(falls if several else {"": falls})  # type: ignore[arg-type]
    body = one_body(body_of(shown[0].data))
    if any(body_of(one.data) != body for one in shown):
        raise RimrollError("falls in one figure must be those of one body")
    turns = _limits(shown)
    with_measured = body == bodies.can_2007() if measured is None else measured
    marks = _measured() if with_measured else ()
    view = _view(shown, [*_sides(turns.values()), *(mean for mean, _ in marks)])
    with style.figure_style():
        figure = style.page(88.0)
        grid = figure.add_gridspec(1, 2, width_ratios=(1.45, 1.0))
        flat = figure.add_subplot(grid[0])
        rose = figure.add_subplot(grid[1], projection="polar")
        assert isinstance(rose, PolarAxes)
        _draw_flat(flat, shown, view, turns, marks)
        _draw_rose(rose, shown, view, turns, marks)
        figure.suptitle(_title(shown, name or _name(body)), x=0.01, ha="left", size=7.5)
        handles = [*_patches(shown), *_lines(turns, shown), *_mark(marks)]
        columns = 4 if len(shown) == 1 else 3
        figure.legend(handles=handles, loc="outside lower center", ncols=columns)
        return style.settle(figure)


def _shown(several: Mapping[str, Any]) -> list[_Falls]:
    if not several:
        raise RimrollError("there are no falls to draw")
    shown = []
    for k, (label, given) in enumerate(several.items()):
        data = Falls.of(given)
        directions, word = counted(data)
        alone = law_of(data).color
        color = alone if len(several) == 1 else SERIES[k % len(SERIES)]
        shown.append(_Falls(label, data, np.degrees(directions), word, color))
    return shown


def _limits(shown: list[_Falls]) -> dict[str, float]:
    """Limiting turns by label, degrees."""
    several = len({(one.data.attrs["law"], *law_of(one.data).numbers.items()) for one in shown}) > 1
    found: dict[str, float] = {}
    for one in shown:
        for law, turn in limits(one.data).items():
            own = several and law not in DASHES
            found[one.label if own else law] = float(np.degrees(turn))
    return found


def _name(body: Body) -> str:
    names = (name for name, preset in bodies.PRESETS.items() if preset() == body)
    return next(names, "a body")


def _measured() -> tuple[tuple[float, float], ...]:
    """Means and standard deviations of the paper's falls as directions, degrees."""
    (left, left_spread), (right, right_spread) = MEASURED
    return (left, left_spread), (360.0 - right, right_spread)


def _sides(turns: Any) -> Iterator[float]:
    """Directions of turns both ways round."""
    for turn in turns:
        yield turn % 360.0
        yield -turn % 360.0


def _view(shown: list[_Falls], marks: list[float]) -> _View:
    """All falls and marks, around 180 degrees or, for disks that come back, around 0."""
    seen = np.concatenate([*(one.directions for one in shown), np.array(marks)])
    center = middle_of(seen)
    half = 10.0 * np.ceil((1.05 * float(np.abs(away(center, seen)).max()) + 3.0) / 10.0)
    return _View(center, 180.0 if half > 140.0 else half, _bin_width(shown))


def _bin_width(shown: list[_Falls]) -> float:
    """The rule of Freedman and Diaconis for the two humps, overlaid and rounded; degrees."""
    most = max(shown, key=lambda one: one.directions.size)
    if most.directions.size < 2:
        return 2.0
    folded = np.abs(away(180.0, most.directions))
    low, high = np.quantile(folded, [0.25, 0.75])
    wanted = 2.0 * (high - low) / np.cbrt(folded.size)
    return next((width for width in WIDTHS if width >= 0.8 * wanted), WIDTHS[-1])


def _draw_flat(
    ax: Axes, shown: list[_Falls], view: _View, turns: dict[str, float], marks: Any
) -> None:
    highest = view.highest(shown)
    for one in shown:
        counts = np.where(view.count(one) > 0.0, view.count(one), np.nan)
        ax.stairs(counts, view.edges, color=one.color, fill=True, alpha=_faint(shown), lw=0)
        ax.stairs(counts, view.edges, color=one.color, lw=0.8)
    for name, turn in turns.items():
        for side in view.turned(np.array(list(_sides([turn])))):
            ax.axvline(side, **_line(name, shown))
    for mean, spread in marks:
        where = float(view.turned(np.array(mean)))
        ax.errorbar(where, 1.1 * highest, xerr=spread, **_mark_style())
    ax.axvline(view.center, color=style.CONTRAST, lw=0.6, ls=":", zorder=0)
    # Falls to the left of the hand are on the left: angles grow leftward, except for falls back.
    left = view.half if view.center else -view.half
    ax.set_xlim(view.center + left, view.center - left)
    ax.set_ylim(0.0, 1.2 * highest)
    directions_in_degrees(ax.xaxis, view.half)
    ax.yaxis.set_major_locator(MaxNLocator(6, integer=True, steps=[1, 2, 5, 10]))
    if not any(one.directions.size for one in shown):
        ax.text(0.5, 0.5, "none came down", transform=ax.transAxes, ha="center", color=INK)
    _say_sides(ax)
    words = [one.word for one in shown]
    of = " or of ".join(dict.fromkeys(_OF[word] for word in words))
    x, y = f"direction of {of} (degrees)", f"falls (per {view.width:g}°)"
    style.label(ax, "a", " or ".join(dict.fromkeys(_WHERE[word] for word in words)), x, y)
    ax.set_title(ax.get_title(loc="left"), loc="left", pad=TITLE_PAD)


_WHERE = {"toppled": "where it fell", "rocked": "where it rocked up"}
_OF = {"toppled": "fall", "rocked": "the largest tilt"}


def _faint(shown: list[_Falls]) -> float:
    """The opacity of histograms."""
    return 0.35 if len(shown) == 1 else 0.2


def _say_sides(ax: Axes) -> None:
    """Which end of the axis of directions is to the left of the hand, and which to the right."""
    ends: tuple[tuple[float, str, Any], ...] = ((0.0, "← left", "left"), (1.0, "right →", "right"))
    for x, text, align in ends:
        ax.annotate(
            text,
            (x, 0.0),
            (0.0, -20.0),
            xycoords="axes fraction",
            textcoords="offset points",
            ha=align,
            va="top",
            color=INK,
        )


def _draw_rose(
    ax: PolarAxes, shown: list[_Falls], view: _View, turns: dict[str, float], marks: Any
) -> None:
    """Radii are proportional to the root of the counts, so areas are proportional to the counts."""
    view = replace(view, half=180.0, width=max(view.width, ROSE_WIDTH))
    ax.set_theta_zero_location("S")  # the hand, which flicks away from itself, is at the bottom
    highest = view.highest(shown)
    rim = float(np.sqrt(1.12 * highest))
    for name, turn in turns.items():
        for side in _sides([turn]):
            ax.plot(np.radians([side, side]), [0.0, rim], **_line(name, shown) | {"lw": 0.8})
    for one in shown:
        around = np.radians(np.repeat(view.edges, 2))
        radius = np.sqrt(np.concatenate([[0.0], np.repeat(view.count(one), 2), [0.0]]))
        ax.fill(around, radius, color=one.color, alpha=_faint(shown), lw=0)
        ax.plot(around, radius, color=one.color, lw=0.7)
    for mean, spread in marks:
        arc = np.radians(np.linspace(mean - spread, mean + spread, 21))
        ax.plot(arc, np.full(21, 1.07 * rim), color=style.MEASURED, lw=1.1, clip_on=False)
        ax.plot(np.radians(mean), 1.07 * rim, "o", ms=3, color=style.MEASURED, clip_on=False)
    ax.set_ylim(0.0, rim)
    _draw_rings(ax, view, highest)
    title = f"(b) from above; areas are numbers in {view.width:g}°"
    ax.set_title(title, loc="left", pad=TITLE_PAD)


def _draw_rings(ax: PolarAxes, view: _View, highest: float) -> None:
    """Counts and directions around the rose, where there is room."""
    ticks = MaxNLocator(3, integer=True, steps=[1, 2, 5, 10]).tick_values(0.0, highest)
    counts = [tick for tick in ticks if 0 < tick <= highest]
    ax.set_rgrids(np.sqrt(counts), [f"{tick:g}" for tick in counts], size=6.0, color=INK)
    ax.set_rlabel_position(45.0 if view.center else 135.0)
    names = {0: "0°, first lean", 90: "90°\nright", 180: "180°", 270: "270°\nleft"}
    ax.set_thetagrids(range(0, 360, 45), [names.get(angle, "") for angle in range(0, 360, 45)])
    ax.tick_params(axis="x", pad=1.0)
    ax.grid(lw=0.4, color="#CCCCCC")
    ax.spines["polar"].set_linewidth(0.6)


def _line(name: str, shown: list[_Falls]) -> dict[str, Any]:
    """The style of a law's limit: in the colour of the law, or of its falls."""
    own = {one.label: one.color for one in shown if one.label}
    ideal = style.THEORY if own or name not in LAWS else LAWS[name].color
    return {"color": own.get(name, ideal), "ls": DASHES.get(name, (0, (5, 1, 1, 1))), "lw": 1.1}


def _mark_style() -> dict[str, Any]:
    return {"fmt": "o", "ms": 3, "color": style.MEASURED, "elinewidth": 1.1, "capsize": 1.8}


def _patches(shown: list[_Falls]) -> list[Patch]:
    """The legend of several data sets."""
    if len(shown) == 1:
        return []
    return [
        Patch(fc=(one.color, 0.3), ec=one.color, lw=0.8, label=f"{one.label}, {_share(one)}")
        for one in shown
    ]


def _lines(turns: dict[str, float], shown: list[_Falls]) -> list[Line2D]:
    return [
        Line2D([], [], **_line(name, shown), label=f"{typed(name)} limit, {turn:.2f}°")
        for name, turn in turns.items()
    ]


def _mark(marks: Any) -> list[Line2D]:
    if not marks:
        return []
    (left, left_spread), (right, right_spread) = marks
    label = f"measured, {right:.1f}° ± {right_spread}° and {left:.1f}° ± {left_spread}°"
    return [Line2D([], [], color=style.MEASURED, marker="o", ms=3, lw=1.1, label=label)]


def _title(shown: list[_Falls], name: str) -> str:
    """The body, the law, the release, the number of falls and their outcomes."""
    if len(shown) > 1:
        return name
    data = shown[0].data
    lines = [f"{name}, {_law(law_of(data))}; {_outcomes(shown[0])}", *_release(data)]
    return "\n".join(line for each in lines for line in textwrap.wrap(each, LETTERS))


def _law(law: Law) -> str:
    numbers = [
        f"{name.replace('_', ' ')} {in_brief(value)}"
        for name, value in law.numbers.items()
        if value
    ]
    return ", ".join([typed(law.name), *numbers])


def _outcomes(falls: _Falls) -> str:
    counts = Counter(falls.data["outcome"].tolist()).most_common()
    counted_as = ", ".join(f"{count} {ending_in_words(str(outcome))}" for outcome, count in counts)
    return f"{falls.data.size} trials: {counted_as}"


def _share(falls: _Falls) -> str:
    return f"{falls.directions.size} of {falls.data.size} {falls.word}"


def _release(data: Falls) -> list[str]:
    """Means and spreads of the release, if there was one, in one line."""
    if "release_tilt" not in data.attrs:
        return []

    def both(name: str, factor: float = 1.0) -> str:
        mean, spread = (factor * data.attrs[f"release_{name}{end}"] for end in ("", "_spread"))
        return f"{mean:.3g} ± {spread:.2g}".replace("-", "−")

    start = f"from tilt {both('tilt', 180.0 / np.pi)}°, tilt rate {both('tilt_rate')}, sideways"
    start += f" {both('sideways')}, twist {both('twist')} rad/s"
    scatters = data.attrs["release_friction_scale_spread"] != 0.0
    friction = f"; friction scale {both('friction_scale')}" if scatters else ""
    return [f"{start}{friction}; seed {data.attrs['seed']}"]
