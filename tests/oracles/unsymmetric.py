"""A body that is not round on a round rim: Euler's equations in the frame of the table, by SciPy.

Nothing of rimroll is used. The centre of mass may lie beside the axis, and the moments of inertia
across the axis may differ. The rim rolls without slip, or slides without friction.
"""

from dataclasses import dataclass

import numpy as np
from scipy.integrate import solve_ivp
from scipy.spatial.transform import Rotation

GRAVITY = 9.80665
UP = np.array([0.0, 0.0, 1.0])


@dataclass(frozen=True)
class Unsymmetric:
    """SI units; ``moments`` about the centre of mass along the body's axes x, y and z (the axis).

    ``beside``: where the centre of mass is (x, y) from the axis, m.
    """

    mass: float
    radius: float
    height: float
    moments: tuple[float, float, float]
    beside: tuple[float, float] = (0.0, 0.0)


def rates_of(body, tilt, azimuth, yaw_rate, duration, times, rolls):
    """Angular velocity along the body's axes (n, 3), rad/s, of a body let go at rest but for yaw.

    ``azimuth``: where in the body, from its x axis, the rim's point that touches the table is.
    """
    # The body leans about the axis through the table's y: its rim touches at +x.
    start = Rotation.from_euler("y", tilt) * Rotation.from_euler("z", -azimuth)
    moments = np.array(body.moments)
    to_mass = np.array([*body.beside, body.height])

    def change(_, y):
        attitude = Rotation.from_quat(y[:4])
        axes = attitude.as_matrix()
        turning = y[4:]
        axis = axes[:, 2]
        level = UP - axis[2] * axis
        steep = np.linalg.norm(level)
        down = -level / steep
        axis_rate = np.cross(turning, axis)
        level_rate = -axis_rate[2] * axis - axis[2] * axis_rate
        down_rate = -(level_rate - down * (down @ level_rate)) / steep
        middle = axes @ to_mass
        arm = middle - body.radius * down
        arm_rate = np.cross(turning, middle) - body.radius * down_rate
        inertia = axes @ np.diag(moments) @ axes.T
        right = -np.cross(turning, inertia @ turning)
        if rolls:
            left = inertia + body.mass * (arm @ arm * np.eye(3) - np.outer(arm, arm))
            push = np.cross(turning, arm_rate) + GRAVITY * UP
            right -= body.mass * np.cross(arm, push)
        else:
            lever = np.cross(arm, UP)
            left = inertia + body.mass * np.outer(lever, lever)
            right -= body.mass * lever * (GRAVITY + np.cross(turning, arm_rate)[2])
        x, y_, z, w = y[:4]
        by = np.array([[w, z, -y_], [-z, w, x], [y_, -x, w], [-x, -y_, -z]])
        return np.concatenate([0.5 * by @ turning, np.linalg.solve(left, right)])

    begin = np.concatenate([start.as_quat(), yaw_rate * UP])
    found = solve_ivp(
        change, (0.0, duration), begin, "DOP853", t_eval=times, rtol=1e-10, atol=1e-12
    )
    into = Rotation.from_quat(found.y[:4].T).inv()
    return into.apply(found.y[4:].T)
