"""Exudyn: a rigid body whose rim is a rolling disc connector, with the contact as a penalty."""

from __future__ import annotations

import math
from importlib.metadata import version
from typing import Any, ClassVar

import exudyn
import exudyn.itemInterface as items
import numpy as np
from exudyn.rigidBodyUtilities import RigidBodyInertia

from rimroll_score.protocol import Scene, State


class Exudyn:
    """A body, a marker at the centre of its base, and a rolling disc over the ground."""

    settings: ClassVar = {
        "defaults": "generalised-alpha steps; stiffness 1e5 N/m, friction proportional "
        "below 1 cm/s",
        "best": "trapezoidal steps; stiffness 0.14 m/dt², friction proportional below 10 m/s² dt",
    }
    known_versions = "1."

    def version(self) -> str:
        return version("exudyn")

    def make(self, scene: Scene, dt: float, setting: str) -> list[str]:
        self._scene, self._dt, self._steps = scene, dt, 0
        self._best = setting == "best"
        friction = min(scene.friction, 1.0)
        departures = ["contact and friction are regularised: the connector takes a stiffness"]
        if math.isinf(scene.friction):
            departures.append(f"friction is {friction:g}, not infinite")
        departures.append("the body has the rim of its base only")
        self._friction = friction
        self._stiffness = 0.14 * scene.body.mass / dt**2 if self._best else 1e5
        self._zone = 10.0 * dt if self._best else 1e-2
        return departures if scene.table else []

    def set_state(self, state: State) -> None:
        body, best = self._scene.body, self._best
        self._container = exudyn.SystemContainer()
        self._system: Any = self._container.AddSystem()
        moments = [body.transverse_inertia, body.transverse_inertia, body.axial_inertia]
        # Its reference point is the centre of the base, as the connector wants it.
        down = body.height * state.rotation[:, 2]
        inertia = RigidBodyInertia(body.mass, np.diag(moments), com=np.zeros(3))
        made = self._system.CreateRigidBody(
            inertia=inertia.Translated([0.0, 0.0, body.height]),
            referencePosition=(state.position - down).tolist(),
            referenceRotationMatrix=state.rotation,
            initialVelocity=(state.velocity - np.cross(state.angular_velocity, down)).tolist(),
            initialAngularVelocity=state.angular_velocity.tolist(),
            gravity=[0.0, 0.0, -self._scene.gravity],
            nodeType=exudyn.NodeType.RotationRotationVector,
        )
        self._made = made
        if self._scene.table:
            ground = self._system.AddObject(items.ObjectGround())
            floor = self._system.AddMarker(items.MarkerBodyRigid(bodyNumber=ground))
            rim = self._system.AddMarker(items.MarkerBodyRigid(bodyNumber=made))
            node = self._system.AddNode(
                items.NodeGenericData(initialCoordinates=[0.0] * 3, numberOfDataCoordinates=3)
            )
            self._system.AddObject(
                items.ObjectConnectorRollingDiscPenalty(
                    markerNumbers=[floor, rim], nodeNumber=node, discRadius=body.radius,
                    discAxis=[0.0, 0.0, 1.0], planeNormal=[0.0, 0.0, 1.0],
                    contactStiffness=self._stiffness, contactDamping=0.0,
                    dryFriction=[self._friction] * 2,
                    dryFrictionProportionalZone=self._zone,
                )
            )  # fmt: skip
        self._system.Assemble()
        self._settings = exudyn.SimulationSettings()
        integration = self._settings.timeIntegration
        integration.numberOfSteps = 1
        integration.endTime = self._dt
        integration.verboseMode = 0
        self._settings.solutionSettings.writeSolutionToFile = False
        kinds = exudyn.DynamicSolverType
        self._kind = kinds.TrapezoidalIndex2 if best else kinds.GeneralizedAlpha
        self._steps = 0

    def step(self) -> None:
        integration = self._settings.timeIntegration
        integration.startTime = self._steps * self._dt
        integration.endTime = (self._steps + 1) * self._dt
        self._system.SolveDynamic(
            self._settings, solverType=self._kind, updateInitialValues=True,
            showHints=False, showCausingItems=False,
        )  # fmt: skip
        self._steps += 1

    def time(self) -> float:
        return self._steps * self._dt

    def state(self) -> State:
        up = [0.0, 0.0, self._scene.body.height]
        kind = exudyn.OutputVariableType
        get = self._system.GetObjectOutputBody
        configuration = exudyn.ConfigurationType.Current
        if not self._steps:
            configuration = exudyn.ConfigurationType.Initial
        return State(
            np.array(get(self._made, kind.Position, up, configuration)),
            np.array(get(self._made, kind.RotationMatrix, up, configuration)).reshape(3, 3),
            np.array(get(self._made, kind.Velocity, up, configuration)),
            np.array(get(self._made, kind.AngularVelocity, up, configuration)),
        )
