"""The figures of the report, in its order; one file each."""

from __future__ import annotations

from collections.abc import Callable

from rimroll.paper.drawing import Drawing
from rimroll.paper.figures import (
    contact_path,
    convergence,
    disks_against_friction,
    falling,
    falls,
    friction,
    height,
    imperfection,
    pasted,
    sensitivity,
    simulation,
    small_angle,
    turn_against_friction,
)

FIGURES: tuple[Callable[[], Drawing], ...] = (
    falling.draw,
    simulation.draw,
    simulation.draw_frictionless,
    convergence.draw,
    height.draw,
    friction.draw,
    turn_against_friction.draw,
    disks_against_friction.draw,
    sensitivity.draw,
    falls.draw,
    pasted.draw,
    small_angle.draw,
    contact_path.draw,
    imperfection.draw,
)
