"""How well does a gyroscope in a body show the veer and the friction?

Falls of random bodies with random frictions, from ice to rolling, are simulated, recorded by a
simulated sensor that is mounted askew, and read. For each sensor the script prints how many records
could be read, the median error of the veers beside that which the stated errors lead one to expect,
how often a veer and the friction lie in their 95 % intervals, how many veers are wrong by a whole
turn although their side is called sure, and how often an ideal law is excluded that holds. Run:

    .venv/bin/python bench/gyroscope.py [--records 60] [--seed 1]
"""

from __future__ import annotations

import argparse
import math
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass, field, replace
from functools import partial

import numpy as np
from scipy.stats import norm

import rimroll as rr
from rimroll.sensors.gyro.sensor import TIPPING

REST, HELD = 1.0, 0.5
RELEASE = REST + TIPPING + HELD
USUAL = rr.gyro.phone(200.0)
ASKEW = math.radians(5.0)
"""The largest standard deviation of the mounting in each of two directions."""

SENSORS = {
    "200 Hz, noise of the data sheet": USUAL,
    "100 Hz": rr.gyro.phone(100.0),
    "400 Hz": rr.gyro.phone(400.0),
    "ten times the noise": replace(USUAL, noise_density=10.0 * USUAL.noise_density),
    "range of 250 degrees/s": rr.gyro.phone(400.0, range=math.radians(250.0)),
    "BMI270": replace(USUAL, noise_density=math.radians(7e-3), bias=math.radians(0.5)),
    "filter at 30 Hz": replace(USUAL, bandwidth=30.0),
}


@dataclass(frozen=True)
class Reading:
    """What was read from a record; its veers stay empty if it was refused.

    ``veers`` has the error and the standard deviation of each veer, rad, and whether its side was
    called sure. ``holds`` is None where no interval of the friction is stated.
    """

    veers: list[tuple[float, float, bool]] = field(default_factory=list)
    holds: bool | None = None
    wrongly_excluded: bool = False


def random_fall(draw: np.random.Generator) -> tuple[rr.Body, float, rr.Motion]:
    """A round body like a can, the friction of its table (infinite if it rolls), and its motion."""
    radius, mass = draw.uniform(0.03, 0.06), draw.uniform(0.1, 0.5)
    height = radius * draw.uniform(0.6, 1.8)
    across = mass * (height**2 * draw.uniform(0.4, 1.2) + 0.3 * radius**2)
    along = min(mass * radius**2 * draw.uniform(0.4, 0.9), 1.8 * across)
    body = rr.Body(mass, radius, height, across, along)
    kind = draw.random()
    part = math.inf if kind < 0.15 else 0.0 if kind < 0.3 else draw.uniform(0.03, 1.2)
    friction = part * float(rr.needed_friction(body))
    start = rr.State(
        tilt=rr.balance_tilt(body) * draw.uniform(0.5, 0.85),
        tilt_rate=-draw.choice([0.0, draw.uniform(0.1, 1.0)]),
        yaw_rate=draw.normal(0.0, 0.15),
        spin_rate=draw.normal(0.0, 0.15),
    )
    law = rr.NoSlip() if math.isinf(friction) else rr.Coulomb(friction)
    return body, friction, rr.simulate(body, start, law, duration=1.2)


def reading(sensor: rr.gyro.Sensor, seed: tuple[int, int]) -> Reading:
    """One record, read."""
    draw = np.random.default_rng(seed)
    body, friction, motion = random_fall(draw)
    mounted = replace(sensor, misalignment=draw.uniform(0.0, ASKEW))
    record = mounted.record(motion, rest=REST, held=HELD, seed=int(draw.integers(2**32)))
    try:
        found = rr.gyro.analyze(record, body, axis="z")
    except rr.RimrollError:
        return Reading()
    veers = []
    for one in found.collisions:
        turn = min(motion.turns, key=lambda turn: abs(RELEASE + turn.t - one.time))
        error = abs(one.turn) - abs(turn.angle)
        veers.append((error, one.veer_error, one.side_is_sure))
    rolls = friction >= rr.needed_friction(body)
    wrongly = (found.friction.excludes_rolling and rolls) or (
        found.friction.excludes_sliding and friction == 0.0
    )
    if found.friction.interval is None:
        return Reading(veers, None, wrongly)
    low, high = found.friction.interval
    return Reading(veers, low <= friction and (high is None or friction <= high), wrongly)


def row(name: str, readings: list[Reading]) -> str:
    """A line of the table."""
    read = [one for one in readings if one.veers]
    veers = np.array([veer for one in read for veer in one.veers]).reshape(-1, 3)
    if not len(veers):
        return f"| {name} | 0 of {len(readings)} | | | | | | | |"
    error, deviation, sure = np.abs(veers[:, 0]), veers[:, 1], veers[:, 2] > 0
    expected = norm.ppf(0.75) * np.median(deviation)
    holds = [one.holds for one in read if one.holds is not None]
    return (
        f"| {name} | {len(read)} of {len(readings)} | {len(veers)}"
        f" | {math.degrees(np.median(error)):.2f}° | {math.degrees(expected):.2f}°"
        f" | {100 * (error < norm.ppf(0.975) * deviation).mean():.0f} %"
        f" | {sum(holds)} of {len(holds)} | {(sure & (error > math.radians(40.0))).sum()}"
        f" | {sum(one.wrongly_excluded for one in read)} |"
    )


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--records", type=int, default=60, help="for each sensor")
    parser.add_argument("--seed", type=int, default=1, help="others give other records")
    given = parser.parse_args()
    print(
        "| sensor | read | veers | median error | stated | veer holds | friction holds"
        " | a turn wrong and sure | laws wrongly excluded |"
    )
    print("|---|--:|--:|--:|--:|--:|--:|--:|--:|")
    seeds = [(given.seed, number) for number in range(given.records)]
    everything = []
    with ProcessPoolExecutor(2) as pool:
        for name, sensor in SENSORS.items():
            readings = list(pool.map(partial(reading, sensor), seeds))
            everything += readings
            print(row(name, readings), flush=True)
    print(row("all", everything))


if __name__ == "__main__":
    main()
