"""What is the friction of a table on which a class flicked cans?

Directions of forty falls, in degrees from the direction of the first lean, as read from a
protractor. The likelihood of the two humps gives the friction and its uncertainty, and says which
of the two ideal laws the falls exclude. (The falls are simulated, with friction 0.2.)

    friction 0.198 (0.185 to 0.209)
    rolling without slip: excluded (p < 0.0001)
    sliding without friction: excluded (p < 0.0001)
    one friction for both sides, without a bias: possible (p = 0.16)
    two humps as friction makes them: the falls have that shape (p = 0.85)
"""

import numpy as np

import rimroll as rr

can = rr.bodies.can_2007()
falls = rr.topple(can, rr.Coulomb(0.2), n=40, release="paper", seed=7)
read = np.radians(np.round(np.degrees(falls.direction.values)))
found = rr.fit(can, read, release="paper", reading_error="0.5 deg")
print("friction", found.friction)
for verdict in found.verdicts:
    print(verdict.sentence)
