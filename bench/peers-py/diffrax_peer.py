"""diffrax: Dormand and Prince's 8(5,3) as JAX compiles it for all starts at once (vmap)."""

import functools
import os

os.environ["XLA_FLAGS"] = "--xla_cpu_multi_thread_eigen=false intra_op_parallelism_threads=1"
os.environ["JAX_PLATFORMS"] = "cpu"

import diffrax
import equations
import jax
import jax.numpy as jnp
import optimistix
from diffrax import ODETerm, PIDController

jax.config.update("jax_enable_x64", True)

LONG = 1e3
"""Longer than any turn takes, in either clock."""

ATOL_OVER_RTOL = 1e-4

SOLVERS = {"diffrax_dopri8": diffrax.Dopri8, "diffrax_tsit5": diffrax.Tsit5}


@functools.cache
def compiled(method, coordinates, law):
    """The turns of an array of states at a tolerance."""
    rates = equations.rates(coordinates, law, jnp.sin, jnp.cos)
    place = equations.TILT_RATE[coordinates]
    term = ODETerm(lambda t, u, args: jnp.stack(rates(*u)))

    def turn(state, tolerance):
        event = diffrax.Event(
            lambda t, y, args, **rest: y[place],
            optimistix.Newton(rtol=1e-13, atol=1e-13),
            direction=False,
        )
        solution = diffrax.diffeqsolve(
            term,
            SOLVERS[method](),
            t0=0.0,
            t1=LONG,
            dt0=1e-3,
            y0=state,
            stepsize_controller=PIDController(rtol=tolerance, atol=ATOL_OVER_RTOL * tolerance),
            event=event,
            max_steps=100_000,
            throw=False,
        )
        found = diffrax.is_event(solution.result)
        return jnp.where(found, solution.ys[0, equations.YAW], jnp.nan)

    return jax.jit(jax.vmap(turn, in_axes=(0, None)))


def prepare(method, coordinates, law, tolerance, starts):
    """A function without arguments that computes all turns."""
    turns = compiled(method, coordinates, law)
    states = jnp.stack(equations.begin(coordinates, jnp.array(starts.T), jnp.sin, jnp.cos), axis=1)
    turns(states, tolerance).block_until_ready()
    return lambda: turns(states, tolerance).block_until_ready()
