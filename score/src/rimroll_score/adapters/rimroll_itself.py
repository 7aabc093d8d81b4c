"""rimroll itself, by the interface that every engine has.

rimroll chooses its own steps: a step here advances a clock, and the motion is computed in the first
step, for two seconds, longer than any case takes. It has no free flight of a body that was thrown.
"""

from __future__ import annotations

import math
from typing import Any, ClassVar

import numpy as np

import rimroll as rr
from rimroll_score.euler import frame
from rimroll_score.protocol import Scene, State, Unsupported

LONGEST = 2.0
"""s"""


class Rimroll:
    """``rimroll.simulate`` as an engine."""

    settings: ClassVar = {
        "defaults": "the default tolerance",
        "best": "relative tolerance 1e-12",
    }
    known_versions = "0."
    moves_table = True

    def version(self) -> str:
        return rr.__version__

    def make(self, scene: Scene, dt: float, setting: str) -> list[str]:
        if not scene.table:
            raise Unsupported("rimroll has no free flight without a table")
        body = scene.body
        self._body = rr.Body(
            mass=body.mass, radius=body.radius, height=body.height,
            transverse_inertia=body.transverse_inertia, axial_inertia=body.axial_inertia,
        )  # fmt: skip
        self._law: rr.Law = rr.NoSlip()
        if math.isfinite(scene.friction):
            self._law = rr.Coulomb(scene.friction) if scene.friction else rr.Frictionless()
        self._scene, self._dt, self._steps = scene, dt, 0
        self._options: dict[str, Any] = {"rtol": 1e-12} if setting == "best" else {}
        if scene.table_acceleration:
            rise = [0.0, 0.0, scene.table_acceleration]
            self._options["ground"] = rr.ground.sampled(LONGEST, [rise, rise])
        return []

    def set_state(self, state: State) -> None:
        axis = state.rotation[:, 2]
        tilt = math.atan2(math.hypot(axis[0], axis[1]), axis[2])
        yaw = math.atan2(-axis[1], -axis[0])
        level = np.array([math.cos(yaw), math.sin(yaw), 0.0])
        across = np.array([-math.sin(yaw), math.cos(yaw), 0.0])
        tilted = math.cos(tilt) * level + math.sin(tilt) * np.array([0.0, 0.0, 1.0])
        first = state.rotation[:, 0]
        yaw_rate = float(state.angular_velocity @ tilted) / math.sin(tilt)
        if self._body.height and abs(axis[2]) < 1e-9:
            raise Unsupported("rimroll's body has one rim and cannot stand on its side")
        angles = rr.State(
            tilt=tilt, tilt_rate=-float(state.angular_velocity @ across),
            yaw=yaw, yaw_rate=yaw_rate, spin=math.atan2(first @ across, first @ tilted),
            spin_rate=float(state.angular_velocity @ axis) - yaw_rate * math.cos(tilt),
        )  # fmt: skip
        self._start, self._angles, self._steps = state, angles, 0
        self._motion: rr.Motion | None = None

    def step(self) -> None:
        if self._motion is None:  # here, where its time counts
            self._motion = rr.simulate(
                self._body, self._angles, self._law, gravity=self._scene.gravity, duration=LONGEST,
                **self._options,
            )  # fmt: skip
            self._moved = self._start.position - self._motion.center[0]
        self._steps += 1

    def time(self) -> float:
        return self._steps * self._dt

    def state(self) -> State:
        if self._motion is None:
            return self._start
        t = min(self.time(), float(self._motion.t[-1]))
        now = self._motion.evaluate(np.array([t]))
        c, s = math.cos(now.spin[0]), math.sin(now.spin[0])
        axes = frame(float(now.tilt[0]), float(now.yaw[0]))
        turning = (
            now.yaw_rate[0] * np.array([0.0, 0.0, 1.0])
            - now.tilt_rate[0] * axes[:, 1]
            + now.spin_rate[0] * axes[:, 2]
        )
        above = self._body.radius * axes[:, 0] + self._body.height * axes[:, 2]
        velocity = np.cross(turning, above) + np.array([*now.slip[0], 0.0])
        spun = axes @ np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])
        return State(now.center[0] + self._moved, spun, velocity, turning)
