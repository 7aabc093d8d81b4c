"""Newton, on the processor by Warp, in single precision.

A step costs milliseconds however small the scene is, since it starts many small kernels.
"""

from __future__ import annotations

from importlib.metadata import version
from typing import Any, ClassVar

import newton
import numpy as np
import warp

from rimroll_score.protocol import (
    Scene,
    State,
    friction_departures,
    inertia_departures,
    quaternion,
    rotation_matrix,
)


class Newton:
    """A free body with a cylinder over the ground plane."""

    settings: ClassVar = {
        "defaults": "SolverXPBD as it comes, with contacts found in every step",
        "best": "SolverMuJoCo (MuJoCo Warp): elliptic cone, impratio 100, contact as stiff as "
        "the step allows (2 dt), solimp 0.99 to 0.9999",
    }
    known_versions = "1."
    why_table_rests = "the ground plane of Newton belongs to the world and does not move"

    def version(self) -> str:
        return version("newton")

    compiled: ClassVar[set[tuple[str, bool]]] = set()
    """Settings and kinds of scene whose kernels were compiled or loaded in this process."""

    def make(self, scene: Scene, dt: float, setting: str) -> list[str]:
        warp.config.quiet = True
        kind = (setting, scene.table)
        if kind not in self.compiled:  # by a step, which is not to count as the engine's work
            self.compiled.add(kind)
            self.make(scene, dt, setting)
            height = np.array([0.0, 0.0, scene.body.height])
            self.set_state(State(height, np.eye(3), np.zeros(3), np.zeros(3)))
            self.step()
        body, best, friction = scene.body, setting == "best", min(scene.friction, 1.0)
        self._dt, self._steps = dt, 0
        with warp.ScopedDevice("cpu"):
            self._model: Any = self._built(scene, friction, best)
            self._solver: Any = newton.solvers.SolverXPBD(self._model)
            if best:
                self._solver = newton.solvers.SolverMuJoCo(
                    self._model, cone="elliptic", impratio=100.0, integrator="implicitfast",
                    iterations=100, tolerance=1e-8,
                )  # fmt: skip
            self._now, self._next = self._model.state(), self._model.state()
            self._control = self._model.control()
            self._pipeline = None if best else newton.CollisionPipeline(self._model)
            self._contacts = self._pipeline.contacts() if self._pipeline else None
        moments = np.diag(self._model.body_inertia.numpy()[0])
        departures = inertia_departures(body, float(self._model.body_mass.numpy()[0]), moments)
        departures.append("arithmetic is in single precision")
        if scene.table:
            found = self._model.shape_material_mu.numpy()
            departures += friction_departures(scene.friction, float(np.mean(found)))
            if best:
                departures.append("contacts are soft: they never touch without overlap")
        return departures

    def _built(self, scene: Scene, friction: float, best: bool) -> Any:
        """The model of Newton."""
        body = scene.body
        builder = newton.ModelBuilder(gravity=(0.0, 0.0, -scene.gravity), up_axis="Z")
        if best:
            newton.solvers.SolverMuJoCo.register_custom_attributes(builder)
        moments = [body.transverse_inertia, body.transverse_inertia, body.axial_inertia]
        rigid = builder.add_body(
            mass=body.mass, com=(0.0, 0.0, 0.0), inertia=np.diag(moments), lock_inertia=True
        )
        known = newton.ModelBuilder.ShapeConfig(
            density=0.0, mu=friction, mu_torsional=0.0, mu_rolling=0.0
        )
        extra: dict[str, Any] = {}
        if best:
            impedance = [0.99, 0.9999, 1e-6, 0.5, 2.0]
            extra["custom_attributes"] = {"mujoco:geom_solimp": impedance}
            # As SolverMuJoCo turns them into a time constant of 2 dt and a damping ratio of 1.
            time = 2.0 * self._dt
            known.ke, known.kd = 1.0 / time**2, 2.0 / time
        builder.add_shape_cylinder(
            rigid, radius=body.radius, half_height=body.height, cfg=known, **extra
        )
        if scene.table:
            builder.add_ground_plane(cfg=known)
        return builder.finalize(device="cpu")

    def set_state(self, state: State) -> None:
        w, x, y, z = quaternion(state.rotation)
        self._now.joint_q.assign([*state.position, x, y, z, w])
        self._now.joint_qd.assign([*state.velocity, *state.angular_velocity])
        newton.eval_fk(self._model, self._now.joint_q, self._now.joint_qd, self._now)
        self._steps = 0

    def step(self) -> None:
        self._now.clear_forces()
        if self._pipeline is not None:
            self._pipeline.collide(self._now, self._contacts)
        self._solver.step(self._now, self._next, self._control, self._contacts, self._dt)
        self._now, self._next = self._next, self._now
        self._steps += 1

    def time(self) -> float:
        return self._steps * self._dt  # Newton has no clock

    def state(self) -> State:
        pose = self._now.body_q.numpy()[0].astype(float)
        moving = self._now.body_qd.numpy()[0].astype(float)
        x, y, z, w = pose[3:]
        return State(pose[:3], rotation_matrix([w, x, y, z]), moving[:3], moving[3:])
