"""DART: whether its rim is round depends on the collision detector."""

from __future__ import annotations

from importlib.metadata import version
from typing import Any, ClassVar

import dartpy
import numpy as np

from rimroll_score.protocol import (
    Scene,
    State,
    friction_departures,
    inertia_departures,
    loss_departures,
)


class Dart:
    """A free skeleton of one body over a table."""

    settings: ClassVar = {
        "defaults": "the collision detector and the solver that a world comes with",
        "ode": "the collision detector of ODE instead",
        "best": "no sleeping, a plane as the table; the detector and solver of the defaults",
    }
    best: ClassVar[dict[str, Any]] = {
        "detector": "FCL",
        "solver": "Dantzig",
        "table": "PlaneShape",
        "split_impulse": False,
    }
    choices: ClassVar[dict[str, list[Any]]] = {
        "detector": ["FCL", "DART", "BULLET", "ODE"],
        "solver": ["Dantzig", "Pgs"],
        "table": ["BoxShape", "PlaneShape"],
        "split_impulse": [False, True],
    }
    known_versions = "6."
    moves_table = True

    def version(self) -> str:
        return version("dartpy")

    def make(self, scene: Scene, dt: float, setting: str) -> list[str]:
        body = scene.body
        self._scene, friction = scene, min(scene.friction, 1.0)
        self._lift: Any = None
        self._world: Any = dartpy.simulation.World()
        self._world.setTimeStep(dt)
        self._world.setGravity([0.0, 0.0, -scene.gravity])
        shape = "BoxShape"
        if setting == "ode":
            kind = dartpy.simulation.CollisionDetectorType.ODE
            self._world.setCollisionDetector(kind)
        if setting == "best":
            shape = self.best["table"]
            self._use_best()
        skeleton = dartpy.dynamics.Skeleton("body")
        self._joint, self._node = skeleton.createFreeJointAndBodyNodePair()
        moments = [body.transverse_inertia, body.transverse_inertia, body.axial_inertia]
        self._node.setInertia(dartpy.dynamics.Inertia(body.mass, np.zeros(3), np.diag(moments)))
        cylinder = dartpy.dynamics.CylinderShape(body.radius, 2.0 * body.height)
        shapes = [_solid(self._node, cylinder, friction)]
        self._world.addSkeleton(skeleton)
        if scene.table:
            table = dartpy.dynamics.Skeleton("table")
            if scene.table_acceleration:
                joint, self._ground = table.createPrismaticJointAndBodyNodePair()
                joint.setAxis([0.0, 0.0, 1.0])
                joint.setActuatorType(dartpy.dynamics.ActuatorType.ACCELERATION)
                self._lift = joint
            else:
                joint, self._ground = table.createWeldJointAndBodyNodePair()
            pose = dartpy.math.Isometry3()
            if shape == "BoxShape":
                pose.set_translation([0.0, 0.0, -0.5])
                plane = dartpy.dynamics.BoxShape([4.0, 4.0, 1.0])
            else:
                plane = dartpy.dynamics.PlaneShape([0.0, 0.0, 1.0], 0.0)
            joint.setTransformFromParentBodyNode(pose)
            shapes.append(_solid(self._ground, plane, friction))
            self._world.addSkeleton(table)
        inertia = self._node.getInertia()
        departures = inertia_departures(body, inertia.getMass(), np.diag(inertia.getMoment()))
        departures.append(f"collisions are found by {self._world.getCollisionDetector().getType()}")
        if scene.table:
            if shape == "BoxShape":
                departures.append("the table is a box, since not every detector has a plane")
            found = [shape.getDynamicsAspect().getFrictionCoeff() for shape in shapes]
            departures += friction_departures(scene.friction, min(found))
        coordinates = range(self._joint.getNumDofs())
        departures += loss_departures(
            damping_of_the_joint=max(map(self._joint.getDampingCoefficient, coordinates)),
            friction_of_the_joint=max(map(self._joint.getCoulombFriction, coordinates)),
        )
        if self._world.getDeactivationOptions().mEnabled:
            departures.append("a body that is slow for long may be put to sleep")
        return departures

    def _use_best(self) -> None:
        """Set the world's options as the best settings have them."""
        kind = getattr(dartpy.simulation.CollisionDetectorType, self.best["detector"])
        self._world.setCollisionDetector(kind)
        solver = self._world.getConstraintSolver()
        if self.best["solver"] == "Pgs":  # which is there in case that Dantzig's fails
            solver.setBoxedLcpSolver(solver.getSecondaryBoxedLcpSolver())
        solver.setSplitImpulseEnabled(self.best["split_impulse"])
        awake = self._world.getDeactivationOptions()
        awake.mEnabled = False
        self._world.setDeactivationOptions(awake)

    def set_state(self, state: State) -> None:
        pose = dartpy.math.Isometry3()
        pose.set_translation(state.position)
        pose.set_rotation(state.rotation)
        self._joint.setTransform(pose)
        self._joint.setLinearVelocity(state.velocity)
        self._joint.setAngularVelocity(state.angular_velocity)
        self._world.setTime(0.0)

    def step(self) -> None:
        if self._lift is not None:  # a step clears the command
            self._lift.setCommand(0, self._scene.table_acceleration)
        self._world.step()

    def time(self) -> float:
        return float(self._world.getTime())

    def state(self) -> State:
        pose = self._node.getWorldTransform()
        position, velocity = np.array(pose.translation()), np.array(self._node.getLinearVelocity())
        if self._lift is not None:
            position[2] -= self._lift.getPosition(0)
            velocity[2] -= self._lift.getVelocity(0)
        turned = np.array(pose.rotation())
        return State(position, turned, velocity, np.array(self._node.getAngularVelocity()))


def _solid(node: Any, shape: Any, friction: float) -> Any:
    """Give a body a shape that collides, and return where it is."""
    place = node.createShapeNode(shape)
    for aspect in ("Visual", "Collision", "Dynamics"):
        getattr(place, f"create{aspect}Aspect")()
    place.getDynamicsAspect().setFrictionCoeff(friction)
    place.getDynamicsAspect().setRestitutionCoeff(0.0)
    return place
