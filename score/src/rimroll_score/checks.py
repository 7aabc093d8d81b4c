"""Checks that need no truth: changes of a scene that change nothing, but for an engine's errors.

The case ``rolling_near`` is run again with another heading, with the body turned about its own
axis, mirrored, with half the step, four times as large and twice as slow, and on a table that
accelerates upward at half of gravity in place of that half.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from rimroll_score.cases import Case
from rimroll_score.protocol import Body, State
from rimroll_score.sweep import run
from rimroll_score.worker import Worker

MIRROR = np.diag([1.0, -1.0, 1.0])
ANGLES = (37.0, 90.0, 211.0)
"""Degrees."""
SCALE = 4.0
"""The factor on lengths; that on times is its square root."""


@dataclass(frozen=True)
class Check:
    """How far an engine's answer moved under a change that should not move it."""

    name: str
    setting: str
    dt: float
    angle: float | None
    """Largest change of the turn, degrees; None where a run had no turn."""
    energy: float | None
    """Largest change of the lost fraction of the energy."""
    note: str = ""
    """Why the engine does not have the changed scene, if so."""


def check(worker: Worker, case: Case, dt: float, setting: str) -> list[Check]:
    """All checks of a case that measures a turn."""
    plain = run(worker, case, dt, setting)
    found = []
    for name, varied in variants(case, dt):
        runs = [run(worker, other, step, setting) for other, step in varied]
        sign = -1.0 if name == "mirror" else 1.0  # a mirror turns errors round, too
        off = [_wrapped(sign * one.error_or_nan - plain.error_or_nan) for one in runs]
        angle = float(np.max(off))
        energy = float(np.max([abs(one.energy_or_nan - plain.energy_or_nan) for one in runs]))
        lacking = [one.message for one in runs if one.status == "unsupported"]
        note = lacking[0] if lacking else ""
        found.append(Check(name, setting, dt, _known(angle), _known(energy), note))
    return found


def variants(case: Case, dt: float) -> Iterator[tuple[str, list[tuple[Case, float]]]]:
    """The changed cases and their steps, by name."""
    yield "heading", [(replace(case, state=headed(case.state, a)), dt) for a in ANGLES]
    yield "spin", [(replace(case, state=spun(case.state, a)), dt) for a in ANGLES]
    opposite = {**case.truth, "turn": -case.truth["turn"]}
    yield "mirror", [(replace(case, state=mirrored(case.state), truth=opposite), dt)]
    yield "half_step", [(case, 0.5 * dt)]
    yield "scale", [(scaled(case), math.sqrt(SCALE) * dt)]
    yield "table", [(lifted(case), dt)]


def about_z(degrees: float) -> NDArray[np.float64]:
    """The rotation by an angle about the third axis."""
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    return np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])


def headed(state: State, degrees: float) -> State:
    """The state, turned about the vertical."""
    turn = about_z(degrees)
    return State(
        turn @ state.position, turn @ state.rotation,
        turn @ state.velocity, turn @ state.angular_velocity,
    )  # fmt: skip


def spun(state: State, degrees: float) -> State:
    """The state, with the body turned about its symmetry axis."""
    return replace(state, rotation=state.rotation @ about_z(degrees))


def mirrored(state: State) -> State:
    """The state in a mirror that stands on the line of the lean."""
    return State(
        MIRROR @ state.position, MIRROR @ state.rotation @ MIRROR,
        MIRROR @ state.velocity, -MIRROR @ state.angular_velocity,
    )  # fmt: skip


def scaled(case: Case) -> Case:
    """The case with lengths times ``SCALE`` and times times its square root; gravity is kept."""
    body, slow, state = case.scene.body, math.sqrt(SCALE), case.state
    large = Body(
        body.mass, SCALE * body.radius, SCALE * body.height,
        SCALE**2 * body.transverse_inertia, SCALE**2 * body.axial_inertia,
    )  # fmt: skip
    times = ("time_of_smallest_tilt", "time_of_largest_tilt")
    return replace(
        case,
        scene=replace(case.scene, body=large),
        state=State(
            SCALE * state.position, state.rotation,
            SCALE / slow * state.velocity, state.angular_velocity / slow,
        ),
        duration=slow * case.duration,
        truth={**case.truth, **{name: slow * case.truth[name] for name in times}},
    )  # fmt: skip


def lifted(case: Case) -> Case:
    """The case with half of gravity, on a table that accelerates upward at the other half."""
    half = 0.5 * case.scene.gravity
    return replace(case, scene=replace(case.scene, gravity=half, table_acceleration=half))


def _known(value: float) -> float | None:
    return None if math.isnan(value) else value


def _wrapped(degrees: float) -> float:
    return abs((degrees + 180.0) % 360.0 - 180.0)
