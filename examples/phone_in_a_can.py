"""What would a phone record that stands in a can, and does its record show the friction?

A tin with a phone inside stands, is tipped by hand, held and let go on a table with friction 0.2.
The phone is simulated, with the noise and the other errors of data sheets. Its y axis, along its
longer side, is that of the tin. The file examples/simulated_phone_in_a_can.csv is this
record, as record.save writes it.

    760 samples, 200 Hz
    veer 54.7°, read as 53.7 ± 0.9°
    friction 0.2, read as 0.21 (0.19 to 0.22)
"""

from dataclasses import replace
from math import degrees
from pathlib import Path

import rimroll as rr
from rimroll.scenario import load

tin = load(Path(__file__).with_name("can_with_phone.toml")).body
start = rr.State(tilt="28 deg", yaw_rate=0.1, spin_rate=0.05)
motion = rr.simulate(tin, start, rr.Coulomb(0.2), duration=1.2)
record = rr.gyro.phone(sampling_rate=200.0).record(motion, rest=1.5, seed=2007)
record = replace(record, rates=record.rates[:, [1, 2, 0]])  # the phone's x, y and z
found = rr.gyro.analyze(record, tin)
print(f"{len(record)} samples, {record.sampling_rate:.0f} Hz")
for one, turn in zip(found.collisions, motion.turns, strict=False):
    error = degrees(one.veer_error)
    veer = abs(degrees(turn.angle)) - 180.0
    print(f"veer {veer:.1f}°, read as {degrees(one.veer):.1f} ± {error:.1f}°")
low, high = found.friction.interval
print(f"friction 0.2, read as {found.friction.best:.2f} ({low:.2f} to {high:.2f})")
