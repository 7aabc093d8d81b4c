"""rimroll, as a Python user calls it: quadrature, and stepping in an ensemble; on one thread."""

import rimroll as rr

GRAVITY = 9.8
LAWS = {"no_slip": rr.NoSlip(), "frictionless": rr.Frictionless()}

ALL_AT_ONCE = True
"""Repeated starts are passed as one array."""


def prepare(method, coordinates, law, tolerance, starts):
    """A function without arguments that computes all turns."""
    can = rr.bodies.can_2007()
    tilt, tilt_rate, yaw_rate, spin_rate = starts.T.copy()
    state = rr.State(tilt=tilt, tilt_rate=tilt_rate, yaw_rate=yaw_rate, spin_rate=spin_rate)

    def quadrature():
        return rr.exact_turn(can, state, LAWS[law], gravity=GRAVITY, threads=1).turn

    def ensemble():
        falls = rr.ensemble(can, state, LAWS[law], gravity=GRAVITY, rtol=tolerance, threads=1)
        return falls["turn"].values

    return {"rimroll_quadrature": quadrature, "rimroll_ensemble": ensemble}[method]


def prepare_motion(method, coordinates, law, tolerance, starts):
    """A function without arguments for the yaw and the tilt after two seconds."""
    assert method == "rimroll_simulate"
    can = rr.bodies.can_2007()
    tilt, tilt_rate, yaw_rate, spin_rate = starts[0].tolist()
    start = rr.State(tilt=tilt, tilt_rate=tilt_rate, yaw_rate=yaw_rate, spin_rate=spin_rate)

    def compute():
        motion = rr.simulate(can, start, LAWS[law], duration=2.0, gravity=GRAVITY, rtol=tolerance)
        return motion.yaw[-1], motion.tilt[-1]

    return compute
