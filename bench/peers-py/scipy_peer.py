"""SciPy: solve_ivp with a terminal event; the right-hand side in plain floats, its fastest form."""

import math

import equations
import numpy as np
from scipy.integrate import solve_ivp

LONG = 1e3
"""Longer than any turn takes, in either clock."""

ATOL_OVER_RTOL = 1e-4

METHODS = {"scipy_dop853": "DOP853", "scipy_lsoda": "LSODA", "scipy_radau": "Radau"}


def prepare(method, coordinates, law, tolerance, starts):
    """A function without arguments that computes all turns."""
    rates = equations.rates(coordinates, law, math.sin, math.cos)
    place = equations.TILT_RATE[coordinates]
    states = [equations.begin(coordinates, start, math.sin, math.cos) for start in starts.tolist()]

    def derivatives(_, u):
        return rates(*u.tolist())

    def tilt_maximum(_, u):
        return u[place]

    tilt_maximum.direction, tilt_maximum.terminal = -1, True

    def turn(state):
        solution = solve_ivp(
            derivatives,
            (0.0, LONG),
            state,
            method=METHODS[method],
            rtol=tolerance,
            atol=ATOL_OVER_RTOL * tolerance,
            events=tilt_maximum,
        )
        found = solution.y_events[0]
        return found[0, equations.YAW] if len(found) else math.nan

    return lambda: np.array([turn(state) for state in states])
