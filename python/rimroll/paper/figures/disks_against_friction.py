"""Disks and friction: the step of the near-collision does not depend on it, the whole turn does."""

from __future__ import annotations

from functools import cache

import numpy as np
from matplotlib.axes import Axes

from rimroll import bodies
from rimroll.bodies.body import Body
from rimroll.figures import style
from rimroll.laws import Coulomb, Frictionless, Law, NoSlip, Stribeck, Viscous
from rimroll.motion import Array, Motion, simulate
from rimroll.paper import setting
from rimroll.paper.drawing import Drawing, Table
from rimroll.paper.figures.turn_against_friction import STARTS, Start, measured_step
from rimroll.theory.closed_forms import arrival, disk_turn_limit, turn_limit

RADIUS = setting.CAN.radius

DISKS: dict[str, tuple[Body, float]] = {
    "uniform disk": (bodies.disk(RADIUS), 0.5**0.5),
    "ring": (bodies.ring(RADIUS), 1.0),
}
"""As wide as the can, each with its k."""

FRICTIONS = np.concatenate([np.linspace(0.0, 0.2, 17), np.linspace(0.25, 1.0, 16)])
"""Below 1.118, above which a sliding disk can meet Painlevé's paradox."""

MARKED = np.linspace(0.0, 1.0, 6)

CLOSE = 1e-4
"""Sideways rates ε of the whole motions, rad/s."""

LAWS: tuple[Law, ...] = (
    NoSlip(),
    Frictionless(),
    *(Coulomb(friction) for friction in (0.1, 0.3, 0.8)),
    Viscous(0.1),
    Stribeck(0.3),
)


def limit(disk: str) -> float:
    """π √(2 + k²)/k, degrees."""
    return float(np.degrees(disk_turn_limit(DISKS[disk][1])))


def step(disk: str, law: Law, start: Start) -> float:
    """Limiting turn of the near-collision as it comes down from the start, degrees."""
    body, _ = DISKS[disk]
    arriving = arrival(body, start.state(), law, setting.GRAVITY)
    return float(np.degrees(turn_limit(body, law, arriving)))


@cache
def motion(disk: str, friction: float, start: Start) -> Motion:
    """The whole motion, with the first tilt maximum in it."""
    law = Coulomb(friction)
    return simulate(DISKS[disk][0], start.state(CLOSE), law, 0.4, gravity=setting.GRAVITY)


def whole_turn(disk: str, friction: float, start: Start) -> float:
    """Turn from the release to the next tilt maximum, degrees."""
    return float(np.degrees(abs(motion(disk, friction, start).turns[0].angle)))


@cache
def whole_turns(disk: str, start: Start) -> Array:
    """Whole turns at :data:`FRICTIONS`, degrees."""
    return np.array([whole_turn(disk, float(friction), start) for friction in FRICTIONS])


@cache
def spread_of_the_step() -> float:
    """The largest difference of the step from its closed form, under all laws, degrees."""
    return max(
        abs(step(disk, law, start) - limit(disk))
        for disk in DISKS
        for law in LAWS
        for start in STARTS
    )


def draw() -> Drawing:
    """The disk and the ring: the step of the near-collision, and turns to the tilt maximum."""
    with style.figure_style():
        figure = style.page(72.0)
        for ax, letter, disk in zip(figure.subplots(1, 2), "ab", DISKS, strict=True):
            _draw_disk(ax, letter, disk)
        style.settle(figure)
    return Drawing(
        "disks_against_friction",
        "Disks against friction",
        figure,
        _caption(),
        _numbers(),
        _table(),
    )


def _draw_disk(ax: Axes, letter: str, disk: str) -> None:
    value = limit(disk)
    ax.axhline(value, color=style.THEORY, lw=0.9, zorder=1, label="π√(2+$k$²)/$k$")
    for start, size in zip(STARTS, (5.0, 3.0), strict=True):
        steps = [measured_step(motion(disk, float(friction), start)) for friction in MARKED]
        name = f"{start.name}: near-collision alone"
        ax.plot(MARKED, steps, ms=size, clip_on=False, zorder=3, label=name, **start.marks)
    for start in STARTS:
        name = f"{start.name}: to the next tilt maximum"
        turns = whole_turns(disk, start)
        ax.plot(FRICTIONS, turns, color=start.color, ls=start.dashes, label=name)
    style.label(ax, letter, disk, "friction $μ$ (1)", "angle of turn (degrees)")
    ax.set_xlim(0.0, 1.0)
    ax.set_ylim(value - 4.4, value + 5.0)
    if letter == "a":
        ax.legend(loc="upper right")


def _caption() -> str:
    disk = whole_turn("uniform disk", 0.8, STARTS[0])
    return (
        "The paper finds the turn of disks independent of the law of friction and its magnitude. "
        "For the near-collision this is exact: π√(2+k²)/k under every law in the table, to "
        f"{spread_of_the_step():.0e} degrees. In whole motions (Coulomb; points, ε = "
        f"{style.power_of_ten(CLOSE)} rad/s) the same step is found, but a disk that slides on its "
        "way down enters the near-collision with slip and leaves it with spin and slip, which turn "
        "it further as it rises: to the next tilt maximum (dashed) the uniform disk released at "
        f"{STARTS[0].name} turns by {limit('uniform disk'):.2f}° without friction and by "
        f"{disk:.2f}° at μ = 0.8."
    ).replace("e-", "e−")


def _numbers() -> dict[str, object]:
    return {
        "friction": FRICTIONS,
        "largest_difference_of_the_step_degrees": spread_of_the_step(),
        **{
            disk: {
                "limit_degrees": limit(disk),
                "whole_turn_degrees": {one.name: whole_turns(disk, one) for one in STARTS},
            }
            for disk in DISKS
        },
    }


def _table() -> Table:
    rocked = STARTS[0]
    head = ["law", *(f"{disk} (degrees)" for disk in DISKS)]
    rows = [[_name(law), *(f"{step(disk, law, rocked):.6f}" for disk in DISKS)] for law in LAWS]
    text = (
        f"The near-collision alone, ε → 0, as the disk comes down when released at {rocked.name}."
    )
    return Table(text, head, rows)


def _name(law: Law) -> str:
    if isinstance(law, NoSlip | Frictionless):
        return setting.LAW_NAMES[law.name]
    if isinstance(law, Viscous):
        return f"viscous, {law.coefficient:g} N s/m"
    assert isinstance(law, Coulomb | Stribeck)
    return f"{type(law).__name__}, μ = {law.friction:g}"
