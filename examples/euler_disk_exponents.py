"""How does Euler's disk come to rest?

The tilt of a disk that loses the power Ω^λ at a wobble rate Ω falls like (t₀ − t)^(2/(2 + λ)). The
exponent tells what stops a disk: dry rolling resistance (λ = 1), viscous rolling resistance (2), or
the air under it (4, Moffatt 2000). The end t₀ is fitted, too, and the 95 % interval of the exponent
includes its uncertainty. It holds for the window, from a half to a tenth of the first tilt.

    dry rolling      0.667, 0.666 to 0.667 (law: 0.667)
    viscous rolling  0.500, 0.500 to 0.500 (law: 0.500)
    film of air      0.333, 0.332 to 0.334 (law: 0.333)
"""

import numpy as np

import rimroll as rr

disk = rr.bodies.disk(radius=0.0375)
rate = rr.steady_wobble_rate(disk, 0.1)
start = rr.State(tilt=0.1, yaw_rate=rate, spin_rate=-rate * np.cos(0.1))
losses = {
    "dry rolling": (1, rr.RollingResistance(dry=1e-4)),
    "viscous rolling": (2, rr.RollingResistance(viscous=1e-4)),
    "film of air": (4, rr.AirDrag(1e-12)),
}
for name, (power, loss) in losses.items():
    motion = rr.simulate(disk, start, rr.NoSlip() + loss, duration=500, rtol=1e-8)
    half, tenth = (
        motion.crossings(lambda at, part=part: at.tilt - part * start.tilt)[0].t
        for part in (0.5, 0.1)
    )
    t = np.linspace(half, tenth, 400)
    fit = rr.fit_exponent(t, motion(t).tilt)
    low, high = fit.exponent_interval
    print(f"{name:16} {fit.exponent:.3f}, {low:.3f} to {high:.3f} (law: {2 / (2 + power):.3f})")
