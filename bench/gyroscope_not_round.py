"""How much does a phone that is not round, or beside the axis, change the veer that is read?

For the tin of examples/can_with_phone.toml and random bodies, Euler's equations for a body whose
moments across the axis differ, or whose centre of mass is beside it, are integrated
(tests/oracles/unsymmetric.py), let go in six directions of the phone, and read as if the body were
round. The script prints the differences from the veer of the round body. Run:

    PYTHONPATH=tests .venv/bin/python bench/gyroscope_not_round.py [--bodies 6]
"""

from __future__ import annotations

import argparse
import math
from pathlib import Path

import numpy as np

import rimroll as rr
from oracles.unsymmetric import Unsymmetric, rates_of
from rimroll.scenario import load

TIN = load(Path(__file__).parents[1] / "examples/can_with_phone.toml").body
RATE = 200.0
APART, BESIDE = 0.04, 0.02
"""Half the difference of the moments over their mean; the offset over the radius."""
DIRECTIONS = 6


def bodies(count: int) -> list[tuple[rr.Body, float, float]]:
    """The tin and random bodies, each with a tilt and a yaw rate at the release."""
    draw = np.random.default_rng(1)
    some = []
    for _ in range(count - 1):
        radius = draw.uniform(0.035, 0.06)
        height, mass = draw.uniform(0.8, 1.6) * radius, 0.3
        across = mass * (height**2 * draw.uniform(0.4, 0.9) + 0.4 * radius**2)
        some.append(
            rr.Body(mass, radius, height, across, mass * radius**2 * draw.uniform(0.4, 0.8))
        )
    more = [(body, 0.7 * float(rr.balance_tilt(body)), draw.uniform(0.03, 0.3)) for body in some]
    return [(TIN, 0.45, 0.05), *more]


def differences(body: rr.Body, tilt: float, yaw_rate: float, rolls: bool, fault: str) -> list[str]:
    """The veer that is read less that of the round body, degrees, in each direction."""
    law = rr.NoSlip() if rolls else rr.Frictionless()
    turn = rr.simulate(body, rr.State(tilt=tilt, yaw_rate=yaw_rate), law, 1.0).turns[0]
    across = body.transverse_inertia
    apart = APART * across if fault == "moments" else 0.0
    beside = BESIDE * body.radius if fault == "offset" else 0.0
    moments = (across - apart, across + apart, body.axial_inertia)
    other = Unsymmetric(body.mass, body.radius, body.height, moments, (beside, 0.0))
    duration = turn.end + 0.12
    t = np.arange(0.0, duration, 1.0 / RATE) + 0.0007
    found = []
    for k in range(DIRECTIONS):
        # The moments have two equal directions, the offset has one.
        direction = k * (math.pi if fault == "moments" else math.tau) / DIRECTIONS
        rates = rates_of(other, tilt, direction, yaw_rate, duration + 0.01, t, rolls)
        shown = np.concatenate([np.zeros((400, 3)), rates])
        shown += 1e-4 * np.random.default_rng(0).normal(size=shown.shape)
        record = rr.gyro.Record(np.arange(len(shown)) / RATE, shown)
        try:
            veer = rr.gyro.analyze(record, body, axis="z").collisions[0].veer
        except rr.RimrollError:
            found.append("not read")
            continue
        found.append(f"{math.degrees(veer - (abs(turn.angle) - math.pi)):.1f}°")
    return found


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--bodies", type=int, default=6)
    for body, tilt, yaw_rate in bodies(parser.parse_args().bodies):
        print(f"H/R {body.height / body.radius:.2f}, yaw rate {yaw_rate:.2f} rad/s")
        for rolls in (True, False):
            for fault in ("moments", "offset"):
                some = ", ".join(differences(body, tilt, yaw_rate, rolls, fault))
                print(f"  {'rolling' if rolls else 'sliding'}, {fault}: {some}", flush=True)


if __name__ == "__main__":
    main()
