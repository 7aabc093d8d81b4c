"""DART: whether its rim is round depends on the collision detector.

No other detector did better in all cases than the one it comes with.
"""

from __future__ import annotations

import math
from importlib.metadata import version
from typing import Any, ClassVar

import dartpy
import numpy as np

from rimroll_score.protocol import Scene, State, inertia_departures


class Dart:
    """A free skeleton of one body over a table."""

    settings: ClassVar = {
        "defaults": "the collision detector and the solver that a world comes with",
        "ode": "the collision detector of ODE instead",
    }
    known_versions = "6."

    def version(self) -> str:
        return version("dartpy")

    def make(self, scene: Scene, dt: float, setting: str) -> list[str]:
        body = scene.body
        friction = min(scene.friction, 1.0)
        self._world: Any = dartpy.simulation.World()
        self._world.setTimeStep(dt)
        self._world.setGravity([0.0, 0.0, -scene.gravity])
        if setting == "ode":
            kind = dartpy.simulation.CollisionDetectorType.ODE
            self._world.setCollisionDetector(kind)
        skeleton = dartpy.dynamics.Skeleton("body")
        self._joint, self._node = skeleton.createFreeJointAndBodyNodePair()
        moments = [body.transverse_inertia, body.transverse_inertia, body.axial_inertia]
        self._node.setInertia(dartpy.dynamics.Inertia(body.mass, np.zeros(3), np.diag(moments)))
        cylinder = dartpy.dynamics.CylinderShape(body.radius, 2.0 * body.height)
        _solid(self._node, cylinder, friction)
        self._world.addSkeleton(skeleton)
        if scene.table:
            table = dartpy.dynamics.Skeleton("table")
            weld, ground = table.createWeldJointAndBodyNodePair()
            pose = dartpy.math.Isometry3()
            pose.set_translation([0.0, 0.0, -0.5])
            weld.setTransformFromParentBodyNode(pose)
            _solid(ground, dartpy.dynamics.BoxShape([4.0, 4.0, 1.0]), friction)
            self._world.addSkeleton(table)
        inertia = self._node.getInertia()
        departures = inertia_departures(body, inertia.getMass(), np.diag(inertia.getMoment()))
        departures.append(f"collisions are found by {self._world.getCollisionDetector().getType()}")
        if scene.table:
            departures.append("the table is a box, since not every detector has a plane")
        if math.isinf(scene.friction):
            departures.append(f"friction is {friction:g}, not infinite")
        return departures

    def set_state(self, state: State) -> None:
        pose = dartpy.math.Isometry3()
        pose.set_translation(state.position)
        pose.set_rotation(state.rotation)
        self._joint.setTransform(pose)
        self._joint.setLinearVelocity(state.velocity)
        self._joint.setAngularVelocity(state.angular_velocity)
        self._world.setTime(0.0)

    def step(self) -> None:
        self._world.step()

    def time(self) -> float:
        return float(self._world.getTime())

    def state(self) -> State:
        pose = self._node.getWorldTransform()
        return State(
            np.array(pose.translation()), np.array(pose.rotation()),
            np.array(self._node.getLinearVelocity()), np.array(self._node.getAngularVelocity()),
        )  # fmt: skip


def _solid(node: Any, shape: Any, friction: float) -> None:
    """Give a body a shape that collides."""
    place = node.createShapeNode(shape)
    for aspect in ("Visual", "Collision", "Dynamics"):
        getattr(place, f"create{aspect}Aspect")()
    place.getDynamicsAspect().setFrictionCoeff(friction)
    place.getDynamicsAspect().setRestitutionCoeff(0.0)
