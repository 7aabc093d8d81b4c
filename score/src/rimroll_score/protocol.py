"""What an engine is asked to do, and how it answers: all that an adapter needs.

An adapter is a class in one small file, named as an entry point of the group ``rimroll.engines``:

    [project.entry-points."rimroll.engines"]
    my_engine = "my_engine.rimroll_adapter:MyEngine"

SI units and radians. The world's z axis points up and the table is the plane z = 0. The body is a
solid of revolution that touches the table as a cylinder of radius R and half-length H, with its
centre of mass at the centre. Its third axis is the symmetry axis.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import ClassVar, Protocol

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


class Unsupported(Exception):
    """The engine cannot be set up for a scene; the message says why."""


@dataclass(frozen=True)
class Body:
    """A round body: mass in kg, lengths in m, moments of inertia about its centre in kg m²."""

    mass: float
    radius: float
    """Radius R of the cylinder."""
    height: float
    """Half-length H of the cylinder: height of the centre of mass over the base."""
    transverse_inertia: float
    """About any axis through the centre of mass perpendicular to the symmetry axis."""
    axial_inertia: float
    """About the symmetry axis."""


@dataclass(frozen=True)
class Scene:
    """A body, a table and gravity."""

    body: Body
    friction: float
    """Coulomb's coefficient between body and table: 0 without friction, infinite without slip."""
    gravity: float = 9.8
    """Downward, m/s²."""
    table: bool = True
    """False in free flight."""
    table_acceleration: float = 0.0
    """Acceleration of the table, upward, m/s². It starts at rest; the body's state is relative.

    Only an adapter that has ``moves_table = True`` is asked for one other than 0.
    """

    @property
    def weight(self) -> float:
        """The weight per mass that the body has on the table, m/s²."""
        return self.gravity + self.table_acceleration


@dataclass(frozen=True)
class State:
    """Pose and motion of the body in the world's frame."""

    position: Array
    """The position of the centre of mass, (3,), m."""
    rotation: Array
    """Matrix (3, 3) whose columns are the body's axes; the third is the symmetry axis."""
    velocity: Array
    """The velocity of the centre of mass, (3,), m/s."""
    angular_velocity: Array
    """In the world's frame, (3,), rad/s."""


class Engine(Protocol):
    """An adapter. It is made anew, without arguments, for each run.

    It may have ``moves_table = True`` if it takes a ``table_acceleration``; if it does not, a
    sentence ``why_table_rests`` is shown in place of that check.

    It may also have ``best``, the options that its setting ``best`` consists of, and ``choices``,
    the values of each that :mod:`rimroll_score.search` tries.
    """

    settings: ClassVar[Mapping[str, str]]
    """Names of settings and a sentence on each. ``defaults`` is the engine as it comes."""
    known_versions: ClassVar[str | tuple[str, ...]]
    """The starts of the versions that the adapter was written for, as ``"3."``; empty for any."""

    def version(self) -> str:
        """The engine's version."""

    def make(self, scene: Scene, dt: float, setting: str) -> Sequence[str]:
        """Build the scene for steps of ``dt`` (s). Return the *departures*.

        A departure is a sentence on what could not be set as asked, such as an inertia that the
        engine changed, a damping that is not zero or a rim that is a polygon. Read back from the
        engine what can be read back; :func:`inertia_departures` compares.

        Raises ``Unsupported`` if the engine has no such scene.
        """

    def set_state(self, state: State) -> None:
        """Put the body there, at time 0."""

    def step(self) -> None:
        """Advance by one step."""

    def time(self) -> float:
        """The engine's time, s."""

    def state(self) -> State:
        """The body's pose and motion now, as seen from the table if that moves."""


def inertia_departures(body: Body, mass: float, principal: Sequence[float] | Array) -> list[str]:
    """Departures of the mass and principal moments (transverse, transverse, axial) as read back."""
    found = {
        "mass": (body.mass, mass, "kg"),
        "transverse inertia": (body.transverse_inertia, float(principal[0]), "kg m²"),
        "second transverse inertia": (body.transverse_inertia, float(principal[1]), "kg m²"),
        "axial inertia": (body.axial_inertia, float(principal[2]), "kg m²"),
    }
    return [
        f"{name} is {has:.9g} {unit}, not {asked:.9g} {unit}"
        for name, (asked, has, unit) in found.items()
        if not math.isclose(asked, has, rel_tol=1e-6)
    ]


def friction_departures(asked: float, found: float) -> list[str]:
    """The departure of the coefficient of friction as read back, if there is one."""
    if math.isclose(asked, found, rel_tol=1e-6):
        return []
    return [f"friction is {found:g}, not {'infinite' if math.isinf(asked) else f'{asked:g}'}"]


def loss_departures(**found: float) -> list[str]:
    """Departures of what must be zero so that nothing is lost, such as ``linear_damping``."""
    return [f"{name.replace('_', ' ')} is {v:g}, not 0" for name, v in found.items() if v]


def quaternion(rotation: Array) -> Array:
    """The unit quaternion (w, x, y, z) of a rotation matrix."""
    r = np.asarray(rotation, float)
    # The largest of the four components is found first.
    four = np.array(
        [
            1.0 + r[0, 0] + r[1, 1] + r[2, 2],
            1.0 + r[0, 0] - r[1, 1] - r[2, 2],
            1.0 - r[0, 0] + r[1, 1] - r[2, 2],
            1.0 - r[0, 0] - r[1, 1] + r[2, 2],
        ]
    )
    antisymmetric = [r[2, 1] - r[1, 2], r[0, 2] - r[2, 0], r[1, 0] - r[0, 1]]
    products = np.diag(four)
    for i in range(3):
        products[0, i + 1] = products[i + 1, 0] = antisymmetric[i]
    for i, j in ((0, 1), (0, 2), (1, 2)):
        products[i + 1, j + 1] = products[j + 1, i + 1] = r[i, j] + r[j, i]
    row = products[int(np.argmax(four))]
    return np.asarray(row / np.linalg.norm(row))


def rotation_matrix(wxyz: Sequence[float] | Array) -> Array:
    """The rotation matrix of a quaternion (w, x, y, z), which need not have unit length."""
    w, x, y, z = np.asarray(wxyz, float) / np.linalg.norm(np.asarray(wxyz, float))
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
        ]
    )
