"""How exact are derivatives of a motion, against finite differences?

Derivatives come from dual numbers along with the motion. A difference of two motions is right to
half of the digits at best: large steps bend, and small steps drown in rounding.

    d turn / d tilt_rate = 0.0079406302
    step 1e-01: off by about 1e-2
    step 1e-03: off by about 1e-6
    step 1e-05: off by about 1e-8
    step 1e-07: off by about 1e-6
    step 1e-09: off by about 1e-4
"""

from dataclasses import replace

import numpy as np

import rimroll as rr

can = rr.bodies.can_2007()
start = rr.State(tilt=0.5, tilt_rate=-0.5, yaw_rate=0.1)
motion = rr.simulate(can, start, rr.NoSlip(), duration=1.0, rtol=1e-13, jacobian=True)
exact = motion.turn_jacobians[0]["tilt_rate"]
print(f"d turn / d tilt_rate = {exact:.10f}")
for step in 1e-1, 1e-3, 1e-5, 1e-7, 1e-9:
    rates = np.array([-0.5 - step, -0.5 + step])
    turns = [
        rr.simulate(can, replace(start, tilt_rate=rate), rr.NoSlip(), 1.0, rtol=1e-13).turns[0]
        for rate in rates
    ]
    difference = (turns[1].angle - turns[0].angle) / (2 * step)
    print(f"step {step:.0e}: off by about 1e{np.log10(abs(difference / exact - 1)):.0f}")
