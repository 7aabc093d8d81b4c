"""Growth rates of disturbances of a steady motion under any law, by derivatives of the flow."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from rimroll import _core
from rimroll.body import Body, one_body
from rimroll.errors import RimrollError, expect
from rimroll.given import Number, positive
from rimroll.laws import Law, one_law
from rimroll.motion import Motion, simulate
from rimroll.state import State, single

QUANTITIES = ("tilt", "tilt_rate", "yaw_rate", "spin_rate")
"""What is disturbed and observed; yaw and spin themselves do not matter."""

BLOCKS = 12
"""Rows of blocks in the Hankel matrix; twice as many derivatives are taken."""

STEPS_PER_RADIAN = 2.0
"""Derivatives while the fastest rotation of the motion turns by one radian."""

NOISE = 1e-6
"""Singular values below this fraction of the largest are errors of the derivatives."""

DISTURBANCES = (1e-8, 1e-7, 1e-6, 1e-9)
"""Tilt rates, in units of √(g/R), that are added to the start, one after the other until the
derivatives are accurate. With them the solver's steps follow disturbances; on an exactly steady
motion it would take steps of any length."""

LARGEST_ORDER = 6
"""Tilt, its rate, two rates and the slip."""

STEADY = 1e-4
"""The largest change of the tilt of a steady motion, rad."""

LARGEST_GROWTH = 100.0
"""By which factor a disturbance may grow, so that it leaves others to be seen."""

HALVINGS = 5
"""How often the duration is halved where a disturbance grows beyond that."""


def growth_rates(
    body: Body,
    start: State,
    law: Law,
    *,
    duration: Number | None = None,
    gravity: Number = _core.STANDARD_GRAVITY,
) -> NDArray[np.complex128]:
    """The rates at which small disturbances of a steady motion grow, 1/s, under any law.

    Parameters
    ----------
    body, start, law
        A steady motion: tilt, yaw rate and spin rate stay constant from this start. It may be one
        of :func:`rimroll.steady_motions`, whose ``start`` it has, or that of an upright disk.
    duration
        How long disturbances are followed, s. By default, until the motion has turned by 12 radians
        (at its yaw or spin rate, or at √(g/R) if that is larger). It is shortened if disturbances
        grow too fast.
    gravity
        m/s².

    Returns
    -------
    array of complex
        The eigenvalues λ of disturbances exp(λt), the largest real part first: a positive real part
        is an instability, an imaginary part an oscillation. Zeros belong to neighbouring steady
        motions. Disturbances that vanish within the duration are not among them.

    Raises
    ------
    RimrollError
        A number outside its bounds, or a motion that is not steady or whose derivatives are not
        accurate enough.

    Notes
    -----
    The motion is simulated with its exact derivatives. M(t), those of the tilt, its rate and the
    other two rates by the same quantities of the start, is C exp(Lt) B with the generator L. Under
    laws that allow slip, L also contains the slip, which is neither given at the start nor
    observed. So L follows from M at equal steps by the eigensystem realization algorithm (J.-N.
    Juang and R. S. Pappa, J. Guidance 8, 1985): the Hankel matrix of M, reduced to its range, and
    the same one step later. Under dry friction a rim that sticks with a margin of friction also
    sticks in small disturbances, and the rates are those without slip.
    """
    one_body(body)
    expect("start", start, State)
    one_law(law)
    g, release = positive("gravity", gravity, "m/s^2"), single(start)
    falling_rate = math.sqrt(g / body.radius)
    fastest = max(falling_rate, abs(release.yaw_rate), abs(release.spin_rate))
    length = 2 * BLOCKS / (STEPS_PER_RADIAN * fastest)
    if duration is not None:
        length = positive("duration", duration, "s")
    for disturbance in DISTURBANCES:
        disturbed = replace(release, tilt_rate=release.tilt_rate + disturbance * falling_rate)
        flow, step = _followed(body, disturbed, law, length, g, fastest)
        multipliers = _multipliers(flow)
        if multipliers is not None:
            rates = np.log(multipliers.astype(complex)) / step
            return np.asarray(rates[np.argsort(-rates.real)])
    raise RimrollError(
        "the derivatives of the motion are not accurate enough for growth rates; choose another"
        " duration"
    )


def _followed(
    body: Body, start: State[float], law: Law, length: float, gravity: float, fastest: float
) -> tuple[NDArray[np.float64], float]:
    """M at equal steps and the step, s, for so short a time that no disturbance grows too large."""
    for _ in range(HALVINGS):
        motion = simulate(body, start, law, length, gravity=gravity, rtol=1e-12, jacobian=True)
        if motion.status == "finished" and np.ptp(motion.tilt) < STEADY:
            step = length / (2 * BLOCKS)
            flow = _flow(motion, step, fastest)
            if np.abs(flow).max() < LARGEST_GROWTH:
                return flow, step
        length *= 0.5
    raise RimrollError(
        f"the motion is not steady: within {2.0 * length:.3g} s its tilt goes from"
        f" {motion.tilt.min():.6g} to {motion.tilt.max():.6g} rad ({motion.status})"
    )


def _flow(motion: Motion, step: float, fastest: float) -> NDArray[np.float64]:
    """M at equal steps, shape (2 BLOCKS, 4, 4), with rates in units of the fastest one."""
    found = motion.jacobian(np.minimum(step * np.arange(1, 2 * BLOCKS + 1), motion.t[-1]))
    by_names = [[found[row, column] for column in QUANTITIES] for row in QUANTITIES]
    units = np.array([1.0, fastest, fastest, fastest])
    flow: NDArray[np.float64] = np.moveaxis(np.array(by_names), -1, 0) * units / units[:, None]
    if not np.isfinite(flow).all():
        raise RimrollError("the motion has no derivatives: its contact changes at the start")
    return flow


def _multipliers(flow: NDArray[np.float64]) -> NDArray[np.complex128] | None:
    """The eigenvalues of the flow over one step, of the smallest system with these derivatives.

    None if that system has more quantities than a rim on a table, as errors have.
    """
    now, later = (
        np.block([[flow[i + j + shift] for j in range(BLOCKS)] for i in range(BLOCKS)])
        for shift in (0, 1)
    )
    left, sizes, right = np.linalg.svd(now)
    kept = int((sizes > NOISE * sizes[0]).sum())
    if kept > LARGEST_ORDER:
        return None
    root = 1.0 / np.sqrt(sizes[:kept])
    reduced = (root[:, None] * left[:, :kept].T) @ later @ (right[:kept].T * root)
    multipliers: NDArray[np.complex128] = np.linalg.eigvals(reduced)
    return multipliers
