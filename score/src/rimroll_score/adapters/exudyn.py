"""Exudyn: a rigid body whose rim is a rolling disc connector, with the contact as a penalty."""

from __future__ import annotations

from importlib.metadata import version
from typing import Any, ClassVar

import exudyn
import exudyn.itemInterface as items
import numpy as np
from exudyn.rigidBodyUtilities import RigidBodyInertia

from rimroll_score.protocol import (
    Scene,
    State,
    friction_departures,
    inertia_departures,
    loss_departures,
)

HEAVY = 1e6
"""Mass of a table that moves, kg."""


class Exudyn:
    """A body, a marker at the centre of its base, and a rolling disc over the ground."""

    settings: ClassVar = {
        "defaults": "generalised-alpha steps; stiffness 1e5 N/m, friction proportional "
        "below 1 cm/s",
        "best": "trapezoidal steps; stiffness 0.5 m/dt², friction proportional below 10 m/s² dt",
    }
    best: ClassVar[dict[str, Any]] = {
        "integrator": "TrapezoidalIndex2",
        "stiffness": 0.5,  # m/dt², with the body's mass m
        "zone": 10.0,  # of proportional friction, m/s² times dt
        "linear_zone": False,
    }
    choices: ClassVar[dict[str, list[Any]]] = {
        "integrator": ["TrapezoidalIndex2", "GeneralizedAlpha"],
        "stiffness": [0.07, 0.14, 0.2, 0.3, 0.5, 1.0],
        "zone": [1.0, 10.0, 100.0],
        "linear_zone": [False, True],
    }
    known_versions = "1."
    moves_table = True

    def version(self) -> str:
        return version("exudyn")

    def make(self, scene: Scene, dt: float, setting: str) -> list[str]:
        self._scene, self._dt, self._best = scene, dt, setting == "best"
        stiffness = self.best["stiffness"] * scene.body.mass / dt**2
        self._stiffness = stiffness if self._best else 1e5
        self._zone = self.best["zone"] * dt if self._best else 1e-2
        self._linear = self._best and self.best["linear_zone"]
        up = np.array([0.0, 0.0, scene.body.height])
        self.set_state(State(up, np.eye(3), np.zeros(3), np.zeros(3)))
        return self._departures()

    def _departures(self) -> list[str]:
        """What the system has otherwise than asked."""
        body, made = self._scene.body, self._system.GetObject(self._made)
        # Its moments are about the centre of the base.
        shift = made["mass"] * np.array([1.0, 1.0, 0.0]) * made["centerOfMass"][2] ** 2
        departures = inertia_departures(body, made["mass"], made["inertia"][:3] - shift)
        if not self._scene.table:
            return departures
        contact = self._system.GetObject(self._contact)
        spring = f"{contact['contactStiffness']:g} N/m"
        zone = f"{contact['dryFrictionProportionalZone']:g} m/s"
        if self._best:  # in numbers that do not depend on the step
            spring = f"{contact['contactStiffness'] * self._dt**2 / made['mass']:.3g} m/dt²"
            zone = f"{contact['dryFrictionProportionalZone'] / self._dt:.3g} m/s² dt"
        departures += friction_departures(self._scene.friction, contact["dryFriction"][0])
        departures += loss_departures(
            contact_damping=contact["contactDamping"],
            viscous_friction=max(contact["viscousFriction"]),
            rolling_friction=contact["rollingViscousFriction"],
        )
        departures.append(f"contact is a spring of {spring}")
        if contact["dryFriction"][0]:
            departures.append(f"friction is proportional to slip below {zone}")
        return [*departures, "the body has the rim of its base only"]

    def set_state(self, state: State) -> None:
        body = self._scene.body
        self._container = exudyn.SystemContainer()
        self._system: Any = self._container.AddSystem()
        moments = [body.transverse_inertia, body.transverse_inertia, body.axial_inertia]
        # Its reference point is the centre of the base, as the connector wants it.
        down = body.height * state.rotation[:, 2]
        inertia = RigidBodyInertia(body.mass, np.diag(moments), com=np.zeros(3))
        self._made = self._system.CreateRigidBody(
            inertia=inertia.Translated([0.0, 0.0, body.height]),
            referencePosition=(state.position - down).tolist(),
            referenceRotationMatrix=state.rotation,
            initialVelocity=(state.velocity - np.cross(state.angular_velocity, down)).tolist(),
            initialAngularVelocity=state.angular_velocity.tolist(),
            gravity=[0.0, 0.0, -self._scene.gravity],
            nodeType=exudyn.NodeType.RotationRotationVector,
        )
        if self._scene.table:
            self._add_contact()
        self._system.Assemble()
        self._settings = exudyn.SimulationSettings()
        integration = self._settings.timeIntegration
        integration.numberOfSteps = 1
        integration.endTime = self._dt
        integration.verboseMode = 0
        self._settings.solutionSettings.writeSolutionToFile = False
        kinds = exudyn.DynamicSolverType
        name = self.best["integrator"] if self._best else "GeneralizedAlpha"
        self._kind = getattr(kinds, name)
        self._steps = 0

    def _add_contact(self) -> None:
        """The connector of the rim and the table."""
        friction = min(self._scene.friction, 1.0)
        self._table = self._table_made()
        floor = self._system.AddMarker(items.MarkerBodyRigid(bodyNumber=self._table))
        rim = self._system.AddMarker(items.MarkerBodyRigid(bodyNumber=self._made))
        node = self._system.AddNode(
            items.NodeGenericData(initialCoordinates=[0.0] * 3, numberOfDataCoordinates=3)
        )
        self._contact = self._system.AddObject(
            items.ObjectConnectorRollingDiscPenalty(
                markerNumbers=[floor, rim], nodeNumber=node, discRadius=self._scene.body.radius,
                discAxis=[0.0, 0.0, 1.0], planeNormal=[0.0, 0.0, 1.0],
                contactStiffness=self._stiffness, contactDamping=0.0,
                dryFriction=[friction] * 2, dryFrictionProportionalZone=self._zone,
                useLinearProportionalZone=self._linear,
            )
        )  # fmt: skip

    def _table_made(self) -> Any:
        """The ground or, if it moves, a body so heavy that the can does not stop it."""
        rise = self._scene.table_acceleration
        if not rise:
            return self._system.AddObject(items.ObjectGround())
        table = self._system.CreateRigidBody(
            inertia=RigidBodyInertia(HEAVY, HEAVY * np.eye(3), com=np.zeros(3))
        )
        self._system.CreateForce(bodyNumber=table, loadVector=[0.0, 0.0, HEAVY * rise])
        return table

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
        position, velocity = (
            self._read(self._made, what, up) for what in (kind.Position, kind.Velocity)
        )
        if self._scene.table_acceleration:
            position -= self._read(self._table, kind.Position)
            velocity -= self._read(self._table, kind.Velocity)
        turned = self._read(self._made, kind.RotationMatrix, up).reshape(3, 3)
        return State(position, turned, velocity, self._read(self._made, kind.AngularVelocity, up))

    def _read(self, body: Any, kind: Any, point: Any = (0.0, 0.0, 0.0)) -> Any:
        """What a body has at a point of it."""
        kinds = exudyn.ConfigurationType
        when = kinds.Current if self._steps else kinds.Initial
        return np.array(self._system.GetObjectOutputBody(body, kind, list(point), when))
