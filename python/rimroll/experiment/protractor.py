"""A sheet to print and put under a can, to read the direction in which it falls.

The page is drawn at true size, on axes that cover it in mm from its lower left corner. Directions
are counted in degrees anticlockwise as seen from above, from 0 at the foot of the page, toward
which the body leans at first. One that rose without turning would fall at 180; one whose contact
point runs round anticlockwise by 213 degrees falls at 213, on the left of who flicks it from 0.
"""

from __future__ import annotations

import math
import textwrap
from dataclasses import dataclass
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection
from matplotlib.figure import Figure
from matplotlib.patches import Circle, Polygon, Rectangle, Wedge
from matplotlib.patheffects import withStroke

from rimroll._core import __version__
from rimroll.bodies.body import Body, one_body
from rimroll.errors import RimrollError, choose
from rimroll.figures.style import figure_style
from rimroll.laws import Frictionless, NoSlip
from rimroll.theory.closed_forms import turn_limit


@dataclass(frozen=True)
class Paper:
    """A sheet of paper and its layout, mm."""

    width: float
    height: float
    ring: float
    """Radius of the ring of degrees."""
    box: tuple[float, float]
    """The size of the box for a reading."""
    type: tuple[float, int]
    """Size of the instructions' letters, points, and how many go in a line."""

    @property
    def center(self) -> tuple[float, float]:
        """The middle of the ring."""
        return 0.5 * self.width, self.height - ABOVE - self.ring


PAPERS = {
    "a4": Paper(210.0, 297.0, 94.0, (12.0, 7.8), (7.9, 62)),
    "letter": Paper(215.9, 279.4, 88.0, (12.0, 7.0), (7.5, 68)),
}

ABOVE = 23.0  # mm, of the ring
MARGIN = 13.0  # mm, more than printers leave blank
NUMBERS = 8.0  # mm that the degrees take, inside the ring
ROWS, COLUMNS = 6, 7  # of boxes for readings: 42, as many as the paper's falls
BAR = 100.0  # mm

INK, GRAY, PALE, SHADE = "#000000", "#4d4d4d", "#b0b0b0", "#e2e2e2"
HALO = [withStroke(linewidth=2.2, foreground="white")]
BLANK = {"facecolor": "white", "edgecolor": "none", "pad": 1.2}
DASHED = (0, (3.5, 1.8))

STEPS = (
    "Tape the sheet to a level table. The paper is what it runs on; for another surface lay that"
    " on top: a glass plate, a foil.",
    "Stand it in the circle and lean it toward 0, on the marked point of its rim.",
    "Flick it toward 180. It should come back through upright, nearly slap the table and topple"
    " on the far side.",
    "Read the direction in which its top points: it lies along a radius. If it has rolled off,"
    " lay a ruler along its axis and shift that parallel to the middle.",
    "Write it down, all round from 0 to 360; falls on your left are above 180. About 40 falls"
    " make a picture. Falls that did not pass through upright do not count.",
)


def widest(paper: Paper) -> float:
    """The radius of the widest rim that leaves room on a paper, m."""
    return 1e-3 * (paper.ring - NUMBERS - 4.0)


def falls(body: Body) -> tuple[float, float]:
    """Directions of fall to one side, degrees in [0, 360): rolling without slip, and sliding.

    To the other side it falls at 360 less these. They are those of the limiting angles of turn.
    """
    rolling, sliding = (math.degrees(turn_limit(body, law)) for law in (NoSlip(), Frictionless()))
    return rolling % 360.0, sliding % 360.0


def sheet(body: Body, name: str = "", paper: str = "a4") -> Figure:
    """The page for a body, ``paper`` being ``a4`` or ``letter``.

    Save it as it is, at its own size; a tight bounding box would change the scale.

    Raises ``RimrollError`` for another paper, and for a rim too wide for it.
    """
    one_body(body)
    kind = choose("paper", paper, PAPERS)
    if body.radius > widest(kind):
        raise RimrollError(
            field="radius",
            value=1000.0 * body.radius,
            bound=f"at most {1000.0 * widest(kind):g} mm for the rim to fit on {paper} paper",
            unit="mm",
        )
    with figure_style():
        figure = Figure(figsize=(kind.width / 25.4, kind.height / 25.4))
        ax = figure.add_axes((0.0, 0.0, 1.0, 1.0), xlim=(0.0, kind.width), ylim=(0.0, kind.height))
        ax.set_axis_off()
        page = _Page(ax, kind, body)
        page.bands()
        page.rays()
        page.degrees()
        page.rim()
        page.limits()
        page.lean()
        page.flick()
        page.head(name or "your body")
        page.key()
        page.steps()
        page.boxes()
        page.foot()
    return figure


class _Page:
    """The parts of a sheet, drawn on axes in mm."""

    def __init__(self, ax: Axes, paper: Paper, body: Body) -> None:
        self.ax, self.paper, self.body = ax, paper, body
        self.center, self.ring, self.rim_radius = paper.center, paper.ring, 1e3 * body.radius
        self.inner = self.ring - NUMBERS - 2.5  # up to where rays go
        self.outside = self.inner - self.rim_radius > 29.0  # there is more room there than inside
        self.foot_of_ring = self.center[1] - self.ring

    def at(self, direction: float, radius: float) -> tuple[float, float]:
        """The point in a direction (degrees) and at a distance (mm) from the middle."""
        angle = math.radians(direction - 90.0)
        return (
            self.center[0] + radius * math.cos(angle),
            self.center[1] + radius * math.sin(angle),
        )

    def line(self, *points: tuple[float, float], **style: Any) -> None:
        x, y = zip(*points, strict=True)
        self.ax.plot(x, y, **{"color": INK, "lw": 0.5, "solid_capstyle": "butt", **style})

    def write(self, x: float, y: float, text: str, size: float = 7.5, **style: Any) -> None:
        self.ax.text(
            x,
            y,
            text,
            **{"fontsize": size, "color": INK, "linespacing": 1.35, "parse_math": False, **style},
        )

    def bands(self) -> None:
        """The directions between the two limits, on both sides; a line if the limits coincide."""
        rolling, sliding = falls(self.body)
        between = math.degrees(
            turn_limit(self.body, Frictionless()) - turn_limit(self.body, NoSlip())
        )
        start = min(15.0, 0.5 * self.rim_radius)
        for side in (1.0, -1.0):
            ends = sorted((side * rolling, side * (rolling + min(between, 360.0))))
            self.ax.add_patch(
                Wedge(
                    self.center,
                    self.inner,
                    *(end - 90.0 for end in ends),
                    width=self.inner - start,
                    facecolor=SHADE,
                    edgecolor="none",
                    zorder=0.5,
                )
            )
            for direction, dashes in ((sliding, DASHED), (rolling, "-")):
                ray = (self.at(side * direction, r) for r in (start, self.inner))
                self.line(*ray, lw=1.2, ls=dashes, zorder=1.5)

    def limits(self) -> None:
        """The limits' numbers, written along their lines, clear of the shade and each other."""
        rolling, sliding = falls(self.body)
        one = abs(sliding - rolling) < 0.05
        shown = [(rolling, -1.0, "rolling")] + [(sliding, 1.0, "sliding")] * (not one)
        end = self._end_of_labels(
            near_foot=any(math.cos(math.radians(d)) > 0.96 for d, _, _ in shown)
        )
        beside = math.degrees(2.1 / (end - 10.0))
        labels = sorted(
            (side * (limit + away * beside) % 360.0, f"{word}{' or sliding' * one} {read:.1f}°")
            for limit, away, word in shown
            for side, read in ((1.0, limit), (-1.0, 360.0 - limit))
        )
        where = _apart([direction for direction, _ in labels], 1.5 * beside)
        for direction, (_, text) in zip(where, labels, strict=True):
            self._along(direction, end, text)

    def _end_of_labels(self, near_foot: bool) -> float:
        """Distance from the middle where labels 19 mm long end, clear of the text at the foot."""
        if self.inner - self.rim_radius > 19.0:
            crowded = near_foot and self.outside and self.rim_radius > 40.0
            return self.rim_radius - 6.0 if crowded else self.inner - 1.5
        return self.rim_radius - (34.0 if near_foot else 8.0)

    def _along(self, direction: float, end: float, text: str) -> None:
        """Writes along a ray up to ``end``, readable from the foot of the page."""
        leftward = direction > 180.0
        self.write(
            *self.at(direction, end),
            text,
            6.6,
            ha="left" if leftward else "right",
            va="center",
            rotation=direction + (90.0 if leftward else -90.0),
            rotation_mode="anchor",
            path_effects=HALO,
            zorder=4.0,
        )

    def rays(self) -> None:
        """A long line every ten degrees, to lay a ruler on."""
        for direction in range(0, 360, 10):
            if direction % 90 == 0:
                ray = (self.at(direction, r) for r in (5.0, self.inner - 3.0))
                self.line(*ray, color=GRAY, zorder=1)
            else:
                ray = (self.at(direction, r) for r in (12.0, self.inner))
                self.line(*ray, color=PALE, lw=0.4, zorder=1)

    def degrees(self) -> None:
        """The ring: a tick each degree, a number each ten."""
        self.ax.add_patch(Circle(self.center, self.ring, fill=False, ec=INK, lw=0.9, gid="ring"))
        length = {0: 4.4, 5: 3.2}
        ticks = [
            [
                self.at(direction, r)
                for r in (self.ring, self.ring - length.get(direction % 10, 1.9))
            ]
            for direction in range(360)
        ]
        widths = [0.8 if direction % 10 == 0 else 0.4 for direction in range(360)]
        self.ax.add_collection(LineCollection(ticks, colors=INK, linewidths=widths, gid="ticks"))
        for direction in range(0, 360, 10):
            self._number(direction)

    def _number(self, direction: int) -> None:
        """A number on the ring, turned with it; those of the quarters large, and level."""
        style: dict[str, Any] = {"va": "center", "rotation_mode": "anchor"}
        if direction % 90 == 0:
            style |= {"size": 10.0, "weight": "bold"}
        if direction in (90, 270):
            side = "right" if direction == 90 else "left"
            self.write(*self.at(direction, self.ring - 5.4), f"{direction}", ha=side, **style)
            return
        lower = direction < 90 or direction > 270  # the other way up, for a reader at the foot
        style["rotation"] = direction if lower else direction - 180.0
        place = self.at(direction, self.ring - NUMBERS + 0.9)
        self.write(*place, f"{direction}", ha="center", **style)

    def rim(self) -> None:
        """The rim at true size, its middle and the point to lean on."""
        self.ax.add_patch(
            Circle(self.center, self.rim_radius, fill=False, ec=INK, lw=1.6, zorder=3, gid="rim")
        )
        x, y = self.center
        self.line((x - 3.0, y), (x + 3.0, y), lw=0.8, zorder=3)
        self.line((x, y - 3.0), (x, y + 3.0), lw=0.8, zorder=3)
        self.ax.add_patch(Circle(self.at(0.0, self.rim_radius), 1.4, fc=INK, ec="white", zorder=5))

    def lean(self) -> None:
        """The direction in which to lean the body, at the foot."""
        if self.outside:
            tail, words = self.rim_radius + 3.0, self.rim_radius + 15.5
        else:
            tail, words = self.rim_radius - 13.0, self.rim_radius - 22.5
        self._arrow(self.at(0.0, tail), self.at(0.0, tail + 10.0), 3.2)
        text = "lean it toward 0\non this point of its rim"
        style: dict[str, Any] = {"ha": "center", "va": "top", "bbox": BLANK, "zorder": 3.5}
        self.write(*self.at(0.0, words), text, **style)

    def flick(self) -> None:
        """The direction in which to flick it, from 0 to 180."""
        inside = self.rim_radius > 30.0
        tail = 5.0 if inside else self.rim_radius + 3.0
        head = 0.6 * self.rim_radius if inside else tail + 16.0
        self._arrow(self.at(180.0, tail), self.at(180.0, head), 6.0)
        style: dict[str, Any] = {
            "ha": "center",
            "va": "bottom",
            "weight": "bold",
            "bbox": BLANK,
            "zorder": 3.5,
        }
        self.write(*self.at(180.0, head + 2.2), "flick it toward 180", 8.5, **style)

    def _arrow(self, tail: tuple[float, float], head: tuple[float, float], width: float) -> None:
        """An upright arrow."""
        x, (low, high) = tail[0], (tail[1], head[1])
        neck = high - math.copysign(1.3 * width, high - low)
        half, shaft = 0.5 * width, 0.2 * width
        corners = [(-shaft, low), (-shaft, neck), (-half, neck), (0.0, high)]
        corners += [(-dx, y) for dx, y in reversed(corners[:-1])]
        outline = [(x + dx, y) for dx, y in corners]
        self.ax.add_patch(Polygon(outline, fc="white", ec=INK, lw=1.0, joinstyle="miter", zorder=4))

    def head(self, name: str) -> None:
        body, top = self.body, self.paper.height
        left, right = MARGIN, self.paper.width - MARGIN
        self.write(left, top - 16.5, "Which way does it fall?", 16.0, weight="bold")
        about = textwrap.wrap(name, 26, max_lines=3, placeholder="…")
        self.write(left, top - 20.5, "\n".join(about), 8.5, va="top")
        turns = [math.degrees(turn_limit(body, law)) for law in (NoSlip(), Frictionless())]
        facts = (
            f"R = {1e3 * body.radius:.3g} mm,  H = {1e3 * body.height:.3g} mm",
            "limiting angle of turn",
            f"rolling {turns[0]:.1f}°",
            f"sliding {turns[1]:.1f}°",
        )
        for row, fact in enumerate(facts):
            self.write(right, top - 15.0 - 4.0 * row, fact, 7.5, ha="right")

    def key(self) -> None:
        """The legend of shade and lines, in the corner beside the ring."""
        x, y = MARGIN, self.foot_of_ring + 10.5
        rolling, sliding = falls(self.body)
        self.line((x, y), (x, y + 4.5), lw=1.2)
        text = "expected, whether\nit rolls or slides"
        if abs(sliding - rolling) >= 0.05:
            text = "expected, between\nrolling (full line) and\nsliding (broken)"
            self.ax.add_patch(Rectangle((x, y), 9.0, 4.5, fc=SHADE, ec="none"))
            self.line((x + 9.0, y), (x + 9.0, y + 4.5), lw=1.2, ls=DASHED)
        self.write(x, y - 1.6, text, 6.4, va="top")

    def steps(self) -> None:
        """The numbered instructions beside the boxes."""
        size, letters = self.paper.type
        y = self.foot_of_ring - 7.0
        for number, step in enumerate(STEPS, 1):
            lines = textwrap.wrap(step, letters)
            self.write(MARGIN, y, f"{number}", size, weight="bold", va="top")
            self.write(MARGIN + 4.5, y, "\n".join(lines), size, va="top")
            y -= 0.478 * size * len(lines) + 1.2

    def boxes(self) -> None:
        """Boxes for readings, and lines for notes."""
        width, height = self.paper.box
        right = self.paper.width - MARGIN
        left, top = right - COLUMNS * width, self.foot_of_ring - 9.5
        self.write(left, top + 1.4, "Readings (degrees)", self.paper.type[0], weight="bold")
        for number in range(ROWS * COLUMNS):
            row, column = divmod(number, COLUMNS)
            x, y = left + column * width, top - (row + 1) * height
            self.ax.add_patch(Rectangle((x, y), width, height, fill=False, ec=GRAY, lw=0.5))
            self.write(x + 0.7, y + height - 0.7, str(number + 1), 4.6, color=GRAY, va="top")
        y = top - ROWS * height - 6.5
        for x, end, word in ((left, left + 52.0, "surface"), (left + 55.0, right, "date")):
            self.write(x, y, word, 6.6)
            self.line(
                (x + (10.5 if word == "surface" else 7.0), y - 0.4), (end, y - 0.4), color=GRAY
            )

    def foot(self) -> None:
        """The bar that checks the scale of the print, and the name of the program."""
        y = MARGIN
        self.line((MARGIN, y), (MARGIN + BAR, y), lw=1.2, gid="bar")
        for mm in range(0, int(BAR) + 1, 10):
            height = 3.0 if mm % 50 == 0 else 1.8
            self.line((MARGIN + mm, y), (MARGIN + mm, y + height), lw=0.8)
        text = "This bar is 100 mm long. If it is not, print again at actual size (100 %)."
        self.write(MARGIN, y - 1.4, text, 6.4, va="top")
        made = f"rimroll {__version__}\nafter Srinivasan & Ruina (2007)"
        self.write(
            self.paper.width - MARGIN, y - 1.4, made, 6.0, ha="right", va="center", color=GRAY
        )


def _apart(directions: list[float], least: float) -> list[float]:
    """Sorted directions (degrees), moved as little as possible to be ``least`` apart."""
    moved = np.array(directions)
    for _ in range(50):
        short = np.clip(least - np.diff(moved), 0.0, None)
        moved[:-1] -= 0.5 * short
        moved[1:] += 0.5 * short
    return [float(direction) for direction in moved]
