"""PyBullet (Bullet 3).

A cylinder of ``createCollisionShape`` has a round rim, that of a URDF has 32 corners.
"""

from __future__ import annotations

from importlib.metadata import version
from typing import Any, ClassVar

import numpy as np
import pybullet

from rimroll_score.protocol import (
    Scene,
    State,
    friction_departures,
    inertia_departures,
    loss_departures,
    quaternion,
    rotation_matrix,
)

HEAVY = 1e6
"""Mass of a table that moves, kg."""


class PyBullet:
    """A rigid body with a cylinder shape over a plane."""

    settings: ClassVar = {
        "defaults": "the world as it comes, damping and sleeping included",
        "best": "no damping, no sleeping, collision margin 1e-6 m, implicit cone, 200 iterations, "
        "no residual threshold, gyroscopic terms, no restitution and slop, "
        "error reduction 0.5",
    }
    best: ClassVar[dict[str, Any]] = {
        "margin": 1e-6,  # m; with none at all, contacts are lost
        "iterations": 200,
        "error_reduction": 0.5,
        "cone": 1,
        "slop": 0.0,  # m
    }
    choices: ClassVar[dict[str, list[Any]]] = {
        "margin": [1e-7, 1e-6, 1e-5, 1e-4],
        "iterations": [50, 200, 1000],
        "error_reduction": [0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.8],
        "cone": [0, 1],
        "slop": [0.0, 1e-5],
    }
    known_versions = "3."
    moves_table = True

    def version(self) -> str:
        return version("pybullet")

    def make(self, scene: Scene, dt: float, setting: str) -> list[str]:
        body, best = scene.body, setting == "best"
        friction = min(scene.friction, 1.0)
        # A table that moves is a body so heavy that the can does not stop it, under a force.
        self._push = scene.table_acceleration and HEAVY * (scene.table_acceleration + scene.gravity)
        if pybullet.isConnected():
            pybullet.disconnect()
        pybullet.connect(pybullet.DIRECT)
        pybullet.setTimeStep(dt)
        pybullet.setGravity(0.0, 0.0, -scene.gravity)
        if best:
            reduction = self.best["error_reduction"]
            pybullet.setPhysicsEngineParameter(
                numSolverIterations=self.best["iterations"], solverResidualThreshold=0.0,
                contactSlop=self.best["slop"], enableConeFriction=self.best["cone"],
                erp=reduction, contactERP=reduction, frictionERP=reduction,
                restitutionVelocityThreshold=0.0,
            )  # fmt: skip
        if scene.table:
            plane = pybullet.createCollisionShape(pybullet.GEOM_PLANE)
            self._table = pybullet.createMultiBody(self._push and HEAVY, plane)
            pybullet.changeDynamics(self._table, -1, lateralFriction=1.0)
            if self._push:
                pybullet.changeDynamics(
                    self._table, -1, linearDamping=0.0, angularDamping=0.0,
                    localInertiaDiagonal=[HEAVY] * 3, maxJointVelocity=1e6,
                )  # fmt: skip
        cylinder = pybullet.createCollisionShape(
            pybullet.GEOM_CYLINDER, radius=body.radius, height=2.0 * body.height
        )
        self._body = pybullet.createMultiBody(body.mass, cylinder)
        inertia = [body.transverse_inertia, body.transverse_inertia, body.axial_inertia]
        # Bullet multiplies the frictions of the two bodies.
        pybullet.changeDynamics(
            self._body, -1, localInertiaDiagonal=inertia, lateralFriction=friction,
            rollingFriction=0.0, spinningFriction=0.0, restitution=0.0,
        )  # fmt: skip
        if best:
            pybullet.changeDynamics(
                self._body, -1, linearDamping=0.0, angularDamping=0.0,
                collisionMargin=self.best["margin"],
                activationState=pybullet.ACTIVATION_STATE_DISABLE_SLEEPING,
                maxJointVelocity=1e6,
            )  # fmt: skip
        self._dt, self._steps = dt, 0
        info = pybullet.getDynamicsInfo(self._body, -1)
        departures = inertia_departures(body, info[0], info[2])
        if scene.table:  # the product counts
            departures += friction_departures(
                scene.friction, info[1] * pybullet.getDynamicsInfo(self._table, -1)[1]
            )
        departures += loss_departures(
            restitution=info[5], rolling_friction=info[6], spinning_friction=info[7]
        )
        if info[11] > self.best["margin"]:
            departures.append(f"the collision margin, which rounds the rim, is {info[11]:g} m")
        if not best:  # from its manual and source: PyBullet does not report it
            departures.append("damping is 0.04 1/s times 1 + speed in m/s, 1 + rate in rad/s")
            departures.append("a body that is slow for long may be put to sleep")
            departures.append("angular velocity is limited to 100 rad/s")
        return departures

    def set_state(self, state: State) -> None:
        w, x, y, z = quaternion(state.rotation)
        pybullet.resetBasePositionAndOrientation(self._body, state.position, [x, y, z, w])
        pybullet.resetBaseVelocity(
            self._body, state.velocity.tolist(), state.angular_velocity.tolist()
        )
        self._steps = 0

    def step(self) -> None:
        if self._push:
            pybullet.applyExternalForce(
                self._table, -1, [0.0, 0.0, self._push], [0.0] * 3, pybullet.WORLD_FRAME
            )
        pybullet.stepSimulation()
        self._steps += 1

    def time(self) -> float:
        return self._steps * self._dt  # PyBullet has no clock

    def state(self) -> State:
        position, (x, y, z, w) = pybullet.getBasePositionAndOrientation(self._body)
        velocity, angular_velocity = pybullet.getBaseVelocity(self._body)
        place, moving = np.array(position), np.array(velocity)
        if self._push:
            place -= pybullet.getBasePositionAndOrientation(self._table)[0]
            moving -= pybullet.getBaseVelocity(self._table)[0]
        return State(place, rotation_matrix([w, x, y, z]), moving, np.array(angular_velocity))
