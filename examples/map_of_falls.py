"""To which side does a flicked can fall?

The side of a fall over the plane of starts: it jumps at a line, the watershed, along which the can
comes down flat. Rows are yaw rates, columns spin rates, both from -0.5 to 0.5 rad/s; `L` is left of
straight away, `R` is right.

    RRRRRRRRRRRR
    RRRRRRRRRRRR
    RRRRRRRRRRRR
    RRRRRRRRRRRR
    RRRRRRRRRRRR
    LLLRRRRRRRRR
    LLLLLLLLLRRR
    LLLLLLLLLLLL
    LLLLLLLLLLLL
    LLLLLLLLLLLL
    LLLLLLLLLLLL
    LLLLLLLLLLLL
    on the line, the yaw rate is 0.1561 times the spin rate
"""

import numpy as np

import rimroll as rr

can = rr.bodies.can_2007()
flick = rr.State(tilt="20 deg", tilt_rate=-5)
rates = np.linspace(-0.5, 0.5, 12)
falls = rr.turn_map(can, flick, rr.NoSlip(), rates, rates)
for row in falls.direction.transpose("yaw_rate", "spin_rate").values:
    print("".join("L" if direction > np.pi else "R" for direction in row))
slope = rr.watershed_slope(can, flick.tilt, rr.NoSlip())
print(f"on the line, the yaw rate is {slope:.4f} times the spin rate")
