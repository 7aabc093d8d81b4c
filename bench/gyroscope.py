"""How well does a gyroscope in a can show the veer and the friction?

Falls of the tin of examples/can_with_phone.toml are simulated with a known friction, recorded by a
simulated sensor, and read. The script prints, for sensors of several sampling rates, noises and
misalignments, the median error of the veer, how often it lies within its standard deviation and
within two, the median width of the 95 % interval of the friction, and how often that holds the
truth. Run:

    .venv/bin/python bench/gyroscope.py [--records 60]
"""

from __future__ import annotations

import argparse
import math
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path

import numpy as np

import rimroll as rr
from rimroll.gyro.sensor import TIPPING
from rimroll.scenario import load

TIN = load(Path(__file__).parents[1] / "examples/can_with_phone.toml").body
REST, HELD = 1.0, 0.5
RELEASE = REST + TIPPING + HELD
USUAL = rr.gyro.phone(200.0)

SENSORS = {
    "200 Hz, noise of the data sheet, 1° askew": USUAL,
    "100 Hz": rr.gyro.phone(100.0),
    "400 Hz": rr.gyro.phone(400.0),
    "1000 Hz": rr.gyro.phone(1000.0),
    "ten times the noise": replace(USUAL, noise_density=10.0 * USUAL.noise_density),
    "5° askew": replace(USUAL, misalignment=math.radians(5.0)),
    "range of 250 degrees/s": rr.gyro.phone(200.0, range=math.radians(250.0)),
    "filter at 20 Hz": replace(USUAL, bandwidth=20.0),
}


@dataclass(frozen=True)
class Reading:
    """The first veer of a record: its error and standard deviation, rad; the friction's interval.

    ``width`` is None where the interval has no end; all is None where the record was refused.
    """

    error: float | None = None
    deviation: float | None = None
    width: float | None = None
    holds: bool = False


def reading(sensor: rr.gyro.Sensor, seed: int) -> Reading:
    """One record, read."""
    draw = np.random.default_rng(seed)
    friction = draw.uniform(0.05, 0.9 * rr.needed_friction(TIN))
    start = rr.State(
        tilt=rr.balance_tilt(TIN) * draw.uniform(0.6, 0.85),
        yaw_rate=draw.normal(0.0, 0.1),
        spin_rate=draw.normal(0.0, 0.1),
    )
    motion = rr.simulate(TIN, start, rr.Coulomb(friction), duration=1.2)
    record = sensor.record(motion, rest=REST, held=HELD, seed=seed)
    try:
        found = rr.gyro.analyze(record, TIN, axis="z")
    except rr.RimrollError:
        return Reading()
    first = found.collisions[0]
    if abs(first.time - RELEASE - motion.turns[0].t) > 0.02:
        return Reading()  # the first near-collision was not read
    error = first.veer - (abs(motion.turns[0].angle) - math.pi)
    interval = found.friction.interval
    if interval is None:
        return Reading(error, first.veer_error)
    low, high = interval
    holds = low <= friction and (high is None or friction <= high)
    return Reading(error, first.veer_error, None if high is None else high - low, holds)


def row(name: str, readings: list[Reading]) -> str:
    """A line of the table."""
    read = [one for one in readings if one.error is not None]
    if not read:
        return f"| {name} | 0 of {len(readings)} | | | | | |"
    off = np.array([abs(one.error / one.deviation) for one in read])
    error = math.degrees(float(np.median([abs(one.error) for one in read])))
    width = float(np.median([math.inf if one.width is None else one.width for one in read]))
    return (
        f"| {name} | {len(read)} of {len(readings)} | {error:.2f}° | {100 * (off < 1).mean():.0f} %"
        f" | {100 * (off < 2).mean():.0f} % | {width:.3f}"
        f" | {100 * np.mean([one.holds for one in read]):.0f} % |"
    )


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--records", type=int, default=60, help="for each sensor")
    records = parser.parse_args().records
    print("| sensor | read | median error of the veer | within 1 s.d. | within 2 | width | holds |")
    print("|---|--:|--:|--:|--:|--:|--:|")
    with ProcessPoolExecutor(2) as pool:
        for name, sensor in SENSORS.items():
            print(row(name, list(pool.map(partial(reading, sensor), range(records)))), flush=True)


if __name__ == "__main__":
    main()
