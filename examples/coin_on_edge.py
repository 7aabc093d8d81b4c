"""How long does a coin stand on its edge?

An upright coin at rest falls like an inverted pendulum: each ten times better balance adds the same
time, ln 10 over the rate at which a lean grows. Without slip a coin tips about its contact, so that
the rate is √(m g R / (A + m R²)).

    leaning by 1e-02 rad: falls after 0.195 s
    leaning by 1e-04 rad: falls after 0.372 s
    leaning by 1e-06 rad: falls after 0.549 s
    each ten times adds 88.5 ms (theory: 88.5 ms)
"""

import numpy as np

import rimroll as rr

coin = rr.bodies.disk(radius="11.6 mm")
times = []
for lean in 1e-2, 1e-4, 1e-6:
    motion = rr.simulate(coin, rr.State(tilt=np.pi / 2 - lean), rr.NoSlip(), duration=5)
    halfway = motion.crossings(lambda at: at.tilt - np.pi / 4)[0]
    times.append(halfway.t)
    print(f"leaning by {lean:.0e} rad: falls after {halfway.t:.3f} s")
inertia = coin.transverse_inertia + coin.mass * coin.radius**2
rate = np.sqrt(coin.mass * rr.STANDARD_GRAVITY * coin.radius / inertia)
added = (times[2] - times[1]) / 2
print(f"each ten times adds {1e3 * added:.1f} ms (theory: {1e3 * np.log(10) / rate:.1f} ms)")
