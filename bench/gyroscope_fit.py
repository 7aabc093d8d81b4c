"""How often do the intervals of rr.fit_motion contain the true value?

Falls of the tin of examples/can_with_phone.toml under dry friction are simulated, with the tin's
radius, height and moments of inertia wrong by 1 % at random, and recorded by a simulated sensor.
The script prints, for sensors of several kinds, how many records were fitted, the median error of
the friction, the median width of its 95 % interval, how many of these intervals contain the true
value, how many of those of the yaw rate and the spin rate at the release, how often rolling without
slip and sliding without friction are both excluded, and how many excluded laws were the truth. Run:

    .venv/bin/python bench/gyroscope_fit.py [--records 24] [--processes 2]
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
from rimroll.scenario import load

TIN = load(Path(__file__).parents[1] / "examples/can_with_phone.toml").body
DEGREE = math.radians(1.0)
USUAL = rr.gyro.phone(200.0)
BMI270 = replace(USUAL, noise_density=7e-3 * DEGREE, bias=0.5 * DEGREE, resolution=DEGREE / 16.4)
"""Bosch, data sheet BST-BMI270-DS000."""
MPU6050 = replace(
    USUAL,
    noise_density=5e-3 * DEGREE,
    bias=10.0 * DEGREE,
    resolution=DEGREE / 16.4,
    scale_error=0.015,
)
"""InvenSense, product specification PS-MPU-6000A-00, revision 3.4, section 6.1; of its limits for
the zero-rate output (20 degrees/s) and the sensitivity (3 %), half is the standard deviation."""
SENSORS = {
    "LSM6DSO, 200 Hz, 1° askew": USUAL,
    "100 Hz": rr.gyro.phone(100.0),
    "400 Hz": rr.gyro.phone(400.0),
    "ten times the noise": replace(USUAL, noise_density=10.0 * USUAL.noise_density),
    "range of 250 degrees/s": rr.gyro.phone(200.0, range=math.radians(250.0)),
    "BMI270": BMI270,
    "MPU-6050": MPU6050,
    "filter at 20 Hz": replace(USUAL, bandwidth=20.0),
}
BODY_ERROR = 0.01


@dataclass(frozen=True)
class Fitted:
    """One record: the friction, its interval and the verdicts; None where it was refused."""

    truth: float
    friction: float | None = None
    interval: tuple[float, float | None] | None = None
    wrong: bool = False
    excluded: tuple[bool, bool] = (False, False)
    start_holds: bool = False
    why: str = ""

    @property
    def holds(self) -> bool:
        """Whether the interval contains the true value."""
        assert self.interval is not None
        low, high = self.interval
        return low <= self.truth and (high is None or self.truth <= high)


def fitted(sensor: rr.gyro.Sensor, seed: int) -> Fitted:
    """One record, fitted; one in six rolls, one in six slides without friction."""
    draw = np.random.default_rng(seed)
    true = replace(
        TIN,
        **{
            name: getattr(TIN, name) * (1.0 + BODY_ERROR * draw.normal())
            for name in ("radius", "height", "transverse_inertia", "axial_inertia")
        },
    )
    needed = rr.needed_friction(true)
    kind = draw.integers(6)
    friction = {0: 2.0 * needed, 1: 0.0}.get(int(kind), draw.uniform(0.05, 0.95) * needed)
    start = rr.State(
        tilt=rr.balance_tilt(TIN) * draw.uniform(0.6, 0.85),
        yaw_rate=draw.normal(0.0, 0.1),
        spin_rate=draw.normal(0.0, 0.1),
    )
    motion = rr.simulate(true, start, rr.Coulomb(friction), duration=1.2)
    record = sensor.record(motion, rest=1.0, held=0.5, seed=seed)
    try:
        fit = rr.fit_motion(record, TIN, axis="z", body_error=BODY_ERROR)
    except rr.RimrollError as error:
        return Fitted(friction, why=str(error))
    if len(fit.starts) > 1:
        return Fitted(friction, why="its release was not read")
    _, rolling, sliding = fit.verdicts
    wrong = (friction == 0.0 and sliding.excluded) or (friction > needed and rolling.excluded)
    excluded = (rolling.excluded, sliding.excluded)
    found = fit.numbers["friction"]
    start_holds = True
    for name in ("yaw_rate", "spin_rate"):
        low, high = fit.numbers[name].interval
        start_holds &= low <= getattr(start, name) <= high
    return Fitted(
        friction, found.value, found.interval, wrong, excluded, start_holds, "; ".join(fit.notes)
    )


def row(name: str, all_of_them: list[Fitted]) -> str:
    """A line of the table."""
    some = [one for one in all_of_them if one.friction is not None]
    if not some:
        return f"| {name} | 0 of {len(all_of_them)} | | | | | | |"
    needed = rr.needed_friction(TIN)
    slips = [one for one in some if 0.0 < one.truth < needed]
    error = float(np.median([abs(one.friction - one.truth) for one in slips]))
    widths = [
        math.inf if one.interval[1] is None else one.interval[1] - one.interval[0] for one in slips
    ]
    both = np.mean([all(one.excluded) for one in slips])
    return (
        f"| {name} | {len(some)} of {len(all_of_them)} | {error:.4f} | {np.median(widths):.4f}"
        f" | {sum(one.holds for one in some)} | {sum(one.start_holds for one in some)}"
        f" | {100.0 * both:.0f} %"
        f" | {sum(one.wrong for one in some)} of {len(some) - len(slips)} |"
    )


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--records", type=int, default=24, help="for each sensor")
    parser.add_argument("--sensors", type=int, default=len(SENSORS), help="how many sensors")
    parser.add_argument("--processes", type=int, default=2)
    parser.add_argument("--each", action="store_true", help="print every record, too")
    given = parser.parse_args()
    print(
        "| sensor | fitted | median error | median width | holds | start holds | excludes both"
        " | wrongly |"
    )
    print("|---|--:|--:|--:|--:|--:|--:|--:|")
    with ProcessPoolExecutor(given.processes) as pool:
        for name, sensor in list(SENSORS.items())[: given.sensors]:
            found = list(pool.map(partial(fitted, sensor), range(given.records)))
            print(row(name, found), flush=True)
            if given.each:
                for seed, one in enumerate(found):
                    print(seed, one)


if __name__ == "__main__":
    main()
