"""Where does the energy of a rocking can go?

A can rocks for two seconds. Every joule is booked: what each cause has taken, and what is left. The
sum stays constant up to the error of the solver.

    at the start  10.476 mJ  100.0%
    friction       3.695 mJ   35.3%
    rolling        6.177 mJ   59.0%
    left           0.604 mJ    5.8%
    the books balance to 1e-9: True
"""

import numpy as np

import rimroll as rr

can = rr.bodies.can_2007()
start = rr.State(tilt="25 deg", tilt_rate=-0.5, yaw_rate=0.3)
law = rr.Coulomb(0.15) + rr.RollingResistance(dry=2e-3)
motion = rr.simulate(can, start, law, duration=2.0)
accounts = {
    "at the start": motion.energy[0],
    "friction": motion.friction_loss[-1],
    "rolling": motion.resistance_loss[-1],
    "left": motion.energy[-1],
}
for name, energy in accounts.items():
    print(f"{name:12} {1e3 * energy:7.3f} mJ {energy / motion.energy[0]:7.1%}")
error = np.ptp(motion.energy_budget) / motion.energy[0]
print("the books balance to 1e-9:", bool(error < 1e-9))
