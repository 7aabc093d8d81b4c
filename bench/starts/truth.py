"""Writes the tables of starts in this folder, with the turns and motions of the can to 20 digits.

Taylor series of order 40 in numbers of 113 bits, by heyoka, in the regular coordinates; this does
not use rimroll. Run, after `bench/install.sh`:

    out/bench/venv/bin/python bench/starts/truth.py
"""

import math
import sys
from pathlib import Path

import heyoka as hy
import numpy as np

HERE = Path(__file__).parent
sys.path.insert(0, str(HERE.parent / "peers-py"))

import equations  # noqa: E402

LAWS = ("no_slip", "frictionless")
QUAD = hy.real128
BALANCE = math.atan2(equations.R, equations.H)

CAN = """\
# The can (m=0.070 kg, R=0.051 m, H=0.069 m, A/m=5.13e-3 m2, C/m=2.0e-3 m2, g=9.8 m/s2); yaw=spin=0.
"""


def integrator(law, stop):
    """Taylor's method for the regular coordinates with one terminal event, made by `stop`."""
    variables = hy.make_vars("yaw", "sin", "cos", "p", "w", "s", "t")
    right = equations.rates("regular", law, hy.sin, hy.cos)(*variables)
    zeros = [QUAD(0.0)] * len(variables)
    system = list(zip(variables, right, strict=True))
    return hy.taylor_adaptive(system, zeros, t_events=[stop(variables)], fp_type=QUAD)


def at_maximum(variables):
    return hy.t_event(variables[3], direction=hy.event_direction.negative, fp_type=QUAD)


def after_two_seconds(variables):
    return hy.t_event(variables[6] - 2.0, fp_type=QUAD)


def end(integrator, start):
    """The state at the event, from a release at (tilt, tilt rate, yaw rate, spin rate)."""
    start = np.array([QUAD(number) for number in start])
    integrator.state[:] = equations.begin("regular", start, np.sin, np.cos)
    integrator.time = QUAD(0.0)
    integrator.reset_cooldowns()
    outcome = integrator.propagate_until(QUAD(1e3))[0]
    assert outcome == hy.taylor_outcome(-1), outcome
    assert integrator.state[1] < math.sin(BALANCE) < integrator.state[2], "it toppled"
    return integrator.state


def write(name, about, head, rows):
    lines = [CAN, f"# {about}\n", ",".join(head) + "\n"]
    lines += [",".join(row) + "\n" for row in rows]
    (HERE / name).write_text("".join(lines), encoding="utf-8")


def near_collisions():
    """Eight tilts for each of eps = 1e-1 ... 1e-12, the yaw and spin rate."""
    turns = [integrator(law, at_maximum) for law in LAWS]
    for power in range(1, 13):
        for degrees in np.linspace(20.0, 32.0, 8):
            start = (math.radians(degrees), -0.5, 10.0**-power, 10.0**-power)
            found = [str(end(turn, start)[equations.YAW]) for turn in turns]
            yield [*(repr(float(number)) for number in start), *found]


def two_seconds():
    """The motion that the paper shows."""
    start = (math.pi / 6.0, -0.5, 0.005, 0.005)
    cells = [repr(number) for number in start]
    for law in LAWS:
        state = end(integrator(law, after_two_seconds), start)
        cells += [str(state[0]), str(np.arctan2(state[1], state[2]))]
    yield cells


def main():
    starts = ["tilt", "tilt_rate", "yaw_rate", "spin_rate"]
    write(
        "near_collisions.csv",
        "Ever nearer: turn from release to the first tilt maximum after the near-collision, rad.",
        [*starts, *(f"turn_{law}" for law in LAWS)],
        near_collisions(),
    )
    write(
        "two_seconds.csv",
        "The paper's motion: yaw and tilt after 2 s, rad.",
        [*starts, *(f"{angle}_{law}" for law in LAWS for angle in ("yaw", "tilt"))],
        two_seconds(),
    )


if __name__ == "__main__":
    main()
