"""numba: what a Python user writes by hand for speed, DOP853 compiled with its right-hand side.

The coefficients are SciPy's. The maximum is found by ordinary steps with the tilt rate as clock
(Hénon, Physica D 5 (1982) 412).
"""

import functools
import math

import equations
import numba
import numpy as np
from scipy.integrate._ivp import dop853_coefficients as dop853

STAGES = dop853.N_STAGES
ATOL_OVER_RTOL = 1e-4
MAX_STEPS = 200_000


def compile_it(function, **options):
    """Compiled with all of numba's optimisations that do not change results."""
    return numba.njit(function, fastmath={"contract"}, error_model="numpy", **options)


def sum_of(weights):
    """A compiled sum of stages; the weights are written out, so that zeros cost nothing."""
    terms = [f"{float(weight)!r} * k[{j}, i]" for j, weight in enumerate(weights) if weight]
    names = {}
    exec(f"def total(k, i):\n    return {' + '.join(terms)}", names)
    return compile_it(names["total"], inline="always")


def advance(weights, n):
    """A compiled out = u + h × a sum of stages."""
    total = sum_of(weights)

    @compile_it
    def write(u, h, k, out):
        for i in range(n):
            out[i] = u[i] + h * total(k, i)

    return write


@functools.cache
def compiled(coordinates, law):
    """The turns of an array of states at a tolerance."""
    n = 7 if coordinates == "regular" else 6
    place = equations.TILT_RATE[coordinates]
    rates = compile_it(equations.rates(coordinates, law, math.sin, math.cos))

    (
        stage_1,
        stage_2,
        stage_3,
        stage_4,
        stage_5,
        stage_6,
        stage_7,
        stage_8,
        stage_9,
        stage_10,
        stage_11,
    ) = (advance(dop853.A[stage, :stage], n) for stage in range(1, STAGES))
    last = advance(dop853.B, n)
    error_3, error_5 = sum_of(dop853.E3), sum_of(dop853.E5)

    @compile_it
    def derivatives(u, by_tilt_rate, out):
        if n == 7:
            values = rates(u[0], u[1], u[2], u[3], u[4], u[5], u[n - 1])
        else:
            values = rates(u[0], u[1], u[2], u[3], u[4], u[5])
        for i, value in enumerate(values):
            out[i] = value
        if by_tilt_rate:
            scale = 1.0 / out[place]
            for i in range(n):
                out[i] *= scale

    @compile_it
    def try_step(u, h, by_tilt_rate, rtol, stages, at, end):
        """One step to `end`; returns the error over the allowed error. stages[0] holds the
        rates."""
        stage_1(u, h, stages, at)
        derivatives(at, by_tilt_rate, stages[1])
        stage_2(u, h, stages, at)
        derivatives(at, by_tilt_rate, stages[2])
        stage_3(u, h, stages, at)
        derivatives(at, by_tilt_rate, stages[3])
        stage_4(u, h, stages, at)
        derivatives(at, by_tilt_rate, stages[4])
        stage_5(u, h, stages, at)
        derivatives(at, by_tilt_rate, stages[5])
        stage_6(u, h, stages, at)
        derivatives(at, by_tilt_rate, stages[6])
        stage_7(u, h, stages, at)
        derivatives(at, by_tilt_rate, stages[7])
        stage_8(u, h, stages, at)
        derivatives(at, by_tilt_rate, stages[8])
        stage_9(u, h, stages, at)
        derivatives(at, by_tilt_rate, stages[9])
        stage_10(u, h, stages, at)
        derivatives(at, by_tilt_rate, stages[10])
        stage_11(u, h, stages, at)
        derivatives(at, by_tilt_rate, stages[11])
        last(u, h, stages, end)
        derivatives(end, by_tilt_rate, stages[STAGES])
        of_5, of_3 = 0.0, 0.0
        for i in range(n):
            scale = rtol * (ATOL_OVER_RTOL + max(abs(u[i]), abs(end[i])))
            of_5 += (error_5(stages, i) / scale) ** 2
            of_3 += (error_3(stages, i) / scale) ** 2
        if of_5 == 0.0 and of_3 == 0.0:
            return 0.0
        return abs(h) * of_5 / math.sqrt((of_5 + 0.01 * of_3) * n)

    @compile_it
    def to_maximum(u, rtol, stages, at, end):
        """Takes u to the tilt maximum after the next minimum; returns whether it reached that."""
        by_tilt_rate, rising = False, False
        h = 1e-3
        derivatives(u, by_tilt_rate, stages[0])
        for _ in range(MAX_STEPS):
            if by_tilt_rate:
                h = min(h, -u[place])
            error = try_step(u, h, by_tilt_rate, rtol, stages, at, end)
            grown = 8.0 if error < 1e-12 else min(8.0, 0.9 * error**-0.125)
            if not error <= 1.0:
                h *= max(0.2, grown) if error == error else 0.1
                continue
            h *= max(0.2, grown)
            for i in range(n):
                u[i] = end[i]
                stages[0, i] = stages[STAGES, i]
            if by_tilt_rate and u[place] >= 0.0:
                return True
            if not by_tilt_rate:
                if rising and u[place] <= 0.0:
                    by_tilt_rate, h = True, -u[place]
                    derivatives(u, by_tilt_rate, stages[0])
                rising = u[place] > 0.0
        return False

    @compile_it
    def turns(states, rtol):
        stages = np.empty((STAGES + 1, n))
        u, at, end = np.empty(n), np.empty(n), np.empty(n)
        found = np.full(len(states), np.nan)
        for k in range(len(states)):
            u[:] = states[k]
            if to_maximum(u, rtol, stages, at, end):
                found[k] = u[0]
        return found

    return turns


def prepare(method, coordinates, law, tolerance, starts):
    """A function without arguments that computes all turns."""
    assert method == "numba_dop853"
    turns = compiled(coordinates, law)
    states = np.array(equations.begin(coordinates, starts.T, np.sin, np.cos)).T.copy()
    turns(states[:1], tolerance)
    return lambda: turns(states, tolerance)
