"""MuJoCo: the cylinder of its plane-cylinder routine has a round rim."""

from __future__ import annotations

from typing import Any, ClassVar

import mujoco
import numpy as np

from rimroll_score.protocol import (
    Array,
    Body,
    Scene,
    State,
    friction_departures,
    inertia_departures,
    loss_departures,
    quaternion,
    rotation_matrix,
)

CORNERS = 32
"""Corners of the rim that is a polygon."""


class MuJoCo:
    """A free body with a cylinder geom over a plane."""

    settings: ClassVar = {
        "defaults": "the options of an empty model; friction as asked",
        "best": "implicitfast, elliptic cone, impratio 100, contact as stiff as the step allows "
        "(solref 2 dt 0.4), solver tolerance 1e-12",
        "polygon": "the best settings, but a mesh of 32 corners as the cylinder",
    }
    best: ClassVar[dict[str, Any]] = {
        "integrator": "implicitfast",
        "cone": "elliptic",
        "impratio": 100,
        "tolerance": 1e-12,
        "time_constant": 2.0,  # of the contact, in steps; MuJoCo allows none below 2
        "damping_ratio": 0.4,
        "solimp": "0.9 0.95 0.001 0.5 2",
    }
    choices: ClassVar[dict[str, list[Any]]] = {
        "integrator": ["Euler", "implicit", "implicitfast", "RK4"],
        "cone": ["pyramidal", "elliptic"],
        "impratio": [1, 10, 100, 1000],
        "tolerance": [1e-8, 1e-12],
        "time_constant": [2.0, 3.0, 5.0],
        "damping_ratio": [0.3, 0.4, 0.5, 0.6, 0.7, 1.0, 2.0],
        "solimp": [
            "0.9 0.95 0.001 0.5 2", "0.99 0.9999 1e-6 0.5 2", "0.9999 0.9999 1e-6 0.5 2",
        ],
    }  # fmt: skip
    known_versions = ("3.", "4.")
    why_table_rests = "a plane of MuJoCo belongs to the world and does not move"

    def version(self) -> str:
        return str(mujoco.__version__)

    def make(self, scene: Scene, dt: float, setting: str) -> list[str]:
        body, best = scene.body, setting in ("best", "polygon")
        mesh, shape = "", f'type="cylinder" size="{body.radius} {body.height}"'
        if setting == "polygon":
            corners = " ".join(f"{x:.12g}" for x in _prism(body).ravel())
            mesh = f'<asset><mesh name="prism" vertex="{corners}"/></asset>'
            shape = 'type="mesh" mesh="prism"'
        friction = min(scene.friction, 1.0)
        known, options = self.best, ""
        if best:
            names = ("integrator", "cone", "impratio", "tolerance")
            options = " ".join(f'{name}="{known[name]}"' for name in names) + ' iterations="200"'
        geom = f'friction="{friction} 0 0" condim="{3 if friction else 1}"'
        if best:
            stiff = f"{known['time_constant'] * dt} {known['damping_ratio']}"
            geom += f' solref="{stiff}" solimp="{known["solimp"]}"'
        transverse, axial = body.transverse_inertia, body.axial_inertia
        floor = f'<geom name="table" type="plane" size="9 9 1" {geom}/>' if scene.table else ""
        self._model: Any = mujoco.MjModel.from_xml_string(f"""
            <mujoco>
              <compiler balanceinertia="false" boundmass="0" boundinertia="0"/>
              <option timestep="{dt}" gravity="0 0 {-scene.gravity}" {options}/>
              {mesh}
              <worldbody>
                {floor}
                <body name="body">
                  <freejoint/>
                  <inertial pos="0 0 0" mass="{body.mass}"
                    diaginertia="{transverse} {transverse} {axial}"/>
                  <geom {shape} {geom}/>
                </body>
              </worldbody>
            </mujoco>""")
        self._data: Any = mujoco.MjData(self._model)
        departures = inertia_departures(body, self._model.body_mass[1], self._axes(body))
        departures += loss_departures(
            damping_of_the_joint=self._model.dof_damping.max(),
            friction_of_the_joint=self._model.dof_frictionloss.max(),
            armature=self._model.dof_armature.max(),
            density_of_the_air=self._model.opt.density,
            viscosity_of_the_air=self._model.opt.viscosity,
        )
        if scene.table:  # the larger of the two counts
            found = self._model.geom_friction[:, 0].max()
            departures += friction_departures(scene.friction, found if friction else 0.0)
            time, ratio = self._model.geom_solref[0]
            long = f"{time / dt:.3g} steps" if best else f"{time:g} s"
            departures.append(
                f"contacts are soft (time constant {long}, damping ratio {ratio:g}): they never "
                "touch without overlap"
            )
        if mesh:
            departures.append(f"the rim is a polygon of {CORNERS} corners")
        if friction and self._model.opt.cone == mujoco.mjtCone.mjCONE_PYRAMIDAL:
            departures.append("the friction cone is a pyramid")
        return departures

    def _axes(self, body: Any) -> Any:
        """Principal moments about the geom's axes; MuJoCo may order them in another way."""
        turned = rotation_matrix(self._model.body_iquat[1])
        return np.diag(turned @ np.diag(self._model.body_inertia[1]) @ turned.T)

    def set_state(self, state: State) -> None:
        mujoco.mj_resetData(self._model, self._data)
        self._data.qpos[:3] = state.position
        self._data.qpos[3:] = quaternion(state.rotation)
        self._data.qvel[:3] = state.velocity
        self._data.qvel[3:] = state.rotation.T @ state.angular_velocity  # in the body's frame
        mujoco.mj_forward(self._model, self._data)

    def step(self) -> None:
        mujoco.mj_step(self._model, self._data)

    def time(self) -> float:
        return float(self._data.time)

    def state(self) -> State:
        turned = rotation_matrix(self._data.qpos[3:])
        angular_velocity = turned @ self._data.qvel[3:]
        position, velocity = self._data.qpos[:3].copy(), self._data.qvel[:3].copy()
        return State(position, turned, velocity, angular_velocity)


def _prism(body: Body) -> Array:
    """The corners of a prism whose edges are inscribed in the body's rims, m."""
    angles = 2.0 * np.pi * np.arange(CORNERS) / CORNERS
    rim = body.radius * np.column_stack([np.cos(angles), np.sin(angles), 0.0 * angles])
    up = np.array([0.0, 0.0, body.height])
    return np.concatenate([rim - up, rim + up])
