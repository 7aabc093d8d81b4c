"""Drake: MultibodyPlant with point contact, in discrete time."""

from __future__ import annotations

import math
from importlib.metadata import version
from typing import Any, ClassVar

import numpy as np
from pydrake.geometry import AddContactMaterial, Cylinder, HalfSpace, ProximityProperties
from pydrake.math import RigidTransform, RotationMatrix
from pydrake.multibody.math import SpatialVelocity
from pydrake.multibody.plant import (
    AddMultibodyPlant,
    CoulombFriction,
    DiscreteContactApproximation,
    MultibodyPlantConfig,
)
from pydrake.multibody.tree import SpatialInertia, UnitInertia
from pydrake.systems.analysis import Simulator
from pydrake.systems.framework import DiagramBuilder

from rimroll_score.protocol import Scene, State, inertia_departures


class Drake:
    """A free body with a cylinder over a half space."""

    settings: ClassVar = {
        "defaults": "MultibodyPlantConfig as it comes, at the step asked",
        "best": "point contact solved by TAMSI, stiffness 1e9 N/m, no dissipation, "
        "stiction tolerance 1e-5 m/s",
    }
    known_versions = "1."

    def version(self) -> str:
        return version("drake")

    def make(self, scene: Scene, dt: float, setting: str) -> list[str]:
        body, best = scene.body, setting == "best"
        friction = min(scene.friction, 1.0)
        builder = DiagramBuilder()
        config = MultibodyPlantConfig(time_step=dt)
        if best:
            config.discrete_contact_approximation = "tamsi"
            config.stiction_tolerance = 1e-5
            config.contact_model = "point"
        plant, _ = AddMultibodyPlant(config, builder)
        plant.mutable_gravity_field().set_gravity_vector([0.0, 0.0, -scene.gravity])
        transverse, axial = body.transverse_inertia / body.mass, body.axial_inertia / body.mass
        inertia = SpatialInertia(
            body.mass, np.zeros(3), UnitInertia(transverse, transverse, axial)
        )  # fmt: skip
        rigid = plant.AddRigidBody("body", inertia)
        material = ProximityProperties()
        known = CoulombFriction(friction, friction)
        if best:
            AddContactMaterial(
                dissipation=0.0, point_stiffness=1e9, friction=known, properties=material
            )
        else:
            AddContactMaterial(friction=known, properties=material)
        shape = Cylinder(body.radius, 2.0 * body.height)
        plant.RegisterCollisionGeometry(rigid, RigidTransform(), shape, "body", material)
        if scene.table:
            plant.RegisterCollisionGeometry(
                plant.world_body(), RigidTransform(), HalfSpace(), "table", material
            )
        plant.Finalize()
        diagram = builder.Build()
        self._simulator: Any = Simulator(diagram)
        self._context: Any = plant.GetMyMutableContextFromRoot(
            self._simulator.get_mutable_context()
        )
        self._plant, self._rigid, self._dt, self._steps = plant, rigid, dt, 0
        has = rigid.CalcSpatialInertiaInBodyFrame(self._context)
        moments = has.CalcRotationalInertia().get_moments()
        departures = inertia_departures(body, has.get_mass(), moments)
        if math.isinf(scene.friction):
            departures.append(f"friction is {friction:g}, not infinite")
        if friction:
            tolerance = config.stiction_tolerance
            departures.append(f"friction is regularised below a slip of {tolerance:g} m/s")
        if scene.table:
            name = DiscreteContactApproximation.kSap
            departures.append(
                "contact is compliant"
                + ("" if plant.get_discrete_contact_approximation() != name else ", solved by SAP")
            )
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
        return State(
            pose.translation(), pose.rotation().matrix(),
            moving.translational(), moving.rotational(),
        )  # fmt: skip
