"""How short are the steps that a games engine would need?

Engines step with a fixed time, by the semi-implicit Euler rule: rates first, then angles. A can
without friction has simple equations, so that the rule takes a few lines here. The near-collision
is over in a moment, and steps that are not much shorter give a turn that means nothing.

    the contact point runs half round in 0.19 ms
    rimroll: 221.62 degrees
    steps of 16.667 ms: off by more than 10 degrees
    steps of  1.000 ms: off by more than 10 degrees
    steps of  0.100 ms: off by more than 10 degrees
    steps of  0.010 ms: off by 0.062 degrees
    steps of  0.001 ms: off by 0.001 degrees
"""

from math import cos, degrees, pi, sin

import rimroll as rr

can = rr.bodies.can_2007()
start = rr.State(tilt=0.5, tilt_rate=-0.5, yaw_rate=0.02)
A, C, m, g = can.transverse_inertia, can.axial_inertia, can.mass, rr.STANDARD_GRAVITY
spin = start.spin_rate + start.yaw_rate * cos(start.tilt)  # about the axis, constant
momentum = A * start.yaw_rate * sin(start.tilt) ** 2 + C * spin * cos(start.tilt)  # constant


def turned(step):
    """The yaw at which the tilt is largest again."""
    tilt, rate, yaw, falling = start.tilt, start.tilt_rate, 0.0, True
    while falling or rate > 0:
        s, c = sin(tilt), cos(tilt)
        yaw_rate = (momentum - C * spin * c) / (A * s * s)
        slope = can.radius * c - can.height * s  # of the height of the centre of mass
        bend = -can.radius * s - can.height * c
        push = A * yaw_rate**2 * s * c - C * spin * yaw_rate * s - m * slope * (bend * rate**2 + g)
        rate += step * push / (A + m * slope**2)
        tilt += step * rate
        yaw += step * yaw_rate
        falling = falling and rate < 0
    return yaw


turn = rr.simulate(can, start, rr.Frictionless()).turns[0]
print(f"the contact point runs half round in {1e3 * pi / turn.yaw_rate:.2f} ms")
print(f"rimroll: {degrees(turn.angle):.2f} degrees")
for step in 1 / 60, 1e-3, 1e-4, 1e-5, 1e-6:
    error = degrees(abs(turned(step) - turn.angle))
    off = f"{error:.3f} degrees" if error < 10 else "more than 10 degrees"
    print(f"steps of {1e3 * step:6.3f} ms: off by {off}")
