"""SciPy: DOP853, begun again at each sample of the record; the right-hand side in plain floats."""

import itertools
import math

import column
from scipy.integrate import DOP853
from scipy_peer import ATOL_OVER_RTOL


def prepare_shaken(method, tolerance, tilts, record):
    """A function without arguments for the tilts at the end of the record."""
    assert method == "scipy_dop853"
    samples, step = record.tolist(), column.STEP

    def end_tilt(tilt):
        u, wanted = column.begin(tilt), step
        for i, (a, b) in enumerate(itertools.pairwise(samples)):
            begin, end = i * step, (i + 1) * step
            slope = [(q - p) / step for p, q in zip(a, b, strict=True)]

            def derivatives(t, u, begin=begin, a=a, slope=slope):
                yaw, *others = u.tolist()
                now = [p + q * (t - begin) for p, q in zip(a, slope, strict=True)]
                return column.rates(math.sin(yaw), math.cos(yaw), *now, *others)

            solver = DOP853(
                derivatives,
                begin,
                u,
                end,
                first_step=min(wanted, end - begin),
                rtol=tolerance,
                atol=ATOL_OVER_RTOL * tolerance,
            )
            while solver.status == "running":
                solver.step()
            if solver.status == "failed":
                return math.nan
            u, wanted = solver.y, solver.h_abs
        return math.atan2(u[1], u[2])

    return lambda: [end_tilt(tilt) for tilt in tilts]
