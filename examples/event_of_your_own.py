"""When does the table push with ten times the weight?

An event is a zero of any function of the motion. The near-collision is over in a fraction of a
millisecond; the search looks inside each of the solver's steps, which are short there.

    from 0.242869 s, for 299.8 µs
    meanwhile the contact point runs 3.000 rad round the rim
    at most 732 times the weight
"""

import rimroll as rr

can = rr.bodies.can_2007()
start = rr.State(tilt="30 deg", tilt_rate=-0.5, yaw_rate=0.005, spin_rate=0.005)
motion = rr.simulate(can, start, rr.NoSlip(), duration=1.0)
weight = can.mass * motion.gravity
begin, end, *_ = motion.crossings(lambda at: at.normal_force - 10 * weight)
print(f"from {begin.t:.6f} s, for {1e6 * (end.t - begin.t):.1f} µs")
run = abs(end.state.yaw - begin.state.yaw)
print(f"meanwhile the contact point runs {run:.3f} rad round the rim")
peak = motion.samples(20).normal_force.max() / weight
print(f"at most {peak:.0f} times the weight")
