"""What if friction falls with the speed of the slip?

A function of the slip speed is a law: sampled, and simulated at compiled speed with exact sticking.
Friction that falls lets the rim slip as fast as on a slippery table, but only late in the
near-collision: the turn stays near that of the friction at low speed.

    0.3 at all speeds  turns 205.40 degrees, slips at up to 3 cm/s
    0.3 falling to 0.1 turns 207.72 degrees, slips at up to 61 cm/s
    0.1 at all speeds  turns 216.42 degrees, slips at up to 57 cm/s
"""

import numpy as np

import rimroll as rr


def mu(speed):
    """Sticks at 0.3 and slides at 0.1 when fast (speed in m/s)."""
    return 0.1 + 0.2 * np.exp(-speed / 0.05)


can = rr.bodies.can_2007()
start = rr.State(tilt="30 deg", tilt_rate=-0.5, yaw_rate=0.005)
laws = {
    "0.3 at all speeds": rr.Coulomb(0.3),
    "0.3 falling to 0.1": rr.Tabulated.from_function(mu, speeds=[0, 2]),
    "0.1 at all speeds": rr.Coulomb(0.1),
}
for name, law in laws.items():
    motion = rr.simulate(can, start, law, duration=0.8)
    turn = np.degrees(motion.turns[0].angle)
    fastest = np.hypot(*motion.samples().slip.T).max()
    print(f"{name:18} turns {turn:.2f} degrees, slips at up to {100 * fastest:.0f} cm/s")
