"""Drake: MultibodyPlant with point contact, in discrete time."""

from __future__ import annotations

from importlib.metadata import version
from typing import Any, ClassVar

import numpy as np
from pydrake.geometry import AddContactMaterial, Cylinder, HalfSpace, ProximityProperties
from pydrake.math import RigidTransform, RotationMatrix
from pydrake.multibody.math import SpatialVelocity
from pydrake.multibody.plant import (
    AddMultibodyPlant,
    CoulombFriction,
    MultibodyPlantConfig,
)
from pydrake.multibody.tree import PrismaticJoint, SpatialInertia, UnitInertia
from pydrake.systems.analysis import Simulator
from pydrake.systems.framework import DiagramBuilder

from rimroll_score.protocol import Scene, State, friction_departures, inertia_departures

HEAVY = 1e4
"""Mass of a table that moves, kg."""


class Drake:
    """A free body with a cylinder over a half space."""

    settings: ClassVar = {
        "defaults": "MultibodyPlantConfig as it comes, at the step asked",
        "best": "point contact solved by TAMSI, stiffness 1e9 N/m, no dissipation, "
        "stiction tolerance 1e-5 m/s",
    }
    best: ClassVar[dict[str, Any]] = {
        "approximation": "tamsi",
        "stiffness": 1e9,  # N/m
        "dissipation": 0.0,  # s/m
        "stiction_tolerance": 1e-5,  # m/s
    }
    choices: ClassVar[dict[str, list[Any]]] = {
        "approximation": ["tamsi", "sap", "similar", "lagged"],
        "stiffness": [1e6, 1e7, 1e8, 1e9, 1e10],
        "dissipation": [0.0, 1.0, 50.0],
        "stiction_tolerance": [1e-3, 1e-4, 1e-5, 1e-6],
    }
    known_versions = "1."
    moves_table = True

    def version(self) -> str:
        return version("drake")

    def make(self, scene: Scene, dt: float, setting: str) -> list[str]:
        body, best = scene.body, setting == "best"
        friction = min(scene.friction, 1.0)
        self._lift: Any = None
        builder = DiagramBuilder()
        config = MultibodyPlantConfig(time_step=dt)
        if best:
            config.discrete_contact_approximation = self.best["approximation"]
            config.stiction_tolerance = self.best["stiction_tolerance"]
            config.contact_model = "point"
        plant, _ = AddMultibodyPlant(config, builder)
        plant.mutable_gravity_field().set_gravity_vector([0.0, 0.0, -scene.gravity])
        transverse, axial = body.transverse_inertia / body.mass, body.axial_inertia / body.mass
        inertia = SpatialInertia(
            body.mass, np.zeros(3), UnitInertia(transverse, transverse, axial)
        )  # fmt: skip
        rigid = plant.AddRigidBody("body", inertia)
        material = ProximityProperties()
        dry = CoulombFriction(friction, friction)
        if best:
            AddContactMaterial(
                dissipation=self.best["dissipation"], point_stiffness=self.best["stiffness"],
                friction=dry, properties=material,
            )  # fmt: skip
        else:
            AddContactMaterial(friction=dry, properties=material)
        shape = Cylinder(body.radius, 2.0 * body.height)
        plant.RegisterCollisionGeometry(rigid, RigidTransform(), shape, "body", material)
        if scene.table:
            table = plant.world_body()
            if scene.table_acceleration:
                heavy = SpatialInertia(HEAVY, np.zeros(3), UnitInertia(1.0, 1.0, 1.0))
                table = plant.AddRigidBody("table", heavy)
                self._lift = plant.AddJoint(
                    PrismaticJoint("lift", plant.world_frame(), table.body_frame(), [0, 0, 1])
                )
                plant.AddJointActuator("lift", self._lift)
            plant.RegisterCollisionGeometry(table, RigidTransform(), HalfSpace(), "table", material)
        plant.Finalize()
        diagram = builder.Build()
        self._simulator: Any = Simulator(diagram)
        self._context: Any = plant.GetMyMutableContextFromRoot(
            self._simulator.get_mutable_context()
        )
        self._plant, self._rigid, self._dt, self._steps = plant, rigid, dt, 0
        if self._lift is not None:
            push = HEAVY * (scene.table_acceleration + scene.gravity)
            plant.get_actuation_input_port().FixValue(self._context, [push])
        has = rigid.CalcSpatialInertiaInBodyFrame(self._context)
        moments = has.CalcRotationalInertia().get_moments()
        departures = inertia_departures(body, has.get_mass(), moments)
        if scene.table:
            known = diagram.GetSubsystemByName("scene_graph").model_inspector()
            (one,) = plant.GetCollisionGeometriesForBody(rigid)
            found = known.GetProximityProperties(one).GetProperty("material", "coulomb_friction")
            departures += friction_departures(scene.friction, found.static_friction())
        if friction:
            tolerance = config.stiction_tolerance
            departures.append(f"friction is regularised below a slip of {tolerance:g} m/s")
        if scene.table:
            kind = plant.get_discrete_contact_approximation().name.removeprefix("k").upper()
            departures.append(f"contact is compliant, approximated by {kind}")
        return departures

    def set_state(self, state: State) -> None:
        pose = RigidTransform(
            RotationMatrix.ProjectToRotationMatrix(state.rotation), state.position
        )
        self._plant.SetFreeBodyPose(self._context, self._rigid, pose)
        moving = SpatialVelocity(state.angular_velocity, state.velocity)
        self._plant.SetFreeBodySpatialVelocity(self._context, self._rigid, moving)
        self._simulator.get_mutable_context().SetTime(0.0)
        self._simulator.Initialize()
        self._steps = 0

    def step(self) -> None:
        self._steps += 1
        self._simulator.AdvanceTo(self._steps * self._dt)

    def time(self) -> float:
        return float(self._simulator.get_context().get_time())

    def state(self) -> State:
        pose = self._plant.EvalBodyPoseInWorld(self._context, self._rigid)
        moving = self._plant.EvalBodySpatialVelocityInWorld(self._context, self._rigid)
        position, velocity = np.array(pose.translation()), np.array(moving.translational())
        if self._lift is not None:
            position[2] -= self._lift.get_translation(self._context)
            velocity[2] -= self._lift.get_translation_rate(self._context)
        return State(position, pose.rotation().matrix(), velocity, moving.rotational())
