"""How does Euler's disk come to rest?

The tilt of a disk that loses the power Ω^λ at a wobble rate Ω falls like (t₀ − t)^(2/(2 + λ)). The
exponent tells what stops a disk: dry rolling resistance (λ = 1), viscous rolling resistance (2), or
the air under it (4, Moffatt 2000). Here the exponent is the slope of ln tilt over ln(t₀ − t).

    dry rolling      0.667 (law: 0.667)
    viscous rolling  0.501 (law: 0.500)
    film of air      0.334 (law: 0.333)
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
    t = np.linspace(0, motion.t[-1], 2000)
    tilt = motion(t).tilt
    chosen = (tilt < 0.5 * start.tilt) & (tilt > 0.1 * start.tilt)
    left = motion.t[-1] - t[chosen]
    exponent = np.polyfit(np.log(left), np.log(tilt[chosen]), 1)[0]
    print(f"{name:16} {exponent:.3f} (law: {2 / (2 + power):.3f})")
