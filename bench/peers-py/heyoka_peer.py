"""heyoka: Taylor series of high order, compiled for the equations; its own terminal events."""

import functools
import math

import equations
import heyoka as hy
import numpy as np

LANES = {"heyoka": 1, "heyoka_4_lanes": 4, "heyoka_8_lanes": 8}
"""Starts at once: one vector of AVX2, one of AVX-512 where the processor has it."""

LONG = 1e3
"""Longer than any turn takes, in either clock."""


@functools.cache
def integrator(coordinates, law, tolerance, lanes):
    """The compiled integrator, which its event stops, and the lanes that have reached the event."""
    names = ["yaw", "sin", "cos", "p", "w", "s", "t"]
    if coordinates == "printed":
        names = ["yaw", "tilt", "spin", "psi", "phi", "theta"]
    variables = hy.make_vars(*names)
    right = equations.rates(coordinates, law, hy.sin, hy.cos)(*variables)
    system = list(zip(variables, right, strict=True))
    tilt_rate = variables[equations.TILT_RATE[coordinates]]
    downward = hy.event_direction.negative
    if lanes == 1:
        event = hy.t_event(tilt_rate, direction=downward)
        zeros = [0.0] * len(names)
        return hy.taylor_adaptive(system, zeros, t_events=[event], tol=tolerance), None
    reached = np.full(lanes, np.nan)

    def at_maximum(integrator, _, lane):
        """Record the yaw of a lane at its first maximum; stop when all lanes have reached
        theirs."""
        if math.isnan(reached[lane]):
            reached[lane] = integrator.state[equations.YAW, lane]
        return bool(np.isnan(reached).any())

    event = hy.t_event_batch(tilt_rate, direction=downward, callback=at_maximum)
    zeros = np.zeros((len(names), lanes))
    made = hy.taylor_adaptive_batch(
        system, zeros, t_events=[event], tol=tolerance, force_avx512=lanes == 8
    )
    return made, reached


def one_by_one(states, integrator):
    yaws = np.empty(len(states))
    for i, state in enumerate(states):
        integrator.state[:] = state
        integrator.time = 0.0
        integrator.reset_cooldowns()
        outcome = integrator.propagate_until(LONG)[0]
        stopped = outcome == hy.taylor_outcome(-1)
        yaws[i] = integrator.state[equations.YAW] if stopped else np.nan
    return yaws


def in_lanes(states, integrator, reached):
    lanes = len(reached)
    yaws = np.full(len(states), np.nan)
    for first in range(0, len(states), lanes):
        part = states[first : first + lanes]
        integrator.state[:, : len(part)] = part.T
        integrator.state[:, len(part) :] = part[0][:, None]
        integrator.set_time(0.0)
        integrator.reset_cooldowns()
        reached[:] = np.nan
        integrator.propagate_until(LONG)
        yaws[first : first + lanes] = reached[: len(part)]
    return yaws


def prepare(method, coordinates, law, tolerance, starts):
    """A function without arguments that computes all turns."""
    lanes = LANES[method]
    states = np.array(equations.begin(coordinates, starts.T, np.sin, np.cos)).T.copy()
    made, reached = integrator(coordinates, law, tolerance, lanes)
    if lanes == 1:
        return lambda: one_by_one(states, made)
    return lambda: in_lanes(states, made, reached)


@functools.cache
def motion_integrator(law, tolerance):
    """It stops after two seconds; extrema of the tilt are recorded on the way."""
    variables = hy.make_vars("yaw", "sin", "cos", "p", "w", "s", "t")
    right = equations.rates("regular", law, hy.sin, hy.cos)(*variables)
    extrema = []
    made = hy.taylor_adaptive(
        list(zip(variables, right, strict=True)),
        [0.0] * len(variables),
        nt_events=[hy.nt_event(variables[3], lambda ta, tau, sign: extrema.append(tau))],
        t_events=[hy.t_event(variables[6] - 2.0)],
        tol=tolerance,
    )
    return made, extrema


def prepare_motion(method, coordinates, law, tolerance, starts):
    """A function without arguments for the yaw and the tilt after two seconds."""
    assert (method, coordinates) == ("heyoka", "regular")
    begin = np.array(equations.begin(coordinates, starts[0], math.sin, math.cos))
    made, extrema = motion_integrator(law, tolerance)

    def compute():
        made.state[:] = begin
        made.time = 0.0
        made.reset_cooldowns()
        extrema.clear()
        made.propagate_until(LONG)
        return made.state[0], math.atan2(made.state[1], made.state[2])

    return compute
