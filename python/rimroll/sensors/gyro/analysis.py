"""What a record of a gyroscope says: as an object, as plain numbers and as a figure."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from rimroll._core import __version__
from rimroll.bodies.body import Body
from rimroll.sensors.gyro.collision import Collision
from rimroll.sensors.gyro.friction import Friction, Predicted
from rimroll.sensors.gyro.passages import Axis, across
from rimroll.sensors.gyro.record import Record, Rests

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure


Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False, repr=False)
class Analysis:
    """What a record says of the near-collisions in it: see :func:`analyze`.

    Attributes
    ----------
    record, body, gravity, confidence
        What it was read from. After a strong filter, the record is the one without it.
    rests
        Where the sensor was at rest, with its bias and noise.
    axis
        The body's symmetry axis in the sensor.
    collisions
        The near-collisions that could be read, in order of time.
    predictions
        The turn that each fall has at each friction; None for those that imply no friction.
    frictions
        The friction that each veer implies. While a hand holds the body, its rim rests on the
        table; later falls may begin with a rim that slides, so they imply no friction: None stands
        for them, unless the record has no release at all.
    friction
        The friction that these veers imply together; None, as are the others, for a body without
        height, whose turn is the same at every friction.
    limits
        The limiting angles of turn, rolling without slip and sliding without friction, rad.
    notes
        What to know about it, a sentence each.
    """

    record: Record
    body: Body
    gravity: float
    confidence: float
    rests: Rests
    axis: Axis
    collisions: list[Collision]
    predictions: list[Predicted | None]
    frictions: list[Friction | None]
    friction: Friction | None
    limits: tuple[float, float]
    notes: list[str]
    filter_cutoff: float | None
    """The cut-off frequency of a filter that was recognised and taken out, Hz."""

    def __repr__(self) -> str:
        veers = ", ".join(f"{math.degrees(one.veer):.1f}°" for one in self.collisions[:6])
        return f"<Gyroscope analysis: {len(self.collisions)} near-collisions, veers {veers}>"

    def rates(self) -> Array:
        """The rates less their bias, (n, 3), rad/s: two axes across the body, and along it."""
        from rimroll.sensors.gyro.passages import across

        frame = np.stack([*across(self.axis.direction), self.axis.direction])
        turned: Array = (self.record.rates - self.rests.bias_at(self.record.t)) @ frame.T
        return turned

    def plot(self) -> Figure:
        """The record, the star of the rate across the axis, and the veers with their friction."""

        return analysis_figure(self)

    def to_dict(self) -> dict[str, Any]:
        """Everything that was read, as plain numbers: angles in degrees, rates in rad/s."""

        return summary_of(self)


_DEGREES = (
    *("turn", "veer", "veer_error", "turn_alone"),
    *("tilt_before", "tilt_after", "miss"),
)
_RATES = ("rate_before", "rate_after", "spin_before", "spin_after")


def summary_of(found: Analysis) -> dict[str, Any]:
    """Everything that was read: angles in degrees, times in s, rates in rad/s."""
    return {
        "record": found.record.name,
        "simulated": found.record.simulated,
        "read": found.record.source,
        "samples": len(found.record),
        "sampling_rate": found.record.sampling_rate,
        "rests": [list(span) for span in found.rests.spans],
        "noise": found.rests.noise,
        "filter_cutoff": found.filter_cutoff,
        "bias": found.rests.bias.mean(axis=0).tolist() if found.rests.spans else None,
        "axis": found.axis.direction.tolist(),
        "axis_error": math.degrees(found.axis.error),
        "collisions": [
            {**_of_collision(one), **_of_friction(friction)}
            for one, friction in zip(found.collisions, found.frictions, strict=True)
        ],
        **_of_friction(found.friction),
        "excludes_rolling": found.friction and found.friction.excludes_rolling,
        "excludes_sliding": found.friction and found.friction.excludes_sliding,
        "veer_limits": [math.degrees(limit) - 180.0 for limit in found.limits],
        "confidence": found.confidence,
        "gravity": found.gravity,
        "notes": found.notes,
        "rimroll_version": __version__,
    }


def _of_collision(one: Collision) -> dict[str, Any]:
    return {
        "time": one.time,
        **{name: math.degrees(getattr(one, name)) for name in _DEGREES},
        **{name: getattr(one, name) for name in _RATES},
        "energy_kept": one.energy_kept,
        "energy_kept_error": one.energy_kept_error,
        "released": one.released,
        "side_is_sure": one.side_is_sure,
        "start": one.start,
        "end": one.end,
    }


def _of_friction(one: Friction | None) -> dict[str, Any]:
    if one is None:
        return {"friction": None, "friction_interval": None}
    interval = None if one.interval is None else list(one.interval)
    return {"friction": one.best, "friction_interval": interval}


MOST_RAYS = 4
"""Near-collisions whose rays are drawn; more would hide each other."""
RAYS = ("#009E73", "#E69F00", "#CC79A7", "#56B4E9")
"""Their colours, none of them that of a limit."""
ACROSS, ALONG = "#0072B2", "#D55E00"


def analysis_figure(found: Analysis) -> Figure:
    """Draw (a) the record, (b) the star of the rate across the axis, (c) veer and friction."""
    from rimroll.figures import style

    with style.figure_style():
        figure = style.page(112.0)
        grid = figure.add_gridspec(2, 2, height_ratios=(0.7, 1.35), width_ratios=(1.0, 1.25))
        _draw_record(figure.add_subplot(grid[0, :]), found)
        star, friction = (figure.add_subplot(grid[1, column]) for column in (0, 1))
        _draw_star(star, found)
        _draw_friction(friction, found)
        return style.settle(figure)


def _draw_record(ax: Axes, found: Analysis) -> None:
    from rimroll.figures import style

    t, rates = found.record.t, found.rates()
    first, last = found.collisions[0], found.collisions[-1]
    begin = max(t[0], first.start - 1.5 * (first.end - first.start) - 0.2)
    end = min(t[-1], last.end + 0.5 * (last.end - last.start) + 0.2)
    inside = (t >= begin) & (t <= end)
    size = np.hypot(rates[inside, 0], rates[inside, 1])
    ax.plot(t[inside], size, color=ACROSS, label="across the axis")
    ax.plot(
        t[inside], rates[inside, 2], color=ALONG, ls=(0, (4, 1.5)), label="about the axis (spin)"
    )
    for i, one in enumerate(found.collisions, 1):
        ax.axvline(one.time, color=style.CONTRAST, lw=0.5, ls=(0, (1, 2)), zorder=0)
        ax.annotate(
            str(i), (one.time, max(one.rate_before, one.rate_after)), xytext=(0, 5),
            textcoords="offset points", ha="center", fontsize=6.5,
        )  # fmt: skip
    for start, stop in found.rests.spans:
        if stop > begin and start < end:
            ax.axvspan(max(start, begin), min(stop, end), color=style.CONTRAST, alpha=0.15, lw=0)
    ax.set_xlim(begin, end)
    ax.margins(y=0.15)
    ax.legend(loc="upper left", ncols=2)
    kind = "simulated record" if found.record.simulated else "record"
    title = f"{kind}: the direction of the rate jumps (rests are grey)"
    style.label(ax, "a", title, "time (s)", "angular velocity (rad/s)")


def _draw_star(ax: Axes, found: Analysis) -> None:
    from rimroll.figures import style

    t, rates = found.record.t, found.rates()
    shown = found.collisions[:MOST_RAYS]
    largest = 1.28 * max(max(one.rate_before, one.rate_after) for one in shown)
    for i, one in enumerate(shown):
        color = RAYS[i % MOST_RAYS]
        fall = (t >= one.start) & (t <= one.time)
        rise = (t >= one.time) & (t <= one.end)
        ax.plot(rates[fall, 0], rates[fall, 1], "o-", ms=1.8, lw=0.9, color=color, mfc="white")
        ax.plot(rates[rise, 0], rates[rise, 1], "o-", ms=1.8, lw=0.9, color=color)
        before, after = rates[fall][-3], rates[rise][2]
        _mark_veer(ax, before, after, i + 1, color)
    ax.plot(0.0, 0.0, "+", color=style.THEORY, ms=5)
    ax.set_aspect("equal")
    ax.set_xlim(-largest, largest)
    ax.set_ylim(-largest, largest)
    ax.text(
        0.98, 0.98, "open: falling\nfilled: rising", transform=ax.transAxes, fontsize=6.5,
        ha="right", va="top",
    )  # fmt: skip
    style.label(ax, "b", "the star: rays turn at each collision", *_axes_in_words(found))


def _axes_in_words(found: Analysis) -> tuple[str, str]:
    """What the two axes across the body are in the sensor."""
    names = []
    for direction in across(found.axis.direction):
        column = int(np.argmax(np.abs(direction)))
        sign = "" if direction[column] > 0.0 else "−"
        names.append(f"rate about the sensor's {sign}{'xyz'[column]} (rad/s)")
    return names[0], names[1]


def _mark_veer(ax: Axes, before: Array, after: Array, number: int, color: str) -> None:
    """The arc from the ray of the fall to that of the rise."""
    begin = math.atan2(before[1], before[0])
    turn = math.remainder(math.atan2(after[1], after[0]) - begin, 2.0 * math.pi)
    size = 1.12 * max(float(np.hypot(*before[:2])), float(np.hypot(*after[:2])))
    angles = begin + np.linspace(0.0, turn, 30)
    ax.plot(size * np.cos(angles), size * np.sin(angles), color=color, lw=1.4)
    middle = begin + 0.5 * turn
    ax.text(
        1.09 * size * math.cos(middle), 1.09 * size * math.sin(middle), str(number),
        ha="center", va="center", fontsize=6.5, color=color,
    )  # fmt: skip


def _draw_friction(ax: Axes, found: Analysis) -> None:
    """The turn that each friction gives, and the turns that were read."""
    from rimroll.figures import style

    used = [i for i, one in enumerate(found.collisions) if one.released]
    used = (used or [*range(len(found.collisions))])[:MOST_RAYS]
    for i in used:
        one = found.collisions[i]
        color = RAYS[i % MOST_RAYS]
        there = found.predictions[i] if found.predictions else None
        if there is not None:
            veers = np.degrees(there.turns) - 180.0
            named = f"{i + 1}: this fall at each friction"
            ax.plot(there.frictions, veers, color=color, label=named)
        veer, error = math.degrees(one.veer), math.degrees(one.veer_error)
        ax.axhspan(veer - error, veer + error, color=color, alpha=0.25, lw=0)
        ax.axhline(veer, color=color, lw=0.7)
        ax.annotate(
            f"veer {i + 1}: {veer:.1f}° ± {error:.1f}°",
            (0.99, veer), xycoords=("axes fraction", "data"), xytext=(0, 3),
            textcoords="offset points", ha="right", fontsize=6.5, color=color,
        )  # fmt: skip
    for limit, color, dashes, name in (
        (found.limits[0], style.NO_SLIP, (0, (5, 2)), "limit, rolling"),
        (found.limits[1], style.FRICTIONLESS, (0, (1, 1.2)), "limit, no friction"),
    ):
        ax.axhline(math.degrees(limit) - 180.0, color=color, ls=dashes, lw=0.9, label=name)
    together = found.friction
    most = max((float(one.frictions[-1]) for one in found.predictions if one), default=1.0)
    title = "the same at every friction" if together is None else "no friction suits"
    if together is not None and together.best is not None and together.interval is not None:
        low, high = together.interval
        ax.axvspan(low, most if high is None else high, color=style.CONTRAST, alpha=0.2, lw=0)
        end = f"{low:.3f} or more" if high is None else f"{low:.3f} to {high:.3f}"
        title = f"friction {together.best:.3f}: {end} ({100.0 * found.confidence:g} %)"
    ax.set_xlim(0.0, most)
    ax.margins(y=0.15)
    ax.legend(loc="upper center", ncols=2, bbox_to_anchor=(0.5, -0.16), columnspacing=1.2)
    style.label(ax, "c", title, "coefficient of friction", "turn beyond 180° (degrees)")
