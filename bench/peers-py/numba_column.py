"""numba: DOP853 with a step that ends at each sample of the record."""

import functools
import math

import column
import numpy as np
from numba_peer import ATOL_OVER_RTOL, STAGES, advance, compile_it, dop853, sum_of

N = 6


@functools.cache
def compiled():
    """The state at the end of a record."""
    rates = compile_it(column.rates, inline="always")
    step = column.STEP
    stage = tuple(advance(dop853.A[i, :i], N) for i in range(1, STAGES))
    stage_1, stage_2, stage_3, stage_4, stage_5, stage_6 = stage[:6]
    stage_7, stage_8, stage_9, stage_10, stage_11 = stage[6:]
    last = advance(dop853.B, N)
    error_3, error_5 = sum_of(dop853.E3), sum_of(dop853.E5)
    c1, c2, c3, c4, c5, c6, c7, c8, c9, c10, c11 = map(float, dop853.C[1:STAGES])

    @compile_it
    def derivatives(u, at, x, out):
        values = rates(
            math.sin(u[0]),
            math.cos(u[0]),
            at[0, 0] + x * at[1, 0],
            at[0, 1] + x * at[1, 1],
            at[0, 2] + x * at[1, 2],
            u[1],
            u[2],
            u[3],
            u[4],
            u[5],
        )
        for i, value in enumerate(values):
            out[i] = value

    @compile_it
    def try_step(u, t, h, line, rtol, k, at, end):
        """A step of h from the time t after the sample; returns its error over the allowed one."""
        stage_1(u, h, k, at)
        derivatives(at, line, t + c1 * h, k[1])
        stage_2(u, h, k, at)
        derivatives(at, line, t + c2 * h, k[2])
        stage_3(u, h, k, at)
        derivatives(at, line, t + c3 * h, k[3])
        stage_4(u, h, k, at)
        derivatives(at, line, t + c4 * h, k[4])
        stage_5(u, h, k, at)
        derivatives(at, line, t + c5 * h, k[5])
        stage_6(u, h, k, at)
        derivatives(at, line, t + c6 * h, k[6])
        stage_7(u, h, k, at)
        derivatives(at, line, t + c7 * h, k[7])
        stage_8(u, h, k, at)
        derivatives(at, line, t + c8 * h, k[8])
        stage_9(u, h, k, at)
        derivatives(at, line, t + c9 * h, k[9])
        stage_10(u, h, k, at)
        derivatives(at, line, t + c10 * h, k[10])
        stage_11(u, h, k, at)
        derivatives(at, line, t + c11 * h, k[11])
        last(u, h, k, end)
        derivatives(end, line, t + h, k[STAGES])
        of_5, of_3 = 0.0, 0.0
        for i in range(N):
            scale = rtol * (ATOL_OVER_RTOL + max(abs(u[i]), abs(end[i])))
            of_5 += (error_5(k, i) / scale) ** 2
            of_3 += (error_3(k, i) / scale) ** 2
        if of_5 == 0.0 and of_3 == 0.0:
            return 0.0
        return abs(h) * of_5 / math.sqrt((of_5 + 0.01 * of_3) * N)

    @compile_it
    def follow(u, samples, rtol):
        k, at, end = np.empty((STAGES + 1, N)), np.empty(N), np.empty(N)
        line = np.empty((2, 3))
        wanted = step
        for i in range(len(samples) - 1):
            line[0] = samples[i]
            line[1] = (samples[i + 1] - samples[i]) / step
            if i == 0:
                derivatives(u, line, 0.0, k[0])
            t = 0.0
            while t < step:
                is_last = t + wanted >= step * (1.0 - 1e-12)
                h = step - t if is_last else wanted
                error = try_step(u, t, h, line, rtol, k, at, end)
                factor = 8.0 if error < 1e-12 else min(8.0, 0.9 * error**-0.125)
                if not error <= 1.0:
                    wanted = h * (max(0.2, factor) if error == error else 0.1)
                    if not wanted > 1e-14:
                        return False
                    continue
                wanted = max(wanted, h * factor) if is_last else h * max(0.2, factor)
                t = step if is_last else t + h
                for j in range(N):
                    u[j] = end[j]
                    k[0, j] = k[STAGES, j]
        return True

    return follow


def prepare_shaken(method, tolerance, tilts, record):
    """A function without arguments for the tilts at the end of the record."""
    assert method == "numba_dop853"
    follow = compiled()
    follow(column.begin(tilts[0]), record[:3], tolerance)

    def end_tilt(tilt):
        u = column.begin(tilt)
        return math.atan2(u[1], u[2]) if follow(u, record, tolerance) else math.nan

    return lambda: [end_tilt(tilt) for tilt in tilts]
