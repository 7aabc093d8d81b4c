"""What is measured on a motion that an engine computed.

The angle error depends on the case:

* ``turn``: of the change of yaw from the release to the highest tilt after the near-collision;
* ``axis``: the angle between the symmetry axis at the end and its true direction;
* ``place``: the distance of the centre of mass at the end from its true place, divided by R: the
  angle by which the disk has rolled too far or not far enough.

The energy error is that of the fraction of the energy that is lost up to that moment. Energy counts
from the body at rest on its base; in free flight, the potential energy from the start.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from rimroll_score.cases import Case
from rimroll_score.euler import tilt_of, wrapped, yaw_of
from rimroll_score.protocol import Body, Scene
from rimroll_score.samples import Samples

Array = NDArray[np.float64]

FLAT = math.radians(2.0)
"""A body that does not rise above this tilt again has lain down."""


@dataclass(frozen=True)
class Measured:
    """The measures of a motion."""

    angle_error: float | None
    """Degrees, signed for turns; None where the body lay down flat instead of rising."""
    right_side: bool | None
    """Whether the body rose on the true side of the line straight across; None for no turn."""
    energy_error: float
    """Error of the change of energy, as a fraction of the initial energy: gained if above 0."""
    slip: float | None
    """Path that the contact point slips, m; None where it may slip."""
    penetration: float | None
    """Deepest point of the rim below the table, m; None in free flight."""
    note: str = ""


def measured(case: Case, samples: Samples) -> Measured:
    """Compare a motion with the truth of its case."""
    scene = case.scene
    at = _top(case, samples) if case.measure == "turn" else len(samples.time) - 1
    energy = energies(scene, samples)
    energy_error = (energy[at] - energy[0]) / energy[0] + case.truth["energy_lost"]
    right_side, note, error = None, "", None
    if case.measure != "turn":
        error = _axis_error(case, samples) if case.measure == "axis" else _lag(case, samples)
    elif tilt_of(samples.axis[at]) < FLAT:
        note, right_side = "lay down flat", False
    else:
        turned = float(yaw_of(samples.axis[at]) - yaw_of(samples.axis[0]))
        true = math.radians(case.truth["turn"])
        error = math.degrees(wrapped(turned - true))
        right_side = wrapped(turned - math.pi) * wrapped(true - math.pi) > 0.0
    slip = slipped(scene.body, samples) if scene.table and math.isinf(scene.friction) else None
    depth = float(-lowest(scene.body, samples).min()) if scene.table else None
    return Measured(error, right_side, float(energy_error), slip, depth, note)


def _top(case: Case, samples: Samples) -> int:
    """The sample of the highest tilt in the rise after the first near-collision."""
    tilt, truth = tilt_of(samples.axis), case.truth
    down, up = truth["time_of_smallest_tilt"], truth["time_of_largest_tilt"]
    falling = samples.time < 0.5 * (down + up)
    low = int(np.argmin(np.where(falling, tilt, np.inf)))
    # Without dissipation the next rise begins only after twice this time.
    rising = samples.time <= samples.time[low] + 1.3 * (up - down)
    rising[:low] = False
    return int(np.argmax(np.where(rising, tilt, -np.inf)))


def _at_end(case: Case, samples: Samples, values: Array) -> Array:
    """Values (n, 3) at the end of the case, which may lie before the last sample."""
    (end,) = np.array([case.duration])
    return np.array([np.interp(end, samples.time, values[:, i]) for i in range(3)])


def _axis_error(case: Case, samples: Samples) -> float:
    """The angle between the axis at the end and the true one, degrees."""
    found, true = _at_end(case, samples, samples.axis), np.array(case.truth["axis"])
    sine = float(np.linalg.norm(np.cross(found, true)))
    return math.degrees(math.atan2(sine, float(found @ true)))


def _lag(case: Case, samples: Samples) -> float:
    """The distance from the true place, divided by the radius, in degrees."""
    off = _at_end(case, samples, samples.position) - np.array(case.truth["position"])
    return math.degrees(float(np.linalg.norm(off)) / case.scene.body.radius)


def energies(scene: Scene, samples: Samples) -> Array:
    """The energy of the body, (n,), J."""
    body = scene.body
    about_axis = np.einsum("ni,ni->n", samples.axis, samples.angular_velocity)
    squared = np.einsum("ni,ni->n", samples.angular_velocity, samples.angular_velocity)
    speed = np.einsum("ni,ni->n", samples.velocity, samples.velocity)
    twice = (
        body.mass * speed
        + body.transverse_inertia * (squared - about_axis**2)
        + body.axial_inertia * about_axis**2
    )
    ground = body.height if scene.table else samples.position[0, 2]
    height = samples.position[:, 2] - ground
    return np.asarray(0.5 * twice + body.mass * scene.weight * height)


def _to_rim(body: Body, samples: Samples) -> Array:
    """From the centre of mass to the lowest point of the rim that is below it, (n, 3)."""
    axis = samples.axis
    up = np.where(axis[:, 2] >= 0.0, 1.0, -1.0)[:, None]
    outward = np.array([0.0, 0.0, 1.0]) - axis[:, 2:] * axis
    length = np.linalg.norm(outward, axis=1)[:, None]
    outward = np.divide(outward, length, out=np.zeros_like(outward), where=length > 1e-12)
    return np.asarray(-body.radius * outward - body.height * up * axis)


def lowest(body: Body, samples: Samples) -> Array:
    """Height of the lowest point of the rim over the table, (n,), m."""
    return np.asarray(samples.position[:, 2] + _to_rim(body, samples)[:, 2])


def slipped(body: Body, samples: Samples) -> float:
    """The path that the material point at the contact slips over the table, m."""
    velocity = samples.velocity + np.cross(samples.angular_velocity, _to_rim(body, samples))
    speed = np.hypot(velocity[:, 0], velocity[:, 1])
    return float(np.trapezoid(speed, samples.time))
