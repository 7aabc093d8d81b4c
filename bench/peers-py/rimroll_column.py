"""rimroll, as a Python user calls it: a column in one motion after another, and in one call; on one
thread."""

import column

import rimroll as rr


def prepare_shaken(method, tolerance, tilts, record):
    """A function without arguments for the tilts at the end of the record."""
    mass = 1000.0
    body = rr.Body(
        mass=mass,
        radius=column.R,
        height=column.H,
        transverse_inertia=mass * column.A,
        axial_inertia=mass * column.C,
    )
    ground, law = rr.ground.sampled(column.STEP, record), rr.NoSlip()
    options = {"gravity": column.G, "rtol": tolerance, "duration": ground.duration}

    def alone():
        starts = (rr.State(tilt=float(tilt)) for tilt in tilts)
        motions = (rr.simulate(body, at, law, ground=ground, **options) for at in starts)
        return [motion.tilt[-1] for motion in motions]

    def many():
        found = rr.shake_many(body, rr.State(tilt=tilts), law, ground, threads=1, **options)
        return found["end_tilt"].values

    return {"rimroll_simulate": alone, "rimroll_shake_many": many}[method]
