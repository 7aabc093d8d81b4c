"""Random bodies on grounds that move at random, for rimroll and for the oracle.

The oracle has formulas of its own for the ground.
"""

from dataclasses import dataclass

import numpy as np
from hypothesis import strategies as st

import rimroll as rr
from given.strategies import sizes
from oracles.shaken_body import Pulse, Table


@dataclass(frozen=True)
class Shaking:
    """A motion of the table, as rimroll has it and as the oracle has it."""

    ground: rr.Ground
    table: Table


def sine(amplitude, period, cycles):
    shape = Pulse(amplitude, lambda t: np.sin(2 * np.pi * t / period), cycles * period)
    return Shaking(rr.ground.sine(amplitude, period, cycles), Table((shape,)))


def half_sine(amplitude, period, cycles):
    """Half a sine, `cycles` of a period long."""
    end = cycles * period
    shape = Pulse(amplitude, lambda t: np.sin(np.pi * t / end), end)
    return Shaking(rr.ground.half_sine(amplitude, end), Table((shape,)))


def ricker(amplitude, period, cycles):
    """The peak is `cycles` of a period after the start."""
    center = cycles * period

    def shape(t):
        square = (np.pi * (t - center) / period) ** 2
        return (1 - 2 * square) * np.exp(-square)

    wavelet = Pulse(amplitude, shape, center + 2 * period)
    return Shaking(rr.ground.ricker(amplitude, period, center), Table((wavelet,)))


def rectangular(amplitude, period, cycles):
    """A constant acceleration, `cycles` of a period long."""
    end = cycles * period
    block = Pulse(amplitude, lambda t: 1.0, end)
    return Shaking(rr.ground.rectangular(amplitude, end), Table((block,)))


def sampled(amplitude, period, cycles):
    """Noise of this size, `cycles` of a period long with eight samples each."""
    count = 2 + int(8 * cycles)
    seed = int(1e6 * cycles)
    noise = np.random.default_rng(seed).uniform(-1.0, 1.0, (count, 3)) * amplitude
    return Shaking(rr.ground.sampled(period / 8, noise), Table((), period / 8, noise))


PULSES = [sine, half_sine, ricker, rectangular]
KINDS = [*PULSES, sampled]


@dataclass(frozen=True)
class ShakenStart:
    """A body, its start, the motion of the table and a duration (s)."""

    body: rr.Body
    start: rr.State
    shaking: Shaking
    duration: float


def signs():
    """Numbers between -1 and 1."""
    return st.floats(-1.0, 1.0)


@st.composite
def heavy_bodies(draw):
    """Bodies given by five numbers, from needles to plates, disks among them."""
    mass, radius = draw(sizes(0.01, 1000.0)), draw(sizes(0.01, 1.0))
    height = draw(st.floats(0.3, 5.0) | sizes(0.01, 0.5) | st.just(0.0))
    transverse = draw(sizes(0.05, 20.0))
    return rr.Body(
        mass=mass,
        radius=radius,
        height=height * radius,
        transverse_inertia=transverse * mass * radius**2,
        axial_inertia=transverse * draw(st.floats(0.02, 2.0)) * mass * radius**2,
    )


@st.composite
def grounds(draw, acceleration, time):
    """A pulse or a record, or the sum of two.

    Horizontal amplitudes reach twice `acceleration` (m/s2), vertical ones 20 m/s2: the table may
    fall away. Some are zero. Periods are between 0.3 and 3 of `time` (s).
    """

    def ground(kinds):
        parts = [draw(signs() | st.just(0.0)) for _ in range(3)]
        amplitude = np.array([2 * acceleration, 2 * acceleration, 20.0]) * parts
        period = time * draw(sizes(0.3, 3.0))
        return draw(st.sampled_from(kinds))(amplitude, period, draw(st.floats(0.3, 2.5)))

    one = ground(KINDS)
    # Only one of them may be a record.
    return added(one, ground(PULSES)) if draw(st.booleans()) else one


@st.composite
def shaken_starts(draw):
    """Bodies that are let go at any tilt, and motions of the table that can tip or slide them."""
    body = draw(heavy_bodies())
    slenderness = body.height / body.radius
    inertia = body.transverse_inertia + body.mass * (body.radius**2 + body.height**2)
    time = float(np.sqrt(inertia / (body.mass * 9.81 * body.radius)))
    rate = float(np.sqrt(9.81 / body.radius))
    start = rr.State(
        tilt=draw(st.floats(0.02, 1.3)),
        tilt_rate=draw(signs()) / time,
        yaw=draw(st.floats(-3.0, 3.0)),
        yaw_rate=draw(signs()) * rate,
        spin=draw(st.floats(-3.0, 3.0)),
        spin_rate=draw(signs()) * rate,
    )
    shaking = draw(grounds(9.81 / max(slenderness, 0.5), time))
    return ShakenStart(body, start, shaking, 3.0 * time)


def added(one, other):
    pulses = one.table.pulses + other.table.pulses
    return Shaking(one.ground + other.ground, Table(pulses, one.table.step, one.table.samples))
