"""Rapier, from Python in single precision.

Its default friction model acts on groups of contacts, some of which are predicted far away.
"""

from __future__ import annotations

from importlib.metadata import version
from typing import Any, ClassVar

import numpy as np
import rapier3d

from rimroll_score.protocol import (
    Scene,
    State,
    friction_departures,
    inertia_departures,
    loss_departures,
    quaternion,
    rotation_matrix,
)

UPRIGHT = np.array([[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, -1.0, 0.0]])
"""From the axes of Rapier's cylinder, which stands along y, to the body's."""


class Rapier:
    """A dynamic body with a cylinder over a half space."""

    settings: ClassVar = {
        "defaults": "the world as it comes, at the step asked",
        "best": "Coulomb friction at every contact, lengths of 5 cm, 2 iterations, no contact "
        "kept from the last step, fast rotation allowed, no sleeping",
    }
    best: ClassVar[dict[str, Any]] = {
        "friction": "COULOMB",
        "length_unit": 0.05,  # m
        "iterations": 2,
        "recycling": False,
        "softness": 8.0,  # steps in which the contact's spring turns by a radian
        "damping": 5.0,
    }
    choices: ClassVar[dict[str, list[Any]]] = {
        "friction": ["SIMPLIFIED", "COULOMB"],
        "length_unit": [1.0, 0.2, 0.05, 0.01],
        "iterations": [1, 2, 4, 8, 20],
        "recycling": [False, True],
        "softness": [4.0, 8.0, 16.0, 32.0],
        "damping": [1.0, 2.0, 5.0, 10.0],
    }
    known_versions = "0."
    moves_table = True

    def version(self) -> str:
        return version("rapier3d")

    def make(self, scene: Scene, dt: float, setting: str) -> list[str]:
        body, best = scene.body, setting == "best"
        friction = min(scene.friction, 1.0)
        self._scene, self._table = scene, None
        self._world: Any = rapier3d.PhysicsWorld(gravity=(0.0, 0.0, -scene.gravity))
        known = self._world.integration_parameters
        known.dt = dt
        if best:
            known.friction_model = getattr(rapier3d.FrictionModel, self.best["friction"])
            known.length_unit = self.best["length_unit"]
            known.num_solver_iterations = self.best["iterations"]
            known.contact_recycling = self.best["recycling"]
            known.contact_clustering = False
            known.normalized_allowed_linear_error = 1e-5
            frequency = 1.0 / (self.best["softness"] * dt)
            stiff = rapier3d.SpringCoefficients(frequency, self.best["damping"])
            known.contact_softness = known.static_contact_softness = stiff
        moments = rapier3d.Vec3(
            body.transverse_inertia, body.axial_inertia, body.transverse_inertia
        )
        properties = rapier3d.MassProperties(
            rapier3d.Vec3(0.0, 0.0, 0.0), body.mass, moments, rapier3d.Rotation3.identity()
        )
        builder = rapier3d.RigidBody.dynamic(gyroscopic_forces=True) if best else None
        builder = builder or rapier3d.RigidBody.dynamic()
        builder = builder.additional_mass_properties(properties)
        if best:
            builder = builder.can_sleep(False).allow_fast_rotation(True)
        self._body = self._world.add_body(builder)
        cylinder = rapier3d.Collider.cylinder(body.height, body.radius)
        solid = cylinder.density(0.0).friction(friction)
        solids = [self._world.add_collider(solid, self._body)]
        if scene.table:
            table = rapier3d.Collider.halfspace(rapier3d.Vec3(0.0, 0.0, 1.0))
            kind = rapier3d.RigidBody.fixed()
            if scene.table_acceleration:
                kind = rapier3d.RigidBody.kinematic_velocity_based()
            self._table = self._world.add_body(kind)
            solids.append(self._world.add_collider(table.friction(friction), self._table))
        self._rigid().recompute_mass_properties_from_colliders(self._world.colliders)
        self._dt, self._steps = dt, 0
        has = self._rigid().mass_properties
        x, y, z = _numbers(getattr(has, "local_mprops", has).principal_inertia)
        departures = inertia_departures(body, self._rigid().mass, (x, z, y))
        departures.append("arithmetic is in single precision")
        if friction and known.friction_model == rapier3d.FrictionModel.SIMPLIFIED:
            departures.append("friction acts once for all contacts, with a twist")
        if not self._rigid().gyroscopic_forces_enabled:
            departures.append("gyroscopic forces are off")
        if not self._rigid().allow_fast_rotation:
            departures.append("rotation is limited to 45 degrees a substep")
        departures += friction_departures(scene.friction, self._friction(solids))
        departures += loss_departures(
            linear_damping=self._rigid().linear_damping,
            angular_damping=self._rigid().angular_damping,
        )
        if self._rigid().activation.linear_threshold >= 0.0:  # Rapier's sign for never
            departures.append("a body that is slow for long may be put to sleep")
        return departures

    def _rigid(self, body: Any = None) -> Any:
        body = self._body if body is None else body
        return self._world.rigid_bodies.get(body) if hasattr(body, "index") else body

    def _friction(self, solids: list[Any]) -> float:
        """The mean of the coefficients, which is what counts."""
        found = [float(self._world.colliders.get(one).friction) for one in solids]
        return sum(found) / len(found)

    def set_state(self, state: State) -> None:
        w, x, y, z = (float(q) for q in quaternion(state.rotation @ UPRIGHT.T))
        body = self._rigid()
        body.position = rapier3d.Isometry3(
            rapier3d.Vec3(*map(float, state.position)), rapier3d.Rotation3(w, x, y, z)
        )
        body.linvel = rapier3d.Vec3(*map(float, state.velocity))
        body.angvel = rapier3d.Vec3(*map(float, state.angular_velocity))
        self._steps = 0

    def step(self) -> None:
        if self._scene.table_acceleration:  # its velocity at the end of the step
            rise = self._scene.table_acceleration * (self._steps + 1) * self._dt
            self._rigid(self._table).linvel = rapier3d.Vec3(0.0, 0.0, rise)
        self._world.step()
        self._steps += 1

    def time(self) -> float:
        return self._steps * self._dt  # Rapier has no clock

    def state(self) -> State:
        body = self._rigid()
        turned = body.rotation
        spun = rotation_matrix([turned.w, turned.i, turned.j, turned.k]) @ UPRIGHT
        position, velocity = _numbers(body.translation), _numbers(body.linvel)
        if self._scene.table_acceleration:
            table = self._rigid(self._table)
            position -= _numbers(table.translation)
            velocity -= _numbers(table.linvel)
        return State(position, spun, velocity, _numbers(body.angvel))


def _numbers(vector: Any) -> Any:
    return np.array([vector.x, vector.y, vector.z])
