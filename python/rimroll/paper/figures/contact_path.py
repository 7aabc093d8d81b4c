"""Paths of the contact point on the table: circular, petaloid, cusped, and near a collision."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache

import numpy as np
from matplotlib.axes import Axes

from rimroll.figures import style
from rimroll.laws import Frictionless, NoSlip
from rimroll.motion import Array, Moments, Motion, simulate
from rimroll.paper import setting
from rimroll.paper.drawing import Drawing
from rimroll.state import State
from rimroll.theory.steady import steady_wobble_rate

TILT = np.radians(20.0)
"""Tilt from which the can of the first five panels is released, rad."""


@dataclass(frozen=True)
class Path:
    """A motion whose path is drawn, and the panel's title."""

    name: str
    note: str
    motion: Motion

    def moments(self) -> Moments:
        """Dense in time and dense where the contact point runs."""
        even = np.linspace(0.0, float(self.motion.t[-1]), 1200)
        return self.motion.evaluate(np.union1d(even, self.motion.samples(6).t))


def wobble(yaw_rate: float, spin_ratio: float | None = None, duration: float = 2.0) -> Motion:
    """The can released at rest in tilt, with ``yaw_rate`` in units of the steady wobble's.

    ``spin_ratio`` is dθ/dt over dψ/dt; that of the steady wobble, H sin φ/R − cos φ, if not given.
    """
    can = setting.CAN
    steady = can.height / can.radius * np.sin(TILT) - np.cos(TILT)
    rate = yaw_rate * steady_wobble_rate(can, TILT, setting.GRAVITY)
    spin_rate = rate * (steady if spin_ratio is None else spin_ratio)
    start = State(tilt=TILT, yaw_rate=rate, spin_rate=spin_rate)
    return simulate(can, start, NoSlip(), duration, gravity=setting.GRAVITY)


@cache
def paths() -> tuple[Path, ...]:
    """The paths of the panels, in order."""
    near = [
        Path(
            "near-collision",
            f"{setting.LAW_NAMES[law.name]}, $ε$ = {sideways} rad/s",
            setting.motion(law, sideways, 3.0),
        )
        for law, sideways in ((NoSlip(), 0.5), (NoSlip(), 0.005), (Frictionless(), 0.005))
    ]
    return (
        Path("circular", "steady wobble", wobble(1.0)),
        Path("circular, drifting", "9/10 of its rates", wobble(0.9, duration=1.2)),
        Path("petaloid", "d$θ$/d$t$ < 0 throughout", wobble(0.6, -0.25, 2.8)),
        Path("petaloid to cusped", "d$θ$/d$t$ = 0 at the tips", wobble(0.4, 0.0, 1.75)),
        Path("cusped", "d$θ$/d$t$ > 0 at the tips", wobble(0.2, 1.0, 1.9)),
        *near,
    )


def draw() -> Drawing:
    """Eight paths to one scale."""
    with style.figure_style():
        figure = style.page(104.0)
        panels = figure.subplots(2, 4, sharex=True, sharey=True)
        for ax, letter, path in zip(panels.flat, "abcdefgh", paths(), strict=True):
            _draw_path(ax, letter, path)
        for ax in panels[0]:
            ax.set_xlabel("")
        for ax in panels[:, 1:].flat:
            ax.set_ylabel("")
        panels[0, 0].legend(loc="lower left", handletextpad=0.1)
        style.settle(figure)
    return Drawing("contact_path", "Paths of the contact point", figure, _caption(), _numbers())


def _draw_path(ax: Axes, letter: str, path: Path) -> None:
    points = 100.0 * path.moments().contact_path
    middle = 0.5 * (points.min(axis=0) + points.max(axis=0))
    points = points - middle
    ax.plot(*points.T, color=path.motion.law.color, lw=0.9)
    highest = _highest(path.motion)
    if len(highest):
        tips = 100.0 * path.motion.evaluate(highest).contact_path - middle
        ax.plot(*tips.T, "o", color=style.THEORY, ms=2.4, zorder=3)
    ax.plot([], [], "o", color=style.THEORY, ms=2.4, label="tilt maximum")
    ax.plot(*points[0], "o", color=style.THEORY, mfc="white", ms=4.2, zorder=4, label="release")
    style.label(ax, letter, path.name, "$x$ (cm)", "$y$ (cm)")
    ax.text(0.5, 0.985, path.note, transform=ax.transAxes, ha="center", va="top", size=6.8)
    ax.set_aspect("equal")
    ax.set_xticks((-5.0, 0.0, 5.0))
    ax.set_yticks((-5.0, 0.0, 5.0))
    ax.set_xlim(-9.3, 9.3)
    ax.set_ylim(-9.3, 10.7)


def _highest(motion: Motion) -> Array:
    """Times of the tilt maxima; none of a steady wobble, whose tilt does not change."""
    steady = np.ptp(motion.tilt) < 1e-6
    times = [] if steady else [event.t for event in motion.events if event.kind == "tilt_max"]
    return np.array(times, dtype=np.float64)


def _caption() -> str:
    rolling, sliding = (np.degrees(paths()[k].motion.turns[1].angle) for k in (6, 7))
    needed = [path.motion.samples(4).friction_ratio.max() for path in paths()]
    return (
        "The contact point’s path on the table, all to one scale. Released at a tilt of "
        f"{np.degrees(TILT):.0f}° with the rates of its steady wobble and with others (a–e, "
        f"needing friction up to {max(needed[:5]):.2f}), the can draws circles, petals, and cusps "
        "where the rolling reverses, dθ/dt = 0: the shapes that Collins, Hall and Hogan "
        '(<a href="https://arxiv.org/abs/2302.08335">arXiv 2302.08335</a>) call circular, petaloid '
        "and cusped. From the paper’s start (f, g) the cusps close up: the can stands still on one "
        "point of a circle as large as its rim, then on another "
        f"{abs(rolling):.1f}° further. Without friction (h) the contact slides in and out and runs "
        f"round in between, {abs(sliding):.1f}° at a time."
    )


def _numbers() -> dict[str, object]:
    return {
        f"{letter}: {path.name}, {path.motion.law.name}": {
            "yaw_rate": path.motion.start.yaw_rate,
            "spin_rate": path.motion.start.spin_rate,
            "min_tilt": float(path.motion.tilt.min()),
            "max_tilt": float(path.motion.tilt.max()),
            "needed_friction": float(path.motion.samples(4).friction_ratio.max()),
        }
        for letter, path in zip("abcdefgh", paths(), strict=True)
    }
